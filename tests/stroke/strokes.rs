//! Strokes against the ideal ones, in floating point: distances from the borders of strips, joins and caps.

use core::ops::Range;

use aquatint::{
    Cap, Frame, Join, Outline, Pen, Point2, Polygon, Polyline, Rect, Rows, Sink, SpanFn, Stroke, StrokeStyle, Stroked,
    Subpixel, pixel_bounds, twice_area,
};
use embedded_graphics::{
    geometry::Point,
    image::GetPixel,
    pixelcolor::BinaryColor,
    primitives::{StyledDimensions, StyledDrawable},
};
use proptest::{prelude::*, sample::select};

use crate::{exact::Overdraw, filled, ideal::Ideal, stroked};

const WINDOW: Rect = Rect::new(-2, -1, 20, 15);
/// What a border may be off, in sixteenths of a pixel.
const BOUND: f64 = 1.0;

fn check(ideal: &Ideal, pixels: &Overdraw) {
    for (x, y) in pixels.places() {
        let centre = (f64::from(x) * 16.0 + 8.0, f64::from(y) * 16.0 + 8.0);
        let depth = ideal.depth(centre);
        let count = pixels.count(x, y);
        assert!(count <= 1, "{x}, {y} is drawn {count} times");
        if depth < -BOUND {
            assert_eq!(count, 0, "{x}, {y} is {depth} outside\n{}", pixels.picture());
        } else if depth > BOUND || (depth > -0.1 && ideal.is_in_neighbours(centre, BOUND * 1.05)) {
            assert_eq!(count, 1, "{x}, {y} is {depth} inside\n{}", pixels.picture());
        }
    }
}

fn join() -> impl Strategy<Value = Join> {
    prop_oneof![
        Just(Join::Round),
        Just(Join::Bevel),
        (0..12_u8).prop_map(|limit| Join::Miter { limit }),
        Just(Join::Miter { limit: 40 })
    ]
}

pub fn stroke() -> impl Strategy<Value = Stroke> {
    let width = prop_oneof![2 => 1..40_i32, 2 => 16..200_i32, 2 => (1..8_i32).prop_map(|pixels| pixels * 16)];
    let cap = select(vec![Cap::Butt, Cap::Round, Cap::Square]);
    (width, join(), cap).prop_map(|(width, join, cap)| Stroke { width: Subpixel::from_bits(width), join, cap })
}

fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![4 => -60..350_i32, 2 => (0..20_i32).prop_map(|pixel| pixel * 16), 1 => -3000..3000_i32]
}

/// Points, of which some come twice, go back, or turn by little.
pub fn points(count: core::ops::Range<usize>) -> impl Strategy<Value = Vec<Point2>> {
    let step = prop_oneof![6 => Just(0), 1 => Just(1), 1 => Just(2), 2 => Just(3)];
    prop::collection::vec(((coordinate(), coordinate()), step), count).prop_map(|steps| {
        let mut points: Vec<(i32, i32)> = vec![];
        for (at, step) in steps {
            let at = match (step, &points[..]) {
                (1, [.., last]) | (2, [.., last, _]) => *last,
                (3, [.., a, b]) => (2 * b.0 - a.0 + at.0 % 5, 2 * b.1 - a.1 + at.1 % 5),
                _ => at,
            };
            points.push((at.0.clamp(-9000, 9000), at.1.clamp(-9000, 9000)));
        }
        points.into_iter().map(|(x, y)| Point2::from_sixteenths(x, y)).collect()
    })
}

fn polyline(points: &[Point2], is_closed: bool) -> Polyline<'_> {
    if is_closed { Polyline::closed(points) } else { Polyline::new(points) }.expect("in range")
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn every_pixel_farther_than_a_sixteenth_from_a_border_is_right(
        points in points(0..7), is_closed: bool, stroke in stroke(),
    ) {
        let ideal = Ideal::of(&points, is_closed, stroke);
        prop_assume!(!ideal.is_ambiguous);
        check(&ideal, &stroked(&polyline(&points, is_closed), stroke, WINDOW));
    }
}

