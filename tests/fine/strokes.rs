//! Strokes and dashes, against their formulas.

use aquatint::{Cap, Dashed, Join, Oval, Point2, Polyline, Rect, Stroke, Stroked, Subpixel};
use proptest::{collection::vec, prelude::*, sample::select};

use super::{Place, apart, coarse, fine, from_contour, large, place, point};

/// A corner is rounded once on each axis; the direction is hardly off.
const CORNER: f64 = 0.72;
/// Two offsets that are rounded, one after the other.
const SQUARE: f64 = 1.42;

/// A segment and the unit vector to its right.
struct Side {
    ends: [Place; 2],
    right: Place,
}

fn sides(points: &[Point2]) -> Vec<Side> {
    let pairs = points.windows(2).filter(|pair| pair[0] != pair[1]);
    pairs.map(|pair| side([pair[0], pair[1]].map(large))).collect()
}

fn side(ends: [Place; 2]) -> Side {
    let ([x, y], length) = ([ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]], apart(ends[0], ends[1]));
    Side { ends, right: [-y / length, x / length] }
}

impl Side {
    /// The corners of the strip, in the order in which they are drawn.
    fn strip(&self, half: f64) -> [Place; 4] {
        let [a, b] = self.ends;
        [(a, -half), (b, -half), (b, half), (a, half)]
            .map(|(at, by)| [at[0] + by * self.right[0], at[1] + by * self.right[1]])
    }

    /// How far a point is from the line of the nearer border.
    fn distance_to_border(&self, [x, y]: Place, half: f64) -> f64 {
        let [ax, ay] = self.ends[0];
        (((x - ax) * self.right[0] + (y - ay) * self.right[1]).abs() - half).abs()
    }
}

fn area(contour: &[(i32, i32)]) -> f64 {
    let pairs = contour.iter().zip(contour.iter().cycle().skip(1));
    let crosses = pairs.map(|(&(ax, ay), &(bx, by))| i64::from(ax) * i64::from(by) - i64::from(ay) * i64::from(bx));
    #[expect(clippy::cast_precision_loss, reason = "less than 2^53")]
    let twice = crosses.sum::<i64>() as f64;
    twice / 2.0
}

fn stroke() -> impl Strategy<Value = Stroke> {
    let joins = vec![Join::Miter { limit: 4 }, Join::Miter { limit: 20 }, Join::Round, Join::Bevel];
    let width = prop_oneof![1..64_i32, 1..4096_i32];
    (width, select(joins), select(vec![Cap::Butt, Cap::Round, Cap::Square]))
        .prop_map(|(width, join, cap)| Stroke::of_width(Subpixel::from_bits(width)).with_join(join).with_cap(cap))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn every_corner_of_a_stroke_is_where_it_should_be(points in vec(point(3000), 2..6), stroke in stroke()) {
        let (sides, half) = (sides(&points), 8.0 * f64::from(stroke.width.to_bits()));
        let line = Polyline::new(&points).expect("in range");
        let traced = fine(&Stroked::new(&line, stroke));
        let mut strips = sides.iter().map(|side| side.strip(half)).peekable();
        let limit = if let Join::Miter { limit } = stroke.join { f64::from(limit) } else { 1.0 };
        for contour in &traced.contours {
            prop_assert!(area(contour) >= 0.0, "clockwise: {:?}", contour);
            let corners: Vec<_> = contour.iter().map(|&corner| place(corner)).collect();
            let is_strip = |strip: &[Place; 4]| {
                corners.len() == 4 && strip.iter().zip(&corners).all(|(&exact, &corner)| apart(exact, corner) <= CORNER)
            };
            if strips.next_if(is_strip).is_some() {
                continue;
            }
            // A fan about a corner of the line, or a square cap.
            for &corner in &corners {
                let nearest = points.iter().map(|&point| apart(large(point), corner));
                let is_at = |distance: f64, slack: f64| nearest.clone().any(|d| (d - distance).abs() <= slack);
                let is_on_borders = sides.iter().filter(|side| side.distance_to_border(corner, half) <= 1.0).count() >= 2;
                let is_tip = is_on_borders && nearest.clone().any(|d| half <= d + 1.0 && d <= half * limit + 1.0);
                let is_square = stroke.cap == Cap::Square && is_at(half * 2_f64.sqrt(), SQUARE);
                prop_assert!(is_at(0.0, 0.0) || is_at(half, CORNER) || is_square || is_tip, "{:?} of {:?}", corner, points);
            }
        }
        prop_assert!(strips.next().is_none(), "every segment has a strip");
    }

    #[test]
    fn a_fine_stroke_is_within_a_sixteenth_of_the_coarse_one(points in vec(point(3000), 2..6), width in 1..4096_i32) {
        // The fans of other joins may begin at other steps, or be left out when they are thin.
        let stroke = Stroke::of_width(Subpixel::from_bits(width)).with_cap(Cap::Square).with_join(Join::Bevel);
        let line = Polyline::new(&points).expect("in range");
        let stroked = Stroked::new(&line, stroke);
        let coarse: Vec<Vec<_>> = coarse(&stroked).contours.iter().map(|c| c.iter().map(|&(x, y)| (16 * x, 16 * y)).collect()).collect();
        for &corner in fine(&stroked).contours.iter().flatten() {
            let off = coarse.iter().map(|contour| from_contour(place(corner), contour)).fold(f64::INFINITY, f64::min);
            prop_assert!(off <= 16.0 * SQUARE + 1.0, "{:?} is {} off", corner, off);
        }
    }

    #[test]
    fn dashes_of_a_line_begin_and_end_where_they_should(
        to in point(3000), lengths in vec(1..200_i32, 1..4), offset in -500..500_i32, in_a_window: bool,
    ) {
        prop_assume!(to != Point2::default() && lengths.iter().sum::<i32>() > 16);
        let (points, from) = ([Point2::default(), to], [0.0, 0.0]);
        let pattern: Vec<_> = lengths.iter().map(|&length| Subpixel::from_bits(length)).collect();
        let line = Polyline::new(&points).expect("in range");
        let mut dashed = Dashed::new(&line, &pattern, Subpixel::from_bits(offset));
        if in_a_window {
            // It holds all of the line.
            dashed = dashed.within(Rect::new(-200, -200, 200, 200));
        }
        let whole = apart(from, large(to));
        let exact = exact_dashes(&lengths, offset, whole / 16.0);
        let traced = fine(&dashed);
        let lengths: Vec<_> = traced.contours.iter().map(|dash| apart(place(dash[0]), place(*dash.last().expect("an end")))).collect();
        let drawn: Vec<_> = traced.contours.iter().zip(lengths).filter(|(_, length)| *length > 4.0).map(|(dash, _)| dash).collect();
        let long = exact.iter().filter(|[a, b]| b - a > 6.0 / 16.0).count();
        prop_assert!(long <= drawn.len() && drawn.len() <= exact.len());
        for dash in drawn {
            let [a, b] = [dash[0], *dash.last().expect("an end")].map(|end| apart(from, place(end)) / 16.0);
            let is_same = |[c, d]: &[f64; 2]| (a - c).abs() <= 1.0 / 16.0 && (b - d).abs() <= 1.0 / 16.0;
            prop_assert!(exact.iter().any(is_same), "{} to {} of {:?}", a, b, exact);
        }
    }
}

