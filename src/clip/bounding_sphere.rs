//! Bounding spheres: they turn with their contents, and collide at the price of a few products. Lecture 3.4.1.
//!
//! ```text
//!     ╭───╮   ╭───╮       centres farther apart than
//!    │  ●──┼─┼──●  │      both radii together: no collision
//!     ╰───╯   ╰───╯
//! ```

use core::{array::from_fn, marker::PhantomData};

use crate::{
    matrix::Matrix,
    num::{Scalar, saturate_u32},
    space::Point3,
};

use super::{
    bounding_box_3d::BoundingBox3,
    crossing::Crossing,
    frustum::BoundingVolume,
    half_space::{HalfSpace, bits_of, point_at, root_up},
};

/// A sphere in the space `S`, its inside and its surface.
///
/// Its radius counts in the unit of its points, 2⁻¹⁶: 65,536 is 1.0.
///
/// ```
/// use aquatint::{BoundingSphere, Point3, Scalar, World};
///
/// let at = |x: i32| Point3::<World>::new(Scalar::from_num(x), Scalar::ZERO, Scalar::ZERO);
/// let (ball, wall) = (BoundingSphere::new(at(0), 65_536), BoundingSphere::new(at(3), 2 * 65_536));
/// assert!(ball.collides(&wall), "they touch");
/// assert_eq!(ball.union(&wall), BoundingSphere::new(at(2), 3 * 65_536));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BoundingSphere<S> {
    center: [i32; 3],
    radius: u32,
    space: PhantomData<S>,
}

impl<S> BoundingSphere<S> {
    /// A sphere that holds every point that there is.
    pub const EVERYTHING: Self = Self { center: [0; 3], radius: 3_719_550_787, space: PhantomData };

    /// A sphere from its centre and radius.
    #[must_use]
    #[expect(clippy::needless_pass_by_value, reason = "points are copied; their space need not be `Copy` to say so")]
    pub fn new(center: Point3<S>, radius: u32) -> Self {
        Self { center: bits_of(&center), radius, space: PhantomData }
    }

    /// A sphere around the middle of the points' box that holds all of them; `None` without points.
    ///
    /// Its radius is at most √3 times, and a unit more, than that of the least sphere. One square root.
    pub fn of(points: impl IntoIterator<Item = Point3<S>, IntoIter: Clone>) -> Option<Self> {
        let points = points.into_iter();
        let bounds = BoundingBox3::of(points.clone())?;
        let [min, max] = [bounds.min(), bounds.max()].map(|end| bits_of(&end));
        let half = Crossing::of(1, 2);
        let [a, b, c] = min;
        let [d, e, f] = max;
        let center = [half.coordinate(a, d), half.coordinate(b, e), half.coordinate(c, f)];
        // From the middle no coordinate is farther than 2³¹, so the sum is below 2⁶⁴.
        let square =
            |point: Point3<S>| gaps(center, bits_of(&point)).iter().map(|&gap| u64::from(gap).pow(2)).sum::<u64>();
        let farthest = points.map(square).max()?;
        Some(Self { center, radius: saturate_u32(root_up(farthest)), space: PhantomData })
    }

    /// The centre.
    #[must_use]
    pub const fn center(&self) -> Point3<S> {
        point_at(self.center)
    }

    /// The radius, in units of 2⁻¹⁶.
    #[must_use]
    pub const fn radius(&self) -> u32 {
        self.radius
    }

    /// Whether a point is inside. Exact.
    #[must_use]
    pub fn contains(&self, point: &Point3<S>) -> bool {
        is_within(gaps(self.center, bits_of(point)), self.radius.into())
    }

    /// Whether the two have a point in common: if not, neither have their contents. Exact, no root.
    #[must_use]
    pub fn collides(&self, other: &Self) -> bool {
        is_within(gaps(self.center, other.center), u64::from(self.radius) + u64::from(other.radius))
    }

    /// Whether it has a point in common with a box. Exact, no root.
    #[must_use]
    pub fn collides_with_box(&self, other: &BoundingBox3<S>) -> bool {
        is_within(other.gaps_to(self.center), self.radius.into())
    }

