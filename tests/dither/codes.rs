//! Rows of codes to bits: the same as decoding and comparing.

use aquatint::{
    BAYER_2X2, BAYER_4X4, BAYER_8X8, BAYER_16X16, BLUE_NOISE_64, Code, CodeMask, Columns, Dithered, DotGain, Frame,
    Inverted, Levels, Light, LsbFirst, Pages, R2Noise, RankMask, Rows, Target,
    display::{
        dither::{Mask, PackedRows},
        halftone::DOTS_6X6,
        layout::Layout,
    },
};
use embedded_graphics::{geometry::Point, pixelcolor::BinaryColor};
use proptest::{collection::vec, prelude::*};

const WIDTH: u32 = 67;
const HEIGHT: u32 = 3;

type Bits<L> = Frame<BinaryColor, L, Vec<u8>>;

fn frame<L: Layout<BinaryColor>>(memory: u8) -> Bits<L> {
    let needed = Frame::<BinaryColor, L, ()>::bytes_needed(WIDTH, HEIGHT);
    Frame::new(vec![memory; needed + 1], WIDTH, HEIGHT).unwrap()
}

/// Decodes and compares.
fn decoded<L: Layout<BinaryColor>>(mask: &impl Mask, at: Point, codes: &[u8], memory: u8) -> Bits<L> {
    let mut frame = frame::<L>(memory);
    let columns = at.x..at.x.saturating_add(i32::try_from(codes.len()).unwrap());
    let lights = codes.iter().map(|&code| Some(Light::from_srgb(code)));
    let Ok(()) = Dithered::new(&mut frame, Levels::ONE_BIT).with_method(mask).write_run(at.y, columns, lights);
    frame
}

fn assert_run<L: Layout<BinaryColor>, const W: usize, const H: usize>(
    (mask, codes): (&impl Mask, &CodeMask<W, H>),
    (at, row, memory): (Point, &[u8], u8),
) {
    let mut run = frame::<L>(memory);
    let Ok(()) = codes.write_run(&mut run, at, row);
    assert_eq!(run.memory(), decoded::<L>(mask, at, row, memory).memory(), "{at}");
}

fn assert_rows<L: Layout<BinaryColor> + PackedRows, const W: usize, const H: usize>(
    (mask, codes): (&impl Mask, &CodeMask<W, H>),
    (at, row, memory): (Point, &[u8], u8),
) {
    let mut rows = frame::<L>(memory);
    codes.write_rows(&mut rows, at, row);
    assert_eq!(rows.memory(), decoded::<L>(mask, at, row, memory).memory(), "{at}");
}

fn assert_codes<const W: usize, const H: usize>(mask: &RankMask<'_, W, H>, case: (Point, &[u8], u8)) {
    let codes = CodeMask::srgb(mask);
    assert_rows::<Rows, W, H>((mask, &codes), case);
    assert_rows::<Rows<LsbFirst>, W, H>((mask, &codes), case);
    assert_rows::<Inverted<Rows>, W, H>((mask, &codes), case);
    assert_run::<Rows, W, H>((mask, &codes), case);
    assert_run::<Pages, W, H>((mask, &codes), case);
    assert_run::<Columns, W, H>((mask, &codes), case);
}

/// Where a row begins: mostly so that a part of it is seen.
fn places() -> impl Strategy<Value = Point> {
    let x = prop_oneof![8 => -40..70_i32, 1 => any::<i32>(), 1 => Just(i32::MIN), 1 => Just(i32::MAX)];
    let y = prop_oneof![8 => 0..3_i32, 1 => any::<i32>(), 1 => Just(i32::MIN), 1 => Just(i32::MAX)];
    (x, y).prop_map(Point::from)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn bits_are_those_of_decoded_light(at in places(), row in vec(any::<u8>(), 0..140), memory: u8) {
        let case = (at, &row[..], memory);
        assert_codes(&BAYER_2X2, case);
        assert_codes(&BAYER_4X4, case);
        assert_codes(&BAYER_8X8, case);
        assert_codes(&BAYER_16X16, case);
        assert_codes(&RankMask::<1, 3>::new(&[2, 0, 1]).unwrap(), case);
        assert_codes(&RankMask::<5, 1>::new(&[2, 0, 1, 4, 3]).unwrap(), case);
        assert_codes(&DOTS_6X6, case);
    }
}

#[test]
fn every_code_at_every_cell_of_a_wide_mask() {
    static CODES: CodeMask<64, 64> = CodeMask::srgb(&BLUE_NOISE_64);
    for y in 0..64 {
        for (x, &switch) in (0..).zip(&CODES.switch_codes()[y]) {
            let threshold = u32::from(BLUE_NOISE_64.threshold(x, i32::try_from(y).unwrap()));
            let first = (0..=255).find(|&code| u32::from(Light::from_srgb(code).0) > (65_535 * threshold) >> 16);
            assert_eq!(Some(switch), first);
        }
    }
    let ramp: Vec<u8> = (0..=255).collect();
    for x in [-100, -3, 0, 5] {
        assert_codes(&BLUE_NOISE_64, (Point::new(x, 2), &ramp, 0x5A));
    }
}

#[test]
fn computed_masks_and_other_curves_have_switch_codes_too() {
    let lights = core::array::from_fn(|code| Light::from_srgb(u8::try_from(code).unwrap()).0);
    assert_eq!(CodeMask::of_mask(&BAYER_4X4, &lights), CodeMask::srgb(&BAYER_4X4));
    let gain =
        DotGain::new(BAYER_4X4, core::array::from_fn(|at| u16::try_from(at * at * 65_535 / 256).unwrap())).unwrap();
    let (codes, ramp): (CodeMask<4, 4>, Vec<u8>) = (CodeMask::of_mask(&gain, &lights), (0..=255).collect());
    assert_rows::<Rows, 4, 4>((&gain, &codes), (Point::new(-150, 1), &ramp, 0));
    let noise: CodeMask<32, 3> = CodeMask::of_mask(&R2Noise, &lights);
    assert_rows::<Rows, 32, 3>((&R2Noise, &noise), (Point::new(0, 1), &ramp[..32], 0));
    // Black stays black and white stays white, whatever the curve says.
    for lights in [[0; 256], [65_535; 256]] {
        for code in CodeMask::with_curve(&BAYER_4X4, &lights).switch_codes().as_flattened() {
            assert!((1..=255).contains(code));
        }
    }
    assert_eq!(BinaryColor::BITS, 1);
}
