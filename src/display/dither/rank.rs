//! Masks made of ranks: Bayer's, and any that a user brings.
//!
//! A mask of `N` ranks gives each pixel of a tile a rank from 0 to N−1. The pixel of rank `k` shows the brighter
//! of two levels where the light is more than `(k + ½) / N` of the way to it. So a flat light is right to
//! `1 / 2N` of the step, and N ranks make N+1 shades.
//!
//! ```text
//!             0  8  2 10      Bayer's masks double themselves:
//!   0 2      12  4 14  6
//!   3 1       3 11  1  9      next = 4 × this + │0 2│
//!            15  7 13  5                        │3 1│
//! ```
//!
//! - **Memory** a byte a cell in flash.
//! - **Cost** a load and a multiplication a pixel.
//!
//! Source: B. E. Bayer, "An optimum method for two-level rendition of continuous-tone pictures", IEEE ICC 1973.

use super::Mask;
use crate::{
    error::describe,
    num::{count_i32, high_u16, index, low_index},
    phase::phase,
};

/// A mask of `W` × `H` ranks of 0 to 255, row by row.
///
/// ```
/// use aquatint::{Dithered, Frame, Levels, Light, RankMask, Rows, Target};
/// use embedded_graphics::pixelcolor::BinaryColor;
///
/// // Diagonal lines of 0 to 3 pixels of 3.
/// let lines = RankMask::<3, 3>::new(&[0, 1, 2, 1, 2, 0, 2, 0, 1])?;
/// let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 2], 8, 2).unwrap();
/// let mut dithered = Dithered::new(&mut frame, Levels::ONE_BIT).with_method(lines);
/// for row in 0..2 {
///     dithered.fill_run(row, 0..8, [Light(20_000)]).unwrap();
/// }
/// assert_eq!(frame.bytes(), [0b1001_0010, 0b0010_0100]);
/// # Ok::<(), aquatint::display::dither::UnevenRanks>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RankMask<'a, const W: usize, const H: usize> {
    ranks: &'a [u8],
    /// 2³¹ over the number of ranks, rounded up.
    half_step: u32,
}

/// The ranks of a mask are not as many as it has cells, or there is one from 0 to the greatest that does not
/// occur as often as the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct UnevenRanks;

describe! { UnevenRanks, Self => "the ranks are not as many as the cells, or do not occur equally often"; }

impl<'a, const W: usize, const H: usize> RankMask<'a, W, H> {
    /// A mask of one's own: `W` × `H` ranks row by row, in which each from 0 to the greatest occurs equally often,
    /// so that every shade has its share of pixels.
    ///
    /// # Errors
    /// [`UnevenRanks`].
    pub const fn new(ranks: &'a [u8]) -> Result<Self, UnevenRanks> {
        match W.checked_mul(H) {
            Some(cells) if cells > 0 && cells == ranks.len() => {}
            _ => return Err(UnevenRanks),
        }
        let (mut often, mut greatest, mut cell) = ([0_usize; 256], 0, 0);
        while cell < ranks.len() {
            let rank = ranks[cell] as usize;
            often[rank] += 1;
            greatest = if rank > greatest { rank } else { greatest };
            cell += 1;
        }
        let mut rank = 0;
        while rank <= greatest {
            if often[rank] != often[0] {
                return Err(UnevenRanks);
            }
            rank += 1;
        }
        Ok(Self::trusted(ranks, greatest + 1))
    }

    /// A mask whose ranks are known to be even.
    pub(super) const fn trusted(ranks: &'a [u8], count: usize) -> Self {
        // At most 256 ranks; at least one.
        Self { ranks, half_step: (1_u32 << 31).div_ceil(low_index(count)) }
    }

    /// How many ranks there are, 1 to 256.
    pub(super) const fn count(&self) -> u32 {
        (1_u32 << 31).div_ceil(self.half_step)
    }

    /// The ranks of a row of the screen.
    #[inline]
    pub(super) fn ranks(&self, row: i32) -> &'a [u8; W] {
        let row = index(row.checked_rem_euclid(count_i32(H)).unwrap_or(0));
        let ranks = self.ranks.get(row.wrapping_mul(W)..).and_then(<[u8]>::first_chunk);
        ranks.unwrap_or(const { &[0; W] })
    }

    /// The rank of a cell of the tile.
    pub(super) const fn rank(&self, x: usize, y: usize) -> u8 {
        self.ranks[y * W + x]
    }

    /// The thresholds of all cells.
    pub(super) const fn thresholds(&self) -> [[u16; W]; H] {
        let (mut thresholds, mut y) = ([[0; W]; H], 0);
        while y < H {
            let mut x = 0;
            while x < W {
                thresholds[y][x] = threshold_of(self.rank(x, y), self.half_step);
                x += 1;
            }
            y += 1;
        }
        thresholds
    }
}

