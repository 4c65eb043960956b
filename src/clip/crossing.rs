//! The place where an edge crosses a boundary, exact and then rounded once.
//!
//! ```text
//!   inside ●──────────┼─────● outside      t = part / whole
//!          ├── part ──┤     │
//!          ├──── whole ─────┤
//! ```
//!
//! A coordinate there is `inside + (outside − inside) · part / whole`, rounded to the nearest, ties to
//! the larger. That is a rule about the *value*, not about the way to it, so an edge is cut at the same
//! place from both ends: two polygons that share an edge still share it when both have been cut.

use crate::{
    num::{Scalar, Subpixel, low_u32, saturate_u16, saturate_u32},
    space::Point2,
    vary::Vertex,
};

/// A vertex that can be made between two others.
pub trait Cut: Copy {
    /// The vertex where the boundary crosses the edge from `inside` to `outside`, whose signed
    /// distances from the boundary are `≥ 0` and `< 0`.
    #[must_use]
    fn cut(inside: Self, outside: Self, crossing: Crossing) -> Self;
}

impl Cut for Point2 {
    fn cut(inside: Self, outside: Self, crossing: Crossing) -> Self {
        let between = |inside: Subpixel, outside: Subpixel| crossing.coordinate(inside.to_bits(), outside.to_bits());
        Self::from_sixteenths(between(inside.x, outside.x), between(inside.y, outside.y))
    }
}

impl<const N: usize> Cut for Vertex<N> {
    fn cut(inside: Self, outside: Self, crossing: Crossing) -> Self {
        let mut attributes = inside.attributes;
        for (attribute, outside) in attributes.iter_mut().zip(outside.attributes) {
            *attribute = crossing.attribute(*attribute, outside);
        }
        Self { position: Cut::cut(inside.position, outside.position, crossing), attributes }
    }
}

/// How far along an edge its crossing with a boundary lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Crossing {
    part: u64,
    whole: u64,
}

/// A number between two whole ones, and what it is rounded to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Rounded {
    pub(super) floor: i32,
    pub(super) nearest: i32,
    pub(super) ceiling: i32,
}

impl Crossing {
    /// The crossing of an edge whose ends lie `inside ≥ 0` and `outside < 0` from the boundary, in any unit.
    pub(super) const fn new(inside: i64, outside: i64) -> Self {
        Self { part: inside.unsigned_abs(), whole: inside.abs_diff(outside) }
    }

    /// The place after `part` of `whole` steps; `part ≤ whole`.
    pub(super) const fn after(part: u32, whole: u32) -> Self {
        Self { part: part as u64, whole: whole as u64 }
    }

    /// The place after `part` of `whole` of the way from inside; `part ≤ whole`.
    pub(super) const fn of(part: u64, whole: u64) -> Self {
        Self { part, whole }
    }

    /// How much of the edge lies inside, as a numerator and a denominator.
    #[must_use]
    pub const fn fraction(self) -> (u64, u64) {
        (self.part, self.whole)
    }

    /// The value at the boundary of what is `inside` and `outside` at the ends, to the nearest.
    ///
    /// Right for all values and distances. One 64-bit division, none where the two are equal.
    #[must_use]
    pub const fn coordinate(self, inside: i32, outside: i32) -> i32 {
        self.between(inside, outside).nearest
    }

    /// [`coordinate`](Self::coordinate) for an attribute.
    #[must_use]
    pub const fn attribute(self, inside: u16, outside: u16) -> u16 {
        saturate_u16(self.between(inside as i32, outside as i32).nearest as i64)
    }

    /// The value at the boundary, and the whole numbers around it.
    pub(super) const fn between(self, inside: i32, outside: i32) -> Rounded {
        if inside == outside {
            return Rounded { floor: inside, nearest: inside, ceiling: inside };
        }
        // From the smaller value, so that there is one way to round.
        let (from, part) =
            if inside < outside { (inside, self.part) } else { (outside, self.whole.wrapping_sub(self.part)) };
        let (steps, rest) = multiply_divide(inside.abs_diff(outside), part, self.whole);
        let floor = from.wrapping_add_unsigned(steps);
        Rounded {
            floor,
            nearest: floor.wrapping_add((rest >= self.whole.wrapping_sub(rest)) as i32),
            ceiling: floor.wrapping_add((rest > 0) as i32),
        }
    }
}

