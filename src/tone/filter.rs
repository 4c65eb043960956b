//! Colour matrices that people ask for by name. Lecture 7.2.
//!
//! ```text
//!   saturation   s · 1 + (1 − s) · W              1: identity, W: luminance in every row
//!   hue          W + cos · (1 − W) + sin · K      K: a quarter turn about the greys
//!   sepia        (1 − a) · 1 + a · S
//!   contrast     c · 1, bias (1 − c) / 2          invert: −1, bias 1
//! ```
//!
//! In the first two each row sums to 1 and the columns weigh like W, so that greys and the luminance of every colour
//! stay. K is the one matrix with `K·K = −(1 − W)` that keeps both: the shear, turn and shear back of Haeberli,
//! multiplied out. In the W3C's table it has three decimals and four quarter turns miss the identity; here
//! they miss it by one part of 4096 at most.
//!
//! **Cost**: some hundred multiplications, for set-up. Source: W3C *Filter Effects Module*; Haeberli 1993.

use super::colour_matrix::{ColourMatrix, ONE, rounded};
use crate::{
    angle::{Angle, sine_and_cosine},
    num::{Scalar, saturate_i16},
};

/// Rows on red, green and blue, in parts of 65536.
type Rows = [[i64; 3]; 3];

const UNIT: Rows = [[0x1_0000, 0, 0], [0, 0x1_0000, 0], [0, 0, 0x1_0000]];
/// The luminance of BT.709.
const LUMINANCE: Rows = [[13_933, 46_871, 4732]; 3];
const QUARTER_TURN: Rows = [[-13_933, -46_871, 60_804], [9351, 9201, -18_552], [-51_603, 46_871, 4732]];
/// 0.393, 0.769, 0.189; 0.349, 0.686, 0.168; 0.272, 0.534, 0.131.
const SEPIA: Rows = [[25_756, 50_397, 12_386], [22_872, 44_958, 11_010], [17_826, 34_996, 8585]];

impl ColourMatrix {
    /// The negative: full scale minus the colour; alpha stays. Made for codes: on light a mid-grey, 22 % of
    /// white, becomes 78 %.
    pub const INVERT: Self = Self::from_parts(
        [[-ONE, 0, 0, 0], [0, -ONE, 0, 0], [0, 0, -ONE, 0], [0, 0, 0, ONE]],
        [Scalar::ONE, Scalar::ONE, Scalar::ONE, Scalar::ZERO],
    );

    /// Saturation: 1 changes nothing, 0 leaves the luminance as a grey, more than 1 is more colourful, below 0
    /// are the opposite hues. Moved into ±7.
    ///
    /// ```
    /// use aquatint::{ColourMatrix, Light, Scalar};
    ///
    /// let red = [Light::WHITE, Light::BLACK, Light::BLACK];
    /// assert_eq!(ColourMatrix::saturation(Scalar::ZERO).apply(red), [Light(13_936); 3]);
    /// ```
    #[must_use]
    pub fn saturation(factor: Scalar) -> Self {
        let factor = i64::from(factor.to_bits()).clamp(-7 << 16, 7 << 16);
        mixed::<32, 2>([(factor, UNIT), ((1 << 16) - factor, LUMINANCE)])
    }

    /// Turns all hues about the axis of the greys, red towards yellow. Luminance and greys stay.
    ///
    /// ```
    /// use aquatint::{Angle, ColourMatrix};
    ///
    /// let third = ColourMatrix::hue_rotation(Angle::from_degrees(120.0));
    /// assert_eq!(third.apply([200_u8, 100, 100]), [63, 144, 64]); // red became a green as bright
    /// ```
    #[must_use]
    pub fn hue_rotation(angle: Angle) -> Self {
        let (sin, cos) = sine_and_cosine(u32::from(angle.0) << 16);
        mixed::<47, 3>([(cos, UNIT), ((1 << 31) - cos, LUMINANCE), (sin, QUARTER_TURN)])
    }

    /// Brown tones as of old photographs, from 0 for nothing to 1 for all; more counts as 1.
    ///
    /// Made for codes. Greys turn yellowish, and white stays almost white.
    #[must_use]
    pub fn sepia(amount: Scalar) -> Self {
        let amount = i64::from(amount.to_bits()).clamp(0, 1 << 16);
        mixed::<32, 2>([((1 << 16) - amount, UNIT), (amount, SEPIA)])
    }

    /// All colours times a factor, within ±8. On light it is what a lamp or an exposure does.
    #[must_use]
    pub fn brightness(factor: Scalar) -> Self {
        let factor = saturate_i16((i64::from(factor.to_bits()) + 8) >> 4);
        Self::from_parts([[factor, 0, 0, 0], [0, factor, 0, 0], [0, 0, factor, 0], [0, 0, 0, ONE]], [Scalar::ZERO; 4])
    }

    /// Differences from the middle of the scale times a factor, within ±8; the middle stays. Made for codes,
    /// where the middle is a mid-grey; of light it is code 188, and much turns black.
    #[must_use]
    pub fn contrast(factor: Scalar) -> Self {
        let scaled = Self::brightness(factor);
        let [[factor, ..], ..] = *scaled.rows();
        // (1 − factor) / 2 in parts of 65536, of the factor as it was rounded.
        let bias = Scalar::from_bits((i32::from(ONE) - i32::from(factor)) * 8);
        scaled.with_scale_and_bias([Scalar::ONE; 4], [bias, bias, bias, Scalar::ZERO])
    }
}

/// A sum of matrices times factors; products have `BITS` fraction bits. Alpha stays.
fn mixed<const BITS: u32, const COUNT: usize>(parts: [(i64, Rows); COUNT]) -> ColourMatrix {
    let mut sums = [[0; 4]; 3];
    for (factor, rows) in parts {
        for (sum, value) in sums.iter_mut().zip(rows).flat_map(|(sums, row)| sums.iter_mut().zip(row)) {
            *sum += factor * value;
        }
    }
    let [red, green, blue] = sums.map(rounded::<BITS>);
    ColourMatrix::from_parts([red, green, blue, [0, 0, 0, ONE]], [Scalar::ZERO; 4])
}
