//! Rows of pixels, one after the other.

use core::{marker::PhantomData, ops::Range};

use super::{BitRun, Layout, Memory, MsbFirst, Order, Shape, merge};
use crate::{num::low_index, phase::bits_of_bytes, target::Code};

/// Rows of pixels from the left, each row padded to whole bytes; 1, 2, 4 or 8 bits a pixel.
///
/// ```text
///                byte 0          byte 1
///   bit       7 6 5 4 3 2 1 0  7 6 5 …    MsbFirst, 1 bit; LsbFirst counts the bits from 0
///   row 0     · · · · · · · ·  · · ·
///   row 1     · · · · · · · ·  · · ·
///             x = 0 …          8 …
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rows<O = MsbFirst>(PhantomData<O>);

impl<C: Code, O: Order> Layout<C> for Rows<O> {
    const SHAPE: Shape = Shape { is_vertical: false, rows_per_line: 1, bits: C::BITS, planes: 1 };

    #[inline]
    fn fill(memory: Memory<&mut [u8]>, rows: Range<usize>, columns: Range<usize>, colors: [C; 8]) {
        let pattern = repeat_over_word::<C, O>(colors.map(C::code));
        BitRun::new::<O>(bits_of::<C>(columns)).fill(memory, rows, pattern);
    }

    #[inline]
    fn fill_solid(memory: Memory<&mut [u8]>, rows: Range<usize>, columns: Range<usize>, color: C) {
        let (bits, value) = (bits_of::<C>(columns), repeat::<C>(color));
        if rows.end.wrapping_sub(rows.start) == 1 {
            BitRun::new::<O>(bits).fill_one(memory, rows.start, value);
        } else {
            fill_rows::<O>(memory, rows, bits, value);
        }
    }

    fn fill_tile(memory: Memory<&mut [u8]>, rows: Range<usize>, columns: Range<usize>, tile: &[[C; 8]; 8]) {
        let Memory { bytes, stride } = memory;
        let run = BitRun::new::<O>(bits_of::<C>(columns));
        let [a, b, c, d, lower @ ..] = tile;
        // Every eighth row has the same pattern, or every fourth: a 4 × 4 dither.
        let shift = if [a, b, c, d] == lower.each_ref() { 2 } else { 3 };
        let period = 1 << shift;
        let left = rows.end.wrapping_sub(rows.start).wrapping_add(period - 1);
        for (place, colors) in tile.iter().cycle().skip(rows.start & 7).take(period).enumerate() {
            let pattern = repeat_over_word::<C, O>(colors.map(C::code));
            let bytes = bytes.get_mut(rows.start.wrapping_add(place).wrapping_mul(stride)..).unwrap_or_default();
            let lines = left.saturating_sub(place) >> shift;
            run.fill(Memory { bytes, stride: stride << shift }, 0..lines, pattern);
        }
    }

    #[inline]
    fn write(memory: Memory<&mut [u8]>, row: usize, column: usize, colors: impl Iterator<Item = Option<C>>) {
        let (bits, start) = (C::BITS, column * C::BITS as usize);
        let Some(window) = memory.line(row).and_then(|line| line.get_mut(start / 8..)) else { return };
        let mut bytes = window.iter_mut();
        // Pixels are gathered and go into a byte together: `used` bits of it are decided.
        let (mut mask, mut value, mut used) = (0_u8, 0_u8, bit_of(start));
        for color in colors {
            if let Some(color) = color {
                let shift = if O::MSB_FIRST { 8 - bits - used } else { used };
                mask |= code_mask::<C>() << shift;
                value |= (color.code() & code_mask::<C>()) << shift;
            }
            used += bits;
            if used == 8 {
                let Some(byte) = bytes.next() else { return };
                merge(byte, mask, value);
                (mask, value, used) = (0, 0, 0);
            }
        }
        // With nothing gathered, nothing is changed.
        if let Some(byte) = bytes.next() {
            merge(byte, mask, value);
        }
    }

