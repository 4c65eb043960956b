//! Depth sort: the painter's algorithm, from the farthest face to the nearest. Lecture 5.7.
//!
//! ```text
//!        far                    P  farthest of all that wait
//!   ──────┼──── Q                  may be drawn before Q, if
//!     P ──┼──                      1, 2  their boxes are apart, or
//!         ┼─────── R               3     P is behind the plane of Q, or
//!        near                      4     Q is in front of the plane of P, or
//!         ▲ eye                    5     their outlines are apart
//! ```
//!
//! If none of it holds, the two change places, and the tests begin anew with Q; a face that has been put forward already
//! is part of a circle of faces that hide each other, or pierces P, and one of them is split by the plane of the other.
//! So all three of the lecture's problems are solved: a large face and a small one, circles, and faces through each other.
//!
//! A piece that is split off is *drawn* as its whole triangle on one side of some [cuts](crate::cut), so a split changes
//! no pixel. Its corners, rounded to 1/1024 pixel on a screen of 128 pixels, only tell the order. All planes are those of the screen, where
//! depths are linear. Faces in one plane are drawn so that the earlier one is seen, as by a depth buffer.
//!
//! What is seen is right to four units of 22 bits of depth and an eighth of a pixel of its slope. Only where a split runs between
//! faces almost in one plane is its place on the screen less certain than that, and a pixel beside it may be in the order of its
//! neighbour with some third face: one pixel in some ten thousand pictures of random scenes.
//!
//! - **Takes** triangles on the screen with the depths of their corners.
//! - **Gives** pieces of them in an order in which each hides what it must.
//! - **Memory** 20 bytes a piece, 12 a corner (a split adds those of both parts, four more than the piece had, and frees none),
//!   and 64 a split, lent by the caller.
//! - **Cost** every piece is compared with all that wait: with `k` pieces `k²/2` comparisons of depths, and the five tests for
//!   those whose depths overlap. The tests begin anew where places change and after a split.
//!
//! M. E. Newell, R. G. Newell, T. L. Sancha, "A solution to the hidden surface problem", Proceedings of the ACM National
//! Conference, 1972.

mod divide;
mod piece;
mod precedence;

use core::ops::Range;

use heapless::vec::VecView;

pub use self::{
    divide::PieceCut,
    piece::{PieceCorner, SortedPiece},
};
use self::{
    divide::{Divider, FacePlane, Line},
    precedence::{may_precede, overlap},
};
use super::{scanline::Full, within::Region};
use crate::{
    list::{insert, last_to_front, remove},
    num::{Subpixel, index_u16},
    sort::heap_sort,
    space::{GUARD_BAND, Point2, Rect},
};

/// The end of a chain of cuts.
const NONE: u16 = u16::MAX;

/// The binary digits of the way from one corner to another, along the width and the height of the screen.
const PLACE_DIGITS: u32 = 19;

/// So many faces have corners that 16 bits can count.
pub(crate) const MOST_FACES: usize = 20_000;

/// Pieces of faces that are put in order, in memory that is lent.
pub(crate) struct DepthSort<'m> {
    pieces: &'m mut VecView<SortedPiece>,
    corners: &'m mut VecView<PieceCorner>,
    cuts: &'m mut VecView<PieceCut>,
    /// So many binary digits of places are finer than a sixteenth of a pixel.
    finer: u32,
    /// Pieces that have been put forward since the last one was settled or split have this mark; if twice, the next.
    mark: u32,
}

impl<'m> DepthSort<'m> {
    /// Nothing to sort yet; the faces are those of a viewport.
    pub(crate) fn new(
        pieces: &'m mut VecView<SortedPiece>,
        corners: &'m mut VecView<PieceCorner>,
        cuts: &'m mut VecView<PieceCut>,
        view: Rect,
    ) -> Self {
        pieces.clear();
        corners.clear();
        cuts.clear();
        // All faces are in its guard band.
        let pixels = u64::from(view.width().max(view.height())).saturating_mul(GUARD_BAND.unsigned_abs());
        let digits = u64::BITS - (pixels << Subpixel::FRAC_NBITS).leading_zeros();
        Self { pieces, corners, cuts, finer: PLACE_DIGITS.saturating_sub(digits), mark: 1 }
    }

    /// For so many faces there is room, before any is split.
    pub(crate) fn room(&self) -> usize {
        self.pieces.capacity().min(self.corners.capacity() / 3).min(MOST_FACES)
    }

    /// Adds the next face, which has an area; depths have 31 bits.
    pub(crate) fn add(&mut self, places: &[Point2; 3], depths: [u32; 3]) -> Result<(), Full> {
        let face = index_u16(self.pieces.len());
        let first = self.corners.len();
        for (place, depth) in places.iter().zip(depths) {
            self.corners.push(PieceCorner::new(*place, depth, self.finer)).map_err(|_| Full)?;
        }
        let piece = SortedPiece::new(face, first..self.corners.len(), NONE, self.corners);
        self.pieces.push(piece).map_err(|_| Full)
    }

    /// Sorts by depth alone, the farthest first; of equals the face that was added last.
    pub(crate) fn sort(&mut self) {
        heap_sort(self.pieces, SortedPiece::is_farther);
    }

    /// Puts the pieces in order, splitting them where that is needed.
    pub(crate) fn order(&mut self) -> Result<(), Full> {
        self.sort();
        let (mut place, mut next) = (0, 1);
        while place < self.pieces.len() {
            next = match self.obstacle(place, next) {
                Some(other) if self.resolve(place, other)? => place + 1,
                Some(other) => other + 1,
                None => {
                    place += 1;
                    self.mark = self.mark.saturating_add(2);
                    place + 1
                }
            };
        }
        Ok(())
    }

