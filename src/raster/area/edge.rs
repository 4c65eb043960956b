//! An edge of an antialiased shape: where it crosses the borders of rows, to 2⁻³² pixels.
//!
//! ```text
//!   ───────●╲─────────── upper border of the row: `x`
//!           ╲  t/256 of the row further down: x + step·t/256
//!   ─────────╲────────── lower border: x + step, the next row's `x`
//! ```
//!
//! A step is rounded once, by less than 2⁻³² pixels a row, and rows are entered by a multiplication, so an edge
//! is where it is whichever row the walk begins in: bands and tiles agree to the bit. After 1000 rows it is off by
//! less than 2⁻²² pixels, after four million by 2⁻¹⁰.

use core::ops::Range;

use crate::{
    num::{divide_floor, divide_floor_i32, low_i16, low_i32, low_u8},
    outline::Directed,
    raster::{active::RowEdge, area::cells::Side},
    space::Point2,
    stretch::Run,
    style::Rule,
};

/// Parts of a pixel on the axes of [`Outline::trace_fine`](crate::Outline::trace_fine).
pub(super) const PARTS: i32 = 256;

/// One edge of an outline, or a curve of which one piece at a time is an edge, in the list that
/// [`fill`](super::fill) works with.
#[derive(Clone, Copy, Debug)]
pub struct AreaEdge<C = Pieces> {
    /// Where it crosses the upper border of the present row, prolonged if it begins below: 32 fraction bits, modulo
    /// 2⁶⁴ outside of its rows.
    x: i64,
    /// To the right on the way down a row.
    step: i64,
    /// Where it crosses the borders of a band, with 16 fraction bits.
    pub(super) from: i64,
    pub(super) to: i64,
    /// Where it begins and ends, in 256ths of a pixel.
    top: i32,
    bottom: i32,
    winding: i16,
    /// Between which parts of the row it is, once it was added as a whole; the last one is inside.
    parts: [u8; 2],
    /// The cells that it has changed in the row: the first, and the first behind.
    touched: (i16, i16),
    pieces: Option<C>,
}

/// What an edge knows of the curve that it is a piece of.
pub trait Curved: Copy + 'static {
    /// Whether there are no curves.
    const ARE_NONE: bool = false;

    /// To be kept, if curves are.
    fn new(pieces: Pieces) -> Option<Self>;

    /// What is kept.
    fn get(&self) -> &Pieces;

    /// The same.
    fn get_mut(&mut self) -> &mut Pieces;
}

impl Curved for Pieces {
    #[inline]
    fn new(pieces: Pieces) -> Option<Self> {
        Some(pieces)
    }

    #[inline]
    fn get(&self) -> &Pieces {
        self
    }

    #[inline]
    fn get_mut(&mut self) -> &mut Pieces {
        self
    }
}

/// No curve: for outlines of straight edges, which are half as large then.
#[derive(Clone, Copy, Debug)]
pub enum Straight {}

impl Curved for Straight {
    const ARE_NONE: bool = true;

    #[inline]
    fn new(_pieces: Pieces) -> Option<Self> {
        None
    }

    #[inline]
    fn get(&self) -> &Pieces {
        match *self {}
    }

    #[inline]
    fn get_mut(&mut self) -> &mut Pieces {
        match *self {}
    }
}

/// The curve that an edge is a piece of.
#[derive(Clone, Copy, Debug)]
pub struct Pieces {
    run: Run,
    /// Where the last piece ends, in 256ths of a pixel, and where this one does.
    bottom: i32,
    lower: Point2,
    /// Which piece the edge is, and which one it was at the beginning of the row.
    at: u32,
    at_row: u32,
}

/// Where an edge is that does not cross the band: right of all others.
const ELSEWHERE: i64 = i64::MAX >> 2;

