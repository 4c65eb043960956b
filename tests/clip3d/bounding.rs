//! Bounding volumes: what they hold they hold, `Outside` and `Inside` are true, and few are `Crossing` without need.

use aquatint::{
    Angle, BoundingBox3, BoundingSphere, Clip, Frustum, HalfSpace, Matrix, Point3, Scalar, Vector3, View, World,
    clip::{
        bounds::Verdict,
        frustum::BoundingVolume,
        volume::{Plane, Volume},
    },
};
use proptest::prelude::*;

use super::{coordinate, planes::cameras, point3};

type Place = [i32; 3];

fn places() -> impl Strategy<Value = Place> {
    prop::array::uniform3(coordinate())
}

/// Some points, not far from each other or anywhere.
fn clouds() -> impl Strategy<Value = Vec<Place>> {
    let near = (places(), prop::collection::vec(prop::array::uniform3(-300_000..300_000_i32), 1..6));
    let near = near.prop_map(|(middle, offsets)| {
        let shifted = |offset: Place| core::array::from_fn(|i| middle[i].saturating_add(offset[i]));
        offsets.into_iter().map(shifted).collect()
    });
    prop_oneof![3 => near, 1 => prop::collection::vec(places(), 1..6)]
}

fn matrices() -> impl Strategy<Value = Matrix<World, View>> {
    let element = prop_oneof![4 => -200_000..200_000_i32, 1 => coordinate()];
    prop::array::uniform4(prop::array::uniform4(element))
        .prop_map(|rows| Matrix::from_rows(rows.map(|row| row.map(Scalar::from_bits))))
}

fn box_of(cloud: &[Place]) -> BoundingBox3<World> {
    BoundingBox3::of(cloud.iter().map(|&place| point3(place))).expect("points")
}

fn sphere_of(cloud: &[Place]) -> BoundingSphere<World> {
    BoundingSphere::of(cloud.iter().map(|&place| point3(place))).expect("points")
}

fn square(a: Place, b: Place) -> i128 {
    (0..3).map(|i| (i128::from(a[i]) - i128::from(b[i])).pow(2)).sum()
}

/// A place of a box, by weights of 0 to 16 along its axes.
fn inside(bounds: &BoundingBox3<World>, weights: [i64; 3]) -> Place {
    let ends = |min: Scalar, max: Scalar| [i64::from(min.to_bits()), i64::from(max.to_bits())];
    let (min, max) = (bounds.min(), bounds.max());
    let axes = [ends(min.x, max.x), ends(min.y, max.y), ends(min.z, max.z)];
    core::array::from_fn(|i| {
        let [min, max] = axes[i];
        i32::try_from(min + (max - min) * weights[i] / 16).expect("between")
    })
}

fn within<S>(bounds: &BoundingBox3<S>, point: &Point3<S>) -> bool {
    let axis = |v: Scalar, min: Scalar, max: Scalar| min <= v && v <= max;
    let (min, max) = (bounds.min(), bounds.max());
    axis(point.x, min.x, max.x) && axis(point.y, min.y, max.y) && axis(point.z, min.z, max.z)
}

