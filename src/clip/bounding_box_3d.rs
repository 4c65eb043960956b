//! Axis-aligned bounding boxes in space. Lecture 3.4.1.
//!
//! ```text
//!        ┌───────┐ max        of the points of a mesh, once;
//!       ╱   ╱╲  ╱│            turned with it, a box around the turned box:
//!      ┌───────┐ │                ┌─────┐
//!      │  ╱  ╲ │ ┘                │ ╱╲  │
//!  min └───────┘╱                 │╱  ╲╱│
//! ```

use core::{array::from_fn, marker::PhantomData};

use crate::{
    matrix::Matrix,
    num::{Scalar, saturate_i32},
    space::{Model, Point3},
};

use super::{
    frustum::BoundingVolume,
    half_space::{HalfSpace, bits_of, point_at},
};

/// An axis-aligned box in the space `S`. Its border belongs to it, so a box around one point is not empty.
///
/// ```
/// use aquatint::BoundingBox3;
///
/// let one = 16_384;
/// let roof = BoundingBox3::of_places(&[[0, one, 0], [one, 0, one]]).unwrap();
/// let cellar = BoundingBox3::of_places(&[[0, -one, 0], [one, -1, one]]).unwrap();
/// assert!(!roof.collides(&cellar) && roof.union(&cellar).collides(&cellar));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BoundingBox3<S> {
    min: [i32; 3],
    max: [i32; 3],
    space: PhantomData<S>,
}

impl<S> BoundingBox3<S> {
    /// The least box that holds all points; `None` without points.
    pub fn of(points: impl IntoIterator<Item = Point3<S>>) -> Option<Self> {
        Self::around(points.into_iter().map(|point| bits_of(&point)))
    }

    fn around(places: impl IntoIterator<Item = [i32; 3]>) -> Option<Self> {
        let boxes = places.into_iter().map(|place| Self { min: place, max: place, space: PhantomData });
        boxes.reduce(|all, place| all.union(&place))
    }

    /// Least x, y and z.
    #[must_use]
    pub const fn min(&self) -> Point3<S> {
        point_at(self.min)
    }

    /// Greatest x, y and z.
    #[must_use]
    pub const fn max(&self) -> Point3<S> {
        point_at(self.max)
    }

    /// The least box that holds both.
    #[must_use]
    pub fn union(&self, other: &Self) -> Self {
        let [min, max] = [
            from_fn(|axis| self.along(axis).0.min(other.along(axis).0)),
            from_fn(|axis| self.along(axis).1.max(other.along(axis).1)),
        ];
        Self { min, max, space: PhantomData }
    }

    /// Whether a point is inside.
    #[must_use]
    pub fn contains(&self, point: &Point3<S>) -> bool {
        self.gaps_to(bits_of(point)) == [0; 3]
    }

    /// Whether the two have a point in common: if not, neither have their contents.
    #[must_use]
    pub fn collides(&self, other: &Self) -> bool {
        let is_apart = |axis| {
            let ((min, max), (other_min, other_max)) = (self.along(axis), other.along(axis));
            min > other_max || other_min > max
        };
        !(0..3).any(is_apart)
    }

    /// A box around the transformed box: wherever [`transform_point`](Matrix::transform_point) puts a point of this box,
    /// it is inside, and so is where the point ought to be, as far as the numbers reach.
    ///
    /// For placements and cameras: the last row of the matrix plays no part. 18 products. After J. Arvo,
    /// "Transforming axis-aligned bounding boxes", *Graphics Gems*, 1990.
    #[must_use]
    pub fn transformed<To>(&self, matrix: &Matrix<S, To>) -> BoundingBox3<To> {
        let [x, y, z, _] = matrix.rows().map(|row| {
            let [a, b, c, shift] = row.map(Scalar::to_bits);
            let (least, greatest) = self.extent_along([a, b, c]);
            let shift = i64::from(shift) << 16;
            let up = greatest.saturating_add(shift).saturating_add(0xFFFF);
            (saturate_i32(least.saturating_add(shift) >> 16), saturate_i32(up >> 16))
        });
        BoundingBox3 { min: [x.0, y.0, z.0], max: [x.1, y.1, z.1], space: PhantomData }
    }

    /// The least and the greatest product of a direction and a point of the box.
    fn extent_along(&self, direction: [i32; 3]) -> (i64, i64) {
        let products = direction.iter().zip(self.min.iter().zip(&self.max)).map(|(&v, (&min, &max))| {
            let [a, b] = [min, max].map(|end| i64::from(v) * i64::from(end));
            (a.min(b), a.max(b))
        });
        products.fold((0, 0), |sum: (i64, i64), (least, greatest)| {
            (sum.0.saturating_add(least), sum.1.saturating_add(greatest))
        })
    }

    /// Least and greatest along an axis: 0, 1 or 2.
    fn along(&self, axis: usize) -> (i32, i32) {
        let at = |ends: &[i32; 3]| ends.get(axis).copied().unwrap_or(0);
        (at(&self.min), at(&self.max))
    }

    /// How far beside the box a place is, along each axis.
    pub(super) fn gaps_to(&self, place: [i32; 3]) -> [u32; 3] {
        let [(x0, x1), (y0, y1), (z0, z1)] = [self.along(0), self.along(1), self.along(2)];
        let gap = |v: i32, min: i32, max: i32| {
            if v < min {
                v.abs_diff(min)
            } else if v > max {
                v.abs_diff(max)
            } else {
                0
            }
        };
        let [x, y, z] = place;
        [gap(x, x0, x1), gap(y, y0, y1), gap(z, z0, z1)]
    }
}

impl BoundingBox3<Model> {
    /// The least box that holds all positions of a mesh, in 2.14; `None` without positions.
    #[must_use]
    pub fn of_places(places: &[[i16; 3]]) -> Option<Self> {
        Self::around(places.iter().map(|place| place.map(|v| i32::from(v) << 2)))
    }
}

impl<S> BoundingVolume<S> for BoundingBox3<S> {
    fn extent(&self, side: &HalfSpace<S>) -> (i64, i64) {
        let (least, greatest) = self.extent_along(side.normal);
        (least.saturating_add(side.offset), greatest.saturating_add(side.offset))
    }
}
