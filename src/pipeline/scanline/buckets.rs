//! Buckets of rows: a radix sort of the faces by their first rows. Lecture 5.4.4.

use core::ops::Range;

use crate::{
    num::{index, low_index},
    space::Rect,
};

/// The faces whose first rows are some rows of the picture: 4 bytes.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RowBucket {
    /// One more than its first face; 0 if it has none, so that a static array takes no flash.
    first: u16,
    /// How many more faces reach into its rows than into those above.
    change: i16,
}

/// No face.
pub(super) const NONE: u16 = u16::MAX;

impl RowBucket {
    /// Something to fill an array with.
    pub const EMPTY: Self = Self { first: 0, change: 0 };
}

/// Buckets for the rows of a window, each for as many rows: a power of two.
pub(super) struct Buckets<'b> {
    list: &'b mut [RowBucket],
    top: i32,
    rows_log2: u32,
}

impl<'b> Buckets<'b> {
    /// For no rows yet.
    pub(super) fn new(list: &'b mut [RowBucket]) -> Self {
        Self { list, top: 0, rows_log2: 0 }
    }

    /// Empties them, for the rows of a window.
    pub(super) fn empty_for(&mut self, window: Rect) {
        self.list.fill(RowBucket::EMPTY);
        (self.top, self.rows_log2) = (window.top, 0);
        while self.rows_log2 < 31 && window.height().saturating_sub(1) >> self.rows_log2 >= low_index(self.list.len()) {
            self.rows_log2 += 1;
        }
    }

    fn place(&self, row: i32) -> usize {
        index(row.saturating_sub(self.top)) >> self.rows_log2
    }

    /// The first face of the bucket of a row.
    pub(super) fn first(&self, row: i32) -> u16 {
        self.list.get(self.place(row)).map_or(NONE, |bucket| bucket.first.wrapping_sub(1))
    }

    /// Puts a face in front of those that begin with the same rows; gives the one that was first.
    pub(super) fn insert(&mut self, face: u16, rows: &Range<i32>) -> u16 {
        let (begins, ends) = (self.place(rows.start), self.place(rows.end.saturating_sub(1)).wrapping_add(1));
        if let Some(behind) = self.list.get_mut(ends) {
            behind.change = behind.change.wrapping_sub(1);
        }
        let Some(bucket) = self.list.get_mut(begins) else { return NONE };
        bucket.change = bucket.change.wrapping_add(1);
        core::mem::replace(&mut bucket.first, face.wrapping_add(1)).wrapping_sub(1)
    }

    /// Whether there is none.
    pub(super) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The most faces that reach into the rows of one bucket.
    pub(super) fn most_active(&self) -> usize {
        let active = self.list.iter().scan(0_u16, |active, bucket| {
            *active = active.wrapping_add_signed(bucket.change);
            Some(*active)
        });
        active.max().unwrap_or(0).into()
    }
}
