//! Hatching: light as lines of a pen, which get denser and then cross.
//!
//! ```text
//!   HATCH_8X8: 7/8    3/4                1/2                CROSS_HATCH_8X8    3/8 of the light
//!   #.......#.......   #...#...#...#...   ##..##..##..##..   #.......#.......   ###.....###.....
//!   .......#.......#   ...#...#...#...#   #..##..##..##..#   .#.....#.#.....#   ####...#####...#
//!   ......#.......#.   ..#...#...#...#.   ..##..##..##..##   ..#...#...#...#.   #.###.###.###.##
//!   .....#.......#..   .#...#...#...#..   .##..##..##..##.   ...#.#.....#.#..   #..######..#####
//!   ....#.......#...   #...#...#...#...   ##..##..##..##..   ....##......##..   ....####....####
//!   ...#.......#....   ...#...#...#...#   #..##..##..##..#   ...#.#.....#.#..   ...#####...#####
//!   ..#.......#.....   ..#...#...#...#.   ..##..##..##..##   ..#...#...#...#.   #.###.###.###.##
//!   .#.......#......   .#...#...#...#..   .##..##..##..##.   .#.....#.#.....#   ####...#####...#
//! ```
//!
//! These are [`RankMask`]s, as the screens of [halftone](crate::display::halftone) are, but their ranks follow
//! strokes: a stroke grows along its line before the next one begins. With a toon's [bands](crate::fragment::toon)
//! of light each band has strokes of its own; without them strokes fade out along a curved surface.
//!
//! - **Memory** a byte a cell in flash, made while compiling.
//! - **Cost** that of every mask.

use super::rank::{RankMask, even};
use crate::num::{index, low_index, low_u8};

/// The directions of strokes in a tile of `S` × `S`.
#[derive(Clone, Copy)]
enum Strokes {
    /// Only up to the right.
    OneWay,
    /// Then across those.
    Crossed,
}

impl Strokes {
    /// The distance of the lines when they are as dense as they get. From then on they get thicker.
    const fn densest(self) -> i32 {
        match self {
            Self::OneWay => 4,
            // Closer crossings are too small to be seen.
            Self::Crossed => 8,
        }
    }
}

/// How many densities come before a line: the first are `size` apart, then half as far, as long as that is possible.
const fn density(line: i32, size: i32) -> i32 {
    let (mut density, mut step) = (0, size);
    while line % step != 0 {
        step /= 2;
        density += 1;
    }
    density
}

/// When a cell turns black: the less, the sooner. No two are equal.
const fn key(strokes: Strokes, (x, y): (i32, i32), size: i32) -> i32 {
    let (rising, falling) = ((x + y) % size, (x - y + size) % size);
    let densest = strokes.densest();
    let densities = density(densest, size) + 1;
    // Rising strokes of all densities, then those across, then one pixel thicker by turns.
    let (thicker, across) = (2 * (rising % densest), 2 * (falling % densest));
    let rises = if thicker == 0 { density(rising, size) } else { 2 * densities + thicker };
    let falls = if across == 0 { densities + density(falling, size) } else { 2 * densities + across + 1 };
    let crossed = matches!(strokes, Strokes::Crossed) && falls < rises;
    let (turn, line) = if crossed { (falls, falling) } else { (rises, rising) };
    // Strokes of neighbouring lines do not begin side by side.
    let along = (x + line * 3) % size;
    (turn * size + line) * size + along
}

/// The ranks of the strokes: how many cells turn black after each.
const fn ranks<const S: usize>(strokes: Strokes) -> [[u8; S]; S] {
    const { assert!(S == 8 || S == 16, "distances are halved; ranks are bytes") };
    let size = low_index(S).cast_signed();
    let (mut ranks, mut cell) = ([[0; S]; S], 0);
    while cell < size * size {
        let (mut after, mut other) = (0, 0);
        while other < size * size {
            let at = (other % size, other / size);
            after += (key(strokes, at, size) > key(strokes, (cell % size, cell / size), size)) as u32;
            other += 1;
        }
        ranks[index(cell / size)][index(cell % size)] = low_u8(after);
        cell += 1;
    }
    ranks
}

/// Strokes that rise to the right, 8 pixels apart, then 4, then thicker: 65 shades.
pub const HATCH_8X8: RankMask<'static, 8, 8> = even(const { &ranks::<8>(Strokes::OneWay) }, 64);
/// Strokes that rise to the right 8 pixels apart, then such that fall across them, then both thicker: 65 shades.
pub const CROSS_HATCH_8X8: RankMask<'static, 8, 8> = even(const { &ranks::<8>(Strokes::Crossed) }, 64);
/// As [`HATCH_8X8`], from 16 pixels apart on: 257 shades, for panels of many pixels.
pub const HATCH_16X16: RankMask<'static, 16, 16> = even(const { &ranks::<16>(Strokes::OneWay) }, 256);
/// As [`CROSS_HATCH_8X8`], from 16 pixels apart on: 257 shades, for panels of many pixels.
pub const CROSS_HATCH_16X16: RankMask<'static, 16, 16> = even(const { &ranks::<16>(Strokes::Crossed) }, 256);

#[cfg(test)]
mod tests {
    use super::*;

    /// A tile of which so many cells are black.
    fn picture(strokes: Strokes, black: u8) -> [[char; 8]; 8] {
        ranks::<8>(strokes).map(|row| row.map(|rank| if rank >= 64 - black { '#' } else { '.' }))
    }

    fn rows(picture: [&str; 8]) -> [[char; 8]; 8] {
        picture.map(|row| {
            let mut signs = row.chars();
            [(); 8].map(|()| signs.next().unwrap())
        })
    }

    #[test]
    fn strokes_get_denser_then_thicker() {
        let sparse = ["#.......", ".......#", "......#.", ".....#..", "....#...", "...#....", "..#.....", ".#......"];
        assert_eq!(picture(Strokes::OneWay, 8), rows(sparse));
        let half_a_stroke =
            ["#...#...", ".......#", "......#.", ".....#..", "....#...", "...#....", "..#...#.", ".#...#.."];
        assert_eq!(picture(Strokes::OneWay, 11), rows(half_a_stroke));
        let dense = ["#...#...", "...#...#", "..#...#.", ".#...#..", "#...#...", "...#...#", "..#...#.", ".#...#.."];
        assert_eq!(picture(Strokes::OneWay, 16), rows(dense));
        let thick = ["##..##..", "#..##..#", "..##..##", ".##..##.", "##..##..", "#..##..#", "..##..##", ".##..##."];
        assert_eq!(picture(Strokes::OneWay, 32), rows(thick));
    }

    #[test]
    fn strokes_cross() {
        let crossed = ["#.......", ".#.....#", "..#...#.", "...#.#..", "....#...", "...#.#..", "..#...#.", ".#.....#"];
        assert_eq!(picture(Strokes::Crossed, 14), rows(crossed));
    }

    #[test]
    fn every_rank_occurs_once() {
        for strokes in [Strokes::OneWay, Strokes::Crossed] {
            assert!(RankMask::<8, 8>::new(ranks::<8>(strokes).as_flattened()).is_ok_and(|mask| mask.count() == 64));
            assert!(RankMask::<16, 16>::new(ranks::<16>(strokes).as_flattened()).is_ok_and(|mask| mask.count() == 256));
        }
    }
}
