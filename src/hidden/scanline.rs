//! The scanline algorithm: the surfaces that reach into a row are compared in that row only. Lecture 5.4.
//!
//! ```text
//!   spans of a row, with depths         the runs that are seen
//!      ╲ b
//!   ────╲───────── a      nearer
//!        ╲              ↓               a a a a b b b · · c c
//!         ╲     c ─────  the eye
//! ```
//!
//! Depths are linear along a row, so two spans that overlap are compared at the ends of the overlap: who is in front at
//! both is in front between them, and if the ends disagree, the spans pierce each other at a column that is computed.
//! Nothing is done a pixel, no pixel is given twice, and there is no depth buffer.
//!
//! - **Takes** the spans of one row, in any order.
//! - **Gives** runs from left to right, each with the surface that is seen in it: to the pixel those that a
//!   [`DepthBuffer<u32>`](super::depth::DepthBuffer) would leave, if it were given the spans by their order.
//! - **Memory** six bytes a run, lent by the caller.
//! - **Cost** of a span two comparisons for each run that it overlaps, and one division where two pierce each other.
//!
//! G. S. Watkins, "A real time visible surface algorithm", University of Utah, 1970.

use core::ops::Range;

use heapless::vec::VecView;

use crate::{
    list::insert,
    num::{bits, low_i16},
};

/// Pixels of a row in which one surface is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct VisibleRun {
    start: i16,
    end: i16,
    surface: u16,
}

impl VisibleRun {
    /// Columns from −32,768 to 32,767.
    #[inline]
    fn new(columns: &Range<i32>, surface: u16) -> Self {
        Self { start: low_i16(columns.start), end: low_i16(columns.end), surface }
    }

    /// Its columns.
    #[inline]
    #[must_use]
    pub fn columns(&self) -> Range<i32> {
        self.start.into()..self.end.into()
    }

    /// The number that its surface was given.
    #[inline]
    #[must_use]
    pub const fn surface(&self) -> u16 {
        self.surface
    }
}

/// How far away a surface is along one row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RowDepth {
    /// In column 0, in 31 bits; modulo 2³² where the surface does not reach so far.
    pub(crate) depth: u32,
    /// What is added from column to column.
    pub(crate) across: u32,
    /// Of two that are equally near, the one with the lower number is seen: it was drawn first.
    pub(crate) order: u16,
}

impl RowDepth {
    /// Of no surface.
    pub(crate) const FARTHEST: Self = Self { depth: 0, across: 0, order: u16::MAX };
}

/// There is no room for another run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Full;

/// The visible runs of one row, from left to right, none overlapping another.
pub(crate) struct Scanline<'r> {
    runs: &'r mut VecView<VisibleRun>,
}

impl<'r> Scanline<'r> {
    /// A row in which nothing is seen yet.
    pub(crate) fn new(runs: &'r mut VecView<VisibleRun>) -> Self {
        runs.clear();
        Self { runs }
    }

    /// Adds the span of a surface; `depths` tells those of all surfaces that have been added, by their numbers.
    #[inline]
    pub(crate) fn add(
        &mut self,
        mut columns: Range<i32>,
        surface: u16,
        depths: &impl Fn(u16) -> RowDepth,
    ) -> Result<(), Full> {
        if columns.is_empty() {
            return Ok(());
        }
        if self.runs.last().is_none_or(|last| i32::from(last.end) <= columns.start) {
            return self.push(&columns, surface);
        }
        let mut place = self.first_that_ends_behind(columns.start);
        while !columns.is_empty() {
            let old = self.runs.get(place).copied().filter(|old| i32::from(old.start) < columns.end);
            let Some(old) = old else { return self.insert(place, &columns, surface).map(drop) };
            let before = columns.start..old.start.into();
            if !before.is_empty() {
                place = self.insert(place, &before, surface)?;
                columns.start = before.end;
            }
            let end = columns.end.min(old.end.into());
            let wins = where_nearer(&depths(surface), &depths(old.surface), columns.start..end);
            place = self.replace(place, &wins, surface)?;
            // There stands what the old surface has kept, if that is to the right.
            place = place.wrapping_add(usize::from(wins.end < end));
            columns.start = end;
        }
        Ok(())
    }

