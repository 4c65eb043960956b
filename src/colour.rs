//! Light: the one quantity that may be added, averaged and compared. Lecture 7.3.
//!
//! The number in a picture file is not an amount of light but a *code*, spaced for the eye: code
//! 128 of 255 stands for 22 % of the light. Whatever is computed on codes comes out wrong. So the
//! crate decodes once, computes in linear light to the very end, and turns light into what the
//! panel shows in the last step.

/// An amount of light, linear: 0 is the panel's black, 65535 its white.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Light(pub u16);

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
        Self(crate::num::high_u16(weighed + 0x8000))
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
