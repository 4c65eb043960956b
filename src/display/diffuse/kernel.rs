//! Kernels: which neighbours get how much of an error. Data only.
//!
//! ```text
//!                 ·  ·  X  a₀ a₁      X: the pixel whose error is handed on
//!   below[0]      b₀ b₁ b₂ b₃ b₄      all as parts of the divisor; in a row that is walked
//!   below[1]      c₀ c₁ c₂ c₃ c₄      from right to left, everything is mirrored
//! ```
//!
//! R. W. Floyd and L. Steinberg, "An adaptive algorithm for spatial grey scale", Proc. SID 17(2), 1976;
//! J. F. Jarvis, C. N. Judice and W. H. Ninke, "A survey of techniques for the display of continuous
//! tone pictures on bilevel displays", CGIP 5, 1976; P. Stucki, "MECCA", IBM RZ1060, 1981; D. Burkes,
//! 1988; F. Sierra, 1989 and 1990; B. Atkinson, `HyperScan` for the Macintosh.

/// The weights of an error diffusion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Weights {
    /// For the next two pixels of the row.
    pub ahead: [u8; 2],
    /// For five pixels of each of the two rows below, from two columns behind to two ahead.
    pub below: [[u8; 5]; 2],
    /// What the weights are parts of.
    pub divisor: u8,
}

/// An error diffusion, chosen at compile time.
pub trait Kernel: sealed::Sealed {
    /// Who gets how much.
    const WEIGHTS: Weights;
}

/// Is most widely known, keeps tone and sharpness; errors go to four pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FloydSteinberg {}

/// The recommended one: three pixels, in two thirds of the time, and as good; serpentine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SierraLite {}

/// Sierra's with three rows: ten pixels, smoother and less sharp.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sierra {}

/// Seven pixels of two rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Burkes {}

/// Twelve pixels of three rows: strong lines, coarse in the shadows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JarvisJudiceNinke {}

/// Twelve pixels of three rows, sharper than [`JarvisJudiceNinke`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stucki {}

/// Of the first Macintosh: high in contrast, because a quarter of each error is thrown away.
///
/// So it **cannot keep tone**: what is darker than an eighth of the light becomes black, what is
/// brighter than seven eighths white.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Atkinson {}

impl Kernel for FloydSteinberg {
    const WEIGHTS: Weights = Weights { ahead: [7, 0], below: [[0, 3, 5, 1, 0], [0; 5]], divisor: 16 };
}

impl Kernel for SierraLite {
    const WEIGHTS: Weights = Weights { ahead: [2, 0], below: [[0, 1, 1, 0, 0], [0; 5]], divisor: 4 };
}

impl Kernel for Sierra {
    const WEIGHTS: Weights = Weights { ahead: [5, 3], below: [[2, 4, 5, 4, 2], [0, 2, 3, 2, 0]], divisor: 32 };
}

impl Kernel for Burkes {
    const WEIGHTS: Weights = Weights { ahead: [8, 4], below: [[2, 4, 8, 4, 2], [0; 5]], divisor: 32 };
}

impl Kernel for JarvisJudiceNinke {
    const WEIGHTS: Weights = Weights { ahead: [7, 5], below: [[3, 5, 7, 5, 3], [1, 3, 5, 3, 1]], divisor: 48 };
}

impl Kernel for Stucki {
    const WEIGHTS: Weights = Weights { ahead: [8, 4], below: [[2, 4, 8, 4, 2], [1, 2, 4, 2, 1]], divisor: 42 };
}

impl Kernel for Atkinson {
    const WEIGHTS: Weights = Weights { ahead: [1, 1], below: [[0, 1, 1, 1, 0], [0, 0, 1, 0, 0]], divisor: 8 };
}

impl Weights {
    /// Whether the second row below gets anything.
    pub(super) const fn reaches_two_rows(&self) -> bool {
        let [_, [a, b, c, d, e]] = self.below;
        a | b | c | d | e > 0
    }

    /// How far to the sides pixels get something: one or two columns. It is one in one row only.
    pub(super) const fn reach(&self) -> usize {
        let ([_, second], [[a, .., e], _]) = (self.ahead, self.below);
        if second | a | e > 0 || self.reaches_two_rows() { 2 } else { 1 }
    }

    /// The weights of the row below; straight down there is none if what is left of an error goes there.
    #[inline]
    pub(super) const fn near(&self) -> [u8; 5] {
        let [[a, b, c, d, e], _] = self.below;
        [a, b, if self.conserve() { 0 } else { c }, d, e]
    }

    /// The weights of the row below that.
    #[inline]
    pub(super) const fn far(&self) -> [u8; 5] {
        let [_, far] = self.below;
        far
    }

    /// Whether the whole error is handed on.
    pub(super) const fn conserve(&self) -> bool {
        let [[a, b, c, d, e], [f, g, h, i, j]] = self.below;
        let [k, l] = self.ahead;
        a + b + c + d + e + f + g + h + i + j + k + l == self.divisor
    }

    /// The share of an error that a weight stands for, rounded down; the error has 16 bits.
    ///
    /// Weights in sixteenths and the like are multiplied out; others get so many 42nds of it.
    #[inline]
    pub(super) const fn share(&self, error: i32, weight: u8) -> i32 {
        if self.divisor.is_power_of_two() {
            (error * weight as i32) >> self.divisor.trailing_zeros()
        } else {
            self.part(error) * weight as i32
        }
    }

    /// An error of 16 bits by a divisor of 32 to 63, rounded down: a product, which is exact because the reciprocal
    /// is wrong by half of a 2²¹st at most, and the hundredth that is added keeps whole quotients whole.
    #[inline]
    const fn part(&self, error: i32) -> i32 {
        let reciprocal = ((1 << 21) + self.divisor as i32 / 2) / self.divisor as i32;
        (error * reciprocal + 0x5000) >> 21
    }
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::FloydSteinberg {}
    impl Sealed for super::SierraLite {}
    impl Sealed for super::Sierra {}
    impl Sealed for super::Burkes {}
    impl Sealed for super::JarvisJudiceNinke {}
    impl Sealed for super::Stucki {}
    impl Sealed for super::Atkinson {}
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(weights: &Weights) {
        for error in -0x8000..=0x7FFF_i32 {
            for weight in weights.ahead.iter().chain(weights.below.as_flattened()) {
                let (weight_i32, divisor) = (i32::from(*weight), i32::from(weights.divisor));
                let expected = if divisor.count_ones() == 1 {
                    (error * weight_i32).div_euclid(divisor)
                } else {
                    error.div_euclid(divisor) * weight_i32
                };
                assert_eq!(weights.share(error, *weight), expected, "{error} by {weight} of {divisor}");
            }
        }
    }

    #[test]
    fn shares_are_rounded_down_for_every_error() {
        check(&FloydSteinberg::WEIGHTS);
        check(&SierraLite::WEIGHTS);
        check(&Sierra::WEIGHTS);
        check(&Burkes::WEIGHTS);
        check(&JarvisJudiceNinke::WEIGHTS);
        check(&Stucki::WEIGHTS);
        check(&Atkinson::WEIGHTS);
    }

    #[test]
    fn only_atkinson_throws_light_away() {
        assert!(!Atkinson::WEIGHTS.conserve() && FloydSteinberg::WEIGHTS.conserve() && Stucki::WEIGHTS.conserve());
        assert!(SierraLite::WEIGHTS.conserve() && Burkes::WEIGHTS.conserve() && Sierra::WEIGHTS.conserve());
        assert!(JarvisJudiceNinke::WEIGHTS.conserve());
    }
}
