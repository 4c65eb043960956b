//! Dashes against a slow walk along the contour in floating point.

use aquatint::{
    Cap, Dashed, Frame, Outline, Pen, Point2, Polyline, Rect, Rows, Stroke, StrokeStyle, Stroked, Subpixel,
};
use embedded_graphics::{
    geometry::Point,
    image::GetPixel,
    pixelcolor::BinaryColor,
    primitives::{StyledDimensions, StyledDrawable},
};
use proptest::{prelude::*, sample::select};

use crate::{filled, stroked};

const WINDOW: Rect = Rect::new(0, 0, 22, 16);

/// A pen that remembers, without points that come twice.
#[derive(Debug, Default)]
struct Record(Vec<Vec<(f64, f64)>>);

impl Pen for Record {
    fn move_to(&mut self, point: Point2) {
        self.0.push(vec![position(point)]);
    }

    fn line_to(&mut self, point: Point2) {
        let contour = self.0.last_mut().expect("begun");
        if contour.last() != Some(&position(point)) {
            contour.push(position(point));
        }
    }

    fn close(&mut self) {
        panic!("dashes are open");
    }
}

fn position(point: Point2) -> (f64, f64) {
    (f64::from(point.x.to_bits()), f64::from(point.y.to_bits()))
}

/// Vertices of a contour with their distances along it.
struct Walk(Vec<(f64, (f64, f64))>);

impl Walk {
    fn along(points: &[Point2]) -> Self {
        let mut at = 0.0;
        let mut last = position(points[0]);
        Self(
            points
                .iter()
                .map(|&point| {
                    let here = position(point);
                    at += (here.0 - last.0).hypot(here.1 - last.1);
                    last = here;
                    (at, here)
                })
                .collect(),
        )
    }

    fn length(&self) -> f64 {
        self.0.last().expect("a point").0
    }

    fn point(&self, at: f64) -> (f64, f64) {
        let segment = self.0.windows(2).find(|ends| at <= ends[1].0).unwrap_or(&self.0[self.0.len() - 2..]);
        let ((from, a), (to, b)) = (segment[0], segment[1]);
        let part = (at - from) / (to - from);
        (a.0 + part * (b.0 - a.0), a.1 + part * (b.1 - a.1))
    }

    /// The contour of a dash.
    fn dash(&self, from: f64, to: f64) -> Vec<(f64, f64)> {
        let corners = self.0.iter().filter(|(at, _)| from < *at && *at < to).map(|&(_, point)| point);
        let mut dash: Vec<_> = std::iter::once(self.point(from)).chain(corners).chain([self.point(to)]).collect();
        dash.dedup();
        dash
    }

    /// The dashes, and whether one of their ends is too near a corner to say on which side.
    fn dashes(&self, lengths: &[i32], offset: i32) -> (Vec<Vec<(f64, f64)>>, bool) {
        let period: i32 = lengths.iter().sum::<i32>() * if lengths.len().is_multiple_of(2) { 1 } else { 2 };
        let (mut at, mut index) = (f64::from(-offset.rem_euclid(period)), 0);
        let (mut dashes, mut is_ambiguous) = (vec![], false);
        while at <= self.length() {
            let length = lengths[index % lengths.len()];
            let end = at + f64::from(length);
            let is_near = |at: f64| self.0.iter().any(|(corner, _)| (1e-9..0.75).contains(&(corner - at).abs()));
            is_ambiguous |= is_near(at) || is_near(end);
            let is_seen = end > 0.0 && at < self.length() || length == 0 && end >= 0.0;
            if index % 2 == 0 && is_seen {
                dashes.push(self.dash(at.max(0.0), end.min(self.length())));
            }
            (at, index) = (end, index + 1);
        }
        (dashes, is_ambiguous)
    }
}