impl<C: Curved> AreaEdge<C> {
    /// An edge, standing on a row that it reaches into.
    pub(super) fn new(edge: Directed, row: i32) -> Self {
        let (x, step) = line(edge, row);
        let (top, bottom) = (edge.upper.y.to_bits(), edge.lower.y.to_bits());
        let (winding, parts, touched) = (low_i16(edge.winding), [0; 2], UNTOUCHED);
        Self { x, step, from: 0, to: 0, top, bottom, winding, parts, touched, pieces: None }
    }

    /// The first piece of a curve that reaches into a row, standing on that row.
    pub(super) fn of_run(run: Run, row: i32) -> Self {
        let at = run.piece_below(row << 8);
        let (edge, bottom) = (run.piece(at), run.vertex(run.len()).y.to_bits());
        let pieces = C::new(Pieces { run, bottom, lower: edge.lower, at, at_row: at });
        Self { pieces, ..Self::new(edge, row) }
    }

    /// Becomes a piece of its curve.
    fn become_piece(&mut self, edge: Directed, row: i32) {
        (self.x, self.step) = line(edge, row);
        (self.top, self.bottom) = (edge.upper.y.to_bits(), edge.lower.y.to_bits());
    }

    /// Goes on to the next piece of its curve where this one ends at or above a part of the row. Whether there is one.
    pub(super) fn go_on(&mut self, row: i32, part: i32) -> bool {
        let Some(pieces) = self.pieces.as_mut().map(C::get_mut) else { return false };
        if self.bottom > (row << 8) + part || self.bottom >= pieces.bottom {
            return false;
        }
        // There is a piece below that is not level.
        let mut upper = pieces.lower;
        while pieces.lower.y.to_bits() <= self.bottom && pieces.at < pieces.run.len() {
            upper = pieces.lower;
            pieces.at += 1;
            pieces.lower = pieces.run.vertex(pieces.at + 1);
        }
        let edge = Directed { upper, lower: pieces.lower, winding: self.winding.into() };
        self.become_piece(edge, row);
        true
    }

    /// Remembers its piece at the beginning of a row.
    #[inline]
    pub(super) fn begin_row(&mut self) {
        if let Some(pieces) = self.pieces.as_mut().map(C::get_mut) {
            pieces.at_row = pieces.at;
        }
    }

    /// Goes back to the piece that it was at the beginning of the row, and has changed no cells yet.
    pub(super) fn begin_part(&mut self, row: i32) {
        self.touched = UNTOUCHED;
        if let Some(pieces) = self.pieces.as_mut().map(C::get_mut) {
            if pieces.at != pieces.at_row {
                pieces.at = pieces.at_row;
                let edge = pieces.run.piece(pieces.at);
                pieces.lower = edge.lower;
                self.become_piece(edge, row);
            }
        }
    }

    /// Remembers cells that it has changed.
    #[inline]
    pub(super) fn touch(&mut self, (first, end): (i32, i32)) {
        self.touched = (self.touched.0.min(low_i16(first)), self.touched.1.max(low_i16(end)));
    }

    /// The cells that it has changed in the row: the first, and the first behind.
    #[inline]
    pub(super) fn touched(&self) -> (i32, i32) {
        (self.touched.0.into(), self.touched.1.into())
    }

    /// Remembers where it is once it was added as a whole: between which places, and between which parts of the row.
    #[inline]
    pub(super) fn is_between(&mut self, (from, to): (i64, i64), (begin, end): (i32, i32)) {
        (self.from, self.to) = (from, to);
        self.parts = [begin, end - 1].map(|part| low_u8(part.cast_unsigned()));
    }

    /// Between which parts of the row it is, once it was added as a whole.
    #[inline]
    pub(super) fn parts(&self) -> Range<i32> {
        let [begin, last] = self.parts.map(i32::from);
        begin..last + 1
    }

    pub(super) const fn winding(&self) -> i32 {
        self.winding as i32
    }

    /// Passes the edge on the way to the right; says of which side of the inside it is the border, if it is.
    #[inline]
    pub(super) const fn side(&self, winding: &mut i32, rule: Rule) -> Option<Side> {
        Side::passed(winding, self.winding(), rule)
    }

