//! Clip planes of the user's: the same boundary in the world and in clip space.

use aquatint::{
    Angle, Clip, ClipPlane, HalfSpace, Matrix, Point3, Scalar, Vector3, View, World, clip::window::Boundary,
};
use proptest::prelude::*;

use super::{point3, point4};

fn scalar(value: f64) -> Scalar {
    Scalar::saturating_from_num(value)
}

/// A camera somewhere, that looks somewhere, with some lens.
pub fn cameras() -> impl Strategy<Value = Matrix<World, Clip>> {
    let turns = prop::array::uniform3(0.0..360.0_f32);
    (turns, prop::array::uniform3(-20.0..20.0_f64), 20.0..100.0_f32, 0.125..1.0_f64, 20.0..300.0_f64).prop_map(
        |([x, y, z], [dx, dy, dz], field, near, far)| {
            let moved = Matrix::<World, World>::translation(scalar(dx), scalar(dy), scalar(dz));
            let turned = Matrix::<World, World>::rotation_x(Angle::from_degrees(x))
                .then(&Matrix::<World, World>::rotation_y(Angle::from_degrees(y)))
                .then(&Matrix::<World, View>::rotation_z(Angle::from_degrees(z)));
            let cotangent = f64::from((field.to_radians() / 2.0).tan().recip());
            let (depth, shift) = ((far + near) / (near - far), 2.0 * far * near / (near - far));
            let rows = [
                [cotangent, 0.0, 0.0, 0.0],
                [0.0, cotangent, 0.0, 0.0],
                [0.0, 0.0, depth, shift],
                [0.0, 0.0, -1.0, 0.0],
            ];
            moved.then(&turned).then(&Matrix::from_rows(rows.map(|row| row.map(scalar))))
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn a_half_space_of_the_world_is_the_same_in_clip_space(
        camera in cameras(), normal in prop::array::uniform3(-65_536..65_536_i32),
        through in prop::array::uniform3(-2_000_000..2_000_000_i32),
        points in prop::collection::vec(prop::array::uniform3(-4_000_000..4_000_000_i32), 8),
    ) {
        let length = normal.iter().map(|&v| f64::from(v).powi(2)).sum::<f64>().sqrt();
        prop_assume!(length > 1000.0);
        let [x, y, z] = normal.map(Scalar::from_bits);
        let side = HalfSpace::through(point3(through), Vector3::<World>::new(x, y, z)).expect("in range");
        let plane = side.in_clip_space(&camera).expect("a camera can be undone");
        for point in points {
            let exact = (0..3).map(|i| f64::from(normal[i]) * f64::from(point[i] - through[i])).sum::<f64>() / length;
            let there = camera.transform_point(point3(point));
            // Units of 2⁻¹⁶ along the normal: a rounded vertex is no nearer than this to what it was. The matrix
            // itself is rounded and undone as it is.
            if exact.abs() > 2_000.0 {
                prop_assert_eq!(Boundary::distance(&plane, &there) >= 0, exact >= 0.0, "{} units", exact);
            }
        }
    }

    #[test]
    fn any_matrix_and_any_half_space_give_a_plane_or_none(
        rows in prop::array::uniform4(prop::array::uniform4(any::<i32>())), extreme in any::<u16>(),
        normal in prop::array::uniform3(-1_i32 << 29..=1 << 29), through in prop::array::uniform3(any::<i32>()),
    ) {
        let mut rows = rows;
        for (bit, element) in rows.iter_mut().flatten().enumerate() {
            if extreme >> bit & 1 == 1 {
                *element = if *element < 0 { i32::MIN } else { i32::MAX };
            }
        }
        let matrix = Matrix::<World, Clip>::from_rows(rows.map(|row| row.map(Scalar::from_bits)));
        let [x, y, z] = normal.map(Scalar::from_bits);
        let side = HalfSpace::through(point3(through), Vector3::new(x, y, z)).expect("in range");
        if let Some(plane) = side.in_clip_space(&matrix) {
            for v in [i32::MIN, i32::MAX] {
                let _ = Boundary::distance(&plane, &point4([v, v, i32::MIN, i32::MAX]));
            }
        }
    }
}

#[test]
fn a_matrix_that_cannot_be_undone_gives_no_plane() {
    let up = HalfSpace::<World>::new(Vector3::new(Scalar::ZERO, Scalar::ONE, Scalar::ZERO), Scalar::ONE).unwrap();
    let flat = Matrix::<World, Clip>::from_rows([[Scalar::ONE; 4]; 4]);
    assert_eq!(up.in_clip_space(&flat), None);
    assert_eq!(up.in_clip_space(&Matrix::from_rows([[Scalar::ZERO; 4]; 4])), None);
    assert!(up.in_clip_space(&Matrix::IDENTITY).is_some());
}

#[test]
fn a_plane_keeps_its_side_where_the_matrix_mirrors() {
    let right = HalfSpace::<World>::new(Vector3::new(Scalar::ONE, Scalar::ZERO, Scalar::ZERO), Scalar::ZERO).unwrap();
    let mut rows = *Matrix::<World, Clip>::IDENTITY.rows();
    rows[0][0] = -Scalar::ONE;
    let mirror = Matrix::<World, Clip>::from_rows(rows);
    let plane = right.in_clip_space(&mirror).unwrap();
    let point = |x: i32| mirror.transform_point(Point3::new(Scalar::from_num(x), Scalar::ONE, Scalar::ONE));
    assert!(Boundary::distance(&plane, &point(3)) > 0 && Boundary::distance(&plane, &point(-3)) < 0);
}

#[test]
fn what_is_too_long_is_refused() {
    let (most, more) = (Scalar::from_bits(1 << 29), Scalar::from_bits((1 << 29) + 1));
    let nil = Scalar::ZERO;
    assert!(HalfSpace::<World>::new(Vector3::new(most, -most, nil), Scalar::MIN).is_ok());
    assert!(HalfSpace::<World>::new(Vector3::new(nil, nil, more), nil).is_err());
    assert!(HalfSpace::<World>::new(Vector3::new(Scalar::MIN, nil, nil), nil).is_err());
    assert!(ClipPlane::new([most; 4]).is_ok() && ClipPlane::new([nil, nil, nil, -more]).is_err());
    let all = HalfSpace::through(point3([1; 3]), Vector3::<World>::new(nil, nil, nil)).unwrap();
    assert!(all.contains(point3([i32::MIN; 3])) && all.opposite().contains(point3([7; 3])));
}
