//! Number words: the fixed-point types, and every rounding and narrowing that the crate does.
//!
//! This is the one file where `as` may lose bits, each time in a function whose name says how.
//! Elsewhere numbers only widen.

/// A coordinate or a matrix element in model, world, view and clip space: signed 16.16.
pub type Scalar = fixed::types::I16F16;

/// A coordinate on the screen in sixteenths of a pixel: signed 28.4.
///
/// Whole numbers are the corners of pixels, so the centre of pixel `(x, y)` is `(x + ½, y + ½)`.
pub type Subpixel = fixed::types::I28F4;

/// Fixed-point numbers as defmt logs them: raw bits, and what stands for one, as in `24/16`. Exact, and nothing to compute.
#[cfg(feature = "defmt")]
pub(crate) struct Fixed<T>(pub(crate) T);

#[cfg(feature = "defmt")]
macro_rules! log_as_fraction {
    ($($number:ty: $text:literal),+) => { $(
        impl defmt::Format for Fixed<$number> {
            fn format(&self, f: defmt::Formatter<'_>) {
                defmt::write!(f, $text, self.0.to_bits());
            }
        }
    )+ };
}

#[cfg(feature = "defmt")]
log_as_fraction!(Subpixel: "{=i32}/16", fixed::types::I20F12: "{=i32}/4096", Scalar: "{=i32}/65536");

#[cfg(feature = "defmt")]
impl<T: Copy, const N: usize> defmt::Format for Fixed<[T; N]>
where
    Fixed<T>: defmt::Format,
{
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "{}", self.0.map(Fixed));
    }
}

/// Lets defmt log a type with fixed-point numbers in it, of which it knows nothing.
macro_rules! format_fixed {
    (impl[$($space:ident),*] |$it:ident: $type:ty| $text:literal, $($value:expr),+) => {
        #[cfg(feature = "defmt")]
        impl<$($space),*> defmt::Format for $type {
            fn format(&self, f: defmt::Formatter<'_>) {
                use crate::num::Fixed;
                let $it = self;
                defmt::write!(f, $text, $($value),+);
            }
        }
    };
}

pub(crate) use format_fixed;

/// Sub-pixel steps in a pixel.
pub(crate) const SUBPIXELS: i32 = 1 << Subpixel::FRAC_NBITS;

/// Quotient rounded towards minus infinity, and the remainder, which is never negative.
///
/// Both are zero when `divisor` is not positive: a total function has no panic path.
#[inline]
pub(crate) const fn divide_floor(dividend: i64, divisor: i64) -> (i64, i64) {
    if divisor <= 0 {
        return (0, 0);
    }
    let (quotient, remainder) = (dividend / divisor, dividend % divisor);
    if remainder < 0 { (quotient - 1, remainder + divisor) } else { (quotient, remainder) }
}

/// [`divide_floor`] in 32 bits, a third of the instructions on a core without a divider.
#[inline]
pub(crate) const fn divide_floor_i32(dividend: i32, divisor: i32) -> (i32, i32) {
    if divisor <= 0 {
        return (0, 0);
    }
    let (quotient, remainder) = (dividend / divisor, dividend % divisor);
    if remainder < 0 { (quotient - 1, remainder + divisor) } else { (quotient, remainder) }
}

/// Quotient rounded to the nearest, ties up. Zero when `divisor` is not positive.
#[inline]
pub(crate) const fn divide_round(dividend: i64, divisor: i64) -> i64 {
    divide_floor(dividend.saturating_add(divisor / 2), divisor).0
}

/// What to multiply by instead of dividing by `value`: `(reciprocal, shift)` such that `1/value` is
/// `reciprocal / 2^(63 - shift)`, too small by less than one part in 2²⁹ and never too large.
///
/// `value << shift` has its highest bit set, and so has the reciprocal. Zero counts as one. A core without a divider
/// takes 180 instructions for a division and 37 for a product of 64 bits; so a table has the first 9 bits, and two steps
/// of Newton's double them twice, in products of 32 bits.
#[inline]
pub(crate) const fn reciprocal(value: u32) -> (u32, u32) {
    let value = if value == 0 { 1 } else { value };
    let shift = value.leading_zeros();
    let normal = value << shift; // 2³¹ ≤ normal < 2³²
    let (high, low) = (normal >> 16, normal & 0xFFFF);
    // 2⁴⁶ over it, 15 bits of which half are right; then 2⁴⁷ over it, 16 bits.
    let first = RECIPROCAL_SEEDS[(normal >> 23 & 0xFF) as usize] as u32;
    let error = (1_u32 << 31).wrapping_sub((normal >> 15).wrapping_mul(first)).cast_signed();
    let seed = (first << 1).wrapping_add_signed((first.cast_signed().wrapping_mul(error >> 7) + (1 << 22)) >> 23);
    // How far the product is from 2⁴⁷, in 2¹⁶: less than 2¹⁶ itself. Then seed × (1 + error).
    let error = (1_u32 << 31).wrapping_sub(seed * high).wrapping_sub((seed * low).div_ceil(1 << 16)).cast_signed();
    let corrected = (seed.wrapping_sub(1) << 16).wrapping_add_signed(seed.cast_signed().wrapping_mul(error >> 1) >> 14);
    // The one that was taken off, so that a power of two, which has a reciprocal of 2³², does not become nothing.
    (corrected.saturating_add(1 << 16), shift)
}

