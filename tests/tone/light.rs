//! sRGB both ways, against its definition in whole numbers: no rounding but the one that is tested.

use std::cmp::Ordering;

use crate::exact::compare;
use aquatint::{Light, tone::luma::naive_grey};

/// How `light / white_halves` of white compares with the light of `halves / 510`, by IEC 61966-2-1.
///
/// The upper branch is `((v + 0.055) / 1.055)^(12/5)`, and `v = h/510` makes the base `(20 h + 561) / 10761`.
fn compared(light: u64, of: u64, halves: u64) -> Ordering {
    if halves * 100_000 <= 4045 * 510 {
        return compare(&[(light, 1), (1292 * 510, 1)], &[(halves * 100, 1), (of, 1)]);
    }
    compare(&[(light, 5), (10_761, 12)], &[(20 * halves + 561, 12), (of, 5)])
}

#[test]
fn every_code_decodes_to_the_nearest_light() {
    for code in 0..=255_u8 {
        let (light, halves) = (u64::from(Light::from_srgb(code).0), 2 * u64::from(code));
        assert_ne!(compared(2 * light + 1, 131_070, halves), Ordering::Less, "{code}");
        assert!(light == 0 || compared(2 * light - 1, 131_070, halves).is_le(), "{code}");
    }
}

#[test]
fn every_light_encodes_to_the_nearest_code() {
    for light in 0..=u16::MAX {
        let code = u64::from(Light(light).to_srgb());
        let light = u64::from(light);
        // At or above the border below the code, and below the one above it.
        assert!(code == 0 || compared(light, 65_535, 2 * code - 1).is_ge(), "{light}");
        assert!(code == 255 || compared(light, 65_535, 2 * code + 1).is_lt(), "{light}");
    }
}

#[test]
fn every_code_comes_back() {
    for code in 0..=255 {
        assert_eq!(Light::from_srgb(code).to_srgb(), code);
        assert_eq!(Light::naive_from_code(code).to_naive_code(), code);
    }
    let codes = [0, 1, 32_767, 32_768, u16::MAX].map(|light| Light(light).to_srgb());
    assert_eq!(codes, [0, 0, 188, 188, 255]);
}

#[test]
fn naive_codes_are_the_nearest_too() {
    for light in 0..=u16::MAX {
        assert_eq!(u16::from(Light(light).to_naive_code()), (light / 257) + u16::from(light % 257 > 128));
    }
}

/// The gamma mistake in numbers: the greys of the codes against the luminance of the colours.
#[test]
fn greys_of_codes_are_wrong_by_seventy() {
    use embedded_graphics::pixelcolor::{Gray8, GrayColor, Rgb888};
    let mut worst = 0;
    for rgb @ [red, green, blue] in crate::exact::some_colours(5) {
        let naive = naive_grey(rgb);
        assert_eq!(naive, Gray8::from(Rgb888::new(red, green, blue)).luma(), "{rgb:?}");
        worst = worst.max(naive.abs_diff(Light::from_srgb_colour(rgb).to_srgb()));
    }
    assert!((69..=72).contains(&worst), "{worst}");
}