    /// The pieces as they are to be drawn.
    pub(crate) fn pieces(&self) -> impl Iterator<Item = (u16, Chain<'_>)> {
        self.pieces.iter().map(|piece| (piece.face(), Chain { cuts: self.cuts, last: piece.last_cut() }))
    }

    /// The first piece, from the next one on, before which the one at a place may not be drawn.
    fn obstacle(&self, place: usize, next: usize) -> Option<usize> {
        let piece = self.pieces.get(place)?;
        let mut others = self.pieces.iter().enumerate().skip(next);
        others.find(|(_, other)| !may_precede(self.corners, piece, other)).map(|(at, _)| at)
    }

    /// Puts the obstacle forward, or splits one of the two. `false` if nothing of that can be done: then they touch
    /// each other, within the rounding of their corners.
    fn resolve(&mut self, place: usize, obstacle: usize) -> Result<bool, Full> {
        let (Some(&p), Some(&q)) = (self.pieces.get(place), self.pieces.get(obstacle)) else { return Ok(false) };
        let [plane_p, plane_q] = [p, q].map(|piece| FacePlane::new(&piece.triangle(self.corners)));
        let is_before = q.sides(self.corners, &plane_p).is_behind() || p.sides(self.corners, &plane_q).is_in_front();
        if is_before && q.mark < self.mark {
            self.put_forward(place, obstacle, self.mark);
            return Ok(true);
        }
        if self.split(place, &plane_q)? || self.split(obstacle, &plane_p)? {
            return Ok(true);
        }
        // Their planes do not tell them apart, so that others are part of the circle. Then their outlines do.
        if !overlap(self.corners, &p, &q) {
            return Ok(false);
        }
        if self.split_by_outline(place, &q)? || self.split_by_outline(obstacle, &p)? {
            return Ok(true);
        }
        // One covers the other, so that elsewhere in the circle two only touch each other.
        let is_forced = is_before && q.mark == self.mark;
        if is_forced {
            self.put_forward(place, obstacle, self.mark.saturating_add(1));
        }
        Ok(is_forced)
    }

    /// Moves a piece to an earlier place, and remembers that.
    fn put_forward(&mut self, place: usize, from: usize, mark: u32) {
        let moved = self.pieces.get_mut(place..=from).unwrap_or_default();
        last_to_front(moved);
        if let Some(piece) = moved.first_mut() {
            piece.mark = mark;
        }
    }

    /// Splits a piece, if it is on both sides: a part takes its place by depth each.
    fn split(&mut self, at: usize, by: &impl Divider) -> Result<bool, Full> {
        let Some(&piece) = self.pieces.get(at) else { return Ok(false) };
        if !piece.sides(self.corners, by).are_both() {
            return Ok(false);
        }
        if self.pieces.is_full() || self.cuts.capacity().saturating_sub(self.cuts.len()) < 2 {
            return Err(Full);
        }
        let cut = by.cut(&piece.triangle(self.corners), self.finer);
        remove(self.pieces, at);
        for (cut, is_front) in [(cut, true), (cut.other(), false)] {
            let corners = self.cut_corners(&piece, by, is_front)?;
            let last = index_u16(self.cuts.len());
            self.cuts.push(PieceCut { cut, before: piece.last_cut() }).map_err(|_| Full)?;
            if last == NONE {
                return Err(Full);
            }
            self.insert(at, SortedPiece::new(piece.face(), corners, last, self.corners))?;
        }
        self.mark = self.mark.saturating_add(2);
        Ok(true)
    }

    /// Splits a piece by the first edge of another that has it on both sides.
    fn split_by_outline(&mut self, at: usize, other: &SortedPiece) -> Result<bool, Full> {
        for edge in 0..other.corners(self.corners).len() {
            let line = Line::of_edge(other.corners(self.corners), edge);
            if self.split(at, &line)? {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Adds the corners of the part of a piece on one side.
    fn cut_corners(&mut self, piece: &SortedPiece, by: &impl Divider, is_front: bool) -> Result<Range<usize>, Full> {
        let (start, count) = (self.corners.len(), piece.corners(self.corners).len());
        for at in 0..count {
            let corners = piece.corners(self.corners);
            let pair = corners.get(at).zip(corners.get(at.wrapping_add(1)).or(corners.first()));
            let Some((&here, &next)) = pair else { break };
            let (distance, further) = (by.distance(&here), by.distance(&next));
            // By the sign alone, as the cut: where the planes are almost the same, the line may be far from what is near both.
            if if is_front { distance >= 0 } else { distance <= 0 } {
                self.corners.push(here).map_err(|_| Full)?;
            }
            if distance.min(further) < 0 && distance.max(further) > 0 {
                self.corners.push(here.crossing(&next, (distance, further))).map_err(|_| Full)?;
            }
        }
        // Pieces count them with 16 bits.
        if self.corners.len() > usize::from(u16::MAX) { Err(Full) } else { Ok(start..self.corners.len()) }
    }

    /// Inserts a piece by its depth, not before a place.
    fn insert(&mut self, from: usize, piece: SortedPiece) -> Result<(), Full> {
        let waiting = self.pieces.get(from..).unwrap_or_default();
        let before = waiting.iter().take_while(|other| other.is_farther(&piece)).count();
        insert(self.pieces, from.saturating_add(before), piece).map_err(|_| Full)
    }
}

/// The cuts of a piece, from the last to the first.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Chain<'c> {
    cuts: &'c [PieceCut],
    last: u16,
}

impl Region for Chain<'_> {
    #[inline]
    fn keep(&self, row: i32, mut columns: Range<i32>) -> Range<i32> {
        let mut at = self.last;
        while let Some(PieceCut { cut, before }) = self.cuts.get(usize::from(at)) {
            (columns, at) = (cut.keep(row, columns), *before);
        }
        columns
    }
}
