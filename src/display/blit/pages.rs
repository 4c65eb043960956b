//! One page of a frame: blocks of eight columns, and how they are merged.

use core::{iter::zip, ops::Range};

use super::RasterOp;
use crate::{
    display::transpose::{columns, eight, load, store},
    num::low_index,
};

/// The part of a picture that falls on one page of the target.
#[derive(Clone, Debug)]
pub(super) struct Page {
    pub(super) index: usize,
    pub(super) columns: Range<usize>,
    /// The first pixel in the source.
    pub(super) column: usize,
    pub(super) row: usize,
    /// How many columns of the first block are left of it.
    pub(super) hidden: usize,
    /// How many rows, 1 to 8, and how far below the upper edge of the page.
    pub(super) rows: usize,
    pub(super) below: u32,
}

impl Page {
    /// The bytes of the target.
    pub(super) fn bytes<'t>(&self, target: &'t mut [u8], stride: usize) -> &'t mut [u8] {
        let start = self.index * stride;
        target.get_mut(start + self.columns.start..start + self.columns.end).unwrap_or_default()
    }

    /// The rows that are meant, a bit for each.
    pub(super) fn inside(&self) -> u8 {
        0xFF >> (8 - low_index(self.rows)) << self.below
    }

    /// Blocks from rows. The first one begins at a multiple of eight columns.
    pub(super) fn blocks_of_rows(&self, bytes: &[u8], stride: usize) -> impl Iterator<Item = u64> {
        let (start, end) = (self.row * stride, (self.row + self.rows) * stride);
        let (rows, _) = eight(bytes.get(start..end).unwrap_or_default(), stride);
        let below = self.below;
        columns(rows.map(|row| row.get(self.column / 8..).unwrap_or_default())).map(move |block| block << below)
    }

    /// Blocks from pages. The first one begins with the first pixel.
    pub(super) fn blocks_of_pages(&self, bytes: &[u8], stride: usize) -> impl Iterator<Item = u64> {
        let width = self.columns.len();
        let line = |page: usize| bytes.get(page * stride + self.column..)?.get(..width);
        let upper = line(self.row / 8).unwrap_or_default();
        // Without a lower page, none of its rows is meant.
        let lower = line(self.row / 8 + 1).unwrap_or(upper);
        let (below, above) = (self.below, self.row % 8);
        let of_upper = lanes(0xFF >> above);
        zip(upper.chunks(8), lower.chunks(8)).map(move |(upper, lower)| {
            let (upper, lower) = (load(upper) >> above, load(lower) << (8 - above));
            (upper & of_upper | lower & !of_upper) << below
        })
    }

    /// Merges blocks, each with its mask.
    pub(super) fn merge(&self, bytes: &mut [u8], mut blocks: impl Iterator<Item = (u64, u64)>, op: RasterOp) {
        let inside = lanes(self.inside());
        let merge = |bytes: &mut [u8], (new, mask): (u64, u64)| {
            let old = load(bytes);
            store(bytes, old ^ (op.change(old, new) & mask & inside));
        };
        let head = ((8 - self.hidden) % 8).min(bytes.len());
        let (head, rest) = bytes.split_at_mut_checked(head).unwrap_or_default();
        if !head.is_empty() {
            let hidden = |block| block << (8 * self.hidden);
            blocks.next().into_iter().for_each(|(new, mask)| merge(head, (hidden(new), hidden(mask))));
        }
        zip(rest.chunks_mut(8), blocks).for_each(|(bytes, block)| merge(bytes, block));
    }
}

/// Eight bytes alike.
pub(super) const fn lanes(byte: u8) -> u64 {
    u64::from_ne_bytes([byte; 8])
}
