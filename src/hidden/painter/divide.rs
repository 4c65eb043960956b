//! What pieces are split by: the planes of faces, and lines on the screen.

use super::piece::PieceCorner;
use crate::{cut::Cut, num::SUBPIXELS};

/// A cut of a piece, and the one before it: 32 bytes.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PieceCut {
    pub(super) cut: Cut,
    pub(super) before: u16,
}

/// On which sides of a plane or line something is; on neither, if it is within the rounding of it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Sides {
    pub(super) front: bool,
    pub(super) behind: bool,
}

impl Sides {
    /// No corner is in front.
    pub(super) const fn is_behind(self) -> bool {
        !self.front
    }

    /// No corner is behind.
    pub(super) const fn is_in_front(self) -> bool {
        !self.behind
    }

    pub(super) const fn are_both(self) -> bool {
        self.front && self.behind
    }

    /// All corners are on the plane.
    pub(super) const fn is_within(self) -> bool {
        !self.front && !self.behind
    }
}

/// Has two sides.
pub(super) trait Divider {
    /// How far in front a corner is, in any unit; behind it is negative.
    fn distance(&self, corner: &PieceCorner) -> i64;

    /// So far from it corners count as on it; those of whole faces have only their depth rounded.
    fn rounding(&self, is_whole: bool) -> i64;

    /// The pixels of a triangle in front; places have so many binary digits more than sixteenths.
    fn cut(&self, triangle: &[PieceCorner; 3], finer: u32) -> Cut {
        // Those of whole faces are sixteenths, and small numbers make exact lines.
        let place = |v: i32| i64::from(v >> finer);
        let places = triangle.each_ref().map(|corner| [place(corner.x), place(corner.y), SUBPIXELS.into()]);
        Cut::of_values(&places, triangle.each_ref().map(|corner| self.distance(corner)))
    }
}

/// The plane of a face; the eye is in front of it.
pub(super) struct FacePlane {
    place: PieceCorner,
    normal: [i64; 3],
}

impl FacePlane {
    /// Of a triangle that has an area.
    ///
    /// Ways along x and y are at most 2¹⁹, along z 2²²: then the normal has 42 and 42 bits, and 39 along z, and a distance is at
    /// most 3 · 2⁶¹.
    pub(super) fn new([a, b, c]: &[PieceCorner; 3]) -> Self {
        let ([x, y, z], [u, v, w]) = (b.from(a), c.from(a));
        let [across, down, nearer] = [y * w - z * v, z * u - x * w, x * v - y * u];
        let sign = if nearer < 0 { -1 } else { 1 };
        Self { place: *a, normal: [sign * across, sign * down, sign * nearer] }
    }
}

impl Divider for FacePlane {
    fn distance(&self, corner: &PieceCorner) -> i64 {
        let ([x, y, z], [u, v, w]) = (corner.from(&self.place), self.normal);
        x * u + y * v + z * w
    }

    fn rounding(&self, is_whole: bool) -> i64 {
        let [across, down, nearer] = self.normal.map(i64::abs);
        if is_whole { nearer } else { across + down + nearer }
    }
}

/// A line on the screen.
pub(super) struct Line {
    from: PieceCorner,
    to: PieceCorner,
}

impl Line {
    /// Through an edge of an outline; of an empty one, through nothing.
    pub(super) fn of_edge(outline: &[PieceCorner], edge: usize) -> Self {
        let corner =
            |at: usize| outline.get(at).or(outline.first()).copied().unwrap_or(PieceCorner { x: 0, y: 0, z: 0 });
        Self { from: corner(edge), to: corner(edge.saturating_add(1)) }
    }
}

impl Divider for Line {
    fn distance(&self, corner: &PieceCorner) -> i64 {
        let ([dx, dy, _], [x, y, _]) = (self.to.from(&self.from), corner.from(&self.from));
        dx * y - dy * x
    }

    fn rounding(&self, is_whole: bool) -> i64 {
        let [dx, dy, _] = self.to.from(&self.from).map(i64::abs);
        if is_whole { 0 } else { dx + dy }
    }
}
