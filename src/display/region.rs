//! Regions of frames: which of 32 pixels side by side have a colour, read by words.
//!
//! - **Takes** the bytes of a picture, a pixel, a colour.
//! - **Gives** a word, the pixel and its 31 neighbours to the right from the highest bit on.
//! - **Memory** none. **Cost** rows of one bit: four bytes and a shift; pages: 32 bytes, of which four at
//!   a time give their bit by one multiplication; other packings are read pixel by pixel.
//!
//! ```text
//!   four bytes of a page,     byte 3    byte 2    byte 1    byte 0
//!   one bit of each:          0000000d  0000000c  0000000b  0000000a
//!   × 80402010h:              abcd·····                                the four, the leftmost first
//! ```
//!
//! The multiplication adds four copies of the word, shifted so that no two bits meet: H. S. Warren,
//! *Hacker's Delight*, section 7-4 (compress by multiplication).

use embedded_graphics::{
    geometry::{OriginDimensions, Point},
    image::GetPixel,
    pixelcolor::{PixelColor, raw::RawU1, raw::RawU2},
};

use crate::{
    display::{
        frame::Frame,
        layout::{Columns, Inverted, Layout, Memory, Order, Pages, Planes, Rows, Words},
        turned::Turned,
        window::Window,
    },
    num::{bits, low_index},
    runs::{Inside, Runs, by_pixels, join},
    target::Code,
};

/// A layout that may know how to compare 32 pixels at once.
pub trait Alike<C> {
    /// Which of the 32 pixels of a row from a column on have this colour, the first in the highest bit.
    ///
    /// Bits behind the end of the row may be anything. `None`: the pixels must be read one by one.
    #[must_use]
    #[inline]
    fn alike(memory: Memory<&[u8]>, row: usize, column: usize, color: C) -> Option<u32> {
        let _ = (memory, row, column, color);
        None
    }
}

impl<C: Code, O: Order> Alike<C> for Rows<O> {
    #[inline]
    fn alike(memory: Memory<&[u8]>, row: usize, column: usize, color: C) -> Option<u32> {
        if C::BITS == 1 { Some(!(row_of_bits::<O>(memory, row, column)? ^ repeat(color.code()))) } else { None }
    }
}

impl<C: Code<Raw = RawU1>, O: Order> Alike<C> for Pages<O> {
    #[inline]
    fn alike(memory: Memory<&[u8]>, row: usize, column: usize, color: C) -> Option<u32> {
        let start = (row / 8).wrapping_mul(memory.stride).wrapping_add(column);
        let bytes = padded::<32>(memory.bytes.get(start..)?);
        let below = low_index(row) % 8;
        let shift = if O::MSB_FIRST { 7 - below } else { below };
        let ones = bytes.chunks_exact(4).fold(0, |ones, four| {
            let four = four.try_into().map_or(0, u32::from_le_bytes);
            (ones << 4) | (((four >> shift) & 0x0101_0101).wrapping_mul(0x8040_2010) >> 28)
        });
        Some(!(ones ^ repeat(color.code())))
    }
}

impl<C: Code<Raw = RawU2>, O: Order> Alike<C> for Planes<O> {
    #[inline]
    fn alike(memory: Memory<&[u8]>, row: usize, column: usize, color: C) -> Option<u32> {
        let Memory { bytes, stride } = memory;
        let (low, high) = bytes.split_at_checked(bytes.len() / 2)?;
        let ones = |bytes| row_of_bits::<O>(Memory { bytes, stride }, row, column);
        let differ = (ones(low)? ^ repeat(color.code())) | (ones(high)? ^ repeat(color.code() >> 1));
        Some(!differ)
    }
}

impl<C: Code, L: Alike<C>> Alike<C> for Inverted<L> {
    #[inline]
    fn alike(memory: Memory<&[u8]>, row: usize, column: usize, color: C) -> Option<u32> {
        L::alike(memory, row, column, C::from_code(!color.code()))
    }
}

impl<C, O: Order> Alike<C> for Columns<O> {}
impl<C, O: Order> Alike<C> for Words<O> {}

/// The 32 bits of a row from a bit on.
#[inline]
fn row_of_bits<O: Order>(memory: Memory<&[u8]>, row: usize, bit: usize) -> Option<u32> {
    let bytes = memory.bytes.get(row.wrapping_mul(memory.stride).wrapping_add(bit / 8)..)?;
    let four = padded::<4>(bytes);
    let word = if O::MSB_FIRST { u32::from_be_bytes(four) } else { u32::from_le_bytes(four).reverse_bits() };
    let shift = low_index(bit) % 8;
    if shift == 0 {
        return Some(word);
    }
    let fifth = bytes.get(4).copied().unwrap_or(0);
    let fifth = if O::MSB_FIRST { fifth } else { fifth.reverse_bits() };
    Some((word << shift) | (u32::from(fifth) >> (8 - shift)))
}

/// The first `N` bytes, with zeros behind the end.
#[inline]
fn padded<const N: usize>(bytes: &[u8]) -> [u8; N] {
    bytes.first_chunk().copied().unwrap_or_else(|| {
        let mut padded = [0; N];
        for (byte, from) in padded.iter_mut().zip(bytes) {
            *byte = *from;
        }
        padded
    })
}

/// All bits of a word as the lowest bit of a code.
#[inline]
const fn repeat(code: u8) -> u32 {
    if code & 1 == 0 { 0 } else { u32::MAX }
}

impl<C: PixelColor, L: Layout<C> + Alike<C>, B: AsRef<[u8]>> Runs for Frame<C, L, B> {
    #[inline]
    fn runs(&self, place: Point, inside: Inside<C>, seeds: u32, free: u32) -> u32 {
        let (color, turned_over) = match inside {
            Inside::Like(color) => (color, 0),
            Inside::Unlike(color) => (color, u32::MAX),
        };
        match L::alike(self.memory_ref(), bits(place.y) as usize, bits(place.x) as usize, color) {
            Some(alike) => {
                let inside = (alike ^ turned_over) & free;
                join(seeds & inside, inside)
            }
            None => by_pixels(self, place, &inside, (seeds, free)),
        }
    }
}

impl<T: GetPixel> Runs for Window<'_, T> {}

impl<D: GetPixel + OriginDimensions> Runs for Turned<'_, D> {}
