//! Vertex transforms: turning, moving, scaling, looking. Lecture 2.2.2.

use crate::{
    angle::Angle,
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

    /// Scales all three axes alike.
    #[must_use]
    pub const fn scale(by: Scalar) -> Self {
        Self::from_rows([[by, NIL, NIL, NIL], [NIL, by, NIL, NIL], [NIL, NIL, by, NIL], [NIL, NIL, NIL, ONE]])
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
        let right = cross(up.normalized()?, back).normalized()?;
        let up = cross(back, right);
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
fn cross(a: Vector3<World>, b: Vector3<World>) -> Vector3<World> {
    let part = |p: Scalar, q: Scalar, r: Scalar, s: Scalar| {
        let [p, q, r, s] = [p, q, r, s].map(|v| i64::from(v.to_bits()));
        Scalar::from_bits(saturate_i32(divide_round(p * q - r * s, 1 << 16)))
    };
    Vector3::new(part(a.y, b.z, a.z, b.y), part(a.z, b.x, a.x, b.z), part(a.x, b.y, a.y, b.x))
}

/// From quantised mesh places straight to clip space: the transform of the inner loop.
#[derive(Clone, Copy, Debug)]
pub struct MeshTransform {
    rows: [[Scalar; 4]; 4],
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
        Ok(Self { rows: *matrix.rows() })
    }

    /// Where a mesh place lands. Products of 16 by 32 bits, one rounding a coordinate.
    #[must_use]
    pub fn apply(&self, place: [i16; 3]) -> Point4<Clip> {
        let [x, y, z] = place.map(i64::from);
        let [x, y, z, w] = self.rows.map(|[a, b, c, d]| {
            let [a, b, c, d] = [a, b, c, d].map(|v| i64::from(v.to_bits()));
            // Places have 14 fraction bits.
            Scalar::from_bits(low_i32((a * x + b * y + c * z + (d << 14) + (1 << 13)) >> 14))
        });
        Point4::new(x, y, z, w)
    }
}