/// Points and what is drawn along them, near and far.
fn far_points() -> impl Strategy<Value = Vec<Point2>> {
    const END: i32 = (1 << 26) - 1;
    let far = || prop_oneof![4 => coordinate(), 1 => -END..=END, 1 => select(vec![-END, END, END - (1 << 16), 0])];
    prop::collection::vec((far(), far()).prop_map(|(x, y)| Point2::from_sixteenths(x, y)), 0..6)
}

fn any_stroke() -> impl Strategy<Value = Stroke> {
    let limit = any::<u8>().prop_map(|limit| Join::Miter { limit });
    let width = prop_oneof![1..300_i32, any::<i32>(), select(vec![0, -1, i32::MIN, i32::MAX, 0xFFFF, 0x1_0000])];
    (stroke(), prop_oneof![join(), limit], width).prop_map(|(stroke, join, width)| Stroke {
        width: Subpixel::from_bits(width),
        join,
        ..stroke
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn hostile_strokes_are_drawn_once_whatever_the_list_and_the_band(
        points in far_points(), is_closed: bool, stroke in any_stroke(), top in -1..15_i32, height in 0..9_i32,
    ) {
        let stroked_line = Stroked::new(polyline(&points, is_closed), stroke);
        let whole = filled::<24>(&stroked_line, WINDOW);
        prop_assert!(whole.places().all(|(x, y)| whole.count(x, y) <= 1), "\n{}", whole.picture());
        prop_assert_eq!(&filled::<3>(&stroked_line, WINDOW), &whole);
        let mut pieces = Overdraw::new(WINDOW);
        let Ok(()) = stroked_line.spans_of_pieces(&mut SpanFn::new(WINDOW, |row, columns: Range<i32>, ()| pieces.add(row, columns)));
        prop_assert!(whole.places().all(|(x, y)| whole.count(x, y) == pieces.count(x, y).min(1)), "\n{}", pieces.picture());
        let band = Rect { top, bottom: top + height, ..WINDOW };
        let part = filled::<24>(&stroked_line, band);
        for (x, y) in part.places() {
            let expected = if WINDOW.rows().contains(&y) { whole.count(x, y) } else { part.count(x, y) };
            prop_assert_eq!(part.count(x, y), expected);
        }
        let bounds = Rect::from(polyline(&points, is_closed).styled_bounding_box(&StrokeStyle::new(BinaryColor::On).with_stroke(stroke)));
        prop_assert_eq!(bounds, pixel_bounds(&stroked_line));
        prop_assert!(whole.places().all(|(x, y)| whole.count(x, y) == 0 || bounds.contains(Point::new(x, y))));
    }

    #[test]
    fn a_stroke_is_the_same_from_both_ends(points in far_points(), is_closed: bool, stroke in any_stroke()) {
        let back: Vec<_> = points.iter().rev().copied().collect();
        let there = stroked(&polyline(&points, is_closed), stroke, WINDOW);
        prop_assert_eq!(stroked(&polyline(&back, is_closed), stroke, WINDOW), there);
    }

    #[test]
    fn coincident_points_change_nothing(points in points(1..6), is_closed: bool, stroke in stroke(), twice in 0..6_usize) {
        let mut more = points.clone();
        let twice = twice % points.len();
        more.insert(twice, points[twice]);
        let once = stroked(&polyline(&points, is_closed), stroke, WINDOW);
        prop_assert_eq!(stroked(&polyline(&more, is_closed), stroke, WINDOW), once);
    }

    #[test]
    fn whole_widths_along_the_axes_are_exact(
        corners in prop::collection::vec((0..5_i32).prop_map(|at| 3 * at), 1..7), pixels in 1..7_u16, cap in select(vec![Cap::Butt, Cap::Square]),
    ) {
        // A path of right angles; with mitered corners and these caps its stroke is rectangles.
        let mut at = (6, 6);
        let mut points = vec![at];
        for (index, &to) in corners.iter().enumerate() {
            at = if index % 2 == 0 { (to, at.1) } else { (at.0, to) };
            points.push(at);
        }
        points.dedup();
        let borrowed: Vec<_> = points.iter().map(|&(x, y)| Point2::corner(x, y)).collect();
        let drawn = stroked(&polyline(&borrowed, false), Stroke::new(pixels).with_cap(cap), WINDOW);
        let half = i32::from(pixels) * 8;
        let rectangles: Vec<_> = points.windows(2).enumerate().map(|(index, ends)| {
            let [a, b] = [ends[0], ends[1]];
            let (turns_before, turns_after) = (index > 0, index + 2 < points.len());
            let turns_back = |p: Option<&(i32, i32)>, q: (i32, i32), r: (i32, i32)| p.is_some_and(|p| (p.0 - q.0) * (r.0 - q.0) > 0 || (p.1 - q.1) * (r.1 - q.1) > 0);
            let (before, after) = (index.checked_sub(1).and_then(|at| points.get(at)), points.get(index + 2));
            let long = |turns: bool, back: bool| if turns && !back || !turns && cap == Cap::Square { half } else { 0 };
            let (one, other) = (long(turns_before, turns_back(before, a, b)), long(turns_after, turns_back(after, b, a)));
            let (one, other) = if a <= b { (one, other) } else { (other, one) };
            let (a, b) = (a.min(b), a.max(b));
            if a.1 == b.1 { (a.0 * 16 - one, a.1 * 16 - half, b.0 * 16 + other, a.1 * 16 + half) }
            else { (a.0 * 16 - half, a.1 * 16 - one, a.0 * 16 + half, b.1 * 16 + other) }
        }).collect();
        for (x, y) in drawn.places().filter(|_| points.len() > 1) {
            let (cx, cy) = (x * 16 + 8, y * 16 + 8);
            let expected = rectangles.iter().any(|&(left, top, right, bottom)| left <= cx && cx < right && top <= cy && cy < bottom);
            prop_assert_eq!(drawn.count(x, y), u32::from(expected), "{}, {} of {:?}", x, y, points);
        }
    }
}

#[test]
fn a_polygon_is_stroked_as_its_closed_polylines_are() {
    let [outer, inner] = [[(1, 1), (18, 3), (9, 14)], [(7, 4), (9, 9), (12, 5)]]
        .map(|corners| corners.map(|(x, y)| Point2::corner(x, y)));
    let contours = [&outer[..], &inner[..]];
    let stroke = Stroke::new(2).with_join(Join::Round);
    let both = stroked(&Polygon::new(&contours).expect("in range"), stroke, WINDOW);
    let [one, other] = contours.map(|contour| stroked(&polyline(contour, true), stroke, WINDOW));
    for (x, y) in both.places() {
        assert_eq!(both.count(x, y), one.count(x, y) | other.count(x, y), "{x}, {y}");
    }
}

/// A pen that moves and does not draw.
struct Moves;
impl Outline for Moves {
    fn trace<P: Pen>(&self, pen: &mut P) {
        pen.move_to(Point2::corner(3, 3));
        pen.move_to(Point2::corner(8, 8));
    }
}

#[test]
fn points_become_dots_by_their_caps() {
    let (point, caps) = ([Point2::corner(5, 5)], [(Cap::Butt, 0), (Cap::Square, 16), (Cap::Round, 12)]);
    let twice = [point[0], point[0]];
    for (cap, area) in caps {
        let stroke = Stroke::new(4).with_cap(cap);
        for line in [polyline(&point, false), polyline(&point, true), polyline(&twice, false), polyline(&twice, true)] {
            let dot = stroked(&line, stroke, WINDOW);
            assert_eq!(dot.places().map(|(x, y)| dot.count(x, y)).sum::<u32>(), area, "{cap:?}\n{}", dot.picture());
        }
    }
    // As in SVG, a pen that moves without drawing leaves nothing.
    assert_eq!(stroked(&Moves, Stroke::new(4).with_cap(Cap::Round), WINDOW), Overdraw::new(WINDOW));
}

#[test]
fn points_out_of_range_are_refused() {
    let points = |x| [Point2::corner(0, 0), Point2::from_sixteenths(x, 3)];
    assert!(Polyline::new(&points((1 << 26) - 1)).is_ok());
    assert!(Polyline::new(&points(1 << 26)).is_err());
    assert!(Polyline::closed(&points(i32::MIN)).is_err());
}

#[test]
fn a_large_drawing_is_the_same_piece_by_piece_and_stops_at_an_error() {
    // A curve of measurements: in each row there are more edges than the list holds.
    let points: Vec<_> =
        (0..90).map(|at| Point2::from_sixteenths(at * 17, 120 + (at * 7919) % 101 * (at % 3 - 1))).collect();
    let polyline = Polyline::new(&points).expect("in range");
    let window = Rect::new(0, 0, 96, 16);
    let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 192], 96, 16).expect("12 bytes a row");
    let Ok(()) = polyline.draw_styled(&StrokeStyle::new(BinaryColor::On).with_width(2), &mut frame);
    let whole = stroked(&polyline, Stroke::new(2), window);
    for (x, y) in whole.places() {
        assert_eq!(frame.pixel(Point::new(x, y)) == Some(BinaryColor::On), whole.count(x, y) > 0, "{x}, {y}");
    }

    let mut broken = Broken(0);
    assert_eq!(Stroked::new(polyline, Stroke::new(2)).spans_of_pieces(&mut broken), Err("no more"));
    assert_eq!(broken.0, 4);
}

