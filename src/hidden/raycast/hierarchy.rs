//! A bounding-volume hierarchy: boxes around boxes around shapes, so that a ray that misses a box misses all in it.
//!
//! ```text
//!   ┌──────────────┐      nodes in the order of a walk, each with its own length:
//!   │ ┌───┐ ┌────┐ │
//!   │ │ a │ │b  c│ │      │ all 5 │ a 1 │ b, c 3 │ b 1 │ c 1 │
//!   │ └───┘ └────┘ │         └─────── missed: go on behind ──────▶
//!   └──────────────┘                  └── missed ────────────▶
//! ```
//!
//! - **Memory** 16 bytes a node, fewer than two nodes a shape, lent by the caller. No stack: neither building nor walking
//!   calls itself.
//! - **Cost** of building: for each of the log₂ k levels, some 20 looks at each shape; 18,500, 211,800 and 2,150,000
//!   instructions of a Cortex-M0 for 8, 64 and 512 triangles. Of rays: how many boxes they look
//!   at, where a list looks at all of the `k`:
//!
//! | k | 8 | 64 | 512 | 4096 |
//! |---|---|---|---|---|
//! | spheres over a surface, as the triangles of a mesh | 13 | 25 | 39 | 50 |
//! | all through space | 12 | 38 | 75 | 150 |
//!
//! On a surface that is O(log k), 4 boxes more for twice as many shapes; through space a ray comes by O(k^⅓) neighbours.

use super::{
    Hit, Shape,
    bounds::Bounds,
    median::halve,
    ray::Ray,
    search::{Objects, Search},
};
use crate::{error::describe, num::index_u16};

/// As many shapes a hierarchy holds at most.
pub const MOST_SHAPES: usize = 1 << 15;

/// One node of a [`Hierarchy`]: a box, and what is in it. Lend `2 k` for `k` shapes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Node {
    pub(super) bounds: Bounds,
    /// How many nodes, with itself, are in its box.
    length: u16,
    /// The shape in a box that has nothing else in it.
    shape: u16,
}

/// Why there is no hierarchy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum HierarchyError {
    /// Fewer nodes than are needed.
    TooFewNodes {
        /// How many are needed.
        needed: usize,
    },
    /// More shapes than [`MOST_SHAPES`].
    TooManyShapes,
}

describe! { HierarchyError,
    Self::TooFewNodes { needed } => "{needed} nodes are needed";
    Self::TooManyShapes => "more than {MOST_SHAPES} shapes";
}

/// Shapes in boxes in boxes; planes, which no box holds, stand in front.
///
/// ```
/// use aquatint::{
///     Point3, Scalar, Vector3,
///     hidden::raycast::{Hierarchy, Node, Objects, Ray, Shape, Sphere},
/// };
///
/// let at = |x: i32| Point3::new(Scalar::from_num(x), Scalar::ZERO, Scalar::ZERO);
/// let mut shapes = [Shape::Sphere(Sphere::new(Point3::ORIGIN, Scalar::ONE)?); 16];
/// for (x, shape) in (-32..).step_by(4).zip(&mut shapes) {
///     *shape = Shape::Sphere(Sphere::new(at(x), Scalar::ONE)?);
/// }
/// let mut nodes = [Node::default(); 32];
/// let hierarchy = Hierarchy::new(&shapes, &mut nodes).expect("twice as many");
///
/// let ray = Ray::new(at(1), Vector3::new(Scalar::ONE, Scalar::ZERO, Scalar::ZERO))?;
/// let hit = hierarchy.nearest(&ray).expect("the next one");
/// assert_eq!((hit.number, hit.distance), (9, Scalar::from_num(2)));
/// # Ok::<(), aquatint::OutOfRange>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Hierarchy<'a> {
    shapes: &'a [Shape],
    nodes: &'a [Node],
}

