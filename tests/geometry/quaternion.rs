//! Quaternions against floating point.

use aquatint::{Angle, Matrix, Model, Scalar, Vector3, World, geometry::quaternion::Quaternion};
use proptest::prelude::*;

use crate::{inverse::unevenness, number};

/// The exact quaternion of a turn.
fn exact(axis: [f64; 3], turn: u16) -> [f64; 4] {
    let length = axis.iter().map(|v| v * v).sum::<f64>().sqrt();
    let (s, c) = (f64::from(turn) / 65_536.0 * core::f64::consts::PI).sin_cos();
    [c, axis[0] / length * s, axis[1] / length * s, axis[2] / length * s]
}

fn product([a, b, c, d]: [f64; 4], [e, f, g, h]: [f64; 4]) -> [f64; 4] {
    [
        a * e - b * f - c * g - d * h,
        a * f + b * e + c * h - d * g,
        a * g - b * h + c * e + d * f,
        a * h + b * g - c * f + d * e,
    ]
}

fn matrix([w, x, y, z]: [f64; 4]) -> [[f64; 3]; 3] {
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]
}

/// The interpolation along the arc, as Shoemake has it.
fn slerp(from: [f64; 4], to: [f64; 4], part: f64) -> [f64; 4] {
    let dot: f64 = from.iter().zip(to).map(|(a, b)| a * b).sum();
    let to = if dot < 0.0 { to.map(|v| -v) } else { to };
    let arc = dot.abs().min(1.0).acos();
    if arc < 1e-6 {
        return from;
    }
    let (here, there) = (((1.0 - part) * arc).sin() / arc.sin(), (part * arc).sin() / arc.sin());
    [0, 1, 2, 3].map(|i| from[i] * here + to[i] * there)
}

fn assert_close(got: Quaternion, want: [f64; 4], bound: f64) -> Result<(), TestCaseError> {
    let got: Matrix<Model, World> = got.to_matrix();
    for (row, want) in got.rows().iter().zip(matrix(want)) {
        for (got, want) in row.iter().zip(want) {
            prop_assert!((got.to_num::<f64>() - want).abs() <= bound, "{} for {}", got, want);
        }
    }
    Ok(())
}

const STEP: f64 = 1.0 / 65_536.0;

fn axis() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(-30_000..30_000_i32)
        .prop_filter("an axis", |axis| axis.iter().any(|&v| v != 0))
        .prop_map(|axis| axis.map(|v| f64::from(v) * STEP))
}

fn turned([x, y, z]: [f64; 3], turn: u16) -> Quaternion {
    let axis = Vector3::<World>::new(number(x), number(y), number(z));
    Quaternion::from_axis_angle(axis, Angle(turn)).expect("an axis")
}

/// The largest angle in degrees by which `nlerp` is beside `slerp`, over the parts of a turn.
fn lead(degrees: f32) -> f64 {
    let (from, to) = (Quaternion::IDENTITY, turned([0.0, 1.0, 0.0], Angle::from_degrees(degrees).0));
    let around = |q: Quaternion| {
        let rows: Matrix<Model, World> = q.to_matrix();
        let [[c, _, s, _], ..] = rows.rows().map(|row| row.map(|v| v.to_num::<f64>()));
        s.atan2(c).to_degrees()
    };
    let part = |i: i32| Scalar::from_bits(i << 8);
    (0..=256).map(|i| (around(from.nlerp(to, part(i))) - around(from.slerp(to, part(i)))).abs()).fold(0.0, f64::max)
}

#[test]
fn nlerp_leads_and_lags_as_told() {
    for (degrees, told) in [(179.9, 8.2), (90.0, 1.0), (30.0, 0.04)] {
        let lead = lead(degrees);
        assert!((told * 0.8..=told).contains(&lead), "{lead} at {degrees}");
    }
}

#[test]
fn ten_thousand_turns_stay_a_rotation() {
    let step = turned([0.3, -0.7, 0.2], 12_345).then(turned([0.0, 0.1, 0.0], 321));
    let mut turned = Quaternion::IDENTITY;
    for _ in 0..10_000 {
        turned = turned.then(step);
        let uneven = unevenness(&turned.to_matrix());
        assert!(uneven <= 1.0 / 16_384.0, "{uneven}");
    }
}

#[test]
fn an_axis_has_a_length() {
    let nil = Scalar::ZERO;
    assert_eq!(Quaternion::from_axis_angle(Vector3::<World>::new(nil, nil, nil), Angle::QUARTER), None);
    for end in [Scalar::MIN, Scalar::MAX, Scalar::DELTA] {
        assert!(Quaternion::from_axis_angle(Vector3::<World>::new(end, end, end), Angle::QUARTER).is_some());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(5_000))]

    #[test]
    fn turns_and_products(a in axis(), b in axis(), s in any::<u16>(), t in any::<u16>()) {
        let (first, second) = (turned(a, s), turned(b, t));
        assert_close(first, exact(a, s), STEP)?;
        assert_close(first.then(second), product(exact(b, t), exact(a, s)), STEP)?;
        assert_close(first.then(first.conjugate()), [1.0, 0.0, 0.0, 0.0], STEP)?;
        // As matrices chain.
        let chained = first.to_matrix::<Model, World>().then(&second.to_matrix::<World, World>());
        let product: Matrix<Model, World> = first.then(second).to_matrix();
        for (a, b) in chained.rows().as_flattened().iter().zip(product.rows().as_flattened()) {
            prop_assert!(a.abs_diff(*b) <= 4.0 * STEP);
        }
    }

    #[test]
    fn the_way_between_two(a in axis(), b in axis(), s in any::<u16>(), t in any::<u16>(), part in 0..=65_536_i32) {
        let (from, to) = (turned(a, s), turned(b, t));
        let dot: f64 = exact(a, s).iter().zip(exact(b, t)).map(|(p, q)| p * q).sum();
        // Half a turn apart there are two shortest ways.
        prop_assume!(dot.abs() > 0.001);
        let there = slerp(exact(a, s), exact(b, t), f64::from(part) * STEP);
        assert_close(from.slerp(to, Scalar::from_bits(part)), there, 1.5 * STEP)?;
        prop_assert_eq!(from.nlerp(to, number(-3.0)), from.nlerp(to, Scalar::ZERO));
        assert_close(from.nlerp(to, Scalar::MAX), exact(b, t), 1.5 * STEP)?;
        assert_close(from.slerp(to, Scalar::MAX), exact(b, t), 1.5 * STEP)?;
    }
}
