//! The colour matrix: saturation, hue, contrast and the like as one product a pixel. Lecture 7.2.
//!
//! ```text
//!   ⎡R'⎤   ⎡ m m m m ⎤ ⎡R⎤   ⎡b⎤
//!   ⎢G'⎥ = ⎢ m m m m ⎥ ⎢G⎥ + ⎢b⎥      then clipped, once
//!   ⎢B'⎥   ⎢ m m m m ⎥ ⎢B⎥   ⎢b⎥
//!   ⎣A'⎦   ⎣ m m m m ⎦ ⎣A⎦   ⎣b⎦
//! ```
//!
//! OpenGL's `GL_COLOR` matrix, with a scale and a bias of each component after it. The scale is multiplied into the
//! matrix, so a chain of any number of them costs as much as one. Nothing is clipped in between.
//!
//! **One matrix for light and codes.** Numbers are parts of the full scale, whichever it is: 65535 for
//! [`Light`] and `u16`, 255 for `u8`. On light the result is right; on codes it is what web browsers and OpenGL
//! do, and the weights of luminance then weigh what is not light.
//!
//! **Accuracy**: coefficients have 12 fraction bits and ±8. Those of a row are rounded together, so their sum is the
//! exact sum: what should keep greys keeps them. The result of one matrix is within 0.6 of a code of the exact
//! one (0.5 is perfect), on light within 25 of 65535; 0.57 and 17 where rows sum to one.
//! **Cost**: 16 multiplications of 32 bits and four of 64 a colour (an opaque one takes 12 and
//! three), no division. **Memory**: 48 bytes.
//! Source: OpenGL 1.2 imaging subset; W3C *Filter Effects* for the matrices; Haeberli, *Matrix Operations for Image
//! Processing*, 1993.

use crate::{
    colour::Light,
    num::{Scalar, low_i32, low_u8, saturate_i16, saturate_u16},
};

/// A matrix on red, green, blue and alpha, and what is added to each.
///
/// ```
/// use aquatint::{Angle, ColourMatrix, Light, Scalar};
///
/// let warm = ColourMatrix::saturation(Scalar::from_num(0.5))
///     .then(&ColourMatrix::hue_rotation(Angle::from_degrees(10.0)));
/// let codes = [255, 128, 0];
/// // On light, as it should be; greys stay greys.
/// let shown = warm.apply(codes.map(Light::from_srgb)).map(Light::to_srgb);
/// assert_eq!(shown, [210, 151, 101]);
/// assert_eq!(warm.apply([Light(12_345); 3]), [Light(12_345); 3]);
/// // On codes, as OpenGL does it.
/// assert_eq!(warm.apply(codes), [187, 142, 64]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ColourMatrix {
    /// With 12 fraction bits.
    rows: [[i16; 4]; 4],
    /// Parts of 65536 of the full scale, within [`LIMIT`].
    bias: [i32; 4],
}

/// 33 full scales. A row of the matrix reaches 32 at most, so a bias beyond makes the same black or white.
const LIMIT: i64 = 33 << 16;
/// One, in the matrix.
pub(super) const ONE: i16 = 1 << 12;

impl ColourMatrix {
    /// Changes nothing.
    pub const IDENTITY: Self =
        Self { rows: [[ONE, 0, 0, 0], [0, ONE, 0, 0], [0, 0, ONE, 0], [0, 0, 0, ONE]], bias: [0; 4] };

    /// A matrix of coefficients in parts of 4096 and biases in parts of the full scale. For tables in flash.
    #[must_use]
    pub const fn from_parts(rows: [[i16; 4]; 4], [red, green, blue, alpha]: [Scalar; 4]) -> Self {
        Self { rows, bias: [limited(red), limited(green), limited(blue), limited(alpha)] }
    }

    /// A matrix from its rows, rounded. Coefficients beyond ±8 are moved there.
    #[must_use]
    pub fn from_rows(rows: [[Scalar; 4]; 4]) -> Self {
        Self { rows: rows.map(|row| rounded::<16>(row.map(|value| value.to_bits().into()))), bias: [0; 4] }
    }

    /// The coefficients, in parts of 4096.
    #[must_use]
    pub const fn rows(&self) -> &[[i16; 4]; 4] {
        &self.rows
    }

    /// What is added, in parts of the full scale.
    #[must_use]
    pub fn bias(&self) -> [Scalar; 4] {
        self.bias.map(Scalar::from_bits)
    }

    /// The matrix, then a factor for each component, then a number added to it: OpenGL's
    /// `GL_POST_COLOR_MATRIX_RED_SCALE`, `…_BIAS` and so on. Coefficients beyond ±8 are moved there.
    #[must_use]
    pub fn with_scale_and_bias(mut self, scale: [Scalar; 4], bias: [Scalar; 4]) -> Self {
        let factors = scale.map(|factor| i64::from(factor.to_bits()));
        for (row, factor) in self.rows.iter_mut().zip(factors) {
            *row = rounded::<28>(row.map(|value| factor * i64::from(value)));
        }
        for ((old, factor), added) in self.bias.iter_mut().zip(factors).zip(bias) {
            *old = limit(((factor * i64::from(*old) + 0x8000) >> 16) + i64::from(added.to_bits()));
        }
        self
    }

