//! Gammas against powers of whole numbers: `a/b < (c/d)^(p/q)` where `a^q d^p < c^p b^q`.

use std::cmp::Ordering;

use crate::exact::compare;
use aquatint::{
    Gamma, Light,
    tone::gamma::{HDTV, NTSC, PAL},
};
use proptest::prelude::*;

/// How a part of the white compares with the light of `halves / 510`.
fn compared(light: u64, of: u64, halves: u64, (p, q): (u32, u32)) -> Ordering {
    compare(&[(light, q), (510, p)], &[(halves, p), (of, q)])
}

fn decodes_to_the_nearest(gamma: &Gamma, code: u8, exponent: (u32, u32)) -> bool {
    let (light, halves) = (u64::from(gamma.decode(code).0), 2 * u64::from(code));
    compared(2 * light + 1, 131_070, halves, exponent).is_ge()
        && (light == 0 || compared(2 * light - 1, 131_070, halves, exponent).is_le())
}

fn encodes_to_the_nearest(gamma: &Gamma, light: u16, exponent: (u32, u32)) -> bool {
    let (code, light) = (u64::from(gamma.encode(Light(light))), u64::from(light));
    (code == 0 || compared(light, 65_535, 2 * code - 1, exponent).is_ge())
        && (code == 255 || compared(light, 65_535, 2 * code + 1, exponent).is_lt())
}

/// The lights where the code changes, and their neighbours below: if these are right, all are.
fn borders(gamma: &Gamma) -> impl Iterator<Item = u16> {
    let codes: Vec<u8> = (0..=u16::MAX).map(|light| gamma.encode(Light(light))).collect();
    assert!(codes.is_sorted() && codes.first() == Some(&0) && codes.last() == Some(&255));
    let changes = (1..=u16::MAX).filter(move |&at| codes[usize::from(at)] != codes[usize::from(at) - 1]);
    changes.flat_map(|at| [at - 1, at]).chain([0, u16::MAX])
}

#[test]
fn the_gammas_of_the_lecture_are_exact() {
    for (gamma, exponent) in [(&NTSC, (11, 5)), (&HDTV, (5, 2)), (&PAL, (14, 5))] {
        assert!((0..=255).all(|code| decodes_to_the_nearest(gamma, code, exponent)), "{exponent:?}");
        assert!(borders(gamma).all(|light| encodes_to_the_nearest(gamma, light, exponent)), "{exponent:?}");
    }
}

/// The lecture: "light at 50 % intensity is generated with an 8-bit value of 186", for 2.2.
#[test]
fn half_of_the_light() {
    let half = Light(u16::MAX / 2);
    assert_eq!([&NTSC, &HDTV, &PAL].map(|gamma| gamma.encode(half)), [186, 193, 199]);
}

#[test]
fn codes_come_back_but_for_the_darkest() {
    let first_that_stays = |gamma: &Gamma| {
        (0..=255).rev().take_while(|&code| gamma.encode(gamma.decode(code)) == code).last().expect("255")
    };
    assert_eq!([&NTSC, &HDTV, &PAL].map(first_that_stays), [2, 3, 5]);
    let black = |gamma: &Gamma| (0..=255).take_while(|&code| gamma.decode(code) == Light::BLACK).count();
    assert_eq!([&NTSC, &HDTV, &PAL].map(black), [2, 3, 4]);
}

#[test]
fn gamma_one_takes_codes_for_light() {
    for gamma in [Gamma::new(1, 1), Gamma::new(255, 255)] {
        for light in 0..=u16::MAX {
            assert_eq!(gamma.encode(Light(light)), Light(light).to_naive_code());
        }
        assert!((0..=255).all(|code| gamma.decode(code) == Light::naive_from_code(code)));
    }
}

#[test]
fn gammas_beyond_an_eighth_and_eight_are_moved_there() {
    assert_eq!(Gamma::new(255, 1), Gamma::new(8, 1));
    assert_eq!(Gamma::new(0, 0), Gamma::new(8, 1));
    assert_eq!(Gamma::new(3, 0), Gamma::new(8, 1));
    assert_eq!(Gamma::new(0, 255), Gamma::new(1, 8));
    assert_ne!(Gamma::new(79, 10), Gamma::new(8, 1));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    /// Any exponent, any code and light: within half a step and 2⁻²⁰ of one.
    #[test]
    fn any_gamma_is_right(numerator: u8, denominator: u8, code: u8, light: u16) {
        let gamma = Gamma::new(numerator, denominator);
        let exponent = (f64::from(numerator) / f64::from(denominator)).clamp(0.125, 8.0);
        let exponent = if denominator == 0 { 8.0 } else { exponent };
        let exact = (f64::from(code) / 255.0).powf(exponent) * 65_535.0;
        let error = (exact - f64::from(gamma.decode(code).0)).abs();
        prop_assert!(error <= 0.500_001, "{error}");
        // The lights of the borders around the code that was given.
        let given = f64::from(gamma.encode(Light(light)));
        let border = |code: f64| (code / 255.0).max(0.0).powf(exponent) * 65_535.0;
        prop_assert!(border(given - 0.5) <= f64::from(light) + 1e-6);
        prop_assert!(given >= 255.0 || f64::from(light) <= border(given + 0.5) + 1e-6);
    }
}
