//! Codes to bits: a compare a pixel, eight pixels at a time.
//!
//! Whether a pixel is on depends on its code and on its place only, and brighter codes never switch it off. So each
//! cell of a mask has one *switch code*, the least code that is on. It is computed once, decoding included; then
//! nothing is left to do for a pixel but to compare, and eight bytes are compared as one number.
//!
//! ```text
//!   codes of the picture   50  86 111 128 …         │ 4 × 4, sRGB:  50 193 111 212 │
//!                          ≥   <   ≥   <            │              229 145 245 159 │
//!   bits of the frame      1   0   1   0  …         │  …                           │
//! ```
//!
//! - **Takes** rows of 8-bit codes: sRGB greys, or codes of any other curve.
//! - **Gives** bits, the same as decoding and comparing with the mask's thresholds in light.
//! - **Memory** a byte a cell, in flash if the table is a constant.
//! - **Cost** about three instructions a pixel into rows; into other layouts what
//!   [`write_run`](Target::write_run) takes.

use embedded_graphics::{
    geometry::Point,
    pixelcolor::{BinaryColor, raw::RawU1},
};

use super::{Mask, RankMask, rank::Cells};
use crate::{
    colour::Light,
    display::{
        frame::Frame,
        layout::{Inverted, Layout, Memory, Order, Rows},
    },
    num::{count_i32, index, low_u8},
    target::{Code, Target},
};

/// The least code that is on, for each cell of a mask of `W` × `H`.
///
/// ```
/// use aquatint::{BAYER_4X4, CodeMask, Frame, Rows};
/// use embedded_graphics::{geometry::Point, pixelcolor::BinaryColor};
///
/// // In flash.
/// static MASK: CodeMask<4, 4> = CodeMask::srgb(&BAYER_4X4);
///
/// let photo = [188; 16 * 4]; // half of the light
/// let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 8], 16, 4).unwrap();
/// for (y, codes) in (0..).zip(photo.chunks(16)) {
///     MASK.write_rows(&mut frame, Point::new(0, y), codes);
/// }
/// assert_eq!(frame.bytes()[..4], [0b1010_1010, 0b1010_1010, 0b0101_0101, 0b0101_0101]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CodeMask<const W: usize, const H: usize> {
    cells: [[u8; W]; H],
}

impl<const W: usize, const H: usize> CodeMask<W, H> {
    /// For greys in sRGB, as picture files have them: right in light.
    #[must_use]
    pub const fn srgb(mask: &RankMask<'_, W, H>) -> Self {
        let (mut lights, mut code) = ([0; 256], 0_u8);
        loop {
            lights[code as usize] = Light::from_srgb(code).0;
            if code == 255 {
                return Self::with_curve(mask, &lights);
            }
            code += 1;
        }
    }

    /// For codes that are amounts of light already. **Naive** for pictures: they come out too bright, by a fifth of
    /// the range on average.
    #[must_use]
    pub const fn naive(mask: &RankMask<'_, W, H>) -> Self {
        let (mut lights, mut code) = ([0; 256], 0_u8);
        loop {
            lights[code as usize] = Light::naive_from_code(code).0;
            if code == 255 {
                return Self::with_curve(mask, &lights);
            }
            code += 1;
        }
    }

    /// For codes of any curve, given as the light of each; it should not fall. Code 0 is black and code 255 white,
    /// whatever their lights are.
    #[must_use]
    pub const fn with_curve(mask: &RankMask<'_, W, H>, lights: &[u16; 256]) -> Self {
        Self::with_thresholds(&mask.thresholds(), lights)
    }

    /// For the cells from the corner of the screen on of a mask that is computed.
    #[must_use]
    pub fn of_mask(mask: &impl Mask, lights: &[u16; 256]) -> Self {
        let (mut thresholds, mut y) = ([[0; W]; H], 0);
        for row in &mut thresholds {
            row.iter_mut().zip(mask.row(y, 0)).for_each(|(place, threshold)| *place = threshold);
            y += 1;
        }
        Self::with_thresholds(&thresholds, lights)
    }

    const fn with_thresholds(thresholds: &[[u16; W]; H], lights: &[u16; 256]) -> Self {
        let (mut cells, mut y) = ([[0; W]; H], 0);
        while y < H {
            let mut x = 0;
            while x < W {
                cells[y][x] = switch_code(thresholds[y][x], lights);
                x += 1;
            }
            y += 1;
        }
        Self { cells }
    }

    /// The least code that is on, at each cell, row by row. 1 to 255.
    #[must_use]
    pub const fn switch_codes(&self) -> &[[u8; W]; H] {
        &self.cells
    }

