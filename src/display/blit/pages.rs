//! One page of a frame: blocks of eight columns, and how they are merged.

use core::{iter::zip, mem::take, ops::Range};

use super::RasterOp;
use crate::{
    display::transpose::{load, load_blocks, store, to_blocks, words},
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

    /// Merges pixels of rows, where those of the mask are 1.
    pub(super) fn merge_rows(
        &self,
        target: &mut [u8],
        (source, mask): (&[u8], Option<&[u8]>),
        stride: usize,
        op: RasterOp,
    ) {
        // So many blocks are whole when a word begins with the first pixel.
        let hidden = low_index(self.column % 8);
        let blocks = if hidden == 0 { 8 } else { 7 };
        let mut first = self.row * stride + self.column / 8;
        let inside = lanes(self.inside());
        for target in target.chunks_mut(8 * blocks) {
            let tile = |bytes| {
                let mut words = words(bytes, stride, first);
                shift(&mut words, hidden);
                to_blocks(&mut words);
                shift(&mut words, self.below);
                words
            };
            let mut masks = mask.map_or([u64::MAX; 8], tile);
            for mask in &mut masks {
                *mask &= inside;
            }
            merge(target, &tile(source), &masks, op);
            first += blocks;
        }
    }

    /// Merges pixels of pages.
    pub(super) fn merge_pages(&self, target: &mut [u8], source: &[u8], stride: usize, op: RasterOp) {
        let width = target.len();
        let line = |page: usize| source.get(page * stride + self.column..)?.get(..width);
        let upper = line(self.row / 8).unwrap_or_default();
        // Without a lower page, none of its rows is meant.
        let lower = line(self.row / 8 + 1).unwrap_or(upper);
        let above = self.row % 8;
        let (of_upper, inside) = (lanes(0xFF >> above), [lanes(self.inside()); 8]);
        let mut first = 0;
        for target in target.chunks_mut(64) {
            let from = |line: &[u8]| load_blocks(line.get(first..).unwrap_or_default());
            let mut blocks = from(upper);
            for (block, lower) in zip(&mut blocks, from(lower)) {
                *block = (((*block >> above) & of_upper) | ((lower << (8 - above)) & !of_upper)) << self.below;
            }
            merge(target, &blocks, &inside, op);
            first += 64;
        }
    }
}

/// Merges up to eight blocks, the last of them first, each with its mask.
fn merge(target: &mut [u8], blocks: &[u64; 8], masks: &[u64; 8], op: RasterOp) {
    match op {
        RasterOp::Copy => change(target, blocks, masks, |old, new| RasterOp::Copy.change(old, new)),
        RasterOp::Or => change(target, blocks, masks, |old, new| RasterOp::Or.change(old, new)),
        RasterOp::AndNot => change(target, blocks, masks, |old, new| RasterOp::AndNot.change(old, new)),
        RasterOp::Xor => change(target, blocks, masks, |old, new| RasterOp::Xor.change(old, new)),
    }
}

/// The same for one operation, which has a loop of its own.
#[inline]
fn change(target: &mut [u8], blocks: &[u64; 8], masks: &[u64; 8], change: impl Fn(u64, u64) -> u64) {
    let merged = |old, new, mask| old ^ (change(old, new) & mask);
    let mut rest = target;
    for (new, mask) in zip(blocks, masks).rev() {
        if rest.len() < 8 {
            let old = load(rest);
            return store(rest, merged(old, *new, *mask));
        }
        let Some((bytes, more)) = take(&mut rest).split_first_chunk_mut() else { return };
        *bytes = merged(u64::from_be_bytes(*bytes), *new, *mask).to_be_bytes();
        rest = more;
    }
}

/// Shifts to the left, which most often is by nothing.
fn shift(words: &mut [u64; 8], by: u32) {
    if by > 0 {
        for word in words {
            *word <<= by;
        }
    }
}

/// Eight bytes alike.
const fn lanes(byte: u8) -> u64 {
    u64::from_ne_bytes([byte; 8])
}
