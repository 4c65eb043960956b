//! A row of pixels that is summed up: each edge adds the area right of it, in differences from pixel to pixel.
//!
//! ```text
//!        ╱│           the edge crosses two pixels in h of the row's height:
//!      ╱  │             cell 0   the area right of it, a
//!   ──────┴──────       cell 1   what is missing of h, h − a
//!    a      h           afterwards the sums from the left are a, h, h, h …
//! ```
//!
//! An edge at the left of the inside adds, one at its right takes away. Heights and areas count 32768ths of a
//! pixel; the cells of one edge always sum to its height exactly, and an edge that is added and taken away leaves
//! nothing, so that shapes that share an edge cover its pixels once.
//!
//! Accumulating signed areas is the method of R. Levien's *font-rs* and of `FreeType`'s smooth rasteriser; here only
//! borders of the inside are added, so that the winding rule holds.

use crate::{
    coverage::{Coverage, Covered},
    num::{bits, count_i32, index, low_i32, low_u16},
    span::Sink,
    style::Rule,
};

/// The height of a row.
const HEIGHT: u32 = 1 << 15;

/// A part of a row, from a column on.
pub(super) struct Cells<'m> {
    /// Differences from pixel to pixel, modulo 2¹⁶; all zero between rows.
    cells: &'m mut [Coverage],
    left: i32,
}

/// Which side of the inside an edge is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    Left,
    Right,
}

impl Side {
    /// Passes an edge on the way to the right, which changes the winding number by so much; says of which side of the
    /// inside it is the border, if it is.
    #[inline]
    pub(super) const fn passed(winding: &mut i32, by: i32, rule: Rule) -> Option<Self> {
        let was_inside = *winding & rule.mask() != 0;
        *winding = winding.wrapping_add(by);
        let is_inside = *winding & rule.mask() != 0;
        if was_inside == is_inside {
            return None;
        }
        Some(if is_inside { Self::Left } else { Self::Right })
    }

    /// What an area adds, modulo 2¹⁶.
    #[inline]
    const fn of(self, area: u32) -> u16 {
        let area = low_u16(area.cast_signed());
        match self {
            Self::Left => area,
            Self::Right => area.wrapping_neg(),
        }
    }
}

impl<'m> Cells<'m> {
    /// The most columns of a part, so that places in it have 16 fraction bits.
    pub(super) const MOST: usize = 1 << 14;

    /// A part whose first pixel is in column `left`.
    pub(super) fn new(cells: &'m mut [Coverage], left: i32) -> Self {
        Self { cells, left }
    }

    /// Emits the pixels of an edge that goes through the whole row, from its left to its right end, and shares them with
    /// none, and before it the inside from cell `at` on; gives the first cell behind.
    #[inline]
    pub(super) fn emit_edge<S, E>(
        &mut self,
        (from, to): (i64, i64),
        (side, at): (Side, i32),
        row: i32,
        sink: &mut S,
    ) -> Result<i32, E>
    where
        S: for<'c> Sink<Covered<'c>, Error = E>,
    {
        let origin = i64::from(self.left) << 16;
        let (left, right) = (from.wrapping_sub(origin), to.wrapping_sub(origin));
        if left < 0 || right >= i64::from(count_i32(self.cells.len())) << 16 {
            return self.emit_clipped((from, to), (side, at), row, sink);
        }
        let (first, end) = (low_i32(left >> 16), low_i32(right >> 16) + 1);
        if side == Side::Right && at < first {
            sink.span(row, self.left + at..self.left + first, Covered::Evenly(Coverage::FULL))?;
        }
        let (columns, mut few) = (self.left + first..self.left + end, [Coverage::NONE; 8]);
        let is_few = end - first <= 8;
        let cells =
            if is_few { few.get_mut(..index(end - first)) } else { self.cells.get_mut(index(first)..index(end)) };
        let cells = cells.unwrap_or_default();
        let mut places = cells.iter_mut();
        profile((bits(low_i32(left)), bits(low_i32(right))), HEIGHT, |_, area| {
            if let Some(place) = places.next() {
                *place = Coverage::of_area(if side == Side::Left { area } else { HEIGHT - area });
            }
        });
        sink.span(row, columns, Covered::Each(cells))?;
        if !is_few {
            cells.fill(Coverage::NONE);
        }
        Ok(end)
    }

