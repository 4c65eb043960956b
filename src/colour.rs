//! Light: the one quantity that may be added, averaged and compared. Lecture 7.3.
//!
//! The number in a picture file is not an amount of light but a *code*, spaced for the eye: code
//! 128 of 255 stands for 22 % of the light. Whatever is computed on codes comes out wrong. So the
//! crate decodes once, computes in linear light to the very end, and turns light into what the
//! panel shows in the last step.
//!
//! ```text
//!   code 0…255 ── from_srgb ──▶ light 0…65535 ──▶ add, shade, blend, filter ── to_srgb ──▶ code 0…255
//! ```
//!
//! Both ways are tables (512 bytes of flash each, only if used), computed with exact arithmetic.
//! Other curves are in [`tone::gamma`](crate::tone::gamma).

use embedded_graphics::pixelcolor::{
    PixelColor,
    raw::{RawData, RawU16},
};

use crate::num::{high_u16, low_u8};

/// An amount of light, linear: 0 is the panel's black, 65535 its white.
///
/// It is a colour of embedded-graphics of sixteen bits, so that a picture may be kept in light:
/// a [`Frame`](crate::Frame) of it in [`Words`](crate::Words) has two bytes a pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Light(pub u16);

impl PixelColor for Light {
    type Raw = RawU16;
}

impl From<RawU16> for Light {
    fn from(raw: RawU16) -> Self {
        Self(raw.into_inner())
    }
}

impl From<Light> for RawU16 {
    fn from(light: Light) -> Self {
        Self::new(light.0)
    }
}

impl Light {
    /// None.
    pub const BLACK: Self = Self(0);
    /// All that the panel has.
    pub const WHITE: Self = Self(u16::MAX);

    /// The light of a grey in an sRGB picture, exact to the nearest of the 65,536 steps. One load.
    #[must_use]
    pub const fn from_srgb(code: u8) -> Self {
        Self(SRGB_TO_LIGHT[code as usize])
    }

    /// The luminance of a colour in an sRGB picture, by the weights of ITU-R BT.709 (also those of
    /// sRGB) on linear light. They sum to 65536, so greys keep their light exactly.
    #[must_use]
    pub const fn from_srgb_colour([red, green, blue]: [u8; 3]) -> Self {
        let weighed = Self::from_srgb(red).0 as u32 * 13_933
            + Self::from_srgb(green).0 as u32 * 46_871
            + Self::from_srgb(blue).0 as u32 * 4_732;
        Self(high_u16(weighed + 0x8000))
    }

    /// The sRGB code of this light: the exact code, rounded to the nearest, for each of the 65,536 lights.
    ///
    /// Every code survives `from_srgb` and `to_srgb`. Eight comparisons, no division.
    ///
    /// ```
    /// use aquatint::Light;
    ///
    /// // The mean of black and white is code 188, not 128.
    /// assert_eq!(Light(u16::MAX / 2).to_srgb(), 188);
    /// assert_eq!(Light::from_srgb(188).to_srgb(), 188);
    /// ```
    #[must_use]
    pub const fn to_srgb(self) -> u8 {
        self.code_in(&FIRST_LIGHT_OF_SRGB)
    }

    /// A code taken for an amount of light, as most libraries do it. **Naive**: it is right only where the
    /// numbers are amounts of light already, as coverage is, or for a panel of gamma 1.
    ///
    /// ```
    /// # use aquatint::Light;
    /// assert_eq!(Light::naive_from_code(128), Light(0x8080)); // half, where an sRGB picture means 22 %
    /// assert_eq!(Light::naive_from_code(128).to_naive_code(), 128);
    /// ```
    #[must_use]
    pub const fn naive_from_code(code: u8) -> Self {
        Self(code as u16 * 257)
    }

    /// The nearest code of a panel whose codes are equal steps of light. **Naive** for any other.
    #[must_use]
    pub const fn to_naive_code(self) -> u8 {
        // light / 257, rounded: exact for all 65,536 lights.
        low_u8((self.0 as u32 * 255 + 32_895) >> 16)
    }

    /// What is left of it by a surface that gives back a part of 65535; of all, all.
    #[inline]
    pub(crate) const fn reflected(self, part: u16) -> Self {
        Self(high_u16(self.0 as u32 * (part as u32 + 1)))
    }

    /// The last code that begins at this light or below, by a binary search; `first` does not fall.
    pub(crate) const fn code_in(self, first: &[u16; 256]) -> u8 {
        let (mut code, mut bit) = (0, 0x80_u8);
        while bit > 0 {
            // An index of eight bits into 256 entries: no test of bounds.
            if self.0 >= first[(code | bit) as usize] {
                code |= bit;
            }
            bit >>= 1;
        }
        code
    }
}