    /// Dithers a row of codes, its first pixel at `at`, into a frame of rows. What is outside is not drawn.
    pub fn write_rows<C, L, B>(&self, frame: &mut Frame<C, L, B>, at: Point, codes: &[u8])
    where
        C: Code<Raw = RawU1>,
        L: PackedRows + Layout<C>,
        B: AsMut<[u8]>,
    {
        let columns = at.x..at.x.saturating_add(count_i32(codes.len()));
        let Some(visible) = frame.bounds().clip_run(at.y, columns) else { return };
        let hidden = index(visible.start.saturating_sub(at.x));
        let codes = codes.get(hidden..).and_then(|codes| codes.get(..visible.len()));
        let (start, Memory { bytes, stride }) = (index(visible.start), frame.memory_mut());
        let bytes = bytes.get_mut(index(at.y).wrapping_mul(stride).wrapping_add(start / 8)..);
        if let (Some(codes), Some(bytes), Some(cells)) = (codes, bytes, cells_of(&self.cells, at.y)) {
            pack::<L, W>(Groups::new(cells, start), codes, bytes);
        }
    }

    /// Dithers a row of codes, its first pixel at `at`, onto any target of one bit.
    ///
    /// # Errors
    /// What the display behind says.
    pub fn write_run<T: Target>(&self, target: &mut T, at: Point, codes: &[u8]) -> Result<(), T::Error>
    where
        T::Color: From<BinaryColor>,
    {
        let columns = at.x..at.x.saturating_add(count_i32(codes.len()));
        let Some(cells) = cells_of(&self.cells, at.y) else { return Ok(()) };
        let bits = codes.iter().zip(Cells::new(cells, at.x)).map(|(code, switch)| BinaryColor::from(*code >= switch));
        target.write_run(at.y, columns, bits.map(|bit| Some(bit.into())))
    }
}

/// The row of cells for a row of the screen.
#[inline]
fn cells_of<const W: usize, const H: usize>(cells: &[[u8; W]; H], row: i32) -> Option<&[u8; W]> {
    cells.get(index(row.checked_rem_euclid(count_i32(H))?))
}

/// The least code whose light exceeds a threshold between black and white.
const fn switch_code(threshold: u16, lights: &[u16; 256]) -> u8 {
    let light = (0xFFFF * threshold as u32) >> 16;
    let (mut off, mut on) = (0_u8, 255_u8);
    while on - off > 1 {
        let middle = off + (on - off) / 2;
        if lights[middle as usize] as u32 > light {
            on = middle;
        } else {
            off = middle;
        }
    }
    on
}

/// Rows of one bit a pixel: the layouts that bits are written into eight at a time.
pub trait PackedRows: sealed::Sealed {
    /// Whether the leftmost pixel is in the most significant bit.
    const MSB_FIRST: bool;
    /// Whether white is 0.
    const IS_INVERTED: bool;
}

impl<O: Order> PackedRows for Rows<O> {
    const MSB_FIRST: bool = O::MSB_FIRST;
    const IS_INVERTED: bool = false;
}

impl<L: PackedRows> PackedRows for Inverted<L> {
    const MSB_FIRST: bool = L::MSB_FIRST;
    const IS_INVERTED: bool = !L::IS_INVERTED;
}

mod sealed {
    use super::{Inverted, Rows};

    pub trait Sealed {}
    impl<O> Sealed for Rows<O> {}
    impl<L: Sealed> Sealed for Inverted<L> {}
}

/// Writes a row of codes as bits, from the byte on that holds the first of them.
#[inline]
fn pack<L: PackedRows, const W: usize>(mut groups: Groups<W>, codes: &[u8], bytes: &mut [u8]) {
    let mut bytes = bytes.iter_mut();
    let before = groups.before;
    // The pixels up to the next whole byte.
    let (head, rest) = codes.split_at_checked((8 - before) & 7).unwrap_or((codes, &[]));
    if !head.is_empty() {
        write_part::<L>(bytes.next(), groups.next(), (before, head));
    }
    let mut eights = rest.chunks_exact(8);
    for (eight, byte) in eights.by_ref().zip(bytes.by_ref()) {
        let codes = eight.first_chunk().copied().unwrap_or_default();
        *byte = bits::<L>(codes, groups.next());
    }
    let tail = eights.remainder();
    if !tail.is_empty() {
        write_part::<L>(bytes.next(), groups.next(), (0, tail));
    }
}

/// Writes less than eight pixels, behind some that stay.
fn write_part<L: PackedRows>(byte: Option<&mut u8>, switch: Switches, (before, codes): (usize, &[u8])) {
    let mut eight = [0; 8];
    let places = eight.iter_mut().skip(before);
    places.zip(codes).for_each(|(place, code)| *place = *code);
    let drawn = low_u8((0xFF_u32 >> before) & !(0xFF_u32 >> (before + codes.len())));
    let drawn = if L::MSB_FIRST { drawn } else { drawn.reverse_bits() };
    if let Some(byte) = byte {
        *byte ^= (*byte ^ bits::<L>(eight, switch)) & drawn;
    }
}

