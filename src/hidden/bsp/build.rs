//! How trees are built: in memory that the caller lends, or while compiling.
//!
//! The list of nodes is at the same time the list of what is to do: a new node has the pieces of its part of space, and becomes
//! a plane when its turn comes. So there is no recursion.

use super::{
    MOST_CUTS, NONE, Node, Piece, Plane, Split, Tree, Triangles,
    polygon::{Polygon, Side},
};
use crate::{error::describe, num::index_u16};

/// Which planes a tree takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Choice {
    /// So many triangles are tried for each node. Zero counts as one. Good trees take 5 to 20.
    pub candidates: usize,
    /// What is within so many 2⁻¹⁴ of a plane counts as in it. Surfaces that curve, whose vertices have been rounded, are split much
    /// less with 1 or 2; and may be drawn in the wrong order where they are so close. A solid that is asked for points takes 0.
    pub tolerance: u8,
}

impl Choice {
    /// The best of so many candidates, no tolerance.
    #[must_use]
    pub const fn best_of(candidates: usize) -> Self {
        Self { candidates, tolerance: 0 }
    }

    /// The same with a tolerance.
    #[must_use]
    pub const fn with_tolerance(self, tolerance: u8) -> Self {
        Self { tolerance, ..self }
    }
}

/// A list that was too short.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum List {
    /// Of nodes: one for each triangle, at most, and for each split.
    Nodes,
    /// Of pieces: one for each triangle, and one for each split.
    Pieces,
    /// Of cuts: two for each split.
    Cuts,
}

/// Why there is no tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum BuildError {
    /// A list is full; none can have more than 65,535 elements, that of nodes 32,768.
    Full(List),
    /// A piece of this triangle has [`MOST_CUTS`] and would need one more.
    TooManyCuts {
        /// The triangle, counted from 0.
        triangle: u16,
    },
}

describe! { BuildError,
    Self::Full(List::Nodes) => "there is no room for another node";
    Self::Full(List::Pieces) => "there is no room for another piece";
    Self::Full(List::Cuts) => "there is no room for another cut";
    Self::TooManyCuts { triangle } => "triangle {triangle} is cut too often";
}

/// Memory in which a tree is built. What it holds before does not matter.
///
/// Two to three times as many of each as there are triangles are usually enough for the mesh of a solid; for
/// triangles that cross each other it takes many more. Building has polygons of 900 bytes on the stack, a few at a
/// time.
#[derive(Debug)]
pub struct Arena<'a> {
    nodes: &'a mut [Node],
    pieces: &'a mut [Piece],
    cuts: &'a mut [Split],
    pub(super) node_count: usize,
    pub(super) piece_count: usize,
    pub(super) cut_count: usize,
}

/// Pieces in a row, by their links.
#[derive(Clone, Copy)]
struct Chain {
    first: u16,
    last: u16,
}

/// What a plane does to pieces.
#[derive(Clone, Copy)]
struct Score {
    splits: usize,
    /// By how many one side has more than the other.
    unbalance: usize,
}

/// As many as have numbers.
const fn places(length: usize) -> usize {
    if length < NONE as usize { length } else { NONE as usize }
}

impl<'a> Arena<'a> {
    /// Lends the memory, of which 65,535 of each are used at the most.
    pub const fn new(nodes: &'a mut [Node], pieces: &'a mut [Piece], cuts: &'a mut [Split]) -> Self {
        // So no place is the one that stands for none.
        let (nodes, _) = nodes.split_at_mut(places(nodes.len()));
        let (pieces, _) = pieces.split_at_mut(places(pieces.len()));
        let (cuts, _) = cuts.split_at_mut(places(cuts.len()));
        Self { nodes, pieces, cuts, node_count: 0, piece_count: 0, cut_count: 0 }
    }

