//! Coverage: how much of a pixel's area a shape covers. Lecture 6.4.
//!
//! ```text
//!   ┌───┬───┬───┬───┐
//!   │   │ ▗▄▟███████│      0    ⅜    1    1
//!   └───┴───┴───┴───┘
//! ```
//!
//! Coverage is an amount of light, not of code: half covered means half of the light. What becomes of it is told by
//! [`BlendMode`](crate::BlendMode).

/// A part of a pixel's area: 0 is none of it, 32768 all.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Coverage(u16);

impl Coverage {
    /// No part of the pixel.
    pub const NONE: Self = Self(0);
    /// The whole pixel.
    pub const FULL: Self = Self(1 << 15);

    /// So many of 32768 parts; more than all is all.
    #[must_use]
    pub const fn new(parts: u16) -> Self {
        if parts > Self::FULL.0 { Self::FULL } else { Self(parts) }
    }

    /// 0 to 32768.
    #[inline]
    #[must_use]
    pub const fn parts(self) -> u16 {
        self.0
    }

    /// 255 is all of the pixel, 0 nothing, the rest in between.
    #[must_use]
    pub const fn from_byte(byte: u8) -> Self {
        // 255 · 32896 + 128 is 2¹⁵ · 2⁸.
        Self(crate::num::low_u16(((byte as i32) * 32_896 + 128) >> 8))
    }

    /// The nearest of 256 steps, 255 being all of the pixel.
    #[inline]
    #[must_use]
    pub const fn to_byte(self) -> u8 {
        crate::num::low_u8((self.0 as u32 * 255 + (1 << 14)) >> 15)
    }

    /// This part of that part, rounded to the nearest.
    #[inline]
    #[must_use]
    pub const fn of(self, other: Self) -> Self {
        Self(crate::num::high_u16((self.0 as u32 * other.0 as u32 * 2).saturating_add(1 << 15)))
    }

    /// All but this part.
    #[inline]
    #[must_use]
    pub const fn inverted(self) -> Self {
        Self(Self::FULL.0.saturating_sub(self.0))
    }

    /// The amount that a sum has come to, positive or negative, which may have left the range by rounding. Sums are taken
    /// modulo 2¹⁶.
    #[inline]
    pub(crate) const fn of_sum(sum: u16) -> Self {
        // A little more than all is a little less; all is the one number that has no negative.
        Self(sum.cast_signed().unsigned_abs())
    }

    /// A difference modulo 2¹⁶, for a row that is summed up.
    #[inline]
    pub(crate) const fn of_difference(difference: u16) -> Self {
        Self(difference)
    }

    /// An area of 0 to 32768 parts.
    #[inline]
    pub(crate) const fn of_area(parts: u32) -> Self {
        Self(crate::num::low_u16(parts.cast_signed()))
    }

    /// Adds modulo 2¹⁶: while a row is summed up, its cells hold differences.
    #[inline]
    pub(crate) const fn add(&mut self, difference: u16) {
        self.0 = self.0.wrapping_add(difference);
    }
}

/// What a span of an antialiased shape carries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Covered<'c> {
    /// All its pixels are covered alike.
    Evenly(Coverage),
    /// The coverage of each of its pixels, from the left; as many as the span has columns.
    Each(&'c [Coverage]),
}

impl Covered<'_> {
    /// The coverage of the pixel `offset` columns behind the first.
    ///
    /// ```
    /// use aquatint::{Coverage, Covered};
    ///
    /// let edge = [Coverage::new(8_192), Coverage::FULL];
    /// assert_eq!(Covered::Each(&edge).at(1), Coverage::FULL);
    /// assert_eq!(Covered::Evenly(Coverage::FULL).at(99), Coverage::FULL);
    /// ```
    #[inline]
    #[must_use]
    pub fn at(&self, offset: usize) -> Coverage {
        match self {
            Self::Evenly(coverage) => *coverage,
            Self::Each(cells) => cells.get(offset).copied().unwrap_or_default(),
        }
    }
}

/// Makes what is partly covered bolder or thinner.
///
/// Linear coverage is right in light, and looks thin where bright text stands on dark, because small text is looked
/// at in codes. The curve is `c + k·c·(1 − c)`: nothing stays nothing, and all stays all.
///
/// ```
/// use aquatint::{Coverage, CoverageCurve};
///
/// let half = Coverage::new(16_384);
/// assert_eq!(CoverageCurve::LINEAR.bend(half), half);
/// assert_eq!(CoverageCurve::bolder(100).bend(half), Coverage::new(24_576));
/// assert_eq!(CoverageCurve::thinner(100).bend(half), Coverage::new(8_192));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CoverageCurve(i16);

impl CoverageCurve {
    /// As it is.
    pub const LINEAR: Self = Self(0);

    /// More of it, by up to 100 percent.
    #[must_use]
    pub const fn bolder(percent: u8) -> Self {
        Self(Self::strength(percent))
    }

    /// Less of it, by up to 100 percent.
    #[must_use]
    pub const fn thinner(percent: u8) -> Self {
        Self(-Self::strength(percent))
    }

    /// In 16384ths.
    const fn strength(percent: u8) -> i16 {
        let percent = if percent > 100 { 100 } else { percent as i32 };
        crate::num::saturate_i16((percent * 16_384 / 100) as i64)
    }

    /// The bent coverage. Two multiplications.
    #[inline]
    #[must_use]
    pub const fn bend(self, coverage: Coverage) -> Coverage {
        if self.0 == 0 {
            return coverage;
        }
        let parts = coverage.0 as i32;
        // At most 2¹³, a quarter of all.
        let rest = (parts * (Coverage::FULL.0 as i32 - parts)) >> 15;
        Coverage::of_area(crate::num::bits(parts + ((rest * self.0 as i32) >> 14)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_survive_and_are_the_nearest() {
        for byte in 0..=255_u8 {
            assert_eq!(Coverage::from_byte(byte).to_byte(), byte);
        }
        for parts in 0..=32_768_u16 {
            let exact = f64::from(parts) / 32_768.0 * 255.0;
            let error = f64::from(Coverage::new(parts).to_byte()) - exact;
            assert!(error.abs() <= 0.5, "{parts}: {error}");
        }
        assert_eq!((Coverage::from_byte(0), Coverage::from_byte(255)), (Coverage::NONE, Coverage::FULL));
    }

    #[test]
    fn curves_rise_from_nothing_to_all() {
        for curve in [CoverageCurve::bolder(255), CoverageCurve::bolder(30), CoverageCurve::thinner(100)] {
            let bent = |parts| curve.bend(Coverage(parts));
            assert!((0..32_768).all(|parts| bent(parts) <= bent(parts + 1)));
            assert_eq!((bent(0), bent(32_768)), (Coverage::NONE, Coverage::FULL));
        }
    }

    #[test]
    fn a_part_of_a_part() {
        for parts in (0..=32_768).step_by(7).chain([32_768]).map(Coverage::new) {
            assert_eq!((parts.of(Coverage::FULL), parts.of(Coverage::NONE)), (parts, Coverage::NONE));
            assert_eq!(parts.inverted().inverted(), parts);
        }
        assert_eq!(Coverage::new(16_384).of(Coverage::new(16_384)), Coverage::new(8_192));
        assert_eq!(Coverage::new(u16::MAX), Coverage::FULL);
    }
}