    /// The same for an edge that is at least partly outside of the cells.
    #[cold]
    fn emit_clipped<S, E>(
        &mut self,
        (from, to): (i64, i64),
        (side, at): (Side, i32),
        row: i32,
        sink: &mut S,
    ) -> Result<i32, E>
    where
        S: for<'c> Sink<Covered<'c>, Error = E>,
    {
        let (first, end) = self.touched((from, to));
        let mut sum = if side == Side::Left { 0 } else { Coverage::FULL.parts() };
        if side == Side::Right && at < first {
            self.emit_even((at, first), &mut sum, row, sink)?;
        }
        self.add_edge((from, to), HEIGHT.cast_signed(), side);
        self.emit((first, end), &mut sum, row, sink)?;
        self.emit_even((end, end), &mut sum, row, sink)?;
        Ok(end)
    }

    /// Adds an edge between `from` and `to` on the screen, with 16 fraction bits, of `height` 32768ths of the row.
    #[inline]
    pub(super) fn add_edge(&mut self, (from, to): (i64, i64), height: i32, side: Side) {
        let (left, right) = self.relative((from, to));
        let end = i64::from(count_i32(self.cells.len())) << 16;
        if left >= 0 && right < end {
            self.add_inside((bits(low_i32(left)), bits(low_i32(right))), bits(height), side);
        } else {
            self.add_clipped((left, right), height, side);
        }
    }

    /// The left and the right end of an edge, counted from the first cell on.
    #[inline]
    fn relative(&self, (from, to): (i64, i64)) -> (i64, i64) {
        let origin = i64::from(self.left) << 16;
        (from.min(to).wrapping_sub(origin), from.max(to).wrapping_sub(origin))
    }

    /// An edge that is at least partly outside of the cells.
    #[cold]
    fn add_clipped(&mut self, (left, right): (i64, i64), height: i32, side: Side) {
        let end = i64::from(count_i32(self.cells.len())) << 16;
        if right <= 0 {
            return self.add(0, bits(height), side);
        }
        if left >= end {
            return;
        }
        // The edge is longer than a cell.
        let length = right.saturating_sub(left).max(1);
        let share = |part: i64| low_i32(i64::from(height) * part.clamp(0, length) / length);
        let (before, behind) = (share(0 - left), share(right - end));
        self.add(0, bits(before), side);
        let inside = (left.max(0), right.min(end - 1));
        let height = (height - before - behind).max(0);
        self.add_inside((bits(low_i32(inside.0)), bits(low_i32(inside.1))), bits(height), side);
    }

    /// An edge inside of the cells.
    #[inline]
    fn add_inside(&mut self, (left, right): (u32, u32), height: u32, side: Side) {
        let mut sum = 0;
        profile((left, right), height, |cell, area| {
            self.add(cell, area.wrapping_sub(sum), side);
            sum = area;
        });
        self.add((right >> 16) + 1, height - sum, side);
    }

    /// What is added behind the last cell is not seen.
    #[inline]
    fn add(&mut self, cell: u32, area: u32, side: Side) {
        if let Some(cell) = self.cells.get_mut(index(cell.cast_signed())) {
            cell.add(side.of(area));
        }
    }

    /// The cells that an edge between two places crosses: the first, and the first behind, to which the rest of its
    /// height was added.
    #[inline]
    pub(super) fn touched(&self, (from, to): (i64, i64)) -> (i32, i32) {
        let (left, right) = self.relative((from, to));
        let end = i64::from(count_i32(self.cells.len()));
        (low_i32((left >> 16).clamp(0, end)), low_i32(((right >> 16) + 1).clamp(0, end)))
    }

    /// Turns sums of heights that were taken `1 << shift` times smaller, and that may exceed a row where contours overlap,
    /// into those of their union.
    pub(super) fn unite(&mut self, shift: u32) {
        let (mut sum, mut before, most) = (0_u16, 0_u16, Coverage::FULL.parts() >> shift);
        for cell in &mut *self.cells {
            sum = sum.wrapping_add(cell.parts());
            let covered = sum.cast_signed().unsigned_abs().min(most) << shift;
            *cell = Coverage::of_difference(covered.wrapping_sub(before));
            before = covered;
        }
    }

    /// Empties the cells that an edge has changed.
    pub(super) fn clear(&mut self, (first, end): (i32, i32)) {
        let end = index(end.saturating_add(1)).min(self.cells.len());
        self.cells.get_mut(index(first)..end).unwrap_or_default().fill(Coverage::NONE);
    }

