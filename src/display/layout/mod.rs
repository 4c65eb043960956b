//! Layouts: where in the bytes of a frame a pixel is. This folder knows; everything else asks.
//!
//! A panel's packing is a few facts that do not depend on each other, and each is said once:
//!
//! | fact | said by |
//! |---|---|
//! | bits a pixel | the colour of the frame: `BinaryColor` 1, `Gray2` 2, `Gray4` 4, `Gray8` and `Rgb332` 8, `Rgb565` 16 |
//! | what a byte runs along | [`Rows`], [`Words`], [`Pages`], [`Columns`] or [`Planes`] |
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
//! | e-paper of three colours or four greys | `Planes` with `ThreeColor` or `Gray2` |
//! | ST7789, ILI9341 and other colour panels | `Words` with `Rgb565`, `Rows` with `Rgb332` |

mod columns;
mod fill;
mod pages;
mod planes;
mod rows;
mod words;

pub use columns::Columns;
use fill::{BitRun, merge, phase, spread};
pub use pages::Pages;
pub use planes::Planes;
pub use rows::Rows;
pub use words::Words;

use core::{
    marker::PhantomData,
    ops::{Range, RangeInclusive},
};

use crate::{
    display::{blit::Packing, region::Alike},
    num::count,
    phase::{bits_of, bits_of_bytes},
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

/// How colours `C` are packed. A pairing that no panel has does not compile:
///
/// ```compile_fail
/// use aquatint::{Frame, Pages};
/// use embedded_graphics::pixelcolor::Gray4;
/// // Pages hold one bit a pixel.
/// let frame = Frame::<Gray4, Pages, _>::with_array([0; 512], 128, 8);
/// ```
pub trait Layout<C: Copy>: sealed::Sealed + Alike<C> + Packing {
    /// How the bytes of a picture are divided.
    const SHAPE: Shape;

    /// Gives the pixels of an area the colours of their columns' phases, `colors[column & 7]`.
    ///
    /// The area is not empty and lies inside.
    fn fill(memory: Memory<&mut [u8]>, rows: Range<usize>, columns: Range<usize>, colors: [C; 8]);

    /// Gives all pixels of an area one colour. The area is not empty and lies inside.
    #[inline]
    fn fill_solid(memory: Memory<&mut [u8]>, rows: Range<usize>, columns: Range<usize>, color: C) {
        Self::fill(memory, rows, columns, [color; 8]);
    }

    /// Gives the pixels of an area the colours of a tile, `tile[row & 7][column & 7]`.
    ///
    /// The area is not empty and lies inside.
    #[inline]
    fn fill_tile(memory: Memory<&mut [u8]>, rows: Range<usize>, columns: Range<usize>, tile: &[[C; 8]; 8]) {
        let Memory { bytes, stride } = memory;
        for (row, colors) in rows.clone().zip(tile.iter().cycle().skip(rows.start & 7)) {
            Self::fill(Memory { bytes: &mut *bytes, stride }, row..row.wrapping_add(1), columns.clone(), *colors);
        }
    }

    /// Gives the pixels from a column on one colour each; `None` is skipped. They end inside.
    fn write(memory: Memory<&mut [u8]>, row: usize, column: usize, colors: impl Iterator<Item = Option<C>>);

    /// Gives the pixels of some columns of a row one of two colours that repeat every eight columns, from the highest
    /// bit on. The columns are not empty, and lie inside.
    #[inline]
    fn fill_bits((memory, row): (Memory<&mut [u8]>, usize), columns: Range<usize>, [off, on]: [C; 2], byte: u8) {
        Self::fill(memory, row..row.wrapping_add(1), columns, bits_of(byte).map(|bit| if bit { on } else { off }));
    }

    /// Gives the pixels of some columns of a row one of two colours; `next` gives a bit for each of eight columns, of
    /// which the first, in the highest bit, is the multiple of eight at or before the first column.
    ///
    /// The columns are not empty, and lie inside.
    #[inline]
    fn write_bits(
        (memory, row): (Memory<&mut [u8]>, usize),
        columns: Range<usize>,
        [off, on]: [C; 2],
        next: impl FnMut() -> u8,
    ) {
        let width = columns.end.wrapping_sub(columns.start);
        let visible = bits_of_bytes(next).skip(columns.start & 7).take(width);
        Self::write(memory, row, columns.start, visible.map(|bit| Some(if bit { on } else { off })));
    }

    /// Gives one pixel inside a colour.
    #[inline]
    fn set(memory: Memory<&mut [u8]>, row: usize, column: usize, color: C) {
        Self::write(memory, row, column, core::iter::once(Some(color)));
    }

    /// The colour of a pixel inside.
    fn read(memory: Memory<&[u8]>, row: usize, column: usize) -> Option<C>;
}

/// How the bytes of a picture are divided into lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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
        count((along as u64).saturating_mul(self.bits as u64 * self.rows_per_line as u64).div_ceil(8))
    }

    /// Lines of a picture of this size, in all planes.
    #[must_use]
    pub const fn lines(self, width: u32, height: u32) -> u64 {
        let rows = if self.rows_per_line == 0 { 1 } else { self.rows_per_line };
        let across = if self.is_vertical { width } else { height.div_ceil(rows) };
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

/// A row of a picture that is written.
pub(super) type Line<'m> = (Memory<&'m mut [u8]>, usize);

