//! A mask without a table: the R2 sequence.
//!
//! The threshold of pixel (x, y) is the fraction of `x / g + y / g²`, where `g` = 1.3247… solves g³ = g + 1, folded
//! into a triangle wave. It repeats nowhere on a screen, so flat tones show no grid; the pattern is between that
//! of Bayer's masks and blue noise.
//!
//! ```text
//!   fraction   0 ……… ½ ……… 1
//!   threshold  0 ╱╲ 1 ╲╱ 0
//! ```
//!
//! - **Memory** none.
//! - **Cost** an addition and three bit operations a pixel.
//!
//! Source: M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018.

use super::Mask;
use crate::num::{bits, high_u16};

/// 2³² / g, to the nearest.
const ACROSS: u32 = 3_242_174_889;
/// 2³² / g², to the nearest.
const DOWN: u32 = 2_447_445_414;

/// The table-free mask of the R2 sequence.
///
/// ```
/// use aquatint::{Dithered, Frame, Levels, Light, Pages, R2Noise, Target};
/// use embedded_graphics::pixelcolor::BinaryColor;
///
/// let mut frame = Frame::<BinaryColor, Pages, _>::with_array([0; 1024], 128, 64).unwrap();
/// let mut dithered = Dithered::new(&mut frame, Levels::ONE_BIT).with_method(R2Noise);
/// for row in 0..64 {
///     dithered.fill_run(row, 0..128, [Light::from_srgb(188)]).unwrap();
/// }
/// let on = frame.bytes().iter().map(|byte| byte.count_ones()).sum::<u32>();
/// assert!(on.abs_diff(4096) < 50); // half of the pixels
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct R2Noise;

/// The fraction of a pixel, of 2³².
#[inline]
const fn fraction(column: i32, row: i32) -> u32 {
    bits(column).wrapping_mul(ACROSS).wrapping_add(bits(row).wrapping_mul(DOWN))
}

/// Rises over the first half of the fractions and falls over the second.
#[inline]
const fn triangle(fraction: u32) -> u16 {
    let falls = (fraction >> 31).wrapping_neg();
    high_u16((fraction << 1) ^ falls)
}

impl Mask for R2Noise {
    const REPEATS: bool = false;

    #[inline]
    fn threshold(&self, column: i32, row: i32) -> u16 {
        triangle(fraction(column, row))
    }

    #[inline]
    fn row(&self, row: i32, column: i32) -> impl Iterator<Item = u16> {
        let mut next = fraction(column, row);
        core::iter::repeat_with(move || {
            let threshold = triangle(next);
            next = next.wrapping_add(ACROSS);
            threshold
        })
    }
}
