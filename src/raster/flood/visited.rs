//! The visited bitmap: a bit a pixel, and a bit for each row that must be looked at again.
//!
//! What the lent memory holds does not matter. Only a rectangle of words is valid; it grows with the
//! search, and what comes into it is cleared then. So no call leaves anything behind that the next could
//! stumble over, and what is never searched is never cleared.
//!
//! ```text
//!   dirty rows   ▒▒                  one bit a row, cleared at the beginning
//!   rows         ? ? ? ? ? ?
//!                ? ? 0 0 0 ?         valid: this rectangle of words
//!                ? ? 0 x 0 ?
//!                ? ? ? ? ? ?
//! ```

use core::ops::Range;

use super::Refused;
use crate::{
    num::{count, low_index},
    space::Rect,
};

/// Rows and columns that a window may have: places fit 16 bits.
pub(super) const LIMIT: u32 = u16::MAX as u32;

/// How many words [`Flood`](super::Flood) needs for a window of this size: a bit a pixel in whole words a
/// row, and a bit a row. `usize::MAX` where no memory could hold them.
///
/// ```
/// use aquatint::raster::flood::words_needed;
/// assert_eq!(words_needed(128, 64), 4 * 64 + 2); // 1032 bytes
/// assert_eq!(words_needed(400, 240), 13 * 240 + 8); // 12,512 bytes
/// ```
#[must_use]
pub const fn words_needed(width: u32, height: u32) -> usize {
    count(width.div_ceil(32) as u64 * height as u64 + height.div_ceil(32) as u64)
}

#[derive(Debug)]
pub(super) struct Visited<'m> {
    words: &'m mut [u32],
    dirty: &'m mut [u32],
    /// Words in a row.
    stride: usize,
    height: usize,
    /// Those pixels of the last word of a row that exist.
    tail: u32,
    /// The words that are valid.
    rows: Range<usize>,
    columns: Range<usize>,
    /// The row after the one that was last looked at again.
    cursor: usize,
}

impl<'m> Visited<'m> {
    /// No pixel of a window is visited.
    pub(super) fn new(memory: &'m mut [u32], window: Rect) -> Result<Self, Refused> {
        let (width, height) = (window.width(), window.height());
        if width > LIMIT || height > LIMIT {
            return Err(Refused::TooLarge);
        }
        let needed = words_needed(width, height);
        let memory = memory.get_mut(..needed).ok_or(Refused::TooFewWords { needed })?;
        let (dirty, words) = memory.split_at_mut_checked(height.div_ceil(32) as usize).unwrap_or_default();
        dirty.fill(0);
        let tail = u32::MAX << (width.wrapping_neg() % 32);
        let (stride, height) = (width.div_ceil(32) as usize, height as usize);
        Ok(Self { words, dirty, stride, height, tail, rows: 0..0, columns: 0..0, cursor: 0 })
    }

    pub(super) const fn stride(&self) -> usize {
        self.stride
    }

    pub(super) const fn height(&self) -> usize {
        self.height
    }

    /// The rows in which something may have been visited.
    pub(super) fn rows(&self) -> Range<usize> {
        self.rows.clone()
    }

    /// The words of these rows in which something may have been visited.
    pub(super) fn columns(&self) -> Range<usize> {
        self.columns.clone()
    }

    /// The pixels visited in a valid word.
    #[inline]
    pub(super) fn word(&self, row: usize, word: usize) -> u32 {
        self.words.get(row * self.stride + word).copied().unwrap_or(0)
    }

    /// The pixels of a word that exist.
    #[inline]
    pub(super) const fn existing(&self, word: usize) -> u32 {
        if word + 1 < self.stride { u32::MAX } else { self.tail }
    }

    /// Whether all that is visited in some words of a row is visited in the row next to it too.
    #[inline]
    pub(super) fn covers(&self, row: usize, from: usize, mut words: Range<usize>) -> bool {
        let is_covered = |word| self.word(from, word) & !self.word(row, word) == 0;
        self.rows.contains(&row) && words.all(is_covered)
    }

    /// Words of a row.
    #[inline]
    pub(super) fn line(&self, row: usize, words: Range<usize>) -> &[u32] {
        let start = row * self.stride;
        self.words.get(start + words.start..start + words.end).unwrap_or(&[])
    }

    /// Visits pixels of a valid word.
    #[inline]
    pub(super) fn mark(&mut self, row: usize, word: usize, pixels: u32) {
        if let Some(visited) = self.words.get_mut(row * self.stride + word) {
            *visited |= pixels;
        }
    }

    /// Makes words of a row valid that overlap with those that are, or lie next to them; or the very first.
    #[inline]
    pub(super) fn cover(&mut self, row: usize, words: &Range<usize>) {
        if words.start < self.columns.start || words.end > self.columns.end {
            self.widen(words);
        }
        if !self.rows.contains(&row) {
            self.heighten(row);
        }
    }

    #[inline(never)]
    fn widen(&mut self, words: &Range<usize>) {
        let wide = united(&self.columns, words);
        let old = core::mem::replace(&mut self.columns, wide);
        for row in self.rows.clone() {
            for words in [self.columns.start..old.start, old.end..self.columns.end] {
                if !words.is_empty() {
                    self.clear(row, words);
                }
            }
        }
    }

    #[inline]
    fn heighten(&mut self, row: usize) {
        self.clear(row, self.columns.clone());
        self.rows = united(&self.rows, &(row..row + 1));
    }

    fn clear(&mut self, row: usize, words: Range<usize>) {
        let start = row * self.stride;
        self.words.get_mut(start + words.start..start + words.end).unwrap_or_default().fill(0);
    }

    /// Says that the neighbours of a row must be looked at again.
    #[cold]
    pub(super) fn mark_dirty(&mut self, row: usize) {
        if let Some(word) = self.dirty.get_mut(row / 32) {
            *word |= 1 << (31 - low_index(row) % 32);
        }
    }

    /// The next row that is dirty, from the last one on downwards and then from the top again.
    pub(super) fn take_dirty(&mut self) -> Option<usize> {
        // The word of the cursor comes twice: from the cursor on, and in the end as a whole.
        let (first, mut mask) = (self.cursor / 32, u32::MAX >> (low_index(self.cursor) % 32));
        for at in (first..self.dirty.len()).chain(0..=first) {
            if let Some(word) = self.dirty.get_mut(at).filter(|word| **word & mask != 0) {
                let bit = (*word & mask).leading_zeros();
                *word &= !(1 << (31 - bit));
                let row = 32 * at + bit as usize;
                self.cursor = row + 1;
                return Some(row);
            }
            mask = u32::MAX;
        }
        None
    }
}

/// Two ranges that meet, as one; the second alone when the first is empty.
fn united(range: &Range<usize>, other: &Range<usize>) -> Range<usize> {
    if range.is_empty() { other.clone() } else { range.start.min(other.start)..range.end.max(other.end) }
}