fn moved(matrix: &Matrix<World, View>, place: Place) -> Point3<View> {
    let point = matrix.transform_point(point3(place));
    Point3::new(point.x, point.y, point.z)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn bounds_hold_their_points_and_unions_hold_both(one in clouds(), other in clouds(), any in places()) {
        let (first, second) = (box_of(&one), box_of(&other));
        let (ball, second_ball) = (sphere_of(&one), sphere_of(&other));
        let (both, both_balls) = (first.union(&second), ball.union(&second_ball));
        for place in one.iter().chain(&other).map(|&place| point3(place)) {
            prop_assert!(both.contains(&place) && both_balls.contains(&place));
        }
        prop_assert!(one.iter().all(|&place| first.contains(&point3(place)) && ball.contains(&point3(place))));
        prop_assert_eq!(first.contains(&point3(any)), within(&first, &point3(any)));
        let radius = i128::from(ball.radius());
        let center = [ball.center().x, ball.center().y, ball.center().z].map(Scalar::to_bits);
        prop_assert_eq!(ball.contains(&point3(any)), square(center, any) <= radius * radius);
        // The diagonal of the box, and a unit.
        let diagonal = square(inside(&first, [0; 3]), inside(&first, [16; 3]));
        prop_assert!((2 * radius - 4).max(0).pow(2) <= diagonal);
    }

    #[test]
    fn the_union_of_spheres_is_hardly_larger_than_it_has_to_be(
        a in places(), b in places(), radii in prop::array::uniform2(prop_oneof![0..9_u32, 0..400_000_u32, any::<u32>()]),
    ) {
        let balls = [BoundingSphere::<World>::new(point3(a), radii[0]), BoundingSphere::new(point3(b), radii[1])];
        let union = balls[0].union(&balls[1]);
        let apart = (square(a, b) as f64).sqrt();
        let [p, q] = radii.map(f64::from);
        let least = ((apart + p + q) / 2.0).max(p).max(q);
        let (radius, is_everything) = (f64::from(union.radius()), union == BoundingSphere::EVERYTHING);
        prop_assert!(is_everything && least > 4_294_967_290.0 || (least - 1.0..least + 12.0).contains(&radius), "{radius} for {least}");
        prop_assert_eq!(union, balls[1].union(&balls[0]), "either way");
    }

    #[test]
    fn collisions_are_exact(one in clouds(), other in clouds(), radii in prop::array::uniform2(prop_oneof![0..400_000_u32, any::<u32>()])) {
        let (first, second) = (box_of(&one), box_of(&other));
        let ends = |bounds: &BoundingBox3<World>| (inside(bounds, [0; 3]), inside(bounds, [16; 3]));
        let ((min, max), (other_min, other_max)) = (ends(&first), ends(&second));
        let overlap = (0..3).all(|i| min[i] <= other_max[i] && other_min[i] <= max[i]);
        prop_assert_eq!(first.collides(&second), overlap);
        prop_assert_eq!(second.collides(&first), overlap);

        let (a, b) = (one[0], other[0]);
        let [ball, second_ball] = [(a, radii[0]), (b, radii[1])].map(|(at, radius)| BoundingSphere::new(point3(at), radius));
        let sum = i128::from(radii[0]) + i128::from(radii[1]);
        prop_assert_eq!(ball.collides(&second_ball), square(a, b) <= sum * sum);
        let nearest = core::array::from_fn(|i| a[i].clamp(other_min[i], other_max[i]));
        prop_assert_eq!(ball.collides_with_box(&second), square(a, nearest) <= i128::from(radii[0]).pow(2));
    }

    #[test]
    fn transformed_bounds_hold_the_transformed_points(
        cloud in clouds(), matrix in matrices(), weights in prop::array::uniform3(0..=16_i64),
    ) {
        let (bounds, ball) = (box_of(&cloud), sphere_of(&cloud));
        let (turned, turned_ball) = (bounds.transformed(&matrix), ball.transformed(&matrix));
        prop_assert!(turned.contains(&moved(&matrix, inside(&bounds, weights))));
        for &place in &cloud {
            prop_assert!(turned.contains(&moved(&matrix, place)) && turned_ball.contains(&moved(&matrix, place)));
        }
        // The six ends of the sphere itself.
        let center = [ball.center().x, ball.center().y, ball.center().z].map(Scalar::to_bits);
        for axis in 0..3 {
            let mut end = center;
            end[axis] = end[axis].saturating_add_unsigned(ball.radius());
            prop_assert!(turned_ball.contains(&moved(&matrix, end)));
        }
    }

    #[test]
    fn verdicts_on_half_spaces_are_true(
        cloud in clouds(), normal in prop::array::uniform3(-1_i32 << 29..=1 << 29), through in places(),
        weights in prop::array::uniform3(0..=16_i64),
    ) {
        let [x, y, z] = normal.map(Scalar::from_bits);
        let side = HalfSpace::through(point3(through), Vector3::<World>::new(x, y, z)).expect("in range");
        let (bounds, ball) = (box_of(&cloud), sphere_of(&cloud));
        let is_true = |verdict: Verdict, place: Place| match verdict {
            Verdict::Outside => !side.contains(point3(place)),
            Verdict::Inside => side.contains(point3(place)),
            Verdict::Crossing => true,
        };
        let verdict = bounds.against_half_space(&side);
        prop_assert!(is_true(verdict, inside(&bounds, weights)));
        prop_assert!(cloud.iter().all(|&place| is_true(ball.against_half_space(&side), place)));
        // Exact for a box: its corners decide.
        let corners = (0..8).map(|bits| inside(&bounds, core::array::from_fn(|i| i64::from(bits >> i & 1) * 16)));
        let mut are_inside = corners.map(|corner| side.contains(point3(corner)));
        let first = are_inside.next();
        let want = if are_inside.any(|is_inside| Some(is_inside) != first) {
            Verdict::Crossing
        } else if first == Some(true) { Verdict::Inside } else { Verdict::Outside };
        prop_assert_eq!(verdict, want);
    }

    #[test]
    fn verdicts_on_frustums_are_true_for_vertices_as_they_are_rounded(
        camera in cameras(), middle in prop::array::uniform3(-2_000_000..2_000_000_i32),
        size in prop::array::uniform3(0..400_000_i32), weights in prop::collection::vec(prop::array::uniform3(0..=16_i64), 8),
    ) {
        let frustum = Frustum::new(&camera).expect("in range");
        let bounds = box_of(&[middle, core::array::from_fn(|i| middle[i] + size[i])]);
        let ball = BoundingSphere::new(point3(middle), size[0].unsigned_abs());
        let (verdict, ball_verdict) = (bounds.against(&frustum), ball.against(&frustum));
        for weights in weights {
            let code = Volume::View.outcode(&camera.transform_point(point3(inside(&bounds, weights))));
            prop_assert!(verdict != Verdict::Outside || code != 0);
            prop_assert!(verdict != Verdict::Inside || code == 0);
            // A place in the ball: a cube of half its size lies in it.
            let shift = |i: usize| i32::try_from((weights[i] - 8) * i64::from(size[0]) / 16).expect("small");
            let code = Volume::View.outcode(&camera.transform_point(point3(core::array::from_fn(|i| middle[i] + shift(i)))));
            prop_assert!(ball_verdict != Verdict::Outside || code != 0);
            prop_assert!(ball_verdict != Verdict::Inside || code == 0);
        }
        // Certain cases are decided: all corners beyond one plane, or all of them inside of all.
        let corners = (0..8).map(|bits| inside(&bounds, core::array::from_fn(|i| i64::from(bits >> i & 1) * 16)));
        let (mut any, mut all) = (0, u8::MAX);
        for corner in corners {
            let code = Volume::View.outcode(&camera.transform_point(point3(corner)));
            (any, all) = (any | code, all & code);
        }
        let (is_outside, is_inside) = (all != 0, any == 0);
        prop_assert!(verdict != Verdict::Inside || is_inside);
        prop_assert!(verdict != Verdict::Outside || is_outside);
    }

    #[test]
    fn a_frustum_takes_any_bounds(rows in prop::array::uniform4(prop::array::uniform4(coordinate())), cloud in clouds(), radius in any::<u32>()) {
        let limit = 1 << 28;
        let matrix = Matrix::<World, Clip>::from_rows(rows.map(|row| row.map(Scalar::from_bits)));
        let is_in_range = rows.iter().flatten().all(|v| (-limit..=limit).contains(v));
        prop_assert_eq!(Frustum::new(&matrix).is_ok(), is_in_range);
        let clamped = rows.map(|row| row.map(|v| Scalar::from_bits(v.clamp(-limit, limit))));
        let frustum = Frustum::new(&Matrix::<World, Clip>::from_rows(clamped)).expect("in range");
        let _ = (box_of(&cloud).against(&frustum), BoundingSphere::new(point3(cloud[0]), radius).against(&frustum));
        prop_assert!(BoundingSphere::EVERYTHING.against(&frustum) != Verdict::Inside);
    }
}

