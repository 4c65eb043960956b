//! Pieces of faces, and their corners in space on the screen.

use core::ops::Range;

use super::{
    NONE,
    divide::{Divider, Sides},
};
use crate::{
    num::{divide_round, index_u16, low_i32},
    space::Point2,
};

/// A corner of a piece on the screen: 12 bytes.
///
/// Places are in sixteenths of a pixel, or finer where the viewport is smaller than 4096 pixels: they are at most 2¹⁹ from each
/// other. Depths have 22 bits, greater is nearer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PieceCorner {
    pub(super) x: i32,
    pub(super) y: i32,
    pub(super) z: i32,
}

impl PieceCorner {
    /// A depth has 31 bits, a place so many more than sixteenths.
    pub(super) const fn new(place: Point2, depth: u32, finer: u32) -> Self {
        let z = (depth.saturating_add(1 << 8) >> 9).cast_signed();
        Self { x: place.x.to_bits() << finer, y: place.y.to_bits() << finer, z }
    }

    /// From another corner to this.
    pub(super) fn from(&self, other: &Self) -> [i64; 3] {
        [(self.x, other.x), (self.y, other.y), (self.z, other.z)].map(|(to, from)| i64::from(to) - i64::from(from))
    }

    /// Where the way to another corner crosses what they are at these distances from, on different sides. Rounded to the
    /// nearest, and the same for the way back.
    pub(super) fn crossing(&self, other: &Self, (own, others): (i64, i64)) -> Self {
        if own < others {
            return other.crossing(self, (others, own));
        }
        // Of 31 bits each, so that the product with a way has 55.
        let too_long =
            33_u32.saturating_sub(own.unsigned_abs().leading_zeros().min(others.unsigned_abs().leading_zeros()));
        let (own, others) = (own >> too_long, others >> too_long);
        let [x, y, z] = other.from(self).map(|way| low_i32(divide_round(way * own, own - others)));
        Self { x: self.x.wrapping_add(x), y: self.y.wrapping_add(y), z: self.z.wrapping_add(z) }
    }
}

/// A face, or a piece of one, that waits for its turn: 20 bytes.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SortedPiece {
    face: u16,
    first_corner: u16,
    corners: u16,
    last_cut: u16,
    pub(super) mark: u32,
    far: i32,
    near: i32,
}

impl SortedPiece {
    pub(super) fn new(face: u16, range: Range<usize>, last_cut: u16, corners: &[PieceCorner]) -> Self {
        let own = corners.get(range.clone()).unwrap_or_default();
        let far = own.iter().map(|corner| corner.z).min().unwrap_or(0);
        let near = own.iter().map(|corner| corner.z).max().unwrap_or(0);
        let (first_corner, corners) = (index_u16(range.start), index_u16(range.len()));
        Self { face, first_corner, corners, last_cut, mark: 0, far, near }
    }

    /// The number of its face.
    pub(super) const fn face(&self) -> u16 {
        self.face
    }

    /// The last of the cuts that have made it.
    pub(super) const fn last_cut(&self) -> u16 {
        self.last_cut
    }

    /// Whether it has never been split: then its corners are exact.
    pub(super) const fn is_whole(&self) -> bool {
        self.last_cut == NONE
    }

    /// Whether all of it is farther than all of another.
    pub(super) const fn is_wholly_farther(&self, other: &Self) -> bool {
        self.near < other.far
    }

    /// By the farthest depth, and of equals the later face.
    pub(super) const fn is_farther(&self, other: &Self) -> bool {
        self.far < other.far || self.far == other.far && self.face > other.face
    }

    /// Its own corners.
    pub(super) fn corners<'c>(&self, corners: &'c [PieceCorner]) -> &'c [PieceCorner] {
        let first = usize::from(self.first_corner);
        corners.get(first..first.saturating_add(self.corners.into())).unwrap_or_default()
    }

    /// The corners of the whole face: those that were added first.
    pub(super) fn triangle(&self, corners: &[PieceCorner]) -> [PieceCorner; 3] {
        let first = usize::from(self.face) * 3;
        let corner = |at| corners.get(first + at).copied().unwrap_or(PieceCorner { x: 0, y: 0, z: 0 });
        [corner(0), corner(1), corner(2)]
    }

    /// On which sides of something its corners are.
    pub(super) fn sides(&self, corners: &[PieceCorner], of: &impl Divider) -> Sides {
        let near = of.rounding(self.is_whole());
        let mut sides = Sides::default();
        for corner in self.corners(corners) {
            let distance = of.distance(corner);
            sides.front |= distance > near;
            sides.behind |= distance < -near;
        }
        sides
    }
}