/// 2¹⁵ over the middle of each 256th from 1 to 2.
const RECIPROCAL_SEEDS: [u16; 256] = {
    let (mut seeds, mut at) = ([0; 256], 0);
    while at < 256 {
        let twice = 513 + 2 * low_index(at);
        seeds[at] = high_u16(((2 * (512 << 15) + twice) / (2 * twice)) << 16);
        at += 1;
    }
    seeds
};

/// The upper half of the product with a number below 1 that has 32 fraction bits: rounded down, or one or two less.
///
/// Exact to the last bits, it would be a call on a small core.
#[inline]
pub(crate) const fn multiply_high(value: i32, fraction: u32) -> i32 {
    // As an unsigned number, a negative one is 2³² more, and its product 2³² times the fraction.
    let excess = if value < 0 { fraction } else { 0 };
    multiply_high_u32(bits(value), fraction).wrapping_sub(excess).cast_signed()
}

/// [`multiply_high`] without a sign.
#[inline]
pub(crate) const fn multiply_high_u32(value: u32, fraction: u32) -> u32 {
    let (value_high, value_low, high, low) = (value >> 16, value & 0xFFFF, fraction >> 16, fraction & 0xFFFF);
    // Without the product of the lower halves, which carries one at most.
    value_high * high + ((value_high * low) >> 16) + ((value_low * high) >> 16)
}

/// The low 32 bits: arithmetic modulo 2³² by intent.
#[inline]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "modulo 2^32 by intent")]
pub(crate) const fn low_u32(value: i64) -> u32 {
    value as u32
}

/// The low 32 bits, read as a signed number.
#[inline]
#[expect(clippy::cast_possible_truncation, reason = "modulo 2^32 by intent")]
pub(crate) const fn low_i32(value: i64) -> i32 {
    value as i32
}

/// The low 32 bits of a long number, read as a signed one.
#[inline]
#[expect(clippy::cast_possible_truncation, reason = "modulo 2^32 by intent")]
pub(crate) const fn low_i128(value: i128) -> i32 {
    value as i32
}

/// The same 32 bits, read as an unsigned number.
#[inline]
pub(crate) const fn bits(value: i32) -> u32 {
    value.cast_unsigned()
}

/// The high half: the whole part of an unsigned 16.16.
#[inline]
pub(crate) const fn high_u16(value: u32) -> u16 {
    (value >> 16) as u16
}

/// The nearest `i32`.
#[inline]
pub(crate) const fn saturate_i32(value: i64) -> i32 {
    if value > i32::MAX as i64 {
        i32::MAX
    } else if value < i32::MIN as i64 {
        i32::MIN
    } else {
        low_i32(value)
    }
}

/// The nearest `u16`.
#[inline]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "in range after the tests")]
pub(crate) const fn saturate_u16(value: i64) -> u16 {
    if value > u16::MAX as i64 {
        u16::MAX
    } else if value < 0 {
        0
    } else {
        value as u16
    }
}

/// The nearest `i32` to an unsigned size.
#[inline]
pub(crate) const fn size_i32(value: u32) -> i32 {
    if value > i32::MAX.cast_unsigned() { i32::MAX } else { value.cast_signed() }
}

/// An index: negative numbers become zero, numbers beyond the address space its end.
#[inline]
pub(crate) const fn index(value: i32) -> usize {
    if value < 0 {
        0
    } else if value.cast_unsigned() as u64 > usize::MAX as u64 {
        usize::MAX
    } else {
        value.cast_unsigned() as usize
    }
}

/// A number of pixels; what no picture is long becomes `i32::MAX`.
#[inline]
pub(crate) fn count_i32(value: usize) -> i32 {
    i32::try_from(value).unwrap_or(i32::MAX)
}

/// Bytes or elements: a product that does not fit becomes `usize::MAX`, which no buffer reaches.
#[inline]
#[expect(clippy::cast_possible_truncation, reason = "tested")]
pub(crate) const fn count(value: u64) -> usize {
    if value > usize::MAX as u64 { usize::MAX } else { value as usize }
}

/// The low byte.
#[inline]
#[expect(clippy::cast_possible_truncation, reason = "callers mask or shift first")]
pub(crate) const fn low_u8(value: u32) -> u8 {
    value as u8
}

/// The nearest `u32` to a sum that may have grown past it.
#[inline]
#[expect(clippy::cast_possible_truncation, reason = "tested")]
pub(crate) const fn saturate_u32(value: u64) -> u32 {
    if value > u32::MAX as u64 { u32::MAX } else { value as u32 }
}

