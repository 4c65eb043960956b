//! Toon shading: light in a few bands, with edges between them, as in a comic strip.
//!
//! ```text
//!   light ┤            ┌───          shaded          in 3 bands
//!         │       ┌────┘             ░░▒▒▓▓███       ░░░▒▒▒▒███
//!         │   ┌───┘
//!         └───┴───────────
//! ```
//!
//! - **Takes** the light of a fragment. Computed for each pixel ([Phong](crate::illumination)) the bands have round
//!   edges, between the lights of vertices they have straight ones.
//! - **Gives** the light of its band.
//! - **Memory** none.
//! - **Cost** two multiplications; spaced for the eye, sixteen comparisons more.
//!
//! On one bit each band gets its own dither, best by strokes:
//! [`CROSS_HATCH_8X8`](crate::display::dither::CROSS_HATCH_8X8).

use crate::{
    colour::Light,
    num::{high_u16, low_u8},
};

/// A number of bands of light, from black to white.
///
/// ```
/// use aquatint::{Light, fragment::toon::Bands};
///
/// let bands = Bands::even(3).unwrap();
/// let lights = [5_000, 30_000, 40_000, 60_000].map(Light);
/// assert_eq!(lights.map(|light| bands.of(light)), [0, 32_767, 32_767, 65_535].map(Light));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bands {
    count: u8,
    /// From band to band, of light or of sRGB codes, in 16.16 rounded up: the last is white.
    step: u32,
    /// Bands are of the same width in sRGB codes, not in light.
    for_the_eye: bool,
}

impl Bands {
    /// Bands of the same width in light: 2 to 255. `None` for fewer.
    #[must_use]
    pub const fn even(count: u8) -> Option<Self> {
        Self::new(count, u16::MAX as u32, false)
    }

    /// Bands of the same width to the eye, so narrower where it is dark: 2 to 255. `None` for fewer.
    #[must_use]
    pub const fn even_to_the_eye(count: u8) -> Option<Self> {
        Self::new(count, u8::MAX as u32, true)
    }

    const fn new(count: u8, white: u32, for_the_eye: bool) -> Option<Self> {
        match count.checked_sub(1) {
            None | Some(0) => None,
            Some(last) => Some(Self { count, step: (white << 16).div_ceil(last as u32), for_the_eye }),
        }
    }

    /// The light of the band that a light lies in. Black and white stay what they are.
    #[inline]
    #[must_use]
    pub fn of(self, light: Light) -> Light {
        let count = u32::from(self.count);
        if self.for_the_eye {
            let band = (u32::from(light.to_srgb()) * count) >> 8;
            Light::from_srgb(low_u8((band * self.step + (1 << 15)) >> 16))
        } else {
            let band = (u32::from(light.0) * count) >> 16;
            Light(high_u16(band * self.step))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_of_bands_has_as_many_lights() {
        for count in 2..=255_u8 {
            for bands in [Bands::even(count).unwrap(), Bands::even_to_the_eye(count).unwrap()] {
                let lights = (0..=u16::MAX).map(|light| bands.of(Light(light)));
                assert!(lights.clone().is_sorted());
                let mut seen: heapless::Vec<Light, 256> = heapless::Vec::new();
                for light in lights {
                    if seen.last() != Some(&light) {
                        seen.push(light).unwrap();
                    }
                }
                assert_eq!(
                    (seen.len(), seen.first(), seen.last()),
                    (count.into(), Some(&Light(0)), Some(&Light::WHITE))
                );
            }
        }
    }

    #[test]
    fn bands_are_of_the_same_width() {
        let bands = Bands::even(4).unwrap();
        let edges = [0, 16_383, 16_384, 32_767, 32_768, 49_151, 49_152, 65_535].map(|light| bands.of(Light(light)).0);
        assert_eq!(edges, [0, 0, 21_845, 21_845, 43_690, 43_690, 65_535, 65_535]);
        let eye = Bands::even_to_the_eye(3).unwrap();
        assert_eq!([85, 86, 170, 171].map(|code| eye.of(Light::from_srgb(code)).to_srgb()), [0, 128, 128, 255]);
        assert_eq!([Bands::even(0), Bands::even(1), Bands::even_to_the_eye(1)], [None; 3]);
    }
}