impl<'m> Memory<&'m mut [u8]> {
    /// A line of bytes, with what follows it.
    #[inline]
    fn line(self, index: usize) -> Option<&'m mut [u8]> {
        self.bytes.get_mut(index.checked_mul(self.stride)?..)
    }

    /// The bytes from one of a line on, and the distance to the one below.
    #[inline]
    fn from(self, line: usize, byte: usize) -> Option<(&'m mut [u8], usize)> {
        let start = line.wrapping_mul(self.stride).wrapping_add(byte);
        self.bytes.get_mut(start..).map(|bytes| (bytes, self.stride.max(1)))
    }

    /// Some bytes of a line.
    #[inline]
    fn run(self, line: usize, bytes: RangeInclusive<usize>) -> Option<&'m mut [u8]> {
        let start = line.wrapping_mul(self.stride);
        self.bytes.get_mut(start.wrapping_add(*bytes.start())..start.wrapping_add(*bytes.end()).wrapping_add(1))
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

    #[inline]
    fn fill(memory: Memory<&mut [u8]>, rows: Range<usize>, columns: Range<usize>, colors: [C; 8]) {
        L::fill(memory, rows, columns, colors.map(inverse));
    }

    #[inline]
    fn fill_tile(memory: Memory<&mut [u8]>, rows: Range<usize>, columns: Range<usize>, tile: &[[C; 8]; 8]) {
        L::fill_tile(memory, rows, columns, &tile.map(|colors| colors.map(inverse)));
    }

    #[inline]
    fn fill_solid(memory: Memory<&mut [u8]>, rows: Range<usize>, columns: Range<usize>, color: C) {
        L::fill_solid(memory, rows, columns, inverse(color));
    }

    #[inline]
    fn write(memory: Memory<&mut [u8]>, row: usize, column: usize, colors: impl Iterator<Item = Option<C>>) {
        L::write(memory, row, column, colors.map(|color| color.map(inverse)));
    }

    #[inline]
    fn fill_bits(line: (Memory<&mut [u8]>, usize), columns: Range<usize>, colors: [C; 2], byte: u8) {
        L::fill_bits(line, columns, colors.map(inverse), byte);
    }

    #[inline]
    fn write_bits(line: (Memory<&mut [u8]>, usize), columns: Range<usize>, colors: [C; 2], next: impl FnMut() -> u8) {
        L::write_bits(line, columns, colors.map(inverse), next);
    }

    #[inline]
    fn set(memory: Memory<&mut [u8]>, row: usize, column: usize, color: C) {
        L::set(memory, row, column, inverse(color));
    }

    fn read(memory: Memory<&[u8]>, row: usize, column: usize) -> Option<C> {
        L::read(memory, row, column).map(inverse)
    }
}

/// The colour with all bits of its code turned over.
#[inline]
fn inverse<C: Code>(color: C) -> C {
    C::from_code(!color.code())
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::MsbFirst {}
    impl Sealed for super::LsbFirst {}
    impl<O> Sealed for super::Rows<O> {}
    impl<O> Sealed for super::Pages<O> {}
    impl<O> Sealed for super::Columns<O> {}
    impl<O> Sealed for super::Planes<O> {}
    impl<O> Sealed for super::Words<O> {}
    impl<L> Sealed for super::Inverted<L> {}
}
