//! Rays: an origin, a direction, and how far along it they go.

use core::num::NonZero;

use super::{Hit, REACH};
use crate::{
    error::OutOfRange,
    num::{Scalar, divide_round, low_i32, saturate_i32, saturate_u32},
    space::{Point3, Vector3, World},
};

/// Fraction bits of the parameter `t` of a point `origin + t · direction`.
const T_BITS: u32 = 24;
/// Fraction bits of a direction: its largest component is from 1 to 2.
const DIRECTION_BITS: u32 = 29;
/// What a parameter is shifted by, over a quotient of lengths by components of the direction.
const QUOTIENT_BITS: u32 = T_BITS + DIRECTION_BITS - Scalar::FRAC_NBITS;
/// The largest parameter. Behind it, at 128, is no place of the world.
const FARTHEST: u32 = i32::MAX.cast_unsigned();

/// Half of a line: from its origin, in one direction.
///
/// ```
/// use aquatint::{Point3, Scalar, Vector3, hidden::raycast::Ray};
///
/// let [nil, one] = [0, 1].map(Scalar::from_num);
/// assert!(Ray::new(Point3::ORIGIN, Vector3::new(nil, one, nil)).is_ok());
/// assert!(Ray::new(Point3::new(Scalar::MAX, nil, nil), Vector3::new(nil, one, nil)).is_err());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ray {
    /// In 2⁻¹⁶, as all places.
    pub(super) origin: [i32; 3],
    /// In 2⁻²⁹. Zero for rays without a direction, which hit nothing.
    pub(super) direction: [i32; 3],
    /// Along which the direction is largest.
    pub(super) axis: Axis,
    /// The first parameter that is too far.
    pub(super) limit: u32,
    /// The square of the length of the direction, below 2⁶² in 2⁻⁵⁸, and its root in 2⁻²⁹.
    pub(super) square: i64,
    pub(super) length: i64,
}

impl Ray {
    /// From a place in a direction of any length but zero; without a direction it hits nothing. Of components of more than
    /// 30 bits the last ones are cut off.
    ///
    /// # Errors
    /// [`OutOfRange`] for a place more than [`REACH`] from zero along an axis.
    pub fn new(origin: Point3<World>, direction: Vector3<World>) -> Result<Self, OutOfRange> {
        let direction = [direction.x, direction.y, direction.z].map(|v| v.to_bits().into());
        Ok(Self::along(place(origin)?, direction))
    }

    /// From one place to another, which does not belong to it.
    ///
    /// # Errors
    /// [`OutOfRange`] for a place more than [`REACH`] from zero along an axis.
    pub fn between(origin: Point3<World>, end: Point3<World>) -> Result<Self, OutOfRange> {
        let (origin, end) = (place(origin)?, place(end)?);
        let way = between(origin, end);
        let ray = Self::along(origin, way.map(i64::from));
        let [.., (way, step)] = ray.axis.last(pairs(way, ray.direction));
        Ok(Self { limit: parameter(way.into(), step.into()).unwrap_or(FARTHEST), ..ray })
    }

    /// From a place of the world in a direction of any length.
    pub(crate) fn along(origin: [i32; 3], direction: [i64; 3]) -> Self {
        let direction = shortened(direction);
        let square = dot(direction, direction);
        let length = i64::from(saturate_u32(square.unsigned_abs().isqrt()));
        Self { origin, direction, axis: Axis::of(direction), limit: FARTHEST, square, length }
    }

    /// The ray that a surface gives back as a mirror does: `d − 2 (d·n) n`, from a [bias](super::BIAS) above it.
    #[must_use]
    pub fn reflected(&self, hit: &Hit) -> Self {
        let normal = [hit.normal.x, hit.normal.y, hit.normal.z].map(Scalar::to_bits);
        // Below 2³³, but for normals that were made up.
        let twice = dot(self.direction, normal) >> 15;
        let given_back = |(d, n): (i32, i32)| {
            let change = twice.saturating_mul(n.into()).saturating_add(1 << 15) >> 16;
            i64::from(d) - change
        };
        Self::along(hit.lifted(), pairs(self.direction, normal).map(given_back))
    }

    /// The place at a parameter: right to half a unit of 2⁻¹⁶, and inside of the world.
    pub(super) fn at(&self, t: u32) -> [i32; 3] {
        pairs(self.origin, self.direction).map(|(origin, direction)| {
            let way = (i64::from(t) * i64::from(direction) + (1 << (QUOTIENT_BITS - 1))) >> QUOTIENT_BITS;
            saturate_i32(i64::from(origin) + way).clamp(-REACH.to_bits(), REACH.to_bits())
        })
    }

