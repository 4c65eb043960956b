//! BSP trees: planes part space, again and again, until an order of all faces can be read off for any eye. Lecture 5.8.
//!
//! ```text
//!   seen from above              the tree
//!   2│     3│     │4'                1
//!    │      │     │          front ╱   ╲ back      far side, node, near side:
//!       ───────── ┼ 1             2     4          from the back to the front
//!           ─── 5 │          back ╲     ╲ back
//!                 │4               3     5
//!                             back ╲
//!                                   4'
//! ```
//!
//! Each node has a face, those that lie in its plane, and what lies in front of it and behind it. A face on both sides is split.
//! Split faces are no new polygons, but the old one with the planes that cut it: see [`cut`](crate::cut). So a picture has
//! no cracks along splits, and light, depth and texture are those of the whole face.
//!
//! - **Takes** triangles, which stay where they are.
//! - **Gives** the triangles and pieces of triangles in order, for any eye.
//! - **Memory** 10 bytes a node, 6 a piece and 4 a cut, two cuts a split; lent by the caller, or in flash: trees are built by constant
//!   functions. None while a tree is walked.
//! - **Cost** one plane a node, that is nine products; and building, once: at each depth of the tree, each face is compared with some
//!   [candidates](Choice).
//!
//! Source: H. Fuchs, Z. M. Kedem, B. F. Naylor, "On visible surface generation by a priori tree structures", SIGGRAPH 1980.

mod arrays;
mod build;
mod plane;
mod polygon;
mod walk;

pub use arrays::TreeArrays;
pub use build::{Arena, BuildError, Choice, List};
pub(crate) use plane::Plane;
pub use polygon::MOST_CUTS;
pub use walk::Ordered;
pub(crate) use walk::{Plan, Walk};

use crate::{
    error::describe,
    space::{Model, Point4},
};

/// No node, no piece, no cut.
pub const NONE: u16 = u16::MAX;

/// Triangles that are borrowed, as a mesh has them.
#[derive(Clone, Copy, Debug)]
pub struct Triangles<'a> {
    positions: &'a [[i16; 3]],
    triangles: &'a [[u16; 3]],
}

impl<'a> Triangles<'a> {
    /// Places of the vertices, in 2.14, and three vertices a triangle, counter-clockwise as seen from the front. A triangle
    /// that names a vertex that does not exist counts as one without area.
    #[must_use]
    pub const fn new(positions: &'a [[i16; 3]], triangles: &'a [[u16; 3]]) -> Self {
        Self { positions, triangles }
    }

    /// How many there are.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.triangles.len()
    }

    /// The vertices of a triangle.
    #[must_use]
    pub const fn vertices(&self, triangle: u16) -> Option<[u16; 3]> {
        if (triangle as usize) < self.triangles.len() { Some(self.triangles[triangle as usize]) } else { None }
    }

    /// The places of its corners.
    #[must_use]
    pub const fn corners(&self, triangle: u16) -> Option<[[i16; 3]; 3]> {
        let Some([a, b, c]) = self.vertices(triangle) else { return None };
        match (self.position(a), self.position(b), self.position(c)) {
            (Some(a), Some(b), Some(c)) => Some([a, b, c]),
            _ => None,
        }
    }

    const fn position(&self, vertex: u16) -> Option<[i16; 3]> {
        if (vertex as usize) < self.positions.len() { Some(self.positions[vertex as usize]) } else { None }
    }

    /// `None` for a triangle without area.
    pub(crate) const fn plane(&self, triangle: u16) -> Option<Plane> {
        match self.corners(triangle) {
            Some(corners) => Plane::new(corners),
            None => None,
        }
    }
}

/// A plane that parts what is left of space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Node {
    /// The triangle that it is the plane of.
    pub face: u16,
    /// The node that this one is a side of; [`NONE`] of the root, which is the first of all.
    pub parent: u16,
    /// The node in front, if there is anything.
    pub front: u16,
    /// The node behind, if there is anything.
    pub back: u16,
    /// The first piece in the plane.
    pub first: u16,
}

impl Node {
    /// Something to fill an array with.
    pub const EMPTY: Self = Self { face: 0, parent: NONE, front: NONE, back: NONE, first: NONE };

    const fn child(&self, is_front: bool) -> u16 {
        if is_front { self.front } else { self.back }
    }
}

/// A triangle, or a part of one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Piece {
    /// Which triangle.
    pub triangle: u16,
    /// The last cut that made the piece.
    pub cut: u16,
    /// The next piece in the same plane.
    pub next: u16,
}