impl<'a> Hierarchy<'a> {
    /// Sorts shapes into boxes: each box is halved along its longest axis, at the median of what is in it.
    ///
    /// # Errors
    /// [`HierarchyError`]; two nodes a shape are enough.
    pub fn new(shapes: &'a [Shape], nodes: &'a mut [Node]) -> Result<Self, HierarchyError> {
        if shapes.len() > MOST_SHAPES {
            return Err(HierarchyError::TooManyShapes);
        }
        let in_boxes = shapes.iter().filter(|shape| shape.bounds().is_some()).count();
        let planes = shapes.len().saturating_sub(in_boxes);
        let needed = planes.saturating_add((2 * in_boxes).saturating_sub(1));
        let too_few = HierarchyError::TooFewNodes { needed };
        let nodes = nodes.get_mut(..needed).ok_or(too_few)?;
        // Planes from the front, all others from the back.
        let (mut front, mut back) = (0..planes, (0..needed).rev());
        for (number, shape) in (0..).zip(shapes) {
            let bounds = shape.bounds();
            let place = if bounds.is_none() { front.next() } else { back.next() };
            if let Some(node) = place.and_then(|place| nodes.get_mut(place)) {
                *node = Node { bounds: bounds.unwrap_or(Bounds::WORLD), length: 1, shape: number };
            }
        }
        build(nodes.get_mut(planes..).unwrap_or_default());
        Ok(Self { shapes, nodes })
    }

    /// Calls `found` with the number of each shape whose box, as all boxes around it, `meets`, until it says no.
    #[inline]
    fn walk(&self, search: &mut Search, mut go_on: impl FnMut(&mut Search, usize, &Shape) -> bool) {
        let mut at = 0;
        while let Some(node) = self.nodes.get(at) {
            let is_met = search.meets(&node.bounds);
            at += usize::from(if is_met { 1 } else { node.length });
            if !is_met || node.length > 1 {
                continue;
            }
            let number = usize::from(node.shape);
            if self.shapes.get(number).is_some_and(|shape| !go_on(search, number, shape)) {
                return;
            }
        }
    }
}

impl Objects for Hierarchy<'_> {
    fn nearest(&self, ray: &Ray) -> Option<Hit> {
        let mut search = Search::new(ray);
        self.walk(&mut search, |search, number, shape| {
            search.offer(number, shape);
            true
        });
        search.hit(self.shapes)
    }

    fn is_hit(&self, ray: &Ray) -> bool {
        let (mut search, mut is_hit) = (Search::new(ray), false);
        self.walk(&mut search, |search, _, shape| {
            is_hit = search.strikes(shape).is_some();
            !is_hit
        });
        is_hit
    }
}

/// Makes a tree of nodes of which the last ones are its leaves, one more than half.
fn build(tree: &mut [Node]) {
    let all = tree.len();
    set_length(tree.first_mut(), all);
    for at in 0..all {
        let length = tree.get(at).map_or(1, |node| usize::from(node.length));
        if let Some(part) = tree.get_mut(at..at.saturating_add(length)) {
            split(part);
        }
    }
}

/// Makes the first node of a part of a tree, and says where its halves begin.
///
/// ```text
///   │ free … │ n leaves │  becomes  │ node │ free │ m leaves │ free │ n − m leaves │
/// ```
fn split(part: &mut [Node]) {
    let (all, leaves) = (part.len(), part.len().div_ceil(2));
    let (free, half) = (all - leaves, leaves / 2);
    if half == 0 {
        return;
    }
    let whole = part.get_mut(free..).map_or(Bounds::EMPTY, |leaves| halve(leaves, half));
    for at in 0..half {
        let leaf = part.get(free + at).copied();
        if let Some((place, leaf)) = part.get_mut(half + at).zip(leaf) {
            *place = leaf;
        }
    }
    if let Some(node) = part.first_mut() {
        *node = Node { bounds: whole, length: index_u16(all), shape: u16::MAX };
    }
    set_length(part.get_mut(1), 2 * half - 1);
    set_length(part.get_mut(2 * half), all - 2 * half);
}

