//! One-bit pictures between rows and pages, eight by eight pixels at a time.
//!
//! Images come in [`Rows`](crate::Rows), an SSD1306 takes [`Pages`](crate::Pages). A block of
//! 8 × 8 pixels is eight bytes in both, and one is the other mirrored in the diagonal:
//!
//! ```text
//!   eight rows, bit 7 on the left           eight columns, bit 0 on top
//!
//!    byte 0  # # # # . . . .                    . . . # # . . .  bit 7
//!    byte 1  # . . . # . . .                    . . # . . . . .  bit 6
//!    byte 2  # . . . # . . .                        …
//!      ⋮                                        # # # # . . . .  bit 0
//!   bit      7 6 5 4 3 2 1 0            byte    0 1 2 3 4 5 6 7
//! ```
//!
//! - **Method** eight rows of 64 pixels are eight words. Three steps exchange the halves of blocks of
//!   8 × 8, 4 × 4 and 2 × 2 bits between two words each, for eight blocks at once; three more do
//!   the same with bytes, so that each word is a block: H. S. Warren, *Hacker's Delight*, 2nd
//!   edition, section 7-3. Other bit orders are only other orders of words and of bytes.
//! - **Cost** about 45 instructions a block on a desk: a picture of 128 × 64 pixels is 128 blocks.
//! - **Memory** 64 bytes of stack.

use core::iter::zip;

use crate::{display::frame::TooSmall, num::count};

/// Which bit of a byte is the first of its eight pixels, the leftmost or the topmost one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum BitOrder {
    /// Bit 7: rows of most panels and of `ImageRaw`; columns of UC8151.
    HighFirst,
    /// Bit 0: pages of SSD1306 and its kin; rows of XBM images.
    LowFirst,
}

/// Turns one-bit pictures of a size between rows and pages.
///
/// Rows are padded to whole bytes, and the last page to eight rows. Padding is written as 0 and is
/// never read as a pixel.
///
/// ```
/// use aquatint::display::transpose::Transpose;
///
/// let rows = [
///     0b1111_1000,
///     0b0000_0000,
///     0b1000_0000,
/// ];
/// let mut pages = [0; 5];
/// Transpose::new(5, 3).rows_to_pages(&rows, &mut pages)?;
/// assert_eq!(pages, [0b101, 0b001, 0b001, 0b001, 0b001]);
///
/// let mut back = [0; 3];
/// Transpose::new(5, 3).pages_to_rows(&pages, &mut back)?;
/// assert_eq!(back, rows);
/// # Ok::<(), aquatint::TooSmall>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Transpose {
    width: u32,
    height: u32,
    rows: BitOrder,
    pages: BitOrder,
}

impl Transpose {
    /// The leftmost pixel of a row in bit 7, the topmost one of a page in bit 0.
    #[must_use]
    pub const fn new(width: u32, height: u32) -> Self {
        Self { width, height, rows: BitOrder::HighFirst, pages: BitOrder::LowFirst }
    }

    /// The same in other orders, at no cost.
    ///
    /// ```
    /// use aquatint::display::transpose::{BitOrder, Transpose};
    ///
    /// // An XBM image, the leftmost pixel in bit 0.
    /// let xbm = [0b0000_0001, 0b0000_0011];
    /// let mut pages = [0; 2];
    /// Transpose::new(2, 2).with_orders(BitOrder::LowFirst, BitOrder::LowFirst).rows_to_pages(&xbm, &mut pages)?;
    /// assert_eq!(pages, [0b11, 0b10]);
    /// # Ok::<(), aquatint::TooSmall>(())
    /// ```
    #[must_use]
    pub const fn with_orders(self, rows: BitOrder, pages: BitOrder) -> Self {
        Self { rows, pages, ..self }
    }

    /// Fills `pages` from `rows`. Bytes behind the picture are not touched.
    ///
    /// # Errors
    /// [`TooSmall`] for either of them, and nothing is written.
    pub fn rows_to_pages(self, rows: &[u8], pages: &mut [u8]) -> Result<(), TooSmall> {
        let (stride, width) = (self.row_bytes(), self.page_bytes());
        let rows = rows.get(..self.rows_needed()).ok_or(TooSmall { needed: self.rows_needed() })?;
        let pages = pages.get_mut(..self.pages_needed()).ok_or(TooSmall { needed: self.pages_needed() })?;
        let mut first = 0;
        for page in pages.chunks_exact_mut(width.max(1)) {
            let mut column = first;
            for bytes in page.chunks_mut(64) {
                let mut words = words(rows, stride, column);
                if self.pages == BitOrder::HighFirst {
                    words.reverse();
                }
                to_blocks(&mut words);
                store_blocks(bytes, &words.map(|block| self.leftmost_first(block)));
                column += 8;
            }
            first += 8 * stride;
        }
        Ok(())
    }

    /// Fills `rows` from `pages`. Bytes behind the picture are not touched.
    ///
    /// # Errors
    /// [`TooSmall`] for either of them, and nothing is written.
    pub fn pages_to_rows(self, pages: &[u8], rows: &mut [u8]) -> Result<(), TooSmall> {
        let (stride, width) = (self.row_bytes(), self.page_bytes());
        let pages = pages.get(..self.pages_needed()).ok_or(TooSmall { needed: self.pages_needed() })?;
        let rows = rows.get_mut(..self.rows_needed()).ok_or(TooSmall { needed: self.rows_needed() })?;
        let mut first = 0;
        for page in pages.chunks_exact(width.max(1)) {
            let mut column = 0;
            for bytes in page.chunks(64) {
                let mut words = load_blocks(bytes).map(|block| self.leftmost_first(block));
                to_words(&mut words);
                if self.pages == BitOrder::HighFirst {
                    words.reverse();
                }
                let mut start = first + column;
                for word in words {
                    let end = start + (stride - column).min(8);
                    store(rows.get_mut(start..end).unwrap_or_default(), word);
                    start += stride;
                }
                column += 8;
            }
            first += 8 * stride;
        }
        Ok(())
    }