impl Piece {
    /// Something to fill an array with.
    pub const EMPTY: Self = Self { triangle: 0, cut: NONE, next: NONE };
}

/// On one side of a node's plane, and of all that is cut before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Split {
    /// The node, and [`Split::BACK`] on its back.
    pub side: u16,
    /// The cut before this one, which is an earlier one of the list.
    pub before: u16,
}

impl Split {
    /// Something to fill an array with.
    pub const EMPTY: Self = Self { side: 0, before: NONE };

    /// The bit that tells the back.
    pub const BACK: u16 = 0x8000;

    /// The node.
    #[must_use]
    pub const fn node(&self) -> u16 {
        self.side & !Self::BACK
    }

    /// Whether the piece is in front of it.
    #[must_use]
    pub const fn is_front(&self) -> bool {
        self.side & Self::BACK == 0
    }
}

/// A tree over triangles. It borrows, and may be a constant.
#[derive(Clone, Copy, Debug)]
pub struct Tree<'a> {
    triangles: Triangles<'a>,
    nodes: &'a [Node],
    pieces: &'a [Piece],
    cuts: &'a [Split],
}

/// Why arrays do not make a tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum TreeError {
    /// This node has a child that is not behind it in the list, or does not know it; or a face that has no area.
    Node(usize),
    /// This piece is part of no triangle, or is cut by no cut or by more than [`MOST_CUTS`].
    Piece(usize),
    /// This cut is on a side of no node, or after one that is not before it.
    Cut(usize),
    /// All nodes together do not have as many pieces as there are.
    PieceLists,
}

describe! { TreeError,
    Self::Node(at) => "node {at} has a wrong child or face";
    Self::Piece(at) => "piece {at} has no triangle, or wrong cuts";
    Self::Cut(at) => "cut {at} names no node, or no earlier cut";
    Self::PieceLists => "the nodes do not have as many pieces as there are";
}

impl<'a> Tree<'a> {
    /// Borrows and checks three lists: whatever they hold, a walk through the tree ends.
    ///
    /// That the tree is *right*, no face in front of a node that is behind it, is the business of who
    /// [built](Arena::build) it.
    ///
    /// # Errors
    /// [`TreeError`]: the arrays do not fit together.
    pub const fn new(
        triangles: Triangles<'a>,
        nodes: &'a [Node],
        pieces: &'a [Piece],
        cuts: &'a [Split],
    ) -> Result<Self, TreeError> {
        let tree = Self { triangles, nodes, pieces, cuts };
        if let Some(at) = tree.wrong_node() {
            return Err(TreeError::Node(at));
        }
        if let Some(at) = tree.wrong_cut() {
            return Err(TreeError::Cut(at));
        }
        if let Some(at) = tree.wrong_piece() {
            return Err(TreeError::Piece(at));
        }
        if tree.has_as_many_pieces() { Ok(tree) } else { Err(TreeError::PieceLists) }
    }

    /// Where there is a child, it comes later and has this parent: so there is no cycle.
    const fn wrong_node(&self) -> Option<usize> {
        let mut at = 0;
        while at < self.nodes.len() {
            let node = self.nodes[at];
            let are_same = node.front == node.back && node.front != NONE;
            let fits = self.is_child(at, node.front) && self.is_child(at, node.back) && !are_same;
            let has_parent = node.parent == NONE || (node.parent as usize) < at;
            if !fits || !has_parent || self.triangles.plane(node.face).is_none() {
                return Some(at);
            }
            at += 1;
        }
        None
    }

    const fn is_child(&self, at: usize, child: u16) -> bool {
        let index = child as usize;
        child == NONE || (index > at && index < self.nodes.len() && self.nodes[index].parent as usize == at)
    }

    const fn wrong_cut(&self) -> Option<usize> {
        let mut at = 0;
        while at < self.cuts.len() {
            let Split { before, .. } = self.cuts[at];
            let is_after = before == NONE || (before as usize) < at;
            if !is_after || at >= NONE as usize || self.cuts[at].node() as usize >= self.nodes.len() {
                return Some(at);
            }
            at += 1;
        }
        None
    }

