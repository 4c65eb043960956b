//! Luma: a grey made of codes, and the standards that say how much of each channel.
//!
//! Luma is what television sends in place of luminance. It is a sum of *codes*, not of light, so it is wrong as a
//! grey picture: by up to 71 codes with the weights of BT.601, 73 with those of BT.709 (pure blue comes out far
//! too dark). The grey of a colour is its luminance, [`Light::from_srgb_colour`](crate::Light::from_srgb_colour).
//! Luma is here to read and write what others have encoded.
//!
//! ```text
//!            red    green   blue
//!   BT.601   0.299  0.587   0.114      standard television, JPEG
//!   BT.709   0.2126 0.7152  0.0722     high definition; on light these are the weights of sRGB
//! ```
//!
//! Source: ITU-R BT.601-7, BT.709-6.

use crate::num::{bits, low_u8};

/// Whose weights.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Standard {
    /// Standard television, JPEG.
    #[default]
    Bt601,
    /// High definition.
    Bt709,
}

impl Standard {
    /// Weights of red, green and blue in parts of 65536. They sum to 65536, so greys stay what they are.
    pub(super) const fn weights(self) -> [i32; 3] {
        match self {
            Self::Bt601 => [19_595, 38_470, 7_471],
            Self::Bt709 => [13_933, 46_871, 4_732],
        }
    }

    /// The luma of sRGB codes, 0 to 255, within 0.51 of the exact one. Three multiplications.
    ///
    /// ```
    /// use aquatint::tone::luma::Standard;
    ///
    /// assert_eq!([Standard::Bt601, Standard::Bt709].map(|standard| standard.luma([0, 0, 255])), [29, 18]);
    /// ```
    #[must_use]
    pub fn luma(self, rgb: [u8; 3]) -> u8 {
        weighed(self.weights(), rgb, 0)
    }
}

/// The grey that embedded-graphics makes of a colour (`Gray8::from(Rgb888)`), bit for bit: BT.601 on codes in
/// eight bits, 77, 150 and 29 of 256. **Naive**: codes are taken for light.
///
/// ```
/// use aquatint::{Light, tone::luma::naive_grey};
///
/// assert_eq!(naive_grey([0, 0, 255]), 29);
/// assert_eq!(Light::from_srgb_colour([0, 0, 255]).to_srgb(), 76); // what the eye gets
/// ```
#[must_use]
pub fn naive_grey(rgb: [u8; 3]) -> u8 {
    weighed([77 << 8, 150 << 8, 29 << 8], rgb, 0)
}

/// A sum of weighed codes, weights in parts of 65536, around a middle; rounded once and clipped.
pub(super) fn weighed(weights: [i32; 3], codes: [u8; 3], middle: i32) -> u8 {
    let sum: i32 = weights.into_iter().zip(codes).map(|(weight, code)| weight * i32::from(code)).sum();
    nearest_code(sum + (middle << 16))
}

/// The nearest code to a number with 16 fraction bits.
pub(super) fn nearest_code(value: i32) -> u8 {
    low_u8(bits(((value + 0x8000) >> 16).clamp(0, 255)))
}
