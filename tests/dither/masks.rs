//! What the masks are made of, and the tones that they give.

use aquatint::{
    BAYER_2X2, BAYER_4X4, BAYER_8X8, BAYER_16X16, BLUE_NOISE_16, BLUE_NOISE_64, CodeMask, Dithered, DotGain, Frame,
    FrameRateControl, Levels, Light, R2Noise, RankMask, Rect, Rows,
    display::{
        dither::{CROSS_HATCH_8X8, CROSS_HATCH_16X16, HATCH_8X8, HATCH_16X16, Mask, Method, UnevenRanks},
        halftone::{
            DOTS_4X4, DOTS_6X6, DOTS_8X8, DOTS_45_4X4, DOTS_45_6X6, DOTS_45_8X8, LINES_4X4, LINES_8X8, LINES_45_4X4,
            LINES_45_8X8,
        },
    },
};
use embedded_graphics::pixelcolor::BinaryColor;
use proptest::prelude::*;

use crate::{exact, void_and_cluster};

/// Calls a function for every mask of ranks, with the side of its tile and how many ranks it has.
macro_rules! on_every_rank_mask {
    ($check:ident) => {
        $check(&BAYER_2X2, 4);
        $check(&BAYER_4X4, 16);
        $check(&BAYER_8X8, 64);
        $check(&BAYER_16X16, 256);
        $check(&BLUE_NOISE_16, 256);
        $check(&BLUE_NOISE_64, 256);
        $check(&DOTS_4X4, 16);
        $check(&DOTS_6X6, 36);
        $check(&DOTS_8X8, 64);
        $check(&DOTS_45_4X4, 16);
        $check(&DOTS_45_6X6, 36);
        $check(&DOTS_45_8X8, 64);
        $check(&LINES_4X4, 16);
        $check(&LINES_8X8, 64);
        $check(&LINES_45_4X4, 16);
        $check(&LINES_45_8X8, 64);
        $check(&HATCH_8X8, 64);
        $check(&CROSS_HATCH_8X8, 64);
        $check(&HATCH_16X16, 256);
        $check(&CROSS_HATCH_16X16, 256);
    };
}

/// Thresholds of the tile at the corner of the screen.
fn tile<const N: usize>(mask: &impl Mask) -> [[u16; N]; N] {
    core::array::from_fn(|y| {
        core::array::from_fn(|x| mask.threshold(i32::try_from(x).unwrap(), i32::try_from(y).unwrap()))
    })
}

/// The rank that has a threshold of `(2k + 1) / 2N`, rounded down.
fn rank_of(threshold: u16, ranks: u32) -> u32 {
    let rank = (u32::from(threshold) * ranks) >> 16;
    assert_eq!(u32::from(threshold), 65_536 * (2 * rank + 1) / (2 * ranks), "no threshold of {ranks} ranks");
    rank
}

#[test]
fn every_rank_occurs_equally_often() {
    fn check<const N: usize>(mask: &RankMask<'_, N, N>, ranks: u32) {
        let mut often = vec![0; ranks as usize];
        tile::<N>(mask).as_flattened().iter().for_each(|&at| often[rank_of(at, ranks) as usize] += 1);
        assert_eq!(often, vec![N * N / ranks as usize; ranks as usize]);
    }
    on_every_rank_mask!(check);
}

#[test]
fn every_cell_switches_on_at_the_exact_code() {
    fn check<const N: usize>(mask: &RankMask<'_, N, N>, ranks: u32) {
        let (codes, thresholds) = (CodeMask::srgb(mask), tile::<N>(mask));
        let exact: Vec<u8> = (0..ranks).map(|rank| exact::switch_code(rank, ranks)).collect();
        for (code, threshold) in codes.switch_codes().as_flattened().iter().zip(thresholds.as_flattened()) {
            assert_eq!(*code, exact[rank_of(*threshold, ranks) as usize], "threshold {threshold}");
        }
    }
    on_every_rank_mask!(check);
}