#[test]
fn most_boxes_that_are_not_seen_are_rejected() {
    let identity = Frustum::new(&Matrix::<World, Clip>::IDENTITY).unwrap();
    let one = 1 << 16;
    let cube = |x: i32, y: i32, half: i32| box_of(&[[x - half, y - half, -half], [x + half, y + half, half]]);
    assert_eq!(cube(0, 0, one / 2).against(&identity), Verdict::Inside);
    assert_eq!(cube(2 * one, 0, one / 2).against(&identity), Verdict::Outside);
    assert_eq!(cube(one, one, one / 2).against(&identity), Verdict::Crossing);
    let ball = |x: i32, radius: u32| BoundingSphere::<World>::new(point3([x, 0, 0]), radius).against(&identity);
    assert_eq!(
        [ball(0, 65_000), ball(0, 66_000), ball(140_000, 65_000)],
        [Verdict::Inside, Verdict::Crossing, Verdict::Outside]
    );
}

#[test]
fn a_turned_sphere_is_hardly_larger() {
    for degrees in [0.0, 17.0, 45.0, 233.0] {
        let turn = Matrix::<World, World>::rotation_x(Angle::from_degrees(degrees));
        let turn = turn.then(&Matrix::<World, View>::rotation_y(Angle::from_degrees(degrees / 2.0)));
        let ball = BoundingSphere::<World>::new(point3([1 << 16, 0, 0]), 1 << 16);
        assert!((65_536..65_550).contains(&ball.transformed(&turn).radius()));
        let half = turn.then(&Matrix::<View, View>::scale(Scalar::from_num(0.5)));
        assert!((32_768..32_780).contains(&ball.transformed(&half).radius()));
    }
}