/// The highest bit of each of eight bytes.
const HIGH: u64 = 0x8080_8080_8080_8080;

/// Eight switch codes as one number, split for the comparison.
#[derive(Clone, Copy, Debug)]
struct Switches {
    /// All bits but the highest of each byte.
    low: u64,
    /// The highest bits turned over.
    not_high: u64,
}

impl Switches {
    #[inline]
    const fn new(codes: [u8; 8]) -> Self {
        let all = u64::from_le_bytes(codes);
        Self { low: all & !HIGH, not_high: !all & HIGH }
    }
}

/// Eight pixels as bits: which codes are not less than their switch code.
#[inline]
fn bits<L: PackedRows>(codes: [u8; 8], switches: Switches) -> u8 {
    let codes = u64::from_le_bytes(codes);
    // The highest bit of each byte stays set where the low seven bits are not less. No byte borrows from the next.
    let not_less = (codes | HIGH) - switches.low;
    // Of the highest bits themselves: 1 against 0 is greater, equal ones leave it to the others.
    let is_on = (codes & switches.not_high) | ((codes | switches.not_high) & not_less);
    let bits = if usize::BITS < 64 { gathered_32::<L>(is_on) } else { gathered_64::<L>(is_on) };
    if L::IS_INVERTED { !bits } else { bits }
}

/// The highest bits of eight bytes together, by one product: it moves each to its place, and no two meet.
#[inline]
const fn gathered_64<L: PackedRows>(bytes: u64) -> u8 {
    let places = if L::MSB_FIRST { 0x8040_2010_0804_0201 } else { 0x0102_0408_1020_4080 };
    low_u8(high_half((bytes >> 7 & 0x0101_0101_0101_0101).wrapping_mul(places)) >> 24)
}

/// The same in two halves, for cores of 32 bits.
#[inline]
const fn gathered_32<L: PackedRows>(bytes: u64) -> u8 {
    let places = if L::MSB_FIRST { 0x8040_2010 } else { 0x1020_4080 };
    let first = (low_half(bytes) >> 7 & 0x0101_0101_u32).wrapping_mul(places) >> 28;
    let second = (high_half(bytes) >> 7 & 0x0101_0101_u32).wrapping_mul(places) >> 28;
    if L::MSB_FIRST { low_u8(first << 4 | second) } else { low_u8(second << 4 | first) }
}

/// Eight switch codes after the other.
#[derive(Clone, Copy, Debug)]
struct Groups<'c, const W: usize> {
    cells: &'c [u8; W],
    at: usize,
    /// Pixels of the first byte that are before the run.
    before: usize,
    /// The only group of a mask that repeats in eight columns.
    only: Switches,
}

impl<'c, const W: usize> Groups<'c, W> {
    /// From the byte on that holds a column.
    #[inline]
    fn new(cells: &'c [u8; W], column: usize) -> Self {
        let before = column % 8;
        let at = column.wrapping_sub(before).checked_rem(W).unwrap_or(0);
        let only = [0, 1, 2, 3, 4, 5, 6, 7_usize].map(|at| cells.get(at.checked_rem(W)?).copied());
        Self { cells, at, before, only: Switches::new(only.map(Option::unwrap_or_default)) }
    }

    #[inline]
    fn next(&mut self) -> Switches {
        if W > 0 && 8 % W == 0 {
            self.only
        } else if W.is_multiple_of(8) {
            let group = self.cells.get(self.at..).and_then(<[u8]>::first_chunk).copied();
            self.at = if self.at + 8 >= W { 0 } else { self.at + 8 };
            Switches::new(group.unwrap_or_default())
        } else {
            self.gather()
        }
    }

    /// Cell by cell.
    #[inline]
    fn gather(&mut self) -> Switches {
        let mut cells = Cells { cells: self.cells, at: self.at };
        let group = [(); 8].map(|()| cells.next().unwrap_or_default());
        self.at = cells.at.checked_rem(W).unwrap_or(0);
        Switches::new(group)
    }
}

#[inline]
const fn low_half(value: u64) -> u32 {
    crate::num::low_u32(value.cast_signed())
}

#[inline]
const fn high_half(value: u64) -> u32 {
    low_half(value >> 32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::display::layout::{LsbFirst, MsbFirst};

    #[test]
    fn both_widths_gather_the_same_bits() {
        for bits in 0..=255_u8 {
            let bytes = u64::from_le_bytes([0, 1, 2, 3, 4, 5, 6, 7].map(|bit| (bits >> bit & 1) << 7 | 0x55));
            assert_eq!(gathered_64::<Rows<LsbFirst>>(bytes), bits);
            assert_eq!(gathered_32::<Rows<LsbFirst>>(bytes), bits);
            assert_eq!(gathered_64::<Rows<MsbFirst>>(bytes), bits.reverse_bits());
            assert_eq!(gathered_32::<Rows<MsbFirst>>(bytes), bits.reverse_bits());
        }
    }
}
