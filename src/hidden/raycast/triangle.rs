//! Triangles: seen from the origin along the ray, which becomes a point of the plane in which the corners lie.
//!
//! ```text
//!            a
//!          ╱  ╲          three edge functions at the ray ·,
//!        ╱  ·   ╲        the products of two sheared corners,
//!      b──────────c      have the same sign
//! ```
//!
//! Source: S. Woop, C. Benthin, I. Wald, "Watertight ray/triangle intersection", JCGT 2 (1), 2013. The corners are
//! sheared once each and rounded; all that follows is exact. Triangles that share two corners have the same edge
//! function between them but for its sign, and a ray on the edge itself hits both: no ray passes between them.

use super::{
    bounds::Bounds,
    ray::{Ray, between, cross, pairs, parameter, place, shortened},
};
use crate::{
    error::OutOfRange,
    space::{Point3, World},
};

/// By how much sheared corners are cut: 30 bits are left, in 2⁻²¹ at least.
const CUT: u32 = 24;

/// A triangle, from both sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Triangle {
    corners: [[i32; 3]; 3],
}

impl Triangle {
    /// Without area.
    pub(super) const POINT: Self = Self { corners: [[0; 3]; 3] };

    /// From its corners. One without area is never hit.
    ///
    /// # Errors
    /// [`OutOfRange`] for a corner more than [`REACH`](super::REACH) from zero along an axis.
    pub fn new([a, b, c]: [Point3<World>; 3]) -> Result<Self, OutOfRange> {
        Ok(Self { corners: [place(a)?, place(b)?, place(c)?] })
    }

    pub(super) fn bounds(&self) -> Bounds {
        Bounds::of(self.corners)
    }

    /// 12 long products, 18 and a division where the ray passes inside.
    pub(super) fn hit(&self, ray: &Ray) -> Option<u32> {
        let [.., step] = ray.axis.last(ray.direction);
        let corners = self.corners.map(|corner| ray.axis.last(ray.to(corner)));
        let [a, b, c] = corners.map(|corner| sheared(ray, corner));
        let edge = |(a, b): (i64, i64), (c, d): (i64, i64)| a * d - b * c;
        if is_beside(a.0, b.0, c.0) || is_beside(a.1, b.1, c.1) {
            return None;
        }
        // Of the opposite sides, below 2⁶¹.
        let weights = [edge(b, c), edge(c, a), edge(a, b)];
        if weights.iter().any(|&w| w < 0) && weights.iter().any(|&w| w > 0) {
            return None;
        }
        // 30 bits each: the mean of the corners' depths, so that no rounding takes it out of the triangle.
        let weights = shortened(weights).map(|w| i64::from(w).abs());
        let depth = pairs(weights, corners).iter().map(|&(w, [.., z])| w * i64::from(z)).sum();
        parameter(depth, weights.iter().sum::<i64>() * i64::from(step))
    }

    /// At right angles, of any length.
    pub(super) fn normal(&self) -> [i32; 3] {
        let [a, b, c] = self.corners;
        shortened(cross(between(a, b), between(a, c)))
    }
}

/// Where a corner is when the ray is looked along, its axis last: 30 bits.
#[inline]
fn sheared(ray: &Ray, [x, y, z]: [i32; 3]) -> (i64, i64) {
    let [a, b, c] = ray.axis.last(ray.direction).map(i64::from);
    let part = |v: i32, across: i64| (i64::from(v) * c - i64::from(z) * across + (1 << (CUT - 1))) >> CUT;
    (part(x, a), part(y, b))
}

/// Whether three corners lie on one side of the ray.
#[inline]
const fn is_beside(a: i64, b: i64, c: i64) -> bool {
    (a < 0 && b < 0 && c < 0) || (a > 0 && b > 0 && c > 0)
}