/// A crossing at which many values are wanted: one division for all of them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mixer {
    crossing: Crossing,
    /// `2³² · part / whole`, nearly: off by less than 3, and not more than 1 too small if both are short.
    way: u32,
    /// Part and whole, if they are below 2³¹: as between vertices in clip space that are not far out.
    short: Option<(u32, u32)>,
}

impl Mixer {
    /// Divides once, by the leading 32 bits of the whole.
    pub(super) const fn new(crossing: Crossing) -> Self {
        let excess = (u64::BITS - crossing.whole.leading_zeros()).saturating_sub(u32::BITS);
        let (part, whole) = (crossing.part >> excess, crossing.whole >> excess);
        let way = match (part << u32::BITS).checked_div(whole) {
            Some(way) => saturate_u32(way),
            None => 0,
        };
        let is_short = 0 < crossing.whole && crossing.whole < 1 << 31;
        let short = if is_short { Some((saturate_u32(part), saturate_u32(whole))) } else { None };
        Self { crossing, way, short }
    }

    /// [`Crossing::coordinate`]: the same number for all values, without a division.
    #[inline]
    pub(super) fn coordinate(&self, inside: i32, outside: i32) -> i32 {
        let Some((part, whole)) = self.short else { return self.long_coordinate(inside, outside) };
        let (from, part, way) =
            if inside < outside { (inside, part, self.way) } else { (outside, whole - part, !self.way) };
        let length = inside.abs_diff(outside);
        let steps = low_u32(((u64::from(length) * u64::from(way)) >> u32::BITS).cast_signed());
        // A step less than it should be at most, so the rest is less than twice the whole: right although products wrap.
        let rest = length.wrapping_mul(part).wrapping_sub(steps.wrapping_mul(whole));
        let (steps, rest) = if rest >= whole { (steps + 1, rest - whole) } else { (steps, rest) };
        from.wrapping_add_unsigned(steps).wrapping_add(i32::from(rest >= whole - rest))
    }

    /// The same for distances of up to 60 bits, as from planes of the user's; from there on with a division each.
    #[inline(never)]
    fn long_coordinate(&self, inside: i32, outside: i32) -> i32 {
        let Crossing { part, whole } = self.crossing;
        let signed_whole = whole.cast_signed();
        if inside == outside || !(1..1 << 60).contains(&signed_whole) {
            return self.crossing.coordinate(inside, outside);
        }
        let (from, part, way) =
            if inside < outside { (inside, part, self.way) } else { (outside, whole - part, !self.way) };
        let length = u64::from(inside.abs_diff(outside));
        // Less than four off, so the rest is less than four times the whole.
        let mut steps = (length * u64::from(way)) >> u32::BITS;
        let mut rest = length.wrapping_mul(part).wrapping_sub(steps.wrapping_mul(whole)).cast_signed();
        while rest < 0 {
            (steps, rest) = (steps.wrapping_sub(1), rest + signed_whole);
        }
        while rest >= signed_whole {
            (steps, rest) = (steps.wrapping_add(1), rest - signed_whole);
        }
        from.wrapping_add_unsigned(saturate_u32(steps)).wrapping_add(i32::from(rest >= signed_whole - rest))
    }

    /// [`coordinate`](Self::coordinate) for a 16.16 number.
    pub(super) fn scalar(&self, inside: Scalar, outside: Scalar) -> Scalar {
        Scalar::from_bits(self.coordinate(inside.to_bits(), outside.to_bits()))
    }

    /// [`coordinate`](Self::coordinate) for attributes.
    pub(super) fn attributes<const N: usize>(&self, mut inside: [u16; N], outside: [u16; N]) -> [u16; N] {
        for (attribute, outside) in inside.iter_mut().zip(outside) {
            *attribute = saturate_u16(self.coordinate((*attribute).into(), outside.into()).into());
        }
        inside
    }
}

