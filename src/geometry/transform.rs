//! Vertex transforms: turning, moving, scaling, looking. Lecture 2.2.2.

use crate::{
    angle::{Angle, sine_and_cosine},
    error::OutOfRange,
    matrix::Matrix,
    num::{Scalar, divide_round, low_i32, saturate_i32},
    space::{CLIP_LIMIT, Clip, Model, Point3, Point4, Vector3, View, World},
};

const ONE: Scalar = Scalar::ONE;
const NIL: Scalar = Scalar::ZERO;

impl<From, To> Matrix<From, To> {
    /// Turns about the x axis: from y towards z.
    #[must_use]
    pub fn rotation_x(angle: Angle) -> Self {
        let (s, c) = (angle.sin(), angle.cos());
        Self::from_rows([[ONE, NIL, NIL, NIL], [NIL, c, -s, NIL], [NIL, s, c, NIL], [NIL, NIL, NIL, ONE]])
    }

    /// Turns about the y axis: from z towards x.
    #[must_use]
    pub fn rotation_y(angle: Angle) -> Self {
        let (s, c) = (angle.sin(), angle.cos());
        Self::from_rows([[c, NIL, s, NIL], [NIL, ONE, NIL, NIL], [-s, NIL, c, NIL], [NIL, NIL, NIL, ONE]])
    }

    /// Turns about the z axis: from x towards y.
    #[must_use]
    pub fn rotation_z(angle: Angle) -> Self {
        let (s, c) = (angle.sin(), angle.cos());
        Self::from_rows([[c, -s, NIL, NIL], [s, c, NIL, NIL], [NIL, NIL, ONE, NIL], [NIL, NIL, NIL, ONE]])
    }

    /// Moves.
    #[must_use]
    pub const fn translation(x: Scalar, y: Scalar, z: Scalar) -> Self {
        Self::from_rows([[ONE, NIL, NIL, x], [NIL, ONE, NIL, y], [NIL, NIL, ONE, z], [NIL, NIL, NIL, ONE]])
    }

    /// Turns about an axis of any length but zero, counter-clockwise for whom the axis points at.
    ///
    /// Each element is within 2⁻¹⁴ of the exact one. `None` for the zero vector.
    ///
    /// ```
    /// use aquatint::{Angle, Matrix, Model, Scalar, Vector3, World};
    ///
    /// let up = Vector3::new(Scalar::ZERO, Scalar::from_num(7), Scalar::ZERO);
    /// let turned = Matrix::<Model, World>::rotation_about(up, Angle::QUARTER).unwrap();
    /// assert_eq!(turned, Matrix::rotation_y(Angle::QUARTER));
    /// ```
    #[must_use]
    pub fn rotation_about(axis: Vector3<From>, angle: Angle) -> Option<Self> {
        let axis = axis.normalized()?;
        let [x, y, z] = [axis.x, axis.y, axis.z].map(|v| i64::from(v.to_bits()));
        let (sin, cos) = sine_and_cosine(u32::from(angle.0) << 16);
        let (sin, cos, rest) = (sin >> 7, cos >> 7, ((1 << 31) - cos) >> 7); // 24 fraction bits
        // Rodrigues: cos on the diagonal, and of the products of axes what cos leaves, and of the axes the sine.
        let element = |product: i64, across: i64, diagonal: i64| {
            let sum = rest * product + ((sin * across + (diagonal << 16)) << 16);
            Scalar::from_bits(low_i32((sum + (1 << 39)) >> 40))
        };
        Some(Self::from_rows([
            [element(x * x, 0, cos), element(x * y, -z, 0), element(x * z, y, 0), NIL],
            [element(y * x, z, 0), element(y * y, 0, cos), element(y * z, -x, 0), NIL],
            [element(z * x, -y, 0), element(z * y, x, 0), element(z * z, 0, cos), NIL],
            [NIL, NIL, NIL, ONE],
        ]))
    }

    /// Scales all three axes alike.
    #[must_use]
    pub const fn scale(by: Scalar) -> Self {
        Self::scale_by(by, by, by)
    }

    /// Scales each axis by its own factor. Normals then turn by [`normals`](Self::normals).
    #[must_use]
    pub const fn scale_by(x: Scalar, y: Scalar, z: Scalar) -> Self {
        Self::from_rows([[x, NIL, NIL, NIL], [NIL, y, NIL, NIL], [NIL, NIL, z, NIL], [NIL, NIL, NIL, ONE]])
    }
}