    /// A sphere that holds both, a few units larger than the least one at most.
    ///
    /// Up to three square roots. Where there is no such sphere within the range of a radius: [`EVERYTHING`](Self::EVERYTHING).
    #[must_use]
    pub fn union(&self, other: &Self) -> Self {
        let order = |sphere: &Self| (sphere.radius, sphere.center);
        let (small, large) = if order(self) < order(other) { (self, other) } else { (other, self) };
        if is_within(gaps(small.center, large.center), u64::from(large.radius - small.radius)) {
            return Self::if_in_range(large.center, large.radius.into());
        }
        let apart = length_up(gaps(small.center, large.center));
        // From the larger one's centre towards the smaller one's, by half of what is missing there.
        let way = Crossing::of((apart + u64::from(small.radius)).saturating_sub(large.radius.into()) / 2, apart);
        let at = |ends: &[i32; 3], axis: usize| ends.get(axis).copied().unwrap_or(0);
        let center = from_fn(|axis| way.coordinate(at(&large.center, axis), at(&small.center, axis)));
        let reach = |sphere: &Self| length_up(gaps(center, sphere.center)) + u64::from(sphere.radius);
        Self::if_in_range(center, reach(small).max(reach(large)))
    }

    /// A sphere around the transformed sphere: wherever [`transform_point`](Matrix::transform_point) puts a point of this
    /// sphere, it is inside, as far as the numbers reach.
    ///
    /// For placements and cameras: the last row of the matrix plays no part. For a rotation and a scale that is the
    /// same along all axes the radius grows by that scale and a unit or two; for others by somewhat more than the largest
    /// scale. 18 products, one square root.
    #[must_use]
    pub fn transformed<To>(&self, matrix: &Matrix<S, To>) -> BoundingSphere<To> {
        let center = matrix.transform_point(self.center());
        let center = [center.x, center.y, center.z].map(Scalar::to_bits);
        let Some(scale) = largest_scale(matrix.rows()) else { return BoundingSphere::EVERYTHING };
        // A coordinate of the centre and one of a point are rounded, by half a unit each.
        let radius = ((u64::from(self.radius) * scale) >> 16) + 3;
        BoundingSphere::if_in_range(center, radius)
    }

    fn if_in_range(center: [i32; 3], radius: u64) -> Self {
        u32::try_from(radius).map_or(Self::EVERYTHING, |radius| Self { center, radius, space: PhantomData })
    }
}

impl<S> BoundingVolume<S> for BoundingSphere<S> {
    fn extent(&self, side: &HalfSpace<S>) -> (i64, i64) {
        let middle = side.distance_of(&self.center());
        // Below 2⁶².
        let reach = i64::from(self.radius) * i64::from(side.length());
        (middle.saturating_sub(reach), middle.saturating_add(reach))
    }
}

/// How far apart two places are, along each axis.
fn gaps([a, b, c]: [i32; 3], [x, y, z]: [i32; 3]) -> [u32; 3] {
    [a.abs_diff(x), b.abs_diff(y), c.abs_diff(z)]
}

/// Whether `x² + y² + z² ≤ reach²`, for a reach below 2³³.
fn is_within(gaps: [u32; 3], reach: u64) -> bool {
    if gaps.iter().all(|&gap| gap < 1 << 31) && reach < 1 << 32 {
        return gaps.iter().map(|&gap| u64::from(gap).pow(2)).sum::<u64>() <= reach.pow(2);
    }
    gaps.iter().map(|&gap| u128::from(gap).pow(2)).sum::<u128>() <= u128::from(reach).pow(2)
}

/// √(x² + y² + z²), rounded up; beyond 2³¹ to the next multiple of four or the one after it.
fn length_up(gaps: [u32; 3]) -> u64 {
    let is_far = gaps.iter().any(|&gap| gap >= 1 << 31);
    let shift = if is_far { 2 } else { 0 };
    let square = gaps.iter().map(|&gap| u64::from(gap).div_ceil(1 << shift).pow(2)).sum();
    root_up(square) << shift
}

/// By how much a matrix makes a vector longer at most, with 16 fraction bits, rounded up and at most 2³².
///
/// The square of that is no more than the largest sum of a row of `MᵀM`, and just that where it only turns and scales.
fn largest_scale(&[a, b, c, _]: &[[Scalar; 4]; 4]) -> Option<u64> {
    let column = |x: Scalar, y: Scalar, z: Scalar| [x, y, z].map(|v| i64::from(v.to_bits()));
    let columns = [column(a[0], b[0], c[0]), column(a[1], b[1], c[1]), column(a[2], b[2], c[2])];
    let dot = |one: [i64; 3], other: [i64; 3]| {
        let mut products = one.into_iter().zip(other).map(|(a, b)| a * b);
        products.try_fold(0_i64, i64::checked_add)
    };
    let row_sum = |row: [i64; 3]| {
        let sizes = columns.map(|column| dot(row, column).map(i64::unsigned_abs));
        sizes.into_iter().try_fold(0_u64, |sum, size| sum.checked_add(size?))
    };
    let [x, y, z] = columns.map(row_sum);
    Some(root_up(x?.max(y?).max(z?)))
}
