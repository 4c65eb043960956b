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
//! - **Method** the block is one `u64`; three steps swap bits 7, 14 and 28 places apart, which are
//!   the halves of 2 × 2, 4 × 4 and 8 × 8 blocks: H. S. Warren, *Hacker's Delight*, 2nd edition,
//!   section 7-3. Which end of a byte comes first is only a matter of the order of the bytes.
//! - **Cost** about 40 instructions a block on a desk: a picture of 128 × 64 pixels is 128 blocks.
//! - **Memory** none.

use core::{cell::Cell, iter::zip};

use crate::{display::frame::TooSmall, num::count};

/// Which bit of a byte is the first of its eight pixels, the leftmost or the topmost one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
        for (strip, page) in zip(rows.chunks(stride.saturating_mul(8)), pages.chunks_exact_mut(width)) {
            let (mut rows, mut mask) = eight(strip, stride);
            if self.pages == BitOrder::HighFirst {
                rows.reverse();
                mask = mask.reverse_bits();
            }
            let mask = u64::from_ne_bytes([mask; 8]);
            let mut blocks = columns(rows).map(|block| self.leftmost_first(block & mask));
            let mut whole = page.chunks_exact_mut(8);
            zip(&mut whole, &mut blocks).for_each(|(bytes, block)| store(bytes, block));
            zip([whole.into_remainder()], blocks).for_each(|(bytes, block)| store(bytes, block));
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
        let cells = Cell::from_mut(rows).as_slice_of_cells();
        for (strip, page) in zip(cells.chunks(stride.saturating_mul(8)), pages.chunks_exact(width)) {
            let (rows, _) = eight(strip, stride);
            for (cells, bytes) in zip(across(rows), page.chunks(8)) {
                let block = transposed(self.leftmost_first(load(bytes)));
                let block = if self.pages == BitOrder::HighFirst { block.swap_bytes() } else { block };
                // From below: a row that is not there is the first one again, which is written last.
                for (cell, byte) in zip(&cells, &block.to_le_bytes()).rev() {
                    cell.set(*byte);
                }
            }
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

/// The first eight lines of a strip, and a bit for each that is there; the first line stands for
/// the others.
pub(super) fn eight<T>(strip: &[T], stride: usize) -> ([&[T]; 8], u8) {
    let mut lines = strip.chunks(stride.max(1));
    let first = strip.chunks(stride.max(1)).next().unwrap_or(&[]);
    let mask = (0..8).zip(lines.clone()).fold(0, |mask, (bit, _)| mask | 1 << bit);
    ([(); 8].map(|()| lines.next().unwrap_or(first)), mask)
}

/// Blocks of eight columns of eight rows, from the left: the highest byte is the leftmost column,
/// the lowest bit of a byte its topmost pixel.
pub(super) fn columns(rows: [&[u8]; 8]) -> impl Iterator<Item = u64> {
    across(rows).map(|[a, b, c, d, e, f, g, h]| transposed(u64::from_le_bytes([*a, *b, *c, *d, *e, *f, *g, *h])))
}

/// What eight slices have at the same place.
fn across<T>([a, b, c, d, e, f, g, h]: [&[T]; 8]) -> impl Iterator<Item = [&T; 8]> {
    let (left, right) = (zip(zip(a, b), zip(c, d)), zip(zip(e, f), zip(g, h)));
    zip(left, right).map(|(((a, b), (c, d)), ((e, f), (g, h)))| [a, b, c, d, e, f, g, h])
}

/// Swaps bit `8 i + j` with bit `8 j + i`.
#[inline]
const fn transposed(block: u64) -> u64 {
    let block = swap_bits(block, 7, 0x00AA_00AA_00AA_00AA);
    let block = swap_bits(block, 14, 0x0000_CCCC_0000_CCCC);
    swap_bits(block, 28, 0x0000_0000_F0F0_F0F0)
}

/// Swaps each bit of `mask` with the one `distance` above it.
#[inline]
const fn swap_bits(block: u64, distance: u32, mask: u64) -> u64 {
    let differing = (block ^ (block >> distance)) & mask;
    block ^ differing ^ (differing << distance)
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
