//! Pieces of faces: what others decide, on one side of some cuts.

use core::{iter::repeat_with, ops::Range};

use heapless::vec::Vec;

use crate::{
    cut::{Cut, kept},
    hidden::{Hidden, bsp::MOST_CUTS},
    num::{bits, index},
    space::Rect,
    vary::Ramp,
};

/// Lets pixels be seen that are on the kept side of all cuts, if the one behind sees them.
#[derive(Debug)]
pub(crate) struct Within<'h, H> {
    hidden: &'h mut H,
    pub(crate) cuts: Vec<Cut, MOST_CUTS>,
}

impl<'h, H> Within<'h, H> {
    pub(crate) const fn new(hidden: &'h mut H) -> Self {
        Self { hidden, cuts: Vec::new() }
    }
}

impl<H: Hidden> Hidden for Within<'_, H> {
    const USES_DEPTH: bool = H::USES_DEPTH;

    fn bounds(&self) -> Rect {
        self.hidden.bounds()
    }

    #[inline]
    fn sees(&mut self, row: i32, column: i32, depth: Ramp<1>) -> bool {
        self.cuts.iter().all(|cut| cut.keeps(row, column)) && self.hidden.sees(row, column, depth)
    }

    #[inline]
    fn split<E>(
        &mut self,
        row: i32,
        columns: Range<i32>,
        depth: Ramp<1>,
        seen: impl FnMut(Range<i32>) -> Result<(), E>,
    ) -> Result<(), E> {
        let start = columns.start;
        let kept = kept(&self.cuts, row, columns);
        if kept.is_empty() {
            return Ok(());
        }
        let depth = depth.skipped(bits(kept.start.wrapping_sub(start)));
        self.hidden.split(row, kept, depth, seen)
    }

    #[inline]
    fn filter<C>(
        &mut self,
        row: i32,
        columns: Range<i32>,
        depth: Ramp<1>,
        mut colors: impl Iterator<Item = Option<C>>,
    ) -> impl Iterator<Item = Option<C>> {
        let kept = kept(&self.cuts, row, columns.clone());
        let before = kept.start.wrapping_sub(columns.start);
        // Those in front of the cut are computed, and forgotten.
        colors.by_ref().take(index(before)).for_each(drop);
        let (length, behind) = (kept.end.wrapping_sub(kept.start), columns.end.wrapping_sub(kept.end));
        let seen = self.hidden.filter(row, kept, depth.skipped(bits(before)), colors).take(index(length));
        repeat_with(|| None).take(index(before)).chain(seen).chain(repeat_with(|| None).take(index(behind)))
    }
}
