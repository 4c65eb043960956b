//! Colour panels: channels and inks.

use aquatint::{
    BAYER_4X4, ChannelLevels, DitheredDrawTarget, FourColor, Frame, InkMix, Light, Palette, Rgb332, Rows, SevenColor,
    SixColor, ThreeColor, Words,
    display::{
        dither::{IntoSrgb, Quantise},
        palette::{FromChannels, NOMINAL_4, NOMINAL_7, NOMINAL_RED, NOMINAL_YELLOW, SPECTRA_6},
    },
};
use embedded_graphics::{
    draw_target::DrawTarget,
    geometry::Point,
    image::GetPixel,
    pixelcolor::{
        Rgb565, Rgb888, RgbColor,
        raw::{RawData, RawU2, RawU4},
    },
};
use proptest::prelude::*;

/// What sixteen pixels show of a colour.
fn sixteen<C, Q: Quantise<C, From = Rgb888>>(mut quantiser: Q, [red, green, blue]: [u8; 3]) -> Vec<C> {
    let mut cell = |rank: u16| quantiser.quantise(Rgb888::new(red, green, blue), 4096 * rank + 2048);
    (0..16).map(&mut cell).collect()
}

fn lights(srgb: [u8; 3]) -> [f64; 3] {
    srgb.map(|code| f64::from(Light::from_srgb(code).0) / 65_535.0)
}

fn mean(colors: &[[f64; 3]]) -> [f64; 3] {
    core::array::from_fn(|channel| colors.iter().map(|color| color[channel]).sum::<f64>() / 16.0)
}

/// By the weights of the choice.
fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let [red, green, blue] = core::array::from_fn(|channel| (a[channel] - b[channel]).powi(2));
    (2.0 * red + 4.0 * green + blue).sqrt()
}

