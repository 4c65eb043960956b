//! A hierarchy finds what a list finds, of any shapes.

use aquatint::hidden::raycast::{Hierarchy, Node, Objects, Ray, Shape};
use proptest::prelude::*;

use super::scenes::{block, plane, point, sphere, triangle, vector};

fn coordinates(most: f64) -> impl Strategy<Value = [f64; 3]> {
    // Some are whole numbers, so that places coincide.
    let one = prop_oneof![2 => -most..most, 1 => (-4..=4_i32).prop_map(f64::from)];
    prop::array::uniform3(one)
}

fn shapes() -> impl Strategy<Value = Shape> {
    prop_oneof![
        4 => (coordinates(20.0), 0.01..3.0_f64).prop_map(|(center, radius)| sphere(center, radius)),
        4 => (coordinates(20.0), prop::array::uniform2(coordinates(4.0))).prop_map(|(a, [b, c])| {
            triangle([a, [0, 1, 2].map(|i| a[i] + b[i]), [0, 1, 2].map(|i| a[i] + c[i])])
        }),
        4 => (coordinates(20.0), coordinates(3.0)).prop_map(|(a, b)| block(a, [0, 1, 2].map(|i| a[i] + b[i]))),
        1 => (coordinates(20.0), coordinates(1.0)).prop_map(|(p, n)| plane(p, n)),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3_000))]

    #[test]
    fn the_same_hit(
        mut shapes in prop::collection::vec(shapes(), 0..70),
        twice in prop::collection::vec(0..70_usize, 0..6),
        rays in prop::collection::vec((coordinates(24.0), coordinates(24.0)), 12),
    ) {
        // Some shapes are there twice: of two hits at one place that of the lower number counts.
        let again: Vec<_> = twice.iter().filter_map(|&number| shapes.get(number).copied()).collect();
        shapes.extend(again);
        let mut nodes = vec![Node::default(); 2 * shapes.len()];
        let tree = Hierarchy::new(&shapes, &mut nodes).expect("two for each");
        for (from, to) in rays {
            let way = vector([0, 1, 2].map(|axis| to[axis] - from[axis]));
            for ray in [Ray::new(point(from), way), Ray::between(point(from), point(to))] {
                let ray = ray.expect("in range");
                prop_assert_eq!(tree.nearest(&ray), shapes.nearest(&ray));
                prop_assert_eq!(tree.is_hit(&ray), shapes.is_hit(&ray));
                prop_assert_eq!(tree.is_hit(&ray), tree.nearest(&ray).is_some());
            }
        }
    }

    /// All at one place, or in a row: no box can be halved well, and nothing takes long.
    #[test]
    fn boxes_that_cannot_be_told_apart(count in 1..200_usize, step in 0..3_i32) {
        let shapes: Vec<_> = (0..count).map(|i| sphere([f64::from(step) * i as f64 / 16.0, 0.0, 0.0], 0.5)).collect();
        let mut nodes = vec![Node::default(); 2 * count - 1];
        let tree = Hierarchy::new(&shapes, &mut nodes).expect("just enough");
        let ray = Ray::new(point([-10.0, 0.25, 0.0]), vector([1.0, 0.0, 0.0])).expect("in range");
        prop_assert_eq!(tree.nearest(&ray).expect("all are in line").number, 0);
        prop_assert_eq!(tree.nearest(&ray), shapes.nearest(&ray));
    }
}