/// `⌊length · part / whole⌋` and the remainder, for `part ≤ whole`.
const fn multiply_divide(length: u32, part: u64, whole: u64) -> (u32, u64) {
    if whole == 0 {
        return (0, 0);
    }
    let (short_part, short_whole) = (saturate_u32(part), saturate_u32(whole));
    if short_part as u64 != part {
        return multiply_divide_long(length, part, whole);
    }
    let product = length as u64 * short_part as u64;
    let short = saturate_u32(product);
    if short as u64 == product && short_whole as u64 == whole {
        // Edges on a screen: 32 bits, a fraction of the instructions on a small core.
        return (short / short_whole, (short % short_whole) as u64);
    }
    (saturate_u32(product / whole), product % whole)
}

/// The same where the product has up to 96 bits: long division, a bit of the quotient a step.
#[cold]
const fn multiply_divide_long(length: u32, part: u64, whole: u64) -> (u32, u64) {
    let (mut quotient, mut rest, mut bit) = (0_u32, 0_u64, u32::BITS);
    while bit > 0 {
        bit -= 1;
        let (carry, double) = add_modulo(rest, rest, whole);
        quotient = quotient.wrapping_mul(2).wrapping_add(carry);
        rest = double;
        if length >> bit & 1 != 0 {
            let (carry, sum) = add_modulo(rest, part, whole);
            quotient = quotient.wrapping_add(carry);
            rest = sum;
        }
    }
    (quotient, rest)
}

/// `a + b` as how often `whole` goes into it, once or not at all, and what is left. `a < whole`, `b ≤ whole`.
const fn add_modulo(a: u64, b: u64, whole: u64) -> (u32, u64) {
    let missing = whole.wrapping_sub(b);
    if a >= missing { (1, a.wrapping_sub(missing)) } else { (0, a.wrapping_add(b)) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn coordinate() -> impl Strategy<Value = i32> {
        prop_oneof![-20..20_i32, -40_000..40_000_i32, any::<i32>(), Just(i32::MIN), Just(i32::MAX)]
    }

    fn distance() -> impl Strategy<Value = i64> {
        prop_oneof![0..20_i64, 0..1_i64 << 31, 0..1_i64 << 60, any::<i64>().prop_map(|v| v & i64::MAX), Just(i64::MAX)]
    }

    /// `⌊a + (b − a)·part/whole + shift/2⌋`, by the remainder of the exact numerator.
    fn exact(a: i32, b: i32, (part, whole): (u64, u64)) -> [i128; 3] {
        let [a, b, part, whole] = [i128::from(a), i128::from(b), i128::from(part), i128::from(whole)];
        // Below 2⁶⁴ · 2³³: no overflow.
        let numerator = (b - a) * part;
        let rounded = |shift: i128| a + (2 * numerator + shift).div_euclid(2 * whole);
        [rounded(0), rounded(whole), -((-numerator).div_euclid(whole)) + a]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]
        #[test]
        fn a_crossing_is_correctly_rounded_and_the_same_from_both_ends(
            a in coordinate(), b in coordinate(), inside in distance(), outside in distance(),
        ) {
            let outside = -outside.max(1);
            let there = Crossing::new(inside, outside);
            let Rounded { floor, nearest, ceiling } = there.between(a, b);
            prop_assert_eq!([floor, nearest, ceiling].map(i128::from), exact(a, b, there.fraction()));
            let back = Crossing { part: outside.unsigned_abs(), ..there };
            prop_assert_eq!(back.between(b, a), there.between(a, b));
            prop_assert_eq!(Mixer::new(there).coordinate(a, b), nearest, "one division for all");
            prop_assert_eq!(Mixer::new(back).coordinate(b, a), nearest);
        }
    }

    #[test]
    fn ties_go_to_the_larger_value_both_ways() {
        let half = Crossing::new(1, -1);
        assert_eq!([half.coordinate(0, 1), half.coordinate(1, 0)], [1, 1]);
        assert_eq!([half.coordinate(-1, 0), half.coordinate(0, -1)], [0, 0]);
        assert_eq!(half.attribute(u16::MAX, u16::MAX - 1), u16::MAX);
    }

    #[test]
    fn the_ends_are_the_ends() {
        let (start, end) = (Crossing::after(0, 7), Crossing::after(7, 7));
        assert_eq!([start, end].map(|c| c.coordinate(i32::MIN, i32::MAX)), [i32::MIN, i32::MAX]);
    }
}
