//! Inverses, normals and rotations against floating point, over the accepted range and beyond.

use aquatint::{Angle, Matrix, Model, Point3, Scalar, Vector3, View, World, geometry::projection::Lens};
use proptest::prelude::*;

use crate::{number, rows};

type Rows = [[f64; 4]; 4];

fn floats<From, To>(matrix: &Matrix<From, To>) -> Rows {
    matrix.rows().map(|row| row.map(|v| v.to_num()))
}

/// Gauss-Jordan elimination with the largest pivots.
fn inverse(rows: &Rows) -> Option<Rows> {
    let mut wide = [[0.0; 8]; 4];
    for (i, row) in rows.iter().enumerate() {
        wide[i][..4].copy_from_slice(row);
        wide[i][4 + i] = 1.0;
    }
    for column in 0..4 {
        let pivot = (column..4).max_by(|&a, &b| wide[a][column].abs().total_cmp(&wide[b][column].abs()))?;
        wide.swap(column, pivot);
        let divisor = wide[column][column];
        if divisor == 0.0 {
            return None;
        }
        wide[column] = wide[column].map(|v| v / divisor);
        for other in (0..4).filter(|&other| other != column) {
            let (factor, row) = (wide[other][column], wide[column]);
            for (v, part) in wide[other].iter_mut().zip(row) {
                *v -= factor * part;
            }
        }
    }
    Some(wide.map(|[.., a, b, c, d]| [a, b, c, d]))
}

fn affine([x, y, z, _]: [[Scalar; 4]; 4]) -> Matrix<Model, World> {
    Matrix::from_rows([x, y, z, [Scalar::ZERO, Scalar::ZERO, Scalar::ZERO, Scalar::ONE]])
}

/// What the exact inverse times the matrix differs from the identity, as rounding of its elements explains it.
fn assert_inverse(matrix: &Matrix<Model, World>) -> Result<(), TestCaseError> {
    let (forth, exact) = (floats(matrix), inverse(&floats(matrix)));
    match (matrix.inverse(), exact) {
        (Some(got), Some(exact)) => {
            // Floating point is itself off by the condition of the matrix.
            let size = |rows: &Rows| rows.iter().flatten().fold(0.0_f64, |most, v| most.max(v.abs()));
            let slack = 1e-14 * size(&forth) * size(&exact) * size(&exact);
            for (got, exact) in floats(&got).as_flattened().iter().zip(exact.as_flattened()) {
                prop_assert!((got - exact).abs() <= 0.5 / 65_536.0 + slack, "{} for {}", got, exact);
            }
        }
        (None, Some(exact)) => {
            let most = exact.iter().flatten().fold(0.0_f64, |most, v| most.max(v.abs()));
            prop_assert!(most >= 32_767.0, "an inverse is missing: {:?}", exact);
        }
        (_, None) => {}
    }
    Ok(())
}

/// Turns, scales by axis, shears and moves of usual sizes.
fn usual() -> impl Strategy<Value = Matrix<Model, World>> {
    let scale = || prop_oneof![1_000..400_000_i32, -400_000..-1_000_i32];
    (any::<[u16; 3]>(), prop::array::uniform3(scale()), prop::array::uniform3(-6_000_000..6_000_000_i32)).prop_map(
        |([x, y, z], scale, shift)| {
            let [a, b, c] = scale.map(Scalar::from_bits);
            let [p, q, r] = shift.map(Scalar::from_bits);
            Matrix::<Model, Model>::rotation_x(Angle(x))
                .then(&Matrix::<Model, Model>::scale_by(a, b, c))
                .then(&Matrix::<Model, Model>::rotation_y(Angle(y)))
                .then(&Matrix::<Model, Model>::rotation_z(Angle(z)))
                .then(&Matrix::translation(p, q, r))
        },
    )
}

/// A turn, a scale for all axes, a move.
fn uniform() -> impl Strategy<Value = (Matrix<Model, World>, f64)> {
    (any::<[u16; 2]>(), 4_096..1_000_000_i32, prop::array::uniform3(-6_000_000..6_000_000_i32)).prop_map(
        |([x, y], scale, shift)| {
            let [p, q, r] = shift.map(Scalar::from_bits);
            let scale = Scalar::from_bits(scale);
            let turned =
                Matrix::<Model, Model>::rotation_x(Angle(x)).then(&Matrix::<Model, Model>::rotation_y(Angle(y)));
            let placed = turned.then(&Matrix::<Model, Model>::scale(scale)).then(&Matrix::translation(p, q, r));
            (placed, scale.to_num())
        },
    )
}

