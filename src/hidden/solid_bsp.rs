//! Solids as trees: what is inside, what is in between, where a ray strikes. Lecture 5.8.5.
//!
//! ```text
//!         out ╱ in     The front of a face is outside. What is in front of the last plane, where there are no more
//!   ●────────●         faces, is out; what is behind it is in.
//!   a       ╱ hit
//! ```
//!
//! - **Takes** the [tree](super::bsp) of a closed mesh whose faces all face outwards; points in its own space.
//! - **Gives** exact answers, for integers are compared; where a tree has splits, which are rounded, something within 2⁻²⁰ of them may be
//!   taken for what is next to it.
//! - **Memory** none.
//! - **Cost** one plane a node of the way; for a point on a plane, both sides of it. A ray asks three volumes more of each face that it may
//!   strike.

use core::cmp::Ordering;

use super::bsp::{NONE, Node, Plan, Tree};
use crate::{
    error::OutOfRange,
    num::{Scalar, format_fixed, low_i128},
    space::{Model, Point3},
};

/// Where a point is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Place {
    /// In the solid.
    Inside,
    /// Out of it.
    Outside,
    /// On one of its faces.
    Surface,
}

/// Where a segment strikes a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hit {
    /// Which triangle; of those that share an edge or corner that is struck, the first.
    pub triangle: u16,
    /// How far along the segment, 0 to 1, rounded down.
    pub part: Scalar,
    /// Whether its front is struck: the way leads in.
    pub is_front: bool,
}

format_fixed! {
    impl[] |it: Hit| "Hit {{ triangle: {}, part: {}, is_front: {} }}", it.triangle, Fixed(it.part), it.is_front
}

/// The tree of a closed mesh.
///
/// ```
/// use aquatint::{Point3, Scalar, hidden::{bsp::{Choice, TreeArrays, Triangles}, solid_bsp::{Place, SolidTree}}};
///
/// let positions = [[0, 0, 0], [16384, 0, 0], [0, 16384, 0], [0, 0, 16384]];
/// let triangles = Triangles::new(&positions, &[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]);
/// let arrays = TreeArrays::<4, 4, 0>::build(triangles, Choice::best_of(5))?;
/// let solid = SolidTree::new(arrays.tree());
///
/// let at = |v| Point3::new(Scalar::from_num(v), Scalar::from_num(0.25), Scalar::from_num(0.25));
/// assert_eq!([0.1, 0.5, 0.9].map(|v| solid.place(at(v))), [Place::Inside, Place::Surface, Place::Outside]);
/// let hit = solid.first_hit(at(-1.0), at(1.0))?.unwrap();
/// assert_eq!((hit.triangle, hit.part, hit.is_front), (2, Scalar::from_num(0.5), true));
/// assert!(!solid.line_of_sight(at(-1.0), at(1.0))?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct SolidTree<'a> {
    tree: Tree<'a>,
}

/// Ends of segments have coordinates less than this from zero: 32.
const LIMIT: u32 = 1 << 21;

/// A point, 16.16.
type Place3 = [i32; 3];

/// How far along a segment a plane is: `part` of `whole`, `whole > 0`.
#[derive(Clone, Copy)]
struct Fraction {
    part: i128,
    whole: i128,
}

/// The nearest hit so far.
struct Nearest {
    triangle: u16,
    at: Fraction,
    is_front: bool,
}

impl<'a> SolidTree<'a> {
    /// A tree that was built of a closed mesh. Of others it says what is in front of the faces and what is behind.
    #[must_use]
    pub const fn new(tree: Tree<'a>) -> Self {
        Self { tree }
    }

    /// Where a point is.
    ///
    /// On a plane both of its sides are asked; if they disagree, it is on the surface. Where splits are, which are rounded, what
    /// is within 2⁻²⁰ of the surface may be taken for it, or for being on its other side.
    #[must_use]
    pub fn place(&self, point: Point3<Model>) -> Place {
        let point = bits(&point);
        let side = |node: &Node| self.tree.plane(node).map_or(0, |plane| plane.of_point(point));
        let plan = |node: &Node| {
            let side = side(node);
            Plan { front_is_first: true, first: side >= 0, second: side <= 0 }
        };
        let (mut is_in, mut is_out, mut walk) = (false, self.tree.nodes().is_empty(), self.tree.walk());
        while let Some(node) = walk.next(&plan) {
            let side = side(node);
            is_out |= side >= 0 && node.front == NONE;
            is_in |= side <= 0 && node.back == NONE;
        }
        match (is_in, is_out) {
            (true, true) => Place::Surface,
            (true, false) => Place::Inside,
            _ => Place::Outside,
        }
    }