    #[inline]
    fn fill_bits((memory, row): (Memory<&mut [u8]>, usize), columns: Range<usize>, [off, on]: [C; 2], byte: u8) {
        if C::BITS == 1 {
            let (off, on) = (repeat::<C>(off), repeat::<C>(on));
            let bits = if O::MSB_FIRST { byte } else { byte.reverse_bits() };
            BitRun::new::<O>(columns).fill_one(memory, row, off ^ (bits & (off ^ on)));
        } else {
            let colors = crate::phase::bits_of(byte).map(|bit| if bit { on } else { off });
            Self::fill(memory, row..row.wrapping_add(1), columns, colors);
        }
    }

    #[inline]
    fn write_bits(
        (memory, row): (Memory<&mut [u8]>, usize),
        columns: Range<usize>,
        [off, on]: [C; 2],
        mut next: impl FnMut() -> u8,
    ) {
        if C::BITS == 1 {
            let (off, differ) = (repeat::<C>(off), repeat::<C>(off) ^ repeat::<C>(on));
            BitRun::new::<O>(columns).write(memory, row, || {
                let bits = if O::MSB_FIRST { next() } else { next().reverse_bits() };
                off ^ (bits & differ)
            });
            return;
        }
        let width = columns.end.wrapping_sub(columns.start);
        let visible = bits_of_bytes(next).skip(columns.start & 7).take(width);
        Self::write(memory, row, columns.start, visible.map(|bit| Some(if bit { on } else { off })));
    }

    #[inline]
    fn set(memory: Memory<&mut [u8]>, row: usize, column: usize, color: C) {
        let start = column * C::BITS as usize;
        if let Some(byte) = memory.byte(row, start / 8) {
            merge(byte, code_mask::<C>() << shift_of::<C, O>(start), repeat::<C>(color));
        }
    }

    #[inline]
    fn read(memory: Memory<&[u8]>, row: usize, column: usize) -> Option<C> {
        let start = column * C::BITS as usize;
        let byte = memory.line(row)?.get(start / 8)?;
        Some(C::from_code((byte >> shift_of::<C, O>(start)) & code_mask::<C>()))
    }
}

/// Several rows; out of the way of spans, which are one row each.
#[inline(never)]
fn fill_rows<O: Order>(memory: Memory<&mut [u8]>, rows: Range<usize>, bits: Range<usize>, value: u8) {
    if bits.start == 0 && bits.end == memory.stride.wrapping_mul(8) {
        // Whole rows without gaps: one block.
        let block = rows.start.wrapping_mul(memory.stride)..rows.end.wrapping_mul(memory.stride);
        memory.bytes.get_mut(block).unwrap_or_default().fill(value);
    } else {
        BitRun::new::<O>(bits).fill_solid(memory, rows, value);
    }
}

/// The bits of a line that hold some columns.
#[inline]
const fn bits_of<C: Code>(columns: Range<usize>) -> Range<usize> {
    columns.start.wrapping_mul(C::BITS as usize)..columns.end.wrapping_mul(C::BITS as usize)
}

/// As many ones as a code has bits.
#[inline]
const fn code_mask<C: Code>() -> u8 {
    0xFF >> (8 - C::BITS)
}

/// A byte of pixels of one colour.
#[inline]
fn repeat<C: Code>(color: C) -> u8 {
    (color.code() & code_mask::<C>()) * (0xFF / code_mask::<C>())
}

/// The bit within its byte, counted from the first one.
#[inline]
const fn bit_of(position: usize) -> u32 {
    low_index(position) % 8
}

/// How far from the lowest bit of its byte a pixel is that begins at a bit of its line.
#[inline]
const fn shift_of<C: Code, O: Order>(start: usize) -> u32 {
    if O::MSB_FIRST { 8 - C::BITS - bit_of(start) } else { bit_of(start) }
}

/// Eight codes, again and again over the bytes of a line from its left end; the big end is the first.
#[inline]
fn repeat_over_word<C: Code, O: Order>(codes: [u8; 8]) -> u64 {
    let bits = C::BITS;
    let join = |word: u64, code: u8| (word << bits) | u64::from(code & code_mask::<C>());
    let copies = u64::MAX / (u64::MAX >> (64 - 8 * bits));
    if O::MSB_FIRST {
        codes.into_iter().fold(0, join) * copies
    } else {
        (codes.into_iter().rev().fold(0, join) * copies).swap_bytes()
    }
}
