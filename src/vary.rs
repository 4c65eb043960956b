//! What changes across a triangle: attributes that are linear on the screen, stepped without drift.
//!
//! An attribute is a number of 16 bits (a light, a texture coordinate …) or of 24 (a depth). Over a triangle it
//! is a plane; along a span it is a ramp. Both are kept as unsigned 16.15 numbers in 32 bits, *modulo 2³²*: the steps of
//! a sliver may be far out of range, but at the pixel centres inside of the triangle the sums come out right again.
//!
//! Gradients are rounded to 2⁻¹⁵ of a unit a pixel, and have 28 digits at the most. So a value is off by less than 2⁻¹⁵
//! for each pixel of distance from where the plane begins, which is a corner of a small triangle and a pixel of the
//! screen for a large one: an eighth of a unit across 4000 pixels. That place depends on the triangle alone, so bands
//! and windows get the same values. A value never leaves the range of its three corners by more than that, which the
//! half added for rounding absorbs.

use crate::{
    num::{bits, from_16_15},
    space::Point2,
};

/// A corner: where it is on the screen, and what it carries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Vertex<const N: usize> {
    /// Place on the screen.
    pub position: Point2,
    /// What is interpolated between the corners.
    pub attributes: [u16; N],
}

/// `N` attributes along one row of pixels. An endless iterator, a pixel a step.
#[derive(Clone, Debug)]
pub struct Ramp<const N: usize> {
    values: [u32; N],
    steps: [u32; N],
}

impl<const N: usize> Ramp<N> {
    /// From 16.15 numbers, half a unit of rounding in them.
    #[inline]
    pub(crate) const fn new(values: [u32; N], steps: [u32; N]) -> Self {
        Self { values, steps }
    }

    /// The attributes of the next pixel as 16.15 numbers, half a unit of rounding in them.
    #[inline]
    pub(crate) fn next_fine(&mut self) -> [u32; N] {
        let now = self.values;
        for (value, step) in self.values.iter_mut().zip(self.steps) {
            *value = value.wrapping_add(step);
        }
        now
    }

    /// The attributes of the next pixel, which stays the next.
    #[inline]
    pub(crate) const fn fine(&self) -> [u32; N] {
        self.values
    }

    /// Leaves out pixels.
    #[inline]
    pub(crate) fn leave_out(&mut self, pixels: u32) {
        *self = self.clone().skipped(pixels);
    }

    /// The ramp `pixels` further on.
    #[inline]
    pub(crate) fn skipped(mut self, pixels: u32) -> Self {
        for (value, step) in self.values.iter_mut().zip(self.steps) {
            *value = value.wrapping_add(step.wrapping_mul(pixels));
        }
        self
    }

    /// What is added from pixel to pixel, as a 16.15 number modulo 2³².
    #[inline]
    pub(crate) const fn steps(&self) -> [u32; N] {
        self.steps
    }
}

impl<const N: usize> Iterator for Ramp<N> {
    type Item = [u16; N];

    #[inline]
    fn next(&mut self) -> Option<[u16; N]> {
        Some(self.next_fine().map(from_16_15))
    }
}

/// `N` attributes over the plane of the screen, fixed by the three corners of a triangle.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Plane<const N: usize> {
    /// At the centre of this pixel, with the half for rounding in it.
    pub(crate) origin: [u32; N],
    pub(crate) column: i32,
    pub(crate) row: i32,
    pub(crate) across: [u32; N],
    pub(crate) down: [u32; N],
}

/// Corners of triangles must be nearer to zero than this, in sixteenths: 65,536 pixels.
///
/// Then a gradient's numerator stays below 2⁶⁰.
pub(crate) const LIMIT: u32 = 1 << 20;

impl<const N: usize> Plane<N> {
    /// Nothing that changes, where nothing is needed.
    pub(crate) const LEVEL: Self = Self { origin: [0; N], column: 0, row: 0, across: [0; N], down: [0; N] };

    /// The ramp that starts at the centre of a pixel and runs to the right.
    ///
    /// Two 32-bit multiplications an attribute, no division.
    #[inline]
    #[must_use]
    pub fn at(&self, row: i32, column: i32) -> Ramp<N> {
        let (right, below) = (bits(column.wrapping_sub(self.column)), bits(row.wrapping_sub(self.row)));
        let mut values = self.origin;
        for ((value, across), down) in values.iter_mut().zip(self.across).zip(self.down) {
            *value = value.wrapping_add(across.wrapping_mul(right)).wrapping_add(down.wrapping_mul(below));
        }
        Ramp { values, steps: self.across }
    }

    /// How much the first attribute changes at most from a pixel to the next, in 16.15.
    pub(crate) fn steepest(&self) -> u32 {
        let of = |steps: &[u32; N]| steps.first().map_or(0, |step| step.cast_signed().unsigned_abs());
        of(&self.across).max(of(&self.down))
    }
}

/// What a corner carries, that can be mixed when an edge is cut.
pub trait Varying: Copy {
    /// What lies between this and another, each number mixed by `mix`.
    #[must_use]
    fn mixed(self, other: Self, mix: &impl Fn(u16, u16) -> u16) -> Self;
}

impl<const N: usize> Varying for [u16; N] {
    #[inline]
    fn mixed(mut self, other: Self, mix: &impl Fn(u16, u16) -> u16) -> Self {
        for (value, other) in self.iter_mut().zip(other) {
            *value = mix(*value, other);
        }
        self
    }
}

impl<A: Varying, B: Varying> Varying for (A, B) {
    #[inline]
    fn mixed(self, other: Self, mix: &impl Fn(u16, u16) -> u16) -> Self {
        (self.0.mixed(other.0, mix), self.1.mixed(other.1, mix))
    }
}
