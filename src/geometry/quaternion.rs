//! Orientations as unit quaternions: they add up without drift, and turn smoothly from one to another.
//!
//! A rotation by an angle `a` about the axis `(x, y, z)` is `cos a/2 + sin a/2 · (xi + yj + zk)`. Four numbers
//! instead of nine, 16 products to chain two instead of 27, and what they lose is only their length, which
//! is made right again after each step.
//!
//! - **Takes** axes and angles.
//! - **Gives** orientations between and after others, as matrices.
//! - **Memory** 16 bytes each.
//! - **Cost** a product 1,200 instructions of a Cortex-M0; [`nlerp`](Quaternion::nlerp) a square root and four divisions,
//!   3,500.
//!
//! Components are kept with 30 fraction bits. Source: K. Shoemake, "Animating rotation with quaternion curves",
//! SIGGRAPH 1985.
#![expect(clippy::needless_pass_by_value, reason = "points are copied; their space need not be `Copy` to say so")]

use crate::{
    angle::{Angle, sine_and_cosine},
    matrix::Matrix,
    num::{Scalar, divide_round, low_i32, saturate_i32},
    space::Vector3,
};

/// Fraction bits of a component.
const FRACTION: u32 = 30;
/// 1, as components have it.
const UNIT: i64 = 1 << FRACTION;

/// An orientation: a quaternion of length 1.
///
/// ```
/// use aquatint::{Angle, Matrix, Model, Scalar, Vector3, World, geometry::quaternion::Quaternion};
///
/// let up = Vector3::<World>::new(Scalar::ZERO, Scalar::ONE, Scalar::ZERO);
/// let quarter = Quaternion::from_axis_angle(up, Angle::QUARTER).unwrap();
/// let half_way = Quaternion::IDENTITY.slerp(quarter, Scalar::ONE / 2);
/// let placement: Matrix<Model, World> = half_way.then(half_way).to_matrix();
/// assert_eq!(placement, Matrix::rotation_y(Angle::QUARTER));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Quaternion {
    /// Scalar part, then the vector part.
    parts: [i32; 4],
}

impl Default for Quaternion {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl Quaternion {
    /// No rotation.
    pub const IDENTITY: Self = Self { parts: [1 << FRACTION, 0, 0, 0] };

    /// A turn about an axis of any length but zero, counter-clockwise for whom the axis points at.
    ///
    /// `None` for the zero vector.
    #[must_use]
    pub fn from_axis_angle<S>(axis: Vector3<S>, angle: Angle) -> Option<Self> {
        let [x, y, z] = [axis.x, axis.y, axis.z].map(|v| i64::from(v.to_bits()));
        let [_, x, y, z] = unit([0, x, y, z])?.parts.map(i64::from);
        let (sin, cos) = sine_and_cosine(u32::from(angle.0) << 15);
        // From 31 fraction bits to 30, and from 61.
        let along = |axis: i64| (axis * sin) >> 31;
        Some(corrected([cos >> 1, along(x), along(y), along(z)]))
    }

    /// First this turn, then `next`, in the order of [`Matrix::then`]. The result has length 1 again, so that any
    /// number of turns may follow each other: after 10,000 the rows of the [matrix](Self::to_matrix) still are
    /// at right angles within 2⁻¹⁴.
    #[must_use]
    pub fn then(self, next: Self) -> Self {
        let ([a, b, c, d], [e, f, g, h]) = (next.parts.map(i64::from), self.parts.map(i64::from));
        let product = [
            a * e - b * f - c * g - d * h,
            a * f + b * e + c * h - d * g,
            a * g - b * h + c * e + d * f,
            a * h + b * g - c * f + d * e,
        ];
        corrected(product.map(|sum| (sum + UNIT / 2) >> FRACTION))
    }

    /// The turn back.
    #[must_use]
    pub const fn conjugate(self) -> Self {
        let [w, x, y, z] = self.parts;
        Self { parts: [w, -x, -y, -z] }
    }