    /// The first byte of a block is its highest; turned around where the leftmost pixel is the lowest.
    #[inline]
    const fn leftmost_first(self, block: u64) -> u64 {
        match self.rows {
            BitOrder::HighFirst => block,
            BitOrder::LowFirst => block.swap_bytes(),
        }
    }

    /// Bytes from row to row, at least 1.
    const fn row_bytes(self) -> usize {
        if self.width == 0 { 1 } else { count(self.width.div_ceil(8) as u64) }
    }

    /// Bytes from page to page, at least 1.
    const fn page_bytes(self) -> usize {
        if self.width == 0 { 1 } else { count(self.width as u64) }
    }

    const fn rows_needed(self) -> usize {
        count(self.width.div_ceil(8) as u64 * self.height as u64)
    }

    const fn pages_needed(self) -> usize {
        count(self.width as u64 * self.height.div_ceil(8) as u64)
    }
}

/// Eight bytes from byte `first` on, and from `stride` bytes behind, and so on, eight times; what is
/// behind the end, or with numbers that wrapped before the beginning, is 0.
#[inline]
pub(super) fn words(bytes: &[u8], stride: usize, first: usize) -> [u64; 8] {
    let (mut at, mut words) = (first, [0; 8]);
    for word in &mut words {
        *word = bytes.get(at..).map_or(0, load);
        at = at.wrapping_add(stride);
    }
    words
}

/// Makes eight rows of 64 pixels, the leftmost in the highest bit, into eight blocks of eight
/// columns, the *rightmost* one first: a column is a byte, the leftmost the highest one, and its
/// topmost pixel the lowest bit.
pub(super) fn to_blocks(words: &mut [u64; 8]) {
    mirror_bits(words);
    mirror_bytes(words);
}

/// The reverse.
fn to_words(blocks: &mut [u64; 8]) {
    mirror_bytes(blocks);
    mirror_bits(blocks);
}

/// Swaps bit `j` of byte `k` of word `i` with bit `i` of byte `k` of word `j`.
#[inline]
fn mirror_bits(words: &mut [u64; 8]) {
    exchange::<4>(words, 4, 0x0F0F_0F0F_0F0F_0F0F);
    exchange::<2>(words, 2, 0x3333_3333_3333_3333);
    exchange::<1>(words, 1, 0x5555_5555_5555_5555);
}

/// Swaps byte `j` of word `i` with byte `i` of word `j`.
#[inline]
fn mirror_bytes(words: &mut [u64; 8]) {
    exchange::<4>(words, 32, 0x0000_0000_FFFF_FFFF);
    exchange::<2>(words, 16, 0x0000_FFFF_0000_FFFF);
    exchange::<1>(words, 8, 0x00FF_00FF_00FF_00FF);
}

/// Between words `DISTANCE` apart, swaps the bits of `mask` in the second with those `shift` above in
/// the first.
#[inline]
fn exchange<const DISTANCE: usize>(words: &mut [u64; 8], shift: u32, mask: u64) {
    for pair in words.chunks_exact_mut(2 * DISTANCE) {
        let (upper, lower) = pair.split_at_mut_checked(DISTANCE).unwrap_or_default();
        for (upper, lower) in zip(upper, lower) {
            let differing = ((*upper >> shift) ^ *lower) & mask;
            *upper ^= differing << shift;
            *lower ^= differing;
        }
    }
}

/// Up to eight bytes, the first in the highest bits; those that are not there are 0.
#[inline]
pub(super) fn load(bytes: &[u8]) -> u64 {
    match bytes.first_chunk() {
        Some(bytes) => u64::from_be_bytes(*bytes),
        None => bytes.iter().rev().fold(0, |block, &byte| block >> 8 | u64::from(byte) << 56),
    }
}

/// Up to eight bytes from the highest bits.
#[inline]
pub(super) fn store(bytes: &mut [u8], block: u64) {
    match bytes.first_chunk_mut() {
        Some(bytes) => *bytes = block.to_be_bytes(),
        None => zip(bytes, block.to_be_bytes()).for_each(|(byte, new)| *byte = new),
    }
}

/// Up to eight blocks, the first of them last; those that are not there are 0.
#[inline]
pub(super) fn load_blocks(bytes: &[u8]) -> [u64; 8] {
    let mut blocks = [0; 8];
    let mut take = |bytes: &[u8]| {
        let mut chunks = bytes.chunks(8);
        blocks.iter_mut().rev().for_each(|block| *block = chunks.next().map_or(0, load));
    };
    match bytes.first_chunk::<64>() {
        // Of known length, it is done without a branch.
        Some(whole) => take(whole),
        None => take(bytes),
    }
    blocks
}

/// Up to eight blocks, the last of them first.
#[inline]
fn store_blocks(bytes: &mut [u8], blocks: &[u64; 8]) {
    let put = |bytes: &mut [u8]| {
        let mut chunks = bytes.chunks_mut(8);
        blocks.iter().rev().for_each(|block| store(chunks.next().unwrap_or_default(), *block));
    };
    match bytes.first_chunk_mut::<64>() {
        Some(whole) => put(whole),
        None => put(bytes),
    }
}