/// The low 16 bits: arithmetic modulo 2¹⁶ by intent.
#[inline]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "modulo 2^16 by intent")]
pub(crate) const fn low_u16(value: i32) -> u16 {
    value as u16
}

/// The low 16 bits of an index.
#[inline]
pub(crate) const fn index_u16(value: usize) -> u16 {
    low_u16(low_index(value).cast_signed())
}

/// The low 32 bits of an index.
#[inline]
#[expect(clippy::cast_possible_truncation, reason = "modulo 2^32 by intent")]
pub(crate) const fn low_index(value: usize) -> u32 {
    value as u32
}

/// The low 16 bits, read as a signed number.
#[inline]
#[expect(clippy::cast_possible_truncation, reason = "modulo 2^16 by intent")]
pub(crate) const fn low_i16(value: i32) -> i16 {
    value as i16
}

/// The nearest `i16`.
#[inline]
#[expect(clippy::cast_possible_truncation, reason = "in range after the tests")]
pub(crate) const fn saturate_i16(value: i64) -> i16 {
    if value > i16::MAX as i64 {
        i16::MAX
    } else if value < i16::MIN as i64 {
        i16::MIN
    } else {
        value as i16
    }
}

/// Fraction bits of an attribute that is carried over a triangle.
pub(crate) const FRACTION_16_15: u32 = 15;

/// An attribute as an unsigned 16.15 number.
#[inline]
pub(crate) const fn to_16_15(value: u16) -> u32 {
    (value as u32) << FRACTION_16_15
}

/// The whole part of an unsigned 16.15 number, modulo 2¹⁶.
#[inline]
pub(crate) const fn from_16_15(value: u32) -> u16 {
    high_u16(value << (16 - FRACTION_16_15))
}

/// The product of two numbers with 60 fraction bits, rounded down: for tables that the compiler builds.
/// Modulo 16, where it would be that large.
#[expect(clippy::cast_possible_truncation, reason = "modulo 2^64 by intent")]
pub(crate) const fn multiply_60(a: u64, b: u64) -> u64 {
    ((a as u128 * b as u128) >> 60) as u64
}

/// The nearest 16.16 number towards zero, saturated; 0 for what is not a number.
#[cfg(feature = "ttf")]
#[inline]
#[expect(clippy::cast_possible_truncation, reason = "a float-to-int cast saturates")]
pub(crate) fn scalar_of_f32(value: f32) -> Scalar {
    Scalar::from_bits((value * 65_536.0) as i32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn upper_halves_are_at_most_two_too_small() {
        let ends = [0, 1, 2, 0xFFFF, 0x1_0000, 0x1_0001, 0x7FFF_FFFF, 0x8000_0000, 0xFFFF_0001, u32::MAX];
        for (a, b) in ends.into_iter().flat_map(|a| ends.map(|b| (a, b))) {
            let exact = (u64::from(a) * u64::from(b)) >> 32;
            assert!((0..=2).contains(&(exact - u64::from(multiply_high_u32(a, b)))), "{a} {b}");
            let signed = (i64::from(a.cast_signed()) * i64::from(b)) >> 32;
            assert!((0..=2).contains(&(signed - i64::from(multiply_high(a.cast_signed(), b)))), "{a} {b}");
        }
    }

    /// How much too small a reciprocal is, in parts of 2⁴⁰.
    fn shortfall(value: u32) -> u128 {
        let (reciprocal, shift) = reciprocal(value);
        assert_eq!(reciprocal >> 31, 1, "{value}");
        let (product, exact) = (u128::from(reciprocal) * u128::from(value), 1_u128 << (63 - shift));
        assert!(product <= exact, "1/{value} is too large");
        ((exact - product) << 40) / exact
    }

    #[test]
    fn reciprocals_are_right_to_29_bits_for_all_exponents() {
        let mut worst = 0;
        for shift in 0..32 {
            let (least, most) = (1_u32 << 31 >> shift, u32::MAX >> shift);
            let around = [least, least + 1, least + 2, most / 4 * 3, most.saturating_sub(1), most];
            for value in around.into_iter().filter(|value| (least..=most).contains(value)) {
                worst = worst.max(shortfall(value));
            }
            let step = 2_654_435_769_u32;
            for i in 0..20_000_u32 {
                worst = worst.max(shortfall(least + (i.wrapping_mul(step) % (most - least + 1).max(1))));
            }
        }
        // Both sides of each place where the upper half is rounded, and where it changes.
        for upper in 0x8000..=0xFFFF_u32 {
            for lower in [0, 1, 0x7FFF, 0x8000, 0x8001, 0xFFFF] {
                worst = worst.max(shortfall(upper << 16 | lower));
            }
        }
        assert!(worst <= 1 << 11, "{worst}");
        assert!(worst > 1 << 8, "the test sees an error: {worst}");
        assert_eq!(reciprocal(0), reciprocal(1));
        assert_eq!(reciprocal(3), (0xAAAA_AAAA, 30));
    }
}
