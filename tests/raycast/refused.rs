//! What is out of range is refused, and nothing else panics: numbers at the ends of their range.

use aquatint::{
    OutOfRange, Point3, Scalar, Vector3, World,
    hidden::raycast::{
        Block, Hierarchy, HierarchyError, MOST_SHAPES, Node, Objects, Plane, REACH, Ray, Shape, Sphere, Triangle,
    },
};
use proptest::prelude::*;

use super::scenes::{point, sphere, vector};

fn hostile() -> impl Strategy<Value = Scalar> {
    let end = REACH.to_bits();
    prop_oneof![
        Just(0),
        Just(1),
        Just(-1),
        Just(end),
        Just(-end),
        Just(end + 1),
        Just(end - 1),
        Just(i32::MIN),
        Just(i32::MAX),
        -end..=end,
        any::<i32>(),
    ]
    .prop_map(Scalar::from_bits)
}

fn points() -> impl Strategy<Value = Point3<World>> {
    prop::array::uniform3(hostile()).prop_map(|[x, y, z]| Point3::new(x, y, z))
}

fn shapes() -> impl Strategy<Value = Result<Shape, OutOfRange>> {
    prop_oneof![
        (points(), hostile()).prop_map(|(center, radius)| Sphere::new(center, radius).map(Shape::Sphere)),
        (points(), points()).prop_map(|(p, n)| Plane::new(p, Vector3::new(n.x, n.y, n.z)).map(Shape::Plane)),
        prop::array::uniform3(points()).prop_map(|corners| Triangle::new(corners).map(Shape::Triangle)),
        (points(), points()).prop_map(|(a, b)| Block::new(a, b).map(Shape::Block)),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn nothing_overflows(
        all in prop::collection::vec(shapes(), 1..6),
        origin in points(),
        way in points(),
        to in points(),
    ) {
        let shapes: Vec<_> = all.into_iter().flatten().collect();
        let direction = Vector3::new(way.x, way.y, way.z);
        let rays = [Ray::new(origin, direction), Ray::between(origin, to)];
        let mut nodes = vec![Node::default(); 2 * shapes.len()];
        let tree = Hierarchy::new(&shapes, &mut nodes).expect("two for each");
        for ray in rays.into_iter().flatten() {
            let Some(mut hit) = shapes.nearest(&ray) else { continue };
            prop_assert_eq!(tree.nearest(&ray), Some(hit));
            let _ = shapes.nearest(&ray.reflected(&hit));
            let _ = shapes.is_hit(&hit.towards(direction));
            // Hits may be changed by their owner.
            (hit.position, hit.normal) = (to, direction);
            for ray in [ray.reflected(&hit), hit.towards(direction)].into_iter().chain(hit.ray_to(origin)) {
                let _ = shapes.nearest(&ray);
            }
        }
    }
}

#[test]
fn what_reaches_out_of_the_world() {
    let (inside, beyond) = (point([64.0, -64.0, 0.0]), point([0.0, 64.001, 0.0]));
    let way = vector([1.0, 0.0, 0.0]);
    assert!(Ray::new(inside, way).is_ok());
    assert_eq!(Ray::new(beyond, way), Err(OutOfRange));
    assert_eq!(Ray::between(inside, beyond), Err(OutOfRange));
    assert_eq!(Sphere::new(inside, Scalar::DELTA), Err(OutOfRange));
    assert!(Sphere::new(inside, Scalar::ZERO).is_ok());
    assert_eq!(Sphere::new(point([0.0; 3]), -Scalar::DELTA), Err(OutOfRange));
    assert_eq!(Plane::new(beyond, way), Err(OutOfRange));
    assert!(Plane::new(inside, vector([32_767.0, -32_768.0, 0.0])).is_ok());
    assert_eq!(Block::new(inside, beyond), Err(OutOfRange));
    assert_eq!(Triangle::new([inside, inside, beyond]), Err(OutOfRange));
}

#[test]
fn what_has_no_size_is_never_hit() {
    let origin = point([-3.0, 0.0, 0.0]);
    let ahead = Ray::new(origin, vector([1.0, 0.0, 0.0])).expect("in range");
    let dot = Shape::Sphere(Sphere::new(point([0.0; 3]), Scalar::ZERO).expect("in range"));
    let needle = Triangle::new([[0.0, -1.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.0]].map(point)).expect("in range");
    let nowhere = Plane::new(point([0.0; 3]), vector([0.0; 3])).expect("in range");
    let nothing = [Shape::NOTHING, dot, Shape::Triangle(needle), Shape::Plane(nowhere)];
    assert_eq!(nothing.nearest(&ahead), None);
    // A flat box is a wall, whichever its corners are; seen along its side, too.
    let wall = Shape::Block(Block::new(point([0.0, 1.0, -1.0]), point([0.0, -1.0, 1.0])).expect("in range"));
    assert_eq!([wall].nearest(&ahead).expect("hit").distance, 3);
    // A ray without a direction hits nothing, not even from within.
    let still = Ray::new(point([0.0; 3]), vector([0.0; 3])).expect("in range");
    let around = Shape::Block(Block::new(point([-1.0; 3]), point([1.0; 3])).expect("in range"));
    assert_eq!([sphere([0.0; 3], 1.0), around, wall].nearest(&still), None);
}

#[test]
fn memory_is_asked_for_before_anything_is_done() {
    let shapes = [sphere([0.0; 3], 1.0); 5];
    let mut nodes = [Node::default(); 9];
    let too_few = Hierarchy::new(&shapes, &mut nodes[..8]).map(|_| ());
    assert_eq!(too_few, Err(HierarchyError::TooFewNodes { needed: 9 }));
    assert!(Hierarchy::new(&shapes, &mut nodes).is_ok());
    assert!(Hierarchy::new(&[], &mut []).is_ok());
    let many = vec![Shape::NOTHING; MOST_SHAPES + 1];
    let mut nodes = vec![Node::default(); 2 * MOST_SHAPES];
    assert_eq!(Hierarchy::new(&many, &mut nodes).map(|_| ()), Err(HierarchyError::TooManyShapes));
    assert!(Hierarchy::new(&many[1..], &mut nodes).is_ok());
}
