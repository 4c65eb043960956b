//! The light on a point of a surface: what lamps give, and what shading asks for.
//!
//! ```text
//!                   for each object                for each vertex: Gouraud
//!   lamps, camera ────────────────▶ Illumination ─────────────────────────▶ light
//!                                                  for each fragment: Phong
//! ```
//!
//! It is computed in the object's own space, in which its mesh is stored: so no vertex and no normal has to be
//! moved into the world first.

use crate::{
    colour::Light,
    num::{low_i16, low_u8, saturate_u32},
};

/// The light on a point of a surface, in the object's own space.
pub trait Illumination {
    /// The light on a place, 2.14 as in a mesh, with a normal of length 2¹⁴.
    fn on(&self, position: [i16; 3], normal: [i16; 3]) -> Light;

    /// The same for a normal of length 127, as a mesh has them. Some lamps do it cheaper.
    #[inline]
    fn on_vertex(&self, position: [i16; 3], normal: [i8; 3]) -> Light {
        // 127 · 129 = 2¹⁴ − 1.
        self.on(position, normal.map(|n| i16::from(n) * 129))
    }
}

/// The same light everywhere, as in fog: shows only outlines.
impl Illumination for Light {
    fn on(&self, _: [i16; 3], _: [i16; 3]) -> Light {
        *self
    }

    fn on_vertex(&self, _: [i16; 3], _: [i8; 3]) -> Light {
        *self
    }
}

impl<T: Illumination> Illumination for &T {
    #[inline]
    fn on(&self, position: [i16; 3], normal: [i16; 3]) -> Light {
        T::on(self, position, normal)
    }

    #[inline]
    fn on_vertex(&self, position: [i16; 3], normal: [i8; 3]) -> Light {
        T::on_vertex(self, position, normal)
    }
}

/// The normal of length 2¹⁴ in the direction of one of any length, as it comes out of interpolation.
///
/// Each component is within 2 units of the exact one; the zero vector stays what it is. No division; 170
/// instructions of a Cortex-M0 and 96 bytes of table.
///
/// ```
/// use aquatint::illumination::unit_normal;
///
/// assert_eq!(unit_normal([3, 0, -4]), [9830, 0, -13_107]);
/// ```
#[must_use]
pub fn unit_normal(normal: [i32; 3]) -> [i16; 3] {
    Unit::of(normal).map_or([0; 3], |unit| unit.direction.map(low_i16))
}

/// A vector taken apart into its direction and its length.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Unit {
    /// Of length 2¹⁴.
    pub(crate) direction: [i32; 3],
    /// One over the length is `reciprocal / 2^shift`, within a part in 2¹³; 16 bits.
    pub(crate) reciprocal: u32,
    /// 16 to 48.
    pub(crate) shift: u32,
}

impl Unit {
    /// `None` for the zero vector.
    #[inline]
    pub(crate) fn of(vector: [i32; 3]) -> Option<Self> {
        let largest = vector.iter().fold(0, |largest: u32, v| largest.max(v.unsigned_abs()));
        if largest == 0 {
            return None;
        }
        // 2¹⁴ ≤ largest ≤ 2¹⁵, so the sum of the squares is from 2²⁸ to 3 · 2³⁰.
        let up = largest.leading_zeros();
        let short = vector.map(|v| if up >= 17 { v << (up - 17) } else { (v >> (16 - up)).saturating_add(1) >> 1 });
        let squares = short.iter().fold(0, |sum, v| sum + v.unsigned_abs() * v.unsigned_abs());
        let half = u32::from(squares < 1 << 30);
        let reciprocal = reciprocal_root(squares << (2 * half));
        // Less than 2³¹: the direction, 17 bits higher up or 16.
        let along = |v: i32| (((v * reciprocal.cast_signed()) >> 8) + (1 << (8 - half))) >> (9 - half);
        Some(Self { direction: short.map(along), reciprocal, shift: 48 - half - up })
    }
}

/// 2³¹ over the square root of a number from 2³⁰ on: 2¹⁵ to 2¹⁶ − 1, within a part in 2¹⁴.
///
/// From the middle of one of 96 intervals, then two steps of Newton's: `y · (3 − x · y²) / 2`.
#[inline]
const fn reciprocal_root(square: u32) -> u32 {
    let upper = (square >> 16) + (square >> 15 & 1); // 2.14
    let interval = (square >> 25) as usize;
    let seed = if interval >= 32 && interval < 128 { ROOTS[interval - 32] } else { u8::MAX };
    let mut root = (seed as u32) << 8 | 0x80; // 0.16
    let mut step = 0;
    while step < 2 {
        let product = upper * ((root * root).saturating_add(1 << 15) >> 16); // 2.30, about 1
        root = (root * (((3 << 30) - product + (1 << 15)) >> 16) + (1 << 14)) >> 15;
        root = if root > 0xFFFF { 0xFFFF } else { root };
        step += 1;
    }
    root
}

/// 2⁸ over the square root of the middle of each of the intervals of 1/32 from 1 to 4, rounded down.
static ROOTS: [u8; 96] = {
    let (mut roots, mut interval) = ([0; 96], 0_usize);
    while interval < 96 {
        // 2³² over the root of 2⁴⁸ times the middle.
        let root = (1_u64 << 32) / ((2 * (interval as u64 + 32) + 1) << 42).isqrt();
        roots[interval] = low_u8(saturate_u32(root));
        interval += 1;
    }
    roots
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_right_to_14_bits() {
        let mut worst = 0.0_f64;
        for i in 0..=3_000_000_u32 {
            let square = (1 << 30) + i * 1_073;
            let exact = 2_147_483_648.0 / f64::from(square).sqrt();
            worst = worst.max((f64::from(reciprocal_root(square)) / exact - 1.0).abs());
        }
        assert!(worst <= 1.0 / 16_384.0, "{worst}");
        assert_eq!(reciprocal_root(u32::MAX), 1 << 15);
    }

    #[test]
    fn lengths_are_right_to_13_bits() {
        let mut seed = 1_u64;
        for bits in (0..32).cycle().take(300_000) {
            let vector = [0; 3].map(|_| {
                seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                crate::num::low_i32((seed >> 32).cast_signed()) >> bits
            });
            let length = vector.map(f64::from).iter().map(|v| v * v).sum::<f64>().sqrt();
            let Some(unit) = Unit::of(vector) else { continue };
            let got = f64::from(unit.reciprocal) / 2.0_f64.powi(unit.shift.cast_signed());
            assert!((got * length - 1.0).abs() <= 1.0 / 8_192.0, "{vector:?}: {got} for {}", 1.0 / length);
            for (got, exact) in unit.direction.into_iter().zip(vector) {
                let error = f64::from(got) - f64::from(exact) / length * 16_384.0;
                assert!(error.abs() <= 2.0, "{vector:?}: {error}");
            }
        }
    }

    #[test]
    fn extreme_normals() {
        assert_eq!(unit_normal([0; 3]), [0; 3]);
        assert_eq!(unit_normal([i32::MIN, 0, 0]), [-16_384, 0, 0]);
        assert_eq!(unit_normal([0, i32::MAX, 0]), [0, 16_384, 0]);
        assert_eq!(unit_normal([0, 0, -1]), [0, 0, -16_384]);
        let corner = unit_normal([i32::MIN; 3]);
        assert!(corner.iter().all(|v| (v + 9_459).abs() <= 2), "{corner:?}");
    }
}