#[test]
fn naive_codes_are_compared_as_they_are() {
    fn check<const N: usize>(mask: &RankMask<'_, N, N>, ranks: u32) {
        let (codes, thresholds) = (CodeMask::naive(mask), tile::<N>(mask));
        for (code, threshold) in codes.switch_codes().as_flattened().iter().zip(thresholds.as_flattened()) {
            let part = 2 * rank_of(*threshold, ranks) + 1;
            let first = (0..=255_u8).find(|&code| u32::from(code) * 2 * ranks > 255 * part);
            assert_eq!(Some(*code), first, "threshold {threshold}");
        }
    }
    on_every_rank_mask!(check);
}

#[test]
fn bayers_masks_double_themselves() {
    fn check<const N: usize, const M: usize>(small: &RankMask<'_, N, N>, large: &RankMask<'_, M, M>) {
        let (cells, quarter) = (u32::try_from(M * M).unwrap(), u32::try_from(N * N).unwrap());
        let (small, large) = (tile::<N>(small), tile::<M>(large));
        for y in 0..M {
            for x in 0..M {
                let added = [[0, 2], [3, 1]][y / N][x / N];
                assert_eq!(rank_of(large[y][x], cells), 4 * rank_of(small[y % N][x % N], quarter) + added);
            }
        }
    }
    check(&RankMask::<1, 1>::new(&[0]).unwrap(), &BAYER_2X2);
    check(&BAYER_2X2, &BAYER_4X4);
    check(&BAYER_4X4, &BAYER_8X8);
    check(&BAYER_8X8, &BAYER_16X16);
}

#[test]
fn blue_noise_is_what_its_generator_makes() {
    let small: Vec<usize> = tile::<16>(&BLUE_NOISE_16).as_flattened().iter().map(|at| usize::from(at >> 8)).collect();
    assert!(small == void_and_cluster::ranks(16, 1), "16 × 16");
    let large: Vec<usize> = tile::<64>(&BLUE_NOISE_64).as_flattened().iter().map(|at| usize::from(at >> 8)).collect();
    let made: Vec<usize> = void_and_cluster::ranks(64, 1).iter().map(|rank| rank / 16).collect();
    assert!(large == made, "64 × 64");
}

/// Pixels that are on in an area of one light.
fn lit<const N: u32>(mask: &impl Mask, light: Light) -> u32 {
    let bytes = vec![0; (N * N / 8) as usize];
    let mut frame = Frame::<BinaryColor, Rows, _>::new(bytes, N, N).unwrap();
    let mut dithered = Dithered::new(&mut frame, Levels::ONE_BIT).with_method(mask);
    let side = i32::try_from(N).unwrap();
    let Ok(()) = dithered.fill_area(Rect::new(0, 0, side, side), light);
    frame.bytes().iter().map(|byte| byte.count_ones()).sum()
}

/// Over all sRGB greys: right to half a shade, never falling, black and white pure.
fn assert_tones<const N: u32>(mask: &impl Mask, half_shade: f64) {
    let on: Vec<u32> = (0..=255).map(|code| lit::<N>(mask, Light::from_srgb(code))).collect();
    assert!(on.is_sorted() && on[0] == 0 && on[255] == N * N, "{on:?}");
    for (code, on) in (0..=255).zip(on) {
        let error = f64::from(on) / f64::from(N * N) - f64::from(Light::from_srgb(code).0) / 65_535.0;
        assert!(error.abs() <= half_shade + 1.0 / 65_536.0, "code {code}: {error}");
    }
}

#[test]
fn a_flat_tone_is_right_to_half_a_shade() {
    fn check<const N: usize>(mask: &RankMask<'_, N, N>, ranks: u32) {
        let half_shade = 0.5 / f64::from(ranks);
        if N == 6 { assert_tones::<24>(mask, half_shade) } else { assert_tones::<64>(mask, half_shade) }
    }
    on_every_rank_mask!(check);
    assert_tones::<8>(&Method::Ordered4x4, 1.0 / 32.0);
    assert_tones::<64>(&R2Noise, 1.0 / 512.0);
    assert_tones::<8>(&FrameRateControl::new(1, 7).unwrap(), 1.0 / 32.0);
    // Each frame by itself is a dither of 17 shades, a little off.
    assert_tones::<8>(&FrameRateControl::new(4, 3).unwrap(), 1.0 / 16.0);
}

