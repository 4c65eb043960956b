//! The way back: inverse transforms, how normals turn, and rotations that have gathered errors made right again.
//!
//! ```text
//!   Model ──placement──▶ World          where is the lamp, seen from the object?
//!     ◀─────inverse──────               how do its normals stand in the world?
//! ```
//!
//! All of this is set-up, for each object of a picture at most: an inverse takes a Cortex-M0 23,000 instructions.
//! For objects that are scaled alike along all axes [`untransform_point`](Matrix::untransform_point) takes 4,500.
#![expect(clippy::needless_pass_by_value, reason = "points are copied; their space need not be `Copy` to say so")]

use super::transform::cross;
use crate::{
    matrix::Matrix,
    num::{Scalar, divide_round, saturate_i32, saturate_u32},
    space::{Point3, Point4, Vector3, View, World},
};

const ONE: Scalar = Scalar::ONE;
const NIL: Scalar = Scalar::ZERO;

impl<From, To> Matrix<From, To> {
    /// The transform that undoes this one, for any affine one: turns, moves, scales, shears, mirrors.
    ///
    /// Each element is the exact one, rounded to the nearest 2⁻¹⁶. `None` where there is none: this transform
    /// flattens space, has a last row other than 0, 0, 0, 1, or its inverse has elements beyond 16.16.
    ///
    /// ```
    /// use aquatint::{Matrix, Model, Point3, Scalar, World};
    ///
    /// let [two, four] = [2, 4].map(Scalar::from_num);
    /// let placement = Matrix::<Model, World>::scale(two).then(&Matrix::<World, World>::translation(four, four, four));
    /// let back: Matrix<World, Model> = placement.inverse().unwrap();
    /// let landed = back.transform_point(Point3::new(two, two, two));
    /// assert_eq!([landed.x, landed.y, landed.z], [-Scalar::ONE; 3]);
    /// ```
    #[must_use]
    pub fn inverse(&self) -> Option<Matrix<To, From>> {
        let [.., last] = self.rows();
        if *last != [NIL, NIL, NIL, ONE] {
            return None;
        }
        let (cofactors, determinant) = (self.cofactors(), self.determinant());
        let [[a, b, c], [d, e, f], [g, h, i]] = cofactors.map(|row| row.map(i128::from));
        let [x, y, z, _] = self.rows().map(|[.., shift]| i128::from(shift.to_bits()));
        let [x, y, z] = [[a, d, g], [b, e, h], [c, f, i]].map(|[p, q, r]| {
            let back = -(p * x + q * y + r * z);
            // Elements have 16 fraction bits, cofactors 32, the determinant 48.
            let linear = |cofactor: i128| quotient(cofactor << 32, determinant);
            Some([linear(p)?, linear(q)?, linear(r)?, quotient(back << 16, determinant)?])
        });
        Some(Matrix::from_rows([x?, y?, z?, *last]))
    }

    /// How normals turn where points are transformed by this matrix: by the inverse transpose of its upper left
    /// 3 × 3 elements, so that they stay upright on surfaces that are scaled differently along the axes.
    ///
    /// ```text
    ///    │╲   (1, 1)          ╲╲__  ╱       scaled by 2 along x, the normal (1, 1)
    ///    │ ╲ ╱                  ╲ ╲╱__      becomes (½, 1), not (2, 1)
    ///    └──╲             ───────╲────╲
    /// ```
    ///
    /// Only the direction of the result is of use: [normalise](Vector3::normalized) it. Elements are the exact
    /// ones times a factor that makes the largest ½ to 1, each within 2⁻¹⁷. It needs no inverse, so flat
    /// objects have normals too.
    #[must_use]
    pub fn normals(&self) -> Self {
        let sign = if self.determinant() < 0 { -1 } else { 1 };
        let cofactors = self.cofactors();
        let largest = cofactors.iter().flatten().fold(1, |largest: u64, c| largest.max(c.unsigned_abs()));
        let shift = largest.ilog2();
        let scaled = |c: i64| {
            let bits = if shift < 16 { c << (15 - shift.min(15)) } else { divide_round(c, 1 << (shift - 15)) };
            Scalar::from_bits(saturate_i32(sign * bits))
        };
        let [x, y, z] = cofactors.map(|[a, b, c]| [scaled(a), scaled(b), scaled(c), NIL]);
        Self::from_rows([x, y, z, [NIL, NIL, NIL, ONE]])
    }

    /// This transform without the errors that many rotations have gathered: its first three columns and rows at
    /// right angles and of length 1 again. What moves stays; scales are lost, and mirrors.
    ///
    /// The first row keeps its direction, the second its plane. Afterwards products of two rows are within
    /// 2⁻¹⁴ of 0 or 1. `None` where the first two rows are in line.
    ///
    /// Each product of rotations in 16.16 adds up to 10⁻⁴ to those errors: make them right every 64, or keep the angles or
    /// a [`Quaternion`](super::quaternion::Quaternion) instead.
    #[must_use]
    pub fn orthonormalized(&self) -> Option<Self> {
        let [[a, b, c, x], [d, e, f, y], [_, _, _, z], last] = *self.rows();
        let first = Vector3::<To>::new(a, b, c).normalized()?;
        let third = cross(&first, &Vector3::new(d, e, f).normalized()?).normalized()?;
        let second = cross(&third, &first);
        let row = |v: Vector3<To>, shift| [v.x, v.y, v.z, shift];
        Some(Self::from_rows([row(first, x), row(second, y), row(third, z), last]))
    }

