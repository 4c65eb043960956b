//! The queue of what is still to be looked around from: a ring in memory of the caller's.

use core::ops::Range;

use crate::num::index_u16;

/// An entry of the queue: some pixels side by side in one row. Six bytes.
///
/// ```
/// let mut queue = [aquatint::raster::flood::Run::default(); 16];
/// assert_eq!(size_of_val(&queue), 96);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Run {
    row: u16,
    start: u16,
    end: u16,
}

impl Run {
    /// No pixels; a constant, so that a queue can be a static.
    pub const EMPTY: Self = Self { row: 0, start: 0, end: 0 };

    /// Row and columns are at most 65,535.
    #[inline]
    pub(super) fn new(row: usize, columns: &Range<usize>) -> Self {
        let [row, start, end] = [row, columns.start, columns.end].map(index_u16);
        Self { row, start, end }
    }

    #[inline]
    pub(super) fn row(self) -> usize {
        self.row.into()
    }

    #[inline]
    pub(super) fn columns(self) -> Range<usize> {
        self.start.into()..self.end.into()
    }
}

/// First in, first out: a front that grows evenly is short, where a stack's would be as long as the
/// way that it has come.
#[derive(Debug)]
pub(super) struct Queue<'q> {
    runs: &'q mut [Run],
    /// Where the oldest is, and where the next goes.
    first: usize,
    next: usize,
    length: usize,
}

impl<'q> Queue<'q> {
    pub(super) const fn new(runs: &'q mut [Run]) -> Self {
        Self { runs, first: 0, next: 0, length: 0 }
    }

    /// False when there is no room.
    #[inline]
    #[must_use]
    pub(super) fn push(&mut self, run: Run) -> bool {
        let is_free = self.length < self.runs.len();
        if let Some(place) = self.runs.get_mut(self.next).filter(|_| is_free) {
            *place = run;
            self.length += 1;
            self.next = self.after(self.next);
        }
        is_free
    }

    #[inline]
    pub(super) fn pop(&mut self) -> Option<Run> {
        self.length = self.length.checked_sub(1)?;
        let run = self.runs.get(self.first).copied();
        self.first = self.after(self.first);
        run
    }

    #[inline]
    fn after(&self, place: usize) -> usize {
        if place + 1 < self.runs.len() { place + 1 } else { 0 }
    }
}
