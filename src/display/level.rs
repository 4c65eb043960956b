//! Levels: which light each code of the panel gives. Lecture 7.3.
//!
//! A panel with four bits a pixel has 16 codes, but not 16 equal steps of light: what code 8 gives
//! depends on the controller's grey table. A dither that knows it mixes two neighbouring *lights*
//! in the right proportion; one that does not is wrong by more than any dither can repair.

use crate::{
    colour::Light,
    error::describe,
    num::{high_u16, low_index, low_u8},
};

/// The light of each code of a panel, in rising order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Levels<'a> {
    lights: &'a [u16],
}

/// The lights are not 2 to 256 in strictly rising order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NotRising;

describe! { NotRising, Self => "the lights are not 2 to 256 in rising order"; }

/// Two neighbouring levels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Step {
    /// Code of the darker one.
    pub(super) code: u8,
    pub(super) dark: u16,
    pub(super) bright: u16,
}

impl<'a> Levels<'a> {
    /// The levels of a panel that was measured.
    ///
    /// # Errors
    /// [`NotRising`].
    pub const fn new(lights: &'a [u16]) -> Result<Self, NotRising> {
        if lights.len() < 2 || lights.len() > 256 {
            return Err(NotRising);
        }
        let mut code = 1;
        while code < lights.len() {
            if lights[code - 1] >= lights[code] {
                return Err(NotRising);
            }
            code += 1;
        }
        Ok(Self { lights })
    }

    /// The light of a code; `None` beyond the last.
    ///
    /// ```
    /// use aquatint::{Levels, Light};
    ///
    /// assert_eq!(Levels::LINEAR_4.light(1), Some(Light(21_845)));
    /// assert_eq!(Levels::LINEAR_4.light(4), None);
    /// ```
    #[must_use]
    pub fn light(&self, code: u8) -> Option<Light> {
        self.lights.get(usize::from(code)).copied().map(Light)
    }

    /// The last two neighbours the darker of which is not brighter than `light`, or the first two.
    pub(super) fn around(&self, light: Light) -> Step {
        let below = self.lights.partition_point(|&level| level <= light.0);
        let darker = below.saturating_sub(1).min(self.lights.len().saturating_sub(2));
        match self.lights.get(darker..) {
            Some(&[dark, bright, ..]) => Step { code: low_u8(low_index(darker)), dark, bright },
            _ => Step { code: 0, dark: 0, bright: u16::MAX },
        }
    }
}

/// Turns light into codes, by a threshold for each.
///
/// Remembers between which two levels the last light was: light changes little from pixel to pixel, so that most
/// cost two comparisons and no search.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shades<'l> {
    levels: Levels<'l>,
    /// The lights of the step, from the first to the last, which are this far apart.
    from: u16,
    reach: u16,
    dark: u32,
    gap: u32,
    code: u8,
}

impl<'l> Shades<'l> {
    pub(super) const fn new(levels: Levels<'l>) -> Self {
        let (dark, bright) = match levels.lights {
            &[dark, bright, ..] => (dark, bright),
            _ => (0, u16::MAX),
        };
        Self { levels, from: 0, reach: bright, dark: dark as u32, gap: bright.saturating_sub(dark) as u32, code: 0 }
    }

    /// The light of a code.
    pub(super) fn light(&self, code: u8) -> Option<Light> {
        self.levels.light(code)
    }

    /// The code of the brighter of two levels if the light is more than `threshold` / 65536 of the way to it, else
    /// that of the darker.
    #[inline]
    pub(super) fn code(&mut self, light: Light, threshold: u16) -> u8 {
        self.move_to(light);
        // The floor of the product is exact, because lights are whole numbers.
        let switch = self.dark + ((self.gap * u32::from(threshold)) >> 16);
        self.code + u8::from(u32::from(light.0) > switch)
    }

    /// The codes of one light by eight thresholds.
    #[inline]
    pub(super) fn eight(&mut self, light: Light, thresholds: [u16; 8]) -> [u8; 8] {
        self.move_to(light);
        let Self { dark, gap, code, .. } = *self;
        // As above, with the darker level on the other side.
        let above = u32::from(light.0).saturating_sub(dark);
        thresholds.map(|threshold| code + u8::from((gap * u32::from(threshold)) >> 16 < above))
    }

    /// Whether a light is in the step of the last one.
    #[inline]
    pub(super) const fn is_at(&self, light: Light) -> bool {
        light.0.wrapping_sub(self.from) <= self.reach
    }

    /// Whether there are but two levels, so that all lights are between them or beyond.
    #[inline]
    pub(super) const fn is_one_step(&self) -> bool {
        self.levels.lights.len() == 2
    }

    /// Takes the step of a light.
    #[inline]
    pub(super) fn move_to(&mut self, light: Light) {
        if !self.is_at(light) {
            *self = Self::at(self.levels, light);
        }
    }