    /// Adds a run behind all others, or makes the last one longer.
    #[inline]
    fn push(&mut self, columns: &Range<i32>, surface: u16) -> Result<(), Full> {
        match self.runs.last_mut().filter(|last| last.surface == surface && i32::from(last.end) == columns.start) {
            Some(last) => last.end = low_i16(columns.end),
            None => return self.runs.push(VisibleRun::new(columns, surface)).map_err(|_| Full),
        }
        Ok(())
    }

    /// The place of the first run that reaches beyond a column. Surfaces come sorted, mostly, so it is sought from the end.
    #[inline]
    fn first_that_ends_behind(&self, column: i32) -> usize {
        self.runs.iter().rposition(|run| i32::from(run.end) <= column).map_or(0, |before| before.wrapping_add(1))
    }

    /// Puts a run before the one at `place`, or makes the one before it longer; gives the place of the run behind.
    #[inline]
    fn insert(&mut self, place: usize, columns: &Range<i32>, surface: u16) -> Result<usize, Full> {
        let before = place.checked_sub(1).and_then(|before| self.runs.get_mut(before));
        if let Some(before) = before.filter(|run| run.surface == surface && i32::from(run.end) == columns.start) {
            before.end = low_i16(columns.end);
            return Ok(place);
        }
        insert(self.runs, place, VisibleRun::new(columns, surface)).map_err(|_| Full)?;
        Ok(place.wrapping_add(1))
    }

    /// Takes columns from the run at `place` for another surface; gives the place of what is left of it behind them.
    #[inline]
    fn replace(&mut self, place: usize, columns: &Range<i32>, surface: u16) -> Result<usize, Full> {
        let Some(old) = self.runs.get_mut(place).filter(|_| !columns.is_empty()) else { return Ok(place) };
        let (left, right) = (i32::from(old.start)..columns.start, columns.end..i32::from(old.end));
        let loser = old.surface;
        if left.is_empty() && right.is_empty() {
            self.runs.remove(place);
            return self.insert(place, columns, surface);
        }
        if left.is_empty() {
            old.start = low_i16(right.start);
            return self.insert(place, columns, surface);
        }
        old.end = low_i16(left.end);
        let behind = self.insert(place.wrapping_add(1), columns, surface)?;
        if !right.is_empty() {
            insert(self.runs, behind, VisibleRun::new(&right, loser)).map_err(|_| Full)?;
        }
        Ok(behind)
    }
}

/// The columns of an overlap in which `new` is in front of `old`: all, none, or those from one end on.
#[inline]
fn where_nearer(new: &RowDepth, old: &RowDepth, overlap: Range<i32>) -> Range<i32> {
    let lead = (new.depth.wrapping_sub(old.depth), new.across.wrapping_sub(old.across));
    where_ahead(lead, new.order < old.order, overlap)
}

