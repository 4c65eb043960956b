//! How fast attributes change over a triangle: gradients, in integers.
//!
//! ```text
//!   gradient along x = (rise₂ · y₃ − rise₃ · y₂) / area      sides and rises from the first corner
//! ```
//!
//! One reciprocal serves all attributes of a triangle. Where the sides are shorter than 512 pixels, all products are of
//! 32 bits; larger triangles are computed exactly, with divisions of 64 bits.

use crate::{
    num::{
        FRACTION_16_15, SUBPIXELS, bits, divide_floor, divide_round, low_i32, low_u32, multiply_high, reciprocal,
        to_16_15,
    },
    space::{Point2, twice_area},
    vary::Plane,
};

/// Triangles whose sides are shorter than this along both axes, in sixteenths, do with products of 32 bits.
const SMALL: u32 = 1 << 13;

/// Where large triangles are far out, their planes begin no farther from pixel (0, 0) than this.
const SCREEN: i32 = 1023;

/// The numerators of two gradients, of which some binary digits are cut off; if negative, that many are added.
struct Numerators {
    along: [i32; 2],
    cut: i32,
}

/// What all planes over a triangle have in common: its sides, and one over its area.
#[derive(Clone, Copy, Debug)]
pub struct Slopes {
    first: Point2,
    /// The pixel that planes begin at.
    from: (i32, i32),
    to_second: (i32, i32),
    to_third: (i32, i32),
    /// Twice the area, signed.
    area: i64,
    /// One over it, if the triangle is small.
    over_area: Option<(u32, u32)>,
    /// So many digits more than 16 of the rises have room in products of 32 bits.
    room: u32,
}

impl Slopes {
    /// Of three corners nearer than [`LIMIT`]. One reciprocal where the triangle is small.
    #[inline]
    pub(crate) fn new(&[a, b, c]: &[Point2; 3]) -> Self {
        let to = |p: Point2| (p.x.to_bits().wrapping_sub(a.x.to_bits()), p.y.to_bits().wrapping_sub(a.y.to_bits()));
        let (to_second, to_third) = (to(b), to(c));
        let longest = |(x, y): (i32, i32)| x.unsigned_abs() | y.unsigned_abs();
        let from = (a.x.to_bits() >> 4, a.y.to_bits() >> 4);
        let longest = longest(to_second) | longest(to_third);
        let room = match longest {
            0..0x40 => 7,
            0x40..0x100 => 5,
            0x100..0x400 => 3,
            _ => 0,
        };
        if longest < SMALL {
            let area = to_second.0 * to_third.1 - to_third.0 * to_second.1;
            let over_area = Some(reciprocal(area.unsigned_abs()));
            return Self { first: a, from, to_second, to_third, area: area.into(), over_area, room };
        }
        let from = (from.0.clamp(0, SCREEN), from.1.clamp(0, SCREEN));
        Self { first: a, from, to_second, to_third, area: twice_area(a, b, c), over_area: None, room }
    }

    /// The plane of attributes of 16 bits, a list for each corner.
    #[inline]
    #[must_use]
    pub fn plane<const N: usize>(&self, corners: &[[u16; N]; 3]) -> Plane<N> {
        // All their digits count.
        let fine = corners.map(|attributes| attributes.map(to_16_15));
        self.plane_by(&fine, |rises| self.small(self.numerators(rises, FRACTION_16_15)), 1 << (FRACTION_16_15 - 1))
    }

    /// The plane of depths of 31 bits. In a small triangle, 15 digits of their rises count.
    #[inline]
    pub(crate) fn depth_plane(&self, depths: [u32; 3]) -> Plane<1> {
        let gradients = |rises: (i32, i32)| {
            // Two at a time: leading zeros would be a call on a small core.
            let (mut digits, mut cut) = (rises.0.unsigned_abs() | rises.1.unsigned_abs(), 0);
            while digits >= 1 << 16 {
                (digits, cut) = (digits >> 2, cut + 2);
            }
            self.small(self.numerators(rises, cut))
        };
        self.plane_by(&depths.map(|depth| [depth]), gradients, 1 << (FRACTION_16_15 - 1))
    }

    /// The plane of numbers below 2³¹ with all digits of the rises, and without the half for rounding: for what is divided
    /// afterwards.
    #[inline]
    pub(crate) fn fine_plane<const N: usize>(&self, corners: &[[u32; N]; 3]) -> Plane<N> {
        self.plane_by(corners, |rises| self.small(self.all_numerators(rises)), 0)
    }

