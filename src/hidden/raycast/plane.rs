//! Planes: as far as the world reaches.

use super::ray::{Ray, dot, parameter, place};
use crate::{
    error::OutOfRange,
    num::Scalar,
    space::{Point3, Vector3, World},
};

/// A plane, from both sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Plane {
    point: [i32; 3],
    /// Of any length, in 30 bits.
    normal: [i32; 3],
}

impl Plane {
    /// Through a point, at right angles to a normal of any length but zero. Without a normal it is never hit.
    ///
    /// # Errors
    /// [`OutOfRange`] for a point more than [`REACH`](super::REACH) from zero along an axis.
    pub fn new(point: Point3<World>, normal: Vector3<World>) -> Result<Self, OutOfRange> {
        let normal = [normal.x, normal.y, normal.z].map(Scalar::to_bits);
        let is_long = normal.iter().any(|v| v.unsigned_abs() > 1 << 30);
        Ok(Self { point: place(point)?, normal: if is_long { normal.map(|v| v >> 1) } else { normal } })
    }

    /// One division where it is ahead.
    pub(super) fn hit(&self, ray: &Ray) -> Option<u32> {
        let t = parameter(dot(self.normal, ray.to(self.point)), dot(self.normal, ray.direction))?;
        // Where the ray has left the world, it has been brought back to its border.
        let reach = super::REACH.to_bits();
        ray.at(t).iter().all(|v| v.abs() < reach).then_some(t)
    }

    pub(super) const fn normal(&self) -> [i32; 3] {
        self.normal
    }
}