/// In each channel the mean of sixteen pixels is right to 1/32 of the step, and the pixels are its two neighbours.
fn assert_channels<C: FromChannels + RgbColor + IntoSrgb>(srgb: [u8; 3]) {
    let cell = sixteen::<C, _>(ChannelLevels::srgb::<C>(), srgb);
    let shown: Vec<_> = cell.iter().map(|color| color.into_srgb()).collect();
    let mean = mean(&shown.iter().map(|&color| lights(color)).collect::<Vec<_>>());
    for (channel, meant) in lights(srgb).into_iter().enumerate() {
        let codes = shown.iter().map(|color| color[channel]);
        let [least, most] = [codes.clone().min().unwrap(), codes.max().unwrap()];
        let step = f64::from(most - least);
        assert!(step <= 86.0 && (mean[channel] - meant).abs() <= 0.5 / 16.0 * 0.57 + 0.001, "{srgb:?}: {shown:?}");
        assert!(least.min(srgb[channel]) == least || most >= srgb[channel], "{srgb:?}: {shown:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn channels_are_mixed_to_their_light(srgb: [u8; 3]) {
        assert_channels::<Rgb332>(srgb);
        assert_channels::<Rgb565>(srgb);
    }

    /// Choosing greedily, the mean of sixteen is nearer than any single ink, or as near.
    #[test]
    fn a_mixture_of_inks_is_nearer_than_the_nearest_ink(srgb: [u8; 3]) {
        let inks = [
            (SevenColor::Black, [0, 0, 0]), (SevenColor::White, [255, 255, 255]), (SevenColor::Green, [0, 255, 0]),
            (SevenColor::Blue, [0, 0, 255]), (SevenColor::Red, [255, 0, 0]), (SevenColor::Yellow, [255, 255, 0]),
            (SevenColor::Orange, [255, 128, 0]),
        ];
        let cell = sixteen(InkMix::new(&NOMINAL_7), srgb);
        let ink = |color: &SevenColor| lights(inks.iter().find(|(ink, _)| ink == color).unwrap().1);
        let mixed = distance(mean(&cell.iter().map(ink).collect::<Vec<_>>()), lights(srgb));
        let single = inks.iter().map(|&(_, ink)| distance(lights(ink), lights(srgb))).fold(9.0, f64::min);
        assert!(mixed <= single + 0.01, "{srgb:?}: {mixed}, {single}: {cell:?}");
        // Cyan and magenta are the farthest from what seven inks mix; a colour that is not, is met to a sixteenth.
        assert!(mixed <= 1.0, "{srgb:?}: {mixed}: {cell:?}");
    }
}

#[test]
fn greys_of_black_and_white_are_seventeen_shades() {
    let palette = Palette::new([(ThreeColor::White, [255; 3]), (ThreeColor::Black, [0; 3])]);
    for code in 0..=255_u8 {
        let white = sixteen(InkMix::new(&palette), [code; 3]);
        let white = u16::try_from(white.iter().filter(|&&ink| ink == ThreeColor::White).count()).unwrap();
        let error = f64::from(white) / 16.0 - lights([code; 3])[0];
        assert!(error.abs() <= 1.0 / 32.0 + 1.0 / 512.0, "code {code}: {error}");
    }
}

/// Black is all black and white all white, and the bright inks have the low thresholds.
fn assert_ends<C: Copy + PartialEq + core::fmt::Debug, const N: usize>(palette: &Palette<C, N>, black: C, white: C) {
    assert_eq!(sixteen(InkMix::new(palette), [0; 3]), [black; 16]);
    assert_eq!(sixteen(InkMix::new(palette), [255; 3]), [white; 16]);
    let grey = sixteen(InkMix::new(palette), [128; 3]);
    assert!(grey[0] != black && grey[15] != white, "{grey:?}");
}

#[test]
fn black_is_black_and_white_is_white_in_every_palette() {
    assert_ends(&NOMINAL_RED, ThreeColor::Black, ThreeColor::White);
    assert_ends(&NOMINAL_YELLOW, ThreeColor::Black, ThreeColor::White);
    assert_ends(&NOMINAL_4, FourColor::Black, FourColor::White);
    assert_ends(&SPECTRA_6, SixColor::Black, SixColor::White);
    assert_ends(&NOMINAL_7, SevenColor::Black, SevenColor::White);
}

#[test]
fn a_named_colour_is_its_ink() {
    assert_eq!(sixteen(InkMix::new(&NOMINAL_RED), [255, 0, 0]), [ThreeColor::Chromatic; 16]);
    assert_eq!(sixteen(InkMix::new(&NOMINAL_4), [255, 255, 0]), [FourColor::Yellow; 16]);
    assert_eq!(sixteen(InkMix::new(&NOMINAL_7), [255, 128, 0]), [SevenColor::Orange; 16]);
    assert_eq!(sixteen(InkMix::new(&NOMINAL_7), [0, 0, 255]), [SevenColor::Blue; 16]);
}

#[test]
fn inks_and_channels_are_drawn_like_greys() {
    let mut frame = Frame::<SixColor, Rows, _>::with_array([0; 32], 8, 8).unwrap();
    let mut display = DitheredDrawTarget::new(&mut frame, InkMix::<Rgb888, _, 6>::new(&SPECTRA_6), BAYER_4X4);
    let Ok(()) = display.clear(Rgb888::new(200, 150, 100));
    let expected = sixteen(InkMix::new(&SPECTRA_6), [200, 150, 100]);
    let ranks = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];
    for (x, y) in (0..8).flat_map(|x| (0..8).map(move |y| (x, y))) {
        let rank = ranks[usize::try_from(y % 4).unwrap()][usize::try_from(x % 4).unwrap()];
        assert_eq!(frame.pixel(Point::new(x, y)), Some(expected[rank]));
    }
    let mut frame = Frame::<Rgb565, Words, _>::with_array([0; 128], 8, 8).unwrap();
    let mut display = DitheredDrawTarget::new(&mut frame, ChannelLevels::<Rgb888>::srgb::<Rgb565>(), BAYER_4X4);
    let Ok(()) = display.clear(Rgb888::WHITE);
    assert_eq!(frame.bytes(), [0xFF; 128]);
}

#[test]
fn codes_of_the_inks_survive_both_ways() {
    for code in [0, 1, 2, 3] {
        assert_eq!(RawU2::from(FourColor::from(RawU2::new(code))).into_inner(), code);
    }
    for code in 0..16 {
        let six = RawU4::from(SixColor::from(RawU4::new(code))).into_inner();
        assert_eq!(six, if [0, 1, 2, 3, 5, 6].contains(&code) { code } else { 1 });
        let seven = RawU4::from(SevenColor::from(RawU4::new(code))).into_inner();
        assert_eq!(seven, if code < 7 { code } else { 1 });
    }
}