    #[inline]
    fn plane_by<const N: usize>(
        &self,
        [a, b, c]: &[[u32; N]; 3],
        gradients: impl Fn((i32, i32)) -> Option<(u32, u32, u32)>,
        half: u32,
    ) -> Plane<N> {
        let (column, row) = self.from;
        let mut plane = Plane { origin: *a, column, row, across: [0; N], down: [0; N] };
        let outputs = plane.origin.iter_mut().zip(&mut plane.across).zip(&mut plane.down);
        for (((origin, across), down), (second, third)) in outputs.zip(b.iter().zip(c)) {
            let rise = |to: u32| to.cast_signed().wrapping_sub(origin.cast_signed());
            let rises = (rise(*second), rise(*third));
            let (along_x, along_y, offset) = gradients(rises).unwrap_or_else(|| self.exact(rises));
            *origin = origin.wrapping_add(half).wrapping_add(offset);
            (*across, *down) = (along_x, along_y);
        }
        plane
    }

    /// The numerators of the gradients, of which some binary digits are cut off, so that 16 are left of the rises: these,
    /// and how many digits. In products of 32 bits.
    #[inline]
    fn numerators(&self, (second, third): (i32, i32), cut: u32) -> Numerators {
        let (second, third) = (second >> cut, third >> cut);
        // A side is below 2¹³ where these are used.
        let (b, c) = (self.to_second, self.to_third);
        let difference = |p: i32, q: i32, r: i32, s: i32| p.wrapping_mul(q).wrapping_sub(r.wrapping_mul(s));
        let along = [difference(second, c.1, third, b.1), difference(third, b.0, second, c.0)];
        Numerators { along: along.map(|along| along << self.room), cut: cut.cast_signed() - self.room.cast_signed() }
    }

    /// The same in products of 64 bits, with 31 digits.
    fn all_numerators(&self, (second, third): (i32, i32)) -> Numerators {
        let (b, c) = (self.to_second, self.to_third);
        let product = |p: i32, q: i32| i64::from(p) * i64::from(q);
        let along_x = product(second, c.1) - product(third, b.1);
        let along_y = product(third, b.0) - product(second, c.0);
        let cut = 34_u32.saturating_sub((along_x.unsigned_abs() | along_y.unsigned_abs()).leading_zeros());
        Numerators { along: [low_i32(along_x >> cut), low_i32(along_y >> cut)], cut: cut.cast_signed() }
    }

    /// Gradients a pixel, and the way from the first corner to the centre of its pixel; of a small triangle, if they
    /// fit.
    #[inline]
    fn small(&self, Numerators { along: [along_x, along_y], cut }: Numerators) -> Option<(u32, u32, u32)> {
        let (over, zeros) = self.over_area?;
        // over · 2^zeros / 2^63 is one over the area; a pixel has 2^4 sixteenths; the product has lost 32 digits.
        let shift = 27 - zeros.cast_signed() - cut;
        let (right, left) = (shift.max(0), (-shift).max(0));
        let gradient = |numerator: i32| {
            let numerator = if self.area < 0 { numerator.wrapping_neg() } else { numerator };
            let product = multiply_high(numerator, over);
            let half = (1 << right) >> 1;
            let gradient = ((product + half) >> right) << left;
            // Steeper than 2³¹ a pixel: a sliver.
            (gradient >> left == product || left == 0).then_some(gradient)
        };
        let (along_x, along_y) = (gradient(along_x)?, gradient(along_y)?);
        let [x, y] = self.way_to_centre();
        Some((bits(along_x), bits(along_y), bits(sixteenth_of(along_x, x).wrapping_add(sixteenth_of(along_y, y)))))
    }

    /// The same for any triangle, exact but for the rounding of the steps: four 64-bit divisions.
    #[cold]
    #[inline(never)]
    fn exact(&self, (second, third): (i32, i32)) -> (u32, u32, u32) {
        let wide = |(x, y): (i32, i32)| (i64::from(x), i64::from(y));
        let (b, c) = (wide(self.to_second), wide(self.to_third));
        let (second, third) = (i64::from(second), i64::from(third));
        // 32 bits by 22 bits, two of them, by 16: below 2⁵⁹.
        let signed = |numerator: i64| (self.area.signum() * numerator) << 4;
        let (along_x, along_y) = (signed(second * c.1 - third * b.1), signed(third * b.0 - second * c.0));
        let area = self.area.abs();
        let [x, y] = self.way_to_centre().map(i64::from);
        let offset = times_quotient(along_x, area, x).wrapping_add(times_quotient(along_y, area, y)) >> 4;
        let step = |numerator| low_u32(divide_round(numerator, area));
        (step(along_x), step(along_y), low_u32(offset))
    }

    /// From the first corner to the centre of the pixel that planes begin at, in sixteenths.
    #[inline]
    fn way_to_centre(&self) -> [i32; 2] {
        let (column, row) = self.from;
        let along = |pixel: i32, corner: i32| (pixel * SUBPIXELS + SUBPIXELS / 2).wrapping_sub(corner);
        [along(column, self.first.x.to_bits()), along(row, self.first.y.to_bits())]
    }
}

