//! Layouts: where in the bytes of a frame a pixel is. One file knows; everything else asks.
//!
//! A frame is a number of *lines* of bytes. In [`Rows`] a line is a row of pixels; in [`Pages`] it
//! is eight rows, because a byte holds eight pixels one above the other.
//!
//! ```text
//!   Rows, 1 bit         byte 0          byte 1         Pages        byte 0  byte 1  byte 2
//!             bit  7 6 5 4 3 2 1 0  7 6 5 …                 bit 0     ·       ·       ·   row 0
//!           row 0  · · · · · · · ·  · · ·                   bit 1     ·       ·       ·   row 1
//!           row 1  · · · · · · · ·  · · ·                     ⋮       ⋮       ⋮       ⋮    ⋮
//!                  x = 0 …             8 …                  bit 7     ·       ·       ·   row 7
//!                                                                   x = 0     1       2
//! ```

use core::ops::Range;

use crate::{num::low_index, target::Code};

/// Rows of pixels, the leftmost in the most significant bits, each row padded to whole bytes.
///
/// Sharp memory LCDs, most e-paper and ST7920 at 1 bit; SSD1322, SSD1327, SSD0323 at 4 bits (the
/// left pixel in the high nibble).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rows {}

/// Pages of eight rows: a byte is eight pixels one above the other, the lowest bit on top; bytes run
/// along x. SSD1306, SH1106, ST7565, PCD8544.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pages {}

/// How codes of the colour `C` are packed. A pairing that no panel has does not compile:
///
/// ```compile_fail
/// use aquatint::{Frame, Pages};
/// use embedded_graphics::pixelcolor::Gray4;
/// // Pages hold one bit a pixel.
/// let frame = Frame::<Gray4, Pages, _>::with_array([0; 512], 128, 8);
/// ```
pub trait Layout<C: Code>: sealed::Sealed {
    /// Rows of pixels in a line of bytes.
    const ROWS_PER_LINE: u32;

    /// Gives the pixels of `columns` the codes of their phase, `codes[column & 3]`.
    ///
    /// `rows` has a bit set for each row of the line that is meant. `columns` is not empty and lies
    /// within the line.
    fn fill(line: &mut [u8], columns: Range<usize>, rows: u8, codes: [u8; 4]);

    /// Gives the pixels from `column` on one code each, in one row of the line; `None` is skipped.
    fn write(line: &mut [u8], column: usize, rows: u8, codes: impl Iterator<Item = Option<u8>>);

    /// The code of a pixel.
    fn read(line: &[u8], column: usize, rows: u8) -> Option<u8>;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::Rows {}
    impl Sealed for super::Pages {}
}

/// Replaces the bits of `byte` that `mask` selects.
#[inline]
fn merge(byte: &mut u8, mask: u8, value: u8) {
    *byte ^= (*byte ^ value) & mask;
}

impl<C: Code> Layout<C> for Rows {
    const ROWS_PER_LINE: u32 = 1;

    fn fill(line: &mut [u8], columns: Range<usize>, _rows: u8, codes: [u8; 4]) {
        let bits = C::BITS as usize;
        let (start, end) = (columns.start * bits, columns.end * bits);
        let (first, last) = (start / 8, end.saturating_sub(1) / 8);
        let head = 0xFF_u8 >> (start % 8);
        let tail = 0xFF_u8 << ((8 - end % 8) % 8);
        let pattern = repeat_over_word::<C>(codes);
        let byte = |index: usize| phase(pattern, index);
        let Some(window) = line.get_mut(first..=last) else { return };
        match window {
            [] => {}
            [only] => merge(only, head & tail, byte(first)),
            [left, middle @ .., right] => {
                merge(left, head, byte(first));
                fill_bytes(middle, [byte(first + 1), byte(first + 2), byte(first + 3), byte(first + 4)]);
                merge(right, tail, byte(last));
            }
        }
    }

