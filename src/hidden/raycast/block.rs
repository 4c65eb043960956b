//! Boxes along the axes: the ray is inside from where it has entered the last pair of sides to where it leaves the first.

use super::{
    bounds::Bounds,
    ray::{Ray, pairs, parameter, place},
};
use crate::{
    error::OutOfRange,
    space::{Point3, World},
};

/// The surface of a box whose sides are parallel to the axes, from outside and from inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Block {
    min: [i32; 3],
    max: [i32; 3],
}

/// Along one axis: steps of the ray, and the ways to the sides in its direction. The sign of the axis is taken off.
#[derive(Clone, Copy)]
struct Slab {
    step: i64,
    near: i64,
    far: i64,
}

impl Block {
    /// From two opposite corners, whichever they are. It may be flat.
    ///
    /// # Errors
    /// [`OutOfRange`] for a corner more than [`REACH`](super::REACH) from zero along an axis.
    pub fn new(corner: Point3<World>, opposite: Point3<World>) -> Result<Self, OutOfRange> {
        let ends = pairs(place(corner)?, place(opposite)?);
        Ok(Self { min: ends.map(|(a, b)| a.min(b)), max: ends.map(|(a, b)| a.max(b)) })
    }

    pub(super) fn bounds(&self) -> Bounds {
        Bounds::of([self.min, self.max])
    }

    /// Exact products of 53 bits, and one division where it is hit.
    pub(super) fn hit(&self, ray: &Ray) -> Option<u32> {
        let slabs = self.slabs(ray);
        let [x, y, z] = slabs;
        // Quotients are compared by products: steps are not negative. Along an axis without steps there are none.
        let first = |a: Slab, b: Slab, is_first: bool| if b.step > 0 && (a.step == 0 || is_first) { b } else { a };
        let later = |a: Slab, b: Slab| first(a, b, b.near * a.step > a.near * b.step);
        let sooner = |a: Slab, b: Slab| first(a, b, b.far * a.step < a.far * b.step);
        let (entry, exit) = (later(later(x, y), z), sooner(sooner(x, y), z));
        let enters = |slab: &Slab| entry.near * slab.step <= slab.far * entry.step;
        if !slabs.iter().all(|slab| enters(slab) && (slab.step > 0 || (slab.near <= 0 && slab.far >= 0))) {
            return None;
        }
        parameter(entry.near, entry.step).or_else(|| parameter(exit.far, exit.step))
    }

    fn slabs(&self, ray: &Ray) -> [Slab; 3] {
        let ways = pairs(pairs(ray.to(self.min), ray.to(self.max)), ray.direction);
        ways.map(|((min, max), step)| {
            let (near, far) = if step < 0 { (-max, -min) } else { (min, max) };
            Slab { step: i64::from(step).abs(), near: near.into(), far: far.into() }
        })
    }

    /// That of the side that a place of the surface is nearest to.
    pub(super) fn normal(&self, place: [i32; 3]) -> [i32; 3] {
        let ends = pairs(self.min, self.max);
        match pairs(ends, place).map(|((min, max), v)| (v - min).abs().min((max - v).abs())) {
            [x, y, z] if x <= y && x <= z => [1, 0, 0],
            [_, y, z] if y <= z => [0, 1, 0],
            _ => [0, 0, 1],
        }
    }
}