#[test]
fn at_the_border_a_vertex_may_be_rounded_to_either_side() {
    let half = Scalar::from_num(0.5);
    let mut rows = *Matrix::<World, Clip>::IDENTITY.rows();
    rows[0][0] = half;
    let matrix = Matrix::from_rows(rows);
    let frustum = Frustum::new(&matrix).unwrap();
    for (sign, beyond) in [1, -1].into_iter().flat_map(|sign| (-4..=4).map(move |beyond| (sign, beyond))) {
        // So many halves of a unit beyond the border.
        let place = [sign * ((2 << 16) + beyond), 0, 0];
        let verdict = box_of(&[place]).against(&frustum);
        let want = match beyond {
            ..=-2 => Verdict::Inside,
            -1..=2 => Verdict::Crossing,
            _ => Verdict::Outside,
        };
        assert_eq!(verdict, want, "{sign} {beyond}");
        assert_eq!(BoundingSphere::new(point3(place), 0).against(&frustum), want);
        let is_seen = Volume::View.outcode(&matrix.transform_point(point3(place))) == 0;
        assert!(if is_seen { verdict != Verdict::Outside } else { verdict != Verdict::Inside });
    }
}

#[test]
fn sides_are_in_the_order_of_the_planes() {
    let frustum = Frustum::new(&Matrix::<World, Clip>::IDENTITY).unwrap();
    let far = 5 << 16;
    let beyond = |plane: Plane| match plane {
        // Here w is 1 everywhere.
        Plane::Eye => None,
        Plane::Near => Some([0, 0, -far]),
        Plane::Far => Some([0, 0, far]),
        Plane::Left => Some([-far, 0, 0]),
        Plane::Right => Some([far, 0, 0]),
        Plane::Bottom => Some([0, -far, 0]),
        Plane::Top => Some([0, far, 0]),
    };
    for (plane, side) in Plane::ALL.into_iter().zip(frustum.sides()) {
        assert!(side.contains(point3([0; 3])));
        assert!(beyond(plane).is_none_or(|place| !side.contains(point3(place))), "{plane:?}");
    }
}

#[test]
fn without_points_there_are_no_bounds() {
    assert_eq!(BoundingBox3::<World>::of([]), None);
    assert_eq!(BoundingSphere::<World>::of([]), None);
    assert_eq!(BoundingBox3::of_places(&[]), None);
    let bounds = BoundingBox3::of_places(&[[i16::MIN, 0, 1], [i16::MAX, 0, 0]]).unwrap();
    assert_eq!(bounds.min().x, Scalar::from_num(-2));
    assert_eq!((bounds.max().x, bounds.max().z), (Scalar::from_bits(131_068), Scalar::from_bits(4)));
}

#[test]
fn everything_holds_the_ends_of_space() {
    for bits in 0..8 {
        let corner: Place = core::array::from_fn(|i| if bits >> i & 1 == 1 { i32::MIN } else { i32::MAX });
        assert!(BoundingSphere::<World>::EVERYTHING.contains(&point3(corner)));
    }
}