    /// Steps to the next row.
    #[inline]
    pub(super) const fn advance(&mut self) {
        self.x = self.x.wrapping_add(self.step);
    }

    /// The rows that it goes through from border to border. Where a curve goes on at the lower one, that is another row.
    #[inline]
    pub(super) fn whole_rows(&self) -> Range<i32> {
        let end = self.bottom - i32::from(self.pieces.is_some());
        end_row(self.top)..end >> 8
    }

    /// The first of its ends that lies between parts of a row, exclusively; else `until`.
    pub(super) fn next_end(&self, row: i32, (after, until): (i32, i32)) -> i32 {
        let inside = |y: i32| (y - (row << 8) > after).then_some(y - (row << 8));
        [self.top, self.bottom].into_iter().filter_map(inside).fold(until, i32::min)
    }

    /// Between which parts of a row it is, or its present piece.
    #[inline]
    pub(super) fn ends_in(&self, row: i32) -> (i32, i32) {
        ((self.top - (row << 8)).max(0), (self.bottom - (row << 8)).min(PARTS))
    }

    /// Gives it, or all pieces of its curve that end above the lower border of a row and the one that crosses it: where they
    /// are at the upper and the lower one of two parts of the row.
    #[inline]
    pub(super) fn each_piece(&mut self, row: i32, mut give: impl FnMut((i64, i64), (i32, i32))) {
        loop {
            let parts = self.ends_in(row);
            give((self.at(parts.0), self.at(parts.1)), parts);
            if !self.go_on(row, PARTS - 1) {
                return;
            }
        }
    }

    /// Places it between two parts of a row, which its ends are not between.
    #[inline]
    pub(super) fn place(&mut self, row: i32, (top, bottom): (i32, i32)) {
        if self.top <= (row << 8) + top && self.bottom >= (row << 8) + bottom {
            (self.from, self.to) = (self.at(top), self.at(bottom));
        } else {
            (self.from, self.to) = (ELSEWHERE, ELSEWHERE);
        }
    }

    /// Places it in a row that it crosses from border to border, from left to right, and steps to the next.
    #[inline]
    pub(super) fn place_whole(&mut self) -> (i64, i64) {
        let above = self.x >> 16;
        self.advance();
        let below = self.x >> 16;
        (self.from, self.to) = (above.min(below), above.max(below));
        (self.from, self.to)
    }

    /// Steps back to the row above.
    pub(super) const fn retreat(&mut self) {
        self.x = self.x.wrapping_sub(self.step);
    }

    /// Whether it crosses the band that it was placed in.
    #[inline]
    pub(super) const fn is_here(&self) -> bool {
        self.from < ELSEWHERE
    }

    /// Whether it crosses the middle of a strip of the row.
    pub(super) fn crosses(&self, row: i32, part: i32) -> bool {
        (self.top..self.bottom).contains(&((row << 8) + part))
    }

    /// Where it is `part` 256ths below the upper border of the row, with 16 fraction bits.
    #[inline]
    pub(super) const fn at(&self, part_of_row: i32) -> i64 {
        // Where a product of 64 bits is a call, one is less than two.
        let low = ((low_i32(self.step) & 0xFF) * part_of_row) >> 8;
        let right = (self.step >> 8).wrapping_mul(part_of_row as i64).wrapping_add(low as i64);
        self.x.wrapping_add(right) >> 16
    }
}

impl<C: Curved> RowEdge for AreaEdge<C> {
    #[inline]
    fn first_row(&self) -> i32 {
        self.top >> 8
    }

    #[inline]
    fn end_row(&self) -> i32 {
        end_row(self.pieces.as_ref().map_or(self.bottom, |pieces| pieces.get().bottom))
    }
}

/// The rows that a stretch reaches into.
#[inline]
pub(super) const fn rows_between(upper: Point2, lower: Point2) -> Range<i32> {
    upper.y.to_bits() >> 8..end_row(lower.y.to_bits())
}

/// No cell.
const UNTOUCHED: (i16, i16) = (i16::MAX, i16::MIN);

