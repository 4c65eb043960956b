//! Layouts: where in the bytes of a frame a pixel is. This folder knows; everything else asks.
//!
//! A panel's packing is a few facts that do not depend on each other, and each is said once:
//!
//! | fact | said by |
//! |---|---|
//! | bits a pixel | the colour of the frame: `BinaryColor` 1, `Gray2` 2, `Gray4` 4, `Gray8` 8 |
//! | what a byte runs along | [`Rows`], [`Pages`], [`Columns`] or [`Planes`] |
//! | which end of a byte comes first | [`MsbFirst`] or [`LsbFirst`] |
//! | whether 1 is light or ink | [`Inverted`] |
//! | bytes around the lines | [`Spacing`](crate::display::frame::Spacing) |
//!
//! | panels | layout |
//! |---|---|
//! | SSD1306, SH1106, ST7565, PCD8544 | `Pages` |
//! | Sharp memory LCD, ST7920, e-paper of two colours | `Rows` |
//! | SSD1322, SSD1327, SSD0323 | `Rows` with `Gray4`: the left pixel in the high nibble |
//! | UC8151 (Badger 2040) | `Columns` |
//! | e-paper of three colours or four greys | `Planes` |

mod columns;
mod pages;
mod planes;
mod rows;

pub use columns::Columns;
pub use pages::Pages;
pub use planes::Planes;
pub use rows::Rows;

use core::{marker::PhantomData, ops::Range};

use crate::{num::count, target::Code};

/// Which end of a byte holds the first of its pixels.
pub trait Order: sealed::Sealed {
    /// Whether the most significant bits come first.
    const MSB_FIRST: bool;
}

/// The leftmost or topmost pixel is in the most significant bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MsbFirst {}

/// The leftmost or topmost pixel is in the least significant bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LsbFirst {}

impl Order for MsbFirst {
    const MSB_FIRST: bool = true;
}

impl Order for LsbFirst {
    const MSB_FIRST: bool = false;
}

/// How codes of the colour `C` are packed. A pairing that no panel has does not compile:
///
/// ```compile_fail
/// use aquatint::{Frame, Pages};
/// use embedded_graphics::pixelcolor::Gray4;
/// // Pages hold one bit a pixel.
/// let frame = Frame::<Gray4, Pages, _>::with_array([0; 512], 128, 8);
/// ```
pub trait Layout<C: Code>: sealed::Sealed {
    /// How the bytes of a picture are divided.
    const SHAPE: Shape;

    /// Gives the pixels of an area the codes of their columns' phases, `codes[column & 3]`.
    ///
    /// The area is not empty and lies inside.
    fn fill(memory: Memory<&mut [u8]>, rows: Range<usize>, columns: Range<usize>, codes: [u8; 4]);

    /// Gives the pixels from a column on one code each; `None` is skipped. They end inside.
    fn write(memory: Memory<&mut [u8]>, row: usize, column: usize, codes: impl Iterator<Item = Option<u8>>);

    /// The code of a pixel inside.
    fn read(memory: Memory<&[u8]>, row: usize, column: usize) -> Option<u8>;
}

/// How the bytes of a picture are divided into lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shape {
    /// Whether a line of bytes runs down the picture instead of across.
    pub is_vertical: bool,
    /// Rows of pixels in a line that runs across: 1, or 8 in pages.
    pub rows_per_line: u32,
    /// Bits of a pixel in a line.
    pub bits: u32,
    /// How often the picture is stored, a bit of each code a time.
    pub planes: u32,
}

impl Shape {
    /// Bytes in a line of a picture of this size.
    #[must_use]
    pub const fn stride(self, width: u32, height: u32) -> usize {
        let along = if self.is_vertical { height } else { width };
        count((along as u64 * (self.bits * self.rows_per_line) as u64).div_ceil(8))
    }

    /// Lines of a picture of this size, in all planes.
    #[must_use]
    pub const fn lines(self, width: u32, height: u32) -> u64 {
        let across = if self.is_vertical { width } else { height.div_ceil(self.rows_per_line) };
        across as u64 * self.planes as u64
    }
}

