//! Rows onto pages: blocks of eight by eight pixels, turned into bytes of a page.

use core::{iter::repeat, mem::take};

use super::{
    op::{Op, RasterOp},
    packing::Way,
    part::{Job, Pixels, Source},
};
use crate::{
    display::{
        layout::Memory,
        transpose::{load, store, to_blocks, words},
    },
    num::low_index,
};

/// Where the rows of a picture fall on pages, and in which orders of bits.
#[derive(Clone, Copy, Debug)]
struct Tiles {
    /// The bits of a mask where nothing is drawn.
    hole: u64,
    /// First bit in its byte.
    hidden: u32,
    rows_msb_first: bool,
    pages_msb_first: bool,
}

/// Merges a picture in rows.
pub(super) fn merge(
    target: Memory<&mut [u8]>,
    (source, Pixels { hole, .. }): (&Source, Pixels),
    (jobs, way): (impl Iterator<Item = Job>, Way),
    op: Op<u8>,
) {
    let Memory { bytes, stride } = target;
    let Way::Transposed { rows_msb_first, pages_msb_first } = way else { return };
    let (plain, op) = (op.plain(), op.map(lanes));
    for job in jobs {
        let hidden = low_index(job.from.0 % 8);
        let tiles = Tiles { hole: lanes(hole), hidden, rows_msb_first, pages_msb_first };
        let target = (&mut *bytes, stride);
        match plain {
            // Images, most often.
            Some(RasterOp::Copy) => tiles.merge(target, source, &job, |old, new, mask| old ^ ((old ^ new) & mask)),
            _ => tiles.merge(target, source, &job, |old, new, mask| op.merged(old, new, mask)),
        }
    }
}

impl Tiles {
    /// Merges a rectangle.
    #[inline(never)]
    fn merge(
        self,
        (bytes, stride): (&mut [u8], usize),
        source: &Source,
        job: &Job,
        merged: impl Fn(u64, u64, u64) -> u64,
    ) {
        let (top, bottom) = (job.to.1, job.to.1 + job.height);
        for page in top / 8..bottom.div_ceil(8) {
            let (above, below) = (top.saturating_sub(8 * page), (8 * page + 8).saturating_sub(bottom));
            let inside = 0xFF_u8 << low_index(above) & 0xFF_u8 >> low_index(below);
            let inside = lanes(if self.pages_msb_first { inside.reverse_bits() } else { inside });
            // The row of the source that falls on the upper edge of the page, as a number that may wrap.
            let row = (8 * page + job.from.1).wrapping_sub(top);
            let start = page * stride + job.to.0;
            let line = bytes.get_mut(start..start + job.width).unwrap_or_default();
            let merged = |old, new, shown| merged(old, new, inside & shown);
            self.merge_page(line, source, (row, job.from.0 / 8), merged);
        }
    }

    /// Merges the rows of a page.
    fn merge_page(
        self,
        line: &mut [u8],
        source: &Source,
        (row, byte): (usize, usize),
        merged: impl Fn(u64, u64, u64) -> u64,
    ) {
        // So many blocks are whole when a word begins with the first pixel.
        let blocks = if self.hidden == 0 { 8 } else { 7 };
        let mut byte = byte;
        for target in line.chunks_mut(8 * blocks) {
            let tile = |memory| self.tile(memory, row, byte);
            let new = tile(source.memory);
            match source.mask {
                None => change(target, &new, repeat(u64::MAX), &merged),
                Some(mask) => {
                    let shown = tile(mask).map(|shown| shown ^ self.hole);
                    change(target, &new, shown.into_iter().rev(), &merged);
                }
            }
            byte += blocks;
        }
    }

    /// Eight rows from a byte on, as eight blocks, the rightmost first.
    fn tile(self, memory: Memory<&[u8]>, row: usize, byte: usize) -> [u64; 8] {
        let mut words = words(memory.bytes, memory.stride, row.wrapping_mul(memory.stride).wrapping_add(byte));
        if !self.rows_msb_first {
            words = words.map(|word| word.swap_bytes().reverse_bits());
        }
        if self.hidden > 0 {
            words = words.map(|word| word << self.hidden);
        }
        if self.pages_msb_first {
            words.reverse();
        }
        to_blocks(&mut words);
        words
    }
}

/// Changes up to eight blocks, the last of them first, each by what falls on it and as far as it is shown.
#[inline]
fn change(
    target: &mut [u8],
    blocks: &[u64; 8],
    shown: impl Iterator<Item = u64>,
    merged: impl Fn(u64, u64, u64) -> u64,
) {
    let mut rest = target;
    for (new, shown) in blocks.iter().rev().zip(shown) {
        if rest.len() < 8 {
            let old = load(rest);
            return store(rest, merged(old, *new, shown));
        }
        let Some((bytes, more)) = take(&mut rest).split_first_chunk_mut() else { return };
        *bytes = merged(u64::from_be_bytes(*bytes), *new, shown).to_be_bytes();
        rest = more;
    }
}

/// Eight bytes alike.
const fn lanes(byte: u8) -> u64 {
    u64::from_ne_bytes([byte; 8])
}
