//! Attributes that are linear on the surface, not on the screen: texture coordinates. Lecture 2.4.3.
//!
//! What is linear on the screen is an attribute over `w`, and one over `w`. Both are planes; their quotient is taken at
//! every eighth column of the screen, and between these the attribute goes straight:
//!
//! ```text
//!   column   0       8       16      24
//!            ÷───────÷───────÷───────÷      one division for all attributes at each ÷
//! ```
//!
//! The columns are those of the screen, so that a band, a tile and a span of which a part is hidden get the same values. A
//! quotient at such a column may lie outside of the triangle, beyond its horizon even: there each pixel is divided by
//! itself. Over 64 texels, with the far end four times as far as the near one, a coordinate is off by 0.07 texels at most
//! on a span of 400 pixels, and by 0.7 on one of 128.

use super::Placed;
use crate::{
    num::{Scalar, bits, reciprocal, saturate_u32, to_16_15},
    space::LEAST_W,
    vary::{Plane, Slopes},
};

/// `N` attributes over a triangle in perspective.
#[derive(Clone, Copy, Debug)]
pub struct Perspective<const N: usize> {
    /// The least of the three corners, 16.15.
    least: [u32; N],
    /// The rest over `w`, in 2⁻¹⁴ of the next.
    over_w: Plane<N>,
    /// One over `w`, 2³⁰ at the nearest corner.
    one_over_w: Plane<1>,
    /// Whether one of these goes around within a block: beside a triangle of few pixels, seen almost from its edge.
    is_steep: bool,
}

/// Columns from division to division.
const BLOCK: u32 = 8;

/// What changes by less from column to column stays within 2³¹ over a block that a pixel of the triangle is in.
const STEEP: u32 = 1 << 27;

impl<const N: usize> Perspective<N> {
    /// Of three corners with attributes. Three 32-bit divisions, and two more 64-bit products a corner and attribute.
    #[must_use]
    pub fn new(slopes: &Slopes, corners: &[Placed<[u16; N]>; 3]) -> Self {
        let [a, b, c] = corners;
        let nearest = a.w.min(b.w).min(c.w).max(LEAST_W);
        let mut least = a.attributes;
        for ((least, b), c) in least.iter_mut().zip(b.attributes).zip(c.attributes) {
            *least = (*least).min(b).min(c);
        }
        let one_over_w = corners.map(|corner| quotient(nearest, corner.w));
        let mut index = 0_usize;
        let over_w = one_over_w.map(|one_over_w| {
            let mut over_w = [0; N];
            let attributes = corners.get(index).map_or([0; N], |corner| corner.attributes);
            for ((over_w, attribute), least) in over_w.iter_mut().zip(attributes).zip(least) {
                let rest = u64::from(attribute.saturating_sub(least));
                *over_w = saturate_u32((u64::from(one_over_w) * rest) >> 16);
            }
            index += 1;
            over_w
        });
        let over_w = slopes.fine_plane(&over_w);
        let one_over_w = slopes.fine_plane(&one_over_w.map(|value| [value]));
        let is_steep = |step: u32| step.cast_signed().unsigned_abs() >= STEEP;
        let is_steep = over_w.at(0, 0).steps().into_iter().chain(one_over_w.at(0, 0).steps()).any(is_steep);
        Self { least: least.map(to_16_15), over_w, one_over_w, is_steep }
    }

    /// The attributes from a pixel on to the right, as 16.15 numbers.
    #[inline]
    #[must_use]
    pub fn at(&self, row: i32, column: i32) -> PerspectiveRun<'_, N> {
        PerspectiveRun { plane: self, row, column, left: 0, values: [0; N], steps: [0; N], next: None }
    }

    /// The attributes at the centre of a pixel; `None` where the division is out of range, outside of the triangle.
    #[inline]
    fn divided(&self, row: i32, column: i32) -> Option<[u32; N]> {
        let [mut over] = self.one_over_w.at(row, column).next_fine();
        let parts = self.over_w.at(row, column).next_fine();
        // To 28 digits or more, by steps of two: most of what is seen is not much farther than the nearest corner.
        let mut shift = 0;
        while over < 1 << 28 {
            if shift > 20 {
                return None;
            }
            over <<= 2;
            shift += 2;
        }
        // 2⁴⁴ / over
        let inverse = u32::MAX.checked_div(over >> 12).filter(|_| over < 1 << 31)?;
        let mut values = self.least;
        for (value, part) in values.iter_mut().zip(parts) {
            // Outside of the triangle a part may be negative, or greater than the whole.
            let part = (part.cast_signed()).checked_mul(1 << shift).filter(|part| part.unsigned_abs() < over)?;
            *value = value.wrapping_add(bits((part >> 14).wrapping_mul(inverse.cast_signed()) << 1));
        }
        Some(values)
    }
}

/// `near / w` as a number with 30 fraction bits, at most 1.
fn quotient(near: Scalar, w: Scalar) -> u32 {
    let (over, zeros) = reciprocal(w.max(near).to_bits().unsigned_abs());
    let product = u64::from(near.to_bits().unsigned_abs()) * u64::from(over);
    saturate_u32(product >> 33_u32.saturating_sub(zeros)).min(1 << 30)
}

/// The attributes along a row, a pixel a step.
#[derive(Clone, Debug)]
pub struct PerspectiveRun<'p, const N: usize> {
    plane: &'p Perspective<N>,
    row: i32,
    column: i32,
    /// Pixels of the block that are still to come.
    left: u32,
    values: [u32; N],
    steps: [u32; N],
    /// The values where the next block begins.
    next: Option<[u32; N]>,
}

impl<const N: usize> PerspectiveRun<'_, N> {
    /// Whether from start to end is less than all that a number may be: with more it would be taken for the other way round.
    fn is_way(&self, start: &[u32; N], end: &[u32; N]) -> bool {
        let mut ends = start.iter().zip(end).zip(self.plane.least);
        ends.all(|((start, end), least)| {
            let above = |value: &u32| value.wrapping_sub(least).cast_signed();
            above(end).checked_sub(above(start)).is_some()
        })
    }

    /// Begins the block that a column is in, or a block of one pixel where that is divided by itself.
    #[inline(never)]
    fn begin(&mut self) {
        let into = bits(self.column) % BLOCK;
        let first = self.column.wrapping_sub(into.cast_signed());
        let start = self.next.take().or_else(|| self.plane.divided(self.row, first));
        let end = self.plane.divided(self.row, first.wrapping_add(BLOCK.cast_signed()));
        if let Some((start, end)) =
            start.zip(end).filter(|(start, end)| !self.plane.is_steep && self.is_way(start, end))
        {
            (self.values, self.next) = (start, Some(end));
            for ((value, step), end) in self.values.iter_mut().zip(&mut self.steps).zip(end) {
                *step = bits(end.wrapping_sub(*value).cast_signed() >> BLOCK.ilog2());
                *value = value.wrapping_add(step.wrapping_mul(into));
            }
            self.left = BLOCK - into;
        } else {
            self.values = self.plane.divided(self.row, self.column).unwrap_or(self.plane.least);
            self.left = 1;
        }
        self.column = self.column.wrapping_add(self.left.cast_signed());
    }
}

impl<const N: usize> Iterator for PerspectiveRun<'_, N> {
    type Item = [u32; N];

    #[inline]
    fn next(&mut self) -> Option<[u32; N]> {
        if self.left == 0 {
            self.begin();
        }
        self.left -= 1;
        let now = self.values;
        for (value, step) in self.values.iter_mut().zip(self.steps) {
            *value = value.wrapping_add(step);
        }
        Some(now)
    }
}