/// `numerator / divisor · factor`, rounded down once but for 2⁻¹⁵, modulo 2⁶⁴: for a divisor below 2⁴⁴ and a factor
/// below 2²³.
fn times_quotient(numerator: i64, divisor: i64, factor: i64) -> i64 {
    let (whole, part) = divide_floor(numerator, divisor);
    // A part has up to 44 bits, and there is room for 63 of a product.
    let parts = divide_floor((part >> 5) * factor, (divisor >> 5).max(1)).0;
    whole.wrapping_mul(factor).wrapping_add(if divisor < 1 << 40 {
        divide_floor(part * factor, divisor).0
    } else {
        parts
    })
}

/// `value · part / 16`, rounded down, for a part of some sixteenths; in 32 bits.
#[inline]
const fn sixteenth_of(value: i32, part: i32) -> i32 {
    (value >> 4).wrapping_mul(part).wrapping_add(((value & 15) * part) >> 4)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The attribute at the centre of a pixel, in floating point.
    fn exact(points: [(i32, i32); 3], values: [u32; 3], (x, y): (i32, i32)) -> f64 {
        let [(ax, ay), (bx, by), (cx, cy)] = points.map(|(x, y)| (f64::from(x), f64::from(y)));
        let [va, vb, vc] = values.map(f64::from);
        let area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
        let (px, py) = (f64::from(x) * 16.0 + 8.0 - ax, f64::from(y) * 16.0 + 8.0 - ay);
        let along_x = ((vb - va) * (cy - ay) - (vc - va) * (by - ay)) / area;
        let along_y = ((vc - va) * (bx - ax) - (vb - va) * (cx - ax)) / area;
        va + along_x * px + along_y * py
    }

    /// How much the corners weigh at the centre of a pixel, signs left out: 1 inside of the triangle.
    fn spread(points: [(i32, i32); 3], pixel: (i32, i32)) -> f64 {
        let weight = |corner: usize| {
            let mut values = [0; 3];
            values[corner] = 1;
            exact(points, values, pixel).abs()
        };
        [0, 1, 2].map(weight).iter().sum()
    }

    fn corner(reach: i32) -> impl Strategy<Value = (i32, i32)> {
        (-reach..reach, -reach..reach)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]
        #[test]
        fn planes_are_right_at_the_centres_inside(
            points in prop_oneof![
                prop::array::uniform3(corner(100)), prop::array::uniform3(corner(4_000)), prop::array::uniform3(corner(60_000))
            ],
            values in prop::array::uniform3(prop_oneof![0..1_u32 << 31, Just(0_u32), Just((1_u32 << 31) - (1 << 15)), 0..1_u32 << 16]),
            weights in prop::array::uniform3(0..1000_i64),
        ) {
            let [a, b, c] = points.map(|(x, y)| Point2::from_sixteenths(x, y));
            prop_assume!(twice_area(a, b, c) != 0);
            let sum = weights.iter().sum::<i64>().max(1);
            let mean = |of: fn((i32, i32)) -> i32| {
                low_i32(points.iter().zip(weights).map(|(p, w)| i64::from(of(*p)) * w).sum::<i64>() / sum)
            };
            let (x, y) = (mean(|p| p.0) >> 4, mean(|p| p.1) >> 4);
            let want = exact(points, values, (x, y));
            // Only what is inside is promised.
            prop_assume!((0.0..2_147_483_648.0).contains(&want));
            let plane = Slopes::new(&[a, b, c]).depth_plane(values);
            let [got] = plane.at(y, x).next_fine();
            let [fine] = Slopes::new(&[a, b, c]).fine_plane(&values.map(|value| [value])).at(y, x).next_fine();
            // A rise of more than 15 bits is cut to 15.
            let rise = values.iter().max().zip(values.iter().min()).map_or(0.0, |(high, low)| f64::from(high - low));
            let longest = points.iter().map(|p| (p.0 - points[0].0).abs().max((p.1 - points[0].1).abs())).max();
            let is_small = longest.is_some_and(|longest| longest.unsigned_abs() < SMALL);
            // Outside of a sliver, corners weigh more than one together.
            let spread = spread(points, (x, y)).max(1.0);
            let cut = if is_small { rise / 16_384.0 * 3.0 * spread } else { 0.0 };
            let error = (f64::from(got.wrapping_sub(1 << 14).cast_signed()) - want).abs();
            let away = |at: i32, from: i32| f64::from((at - if is_small { from >> 4 } else { (from >> 4).clamp(0, SCREEN) }).abs());
            let distance = away(x, points[0].0) + away(y, points[0].1);
            let fine_error = (f64::from(fine.cast_signed()) - want).abs();
            prop_assert!(fine_error <= 16.0 * (distance + 1.0) * spread || want + distance > 2_147_483_000.0, "{} for {}", fine, want);
            prop_assert!(error <= distance + cut + 2.0, "{} for {}: {}", got, want, error);
        }
    }
}