    fn write(line: &mut [u8], column: usize, _rows: u8, codes: impl Iterator<Item = Option<u8>>) {
        let (bits, start) = (C::BITS, column * C::BITS as usize);
        let Some(window) = line.get_mut(start / 8..) else { return };
        let mut bytes = window.iter_mut();
        let code_mask = 0xFF_u8 >> (8 - bits);
        let mut shift = 8 - bits - bit_of(start);
        // Pixels are gathered and go into a byte together.
        let (mut mask, mut value) = (0_u8, 0_u8);
        for code in codes {
            if let Some(code) = code {
                mask |= code_mask << shift;
                value |= (code & code_mask) << shift;
            }
            if shift >= bits {
                shift -= bits;
                continue;
            }
            let Some(byte) = bytes.next() else { return };
            merge(byte, mask, value);
            (mask, value, shift) = (0, 0, 8 - bits);
        }
        if let Some(byte) = bytes.next() {
            merge(byte, mask, value);
        }
    }

    fn read(line: &[u8], column: usize, _rows: u8) -> Option<u8> {
        let (bits, start) = (C::BITS, column * C::BITS as usize);
        let byte = line.get(start / 8)?;
        Some((byte >> (8 - bits - bit_of(start))) & (0xFF >> (8 - bits)))
    }
}

/// The bit within its byte, counted from the most significant one.
#[inline]
const fn bit_of(position: usize) -> u32 {
    low_index(position) % 8
}

/// The four codes, again and again over 32 bits: the bytes of a line from its left end.
#[inline]
fn repeat_over_word<C: Code>(codes: [u8; 4]) -> [u8; 4] {
    let mask = 0xFF_u8 >> (8 - C::BITS);
    let four = codes.into_iter().fold(0_u64, |four, code| (four << C::BITS) | u64::from(code & mask));
    let copies = u64::from(u32::MAX) / ((1 << (4 * C::BITS)) - 1);
    crate::num::saturate_u32(four * copies).to_be_bytes()
}

#[inline]
fn phase(four: [u8; 4], index: usize) -> u8 {
    let [a, b, c, d] = four;
    match index & 3 {
        0 => a,
        1 => b,
        2 => c,
        _ => d,
    }
}

/// Fills whole bytes with four that repeat.
fn fill_bytes(bytes: &mut [u8], four: [u8; 4]) {
    if four == [four[0]; 4] {
        bytes.fill(four[0]);
        return;
    }
    for chunk in bytes.chunks_mut(4) {
        for (byte, value) in chunk.iter_mut().zip(four) {
            *byte = value;
        }
    }
}

impl<C: Code<Raw = embedded_graphics::pixelcolor::raw::RawU1>> Layout<C> for Pages {
    const ROWS_PER_LINE: u32 = 8;

    fn fill(line: &mut [u8], columns: Range<usize>, rows: u8, codes: [u8; 4]) {
        let first = columns.start;
        let Some(window) = line.get_mut(columns) else { return };
        match codes.map(|code| code & 1) {
            [0, 0, 0, 0] => window.iter_mut().for_each(|byte| *byte &= !rows),
            [1, 1, 1, 1] => window.iter_mut().for_each(|byte| *byte |= rows),
            codes => {
                for (index, byte) in (first..).zip(window) {
                    merge(byte, rows, if phase(codes, index) == 0 { 0 } else { 0xFF });
                }
            }
        }
    }

    fn write(line: &mut [u8], column: usize, rows: u8, codes: impl Iterator<Item = Option<u8>>) {
        let Some(window) = line.get_mut(column..) else { return };
        for (byte, code) in window.iter_mut().zip(codes) {
            if let Some(code) = code {
                merge(byte, rows, if code & 1 == 0 { 0 } else { 0xFF });
            }
        }
    }

    fn read(line: &[u8], column: usize, rows: u8) -> Option<u8> {
        line.get(column).map(|byte| u8::from(byte & rows != 0))
    }
}
