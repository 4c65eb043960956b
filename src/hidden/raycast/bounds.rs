//! Boxes around shapes, and what a ray knows to miss them without a division and without a long product.
//!
//! A line misses a box if it does so in one of the three pictures of both that are seen along the axes:
//!
//! ```text
//!        ┌───┐ half       across = |c × d|, how far the line passes the centre c
//!        │ c │            reach  = half · |d|, how far the box reaches towards it
//!    ╱   └───┘
//!  ╱ d                    across > reach: no hit
//! ```
//!
//! Coordinates are whole 128ths here, 16 bits, so that products fit 32: a box is too large by 1/40 in the worst case,
//! never too small.

use super::ray::{Ray, pairs};
use crate::num::{Scalar, saturate_i16};

/// Fraction bits that a box does without.
const COARSE: u32 = Scalar::FRAC_NBITS - 7;
/// All that is rounded: of the origin half a 128th (twice that is counted, times two components of 2¹⁴), of the direction
/// half a part in 2¹⁴ (times two of 2¹⁵, and two of 2¹⁴).
const SLACK: i32 = (1 << 15) + (1 << 15) + (1 << 14) + 16;

/// A box, in 128ths, rounded outwards.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Bounds {
    min: [i16; 3],
    max: [i16; 3],
}

impl Bounds {
    pub(super) const EMPTY: Self = Self { min: [i16::MAX; 3], max: [i16::MIN; 3] };
    /// As large as the world: every ray meets it.
    pub(super) const WORLD: Self = Self { min: [-(1 << 13); 3], max: [1 << 13; 3] };

    /// Around some places of the world.
    pub(super) fn of<const N: usize>(places: [[i32; 3]; N]) -> Self {
        let around = |place: [i32; 3]| Self {
            min: place.map(|v| saturate_i16((v >> COARSE).into())),
            max: place.map(|v| saturate_i16((v >> COARSE).saturating_add(1).into())),
        };
        places.map(around).iter().fold(Self::EMPTY, |all, one| all.union(one))
    }

    /// Around both.
    pub(super) fn union(&self, other: &Self) -> Self {
        Self {
            min: pairs(self.min, other.min).map(|(a, b)| a.min(b)),
            max: pairs(self.max, other.max).map(|(a, b)| a.max(b)),
        }
    }

    /// Twice its middle.
    #[inline]
    pub(super) fn middle(&self) -> [i32; 3] {
        pairs(self.min, self.max).map(|(a, b)| i32::from(a) + i32::from(b))
    }

    /// How long it is along each axis.
    #[inline]
    pub(super) fn size(&self) -> [i32; 3] {
        pairs(self.min, self.max).map(|(a, b)| i32::from(b) - i32::from(a))
    }

    /// Whether they have a place in common, which for [`EMPTY`](Self::EMPTY) is not asked.
    #[inline]
    fn overlaps(&self, other: &Self) -> bool {
        let [(a, b), (c, d), (e, f)] = pairs(self.min, other.max);
        let [(g, h), (i, j), (k, l)] = pairs(self.max, other.min);
        a <= b && c <= d && e <= f && g >= h && i >= j && k >= l
    }
}

/// A ray in the numbers of boxes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Probe {
    /// Twice the origin.
    origin: [i32; 3],
    /// In 2⁻¹³.
    direction: [i32; 3],
    /// Without signs.
    size: [i32; 3],
    /// Around the part of the ray that counts.
    part: Bounds,
}

impl Probe {
    pub(super) fn new(ray: &Ray) -> Self {
        let direction = ray.direction.map(|v| (v + (1 << 15)) >> 16);
        Self {
            // The middle of what a 128th holds.
            origin: ray.origin.map(|v| 2 * (v >> COARSE) + 1),
            direction,
            size: direction.map(i32::abs),
            part: Self::part(ray, ray.limit),
        }
    }

    /// From now on only what is not behind a parameter counts.
    pub(super) fn shorten(&mut self, ray: &Ray, limit: u32) {
        self.part = Self::part(ray, limit);
    }

    /// A 128th larger than need be, so that the rounding of the end does no harm.
    fn part(ray: &Ray, limit: u32) -> Bounds {
        let Bounds { min, max } = Bounds::of([ray.origin, ray.at(limit)]);
        Bounds { min: min.map(|v| v.saturating_sub(1)), max: max.map(|v| v.saturating_add(1)) }
    }

    /// Whether the ray may meet a box; if not, it certainly does not. Twelve products of 32 bits.
    #[inline]
    pub(super) fn meets(&self, bounds: &Bounds) -> bool {
        if !bounds.overlaps(&self.part) {
            return false;
        }
        let [x, y, z] = pairs(bounds.middle(), self.origin).map(|(middle, origin)| middle - origin);
        let ([a, b, c], [i, j, k], [p, q, r]) = (self.direction, bounds.size(), self.size);
        // Across up to 2³⁰, reaches up to 2²⁹.
        (y * c - z * b).abs() <= j * r + k * q + SLACK
            && (z * a - x * c).abs() <= k * p + i * r + SLACK
            && (x * b - y * a).abs() <= i * q + j * p + SLACK
    }
}
