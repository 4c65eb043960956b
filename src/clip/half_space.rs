//! Planes of arbitrary orientation, in the space of a model, of the world or of the camera. Lecture 3.5.4 and 3.5.5.
//!
//! ```text
//!        ╱ normal            normal · p + offset ≥ 0 is inside, the plane included:
//!   ───●────────────         positive on the side that the normal points to
//!     plane
//! ```
//!
//! - **Takes** a normal of any length, and a point of the plane or an offset.
//! - **Gives** a [`Boundary`] for [lines](super::liang_barsky_3d::clip_to) and
//!   [polygons](super::sutherland_hodgman) of that space; a [`ClipPlane`](super::clip_plane::ClipPlane) for vertices that
//!   have been projected already; a side for [bounding volumes](super::frustum::BoundingVolume).
//! - **Cost** a distance is three products of 32 by 32 bits, exact in 64 bits for every point.
#![expect(clippy::needless_pass_by_value, reason = "points are copied; their space need not be `Copy` to say so")]

use core::marker::PhantomData;

use crate::{
    error::OutOfRange,
    num::{Scalar, saturate_u32},
    space::{Point3, Vector3},
};

use super::window::Boundary;

/// A component of a normal may be as far from zero as this, 8192: then a distance fits 64 bits.
const NORMAL_LIMIT: u32 = 1 << 29;

/// One side of a plane in the space `S`, the plane included.
///
/// ```
/// use aquatint::{HalfSpace, Point3, Scalar, Vector3, World};
///
/// let point = |x: i32, y: i32, z: i32| {
///     let [x, y, z] = [x, y, z].map(Scalar::from_num);
///     Point3::<World>::new(x, y, z)
/// };
/// let slanted = Vector3::new(Scalar::ONE, Scalar::ONE, Scalar::ZERO);
/// let side = HalfSpace::through(point(2, 0, 0), slanted)?;
/// assert!(side.contains(point(1, 1, 9)) && !side.contains(point(1, 0, 9)));
/// # Ok::<(), aquatint::OutOfRange>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HalfSpace<S> {
    pub(super) normal: [i32; 3],
    /// With 32 fraction bits, at most 3·2⁶⁰.
    pub(super) offset: i64,
    /// Of the normal, rounded up.
    length: u32,
    space: PhantomData<S>,
}

impl<S> HalfSpace<S> {
    /// Where `normal · p + offset` is not negative. For a normal of zero, all of space or nothing.
    ///
    /// # Errors
    /// [`OutOfRange`] when a component of the normal is beyond ±8192. Its length plays no part: take a shorter one.
    pub fn new(normal: Vector3<S>, offset: Scalar) -> Result<Self, OutOfRange> {
        Self::with_offset(&normal, i64::from(offset.to_bits()) << 16)
    }

    /// The side of a plane through a point to which a normal points. For a normal of zero, all of space.
    ///
    /// # Errors
    /// [`OutOfRange`] when a component of the normal is beyond ±8192.
    pub fn through(point: Point3<S>, normal: Vector3<S>) -> Result<Self, OutOfRange> {
        let origin = Self::with_offset(&normal, 0)?;
        Self::with_offset(&normal, -origin.distance_of(&point))
    }

    fn with_offset(normal: &Vector3<S>, offset: i64) -> Result<Self, OutOfRange> {
        Self::of_bits([normal.x, normal.y, normal.z].map(Scalar::to_bits), offset)
    }

    /// From a normal with 16 fraction bits and an offset with 32, at most 3·2⁶⁰.
    #[inline(never)]
    pub(super) fn of_bits(normal: [i32; 3], offset: i64) -> Result<Self, OutOfRange> {
        if normal.iter().any(|v| v.unsigned_abs() > NORMAL_LIMIT) {
            return Err(OutOfRange);
        }
        let square = normal.iter().map(|v| u64::from(v.unsigned_abs()).pow(2)).sum();
        Ok(Self { normal, offset, length: saturate_u32(root_up(square)), space: PhantomData })
    }

    /// The other side, the plane included.
    #[must_use]
    pub fn opposite(self) -> Self {
        Self { normal: self.normal.map(|v| -v), offset: -self.offset, ..self }
    }

    /// Whether a point is inside. Exact.
    #[must_use]
    pub fn contains(&self, point: Point3<S>) -> bool {
        self.distance_of(&point) >= 0
    }

    /// How far inside a point is, times the length of the normal, with 32 fraction bits; below 2⁶³.
    pub(super) fn distance_of(&self, point: &Point3<S>) -> i64 {
        let products = self.normal.iter().zip(bits_of(point)).map(|(&normal, v)| i64::from(normal) * i64::from(v));
        products.sum::<i64>() + self.offset
    }

    /// The length of the normal, rounded up, with 16 fraction bits; at most 2³⁰.
    pub(super) const fn length(&self) -> u32 {
        self.length
    }
}

impl<S> Boundary<Point3<S>> for HalfSpace<S> {
    fn distance(&self, vertex: &Point3<S>) -> i64 {
        self.distance_of(vertex)
    }
}

/// The coordinates of a point, in units of 2⁻¹⁶.
pub(super) fn bits_of<S>(point: &Point3<S>) -> [i32; 3] {
    [point.x, point.y, point.z].map(Scalar::to_bits)
}

/// The point with such coordinates.
pub(super) const fn point_at<S>([x, y, z]: [i32; 3]) -> Point3<S> {
    Point3::new(Scalar::from_bits(x), Scalar::from_bits(y), Scalar::from_bits(z))
}

/// The square root, rounded up.
pub(super) const fn root_up(square: u64) -> u64 {
    let root = square.isqrt();
    if root * root < square { root + 1 } else { root }
}