/// The bytes of a picture, from the first byte of its first line on.
#[derive(Clone, Copy, Debug)]
pub struct Memory<B> {
    /// All lines and what is between them.
    pub bytes: B,
    /// Bytes from the beginning of a line to the beginning of the next.
    pub stride: usize,
}

impl<'m> Memory<&'m mut [u8]> {
    /// A line of bytes, with what follows it.
    #[inline]
    fn line(self, index: usize) -> Option<&'m mut [u8]> {
        self.bytes.get_mut(index.checked_mul(self.stride)?..)
    }

    /// The lines from one on.
    #[inline]
    fn lines(self, range: Range<usize>) -> impl Iterator<Item = &'m mut [u8]> {
        let start = range.start.saturating_mul(self.stride);
        let bytes = self.bytes.get_mut(start..).unwrap_or(&mut []);
        bytes.chunks_mut(self.stride.max(1)).take(range.end.saturating_sub(range.start))
    }
}

impl<'m> Memory<&'m [u8]> {
    /// A line of bytes, with what follows it.
    fn line(self, index: usize) -> Option<&'m [u8]> {
        self.bytes.get(index.checked_mul(self.stride)?..)
    }
}

/// The layout `L` with every bit turned over: for panels on which `BinaryColor::On` is to be a 0,
/// such as ink on e-paper whose controller takes 1 for white.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Inverted<L>(PhantomData<L>);

impl<C: Code, L: Layout<C>> Layout<C> for Inverted<L> {
    const SHAPE: Shape = L::SHAPE;

    fn fill(memory: Memory<&mut [u8]>, rows: Range<usize>, columns: Range<usize>, codes: [u8; 4]) {
        L::fill(memory, rows, columns, codes.map(|code| !code));
    }

    fn write(memory: Memory<&mut [u8]>, row: usize, column: usize, codes: impl Iterator<Item = Option<u8>>) {
        L::write(memory, row, column, codes.map(|code| code.map(|code| !code)));
    }

    fn read(memory: Memory<&[u8]>, row: usize, column: usize) -> Option<u8> {
        L::read(memory, row, column).map(|code| !code & (0xFF >> (8 - C::BITS)))
    }
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::MsbFirst {}
    impl Sealed for super::LsbFirst {}
    impl<O> Sealed for super::Rows<O> {}
    impl<O> Sealed for super::Pages<O> {}
    impl<O> Sealed for super::Columns<O> {}
    impl<O> Sealed for super::Planes<O> {}
    impl<L> Sealed for super::Inverted<L> {}
}

/// Replaces the bits of `byte` that `mask` selects.
#[inline]
const fn merge(byte: &mut u8, mask: u8, value: u8) {
    *byte ^= (*byte ^ value) & mask;
}

/// The one of four that a column has.
#[inline]
const fn phase(four: [u8; 4], index: usize) -> u8 {
    let [a, b, c, d] = four;
    match index & 3 {
        0 => a,
        1 => b,
        2 => c,
        _ => d,
    }
}

/// Replaces the bits from `bits.start` up to, not including, `bits.end` of a line, counted in order `O`
/// from its first byte, by those of four bytes that repeat over the line.
#[inline]
fn fill_bits<O: Order>(line: &mut [u8], bits: Range<usize>, pattern: [u8; 4]) {
    let (first, last) = (bits.start / 8, bits.end.saturating_sub(1) / 8);
    let (before, after) = (bits.start % 8, (8 - bits.end % 8) % 8);
    let (head, tail) =
        if O::MSB_FIRST { (0xFF_u8 >> before, 0xFF_u8 << after) } else { (0xFF_u8 << before, 0xFF_u8 >> after) };
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

/// Fills whole bytes with four that repeat.
#[inline]
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

/// All eight bits of a byte as the lowest bit of a code.
#[inline]
const fn spread(code: u8) -> u8 {
    if code & 1 == 0 { 0 } else { 0xFF }
}