/// The sRGB decoding curve (IEC 61966-2-1): light of each code, 0 to 65535, rounded to the nearest.
#[rustfmt::skip]
static SRGB_TO_LIGHT: [u16; 256] = [
    0, 20, 40, 60, 80, 99, 119, 139, 159, 179, 199, 219,
    241, 264, 288, 313, 340, 367, 396, 427, 458, 491, 526, 562,
    599, 637, 677, 718, 761, 805, 851, 898, 947, 997, 1048, 1101,
    1156, 1212, 1270, 1330, 1391, 1453, 1517, 1583, 1651, 1720, 1790, 1863,
    1937, 2013, 2090, 2170, 2250, 2333, 2418, 2504, 2592, 2681, 2773, 2866,
    2961, 3058, 3157, 3258, 3360, 3464, 3570, 3678, 3788, 3900, 4014, 4129,
    4247, 4366, 4488, 4611, 4736, 4864, 4993, 5124, 5257, 5392, 5530, 5669,
    5810, 5953, 6099, 6246, 6395, 6547, 6700, 6856, 7014, 7174, 7335, 7500,
    7666, 7834, 8004, 8177, 8352, 8528, 8708, 8889, 9072, 9258, 9445, 9635,
    9828, 10_022, 10_219, 10_417, 10_619, 10_822, 11_028, 11_235, 11_446, 11_658, 11_873, 12_090,
    12_309, 12_530, 12_754, 12_980, 13_209, 13_440, 13_673, 13_909, 14_146, 14_387, 14_629, 14_874,
    15_122, 15_371, 15_623, 15_878, 16_135, 16_394, 16_656, 16_920, 17_187, 17_456, 17_727, 18_001,
    18_277, 18_556, 18_837, 19_121, 19_407, 19_696, 19_987, 20_281, 20_577, 20_876, 21_177, 21_481,
    21_787, 22_096, 22_407, 22_721, 23_038, 23_357, 23_678, 24_002, 24_329, 24_658, 24_990, 25_325,
    25_662, 26_001, 26_344, 26_688, 27_036, 27_386, 27_739, 28_094, 28_452, 28_813, 29_176, 29_542,
    29_911, 30_282, 30_656, 31_033, 31_412, 31_794, 32_179, 32_567, 32_957, 33_350, 33_745, 34_143,
    34_544, 34_948, 35_355, 35_764, 36_176, 36_591, 37_008, 37_429, 37_852, 38_278, 38_706, 39_138,
    39_572, 40_009, 40_449, 40_891, 41_337, 41_785, 42_236, 42_690, 43_147, 43_606, 44_069, 44_534,
    45_002, 45_473, 45_947, 46_423, 46_903, 47_385, 47_871, 48_359, 48_850, 49_344, 49_841, 50_341,
    50_844, 51_349, 51_858, 52_369, 52_884, 53_401, 53_921, 54_445, 54_971, 55_500, 56_032, 56_567,
    57_105, 57_646, 58_190, 58_737, 59_287, 59_840, 60_396, 60_955, 61_517, 62_082, 62_650, 63_221,
    63_795, 64_372, 64_952, 65_535,
];

/// The sRGB encoding curve: the least light of each code, where the exact code is at least `code - ½`.
#[rustfmt::skip]
static FIRST_LIGHT_OF_SRGB: [u16; 256] = [
    0, 10, 30, 50, 70, 90, 110, 130, 150, 170, 189, 209,
    230, 253, 276, 301, 327, 354, 382, 412, 443, 475, 509, 544,
    580, 618, 657, 698, 740, 783, 828, 875, 923, 972, 1023, 1075,
    1129, 1185, 1242, 1300, 1360, 1422, 1486, 1551, 1617, 1685, 1755, 1827,
    1900, 1975, 2052, 2130, 2210, 2292, 2376, 2461, 2548, 2637, 2727, 2820,
    2914, 3010, 3108, 3208, 3309, 3412, 3518, 3625, 3734, 3844, 3957, 4072,
    4188, 4307, 4427, 4550, 4674, 4800, 4928, 5059, 5191, 5325, 5461, 5599,
    5740, 5882, 6026, 6173, 6321, 6471, 6624, 6778, 6935, 7094, 7255, 7418,
    7583, 7750, 7919, 8091, 8265, 8440, 8618, 8798, 8981, 9165, 9352, 9541,
    9732, 9925, 10_121, 10_318, 10_518, 10_720, 10_925, 11_132, 11_341, 11_552, 11_765, 11_981,
    12_199, 12_420, 12_643, 12_868, 13_095, 13_325, 13_557, 13_791, 14_028, 14_267, 14_508, 14_752,
    14_998, 15_247, 15_498, 15_751, 16_007, 16_265, 16_525, 16_788, 17_054, 17_321, 17_592, 17_864,
    18_139, 18_417, 18_697, 18_980, 19_264, 19_552, 19_842, 20_134, 20_429, 20_727, 21_027, 21_329,
    21_634, 21_942, 22_252, 22_564, 22_880, 23_197, 23_518, 23_840, 24_166, 24_494, 24_824, 25_158,
    25_493, 25_832, 26_173, 26_516, 26_862, 27_211, 27_563, 27_917, 28_273, 28_633, 28_995, 29_359,
    29_727, 30_097, 30_469, 30_845, 31_223, 31_603, 31_987, 32_373, 32_762, 33_153, 33_547, 33_944,
    34_344, 34_747, 35_152, 35_560, 35_970, 36_384, 36_800, 37_219, 37_640, 38_065, 38_492, 38_922,
    39_355, 39_790, 40_229, 40_670, 41_114, 41_561, 42_011, 42_463, 42_918, 43_377, 43_838, 44_301,
    44_768, 45_238, 45_710, 46_185, 46_663, 47_144, 47_628, 48_115, 48_605, 49_097, 49_593, 50_091,
    50_592, 51_096, 51_604, 52_114, 52_627, 53_142, 53_661, 54_183, 54_708, 55_235, 55_766, 56_300,
    56_836, 57_376, 57_918, 58_464, 59_012, 59_564, 60_118, 60_675, 61_236, 61_799, 62_366, 62_935,
    63_508, 64_083, 64_662, 65_244,
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_srgb_code_decodes_to_the_nearest_light() {
        for code in 0..=255_u8 {
            let v = f64::from(code) / 255.0;
            let light = if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) };
            let error = f64::from(Light::from_srgb(code).0) - light * 65_535.0;
            assert!(error.abs() <= 0.5 + 1e-6, "code {code}: {error}");
        }
    }

    #[test]
    fn a_grey_colour_has_the_light_of_the_grey() {
        for code in 0..=255 {
            assert_eq!(Light::from_srgb_colour([code; 3]), Light::from_srgb(code));
        }
    }
}