impl Matrix<World, View> {
    /// The camera at `eye` that looks at `centre`, with `up` upwards on the screen.
    ///
    /// `None` when the eye is at the centre, or looks along `up`. The distance between the two
    /// points must fit the 16.16 format, else the direction saturates.
    #[must_use]
    pub fn look_at(eye: Point3<World>, centre: Point3<World>, up: Vector3<World>) -> Option<Self> {
        let difference = |a: Scalar, b: Scalar| a.saturating_sub(b);
        let back = Vector3::<World>::new(
            difference(eye.x, centre.x),
            difference(eye.y, centre.y),
            difference(eye.z, centre.z),
        );
        let back = back.normalized()?;
        let right = cross(&up.normalized()?, &back).normalized()?;
        let up = cross(&back, &right);
        let turn = |axis: Vector3<World>| [axis.x, axis.y, axis.z, NIL];
        let turned = Matrix::<World, View>::from_rows([turn(right), turn(up), turn(back), [NIL, NIL, NIL, ONE]]);
        let moved = Matrix::<World, World>::translation(negated(eye.x), negated(eye.y), negated(eye.z));
        Some(moved.then(&turned))
    }
}

fn negated(value: Scalar) -> Scalar {
    value.saturating_neg()
}

/// Cross product of two vectors of length 1 at most.
pub(super) fn cross<S>(a: &Vector3<S>, b: &Vector3<S>) -> Vector3<S> {
    let part = |p: Scalar, q: Scalar, r: Scalar, s: Scalar| {
        let [p, q, r, s] = [p, q, r, s].map(|v| i64::from(v.to_bits()));
        Scalar::from_bits(saturate_i32(divide_round(p * q - r * s, 1 << 16)))
    };
    Vector3::new(part(a.y, b.z, a.z, b.y), part(a.z, b.x, a.x, b.z), part(a.x, b.y, a.y, b.x))
}

/// From quantised mesh places straight to clip space: the transform of the inner loop.
///
/// A 64-bit product costs a core like the Cortex-M0 some thirty instructions, a 32-bit one costs it one. So
/// each element is kept in two parts, `high · 2¹⁴ + low`, whose products with 16-bit places fit 32 bits:
///
/// ```text
///   element · place / 2¹⁴  =  high · place  +  low · place / 2¹⁴
///            exact             exact           the one rounding
/// ```
#[derive(Clone, Copy, Debug)]
pub struct MeshTransform {
    rows: [Row; 4],
}

/// A row of the matrix, split.
#[derive(Clone, Copy, Debug)]
struct Row {
    /// Elements over 2¹⁴, rounded down: less than 2¹³ + 3 all together.
    high: [i32; 3],
    /// What that left over: 0 to 2¹⁴ − 1 each.
    low: [i32; 3],
    /// The last element.
    shift: i32,
}

impl Row {
    fn new([x, y, z, w]: [Scalar; 4]) -> Self {
        let elements = [x, y, z].map(Scalar::to_bits);
        Self { high: elements.map(|v| v >> 14), low: elements.map(|v| v & 0x3FFF), shift: w.to_bits() }
    }

    /// Six 32-bit products. The sums are less than 2²⁸ and 3 · 2²⁹, by the test in [`MeshTransform::new`].
    #[inline]
    fn apply(&self, [x, y, z]: [i32; 3]) -> Scalar {
        let sum = |[a, b, c]: [i32; 3]| a * x + b * y + c * z;
        // Places have 14 fraction bits.
        Scalar::from_bits(sum(self.high) + ((sum(self.low) + (1 << 13)) >> 14) + self.shift)
    }
}

impl MeshTransform {
    /// Checks once that no mesh place, whatever its 16-bit coordinates, can leave the range.
    ///
    /// # Errors
    /// [`OutOfRange`]: some vertex might, beyond ±4096. Move the object nearer or scale it down.
    pub fn new(matrix: &Matrix<Model, Clip>) -> Result<Self, OutOfRange> {
        for row in matrix.rows() {
            let [x, y, z, w] = row.map(|v| i64::from(v.to_bits().unsigned_abs()));
            // Mesh coordinates reach to ±2.
            if 2 * (x + y + z) + w >= i64::from(CLIP_LIMIT.to_bits()) {
                return Err(OutOfRange);
            }
        }
        Ok(Self { rows: matrix.rows().map(Row::new) })
    }

    /// Where a mesh place lands: the exact sum, rounded once a coordinate. 24 products of 32 bits.
    #[inline]
    #[must_use]
    pub fn apply(&self, place: [i16; 3]) -> Point4<Clip> {
        let place = place.map(i32::from);
        let [x, y, z, w] = self.rows.each_ref().map(|row| row.apply(place));
        Point4::new(x, y, z, w)
    }

    /// Only the `w` of where a mesh place lands: with perspective, how far in front of the eye it is.
    #[inline]
    #[must_use]
    pub fn apply_w(&self, place: [i16; 3]) -> Scalar {
        let [.., last] = &self.rows;
        last.apply(place.map(i32::from))
    }
}
