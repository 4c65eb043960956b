//! Curves against their formulas, cut so finely that it does not show.

use std::f64::consts::TAU;

use aquatint::{Oval, Path, Point2, Rule, Segment, Subpixel};
use proptest::{array::uniform4, prelude::*};

use super::{WINDOW, drawn, oracle, rule, worst};

fn in_pixels(point: Point2) -> (f64, f64) {
    (f64::from(point.x.to_bits()) / 16.0, f64::from(point.y.to_bits()) / 16.0)
}

/// A curve of any degree in 600 pieces.
fn bezier(points: &[Point2]) -> Vec<(f64, f64)> {
    let at = |step: u32| {
        let t = f64::from(step) / 600.0;
        let mut points: Vec<_> = points.iter().map(|&point| in_pixels(point)).collect();
        while points.len() > 1 {
            let between = |pair: &[(f64, f64)]| {
                (pair[0].0 + t * (pair[1].0 - pair[0].0), pair[0].1 + t * (pair[1].1 - pair[0].1))
            };
            points = points.windows(2).map(between).collect();
        }
        points[0]
    };
    (0..=600).map(at).collect()
}

fn near() -> impl Strategy<Value = Point2> {
    (-60..480_i32, -60..400_i32).prop_map(|(x, y)| Point2::from_sixteenths(x, y))
}

/// The greatest error of an oval, in 256ths of a pixel.
fn oval_error(center: Point2, radii: [i32; 2]) -> f64 {
    let oval = Oval::new(center, radii.map(Subpixel::from_bits)).expect("in range");
    let ((x, y), [rx, ry]) = (in_pixels(center), radii.map(|radius| f64::from(radius) / 16.0));
    let around = (0..2000_u32).map(|step| f64::from(step) / 2000.0 * TAU);
    let contour: Vec<_> = around.map(|angle| (x + rx * angle.cos(), y + ry * angle.sin())).collect();
    worst(&drawn(&oval, Rule::NonZero, WINDOW), &oracle::by_lines(&[contour], Rule::NonZero, WINDOW))
}

/// The greatest error of a curve that is closed by a straight edge, of three or four points.
fn bezier_error(points: &[Point2], rule: Rule) -> f64 {
    let curve = match *points {
        [_, one, to] => Segment::QuadTo(one, to),
        [_, one, other, to] => Segment::CubicTo(one, other, to),
        _ => panic!("three or four points"),
    };
    let segments = [Segment::MoveTo(points[0]), curve, Segment::Close];
    let path = Path::new(&segments).expect("in range");
    worst(&drawn(&path, rule, WINDOW), &oracle::by_lines(&[bezier(points)], rule, WINDOW))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn ovals_are_right_to_two_steps(center in near(), radii in (0..400_i32, 0..400_i32)) {
        let off = oval_error(center, [radii.0, radii.1]);
        prop_assert!(off <= 2.0, "{off}");
    }

    #[test]
    fn beziers_are_right_to_two_steps_or_three(points in uniform4(near()), rule in rule()) {
        // A curve is 0.96 of a step from its chords, and a cubic one may go through a pixel three times.
        for (points, bound) in [(&points[..3], 2.0), (&points, 3.0)] {
            let off = bezier_error(points, rule);
            prop_assert!(off <= bound, "{off}");
        }
    }
}