/// The columns of a run in which a lead of depths is more than 0, or is 0 and `wins_ties`. The lead is that in column 0, and
/// what is added from column to column; both surfaces reach over the run.
#[inline]
pub(super) fn where_ahead((lead, step): (u32, u32), wins_ties: bool, run: Range<i32>) -> Range<i32> {
    // Depths have 31 bits, so that their difference has a sign.
    let tie = i32::from(wins_ties);
    let lead = |column| lead.wrapping_add(step.wrapping_mul(bits(column))).cast_signed().saturating_add(tie);
    let last = run.end.wrapping_sub(1);
    let (at_start, at_end) = (lead(run.start), lead(last));
    match (at_start > 0, at_end > 0) {
        (true, true) => run,
        (false, false) => run.start..run.start,
        (in_front, _) => {
            let step = step.cast_signed().unsigned_abs();
            // So many columns until it is 0 or less, or more than 0.
            let to_go = if in_front { at_start.wrapping_sub(1) } else { at_start.wrapping_neg() };
            let columns = to_go.unsigned_abs().checked_div(step).unwrap_or(0).saturating_add(1);
            // Two columns may differ by more than a step of 32 bits can tell; then it is the second of them.
            let crossing = run.start.saturating_add_unsigned(columns).min(last);
            if in_front { run.start..crossing } else { crossing..run.end }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::{index_u16, low_u32};
    use heapless::Vec;
    use proptest::prelude::*;

    /// A span with the line of its depth; depths are never negative inside of it.
    #[derive(Clone, Debug)]
    struct Flat {
        columns: Range<i32>,
        depth: RowDepth,
    }

    impl RowDepth {
        fn at(&self, column: i32) -> u32 {
            self.depth.wrapping_add(self.across.wrapping_mul(bits(column)))
        }
    }

    fn flats() -> impl Strategy<Value = Vec<Flat, 24>> {
        let depth = prop_oneof![0..16_u32, 0..0x7FFF_FFFF_u32];
        let one = (-8..40_i32, 1..30_i32, depth.clone(), depth);
        prop::collection::vec(one, 0..24).prop_map(|flats| {
            let flat = |(order, (start, width, from, to)): (usize, (i32, i32, u32, u32))| {
                let steps = i64::from(width.max(2) - 1);
                let across = low_u32((i64::from(to) - i64::from(from)) / steps);
                let depth = from.wrapping_sub(across.wrapping_mul(bits(start)));
                Flat { columns: start..start + width, depth: RowDepth { depth, across, order: index_u16(order) } }
            };
            flats.into_iter().enumerate().map(flat).collect()
        })
    }

    /// Who is seen in a column, pixel by pixel.
    fn nearest(flats: &[Flat], column: i32) -> Option<u16> {
        let here = flats.iter().filter(|flat| flat.columns.contains(&column));
        here.max_by_key(|flat| (flat.depth.at(column), !flat.depth.order)).map(|flat| flat.depth.order)
    }

    fn row(flats: &[Flat], runs: &mut VecView<VisibleRun>, turned: bool) -> Result<(), Full> {
        let depths = |surface: u16| flats[usize::from(surface)].depth;
        let mut line = Scanline::new(runs);
        let add = |flat: &Flat| line.add(flat.columns.clone(), flat.depth.order, &depths);
        if turned { flats.iter().rev().try_for_each(add) } else { flats.iter().try_for_each(add) }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        #[test]
        fn runs_are_what_a_depth_of_every_pixel_gives(flats in flats()) {
            let (mut runs, mut turned) = (Vec::<_, 256>::new(), Vec::<_, 256>::new());
            prop_assert!(row(&flats, &mut runs, false).is_ok());
            prop_assert!(row(&flats, &mut turned, true).is_ok());
            for column in -10..80 {
                let run = |runs: &[VisibleRun]| runs.iter().find(|run| run.columns().contains(&column)).map(VisibleRun::surface);
                prop_assert_eq!(run(&runs), nearest(&flats, column), "column {}", column);
                prop_assert_eq!(run(&turned), nearest(&flats, column), "column {}, the other way around", column);
            }
            let ordered = |runs: &[VisibleRun]| {
                runs.iter().all(|run| run.start < run.end) && runs.windows(2).all(|pair| pair[0].end <= pair[1].start)
            };
            prop_assert!(ordered(&runs) && ordered(&turned));
        }

        #[test]
        fn a_row_too_full_is_told(flats in flats()) {
            let (mut all, mut few) = (Vec::<_, 256>::new(), Vec::<_, 3>::new());
            prop_assert!(row(&flats, &mut all, false).is_ok());
            // While it is made, a row may have more runs than in the end.
            prop_assert!(row(&flats, &mut few, false).is_err() || all.len() <= 3);
        }
    }

    #[test]
    fn piercing_spans_are_cut_where_they_cross() {
        let depth = |from: u32, across: i32, order| RowDepth { depth: from, across: bits(across), order };
        let flats = [depth(0, 2, 0), depth(20, -2, 1), depth(7, 0, 2)].map(|depth| Flat { columns: 0..11, depth });
        let mut runs = Vec::<_, 8>::new();
        row(&flats, &mut runs, false).unwrap();
        // Equal in column 5, where the first is seen.
        assert_eq!(runs.as_slice(), [VisibleRun::new(&(0..5), 1), VisibleRun::new(&(5..11), 0)]);
    }
}
