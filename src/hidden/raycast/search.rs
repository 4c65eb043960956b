//! One ray among many shapes: what it has hit so far.

use super::{
    Hit, Shape,
    bounds::{Bounds, Probe},
    ray::Ray,
};
use crate::{
    illumination::Unit,
    num::Scalar,
    space::{Point3, Vector3, World},
};

/// What rays are sent at.
///
/// A slice of shapes asks each of them: fine for ten. A [`Hierarchy`](super::Hierarchy) is for more.
pub trait Objects {
    /// What a ray hits first. Where several shapes are hit at the same place, that of the lowest number.
    fn nearest(&self, ray: &Ray) -> Option<Hit>;

    /// Whether a ray hits anything: the question that shadows ask. It ends at the first answer.
    fn is_hit(&self, ray: &Ray) -> bool;
}

impl Objects for [Shape] {
    fn nearest(&self, ray: &Ray) -> Option<Hit> {
        let mut search = Search::new(ray);
        for (number, shape) in self.iter().enumerate() {
            if shape.bounds().is_none_or(|bounds| search.meets(&bounds)) {
                search.offer(number, shape);
            }
        }
        search.hit(self)
    }

    fn is_hit(&self, ray: &Ray) -> bool {
        let search = Search::new(ray);
        let may_be_hit = |shape: &&Shape| shape.bounds().is_none_or(|bounds| search.meets(&bounds));
        self.iter().filter(may_be_hit).any(|shape| search.strikes(shape).is_some())
    }
}

impl<T: Objects + ?Sized> Objects for &T {
    fn nearest(&self, ray: &Ray) -> Option<Hit> {
        T::nearest(self, ray)
    }

    fn is_hit(&self, ray: &Ray) -> bool {
        T::is_hit(self, ray)
    }
}

/// A ray on its way.
pub(super) struct Search<'r> {
    ray: &'r Ray,
    probe: Probe,
    /// The parameter and the number of the nearest.
    found: Option<(u32, usize)>,
    /// How many boxes have been looked at.
    #[cfg(test)]
    pub(super) looks: core::cell::Cell<usize>,
}

impl<'r> Search<'r> {
    pub(super) fn new(ray: &'r Ray) -> Self {
        Self {
            ray,
            probe: Probe::new(ray),
            found: None,
            #[cfg(test)]
            looks: core::cell::Cell::new(0),
        }
    }

    /// Whether something in a box may be hit, and nearer than what has been found.
    #[inline]
    pub(super) fn meets(&self, bounds: &Bounds) -> bool {
        #[cfg(test)]
        self.looks.set(self.looks.get() + 1);
        self.probe.meets(bounds)
    }

    /// Where a shape is hit, if before the end of the ray.
    #[inline]
    pub(super) fn strikes(&self, shape: &Shape) -> Option<u32> {
        shape.hit(self.ray).filter(|&t| t < self.ray.limit)
    }

    /// Takes a shape if it is hit nearer than all before.
    pub(super) fn offer(&mut self, number: usize, shape: &Shape) {
        let Some(t) = self.strikes(shape) else { return };
        if self.found.is_none_or(|nearest| (t, number) < nearest) {
            self.found = Some((t, number));
            self.probe.shorten(self.ray, t);
        }
    }

    /// What has been found.
    pub(super) fn hit(&self, shapes: &[Shape]) -> Option<Hit> {
        let (t, number) = self.found?;
        let place = self.ray.at(t);
        let normal = shapes.get(number)?.normal(place);
        let normal = Unit::of(normal).map_or([0; 3], |unit| unit.direction);
        let is_behind = super::ray::dot(normal, self.ray.direction) > 0;
        let [a, b, c] = normal.map(|v| Scalar::from_bits(if is_behind { -v } else { v } << 2));
        let [x, y, z] = place.map(Scalar::from_bits);
        let (position, normal) = (Point3::<World>::new(x, y, z), Vector3::new(a, b, c));
        Some(Hit { distance: Scalar::from_bits(self.ray.distance(t)), position, normal, number })
    }
}