/// Where dashes begin and end on a line of some length, all in sixteenths.
fn exact_dashes(lengths: &[i32], offset: i32, whole: f64) -> Vec<[f64; 2]> {
    let twice: Vec<_> = lengths.iter().chain(lengths).copied().collect();
    let pattern = if lengths.len().is_multiple_of(2) { lengths } else { &twice[..] };
    let mut at = -f64::from(offset.rem_euclid(pattern.iter().sum()));
    let mut dashes = vec![];
    for (index, &length) in pattern.iter().enumerate().cycle() {
        if at >= whole {
            return dashes;
        }
        let end = at + f64::from(length);
        if index % 2 == 0 && end > 0.0 {
            dashes.push([at.max(0.0), end.min(whole)]);
        }
        at = end;
    }
    dashes
}

#[test]
fn a_line_one_pixel_wide_has_its_area_at_all_angles() {
    let mut worst = [0.0_f64; 2];
    for step in 0..720 {
        let angle = f64::from(step) / 720.0 * std::f64::consts::TAU;
        #[expect(clippy::cast_possible_truncation, reason = "small")]
        let [x, y] = [angle.cos(), angle.sin()].map(|v| (v * 640.0).round() as i32);
        let points = [Point2::from_sixteenths(33, 8), Point2::from_sixteenths(33 + x, 8 + y)];
        let line = Polyline::new(&points).expect("in range");
        let stroked = Stroked::new(&line, Stroke::new(1));
        let exact = 16.0 * f64::from(x).hypot(f64::from(y));
        for (worst, (traced, unit)) in worst.iter_mut().zip([(fine(&stroked), 256.0), (coarse(&stroked), 1.0)]) {
            assert_eq!(traced.contours.len(), 1, "the strip is one quad");
            *worst = worst.max((area(&traced.contours[0]) / unit / exact - 1.0).abs());
        }
    }
    let [fine, coarse] = worst;
    assert!(fine < 0.01, "{fine}");
    // Which is why.
    assert!(coarse > 0.05, "{coarse}");
}

#[test]
fn a_ring_has_its_area() {
    let circle = Oval::circle(Point2::corner(20, 20), Subpixel::from_num(15)).expect("in range");
    let dashed = Dashed::new(&circle, &[], Subpixel::ZERO);
    for ring in [fine(&Stroked::new(&circle, Stroke::new(1))), fine(&Stroked::new(&dashed, Stroke::new(1)))] {
        // Strips and the joins at their outer sides overlap at the inner ones, by half of the width times the turn.
        let pieces: f64 = ring.contours.iter().map(|contour| area(contour)).sum::<f64>() / 65_536.0;
        let exact = 30.0 * std::f64::consts::PI;
        assert!((pieces / exact - 1.0).abs() < 0.025, "{pieces} for {exact}");
    }
}

#[test]
fn dashes_that_are_too_fine_are_drawn_as_the_whole_line() {
    let circle = Oval::circle(Point2::corner(20, 20), Subpixel::from_num(15)).expect("in range");
    let lengths = [Subpixel::from_bits(7)];
    assert_eq!(fine(&Dashed::new(&circle, &lengths, Subpixel::ZERO)), fine(&circle));
    let lengths = [Subpixel::from_bits(16)];
    let dashed = Dashed::new(&circle, &lengths, Subpixel::ZERO);
    assert_eq!([coarse(&dashed), fine(&dashed)].map(|pen| pen.contours.len()), [48; 2]);
}