/// Takes three spans.
struct Broken(u32);

impl Sink for Broken {
    type Error = &'static str;

    fn bounds(&self) -> Rect {
        Rect::new(0, 0, 96, 16)
    }

    fn span(&mut self, _row: i32, _columns: Range<i32>, (): ()) -> Result<(), Self::Error> {
        self.0 += 1;
        if self.0 > 3 { Err("no more") } else { Ok(()) }
    }
}

/// A pen that looks at the triangles about the first point of each contour.
#[derive(Default)]
struct Clockwise {
    first: Option<Point2>,
    last: Option<Point2>,
    least: i64,
}

impl Pen for Clockwise {
    fn move_to(&mut self, point: Point2) {
        (self.first, self.last) = (Some(point), None);
    }

    fn line_to(&mut self, point: Point2) {
        if let (Some(first), Some(last)) = (self.first, self.last) {
            self.least = self.least.min(twice_area(first, last, point));
        }
        self.last = Some(point);
    }

    fn close(&mut self) {
        self.last = None;
    }
}

#[test]
fn no_piece_is_turned_over_however_thin_it_is() {
    let corner = [0, 1, 3, 7, 20, 50].into_iter().flat_map(|x| [-31, -8, -3, -1, 0, 2, 5, 21].map(|y| (x, y)));
    // Each also the other way, and almost so: there the borders are nearly opposite, and rounded to either side.
    let around = |(x, y): (i32, i32)| {
        [(x, y), (-x, -y), (-40 * x + 1, -40 * y), (-40 * x, 1 - 40 * y), (-40 * x - 1, -40 * y - 1)]
    };
    let directions: Vec<_> = corner.flat_map(around).filter(|at| *at != (0, 0)).collect();
    let joins = [Join::Miter { limit: 255 }, Join::Round, Join::Bevel];
    for width in [1, 2, 3, 4, 5, 7, 9, 12, 17, 33, 64] {
        for ((ax, ay), (bx, by)) in directions.iter().flat_map(|&a| directions.iter().map(move |&b| (a, b))) {
            let points = [(-ax, -ay), (0, 0), (bx, by)].map(|(x, y)| Point2::from_sixteenths(x, y));
            let polyline = Polyline::new(&points).expect("in range");
            for join in joins {
                let stroke = Stroke::of_width(Subpixel::from_bits(width)).with_join(join).with_cap(Cap::Round);
                let mut pieces = Clockwise::default();
                Stroked::new(polyline, stroke).trace(&mut pieces);
                assert_eq!(pieces.least, 0, "{points:?}, {stroke:?}");
            }
        }
    }
}

#[test]
fn a_wide_stroke_between_the_ends_of_what_is_accepted_has_its_width() {
    const END: i32 = (1 << 26) - 1;
    let points = [-END, END].map(|at| Point2::from_sixteenths(at, at));
    // About the border on the left: 800 · √½ = 565.7 pixels from the diagonal, in x and in y.
    let window = Rect::new(-576, 556, -556, 576);
    let drawn = stroked(&polyline(&points, false), Stroke::new(1600), window);
    for (x, y) in drawn.places() {
        let depth = 800.0 - f64::from(y - x) * std::f64::consts::FRAC_1_SQRT_2;
        if depth.abs() > BOUND / 16.0 {
            assert_eq!(drawn.count(x, y), u32::from(depth > 0.0), "{x}, {y}");
        }
    }
}
