//! Halftone: black dots of different sizes. Lecture 7.4.2.
//!
//! A clustered-dot screen is an ordered dither whose ranks grow from the gaps between the dots to their middles: the
//! pixels that are still black when the light grows are those in the middles, so each dot shrinks where it is. Where
//! single pixels blur into their neighbours, as on electronic paper, dots lose less tone than scattered pixels.
//!
//! ```text
//!   half of the light     4/5                   7/8, at 45°
//!   ................      ................      #......##......#
//!   ..####....####..      ................      ................
//!   .######..######.      ...##......##...      ................
//!   .######..######.      ..####....####..      ...##......##...
//!   .######..######.      ..####....####..      ...##......##...
//!   .######..######.      ...##......##...      ................
//!   ..####....####..      ................      ................
//!   ................      ................      #......##......#
//! ```
//!
//! The screens here are [`RankMask`]s for [`Dithered`](crate::Dithered), of 16 to 64 cells, made while compiling.
//! Their cells are 4 to 8 pixels wide: with coarser ones more shades, with finer ones more detail. At 45° the eye
//! sees the grid least, and a tile holds two dots.
//!
//! Where a panel's dots gain on the paper between them, measure what the seventeen shades of a mask of 16 ranks
//! give, and bend the mask by [`DotGain`].
//!
//! - **Memory** a byte a cell in flash; a dot gain curve 34 bytes.
//! - **Cost** that of every mask; with a dot gain curve ten instructions more a pixel.
//!
//! Source: R. Ulichney, "Digital Halftoning", 1987, chapter 5.

use crate::{
    display::{
        dither::{Mask, RankMask, even},
        level::NotRising,
    },
    num::{high_u16, index, low_index, low_u8},
};

/// What the ranks of a screen follow.
#[derive(Clone, Copy)]
enum Spot {
    Dots,
    Dots45,
    Lines,
    Lines45,
}

/// How far twice a cell's centre is from the nearest middle of a dot; less is nearer.
const fn distance(spot: Spot, (x, y): (i32, i32), size: i32) -> i32 {
    let (across, down) = (2 * x + 1, 2 * y + 1);
    match spot {
        Spot::Dots => (across - size) * (across - size) + (down - size) * (down - size),
        // Dots on the corners and in the middle of the tile.
        Spot::Dots45 => {
            let middle = (across - size) * (across - size) + (down - size) * (down - size);
            let (across, down) = (to_edge(across, size), to_edge(down, size));
            let corner = across * across + down * down;
            if corner < middle { corner } else { middle }
        }
        Spot::Lines => (down - size).abs(),
        Spot::Lines45 => (2 * ((x + y) % size) + 1 - size).abs(),
    }
}

/// From twice a place to the nearer side of the tile.
const fn to_edge(place: i32, size: i32) -> i32 {
    if place < size { place } else { 2 * size - place }
}

/// Cells in the order in which they turn white: the largest first. No two are equal.
const fn key(spot: Spot, (x, y): (i32, i32), size: i32) -> i32 {
    // Cells equally far take turns around a dot, or along a line.
    let turn = match spot {
        Spot::Dots | Spot::Dots45 => 2 * ((2 * x < size) as i32 ^ (2 * y < size) as i32) + (2 * y < size) as i32,
        Spot::Lines | Spot::Lines45 => x * 3 % size,
    };
    (distance(spot, (x, y), size) * 16 + turn) * 256 + y * size + x
}

/// The ranks of a screen: how many cells turn white before each.
const fn ranks<const S: usize>(spot: Spot) -> [[u8; S]; S] {
    const { assert!(S > 0 && S <= 16, "ranks are bytes") };
    let size = low_index(S).cast_signed();
    let (mut ranks, mut cell) = ([[0; S]; S], 0);
    while cell < size * size {
        let (mut before, mut other) = (0, 0);
        while other < size * size {
            let at = (other % size, other / size);
            before += (key(spot, at, size) > key(spot, (cell % size, cell / size), size)) as u32;
            other += 1;
        }
        ranks[index(cell / size)][index(cell % size)] = low_u8(before);
        cell += 1;
    }
    ranks
}

/// Ranks of round dots, one in a tile of `S` × `S`; 1 to 16.
///
/// ```
/// use aquatint::{RankMask, display::halftone::dots};
///
/// const FIVE: RankMask<'static, 5, 5> = match RankMask::new(const { &dots::<5>() }.as_flattened()) {
///     Ok(mask) => mask,
///     Err(_) => panic!(),
/// };
/// ```
#[must_use]
pub const fn dots<const S: usize>() -> [[u8; S]; S] {
    ranks::<S>(Spot::Dots)
}