fn set_length(node: Option<&mut Node>, length: usize) {
    if let Some(node) = node {
        // At most two nodes for each of `MOST_SHAPES`.
        node.length = index_u16(length);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        hidden::raycast::{REACH, Sphere},
        num::Scalar,
        space::{Point3, Vector3},
    };
    extern crate std;
    use std::{vec, vec::Vec};

    /// Pseudo-random places of the world, less than 48 from zero.
    struct Places(u64);

    impl Places {
        fn next(&mut self) -> [i32; 3] {
            [0; 3].map(|_| {
                self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                crate::num::low_i32((self.0 >> 33).cast_signed()) % (48 << 16)
            })
        }
    }

    /// Spheres, smaller the more they are: over a surface, as those of a mesh, or all through space.
    fn spheres(count: u32, thickness: i32) -> Vec<Shape> {
        let mut places = Places(count.into());
        let radius = Scalar::from_bits((24 << 16) / i32::try_from(count.isqrt()).expect("few"));
        let sphere = |[x, y, z]: [i32; 3]| {
            let [x, y, z] = [x, y, z / 48 * thickness].map(|v| Scalar::from_bits(v / 2));
            Shape::Sphere(Sphere::new(Point3::new(x, y, z), radius).unwrap())
        };
        (0..count).map(|_| sphere(places.next())).collect()
    }

    /// Boxes that a ray looks at, as a mean of rays down from the upper side of the world.
    fn looks(hierarchy: &Hierarchy<'_>) -> usize {
        let mut places = Places(9);
        let looks = (0..2_000).map(|_| {
            let ([a, b, _], [x, y, _]) = (places.next(), places.next());
            let way = [x / 2 - a, y / 2 - b, -REACH.to_bits()].map(Scalar::from_bits);
            let [a, b] = [a, b].map(Scalar::from_bits);
            let ray = Ray::new(Point3::new(a, b, REACH), Vector3::new(way[0], way[1], way[2])).unwrap();
            let mut search = Search::new(&ray);
            hierarchy.walk(&mut search, |search, number, shape| {
                search.offer(number, shape);
                true
            });
            search.looks.get()
        });
        looks.sum::<usize>() / 2_000
    }

    fn looks_of_many(thickness: i32) -> [usize; 4] {
        [8, 64, 512, 4_096].map(|count| {
            let shapes = spheres(count, thickness);
            let mut nodes = vec![Node::default(); 2 * shapes.len()];
            looks(&Hierarchy::new(&shapes, &mut nodes).unwrap())
        })
    }

    #[test]
    fn eight_times_as_many_shapes_cost_some_looks_more() {
        let (surface, space) = (looks_of_many(1), looks_of_many(48));
        assert!(surface.windows(2).all(|pair| pair[1] - pair[0] < 20), "{surface:?}");
        // Through space a ray passes twice as many neighbours.
        assert!(space.windows(2).all(|pair| pair[1] < pair[0] * 4), "{space:?}");
    }

    /// Places that are often the same, so that there are several at the median.
    #[test]
    fn what_is_in_front_of_the_median_is_not_behind_it() {
        let mut places = Places(5);
        for count in 2..100_usize {
            let coarse = |place: [i32; 3]| [place[0] >> 20 << 18, 0, 0];
            let node = |place| Node { bounds: Bounds::of([place]), ..Node::default() };
            let mut leaves: Vec<_> = (0..count).map(|_| node(coarse(places.next()))).collect();
            halve(&mut leaves, count / 2);
            let (front, back) = leaves.split_at(count / 2);
            let middles = |leaves: &[Node]| leaves.iter().map(|leaf| leaf.bounds.middle()[0]).collect::<Vec<_>>();
            assert!(middles(front).iter().max() <= middles(back).iter().min(), "{front:?} {back:?}");
        }
    }

    #[test]
    fn a_walk_meets_every_shape_once_and_is_no_deeper_than_need_be() {
        for count in 1..70_u32 {
            let shapes = spheres(count, 48);
            let mut nodes = vec![Node::default(); 2 * shapes.len()];
            let hierarchy = Hierarchy::new(&shapes, &mut nodes).unwrap();
            let mut seen: Vec<_> =
                hierarchy.nodes.iter().filter(|node| node.length == 1).map(|node| node.shape).collect();
            seen.sort_unstable();
            assert!(seen.into_iter().map(u32::from).eq(0..count), "{count}");
            for (at, node) in hierarchy.nodes.iter().enumerate().filter(|(_, node)| node.length > 1) {
                let parts = &hierarchy.nodes[at + 1..at + usize::from(node.length)];
                let (left, right) = parts.split_at(parts[0].length.into());
                assert_eq!(usize::from(right[0].length), right.len());
                assert!(left.len().abs_diff(right.len()) <= 2, "{count}");
                assert_eq!(parts.iter().fold(Bounds::EMPTY, |all, part| all.union(&part.bounds)), node.bounds);
            }
        }
    }
}
