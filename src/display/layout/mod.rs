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

use crate::{
    num::{count, low_index, low_u8},
    target::Code,
};

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

    /// Gives one pixel inside a code.
    #[inline]
    fn set(memory: Memory<&mut [u8]>, row: usize, column: usize, code: u8) {
        Self::write(memory, row, column, core::iter::once(Some(code)));
    }

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

    /// A byte of a line.
    #[inline]
    fn byte(self, line: usize, byte: usize) -> Option<&'m mut u8> {
        self.bytes.get_mut(line.wrapping_mul(self.stride).wrapping_add(byte))
    }

    /// The lines of a range, the last of them with what follows it.
    #[inline]
    fn lines(self, range: Range<usize>) -> Lines<'m> {
        let bytes = self.bytes.get_mut(range.start.saturating_mul(self.stride)..).unwrap_or(&mut []);
        Lines { bytes, stride: self.stride, left: range.end.saturating_sub(range.start) }
    }
}

/// Lines of bytes, one after the other.
struct Lines<'m> {
    bytes: &'m mut [u8],
    stride: usize,
    left: usize,
}

impl<'m> Iterator for Lines<'m> {
    type Item = &'m mut [u8];

    #[inline]
    fn next(&mut self) -> Option<&'m mut [u8]> {
        self.left = self.left.checked_sub(1)?;
        let bytes = core::mem::take(&mut self.bytes);
        if self.left == 0 {
            return Some(bytes);
        }
        let (line, rest) = bytes.split_at_mut_checked(self.stride)?;
        self.bytes = rest;
        Some(line)
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

    fn set(memory: Memory<&mut [u8]>, row: usize, column: usize, code: u8) {
        L::set(memory, row, column, !code);
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

/// A run of bits that is filled in one line or in several: which bytes it touches, and how.
#[derive(Clone, Copy, Debug)]
struct BitRun {
    first: usize,
    last: usize,
    /// The bits of the first and of the last byte that are in the run.
    head: u8,
    tail: u8,
    /// Four bytes that repeat over the line, turned so that the run's first byte comes first.
    pattern: u32,
    /// What the last byte becomes.
    right: u8,
}

impl BitRun {
    /// The bits from `bits.start` up to, not including, `bits.end` of a line, counted in order `O` from its
    /// first byte; the big end of `pattern` is for bytes 0, 4, 8 … of the line.
    #[inline]
    fn new<O: Order>(bits: Range<usize>, pattern: u32) -> Self {
        let (first, last) = (bits.start / 8, bits.end.saturating_sub(1) / 8);
        let (before, after) = (low_index(bits.start) % 8, low_index(8_usize.wrapping_sub(bits.end % 8)) % 8);
        let (head, tail) =
            if O::MSB_FIRST { (0xFF_u8 >> before, 0xFF_u8 << after) } else { (0xFF_u8 << before, 0xFF_u8 >> after) };
        let from = |byte: usize| pattern.rotate_left(8 * (low_index(byte) & 3));
        Self { first, last, head, tail, pattern: from(first), right: low_u8(from(last) >> 24) }
    }

    /// Fills the run in a line.
    #[inline]
    fn fill(&self, line: &mut [u8]) {
        let left = low_u8(self.pattern >> 24);
        match line.get_mut(self.first..=self.last) {
            Some([only]) => merge(only, self.head & self.tail, left),
            Some([first, middle @ .., last]) => {
                merge(first, self.head, left);
                fill_bytes(middle, self.pattern.rotate_left(8));
                merge(last, self.tail, self.right);
            }
            _ => {}
        }
    }
}

/// Fills whole bytes with four that repeat, the big end first.
#[inline]
fn fill_bytes(bytes: &mut [u8], pattern: u32) {
    let four = pattern.to_be_bytes();
    // The call of a block fill pays from some words on.
    if bytes.len() >= 32 && pattern == pattern.rotate_left(8) {
        bytes.fill(four[0]);
        return;
    }
    let mut words = bytes.chunks_exact_mut(4);
    for word in &mut words {
        for (byte, value) in word.iter_mut().zip(four) {
            *byte = value;
        }
    }
    for (byte, value) in words.into_remainder().iter_mut().zip(four) {
        *byte = value;
    }
}

/// All eight bits of a byte as the lowest bit of a code.
#[inline]
const fn spread(code: u8) -> u8 {
    if code & 1 == 0 { 0 } else { 0xFF }
}
