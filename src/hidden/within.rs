//! Pieces of faces: what others decide, on one side of some cuts.

use core::{iter::repeat_with, ops::Range};

use crate::{
    cut::Cut,
    hidden::Hidden,
    num::{bits, index},
    space::Rect,
    vary::Ramp,
};

/// A part of the screen of which each row is a run.
pub(crate) trait Region {
    /// The columns of a run that are in it.
    fn keep(&self, row: i32, columns: Range<i32>) -> Range<i32>;

    /// Whether a pixel is in it.
    #[inline]
    fn keeps(&self, row: i32, column: i32) -> bool {
        !self.keep(row, column..column.saturating_add(1)).is_empty()
    }
}

impl Region for Cut {
    #[inline]
    fn keep(&self, row: i32, columns: Range<i32>) -> Range<i32> {
        self.keep(row, columns)
    }

    #[inline]
    fn keeps(&self, row: i32, column: i32) -> bool {
        self.keeps(row, column)
    }
}

/// What is in all of them. Each is asked only about what those before it have kept.
impl<R: Region> Region for [R] {
    #[inline]
    fn keep(&self, row: i32, columns: Range<i32>) -> Range<i32> {
        self.iter().fold(columns, |columns, region| region.keep(row, columns))
    }

    #[inline]
    fn keeps(&self, row: i32, column: i32) -> bool {
        self.iter().all(|region| region.keeps(row, column))
    }
}

/// Lets pixels be seen that are in a region, if the one behind sees them.
#[derive(Debug)]
pub(crate) struct Within<'h, H, R: ?Sized> {
    hidden: &'h mut H,
    region: &'h R,
}

impl<'h, H, R: Region + ?Sized> Within<'h, H, R> {
    pub(crate) const fn new(hidden: &'h mut H, region: &'h R) -> Self {
        Self { hidden, region }
    }
}

impl<H: Hidden, R: Region + ?Sized> Hidden for Within<'_, H, R> {
    const USES_DEPTH: bool = H::USES_DEPTH;

    fn bounds(&self) -> Rect {
        self.hidden.bounds()
    }

    #[inline]
    fn sees(&mut self, row: i32, column: i32, depth: Ramp<1>) -> bool {
        self.region.keeps(row, column) && self.hidden.sees(row, column, depth)
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
        let kept = self.region.keep(row, columns);
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
        let kept = self.region.keep(row, columns.clone());
        let before = kept.start.wrapping_sub(columns.start);
        // Those in front of the cut are computed, and forgotten.
        colors.by_ref().take(index(before)).for_each(drop);
        let (length, behind) = (kept.end.wrapping_sub(kept.start), columns.end.wrapping_sub(kept.end));
        let seen = self.hidden.filter(row, kept, depth.skipped(bits(before)), colors).take(index(length));
        repeat_with(|| None).take(index(before)).chain(seen).chain(repeat_with(|| None).take(index(behind)))
    }
}