/// Dashes and gaps of at least half a pixel, and dots.
fn lengths() -> impl Strategy<Value = Vec<i32>> {
    let length =
        prop_oneof![1 => Just(0), 3 => 8..120_i32, 2 => (1..6_i32).prop_map(|pixels| pixels * 16), 1 => 100..2000_i32];
    prop::collection::vec(length, 1..6).prop_filter("longer than a pixel", |lengths| lengths.iter().sum::<i32>() >= 16)
}

fn points() -> impl Strategy<Value = Vec<Point2>> {
    let coordinate =
        || prop_oneof![3 => -50..400_i32, 1 => (0..20_i32).prop_map(|pixel| pixel * 16), 1 => -2000..2000_i32];
    prop::collection::vec((coordinate(), coordinate()), 2..6).prop_map(|mut points| {
        points.dedup();
        if points.len() < 2 {
            points.push((points[0].0 + 50, points[0].1));
        }
        points.into_iter().map(|(x, y)| Point2::from_sixteenths(x, y)).collect()
    })
}

fn subpixels(lengths: &[i32]) -> Vec<Subpixel> {
    lengths.iter().copied().map(Subpixel::from_bits).collect()
}

fn record(outline: &impl Outline) -> Record {
    let mut record = Record::default();
    outline.trace(&mut record);
    record
}

fn hostile_lengths() -> impl Strategy<Value = Vec<i32>> {
    prop::collection::vec(prop_oneof![Just(0), -5..40_i32, any::<i32>(), Just(i32::MAX)], 0..5)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn dashes_begin_and_end_where_the_exact_ones_do(points in points(), lengths in lengths(), offset in -3000..3000_i32) {
        let (expected, is_ambiguous) = Walk::along(&points).dashes(&lengths, offset);
        prop_assume!(!is_ambiguous);
        let lengths = subpixels(&lengths);
        let dashed = Dashed::new(Polyline::new(&points).expect("in range"), &lengths, Subpixel::from_bits(offset));
        let Record(got) = record(&dashed);
        prop_assert_eq!(got.len(), expected.len(), "{:?} for {:?}", got, expected);
        for (got, expected) in got.iter().zip(&expected) {
            prop_assert_eq!(got.len(), expected.len(), "{:?} for {:?}", got, expected);
            for (got, expected) in got.iter().zip(expected) {
                let off = (got.0 - expected.0).abs().max((got.1 - expected.1).abs());
                prop_assert!(off <= 0.51, "{:?} for {:?}", got, expected);
            }
        }
    }

    #[test]
    fn what_is_left_out_is_not_seen(
        points in points(), is_closed: bool, lengths in lengths(), offset in -300..300_i32, pixels in 1..6_u16,
        cap in select(vec![Cap::Butt, Cap::Round, Cap::Square]), far in select(vec![0, 200_000, (1 << 26) - 1]),
    ) {
        let mut points = points;
        points[0].x += Subpixel::from_bits(far / 4);
        points[0].y -= Subpixel::from_bits(far / 5);
        // All of it is seen without a window while there are few repeats.
        let lengths = subpixels(&if far > 200_000 { vec![60_000, 30_000, 0, 7000] } else if far > 0 { vec![500, 300, 16] } else { lengths });
        let line = if is_closed { Polyline::closed(&points) } else { Polyline::new(&points) }.expect("in range");
        let dashed = Dashed::new(line, &lengths, Subpixel::from_bits(offset));
        let stroke = Stroke::new(pixels).with_cap(cap);
        let whole = stroked(&dashed, stroke, WINDOW);
        let window = Rect::new(WINDOW.left - 13, WINDOW.top - 13, WINDOW.right + 13, WINDOW.bottom + 13);
        prop_assert_eq!(&stroked(&dashed.within(window), stroke, WINDOW), &whole);

        let mut target = Frame::<BinaryColor, Rows, _>::with_array([0; 48], 22, 16).expect("3 bytes a row");
        let style = StrokeStyle::new(BinaryColor::On).with_stroke(stroke);
        let Ok(()) = dashed.draw_styled(&style, &mut target);
        let bounds = Rect::from(dashed.styled_bounding_box(&style));
        for (x, y) in whole.places() {
            let is_drawn = target.pixel(Point::new(x, y)) == Some(BinaryColor::On);
            prop_assert_eq!(is_drawn, whole.count(x, y) > 0);
            prop_assert!(!is_drawn || bounds.contains(Point::new(x, y)));
        }
    }

    #[test]
    fn hostile_patterns_are_drawn_once_and_end(
        points in points(), is_closed: bool, lengths in hostile_lengths(), offset: i32, pixels in 1..6_u16,
    ) {
        const END: i32 = (1 << 26) - 1;
        let mut points = points;
        points[0] = Point2::from_sixteenths(-END, END);
        let line = if is_closed { Polyline::closed(&points) } else { Polyline::new(&points) }.expect("in range");
        let lengths = subpixels(&lengths);
        let dashed = Dashed::new(line, &lengths, Subpixel::from_bits(offset)).within(WINDOW);
        let pixels = stroked(&dashed, Stroke::new(pixels).with_cap(Cap::Round), WINDOW);
        prop_assert!(pixels.places().all(|(x, y)| pixels.count(x, y) <= 1));
    }
}