    /// Whether nothing is struck between two points, both included.
    ///
    /// # Errors
    /// [`OutOfRange`]: a coordinate is 32 or more from zero.
    pub fn line_of_sight(&self, from: Point3<Model>, to: Point3<Model>) -> Result<bool, OutOfRange> {
        Ok(self.first_hit(from, to)?.is_none())
    }

    /// The first face that is struck on the way from one point to another, both included: fronts and backs, their edges, too. A face
    /// whose plane the whole segment lies in is not struck; its neighbours may be.
    ///
    /// # Errors
    /// [`OutOfRange`]: a coordinate is 32 or more from zero.
    pub fn first_hit(&self, from: Point3<Model>, to: Point3<Model>) -> Result<Option<Hit>, OutOfRange> {
        let ends = [bits(&from), bits(&to)];
        if ends.as_flattened().iter().any(|v| v.unsigned_abs() >= LIMIT) {
            return Err(OutOfRange);
        }
        Ok(self.nearest(ends).map(|Nearest { triangle, at, is_front }| Hit {
            triangle,
            part: Scalar::from_bits(low_i128((at.part << 16).checked_div(at.whole).unwrap_or(0))),
            is_front,
        }))
    }

    /// The nodes from one end to the other, as from an eye there. Sides that the segment does not reach are left out, and those
    /// that begin behind a hit.
    fn nearest(&self, ends: [Place3; 2]) -> Option<Nearest> {
        let distances = |node: &Node| {
            let plane = self.tree.plane(node);
            plane.map_or([0; 2], |plane| ends.map(|end| plane.of_point(end)))
        };
        let plan = |node: &Node| {
            let [from, to] = distances(node);
            let front_is_first = from > 0 || (from == 0 && to >= 0);
            let is_parted = from.signum() != to.signum() || from == 0;
            Plan { front_is_first, first: true, second: is_parted }
        };
        let (mut nearest, mut walk) = (None::<Nearest>, self.tree.walk());
        while let Some(node) = walk.next(&plan) {
            let at = Fraction::of(distances(node));
            let is_behind = |hit: &Nearest| at.is_some_and(|at| hit.at.compared(&at) == Ordering::Less);
            if nearest.as_ref().is_some_and(is_behind) {
                walk.leave();
                continue;
            }
            for piece in self.tree.pieces_of(node) {
                let hit = self.strike(piece.triangle, ends);
                nearest = hit.into_iter().chain(nearest).min_by(Nearest::compared);
            }
        }
        nearest
    }

    /// Where a segment strikes a triangle.
    fn strike(&self, triangle: u16, ends @ [from, to]: [Place3; 2]) -> Option<Nearest> {
        let plane = self.tree.triangles().plane(triangle)?;
        let [distance, further] = ends.map(|end| plane.of_point(end));
        let at = Fraction::of([distance, further])?;
        let [a, b, c] = self.tree.triangles().corners(triangle)?.map(|corner| {
            let [x, y, z] = corner.map(|v| i32::from(v) << 2);
            way(from, [x, y, z])
        });
        let along = way(from, to);
        // On which side of each edge the line of the segment passes.
        let sides = [(a, b), (b, c), (c, a)].map(|(here, next)| volume(along, here, next));
        let is_inside = sides.iter().all(|&side| side >= 0) || sides.iter().all(|&side| side <= 0);
        is_inside.then_some(Nearest { triangle, at, is_front: distance > further })
    }
}

impl Nearest {
    fn compared(&self, other: &Self) -> Ordering {
        self.at.compared(&other.at).then(self.triangle.cmp(&other.triangle))
    }
}

impl Fraction {
    /// Where a segment passes or touches a plane, by the distances of its ends; `None` where it does not, or lies in it.
    fn of([from, to]: [i128; 2]) -> Option<Self> {
        let reaches = from.signum() != to.signum();
        reaches.then(|| Self { part: from.abs(), whole: (from - to).abs() })
    }

    /// Products of two distances, less than 2⁵⁸ each.
    fn compared(&self, other: &Self) -> Ordering {
        (self.part * other.whole).cmp(&(other.part * self.whole))
    }
}

fn bits(point: &Point3<Model>) -> Place3 {
    [point.x, point.y, point.z].map(Scalar::to_bits)
}

/// Less than 2²² along each axis.
fn way([x, y, z]: Place3, [to_x, to_y, to_z]: Place3) -> [i64; 3] {
    [to_x - x, to_y - y, to_z - z].map(i64::from)
}

/// Six times the volume of the tetrahedron of three ways: less than 2⁷⁰.
fn volume([a, b, c]: [i64; 3], [d, e, f]: [i64; 3], [g, h, i]: [i64; 3]) -> i128 {
    let normal = [e * i - f * h, f * g - d * i, d * h - e * g];
    [a, b, c].into_iter().zip(normal).map(|(way, normal)| i128::from(way) * i128::from(normal)).sum()
}