fn point<S>([x, y, z]: [f64; 3]) -> Point3<S> {
    Point3::new(number(x), number(y), number(z))
}

fn vector<S>([x, y, z]: [f64; 3]) -> Vector3<S> {
    Vector3::new(number(x), number(y), number(z))
}

fn of<S>(v: &Vector3<S>) -> [f64; 3] {
    [v.x, v.y, v.z].map(|v| v.to_num())
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(5_000))]

    #[test]
    fn the_inverse_of_usual_matrices(matrix in usual()) {
        assert_inverse(&matrix)?;
        let there = matrix.inverse().expect("not flat").inverse().expect("not flat");
        let largest = floats(&matrix).iter().flatten().fold(1.0_f64, |most, v| most.max(v.abs()));
        for (a, b) in floats(&matrix).as_flattened().iter().zip(floats(&there).as_flattened()) {
            prop_assert!((a - b).abs() <= largest * 0.02, "{} and {}", a, b);
        }
    }

    #[test]
    fn the_inverse_of_any_matrix(rows in rows()) {
        let _ = Matrix::<Model, World>::from_rows(rows).inverse();
        assert_inverse(&affine(rows))?;
    }

    #[test]
    fn normals_stay_upright(
        matrix in usual(), along in prop::array::uniform3(-1.0..1.0_f64), other in prop::array::uniform3(-1.0..1.0_f64),
    ) {
        let cross = [
            along[1] * other[2] - along[2] * other[1],
            along[2] * other[0] - along[0] * other[2],
            along[0] * other[1] - along[1] * other[0],
        ];
        prop_assume!(dot(cross, cross) > 0.01);
        let length = dot(cross, cross).sqrt();
        let normal = matrix.normals().transform_vector(vector::<Model>(cross.map(|v| v / length)));
        let Some(normal) = normal.normalized() else { return Ok(()) };
        let exact = inverse(&floats(&matrix)).expect("not flat");
        // The transpose of the inverse.
        let mut upright = [0, 1, 2].map(|i| dot([exact[0][i], exact[1][i], exact[2][i]], cross));
        let size = dot(upright, upright).sqrt();
        upright = upright.map(|v| v / size);
        // Scales that differ a hundredfold cost as many digits.
        let spread = exact[..3].iter().map(|r| r[..3].iter().map(|v| v.abs()).fold(0.0, f64::max)).fold(0.0, f64::max)
            * length / size;
        for (got, exact) in of(&normal).into_iter().zip(upright) {
            prop_assert!((got - exact).abs() <= 4.0 / 65_536.0 * (1.0 + spread), "{} for {}, spread {}", got, exact, spread);
        }
    }

    #[test]
    fn normals_of_any_matrix_have_large_elements(rows in rows()) {
        let normals = floats(&Matrix::<Model, World>::from_rows(rows).normals());
        let largest = normals[..3].iter().flat_map(|row| &row[..3]).fold(0.0_f64, |most, v| most.max(v.abs()));
        prop_assert!(largest == 0.0 || (0.5..=1.0).contains(&largest), "{}", largest);
    }

    #[test]
    fn points_come_from_where_they_were((matrix, scale) in uniform(), place in prop::array::uniform3(-2.0..2.0_f64)) {
        let back = matrix.untransform_point({
            let p = matrix.transform_point(point(place));
            Point3::new(p.x, p.y, p.z)
        }).expect("a scale");
        for (got, exact) in [back.x, back.y, back.z].into_iter().zip(place) {
            let bound = dot(place, place).sqrt() / 8_192.0 + 2.0 / 65_536.0 * (1.0 + 1.0 / scale);
            prop_assert!((got.to_num::<f64>() - exact).abs() <= bound, "{} for {}", got, exact);
        }
    }

    #[test]
    fn nothing_overflows(rows in rows(), corner in prop::array::uniform3(crate::element()), turn in any::<u16>()) {
        let matrix = Matrix::<Model, World>::from_rows(rows);
        let [x, y, z] = corner;
        let _ = matrix.untransform_point(Point3::new(x, y, z));
        let _ = matrix.orthonormalized();
        let _ = Matrix::<World, View>::from_rows(rows).eye();
        let _ = Matrix::<Model, World>::rotation_about(Vector3::new(x, y, z), Angle(turn));
    }

    #[test]
    fn a_camera_knows_where_its_eye_is(
        eye in prop::array::uniform3(-100.0..100.0_f64), centre in prop::array::uniform3(-100.0..100.0_f64),
    ) {
        let up = vector([0.1, 1.0, 0.3]);
        let Some(camera) = Matrix::<World, View>::look_at(point(eye), point(centre), up) else { return Ok(()) };
        let got = camera.eye();
        for (got, exact) in [got.x, got.y, got.z].into_iter().zip(eye) {
            prop_assert!((got.to_num::<f64>() - exact).abs() <= 4.0 / 65_536.0, "{} for {}", got, exact);
        }
    }

    #[test]
    fn rotations_about_any_axis(axis in prop::array::uniform3(any::<i16>()), turn in any::<u16>()) {
        let axis = axis.map(f64::from);
        prop_assume!(dot(axis, axis) > 0.0);
        let got = floats(&Matrix::<Model, World>::rotation_about(vector(axis.map(|v| v / 65_536.0)), Angle(turn)).expect("an axis"));
        let length = dot(axis, axis).sqrt();
        let [x, y, z] = axis.map(|v| v / length);
        let (s, c) = (f64::from(turn) / 65_536.0 * core::f64::consts::TAU).sin_cos();
        let r = 1.0 - c;
        let exact = [
            [c + r * x * x, r * x * y - s * z, r * x * z + s * y, 0.0],
            [r * x * y + s * z, c + r * y * y, r * y * z - s * x, 0.0],
            [r * x * z - s * y, r * y * z + s * x, c + r * z * z, 0.0],
        ];
        for (got, exact) in got.as_flattened().iter().zip(exact.as_flattened()) {
            prop_assert!((got - exact).abs() <= 4.0 / 65_536.0, "{} for {}", got, exact);
        }
    }
}

