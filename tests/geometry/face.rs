//! Facing against exact arithmetic.

use aquatint::{
    Model, Point2, Point3, Scalar,
    geometry::face::{Side, faces_viewer, is_front, side},
    twice_area,
};
use proptest::prelude::*;

use crate::place;

/// Coordinates around the border between short and long products, and anywhere.
fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        3 => -40..40_i32,
        3 => -70_000..70_000_i32,
        2 => prop::sample::select(vec![0, 32_767, 32_768, -32_767, -32_768]),
        1 => -(1 << 29)..(1 << 29),
    ]
}

fn point() -> impl Strategy<Value = Point2> {
    (coordinate(), coordinate()).prop_map(|(x, y)| Point2::from_sixteenths(x, y))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn the_side_is_the_sign_of_the_area(a in point(), b in point(), c in point()) {
        let want = match twice_area(a, b, c) { 0 => None, 1.. => Some(Side::Back), _ => Some(Side::Front) };
        prop_assert_eq!(side(a, b, c), want);
        prop_assert_eq!(is_front(a, b, c), want == Some(Side::Front));
    }

    #[test]
    fn no_corner_overflows(corners in any::<[(i32, i32); 3]>()) {
        let [a, b, c] = corners.map(|(x, y)| Point2::from_sixteenths(x, y));
        let _ = side(a, b, c);
    }

    #[test]
    fn a_face_is_seen_from_its_front(
        normal in any::<[i8; 3]>(), place in place(),
        eye in prop::array::uniform3(prop_oneof![2 => -(1 << 22)..(1 << 22), 1 => any::<i32>()]),
    ) {
        let dot: i128 = (0..3).map(|i| i128::from(normal[i]) * (i128::from(eye[i]) - 4 * i128::from(place[i]))).sum();
        let [x, y, z] = eye.map(Scalar::from_bits);
        prop_assert_eq!(faces_viewer(normal, place, Point3::<Model>::new(x, y, z)), dot >= 0);
    }
}