    /// Sums up some cells behind those that sum to `sum`, emits their coverage and leaves zeros.
    #[inline]
    pub(super) fn emit<S, E>(&mut self, (from, to): (i32, i32), sum: &mut u16, row: i32, sink: &mut S) -> Result<(), E>
    where
        S: for<'c> Sink<Covered<'c>, Error = E>,
    {
        let Some(cells) = self.cells.get_mut(index(from)..index(to)).filter(|cells| !cells.is_empty()) else {
            return Ok(());
        };
        for cell in &mut *cells {
            *sum = sum.wrapping_add(cell.parts());
            *cell = Coverage::of_sum(*sum);
        }
        let emitted = sink.span(row, self.left + from..self.left + to, Covered::Each(cells));
        cells.fill(Coverage::NONE);
        emitted
    }

    /// Emits a run of cells of which only the first may have been added to.
    #[inline]
    pub(super) fn emit_even<S, E>(
        &mut self,
        (from, to): (i32, i32),
        sum: &mut u16,
        row: i32,
        sink: &mut S,
    ) -> Result<(), E>
    where
        S: for<'c> Sink<Covered<'c>, Error = E>,
    {
        if let Some(first) = self.cells.get_mut(index(from)) {
            *sum = sum.wrapping_add(core::mem::take(first).parts());
        }
        let coverage = Coverage::of_sum(*sum);
        if from >= to || coverage == Coverage::NONE {
            return Ok(());
        }
        sink.span(row, self.left + from..self.left + to, Covered::Evenly(coverage))
    }

    /// Looks for the cells that were added to and emits all.
    pub(super) fn emit_all<S, E>(&mut self, row: i32, sink: &mut S) -> Result<(), E>
    where
        S: for<'c> Sink<Covered<'c>, Error = E>,
    {
        let (mut sum, mut at) = (0, 0);
        let end = count_i32(self.cells.len());
        while at < end {
            let rest = self.cells.get(index(at)..).unwrap_or_default();
            let uneven = rest.iter().take_while(|cell| **cell != Coverage::NONE).count();
            let even = rest.iter().skip(uneven).take_while(|cell| **cell == Coverage::NONE).count();
            let (from, to) = (at + count_i32(uneven), at + count_i32(uneven + even));
            self.emit((at, from), &mut sum, row, sink)?;
            self.emit_even((from, to), &mut sum, row, sink)?;
            at = to;
        }
        Ok(())
    }
}

/// Gives the area right of an edge in each of the cells that it crosses, those further left added up.
#[inline]
fn profile((left, right): (u32, u32), height: u32, mut give: impl FnMut(u32, u32)) {
    let (mut cell, last, length) = (left >> 16, right >> 16, right - left);
    if cell == last {
        return give(cell, height - behind((left & 0xFFFF) + (right & 0xFFFF), height));
    }
    // How much of the height the first cell takes, rounded down; `rest` is what that leaves.
    let (mut sum, mut rest) = divided(height * (0x1_0000 - (left & 0xFFFF)), length);
    give(cell, sum - behind((left & 0xFFFF) + 0x1_0000, sum));
    cell += 1;
    if cell < last {
        let (whole, part) = divided(height << 16, length);
        while cell < last {
            rest += part;
            let is_more = rest >= length;
            rest -= if is_more { length } else { 0 };
            let step = whole + u32::from(is_more);
            sum += step;
            give(cell, sum - step / 2);
            cell += 1;
        }
    }
    give(last, height - behind(right & 0xFFFF, height - sum));
}

/// The part of `height` right of which there is another cell; `twice` is twice the mean distance of the edge from its
/// cell's left border.
#[inline]
const fn behind(twice: u32, height: u32) -> u32 {
    (height * (twice >> 2)) >> 15
}

/// Quotient and remainder; a total function has no panic path.
#[inline]
fn divided(dividend: u32, divisor: u32) -> (u32, u32) {
    (dividend.checked_div(divisor).unwrap_or(0), dividend.checked_rem(divisor).unwrap_or(0))
}

/// Parts of 256 of a row's height in 32768ths.
#[inline]
pub(super) const fn height_of(parts: i32) -> i32 {
    parts * (HEIGHT.cast_signed() / 256)
}