/// Ranks of round dots at 45°, two in a tile of `S` × `S`; 1 to 16.
#[must_use]
pub const fn dots_45<const S: usize>() -> [[u8; S]; S] {
    ranks::<S>(Spot::Dots45)
}

/// Ranks of horizontal lines, one in `S` rows; 1 to 16.
#[must_use]
pub const fn lines<const S: usize>() -> [[u8; S]; S] {
    ranks::<S>(Spot::Lines)
}

/// Ranks of lines that rise to the right at 45°; 1 to 16.
#[must_use]
pub const fn lines_45<const S: usize>() -> [[u8; S]; S] {
    ranks::<S>(Spot::Lines45)
}

/// Round dots 4 pixels apart: 17 shades.
pub const DOTS_4X4: RankMask<'static, 4, 4> = even(const { &dots::<4>() }, 16);
/// Round dots 6 pixels apart: 37 shades.
pub const DOTS_6X6: RankMask<'static, 6, 6> = even(const { &dots::<6>() }, 36);
/// Round dots 8 pixels apart: 65 shades.
pub const DOTS_8X8: RankMask<'static, 8, 8> = even(const { &dots::<8>() }, 64);
/// Round dots at 45°, 2.8 pixels apart: 17 shades.
pub const DOTS_45_4X4: RankMask<'static, 4, 4> = even(const { &dots_45::<4>() }, 16);
/// Round dots at 45°, 4.2 pixels apart: 37 shades.
pub const DOTS_45_6X6: RankMask<'static, 6, 6> = even(const { &dots_45::<6>() }, 36);
/// Round dots at 45°, 5.7 pixels apart: 65 shades.
pub const DOTS_45_8X8: RankMask<'static, 8, 8> = even(const { &dots_45::<8>() }, 64);
/// Horizontal lines 4 pixels apart: 17 shades.
pub const LINES_4X4: RankMask<'static, 4, 4> = even(const { &lines::<4>() }, 16);
/// Horizontal lines 8 pixels apart: 65 shades.
pub const LINES_8X8: RankMask<'static, 8, 8> = even(const { &lines::<8>() }, 64);
/// Lines at 45°, 2.8 pixels apart: 17 shades.
pub const LINES_45_4X4: RankMask<'static, 4, 4> = even(const { &lines_45::<4>() }, 16);
/// Lines at 45°, 5.7 pixels apart: 65 shades.
pub const LINES_45_8X8: RankMask<'static, 8, 8> = even(const { &lines_45::<8>() }, 64);

/// A mask on a panel whose shades are not what their share of white pixels says.
///
/// The curve has the light of shades of 0, 1, 2 … 16 sixteenths of white pixels, as measured; between them it is
/// straight. A pixel of the mask then is on where the light exceeds what its shade gives. For panels of one bit.
///
/// ```
/// use aquatint::{DotGain, display::halftone::DOTS_45_4X4};
///
/// // Half of the pixels give 0.42 of the light.
/// let curve = [0, 3000, 6000, 9200, 12_500, 16_000, 19_700, 23_500, 27_500, 31_700, 36_000, 40_500, 45_200, 50_000,
///     55_000, 60_200, 65_535];
/// let mask = DotGain::new(DOTS_45_4X4, curve)?;
/// # Ok::<(), aquatint::display::level::NotRising>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DotGain<M> {
    mask: M,
    curve: [u16; 17],
}

impl<M: Mask> DotGain<M> {
    /// A mask, and the light of 0 to 16 sixteenths of white pixels: from 0, rising, to 65535.
    ///
    /// # Errors
    /// [`NotRising`], also where the ends are not black and white.
    pub fn new(mask: M, curve: [u16; 17]) -> Result<Self, NotRising> {
        let ends = (curve.first(), curve.last()) == (Some(&0), Some(&u16::MAX));
        if ends && curve.is_sorted_by(|a, b| a < b) { Ok(Self { mask, curve }) } else { Err(NotRising) }
    }

    /// The light of a share of white pixels, both in 65536ths.
    #[inline]
    fn light(curve: &[u16; 17], share: u16) -> u16 {
        let sixteenth = usize::from(share >> 12);
        let Some(&[low, high]) = curve.get(sixteenth..).and_then(|part| part.first_chunk()) else { return share };
        let above = u32::from(high.saturating_sub(low)) * u32::from(share & 0xFFF);
        low.saturating_add(high_u16(above << 4))
    }
}

impl<M: Mask> Mask for DotGain<M> {
    const REPEATS: bool = M::REPEATS;

    #[inline]
    fn threshold(&self, column: i32, row: i32) -> u16 {
        Self::light(&self.curve, self.mask.threshold(column, row))
    }

    #[inline]
    fn row(&self, row: i32, column: i32) -> impl Iterator<Item = u16> {
        self.mask.row(row, column).map(|share| Self::light(&self.curve, share))
    }
}