    /// First this matrix, then `next`, as one, without a clip in between. Coefficients are rounded once more.
    #[must_use]
    pub fn then(&self, next: &Self) -> Self {
        let [red, green, blue, alpha] = self.rows;
        let column = |at: fn([i16; 4]) -> i16| [red, green, blue, alpha].map(|row| i32::from(at(row)));
        let columns = [column(|[v, ..]| v), column(|[_, v, ..]| v), column(|[.., v, _]| v), column(|[.., v]| v)];
        let mut bias = next.bias;
        for (added, row) in bias.iter_mut().zip(next.rows) {
            *added = limit(i64::from(*added) + ((dot(row, self.bias) + 0x800) >> 12));
        }
        Self { rows: next.rows.map(|row| rounded::<24>(columns.map(|column| dot(row, column)))), bias }
    }

    /// What becomes of an opaque colour; its alpha is dropped. [`Light`], or `u16` or `u8` of any meaning.
    #[must_use]
    #[inline]
    pub fn apply<C: Component>(&self, [red, green, blue]: [C; 3]) -> [C; 3] {
        let [red, green, blue, _] = self.apply_rgba([red, green, blue, C::FULL]);
        [red, green, blue]
    }

    /// What becomes of a colour and its alpha.
    #[must_use]
    #[inline]
    pub fn apply_rgba<C: Component>(&self, colour: [C; 4]) -> [C; 4] {
        let [red, green, blue, alpha] = self.rows;
        let [r, g, b, a] = self.bias;
        let colour = colour.map(C::widen);
        [(red, r), (green, g), (blue, b), (alpha, a)].map(|(row, bias)| {
            // A coefficient times 65535 fits 32 bits; times the full scale is a shift and a subtraction.
            let products = row.into_iter().zip(colour).map(|(factor, value)| i64::from(i32::from(factor) * value));
            let (sum, bias) = (products.sum::<i64>() << 4, i64::from(bias));
            C::clipped((sum + (bias << C::BITS) - bias + 0x8000) >> 16)
        })
    }
}

/// The sum of four products, of which each may need 64 bits.
fn dot(row: [i16; 4], column: [i32; 4]) -> i64 {
    row.into_iter().zip(column).map(|(a, b)| i64::from(a) * i64::from(b)).sum()
}

const fn limited(bias: Scalar) -> i32 {
    limit(bias.to_bits() as i64)
}

const fn limit(bias: i64) -> i32 {
    low_i32(if bias > LIMIT {
        LIMIT
    } else if bias < -LIMIT {
        -LIMIT
    } else {
        bias
    })
}

/// A row of `BITS` fraction bits with 12. Running sums are rounded, not coefficients, so the sum of the row is the
/// exact sum, rounded, and what one coefficient lost its neighbour has.
pub(super) fn rounded<const BITS: u32>(exact: [i64; 4]) -> [i16; 4] {
    let (mut sum, mut given) = (0, 0);
    exact.map(|value| {
        sum += value;
        let total: i64 = (sum + (1 << (BITS - 13))) >> (BITS - 12);
        let coefficient = saturate_i16(total - given);
        given = total;
        coefficient
    })
}

/// What a colour is made of: [`Light`] or `u16` of 0 to 65535, or `u8` of 0 to 255.
pub trait Component: Copy + sealed::Channel {}

impl Component for Light {}
impl Component for u16 {}
impl Component for u8 {}

mod sealed {
    /// A number from nothing to the full scale.
    pub trait Channel: Copy {
        const FULL: Self;
        const BITS: u32;
        fn widen(self) -> i32;
        fn clipped(value: i64) -> Self;
    }
}

impl sealed::Channel for u16 {
    const FULL: Self = Self::MAX;
    const BITS: u32 = 16;

    #[inline]
    fn widen(self) -> i32 {
        self.into()
    }

    #[inline]
    fn clipped(value: i64) -> Self {
        saturate_u16(value)
    }
}

impl sealed::Channel for Light {
    const FULL: Self = Self::WHITE;
    const BITS: u32 = 16;

    #[inline]
    fn widen(self) -> i32 {
        self.0.into()
    }

    #[inline]
    fn clipped(value: i64) -> Self {
        Self(saturate_u16(value))
    }
}

impl sealed::Channel for u8 {
    const FULL: Self = Self::MAX;
    const BITS: u32 = 8;

    #[inline]
    fn widen(self) -> i32 {
        self.into()
    }

    #[inline]
    fn clipped(value: i64) -> Self {
        low_u8(saturate_u16(value).min(255).into())
    }
}
