//! Bézier curves: how far the straight edges are from the true curve, and how many there are.

use aquatint::{
    Pen, Point2,
    curve::{cubic, quadratic},
};
use proptest::{prelude::*, sample::select};

use crate::{distance, recorder::Recorder};

/// What the documentation promises, in sixteenths: a quarter for the chord, √½ for rounding.
const CHORD: f64 = 0.25;
const ROUNDING: f64 = 0.7072;

/// The most pieces of a curve.
const MOST: usize = 4096;

fn xy(point: Point2) -> [f64; 2] {
    [point.x, point.y].map(|v| f64::from(v.to_bits()))
}

/// A point of the curve with these control points, by de Casteljau's construction.
fn exact(controls: &[Point2], t: f64) -> [f64; 2] {
    let mut points: Vec<_> = controls.iter().copied().map(xy).collect();
    while points.len() > 1 {
        points = points.windows(2).map(|p| [0, 1].map(|axis| p[0][axis] * (1.0 - t) + p[1][axis] * t)).collect();
    }
    points[0]
}

/// The vertices of a curve, the start included.
fn vertices(controls: &[Point2]) -> Vec<Point2> {
    let mut pen = Recorder::default();
    pen.move_to(controls[0]);
    match *controls {
        [a, b, c] => quadratic(&mut pen, [a, b, c]),
        [a, b, c, d] => cubic(&mut pen, [a, b, c, d]),
        _ => unreachable!("two kinds of curves"),
    }
    pen.contours.remove(0)
}

/// The longest second difference.
fn bend(controls: &[Point2]) -> f64 {
    let second = |p: &[Point2]| {
        let [x, y] = [0, 1].map(|axis| xy(p[0])[axis] - 2.0 * xy(p[1])[axis] + xy(p[2])[axis]);
        x.hypot(y)
    };
    controls.windows(3).map(second).fold(0.0, f64::max)
}

/// Checks everything about one curve.
fn check(controls: &[Point2]) -> Result<(), TestCaseError> {
    let vertices = vertices(controls);
    let pieces = vertices.len() - 1;
    prop_assert!(pieces.is_power_of_two() && pieces <= MOST, "{} pieces", pieces);
    prop_assert_eq!(vertices.first(), controls.first());
    prop_assert_eq!(vertices.last(), controls.last());

    // Half as many pieces would not do; the length of a vector is taken for up to an eighth more than it is.
    let factor = if controls.len() == 3 { 0.25 } else { 0.75 };
    let n = f64::from(u32::try_from(pieces).expect("few"));
    let chord = factor * bend(controls) / (n * n);
    prop_assert!(pieces == 1 || 4.0 * (1.12 * chord + 2.0 / (n * n)) > CHORD, "{} pieces for nothing", pieces);
    prop_assert!(chord <= CHORD || pieces == MOST);

    let allowed = chord.min(if pieces == MOST { chord } else { CHORD }) + ROUNDING;
    let samples = if pieces > 256 { 2 } else { 8 };
    for (index, ends) in (0_u32..).zip(vertices.windows(2)) {
        for sample in 0..samples {
            let t = (f64::from(index) + f64::from(sample) / f64::from(samples)) / n;
            let off = distance(exact(controls, t), [xy(ends[0]), xy(ends[1])]);
            prop_assert!(off <= allowed, "{} sixteenths off at {} of {} pieces", off, t, pieces);
        }
    }
    Ok(())
}

/// On a screen, far away, and at the ends of what is accepted.
fn coordinate() -> impl Strategy<Value = i32> {
    const END: i32 = (1 << 26) - 1;
    prop_oneof![
        12 => -400..6000_i32,
        4 => -40..40_i32,
        3 => -100_000..100_000_i32,
        1 => select(vec![-END, END]),
        1 => -END..=END,
    ]
}

fn point() -> impl Strategy<Value = Point2> {
    let anywhere = (coordinate(), coordinate());
    let near = (-400..6000_i32, -400..6000_i32);
    prop_oneof![1 => anywhere, 2 => near].prop_map(|(x, y)| Point2::from_sixteenths(x, y))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn quadratic_curves_are_less_than_a_sixteenth_off(controls in [point(), point(), point()]) {
        check(&controls)?;
    }

    #[test]
    fn cubic_curves_are_less_than_a_sixteenth_off(controls in [point(), point(), point(), point()]) {
        check(&controls)?;
    }

    #[test]
    fn a_cubic_curve_that_is_a_straight_line_is_one_edge(
        (x, y) in (coordinate(), coordinate()), (dx, dy) in (-9_000_000..9_000_000_i32, -9000..9000_i32),
    ) {
        let controls = [0, 1, 2, 3].map(|third| Point2::from_sixteenths(x / 2 + third * dx, y / 2 + third * dy));
        prop_assert_eq!(vertices(&controls), vec![controls[0], controls[3]]);
    }
}

#[test]
fn the_longest_curves_have_4096_pieces_and_are_at_most_18_sixteenths_off() {
    let end = (1 << 26) - 1;
    let [a, b] = [-end, end].map(|v| Point2::from_sixteenths(v, v));
    for controls in [&[a, b, a][..], &[a, b, a, b], &[b, a, b, a]] {
        assert_eq!(vertices(controls).len(), MOST + 1);
        check(controls).expect("within the bound for its length");
        let n = 4096.0;
        let factor = if controls.len() == 3 { 0.25 } else { 0.75 };
        // The 1.1 pixels of the documentation.
        assert!(factor * bend(controls) / (n * n) + ROUNDING < 1.12 * 16.0);
    }
}

#[test]
fn points_out_of_range_are_moved_to_the_border() {
    let [far, near] = [i32::MIN, -(1 << 26) + 1].map(|v| Point2::from_sixteenths(v, v));
    let [other_far, other_near] = [i32::MAX, (1 << 26) - 1].map(|v| Point2::from_sixteenths(v, 7));
    let middle = Point2::corner(3, 4);
    let strip = |vertices: Vec<Point2>| vertices[1..].to_vec();
    assert_eq!(strip(vertices(&[far, middle, other_far])), strip(vertices(&[near, middle, other_near])));
    assert_eq!(strip(vertices(&[far, far, other_far, far])), strip(vertices(&[near, near, other_near, near])));
}
