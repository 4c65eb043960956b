//! Directions of unit length, and how far to the side of a segment its borders lie.
//!
//! ```text
//!     −offset ●━━━━━━━━━━━━━━━━━━●
//!             ┃                  ┃        offset = ½ width · direction.right(), rounded once
//!           a ●┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄▶● b
//!             ┃    direction     ┃
//!     +offset ●━━━━━━━━━━━━━━━━━━●
//! ```
//!
//! A direction has 30 fraction bits and is right to 2⁻²⁹. One integer square root and one division make
//! it, for every segment; everything else is made of it by multiplications.
//!
//! Rounding is symmetric about zero. So the offset of the opposite direction is exactly the opposite
//! offset, and a segment has the same borders whichever end it begins at.

use crate::{
    num::{low_i32, saturate_i32},
    space::Point2,
};

/// Fraction bits of a direction.
const FRACTION: u32 = 30;
/// Bits of a length behind the sixteenth of a pixel.
pub(super) const LENGTH_FRACTION: u32 = 16;
/// One.
pub(super) const ONE: i32 = 1 << FRACTION;

/// A vector of length 1, with [`FRACTION`] bits behind the point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Direction {
    pub(super) x: i32,
    pub(super) y: i32,
}

impl Direction {
    /// To the right of the screen.
    pub(super) const EAST: Self = Self { x: ONE, y: 0 };

    /// That of a vector whose components are less than 2²⁸; `None` for zero.
    pub(super) fn of(run: (i32, i32)) -> Option<Self> {
        Self::and_length(run).map(|(direction, _)| direction)
    }

    /// The direction and the length, in 2⁻¹⁶ sixteenths of a pixel; that is at most 2⁻³⁰ of itself and 1 unit too short.
    pub(super) fn and_length((x, y): (i32, i32)) -> Option<(Self, i64)> {
        // Scaled so that short segments keep their digits: 2³⁰ ≤ longer < 2³¹, squares < 2⁶³.
        let longer = (x.unsigned_abs() | y.unsigned_abs()).checked_ilog2()?;
        let scale = FRACTION.saturating_sub(longer);
        let [x, y] = [x, y].map(|v| i64::from(v) << scale);
        let squares = x.unsigned_abs().pow(2) + y.unsigned_abs().pow(2);
        // 2³⁰ ≤ length < 2³², and what is multiplied is no longer: products stay below 2⁶³.
        let length = squares.isqrt().max(1);
        let inverse = ((1 << 62) / length).cast_signed();
        let [x, y] = [x, y].map(|v| low_i32(shift_round(v * inverse, 62 - FRACTION)));
        Some((Self { x, y }, ((length << LENGTH_FRACTION) >> scale).cast_signed()))
    }

    /// The same line, the other way.
    pub(super) const fn reversed(self) -> Self {
        Self { x: self.x.wrapping_neg(), y: self.y.wrapping_neg() }
    }

    /// A quarter turn clockwise, as seen on the screen.
    pub(super) const fn right(self) -> Self {
        Self { x: self.y.wrapping_neg(), y: self.x }
    }

    /// A quarter turn counter-clockwise.
    pub(super) const fn left(self) -> Self {
        self.right().reversed()
    }

    /// Turned clockwise by an angle of which the cosine and the sine are given. Its length changes by 2⁻³⁰.
    pub(super) fn turned(self, (cosine, sine): (i32, i32)) -> Self {
        let [x, y, cosine, sine] = [self.x, self.y, cosine, sine].map(i64::from);
        let [x, y] = [x * cosine - y * sine, x * sine + y * cosine];
        let [x, y] = [x, y].map(|v| low_i32(shift_round(v, FRACTION)));
        Self { x, y }
    }

    /// The cosine of the angle to another direction.
    pub(super) fn dot(self, other: Self) -> i32 {
        let product = i64::from(self.x) * i64::from(other.x) + i64::from(self.y) * i64::from(other.y);
        low_i32(shift_round(product, FRACTION))
    }

    /// The sine: positive where the other direction is clockwise of this one. Exact, with 60 fraction bits.
    pub(super) fn cross(self, other: Self) -> i64 {
        i64::from(self.x) * i64::from(other.y) - i64::from(self.y) * i64::from(other.x)
    }

    /// How far a point lies ahead, in the unit of lengths. The components are less than 2³⁰.
    pub(super) fn ahead(self, (x, y): (i32, i32)) -> i64 {
        shift_round(i64::from(self.x) * i64::from(x) + i64::from(self.y) * i64::from(y), FRACTION - LENGTH_FRACTION)
    }

    /// The vector of this direction and some length, to the nearest sixteenth of a pixel.
    pub(super) fn times(self, length: i64) -> Offset {
        // Of long ones the last bits are left out, less than 2⁻⁵ sixteenths.
        let dropped = if length < 1 << 33 { 0 } else { 11 };
        let [x, y] = [self.x, self.y]
            .map(|v| low_i32(shift_round(i64::from(v) * (length >> dropped), FRACTION + LENGTH_FRACTION - dropped)));
        Offset { x, y }
    }