    /// Where a point came from, for turns, moves, and scales that are the same along all axes.
    ///
    /// Multiplies by the transpose, and divides by the square of the scale: three divisions, where
    /// [`inverse`](Self::inverse) takes twelve longer ones. Off by 2⁻¹³ of the result's own size, as far as
    /// rotations in 16.16 are from right angles, and by 2⁻¹⁵ and 2⁻¹⁵ over the scale. `None` for a scale of zero.
    #[must_use]
    pub fn untransform_point(&self, point: Point3<To>) -> Option<Point3<From>> {
        let [[a, b, c, x], [d, e, f, y], [g, h, i, z], _] =
            self.rows().map(|row| row.map(|element| i64::from(element.to_bits())));
        let offset = |p: Scalar, shift: i64| i64::from(saturate_i32(i64::from(p.to_bits()) - shift));
        let (x, y, z) = (offset(point.x, x), offset(point.y, y), offset(point.z, z));
        // The mean of the three columns is the square of the scale, in 32.32.
        let square =
            [a, b, c, d, e, f, g, h, i].iter().map(|v| v.unsigned_abs().pow(2) / 3).fold(0, u64::saturating_add);
        let [x, y, z] = [[a, d, g], [b, e, h], [c, f, i]].map(|[p, q, r]| {
            let sum = (p * x).saturating_add(q * y).saturating_add(r * z);
            over_square(sum, square)
        });
        Some(Point3::new(x?, y?, z?))
    }

    /// The square of the scale in 32.32, as a mean of all axes.
    fn mean_square(&self) -> u64 {
        let [x, y, z, _] = self.rows();
        let elements = [x, y, z].into_iter().flat_map(|row| row.iter().take(3));
        let squares = elements.map(|v| u64::from(v.to_bits().unsigned_abs()).pow(2));
        squares.map(|square| square / 3).fold(0, u64::saturating_add)
    }

    /// How much larger things become, as a mean of all axes, in units of 2⁻¹⁶.
    pub(super) fn mean_scale(&self) -> u32 {
        saturate_u32(self.mean_square().isqrt())
    }

    /// What each of the upper left 3 × 3 elements is multiplied by in the determinant. They fit 64 bits: the
    /// difference of two products of 32 bits.
    fn cofactors(&self) -> [[i64; 3]; 3] {
        let [[a, b, c, _], [d, e, f, _], [g, h, i, _], _] =
            self.rows().map(|row| row.map(|element| i64::from(element.to_bits())));
        [
            [e * i - f * h, f * g - d * i, d * h - e * g],
            [c * h - b * i, a * i - c * g, b * g - a * h],
            [b * f - c * e, c * d - a * f, a * e - b * d],
        ]
    }

    /// The determinant of the upper left 3 × 3 elements, with 48 fraction bits.
    fn determinant(&self) -> i128 {
        let ([row, ..], [cofactors, ..]) = (self.rows(), self.cofactors());
        row.iter().zip(cofactors).map(|(element, c)| i128::from(element.to_bits()) * i128::from(c)).sum()
    }
}

impl Matrix<World, View> {
    /// Where the eye of this camera is.
    ///
    /// Within 2⁻¹⁴, for cameras of [`look_at`](Self::look_at), and as exact as an [`inverse`](Self::inverse) for any
    /// other. The origin for one that flattens the world.
    #[must_use]
    pub fn eye(&self) -> Point3<World> {
        let origin = Point3::new(NIL, NIL, NIL);
        let eye = self.inverse().map_or(Point4::new(NIL, NIL, NIL, ONE), |back| back.transform_point(origin));
        Point3::new(eye.x, eye.y, eye.z)
    }
}

/// The quotient rounded to the nearest, if it is a `Scalar`.
fn quotient(dividend: i128, divisor: i128) -> Option<Scalar> {
    let (dividend, divisor) = if divisor < 0 { (-dividend, -divisor) } else { (dividend, divisor) };
    let rounded = (dividend + divisor / 2).checked_div_euclid(divisor)?;
    i32::try_from(rounded).ok().map(Scalar::from_bits)
}

/// `sum / square` in 16.16, both with 32 fraction bits.
fn over_square(sum: i64, square: u64) -> Option<Scalar> {
    // Sixteen bits are shifted up for the result. Where the sum has no room, the square has some to spare.
    let up = sum.unsigned_abs().leading_zeros().saturating_sub(2).min(16);
    let square = i64::try_from(square >> (16 - up)).ok().filter(|&square| square > 0)?;
    Some(Scalar::from_bits(saturate_i32(divide_round(sum << up, square))))
}