#[test]
fn half_of_the_light_is_half_of_the_pixels() {
    assert_eq!(lit::<64>(&BAYER_8X8, Light::from_srgb(188)), 64 * 64 / 2);
    assert!(lit::<64>(&BLUE_NOISE_64, Light::from_srgb(188)).abs_diff(64 * 64 / 2) <= 16);
}

#[test]
fn uneven_ranks_are_refused() {
    assert_eq!(RankMask::<2, 2>::new(&[]), Err(UnevenRanks));
    assert_eq!(RankMask::<0, 0>::new(&[]), Err(UnevenRanks));
    assert_eq!(RankMask::<0, 4>::new(&[0, 1, 2, 3]), Err(UnevenRanks));
    assert_eq!(RankMask::<4, 0>::new(&[0, 1, 2, 3]), Err(UnevenRanks));
    assert_eq!(RankMask::<2, 2>::new(&[0, 1, 2]), Err(UnevenRanks));
    assert_eq!(RankMask::<2, 2>::new(&[0, 1, 2, 3, 4, 5]), Err(UnevenRanks));
    assert_eq!(RankMask::<2, 2>::new(&[0, 1, 1, 2]), Err(UnevenRanks));
    assert_eq!(RankMask::<2, 2>::new(&[0, 1, 2, 4]), Err(UnevenRanks));
    assert_eq!(RankMask::<2, 2>::new(&[1, 2, 3, 4]), Err(UnevenRanks));
    assert_eq!(RankMask::<2, 2>::new(&[255; 4]), Err(UnevenRanks));
    assert!(RankMask::<2, 2>::new(&[0, 1, 1, 0]).is_ok());
    assert!(RankMask::<3, 1>::new(&[2, 0, 1]).is_ok());
    let all: Vec<u8> = (0..=255).chain(0..=255).collect();
    assert!(RankMask::<32, 16>::new(&all).is_ok());
    assert_eq!(RankMask::<32, 16>::new(&all[1..]), Err(UnevenRanks));
}

/// Columns and rows, those at the ends of what there is too.
fn places() -> impl Strategy<Value = i32> {
    prop_oneof![any::<i32>(), -100..100, Just(i32::MIN), Just(i32::MAX), i32::MAX - 20..i32::MAX]
}

/// A row is made of the thresholds of its pixels, and of what is said to repeat.
fn assert_row(mask: &impl Mask, column: i32, row: i32) {
    repeats(mask, column, row);
    for (step, threshold) in (0..80).zip(mask.row(row, column)) {
        assert_eq!(threshold, mask.threshold(column.wrapping_add(step), row), "{step} right of {column}, {row}");
    }
}

fn repeats<M: Mask>(mask: &M, column: i32, row: i32) {
    if M::REPEATS {
        let at = usize::try_from(column & 7).unwrap();
        assert_eq!(mask.eight(row)[at], mask.threshold(column, row));
        assert_eq!(mask.eight(row), mask.eight(row & 7));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn rows_are_made_of_pixels_everywhere((column, row) in (places(), places()), number: u32, frames in 1..=16_u8) {
        assert_row(&Method::Ordered4x4, column, row);
        assert_row(&Method::Nearest, column, row);
        assert_row(&BAYER_2X2, column, row);
        assert_row(&BAYER_16X16, column, row);
        assert_row(&BLUE_NOISE_64, column, row);
        assert_row(&DOTS_8X8, column, row);
        assert_row(&R2Noise, column, row);
        assert_row(&FrameRateControl::new(frames, number).unwrap(), column, row);
        let curve = core::array::from_fn(|at| u16::try_from(at * at * 65_535 / 256).unwrap());
        assert_row(&DotGain::new(&BAYER_8X8, curve).unwrap(), column, row);
        // A period that does not divide 2³² breaks where the numbers do; up to there it holds.
        if column < i32::MAX - 100 {
            assert_row(&DOTS_6X6, column, row);
            assert_row(&RankMask::<3, 1>::new(&[1, 0, 2]).unwrap(), column, row);
        }
    }
}