    const fn wrong_piece(&self) -> Option<usize> {
        let mut at = 0;
        while at < self.pieces.len() {
            let Piece { triangle, mut cut, .. } = self.pieces[at];
            let mut count = 0;
            while (cut as usize) < self.cuts.len() && count <= MOST_CUTS {
                cut = self.cuts[cut as usize].before;
                count += 1;
            }
            if cut != NONE || count > MOST_CUTS || triangle as usize >= self.triangles.count() {
                return Some(at);
            }
            at += 1;
        }
        None
    }

    const fn has_as_many_pieces(&self) -> bool {
        let (mut at, mut count) = (0, 0);
        while at < self.nodes.len() {
            let mut piece = self.nodes[at].first;
            while piece != NONE {
                if piece as usize >= self.pieces.len() || count >= self.pieces.len() {
                    return false;
                }
                piece = self.pieces[piece as usize].next;
                count += 1;
            }
            at += 1;
        }
        count == self.pieces.len()
    }

    /// The triangles that it is a tree of.
    #[must_use]
    pub const fn triangles(&self) -> Triangles<'a> {
        self.triangles
    }

    /// Its planes; the first is the root.
    #[must_use]
    pub const fn nodes(&self) -> &'a [Node] {
        self.nodes
    }

    /// All pieces.
    #[must_use]
    pub const fn pieces(&self) -> &'a [Piece] {
        self.pieces
    }

    /// What cuts pieces.
    #[must_use]
    pub const fn cuts(&self) -> &'a [Split] {
        self.cuts
    }

    /// All pieces, so that none hides one that comes after it: the painter's order.
    ///
    /// The eye is a homogeneous point; with a `w` of zero it is the direction in which the eye is, for a parallel projection. Of
    /// triangles in one plane, those later in the list come first, as in a depth buffer the earlier ones stay.
    ///
    /// ```
    /// use aquatint::{Point4, Scalar, hidden::bsp::{Arena, Choice, Node, Piece, Split, Triangles}};
    ///
    /// // Two triangles across z, at 0 and at 1.
    /// let positions = [[0, 0, 0], [9, 0, 0], [0, 9, 0], [0, 0, 16384], [9, 0, 16384], [0, 9, 16384]];
    /// let triangles = Triangles::new(&positions, &[[0, 1, 2], [3, 4, 5]]);
    /// let (mut nodes, mut pieces, mut cuts) = ([Node::EMPTY; 2], [Piece::EMPTY; 2], [Split::EMPTY; 0]);
    /// let tree = Arena::new(&mut nodes, &mut pieces, &mut cuts).build(triangles, Choice::best_of(5))?;
    ///
    /// let at = |z| Point4::new(Scalar::ZERO, Scalar::ZERO, Scalar::from_num(z), Scalar::ONE);
    /// assert!(tree.back_to_front(at(3)).map(|piece| piece.triangle).eq([0, 1]));
    /// assert!(tree.back_to_front(at(-3)).map(|piece| piece.triangle).eq([1, 0]));
    /// # Ok::<(), aquatint::hidden::bsp::BuildError>(())
    /// ```
    #[must_use]
    pub const fn back_to_front(&self, eye: Point4<Model>) -> Ordered<'a> {
        Ordered::new(*self, eye, false)
    }

    /// All pieces, so that none is hidden by one that comes after it.
    #[must_use]
    pub const fn front_to_back(&self, eye: Point4<Model>) -> Ordered<'a> {
        Ordered::new(*self, eye, true)
    }

    /// The cuts of a piece, the last one first: the plane of each, and whether the piece is in front of it.
    pub(crate) fn cuts_of(&self, piece: Piece) -> impl Iterator<Item = (Plane, bool)> + use<'a> {
        let tree = *self;
        let cut = |at: u16| tree.cuts.get(usize::from(at)).copied();
        let chain = core::iter::successors(cut(piece.cut), move |split| cut(split.before));
        chain.filter_map(move |split| {
            let node = tree.nodes.get(usize::from(split.node()))?;
            Some((tree.plane(node)?, split.is_front()))
        })
    }

    /// The pieces in the plane of a node.
    pub(crate) fn pieces_of(&self, node: &Node) -> impl Iterator<Item = &'a Piece> + use<'a> {
        let pieces = self.pieces;
        let piece = move |at: u16| pieces.get(usize::from(at));
        core::iter::successors(piece(node.first), move |found| piece(found.next))
    }

    #[inline]
    pub(crate) const fn plane(&self, node: &Node) -> Option<Plane> {
        self.triangles.plane(node.face)
    }

    pub(crate) const fn walk(&self) -> Walk<'a> {
        Walk::new(self.nodes)
    }
}
