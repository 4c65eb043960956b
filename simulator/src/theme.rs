//! What panels look like.

use crate::light::{to_channel, to_light};

/// The colours of a panel, as sRGB values a camera would give them under an even light.
///
/// `light` is always the colour of the lightest code. On a panel lit from the front (memory LCD,
/// e-paper, green LCD) that is the paper, and `dark` is the ink.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Theme {
    /// What to call it, in words that fit a command line.
    pub name: &'static str,
    /// The darkest code.
    pub dark: [u8; 3],
    /// The lightest code.
    pub light: [u8; 3],
    /// The space between pixels. On a panel lit from the front this is paper, so a gap draws a fine
    /// grid through large areas of ink.
    pub gap: [u8; 3],
}

impl Theme {
    /// A white OLED: a little blue in the white, and the black of the glass around it.
    pub const OLED_WHITE: Self = Self { name: "oled-white", dark: [9, 10, 13], light: [232, 242, 255], gap: [3, 3, 5] };

    /// A blue OLED, of the light blue that small modules have.
    pub const OLED_BLUE: Self = Self { name: "oled-blue", dark: [6, 9, 15], light: [92, 196, 255], gap: [2, 3, 6] };

    /// A neutral OLED for grey scales: without a tint of its own, greys are judged as greys.
    pub const OLED_GREY: Self = Self { name: "oled-grey", dark: [8, 8, 8], light: [240, 240, 238], gap: [2, 2, 2] };

    /// A memory LCD: a silvery mirror behind nearly black ink.
    pub const MEMORY_LCD: Self =
        Self { name: "memory-lcd", dark: [30, 32, 35], light: [199, 203, 199], gap: [166, 170, 167] };

    /// An LCD with a yellow-green light behind it.
    pub const LCD_GREEN: Self =
        Self { name: "lcd-green", dark: [37, 50, 20], light: [163, 187, 40], gap: [150, 174, 36] };

    /// E-paper: a warm, slightly grey white, and ink that is not quite black. The real thing has no
    /// gaps: look at it with a gap of 0.
    pub const E_PAPER: Self =
        Self { name: "e-paper", dark: [52, 50, 49], light: [226, 222, 211], gap: [217, 213, 202] };

    /// Every theme above.
    pub const ALL: [Self; 6] =
        [Self::OLED_WHITE, Self::OLED_BLUE, Self::OLED_GREY, Self::MEMORY_LCD, Self::LCD_GREEN, Self::E_PAPER];

    /// The colour between `dark`, at 0, and `light`, at 1.
    ///
    /// Light is what adds up in the eye, so the two are mixed as light and the result is encoded as
    /// sRGB again.
    #[must_use]
    pub fn mix(&self, fraction: f32) -> [u8; 3] {
        let fraction = fraction.clamp(0.0, 1.0);
        std::array::from_fn(|channel| {
            let dark = to_light(self.dark[channel]);
            let light = to_light(self.light[channel]);
            to_channel(dark + (light - dark) * fraction)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::Theme;

    #[test]
    fn the_ends_are_exact() {
        for theme in Theme::ALL {
            assert_eq!(theme.mix(0.0), theme.dark, "{}", theme.name);
            assert_eq!(theme.mix(1.0), theme.light, "{}", theme.name);
        }
    }

    #[test]
    fn names_differ() {
        let mut names = Theme::ALL.map(|theme| theme.name).to_vec();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), Theme::ALL.len());
    }

    #[test]
    fn light_is_lighter_than_dark_in_every_channel() {
        for theme in Theme::ALL {
            for channel in 0..3 {
                assert!(theme.light[channel] > theme.dark[channel], "{}", theme.name);
            }
        }
    }
}