/// What part of 65536 the light must exceed for a rank, rounded down: `(2k + 1) / 2N`.
#[inline]
const fn threshold_of(rank: u8, half_step: u32) -> u16 {
    // Below 2³², because 2k + 1 < 2N; the excess of the half step that was rounded up is less than a unit.
    high_u16((2 * rank as u32 + 1).wrapping_mul(half_step))
}

impl<const W: usize, const H: usize> Mask for RankMask<'_, W, H> {
    const REPEATS: bool = W > 0 && H > 0 && 8 % W == 0 && 8 % H == 0;
    const IN_FOUR: bool = W > 0 && 4 % W == 0;

    #[inline]
    fn threshold(&self, column: i32, row: i32) -> u16 {
        threshold_of(phase(self.ranks(row), column).unwrap_or_default(), self.half_step)
    }

    #[inline]
    fn row(&self, row: i32, column: i32) -> impl Iterator<Item = u16> {
        let half_step = self.half_step;
        Cells::new(self.ranks(row), column).map(move |rank| threshold_of(rank, half_step))
    }
}

/// The cells of a row, again and again.
#[derive(Clone, Debug)]
pub(super) struct Cells<'a, C, const W: usize> {
    pub(super) cells: &'a [C; W],
    pub(super) at: usize,
}

impl<'a, C, const W: usize> Cells<'a, C, W> {
    /// From a column of the screen on.
    #[inline]
    pub(super) fn new(cells: &'a [C; W], column: i32) -> Self {
        Self { cells, at: index(column.checked_rem_euclid(count_i32(W)).unwrap_or(0)) }
    }
}

impl<C: Copy, const W: usize> Iterator for Cells<'_, C, W> {
    type Item = C;

    #[inline]
    fn next(&mut self) -> Option<C> {
        if W.is_power_of_two() {
            // No test of bounds remains.
            let cell = self.cells.get(self.at & (W - 1)).copied();
            self.at = self.at.wrapping_add(1);
            return cell;
        }
        let cell = self.cells.get(self.at).copied();
        self.at = if self.at + 1 < W { self.at + 1 } else { 0 };
        cell
    }
}

/// Bayer's ranks in `N` × `N` cells; `N` is a power of two, at most 16.
///
/// The bits of `x XOR y` and of `y`, interleaved from the lowest: the recursion written out.
const fn bayer<const N: usize>() -> [[u8; N]; N] {
    let (mut ranks, mut y) = ([[0; N]; N], 0);
    while y < N {
        let mut x = 0;
        while x < N {
            let (mut rank, mut bit) = (0, 1);
            while bit < N {
                rank = 4 * rank + 2 * ((x ^ y) & bit != 0) as u8 + (y & bit != 0) as u8;
                bit <<= 1;
            }
            ranks[y][x] = rank;
            x += 1;
        }
        y += 1;
    }
    ranks
}

/// 2 × 2 ordered dither: 5 shades. Coarse in tone, fine in grain; for panels of 16 greys.
pub const BAYER_2X2: RankMask<'static, 2, 2> = RankMask::trusted(const { &bayer::<2>() }.as_flattened(), 4);
/// 4 × 4 ordered dither: the 17 shades from 16 pixels of lecture 7.4.3.
pub const BAYER_4X4: RankMask<'static, 4, 4> = RankMask::trusted(const { &bayer::<4>() }.as_flattened(), 16);
/// 8 × 8 ordered dither: 65 shades. On one bit, dark greys from sRGB code 22 on are told from black.
pub const BAYER_8X8: RankMask<'static, 8, 8> = RankMask::trusted(const { &bayer::<8>() }.as_flattened(), 64);
/// 16 × 16 ordered dither: 257 shades, dark greys from sRGB code 7 on.
pub const BAYER_16X16: RankMask<'static, 16, 16> = RankMask::trusted(const { &bayer::<16>() }.as_flattened(), 256);

/// A mask whose ranks the crate has made.
pub(in crate::display) const fn even<const W: usize, const H: usize>(
    ranks: &[[u8; W]; H],
    count: usize,
) -> RankMask<'_, W, H> {
    RankMask::trusted(ranks.as_flattened(), count)
}
