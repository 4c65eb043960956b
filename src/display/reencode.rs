//! Panels with an order of their own: rows of a frame made into what they take, while flushing.
//!
//! A frame stays in [`Rows`](crate::Rows), which everything draws on; a row, or two, goes through a
//! small buffer on its way to the bus. There is no second frame.
//!
//! ```text
//!   ST7306: a byte is 4 × 2 pixels                    IT8951: a word is 4 pixels of 4 bits
//!
//!   row 0   7 5 3 1 │ 7 5 3 1 │ 7 5 3 1 │             row     P0 P1 │ P2 P3       high nibble left
//!   row 1   6 4 2 0 │ 6 4 2 0 │ 6 4 2 0 │             word    P3 P2 │ P1 P0       high byte first
//!            byte 0    byte 1    byte 2
//!           ╰───── 12 × 2 pixels ───────╯
//! ```
//!
//! - **Source** the drivers on crates.io: `set_pixel` of `st7306` 0.10.0 and `OriginTopLeft` of
//!   `it8951` 0.5.1. The first is a *perfect shuffle* of two rows: H. S. Warren, *Hacker's Delight*,
//!   2nd edition, section 7-2.
//! - **Cost** a few instructions a byte.
//! - **Memory** a line of bytes, of the caller's.

use core::iter::{repeat, zip};

use crate::{display::frame::TooSmall, num::count};

/// Bytes that a pair of rows takes on an ST7306: three for each twelve pixels begun.
///
/// ```
/// assert_eq!(aquatint::display::reencode::st7306_bytes(300), 75);
/// ```
#[must_use]
pub const fn st7306_bytes(width: u32) -> usize {
    count(width.div_ceil(12) as u64 * 3)
}

/// Makes two rows of one bit a pixel, the upper one first, into tiles of an ST7306.
///
/// Pixels right of `width`, and those that a row is too short for, are 0. So the lower row may be
/// empty where the height is odd. Bytes behind the [`st7306_bytes`] are not touched. On this panel
/// 1 is black.
///
/// ```
/// use aquatint::display::reencode::{st7306_bytes, st7306_tiles};
///
/// let frame = [
///     0b1000_0000, 0b0000_0000,
///     0b1100_0000, 0b0001_0000,
/// ];
/// let mut sent = vec![];
/// let mut line = [0; st7306_bytes(12)];
/// for pair in frame.chunks(2 * 2) {
///     let (upper, lower) = pair.split_at(2);
///     st7306_tiles([upper, lower], 12, &mut line)?;
///     sent.extend(line);
/// }
/// assert_eq!(sent, [0b1101_0000, 0b0000_0000, 0b0000_0001]);
/// # Ok::<(), aquatint::TooSmall>(())
/// ```
///
/// # Errors
/// [`TooSmall`] for the tiles, and nothing is written.
pub fn st7306_tiles(rows: [&[u8]; 2], width: u32, tiles: &mut [u8]) -> Result<(), TooSmall> {
    let needed = st7306_bytes(width);
    let tiles = tiles.get_mut(..needed).ok_or(TooSmall { needed })?;
    let [upper, lower] = rows.map(|row| within(row, width.into()));
    for (pair, (upper, lower)) in zip(tiles.chunks_mut(2), zip(upper, lower)) {
        zip(pair, shuffled(upper, lower)).for_each(|(tile, bits)| *tile = bits);
    }
    Ok(())
}

/// Bytes that a row takes on an IT8951: two for each four pixels begun.
///
/// ```
/// assert_eq!(aquatint::display::reencode::it8951_bytes(5), 4);
/// ```
#[must_use]
pub const fn it8951_bytes(width: u32) -> usize {
    count(width.div_ceil(4) as u64 * 2)
}

/// Makes a row of four bits a pixel, the left one in the high nibble, into words of an IT8951.
///
/// These are the bytes in the order of the bus, for `load_image_area` and the setting
/// `LittleEndian`: the leftmost pixel of four is the low nibble of the *second* byte. Pixels right
/// of `width`, and those that the row is too short for, are 0. Bytes behind the [`it8951_bytes`]
/// are not touched.
///
/// The controller counts its words from column 0 of the panel: a window must begin at a multiple of
/// four columns.
///
/// ```
/// use aquatint::display::reencode::it8951_words;
///
/// let mut words = [0; 4];
/// it8951_words(&[0x01, 0x23, 0x40], 5, &mut words)?;
/// assert_eq!(words, [0x32, 0x10, 0x00, 0x04]);
/// # Ok::<(), aquatint::TooSmall>(())
/// ```
///
/// # Errors
/// [`TooSmall`] for the words, and nothing is written.
pub fn it8951_words(row: &[u8], width: u32, words: &mut [u8]) -> Result<(), TooSmall> {
    let needed = it8951_bytes(width);
    let words = words.get_mut(..needed).ok_or(TooSmall { needed })?;
    let mut pixels = within(row, u64::from(width) * 4);
    for word in words.chunks_exact_mut(2) {
        if let ([left, right], Some(first), Some(second)) = (word, pixels.next(), pixels.next()) {
            (*left, *right) = (second.rotate_left(4), first.rotate_left(4));
        }
    }
    Ok(())
}

/// The same for a whole frame in its own memory: turned around before it is sent, and back after.
///
/// For rows whose width is a multiple of four, with no bytes between them. It is its own reverse.
/// A byte that is left alone at the end is not touched.
///
/// ```
/// use aquatint::display::reencode::it8951_in_place;
///
/// let mut frame = [0x01, 0x23, 0x45, 0x67];
/// it8951_in_place(&mut frame);
/// assert_eq!(frame, [0x32, 0x10, 0x76, 0x54]);
/// it8951_in_place(&mut frame);
/// assert_eq!(frame, [0x01, 0x23, 0x45, 0x67]);
/// ```
pub fn it8951_in_place(bytes: &mut [u8]) {
    for word in bytes.chunks_exact_mut(2) {
        if let [left, right] = word {
            (*left, *right) = (right.rotate_left(4), left.rotate_left(4));
        }
    }
}

/// The bytes of a row without what is right of `bits`, and zeros for ever.
fn within(row: &[u8], bits: u64) -> impl Iterator<Item = u8> {
    let whole = count(bits / 8);
    let (full, rest) = row.split_at_checked(whole).unwrap_or((row, &[]));
    let mask = !(0xFF_u8 >> (bits % 8));
    let last = rest.first().map(|byte| byte & mask);
    full.iter().copied().chain(last).chain(repeat(0))
}

/// The bits of two bytes by turns, from the highest: eight columns of two pixels.
#[inline]
fn shuffled(upper: u8, lower: u8) -> [u8; 2] {
    let bits = u16::from_be_bytes([upper, lower]);
    let bits = swap_bits(bits, 4, 0x00F0);
    let bits = swap_bits(bits, 2, 0x0C0C);
    swap_bits(bits, 1, 0x2222).to_be_bytes()
}

/// Swaps each bit of `mask` with the one `distance` above it.
#[inline]
const fn swap_bits(bits: u16, distance: u32, mask: u16) -> u16 {
    let differing = (bits ^ (bits >> distance)) & mask;
    bits ^ differing ^ (differing << distance)
}