    /// Half a width in this direction, to the nearest sixteenth of a pixel.
    pub(super) fn half(self, width: u16) -> Offset {
        let [x, y] = [self.x, self.y].map(|v| low_i32(shift_round(i64::from(v) * i64::from(width), FRACTION + 1)));
        Offset { x, y }
    }
}

/// A vector in sixteenths of a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Offset {
    pub(super) x: i32,
    pub(super) y: i32,
}

impl Offset {
    /// The opposite.
    pub(super) const fn reversed(self) -> Self {
        Self { x: self.x.wrapping_neg(), y: self.y.wrapping_neg() }
    }

    /// A quarter turn counter-clockwise, as seen on the screen.
    pub(super) const fn left(self) -> Self {
        Self { x: self.y, y: self.x.wrapping_neg() }
    }

    /// Both, one after the other.
    pub(super) const fn plus(self, other: Self) -> Self {
        Self { x: self.x.wrapping_add(other.x), y: self.y.wrapping_add(other.y) }
    }

    /// The point that is this far from another.
    #[inline]
    pub(super) const fn from(self, point: Point2) -> Point2 {
        Point2::from_sixteenths(point.x.to_bits().saturating_add(self.x), point.y.to_bits().saturating_add(self.y))
    }

    /// Twice the area of the triangle that this and another span: positive where the other is clockwise.
    pub(super) fn cross(self, other: Self) -> i64 {
        i64::from(self.x) * i64::from(other.y) - i64::from(self.y) * i64::from(other.x)
    }
}

/// From one point to another.
pub(super) fn between(from: Point2, to: Point2) -> (i32, i32) {
    (
        saturate_i32(i64::from(to.x.to_bits()) - i64::from(from.x.to_bits())),
        saturate_i32(i64::from(to.y.to_bits()) - i64::from(from.y.to_bits())),
    )
}

/// Divides by a power of two, rounded to the nearest; ties away from zero, so that it is symmetric.
pub(super) const fn shift_round(value: i64, shift: u32) -> i64 {
    let magnitude = (value.unsigned_abs() + (1 << (shift - 1))) >> shift;
    if value < 0 { -magnitude.cast_signed() } else { magnitude.cast_signed() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn run() -> impl Strategy<Value = (i32, i32)> {
        const END: i32 = (1 << 27) - 1;
        let one = || prop_oneof![-9..10_i32, -3000..3000_i32, -END..=END];
        (one(), one()).prop_filter("a direction", |run| *run != (0, 0))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(10_000))]
        #[test]
        fn a_direction_is_right_to_29_bits_and_symmetric((x, y) in run(), width: u16) {
            let direction = Direction::of((x, y)).expect("not zero");
            let length = f64::from(x).hypot(f64::from(y));
            for (got, exact) in [(direction.x, f64::from(x) / length), (direction.y, f64::from(y) / length)] {
                prop_assert!((f64::from(got) / f64::from(ONE) - exact).abs() <= 1.0 / f64::from(1 << 29), "{}", got);
            }
            let back = Direction::of((-x, -y)).expect("not zero");
            prop_assert_eq!((back.x, back.y), (-direction.x, -direction.y));
            prop_assert_eq!(back.half(width), direction.half(width).reversed());
            prop_assert!((f64::from(direction.half(width).x) - f64::from(width) / 2.0 * f64::from(x) / length).abs() < 0.501);
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(10_000))]
        #[test]
        fn lengths_and_points_along_are_right_to_30_bits((x, y) in run(), part in 0.0..=1.0_f64) {
            let (direction, length) = Direction::and_length((x, y)).expect("not zero");
            let (exact, unit) = (f64::from(x).hypot(f64::from(y)), f64::from(1 << LENGTH_FRACTION));
            #[expect(clippy::cast_precision_loss, clippy::cast_possible_truncation, reason = "less than 2^44")]
            let (got, at) = (length as f64 / unit, (part * length as f64) as i64);
            prop_assert!((exact * (1.0 - 1e-9) - 1.01 / unit..=exact + 1e-7).contains(&got), "{} for {}", got, exact);
            let Offset { x: got_x, y: got_y } = direction.times(at);
            // Half of a sixteenth by rounding, 2⁻⁵ by the bits left out, and the direction's own error.
            let allowed = 0.5 + 0.04 + got / f64::from(1 << 29);
            for (got, whole) in [(got_x, x), (got_y, y)] {
                prop_assert!((f64::from(got) - part * f64::from(whole)).abs() <= allowed, "{}", got);
            }
        }
    }

    #[test]
    fn along_the_axes_half_a_width_is_exact() {
        for length in [1, 3, 7, 255, 65_537, (1 << 27) - 1] {
            for width in [16, 48, 512, 65_520] {
                let half = Direction::of((0, -length)).expect("not zero").half(width);
                assert_eq!(half, Offset { x: 0, y: -i32::from(width) / 2 });
            }
        }
    }
}