#[test]
fn patterns_without_length_and_shorter_than_a_pixel_cut_nothing() {
    let points = [(1, 1), (20, 9), (4, 14)].map(|(x, y)| Point2::corner(x, y));
    for line in [Polyline::new(&points), Polyline::closed(&points)].map(|line| line.expect("in range")) {
        let solid = stroked(&line, Stroke::new(2), WINDOW);
        for lengths in [&[][..], &[0], &[0, 0, 0], &[-9, -1], &[7, 8], &[i32::MIN, 15]] {
            let lengths = subpixels(lengths);
            let dashed = Dashed::new(&line, &lengths, Subpixel::from_bits(5));
            assert_eq!(stroked(&dashed, Stroke::new(2), WINDOW), solid, "{lengths:?}");
        }
    }
}

#[test]
fn more_repeats_than_there_may_be_are_drawn_without_gaps() {
    let line = |pixels: i32| [Point2::corner(0, 0), Point2::corner(pixels, 0)];
    let lengths = subpixels(&[8, 8]);
    let dashes = |pixels: i32, window: Option<Rect>| {
        let points = line(pixels);
        let dashed = Dashed::new(Polyline::new(&points).expect("in range"), &lengths, Subpixel::ZERO);
        record(&window.map_or(dashed, |window| dashed.within(window))).0.len()
    };
    assert_eq!(dashes(1024, None), 1024);
    assert_eq!(dashes(1025, None), 1);
    // The centre of the window, and 10 pixels on either side.
    assert_eq!(dashes(1025, Some(Rect::new(1000, 0, 1010, 10))), 21);
    assert_eq!(dashes(4_194_303, None), 1);
    assert_eq!(dashes(4_194_303, Some(Rect::new(1000, 0, 1010, 10))), 21);
}

#[test]
fn a_dash_over_the_beginning_of_a_closed_contour_keeps_its_corner() {
    let square = [(4, 4), (14, 4), (14, 12), (4, 12)].map(|(x, y)| Point2::corner(x, y));
    let lengths = subpixels(&[96, 96]);
    let dashed = Dashed::new(Polyline::closed(&square).expect("in range"), &lengths, Subpixel::from_num(3));
    let drawn = filled::<24>(&Stroked::new(dashed, Stroke::new(2)), WINDOW);
    // 3 pixels on either side of the first corner, which is mitered.
    assert_eq!([(3, 3), (3, 4), (6, 3), (7, 3), (3, 6), (3, 7)].map(|(x, y)| drawn.count(x, y)), [1, 1, 1, 0, 1, 0]);
}
