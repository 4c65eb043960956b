//! Rows of pixels, one after the other.

use core::{marker::PhantomData, ops::Range};

use super::{BitRun, Layout, Memory, MsbFirst, Order, Shape, fill_bytes, merge};
use crate::{
    num::{low_index, saturate_u32},
    target::Code,
};

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
    fn fill(memory: Memory<&mut [u8]>, rows: Range<usize>, columns: Range<usize>, codes: [u8; 4]) {
        let bits = C::BITS as usize;
        let pattern = repeat_over_word::<C, O>(codes);
        let (start, end) = (columns.start * bits, columns.end * bits);
        // Whole lines without gaps, all bytes alike: one block.
        if start == 0 && end == 8 * memory.stride && pattern == pattern.rotate_left(8) {
            let block = memory.bytes.get_mut(rows.start * memory.stride..rows.end * memory.stride);
            fill_bytes(block.unwrap_or_default(), pattern);
            return;
        }
        let run = BitRun::new::<O>(start..end, pattern);
        for line in memory.lines(rows) {
            run.fill(line);
        }
    }

    #[inline]
    fn write(memory: Memory<&mut [u8]>, row: usize, column: usize, codes: impl Iterator<Item = Option<u8>>) {
        let (bits, start) = (C::BITS, column * C::BITS as usize);
        let Some(window) = memory.line(row).and_then(|line| line.get_mut(start / 8..)) else { return };
        let mut bytes = window.iter_mut();
        let code_mask = 0xFF_u8 >> (8 - bits);
        // Pixels are gathered and go into a byte together: `used` bits of it are decided.
        let (mut mask, mut value, mut used) = (0_u8, 0_u8, bit_of(start));
        for code in codes {
            if let Some(code) = code {
                let shift = if O::MSB_FIRST { 8 - bits - used } else { used };
                mask |= code_mask << shift;
                value |= (code & code_mask) << shift;
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
    fn set(memory: Memory<&mut [u8]>, row: usize, column: usize, code: u8) {
        let start = column * C::BITS as usize;
        if let Some(byte) = memory.byte(row, start / 8) {
            let (shift, mask) = (shift_of::<C, O>(start), 0xFF_u8 >> (8 - C::BITS));
            merge(byte, mask << shift, (code & mask) << shift);
        }
    }

    fn read(memory: Memory<&[u8]>, row: usize, column: usize) -> Option<u8> {
        let (bits, start) = (C::BITS, column * C::BITS as usize);
        let byte = memory.line(row)?.get(start / 8)?;
        Some((byte >> shift_of::<C, O>(start)) & (0xFF >> (8 - bits)))
    }
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

/// The four codes, again and again over the bytes of a line from its left end; the big end is the first.
#[inline]
fn repeat_over_word<C: Code, O: Order>(codes: [u8; 4]) -> u32 {
    let [a, b, c, d] = codes.map(|code| u64::from(code & (0xFF >> (8 - C::BITS))));
    let bits = C::BITS;
    let join = |a: u64, b, c, d| (((((a << bits) | b) << bits) | c) << bits) | d;
    let copies = u64::from(u32::MAX) / ((1 << (4 * bits)) - 1);
    if O::MSB_FIRST {
        saturate_u32(join(a, b, c, d) * copies)
    } else {
        saturate_u32(join(d, c, b, a) * copies).swap_bytes()
    }
}