/// Where an edge crosses the upper border of a row, and how much farther right a row below.
fn line(Directed { upper, lower, .. }: Directed, row: i32) -> (i64, i64) {
    let (top, bottom) = (upper.y.to_bits(), lower.y.to_bits());
    // Both are less than 2³⁰.
    let step = slope(lower.x.to_bits() - upper.x.to_bits(), bottom - top);
    let down = i64::from(row) * i64::from(PARTS) - i64::from(top);
    ((i64::from(upper.x.to_bits()) << 24).wrapping_add(part(step, down)), step)
}

/// The first row that lies wholly below `y` 256ths of a pixel.
#[inline]
pub(super) const fn end_row(y: i32) -> i32 {
    (y + PARTS - 1) >> 8
}

/// `step · parts / 256`, rounded down, modulo 2⁶⁴.
#[inline]
const fn part(step: i64, parts: i64) -> i64 {
    (step >> 8).wrapping_mul(parts).wrapping_add(((step & 0xFF) * parts) >> 8)
}

/// `dx / dy` with 32 fraction bits, rounded down; `dy` is positive.
fn slope(dx: i32, dy: i32) -> i64 {
    if dx.unsigned_abs() | dy.unsigned_abs() >= 1 << 15 {
        return divide_floor(i64::from(dx) << 32, dy.into()).0;
    }
    // Two divisions of 32 bits take half of the time of one of 64.
    let (high, rest) = divide_floor_i32(dx << 16, dy);
    let (low, _) = divide_floor_i32(rest << 16, dy);
    i64::from(high) << 16 | i64::from(low)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn coordinate() -> impl Strategy<Value = i32> {
        let end = (1 << 30) - 1;
        prop_oneof![-900..900_i32, -50_000..50_000_i32, -end..=end, Just(end), Just(-end)]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(10_000))]
        #[test]
        fn a_row_may_be_entered_anywhere_and_crossings_are_right(
            x0 in coordinate(), y0 in coordinate(), x1 in coordinate(), y1 in coordinate(), enter in 0..i32::MAX, part in 0..=256_i32,
        ) {
            let y1 = if y0 == y1 { y0 - 1 } else { y1 };
            let ((x0, y0), (x1, y1)) = if y0 < y1 { ((x0, y0), (x1, y1)) } else { ((x1, y1), (x0, y0)) };
            let edge = Directed { upper: Point2::from_sixteenths(x0, y0), lower: Point2::from_sixteenths(x1, y1), winding: 1 };
            let first = y0 >> 8;
            let row = first + enter % (end_row(y1) - first);
            let entered = AreaEdge::<Pieces>::new(edge, row);
            let mut walked = AreaEdge::<Pieces>::new(edge, row.saturating_sub(20).max(first));
            for _ in row.saturating_sub(20).max(first)..row {
                walked.advance();
            }
            prop_assert_eq!(entered.x, walked.x);
            // Between its ends it is right to 2⁻¹⁶ pixels, and 2⁻³² more a row.
            let part = ((row << 8) + part).clamp(y0, y1) - (row << 8);
            let y = (row << 8) + part;
            let [dx, dy, down] = [x1.abs_diff(x0), y1.abs_diff(y0), y.abs_diff(y0)].map(i128::from);
            let dx = if x1 < x0 { -dx } else { dx };
            let exact = (i128::from(x0) << 8) + ((dx * down) << 8).div_euclid(dy);
            let error = i128::from(entered.at(part)) - exact;
            prop_assert!((-(down >> 24) - 2..=1).contains(&error), "{error}");
        }
    }

    #[test]
    fn slopes_are_rounded_down_in_both_ways() {
        for (dx, dy) in [(1, 3), (-1, 3), (32_767, 1), (-32_767, 32_767), (-32_767, 32_766), (0, 5), (12_345, 6_789)] {
            assert_eq!(slope(dx, dy), (i64::from(dx) << 32).div_euclid(dy.into()), "{dx}/{dy}");
        }
    }
}