    /// A tree of all triangles that have an area.
    ///
    /// Each node takes, of up to so many triangles as chosen, spread evenly through what is left, the one whose plane splits the
    /// fewest, and of those the one that parts the rest most evenly. With one, it is the first triangle that is left.
    ///
    /// # Errors
    /// [`BuildError`]: the memory is too small, or a triangle was cut too often.
    pub const fn build(mut self, triangles: Triangles<'a>, choice: Choice) -> Result<Tree<'a>, BuildError> {
        match self.fill(&triangles, choice) {
            Ok(()) => {}
            Err(error) => return Err(error),
        }
        Ok(Tree {
            triangles,
            nodes: beginning(self.nodes, self.node_count),
            pieces: beginning(self.pieces, self.piece_count),
            cuts: beginning(self.cuts, self.cut_count),
        })
    }

    pub(super) const fn fill(&mut self, triangles: &Triangles<'_>, choice: Choice) -> Result<(), BuildError> {
        let all = match self.load(triangles) {
            Ok(all) => all,
            Err(error) => return Err(error),
        };
        match self.add_node(NONE, all) {
            Ok(_) => {}
            Err(error) => return Err(error),
        }
        let mut at = 0;
        while at < self.node_count {
            match self.part(triangles, at, choice) {
                Ok(()) => at += 1,
                Err(error) => return Err(error),
            }
        }
        Ok(())
    }

    /// All triangles with an area, the last one first.
    const fn load(&mut self, triangles: &Triangles<'_>) -> Result<Chain, BuildError> {
        if triangles.count() > NONE as usize {
            return Err(BuildError::Full(List::Pieces));
        }
        let (mut all, mut left) = (Chain::EMPTY, triangles.count());
        while left > 0 {
            left -= 1;
            let triangle = index_u16(left);
            if triangles.plane(triangle).is_some() {
                match self.add_piece(Piece { triangle, ..Piece::EMPTY }) {
                    Ok(piece) => self.append(&mut all, piece),
                    Err(error) => return Err(error),
                }
            }
        }
        Ok(all)
    }

    /// Makes a plane of a node that has pieces, and nodes of what is on both sides.
    const fn part(&mut self, triangles: &Triangles<'_>, at: usize, choice: Choice) -> Result<(), BuildError> {
        let face = self.choose(triangles, self.node(at).first, choice);
        let Some(plane) = triangles.plane(face) else { return Ok(()) };
        let [mut front, mut back, mut within] = [Chain::EMPTY; 3];
        let mut next = self.node(at).first;
        while next != NONE {
            let piece = next;
            next = self.piece(piece).next;
            match self.side(triangles, piece, (face, &plane, choice)) {
                Side::Front => self.append(&mut front, piece),
                Side::Back => self.append(&mut back, piece),
                Side::Within => self.append(&mut within, piece),
                Side::Both => match self.split(piece, index_u16(at)) {
                    Ok(behind) => {
                        self.append(&mut front, piece);
                        self.append(&mut back, behind);
                    }
                    Err(error) => return Err(error),
                },
            }
        }
        let mut node = Node { face, first: within.first, ..self.node(at) };
        match (self.add_node(index_u16(at), front), self.add_node(index_u16(at), back)) {
            (Ok(front), Ok(back)) => (node.front, node.back) = (front, back),
            (Err(error), _) | (_, Err(error)) => return Err(error),
        }
        if at < self.nodes.len() {
            self.nodes[at] = node;
        }
        Ok(())
    }

    /// The triangle whose plane is best.
    const fn choose(&self, triangles: &Triangles<'_>, first: u16, choice: Choice) -> u16 {
        let count = self.count(first);
        let candidates = if choice.candidates == 0 { 1 } else { choice.candidates };
        let stride = count.div_ceil(candidates);
        let (mut best, mut best_score) = (0, Score::WORST);
        let (mut piece, mut left) = (first, count);
        while piece != NONE {
            left = left.wrapping_sub(1);
            let Piece { triangle, next, .. } = self.piece(piece);
            if stride > 0 && left.is_multiple_of(stride) {
                let score =
                    if count <= stride { Score::NONE } else { self.score(triangles, first, (triangle, choice)) };
                // The last of equals is the first triangle.
                if !best_score.is_better(&score) {
                    (best, best_score) = (triangle, score);
                }
            }
            piece = next;
        }
        best
    }

    const fn score(&self, triangles: &Triangles<'_>, first: u16, (face, choice): (u16, Choice)) -> Score {
        let Some(plane) = triangles.plane(face) else { return Score::WORST };
        let (mut splits, mut front, mut back) = (0, 0_usize, 0_usize);
        let mut piece = first;
        while piece != NONE {
            match self.side(triangles, piece, (face, &plane, choice)) {
                Side::Front => front += 1,
                Side::Back => back += 1,
                Side::Both => splits += 1,
                Side::Within => {}
            }
            piece = self.piece(piece).next;
        }
        Score { splits, unbalance: front.abs_diff(back) }
    }

    /// On which side of the plane of a face a piece lies.
    const fn side(&self, triangles: &Triangles<'_>, piece: u16, (face, plane, choice): (u16, &Plane, Choice)) -> Side {
        let Piece { triangle, cut, .. } = self.piece(piece);
        if triangle == face {
            return Side::Within;
        }
        let Some(corners) = triangles.corners(triangle) else { return Side::Within };
        let (chain, mut count) = self.chain(cut);
        let mut polygon = Polygon::new(corners);
        // In the order in which it was cut.
        while count > 0 {
            count -= 1;
            let split = if count < MOST_CUTS { chain[count] } else { Split::EMPTY };
            if let Some(plane) = triangles.plane(self.node(split.node() as usize).face) {
                polygon = polygon.cut(&plane, split.is_front());
            }
        }
        polygon.side(plane, choice.tolerance)
    }

    /// The cuts of a piece, the last one first, and how many there are.
    const fn chain(&self, mut cut: u16) -> ([Split; MOST_CUTS], usize) {
        let (mut chain, mut count) = ([Split::EMPTY; MOST_CUTS], 0);
        while (cut as usize) < self.cuts.len() && count < MOST_CUTS {
            chain[count] = self.cuts[cut as usize];
            cut = chain[count].before;
            count += 1;
        }
        (chain, count)
    }

    /// Leaves of a piece what is in front of a node; what is behind is another piece.
    const fn split(&mut self, piece: u16, node: u16) -> Result<u16, BuildError> {
        let whole = self.piece(piece);
        let (_, count) = self.chain(whole.cut);
        if count == MOST_CUTS {
            return Err(BuildError::TooManyCuts { triangle: whole.triangle });
        }
        let front = Split { side: node, before: whole.cut };
        let back = Split { side: node | Split::BACK, before: whole.cut };
        match (self.add_cut(front), self.add_cut(back)) {
            (Ok(front), Ok(back)) => {
                if (piece as usize) < self.pieces.len() {
                    self.pieces[piece as usize].cut = front;
                }
                self.add_piece(Piece { cut: back, ..whole })
            }
            (Err(error), _) | (_, Err(error)) => Err(error),
        }
    }

    /// A node for pieces, if there are any.
    const fn add_node(&mut self, parent: u16, pieces: Chain) -> Result<u16, BuildError> {
        if pieces.first == NONE {
            return Ok(NONE);
        }
        let at = self.node_count;
        if at >= self.nodes.len() || at >= Split::BACK as usize {
            return Err(BuildError::Full(List::Nodes));
        }
        self.nodes[at] = Node { parent, first: pieces.first, ..Node::EMPTY };
        self.node_count += 1;
        Ok(index_u16(at))
    }

    const fn add_piece(&mut self, piece: Piece) -> Result<u16, BuildError> {
        let at = self.piece_count;
        if at >= self.pieces.len() || at >= NONE as usize {
            return Err(BuildError::Full(List::Pieces));
        }
        self.pieces[at] = piece;
        self.piece_count += 1;
        Ok(index_u16(at))
    }

    const fn add_cut(&mut self, cut: Split) -> Result<u16, BuildError> {
        let at = self.cut_count;
        if at >= self.cuts.len() || at >= NONE as usize {
            return Err(BuildError::Full(List::Cuts));
        }
        self.cuts[at] = cut;
        self.cut_count += 1;
        Ok(index_u16(at))
    }

    const fn append(&mut self, chain: &mut Chain, piece: u16) {
        if (piece as usize) < self.pieces.len() {
            self.pieces[piece as usize].next = NONE;
        }
        if (chain.last as usize) < self.pieces.len() {
            self.pieces[chain.last as usize].next = piece;
        } else {
            chain.first = piece;
        }
        chain.last = piece;
    }

    /// How many pieces are linked.
    const fn count(&self, mut piece: u16) -> usize {
        let mut count = 0;
        while piece != NONE {
            piece = self.piece(piece).next;
            count += 1;
        }
        count
    }

    const fn node(&self, at: usize) -> Node {
        if at < self.nodes.len() { self.nodes[at] } else { Node::EMPTY }
    }

    const fn piece(&self, at: u16) -> Piece {
        if (at as usize) < self.pieces.len() { self.pieces[at as usize] } else { Piece::EMPTY }
    }
}

impl Chain {
    const EMPTY: Self = Self { first: NONE, last: NONE };
}

impl Score {
    const NONE: Self = Self { splits: 0, unbalance: 0 };
    const WORST: Self = Self { splits: usize::MAX, unbalance: usize::MAX };

    const fn is_better(&self, other: &Self) -> bool {
        self.splits < other.splits || (self.splits == other.splits && self.unbalance < other.unbalance)
    }
}

/// The elements that are in use.
pub(super) const fn beginning<T>(list: &[T], count: usize) -> &[T] {
    match list.split_at_checked(count) {
        Some((used, _)) => used,
        None => list,
    }
}
