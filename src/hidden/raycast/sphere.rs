//! Spheres: half a chord from the foot of the centre.
//!
//! ```text
//!            ╭─────╮
//!          ╱    c    ╲       across = |c × d|: from the centre to the ray
//!    ─────●─────┼─────●──▶   half   = √(r² − across²)
//!        near  foot  far     near   = c·d − half
//! ```

use super::{
    bounds::Bounds,
    ray::{Ray, between, cross, dot, parameter, place},
};
use crate::{
    error::OutOfRange,
    num::Scalar,
    space::{Point3, World},
};

/// By how much lengths are cut before they are squared.
const CUT: u32 = 24;

/// The surface of a ball, from outside and from inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Sphere {
    center: [i32; 3],
    /// 0 to 2²², in 2⁻¹⁶.
    radius: i32,
}

impl Sphere {
    /// From its centre and radius. One without a radius is never hit.
    ///
    /// # Errors
    /// [`OutOfRange`] where a part of it is more than [`REACH`](super::REACH) from zero along an axis, or the radius is
    /// negative.
    pub fn new(center: Point3<World>, radius: Scalar) -> Result<Self, OutOfRange> {
        let center = place(center)?;
        let farthest = center.iter().fold(0, |most: u32, v| most.max(v.unsigned_abs()));
        let outside = farthest.saturating_add(radius.to_bits().unsigned_abs()) > super::REACH.to_bits().unsigned_abs();
        if outside || radius < 0 { Err(OutOfRange) } else { Ok(Self { center, radius: radius.to_bits() }) }
    }

    pub(super) fn bounds(&self) -> Bounds {
        Bounds::of([self.center.map(|v| v - self.radius), self.center.map(|v| v + self.radius)])
    }

    /// One root and one division where it is hit.
    pub(super) fn hit(&self, ray: &Ray) -> Option<u32> {
        let to_center = ray.to(self.center);
        let short = |v: i64| (v + (1 << (CUT - 1))) >> CUT;
        // Lengths times that of the direction: 30 bits are left, their squares are below 2⁶².
        let reach = short(i64::from(self.radius) * ray.length);
        let across: i64 = cross(to_center, ray.direction).map(short).iter().map(|v| v * v).sum();
        let half = (reach * reach - across).checked_isqrt().filter(|&half| half > 0)? << CUT;
        let foot = dot(to_center, ray.direction);
        parameter(foot - half, ray.square).or_else(|| parameter(foot + half, ray.square))
    }

    /// Outwards, of any length.
    pub(super) fn normal(&self, place: [i32; 3]) -> [i32; 3] {
        between(self.center, place)
    }
}
