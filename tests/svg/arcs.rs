//! Arcs against appendix B.2 of SVG 2, in floating point.

use std::f64::consts::{PI, TAU};

use aquatint::Scalar;
use proptest::{prelude::*, sample::select};

use super::{fine, path};

/// An arc command from the origin.
#[derive(Clone, Copy, Debug)]
struct Given {
    radii: [f64; 2],
    degrees: f64,
    is_large: bool,
    is_clockwise: bool,
    to: [f64; 2],
}

/// What B.2.4 makes of it.
#[derive(Clone, Copy, Debug)]
struct Center {
    at: [f64; 2],
    radii: [f64; 2],
    start: f64,
    sweep: f64,
}

impl Given {
    fn data(&self) -> String {
        let Self { radii: [rx, ry], degrees, is_large, is_clockwise, to: [x, y] } = *self;
        format!("M0 0A{rx} {ry} {degrees} {} {} {x} {y}", u8::from(is_large), u8::from(is_clockwise))
    }

    /// With the names of the standard.
    fn center(&self) -> Center {
        let (sin, cos) = self.degrees.to_radians().sin_cos();
        let [dx, dy] = self.to.map(|v| -v / 2.0);
        let (x, y) = (cos * dx + sin * dy, cos * dy - sin * dx);
        let [rx, ry] = self.radii.map(f64::abs);
        let lambda = (x / rx).powi(2) + (y / ry).powi(2);
        let scale = lambda.sqrt().max(1.0);
        let [rx, ry] = [rx * scale, ry * scale];
        let rest = (rx * ry).powi(2) / ((rx * y).powi(2) + (ry * x).powi(2)) - 1.0;
        let root = rest.max(0.0).sqrt() * if self.is_large == self.is_clockwise { -1.0 } else { 1.0 };
        let (cx, cy) = (root * rx * y / ry, -root * ry * x / rx);
        let start = ((y - cy) / ry).atan2((x - cx) / rx);
        let sweep = ((-y - cy) / ry).atan2((-x - cx) / rx) - start;
        let sweep = if self.is_clockwise { sweep.rem_euclid(TAU) } else { -(-sweep).rem_euclid(TAU) };
        let [mx, my] = self.to.map(|v| v / 2.0);
        Center { at: [cos * cx - sin * cy + mx, sin * cx + cos * cy + my], radii: [rx, ry], start, sweep }
    }
}

/// Traces an arc finely and compares what is drawn with the ellipse and with the angles.
fn check(given: Given, scale: i32) -> Result<(), TestCaseError> {
    let exact = given.center();
    let data = given.data();
    let traced = fine(&path(&data).scaled(Scalar::from_num(scale)));
    prop_assert_eq!(traced.contours.len(), 1, "{}", &data);
    let (sin, cos) = given.degrees.to_radians().sin_cos();
    let units = 256.0 * f64::from(scale);
    let longest = exact.radii[0].max(exact.radii[1]);
    // A curve is 0.027 % off its arc, the centre 0.003 % off its place, an edge and its ends a 256th.
    let allowed = 0.000_31 * longest + 1.5 / units + 4.0 / 65_536.0;
    let (mut turned, mut last) = (0.0, exact.start);
    for &(x, y) in &traced.contours[0] {
        let [x, y] = [f64::from(x) / units - exact.at[0], f64::from(y) / units - exact.at[1]];
        let [u, v] = [(x * cos + y * sin) / exact.radii[0], (y * cos - x * sin) / exact.radii[1]];
        let (length, angle) = (u.hypot(v), v.atan2(u));
        // How far it is from the ellipse, along the gradient.
        let off = (length - 1.0).abs() / (u / exact.radii[0]).hypot(v / exact.radii[1]);
        prop_assert!(off <= allowed, "{}: {} off, {} allowed", data, off, allowed);
        turned += (angle - last + PI).rem_euclid(TAU) - PI;
        last = angle;
    }
    let slack = 0.001 + 2.0 * allowed / exact.radii[0].min(exact.radii[1]);
    prop_assert!((turned - exact.sweep).abs() <= slack, "{}: {} of {}", data, turned, exact.sweep);
    Ok(())
}

fn thousandths(range: std::ops::Range<i32>) -> impl Strategy<Value = f64> {
    range.prop_map(|v| f64::from(v) / 1000.0)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(5000))]

    #[test]
    fn arcs_are_those_of_the_standard(
        radii in (thousandths(500..60_000), thousandths(500..60_000)), degrees in -720..720_i32, flags: (bool, bool),
        to in (thousandths(-60_000..60_000), thousandths(-60_000..60_000)), scale in select(vec![1, 4, 30]),
    ) {
        let given = Given {
            radii: [radii.0, radii.1], degrees: f64::from(degrees), is_large: flags.0, is_clockwise: flags.1, to: [to.0, to.1],
        };
        let exact = given.center();
        // Next to a half turn the flag decides between two arcs that are the same but for their ends.
        prop_assume!(exact.sweep.abs() > 0.01 && (exact.sweep.abs() - PI).abs() > 0.02 || exact.radii[0] > 1.000_001 * radii.0);
        // A flat ellipse is beyond comparison by angles.
        prop_assume!(exact.radii[0].max(exact.radii[1]) < 50.0 * exact.radii[0].min(exact.radii[1]));
        let given = if exact.radii[0] > 1.000_001 * radii.0 { Given { is_large: false, ..given } } else { given };
        check(given, scale)?;
    }
}

#[test]
fn short_chords_of_large_arcs_keep_their_circle() {
    // The usual way to draw a whole circle, turned by anything.
    for degrees in [0.0, 30.0, 77.0, -140.0] {
        for to in [[0.01, 0.0], [0.001, 0.0], [-0.001, 0.002], [0.0, -0.01]] {
            for is_clockwise in [false, true] {
                let given = Given {
                    radii: [10.0; 2],
                    degrees,
                    is_large: true,
                    is_clockwise,
                    to: to.map(|v: f64| (v * 65_536.0).round() / 65_536.0),
                };
                check(given, 8).unwrap_or_else(|error| panic!("{given:?}: {error}"));
            }
        }
    }
}

#[test]
fn half_circles_and_radii_that_are_too_short() {
    let half = |data: &str| fine(&path(data)).contours.remove(0);
    // Radii of a quarter are stretched until they fit, whatever the flag for the larger one says.
    assert_eq!(half("M0 0A5 5 0 0 1 10 0"), half("M0 0A2.5 2.5 0 0 1 10 0"));
    let mut large = half("M0 0A.01 .01 0 1 1 10 0");
    large.dedup();
    assert_eq!(half("M0 0A5 5 0 0 1 10 0"), large);
    let top = half("M0 0A5 5 0 0 1 10 0").iter().map(|&(_, y)| y).min();
    assert!(top.is_some_and(|top| (-1281..=-1279).contains(&top)), "{top:?}");
    // No radius grows beyond bounds, and the end is where it was said.
    let flat = half("M0 0A30000 .00002 0 0 1 10 60");
    assert_eq!(flat.last(), Some(&(2560, 15_360)));
}
