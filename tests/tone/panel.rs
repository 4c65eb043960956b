//! Moving light into the range of a panel, against exact fractions.

use aquatint::{Light, PanelRange, tone::panel::NotBrighter};
use proptest::prelude::*;

fn is_right_everywhere(black: u16, white: u16) {
    let range = PanelRange::new(Light(black), Light(white)).expect("brighter");
    let width = u64::from(white - black);
    for light in 0..=u16::MAX {
        // To the nearest: 65535 is odd, so there is no half.
        let exact = u64::from(black) + (u64::from(light) * width * 2 + 65_535) / (2 * 65_535);
        assert_eq!(u64::from(range.to_panel(Light(light)).0), exact, "{light} in {black} to {white}");
    }
    for shown in 0..=u16::MAX {
        let light = range.from_panel(Light(shown));
        let above = u64::from(shown.clamp(black, white) - black) * 65_535;
        // Within half a step and 2⁻¹⁶ of one.
        let error = (u64::from(light.0) * width).abs_diff(above) << 16;
        assert!(error <= width * 0x8001, "{shown} in {black} to {white}");
        assert_eq!(range.to_panel(light), Light(shown.clamp(black, white)), "{shown} in {black} to {white}");
    }
}

#[test]
fn all_lights_of_some_panels() {
    // 33296 and 33649 are wide enough for a division by 65535 that is only almost right to show.
    for (black, white) in [
        (0, 65_535),
        (413, 37_355),
        (0, 33_296),
        (7, 33_656),
        (163, 28_704),
        (0, 65_534),
        (1, 65_535),
        (9, 10),
        (7, 9),
        (0, 1),
    ] {
        is_right_everywhere(black, white);
    }
}

#[test]
fn nothing_changes_on_the_full_range() {
    assert_eq!(PanelRange::new(Light::BLACK, Light::WHITE), Ok(PanelRange::FULL));
}

#[test]
fn white_must_be_brighter() {
    for (black, white) in [(0, 0), (5, 5), (6, 5), (65_535, 0)] {
        assert_eq!(PanelRange::new(Light(black), Light(white)), Err(NotBrighter));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn ends_are_exact_and_order_is_kept(a: u16, b: u16, lights: [u16; 2]) {
        prop_assume!(a != b);
        let (black, white) = (Light(a.min(b)), Light(a.max(b)));
        let range = PanelRange::new(black, white).expect("brighter");
        prop_assert_eq!([Light::BLACK, Light::WHITE].map(|light| range.to_panel(light)), [black, white]);
        prop_assert_eq!([black, white].map(|light| range.from_panel(light)), [Light::BLACK, Light::WHITE]);
        let [dark, bright] = [lights[0].min(lights[1]), lights[0].max(lights[1])].map(Light);
        let shown = Light(dark.0.clamp(black.0, white.0));
        prop_assert_eq!(range.to_panel(range.from_panel(dark)), shown);
        prop_assert!(range.to_panel(dark) <= range.to_panel(bright));
        prop_assert!(range.from_panel(dark) <= range.from_panel(bright));
    }
}