#[test]
fn what_is_flat_or_not_affine_has_no_inverse() {
    let nil = Scalar::ZERO;
    assert_eq!(Matrix::<Model, World>::scale_by(Scalar::ONE, nil, Scalar::ONE).inverse(), None);
    assert_eq!(Matrix::<Model, World>::scale(Scalar::DELTA).inverse(), None, "65536 is out of range");
    let lens = Lens { field_of_view: Angle::QUARTER, aspect: Scalar::ONE, near: Scalar::ONE, far: number(9.0) };
    assert_eq!(Matrix::perspective(lens).expect("a lens").inverse(), None);
    let flat = Matrix::<Model, World>::scale_by(Scalar::ONE, nil, Scalar::ONE).normals();
    let up = flat.transform_vector(vector([0.3, 0.5, 0.1])).normalized().expect("a normal");
    assert_eq!([up.x, up.y, up.z], [nil, Scalar::ONE, nil]);
}

#[test]
fn normals_of_a_mirrored_object_point_outwards() {
    let mirror = Matrix::<Model, World>::scale_by(-Scalar::ONE, Scalar::ONE, Scalar::ONE).normals();
    let right = of(&mirror.transform_vector(vector([1.0, 0.0, 0.0])));
    assert!(right[0] < -0.4 && right[1].abs() < 0.1, "{right:?}");
}

/// How far the products of rows are from those of a rotation.
pub fn unevenness(matrix: &Matrix<Model, World>) -> f64 {
    let rows = floats(matrix).map(|[x, y, z, _]| [x, y, z]);
    let pairs = (0..3).flat_map(|i| (0..3).map(move |j| (i, j)));
    pairs.map(|(i, j)| (dot(rows[i], rows[j]) - f64::from(u8::from(i == j))).abs()).fold(0.0, f64::max)
}

#[test]
fn ten_thousand_turns_made_right_every_64() {
    let step = Matrix::<World, World>::rotation_y(Angle(1_234)).then(&Matrix::rotation_x(Angle(4_321)));
    let (mut kept, mut lost) = (Matrix::<Model, World>::IDENTITY, Matrix::<Model, World>::IDENTITY);
    for turn in 1..=10_000 {
        (kept, lost) = (kept.then(&step), lost.then(&step));
        if turn % 64 == 0 {
            kept = kept.orthonormalized().expect("a rotation");
            assert!(unevenness(&kept) <= 1.0 / 16_384.0, "{}", unevenness(&kept));
        }
        assert!(unevenness(&kept) <= 8e-3, "{}", unevenness(&kept));
    }
    assert!(unevenness(&lost) > 8e-3, "there was something to make right");
    assert_eq!(Matrix::<Model, World>::scale(Scalar::ZERO).orthonormalized(), None);
}
