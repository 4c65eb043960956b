//! Levels: which light each code of the panel gives. Lecture 7.3.
//!
//! A panel with four bits a pixel has 16 codes, but not 16 equal steps of light: what code 8 gives
//! depends on the controller's grey table. A dither that knows it mixes two neighbouring *lights*
//! in the right proportion; one that does not is wrong by more than any dither can repair.

use crate::{colour::Light, error::describe};

/// The light of each code of a panel, in rising order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Levels<'a> {
    lights: &'a [u16],
}

/// The lights are not 2 to 256 in strictly rising order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotRising;

describe! { NotRising, Self => "the lights are not 2 to 256 in rising order"; }

/// Two neighbouring levels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Step {
    /// Code of the darker one.
    pub(crate) code: u8,
    pub(crate) dark: u16,
    pub(crate) bright: u16,
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

    /// The last two neighbours the darker of which is not brighter than `light`, or the first two.
    pub(crate) fn around(&self, light: Light) -> Step {
        let below = self.lights.partition_point(|&level| level <= light.0);
        let darker = below.saturating_sub(1).min(self.lights.len().saturating_sub(2));
        match self.lights.get(darker..) {
            Some(&[dark, bright, ..]) => Step { code: crate::num::low_u8(low_u32(darker)), dark, bright },
            _ => Step { code: 0, dark: 0, bright: u16::MAX },
        }
    }
}

fn low_u32(index: usize) -> u32 {
    u32::try_from(index).unwrap_or(0)
}

impl Levels<'static> {
    /// One bit: off is black, on is white.
    pub const ONE_BIT: Self = Self { lights: &[0, u16::MAX] };

    /// Four bits in equal steps of light, the factory setting of SSD1322 and SSD1327.
    pub const LINEAR_16: Self = Self {
        lights: &[
            0, 4369, 8738, 13_107, 17_476, 21_845, 26_214, 30_583, 34_952, 39_321, 43_690, 48_059, 52_428, 56_797,
            61_166, 65_535,
        ],
    };

    /// Four bits spaced like sRGB codes (0, 17, 34 … 255), for panels that imitate a monitor.
    pub const SRGB_16: Self = Self { lights: &SRGB_16 };
}

static SRGB_16: [u16; 16] = {
    let mut lights = [0; 16];
    let mut code: u8 = 0;
    while code < 16 {
        lights[code as usize] = Light::from_srgb(code * 17).0;
        code += 1;
    }
    lights
};

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