    /// Part of the way to another orientation, by the shorter arc, at an *even* speed: `part` is 0 here and 1 there.
    ///
    /// Halves the arc sixteen times: exact to 2⁻²⁴, for the price of sixteen [`nlerp`](Self::nlerp)s.
    #[must_use]
    pub fn slerp(self, to: Self, part: Scalar) -> Self {
        let part = part.clamp(Scalar::ZERO, Scalar::ONE).to_bits();
        let (mut near, mut far) = (self, to.turned_like(self));
        if part == Scalar::ONE.to_bits() {
            return far;
        }
        for bit in (0..16).rev() {
            let middle = near.mixed(far, 1 << 15);
            (near, far) = if part >> bit & 1 == 0 { (near, middle) } else { (middle, far) };
        }
        near
    }

    /// Part of the way to another orientation, by the same arc as [`slerp`](Self::slerp), but faster in the middle.
    ///
    /// Between orientations 180° apart it is up to 8.2° before or behind, 90° apart up to 1°, 30° apart 0.04°:
    /// between the key frames of an animation nobody sees that.
    #[must_use]
    pub fn nlerp(self, to: Self, part: Scalar) -> Self {
        self.mixed(to.turned_like(self), part.clamp(Scalar::ZERO, Scalar::ONE).to_bits())
    }

    /// The rotation, each element within 2⁻¹⁶ of the exact one.
    #[must_use]
    pub fn to_matrix<From, To>(self) -> Matrix<From, To> {
        let [w, x, y, z] = self.parts.map(i64::from);
        // Twice a product has 59 fraction bits.
        let element = |sum: i64| Scalar::from_bits(low_i32((sum + (1 << 42)) >> 43));
        let diagonal = |p: i64, q: i64| element((UNIT << (FRACTION - 1)) - p * p - q * q);
        let (nil, one) = (Scalar::ZERO, Scalar::ONE);
        Matrix::from_rows([
            [diagonal(y, z), element(x * y - w * z), element(x * z + w * y), nil],
            [element(x * y + w * z), diagonal(x, z), element(y * z - w * x), nil],
            [element(x * z - w * y), element(y * z + w * x), diagonal(x, y), nil],
            [nil, nil, nil, one],
        ])
    }

    /// The one of the two quaternions of this orientation that is nearer to another.
    fn turned_like(self, other: Self) -> Self {
        let dot: i64 = self.parts.iter().zip(other.parts).map(|(&a, b)| i64::from(a) * i64::from(b)).sum();
        if dot < 0 { Self { parts: self.parts.map(i32::wrapping_neg) } } else { self }
    }

    /// The straight line to another quaternion, brought back to length 1; `part` is out of 65536.
    fn mixed(self, to: Self, part: i32) -> Self {
        let [mut w, mut x, mut y, mut z] = self.parts.map(i64::from);
        let [a, b, c, d] = to.parts.map(i64::from);
        for (from, to) in [(&mut w, a), (&mut x, b), (&mut y, c), (&mut z, d)] {
            *from += ((to - *from) * i64::from(part) + (1 << 15)) >> 16;
        }
        // Never zero: the two are at most a right angle apart.
        unit([w, x, y, z]).unwrap_or(self)
    }
}

/// Parts that are almost of length 1, by one step of Newton's: `p · (3 − |p|²) / 2`.
fn corrected(parts: [i64; 4]) -> Quaternion {
    let square: i64 = parts.iter().map(|v| v * v).sum::<i64>() >> FRACTION;
    let half_more = 3 * UNIT - square; // 31 fraction bits
    Quaternion { parts: parts.map(|v| saturate_i32((v * half_more + UNIT) >> (FRACTION + 1))) }
}

/// Parts of any length, less than 2³², made of length 1.
fn unit(parts: [i64; 4]) -> Option<Quaternion> {
    let largest = parts.iter().map(|v| v.unsigned_abs()).max()?;
    // Short ones keep their digits: 2²⁹ ≤ largest < 2³⁰, so the sum of the squares is less than 2⁶².
    let shift = largest.checked_ilog2()?;
    let parts = parts.map(|v| if shift <= 29 { v << (29 - shift) } else { v >> (shift - 29) });
    let squares = parts.iter().map(|v| v.unsigned_abs().pow(2)).sum::<u64>();
    let length = i64::try_from(squares.isqrt()).ok().filter(|&length| length > 0)?;
    Some(Quaternion { parts: parts.map(|v| saturate_i32(divide_round(v << FRACTION, length))) })
}
