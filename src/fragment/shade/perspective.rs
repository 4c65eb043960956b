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
    vary::{Plane, Ramp, Slopes},
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
}

/// Columns from division to division.
const BLOCK: u32 = 8;

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
        Self {
            least: least.map(to_16_15),
            over_w: slopes.fine_plane(&over_w),
            one_over_w: slopes.fine_plane(&one_over_w.map(|value| [value])),
        }
    }

    /// The attributes from a pixel on to the right, as 16.15 numbers.
    #[inline]
    #[must_use]
    pub fn at(&self, row: i32, column: i32) -> PerspectiveRun<N> {
        self.scaled_at(row, column, None)
    }

    /// The same as signed numbers, of which zero is in the middle of their range: 2³⁰ less, times two, and shifted to
    /// the right by these numbers of digits, so that this is not done for each pixel.
    #[inline]
    pub(super) fn scaled_at(&self, row: i32, column: i32, scale: Option<[u32; N]>) -> PerspectiveRun<N> {
        let into = bits(column) % BLOCK;
        let first = column.wrapping_sub(into.cast_signed());
        let (over_w, one_over_w) = (self.over_w.at(row, first), self.one_over_w.at(row, first));
        let mut run = PerspectiveRun {
            least: self.least,
            over_w,
            one_over_w,
            left: 0,
            into,
            values: [0; N],
            steps: [0; N],
            start: None,
            by_pixel: false,
            scale,
        };
        run.start = run.divided();
        run
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
pub struct PerspectiveRun<const N: usize> {
    least: [u32; N],
    /// Where the block begins that is next, or the pixel that is next of one that is divided pixel by pixel.
    over_w: Ramp<N>,
    one_over_w: Ramp<1>,
    /// Pixels of the block that are still to come.
    left: u32,
    /// Pixels of the first block that lie before the run.
    into: u32,
    values: [u32; N],
    steps: [u32; N],
    /// The values where the next block begins.
    start: Option<[u32; N]>,
    by_pixel: bool,
    scale: Option<[u32; N]>,
}

impl<const N: usize> PerspectiveRun<N> {
    /// Begins the next block. By value, so that the caller keeps what changes from pixel to pixel in registers.
    #[cold]
    #[inline(never)]
    fn begun(mut self) -> Self {
        let into = core::mem::take(&mut self.into);
        self.left = BLOCK - into;
        let (over_w, one_over_w) = (self.over_w.clone(), self.one_over_w.clone());
        self.over_w.leave_out(BLOCK);
        self.one_over_w.leave_out(BLOCK);
        let end = self.divided();
        let start = core::mem::replace(&mut self.start, end);
        self.by_pixel = false;
        if let (Some(start), Some(end)) = (start, end) {
            self.values = start;
            for ((value, step), end) in self.values.iter_mut().zip(&mut self.steps).zip(end) {
                *step = bits(end.wrapping_sub(*value).cast_signed() >> BLOCK.ilog2());
                *value = value.wrapping_add(step.wrapping_mul(into));
            }
        } else {
            (self.over_w, self.one_over_w) = (over_w.skipped(into), one_over_w.skipped(into));
            self.by_pixel = true;
        }
        self
    }

    /// Steps over a pixel of a block that is divided pixel by pixel, whose values it leaves behind.
    #[cold]
    #[inline(never)]
    fn divided_one(mut self) -> Self {
        self.values = self.divided().unwrap_or(self.least);
        self.over_w.leave_out(1);
        self.one_over_w.leave_out(1);
        if self.left == 0 {
            self.start = self.divided();
        }
        self
    }

    /// The attributes where the next block begins; `None` where the division is out of range, outside of the triangle.
    #[inline]
    fn divided(&self) -> Option<[u32; N]> {
        let [mut over] = self.one_over_w.fine();
        // To 28 digits or more, by steps of two: most of what is seen is not much farther than the nearest corner.
        let mut shift = 0;
        while over < 1 << 28 {
            if shift > 20 {
                return None;
            }
            (over, shift) = (over << 2, shift + 2);
        }
        // 2⁴⁴ / over
        let inverse = u32::MAX.checked_div(over >> 12).filter(|_| over < 1 << 31)?;
        let mut values = self.least;
        for (value, part) in values.iter_mut().zip(self.over_w.fine()) {
            // Outside of the triangle a part may be negative, or greater than the whole.
            let scaled = part << shift;
            let is_in_range = scaled.cast_signed() >> shift == part.cast_signed();
            if !is_in_range || scaled.cast_signed().unsigned_abs() >= 2 * over {
                return None;
            }
            *value = value.wrapping_add(bits((scaled.cast_signed() >> 14).wrapping_mul(inverse.cast_signed()) << 1));
        }
        if let Some(scale) = self.scale {
            for (value, right) in values.iter_mut().zip(scale) {
                *value = bits((value.cast_signed().wrapping_sub(1 << 30) << 1) >> right);
            }
        }
        Some(values)
    }
}

impl<const N: usize> Iterator for PerspectiveRun<N> {
    type Item = [u32; N];

    #[inline]
    fn next(&mut self) -> Option<[u32; N]> {
        if self.left == 0 {
            *self = self.clone().begun();
        }
        self.left -= 1;
        if self.by_pixel {
            *self = self.clone().divided_one();
            return Some(self.values);
        }
        let now = self.values;
        for (value, step) in self.values.iter_mut().zip(self.steps) {
            *value = value.wrapping_add(step);
        }
        Some(now)
    }
}