    /// How far from the origin a parameter is, in 2⁻¹⁶.
    pub(super) fn distance(&self, t: u32) -> i32 {
        saturate_i32((i64::from(t) * self.length + (1 << (QUOTIENT_BITS - 1))) >> QUOTIENT_BITS)
    }

    /// The way from the origin to a place.
    #[inline]
    pub(super) fn to(&self, place: [i32; 3]) -> [i32; 3] {
        between(self.origin, place)
    }
}

/// The parameter at which so many steps along something make a way, if that is ahead and in the world: 2³⁷ times the
/// quotient, to the nearest. One division, and none for what is behind.
///
/// Both are below 2⁶². What is lost of the divisor is less than a part in 2³⁰.
#[inline]
pub(super) fn parameter(way: i64, step: i64) -> Option<u32> {
    let (way, step) = if step < 0 { (-way, -step) } else { (way, step) };
    if way <= 0 {
        return None;
    }
    let up = way.leading_zeros().saturating_sub(2).min(QUOTIENT_BITS);
    let (way, step) = (way << up, step >> (QUOTIENT_BITS - up));
    // Before the division: what would be too far.
    if step == 0 || way >> 31 >= step {
        return None;
    }
    u32::try_from(divide_round(way, step)).ok().filter(|&t| t > 0 && t < FARTHEST)
}

/// An axis of the world.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Axis {
    X,
    Y,
    Z,
}

impl Axis {
    /// Along which a vector is largest.
    pub(super) fn of(vector: [i32; 3]) -> Self {
        let [x, y, z] = vector.map(i32::unsigned_abs);
        if x >= y && x >= z {
            Self::X
        } else if y >= z {
            Self::Y
        } else {
            Self::Z
        }
    }

    /// Turns this axis to the last place, the others keep their order around.
    #[inline]
    pub(super) fn last<T>(self, [x, y, z]: [T; 3]) -> [T; 3] {
        match self {
            Self::X => [y, z, x],
            Self::Y => [z, x, y],
            Self::Z => [x, y, z],
        }
    }
}

/// A place of the world, in 2⁻¹⁶.
pub(super) fn place(point: Point3<World>) -> Result<[i32; 3], OutOfRange> {
    let place = [point.x, point.y, point.z].map(Scalar::to_bits);
    let inside = place.iter().all(|v| v.unsigned_abs() <= REACH.to_bits().unsigned_abs());
    if inside { Ok(place) } else { Err(OutOfRange) }
}

/// The way between two places of the world: at most 2²³.
#[inline]
pub(super) fn between(from: [i32; 3], to: [i32; 3]) -> [i32; 3] {
    pairs(from, to).map(|(from, to)| to - from)
}

#[inline]
pub(super) fn pairs<T, U>([a, b, c]: [T; 3], [x, y, z]: [U; 3]) -> [(T, U); 3] {
    [(a, x), (b, y), (c, z)]
}

/// Below 2⁶², for two numbers of 30 bits each.
#[inline]
pub(super) fn dot(a: [i32; 3], b: [i32; 3]) -> i64 {
    pairs(a, b).iter().map(|&(a, b)| i64::from(a) * i64::from(b)).sum()
}

/// Below 2⁶¹, for two numbers of 30 bits each.
#[inline]
pub(super) fn cross([a, b, c]: [i32; 3], [x, y, z]: [i32; 3]) -> [i64; 3] {
    let part = |p: i32, q: i32, r: i32, s: i32| i64::from(p) * i64::from(q) - i64::from(r) * i64::from(s);
    [part(b, z, c, y), part(c, x, a, z), part(a, y, b, x)]
}

/// The same direction with a largest component of 30 bits; what does not fit is cut off.
pub(super) fn shortened(vector: [i64; 3]) -> [i32; 3] {
    let largest = vector.iter().fold(0, |largest: u64, v| largest.max(v.unsigned_abs()));
    let Some(largest) = NonZero::new(largest) else { return [0; 3] };
    let digits = largest.ilog2();
    vector.map(|v| {
        low_i32(if digits > DIRECTION_BITS { v >> (digits - DIRECTION_BITS) } else { v << (DIRECTION_BITS - digits) })
    })
}