    /// The darker code of this step.
    #[inline]
    pub(super) const fn darker(&self) -> u8 {
        self.code
    }

    /// The two levels of this step.
    #[inline]
    pub(super) const fn ends(&self) -> (u32, u32) {
        (self.dark, self.dark + self.gap)
    }

    /// The lights that must be exceeded in this step to show the brighter code.
    #[inline]
    pub(super) fn switches(&self, thresholds: [u16; 8]) -> [u32; 8] {
        thresholds.map(|threshold| self.dark + ((self.gap * u32::from(threshold)) >> 16))
    }

    /// By value, so that the caller keeps it in registers.
    #[cold]
    #[inline(never)]
    fn at(levels: Levels<'l>, light: Light) -> Self {
        let Step { code, dark, bright } = levels.around(light);
        // Lights beyond the first and the last level belong to the outer steps.
        let from = dark.min(light.0);
        let reach = bright.max(light.0).saturating_sub(from);
        Self { levels, from, reach, dark: dark.into(), gap: bright.saturating_sub(dark).into(), code }
    }
}

impl Levels<'static> {
    /// One bit: off is black, on is white.
    pub const ONE_BIT: Self = Self { lights: const { &linear_levels::<2>() } };
    /// Two bits in equal steps of light.
    pub const LINEAR_4: Self = Self { lights: const { &linear_levels::<4>() } };
    /// Four bits in equal steps of light, the factory setting of SSD1322 and SSD1327.
    pub const LINEAR_16: Self = Self { lights: const { &linear_levels::<16>() } };
    /// Two bits spaced like sRGB codes (0, 85, 170, 255), for panels that imitate a monitor.
    pub const SRGB_4: Self = Self { lights: const { &srgb_levels::<4>() } };
    /// Three bits spaced like sRGB codes: red and green of `Rgb332`.
    pub const SRGB_8: Self = Self { lights: const { &srgb_levels::<8>() } };
    /// Four bits spaced like sRGB codes (0, 17, 34 … 255), for panels that imitate a monitor.
    pub const SRGB_16: Self = Self { lights: const { &srgb_levels::<16>() } };
    /// Five bits spaced like sRGB codes: red and blue of `Rgb565`.
    pub const SRGB_32: Self = Self { lights: const { &srgb_levels::<32>() } };
    /// Six bits spaced like sRGB codes: green of `Rgb565`.
    pub const SRGB_64: Self = Self { lights: const { &srgb_levels::<64>() } };
}

/// `N` levels in equal steps of light, 2 to 256.
///
/// ```
/// use aquatint::{Levels, display::level::linear_levels};
///
/// static FIVE: [u16; 5] = linear_levels();
/// assert_eq!(FIVE, [0, 16_384, 32_768, 49_151, 65_535]);
/// let levels = Levels::new(&FIVE)?;
/// # Ok::<(), aquatint::display::level::NotRising>(())
/// ```
#[must_use]
pub const fn linear_levels<const N: usize>() -> [u16; N] {
    const { assert!(N >= 2 && N <= 256, "codes are bytes") };
    let (mut lights, mut code) = ([0; N], 0);
    while code < N {
        lights[code] = high_u16(nearest(low_index(code), 0xFFFF, low_index(N - 1)) << 16);
        code += 1;
    }
    lights
}

/// `N` levels spaced like sRGB codes, 2 to 256.
#[must_use]
pub const fn srgb_levels<const N: usize>() -> [u16; N] {
    const { assert!(N >= 2 && N <= 256, "codes are bytes") };
    let (mut lights, mut code) = ([0; N], 0);
    while code < N {
        lights[code] = Light::from_srgb(low_u8(nearest(low_index(code), 255, low_index(N - 1)))).0;
        code += 1;
    }
    lights
}

/// `code` of 0 to `last` as the nearest of 0 to `white`.
const fn nearest(code: u32, white: u32, last: u32) -> u32 {
    (2 * code * white + last) / (2 * last)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_enclose_the_light() {
        let levels = Levels::new(&[100, 200, 1000]).unwrap();
        let cases = [(0, 0), (100, 0), (199, 0), (200, 1), (999, 1), (1000, 1), (65_535, 1)];
        for (light, code) in cases {
            assert_eq!(levels.around(Light(light)).code, code, "{light}");
        }
        assert_eq!(Levels::ONE_BIT.around(Light::WHITE), Step { code: 0, dark: 0, bright: 65_535 });
    }

    #[test]
    fn levels_must_rise() {
        assert!(Levels::new(&[]).is_err() && Levels::new(&[7]).is_err() && Levels::new(&[1, 1]).is_err());
        assert!(Levels::new(&[0; 300]).is_err());
        for levels in [Levels::ONE_BIT, Levels::LINEAR_16, Levels::SRGB_16] {
            assert!(Levels::new(levels.lights).is_ok());
        }
    }
}
