//! HLS and HSV: no colour is lost, and the numbers are those of the books.

use crate::exact::{all_colours, some_colours};
use aquatint::{Hls, Hsv};
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use proptest::prelude::*;

#[test]
fn all_colours_come_back_from_hls() {
    for rgb in all_colours() {
        assert_eq!(Hls::from_rgb(rgb).to_rgb(), rgb);
    }
}

#[test]
fn all_colours_come_back_from_hsv() {
    for rgb in all_colours() {
        assert_eq!(Hsv::from_rgb(rgb).to_rgb(), rgb);
    }
}

#[test]
fn the_corners_of_the_hexagon() {
    let corners = [(255, 0, 0), (255, 255, 0), (0, 255, 0), (0, 255, 255), (0, 0, 255), (255, 0, 255)];
    for (hue, (red, green, blue)) in (0..).step_by(256).zip(corners) {
        let colour = Rgb888::new(red, green, blue);
        assert_eq!(Hls::from(colour), Hls { hue, lightness: 255, saturation: 255 });
        assert_eq!(Hsv::from(colour), Hsv { hue, saturation: 255, value: 255 });
        assert_eq!(Rgb888::from(Hls { hue: hue + 1536 * 3, lightness: 255, saturation: 255 }), colour);
        assert_eq!(Rgb888::from(Hsv { hue: hue + 1536 * 3, saturation: 255, value: 255 }), colour);
    }
    let white = Hls::from(Rgb888::WHITE);
    assert_eq!(white, Hls { hue: 0, lightness: 510, saturation: 0 });
    assert_eq!(Hls { saturation: 255, hue: 700, ..white }.to_rgb(), [255; 3], "the tip of the cone");
}

/// Hue in turns of 6, and the chroma, by the book.
fn book([red, green, blue]: [u8; 3]) -> (f64, f64) {
    let (high, low) = (red.max(green).max(blue), red.min(green).min(blue));
    let chroma = f64::from(high - low);
    let slope = |from: u8, to: u8| (f64::from(to) - f64::from(from)) / chroma;
    let hue = match high {
        _ if high == low => 0.0,
        _ if high == red => slope(blue, green).rem_euclid(6.0),
        _ if high == green => slope(red, blue) + 2.0,
        _ => slope(green, red) + 4.0,
    };
    (hue, chroma)
}

#[test]
fn each_number_is_the_nearest_to_the_one_in_the_book() {
    let near = |got: f64, exact: f64| (got - exact).abs() <= 0.5 + 1e-9;
    for rgb in some_colours(5) {
        let exact = rgb.map(f64::from);
        let (hue, chroma) = book(rgb);
        let (high, low) = (exact.into_iter().fold(0.0, f64::max), exact.into_iter().fold(255.0, f64::min));
        let lightness = (high + low) / 510.0;
        let hls = Hls::from_rgb(rgb);
        let saturation = if chroma == 0.0 { 0.0 } else { chroma / (1.0 - (2.0 * lightness - 1.0).abs()) };
        assert!((f64::from(hls.lightness) - (high + low)).abs() < 1e-9, "{rgb:?}");
        assert!(near(f64::from(hls.saturation), saturation), "{rgb:?}: {hls:?} {saturation}");
        let around = (f64::from(hls.hue) - hue * 256.0).abs();
        assert!(near(around.min(1536.0 - around), 0.0) && hls.hue < 1536, "{rgb:?}: {hls:?}");
        let hsv = Hsv::from_rgb(rgb);
        assert_eq!((hsv.hue, f64::from(hsv.value)), (hls.hue, high));
        assert!(near(f64::from(hsv.saturation), if high == 0.0 { 0.0 } else { chroma / high * 255.0 }), "{rgb:?}");
    }
}

/// The exact colour of a hue with a lowest and a highest channel.
fn exact_colour(hue: u16, low: f64, high: f64) -> [f64; 3] {
    let turn = f64::from(hue % 1536) / 256.0;
    [0.0, 4.0, 2.0].map(|shift| {
        let place = (turn + shift).rem_euclid(6.0);
        low + (high - low) * ((place - 3.0).abs() - 1.0).clamp(0.0, 1.0)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    /// Whatever the numbers are, each channel is within a code of the exact one.
    #[test]
    fn any_numbers_are_a_colour(hue: u16, lightness in prop_oneof![0..600_u16, any::<u16>()], saturation: u8) {
        let full = f64::from(lightness.min(510));
        let chroma = full.min(510.0 - full) * f64::from(saturation) / 255.0;
        let exact = exact_colour(hue, f64::midpoint(full, -chroma), f64::midpoint(full, chroma));
        for (got, exact) in (Hls { hue, lightness, saturation }).to_rgb().into_iter().zip(exact) {
            prop_assert!((f64::from(got) - exact).abs() <= 1.0 + 1e-9, "{got} {exact}");
        }
        let value = lightness.to_le_bytes()[0];
        let chroma = f64::from(value) * f64::from(saturation) / 255.0;
        let exact = exact_colour(hue, f64::from(value) - chroma, f64::from(value));
        for (got, exact) in (Hsv { hue, saturation, value }).to_rgb().into_iter().zip(exact) {
            prop_assert!((f64::from(got) - exact).abs() <= 1.0 + 1e-9, "{got} {exact}");
        }
    }
}
