//! The view frustum in the space of a model or of the world: whole meshes are rejected or accepted. Lecture 3.4.1.
//!
//! ```text
//!   ╲  ┌─┐            ╱      Inside    draw it, no vertex needs an outcode
//!    ╲ └─┘   ┌──┐    ╱       Crossing  draw it, and clip
//!     ╲      │  │   ╱
//!      ╲     └──┘  ╱ ┌──┐    Outside   no vertex is looked at
//!       ╲─────────╱──┼─ │
//!                    └──┘    Crossing
//! ```
//!
//! The planes of the view are read off the matrix that leads to clip space: where `w + x ≥ 0` there, the sum of its last
//! row and its first is the normal and the offset here. (G. Gribb and K. Hartmann, "Fast extraction of viewing frustum
//! planes from the world-view-projection matrix", 2001.) So one matrix a mesh decides in the mesh's own space, and no
//! bounds have to be transformed.
//!
//! `Outside` is never wrong. A volume that lies beyond an edge of the frustum, but beyond no plane of it, is `Crossing`.

use crate::{
    error::OutOfRange,
    matrix::Matrix,
    num::Scalar,
    space::{CLIP_LIMIT, Clip, LEAST_W},
};

use super::{bounds::Verdict, half_space::HalfSpace};

/// Something that holds a shape, and tells how far it reaches.
pub trait BoundingVolume<S> {
    /// The least and the greatest distance of its points inside of a half-space, in that one's unit; negative outside.
    ///
    /// The least may be less and the greatest may be greater than that, never the other way round.
    fn extent(&self, side: &HalfSpace<S>) -> (i64, i64);

    /// Where it lies: `Inside` and `Outside` are certain.
    ///
    /// ```
    /// use aquatint::{BoundingSphere, HalfSpace, Point3, Scalar, Vector3, World};
    /// use aquatint::clip::{bounds::Verdict, frustum::BoundingVolume};
    ///
    /// let at = |y: i32| Point3::<World>::new(Scalar::ZERO, Scalar::from_num(y), Scalar::ZERO);
    /// let up = Vector3::new(Scalar::ZERO, Scalar::ONE, Scalar::ZERO);
    /// let above_ground = HalfSpace::through(at(0), up)?;
    /// let ball = |y| BoundingSphere::new(at(y), 65_536).against_half_space(&above_ground);
    /// assert_eq!([ball(2), ball(0), ball(-2)], [Verdict::Inside, Verdict::Crossing, Verdict::Outside]);
    /// # Ok::<(), aquatint::OutOfRange>(())
    /// ```
    fn against_half_space(&self, side: &HalfSpace<S>) -> Verdict {
        let (least, greatest) = self.extent(side);
        verdict(greatest < 0, least >= 0)
    }

    /// Where it lies in what is seen. The vertices of what is `Inside` need not be clipped, those of what is `Outside`
    /// not even be transformed: both are true after their rounding, too.
    fn against(&self, frustum: &Frustum<S>) -> Verdict {
        let mut is_inside = true;
        for side in &frustum.sides {
            let (least, greatest) = self.extent(side);
            if greatest < -ROUNDING {
                return Verdict::Outside;
            }
            is_inside &= least >= ROUNDING;
        }
        verdict(false, is_inside)
    }
}

/// What rounding two coordinates of a vertex in clip space, by 2⁻¹⁷ each, does to their sum; with 32 fraction bits.
const ROUNDING: i64 = 1 << 16;

const fn verdict(is_outside: bool, is_inside: bool) -> Verdict {
    if is_outside {
        Verdict::Outside
    } else if is_inside {
        Verdict::Inside
    } else {
        Verdict::Crossing
    }
}

/// What a camera sees, in the space `S`: six half-spaces, and w ≥ ⅛.
///
/// ```
/// use aquatint::{BoundingBox3, Clip, Frustum, Matrix, Model, Scalar};
/// use aquatint::clip::{bounds::Verdict, frustum::BoundingVolume};
///
/// let bounds = BoundingBox3::of_places(&[[-8192, -8192, -8192], [8192, 8192, 8192]]).unwrap();
/// let moved = |x: f64| Matrix::<Model, Clip>::translation(Scalar::from_num(x), Scalar::ZERO, Scalar::ZERO);
/// let verdict = |x| Frustum::new(&moved(x)).map(|frustum| bounds.against(&frustum));
/// assert_eq!(verdict(0.25), Ok(Verdict::Inside));
/// assert_eq!(verdict(0.75), Ok(Verdict::Crossing));
/// assert_eq!(verdict(1.75), Ok(Verdict::Outside));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Frustum<S> {
    sides: [HalfSpace<S>; 7],
}

impl<S> Frustum<S> {
    /// What is seen of the space from which a matrix leads to clip space. Seven square roots, for spheres.
    ///
    /// Take the very matrix that transforms the vertices: for a mesh, from its model.
    ///
    /// # Errors
    /// [`OutOfRange`] when an element of the matrix is beyond ±[`CLIP_LIMIT`].
    pub fn new(to_clip: &Matrix<S, Clip>) -> Result<Self, OutOfRange> {
        let limit = CLIP_LIMIT.to_bits();
        let [x, y, z, w] = to_clip.rows().map(|row| row.map(Scalar::to_bits));
        if [x, y, z, w].iter().flatten().any(|v| !(-limit..=limit).contains(v)) {
            return Err(OutOfRange);
        }
        let side = |sign: i32, [a, b, c, shift]: [i32; 4]| {
            let [p, q, r, from] = w;
            let normal = [p + sign * a, q + sign * b, r + sign * c];
            HalfSpace::of_bits(normal, i64::from(from + sign * shift) << 16)
        };
        let eye = HalfSpace::of_bits([w[0], w[1], w[2]], i64::from(w[3] - LEAST_W.to_bits()) << 16)?;
        let [near, far] = [side(1, z)?, side(-1, z)?];
        Ok(Self { sides: [eye, near, far, side(1, x)?, side(-1, x)?, side(1, y)?, side(-1, y)?] })
    }

    /// Its half-spaces, in the order of [`Plane::ALL`](super::volume::Plane::ALL): boundaries for
    /// [lines](super::liang_barsky_3d::clip_to) and polygons.
    #[must_use]
    pub const fn sides(&self) -> &[HalfSpace<S>; 7] {
        &self.sides
    }
}
