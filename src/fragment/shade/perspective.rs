//! Attributes that are linear on the surface, not on the screen: texture coordinates. Lecture 2.4.3.
//!
//! What is linear on the screen is an attribute over `w`, and one over `w`. Both are planes; their quotient is taken at
//! every eighth column of the screen, and between these the attribute goes straight:
//!
//! ```text
//!   column   0       8       16      24
//!            ÷───────÷───────÷───────÷      one reciprocal for all attributes at each ÷
//! ```
//!
//! The columns are those of the screen, so that a band, a tile and a span of which a part is hidden get the same values. A
//! quotient at such a column may lie outside of the triangle, beyond its horizon even: where it is far from what the corners
//! have, each pixel is divided by itself. Over 64 texels, with the far end four times as far as the near one, a coordinate
//! is off by 0.09 texels at most on a span of 400 pixels, and by 0.6 on one of 128; the numbers themselves are by 4
//! of 4096 of a texture.

use super::Placed;
use crate::{
    num::{Scalar, bits, multiply_high, reciprocal, saturate_u32, to_16_15},
    slopes::Slopes,
    space::LEAST_W,
    vary::{Plane, Ramp},
};

/// `N` attributes over a triangle in perspective.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Perspective<const N: usize> {
    /// The least of the three corners, 16.15.
    least: [u32; N],
    /// From there to the greatest.
    reach: [u32; N],
    /// The rest over `w`, in 2⁻¹⁶ of the next.
    over_w: Plane<N>,
    /// One over `w`, 2³⁰ at the nearest corner.
    one_over_w: Plane<1>,
    /// The least one over `w` at which a block may begin or end.
    horizon: u32,
}

/// Columns from division to division.
const BLOCK: u32 = 8;

/// One over `w` of what is 16,384 times as far as the nearest corner: beyond, or behind the eye, no block begins or ends,
/// because what has been rounded is no small part of it any more.
const HORIZON: u32 = 1 << 16;

/// What changes less than this from pixel to pixel keeps to its 32 bits where a block begins or ends, up to eight pixels
/// outside of the triangle. In slivers that are steeper each pixel is divided by itself.
const STEEP: u32 = 1 << 27;

impl<const N: usize> Perspective<N> {
    /// Of three corners with attributes. Three reciprocals, and a 64-bit product a corner and attribute.
    #[must_use]
    pub fn new(slopes: &Slopes, corners: &[Placed<[u16; N]>; 3]) -> Self {
        let [a, b, c] = corners;
        let nearest = a.w.min(b.w).min(c.w).max(LEAST_W);
        let (mut least, mut reach) = (a.attributes, a.attributes);
        for (((least, reach), b), c) in least.iter_mut().zip(&mut reach).zip(b.attributes).zip(c.attributes) {
            *least = (*least).min(b).min(c);
            *reach = (*reach).max(b).max(c) - *least;
        }
        let one_over_w = corners.map(|corner| quotient(nearest, corner.w));
        let over_w = |corner: &Placed<[u16; N]>, one_over_w: u32| {
            let mut over_w = [0; N];
            for ((over_w, attribute), least) in over_w.iter_mut().zip(corner.attributes).zip(least) {
                let rest = u64::from(attribute.saturating_sub(least));
                *over_w = saturate_u32((u64::from(one_over_w) * rest) >> 16);
            }
            over_w
        };
        let [p, q, r] = one_over_w;
        let over_w = [over_w(a, p), over_w(b, q), over_w(c, r)];
        let (over_w, one_over_w) = (slopes.fine_plane(&over_w), slopes.fine_plane(&one_over_w.map(|value| [value])));
        let is_steep = |step: &u32| step.cast_signed().unsigned_abs() >= STEEP;
        let horizon = if over_w.across.iter().chain(&one_over_w.across).any(is_steep) { u32::MAX } else { HORIZON };
        Self { least: least.map(to_16_15), reach: reach.map(to_16_15), over_w, one_over_w, horizon }
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
        let Self { least, reach, horizon, .. } = *self;
        let mut blocks = Blocks { least, reach, over_w, one_over_w, horizon, into, alone: 0, start: None, scale };
        blocks.start = blocks.end();
        PerspectiveRun { blocks, block: Block { values: [0; N], steps: [0; N], left: 0 } }
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
    blocks: Blocks<N>,
    block: Block<N>,
}

/// What goes straight, and changes from pixel to pixel: small, so that it stays in registers.
#[derive(Clone, Copy, Debug)]
struct Block<const N: usize> {
    values: [u32; N],
    steps: [u32; N],
    /// Pixels that are still to come.
    left: u32,
}

/// What changes from block to block.
#[derive(Clone, Debug)]
struct Blocks<const N: usize> {
    least: [u32; N],
    reach: [u32; N],
    /// Where the next block begins, or the pixel that is next of one that is divided pixel by pixel.
    over_w: Ramp<N>,
    one_over_w: Ramp<1>,
    horizon: u32,
    /// Pixels of the first block that lie before the run.
    into: u32,
    /// Pixels that are still to come of a block that is divided pixel by pixel.
    alone: u32,
    /// The values where the next block begins.
    start: Option<[u32; N]>,
    scale: Option<[u32; N]>,
}

impl<const N: usize> Blocks<N> {
    /// Begins the next block, or gives the next pixel of one that is divided pixel by pixel.
    #[inline(never)]
    fn next(&mut self, block: &mut Block<N>) -> Option<[u32; N]> {
        if self.alone == 0 && self.go_straight(block) {
            return None;
        }
        Some(self.next_pixel())
    }

    /// Goes to the next block; `false` if it is to be divided pixel by pixel.
    #[inline]
    fn go_straight(&mut self, block: &mut Block<N>) -> bool {
        let into = core::mem::take(&mut self.into);
        self.leave_out(BLOCK);
        let end = self.end();
        let start = core::mem::replace(&mut self.start, end);
        let Some((start, end)) = start.zip(end).filter(|(start, end)| is_way(start, end)) else {
            self.alone = BLOCK - into;
            // Back to the first pixel.
            self.leave_out(into.wrapping_sub(BLOCK));
            return false;
        };
        (block.values, block.left) = (start, BLOCK - into);
        for ((value, step), end) in block.values.iter_mut().zip(&mut block.steps).zip(end) {
            *step = bits(end.wrapping_sub(*value).cast_signed() >> BLOCK.ilog2());
            *value = value.wrapping_add(step.wrapping_mul(into));
        }
        true
    }

    fn leave_out(&mut self, pixels: u32) {
        self.over_w.leave_out(pixels);
        self.one_over_w.leave_out(pixels);
    }

    /// A pixel of a block that is divided pixel by pixel.
    #[cold]
    #[inline(never)]
    fn next_pixel(&mut self) -> [u32; N] {
        let values = self.divided().unwrap_or_else(|| self.scaled(self.least));
        self.leave_out(1);
        self.alone = self.alone.wrapping_sub(1);
        if self.alone == 0 {
            self.start = self.end();
        }
        values
    }

    /// The attributes where the next block begins; `None` outside of the triangle, where the division is out of range or
    /// leaves that of the corners by more than a quarter: the way would be bent.
    #[inline]
    fn end(&self) -> Option<[u32; N]> {
        let ways = self.quotients(self.horizon)?;
        let mut each = ways.iter().zip(self.reach);
        let is_near =
            each.all(|(way, reach)| (-(reach >> 2).cast_signed()..=(reach + (reach >> 2)).cast_signed()).contains(way));
        if is_near { self.attributes(ways) } else { None }
    }

    /// The attributes at the next pixel.
    #[inline]
    fn divided(&self) -> Option<[u32; N]> {
        self.attributes(self.quotients(1 << 8)?)
    }

    /// How far the attributes are from their least, if one over `w` is at least this.
    #[inline]
    fn quotients(&self, least: u32) -> Option<[i32; N]> {
        let [over] = self.one_over_w.fine();
        if !(least..1 << 31).contains(&over) {
            return None;
        }
        // over / 2³¹ inverted is inverse · 2^shift / 2³².
        let (inverse, shift) = reciprocal(over);
        let mut quotients = [0; N];
        for (quotient, part) in quotients.iter_mut().zip(self.over_w.fine()) {
            // Outside of the triangle a part may be negative, or greater than the whole.
            if part.cast_signed().unsigned_abs() > over {
                return None;
            }
            // Halved, so that it keeps its sign; there is always a zero to shift out of a number below 2³¹.
            *quotient = multiply_high((part.cast_signed() >> 1) << shift.saturating_sub(1), inverse) << 2;
        }
        Some(quotients)
    }

    /// Attributes by how far they are from their least; `None` beyond the range of attributes.
    #[inline]
    fn attributes(&self, ways: [i32; N]) -> Option<[u32; N]> {
        let mut values = self.least;
        for (value, way) in values.iter_mut().zip(ways) {
            *value = value.wrapping_add(bits(way));
            if *value >> 31 != 0 {
                return None;
            }
        }
        Some(self.scaled(values))
    }

    /// Attributes as they are asked for.
    #[inline]
    fn scaled(&self, mut values: [u32; N]) -> [u32; N] {
        if let Some(scale) = self.scale {
            for (value, right) in values.iter_mut().zip(scale) {
                *value = bits((value.cast_signed().wrapping_sub(1 << 30) << 1) >> right);
            }
        }
        values
    }
}

/// Whether from start to end is less than all that a number may be: with more it would be taken for the other way round.
fn is_way<const N: usize>(start: &[u32; N], end: &[u32; N]) -> bool {
    start.iter().zip(end).all(|(start, end)| end.cast_signed().checked_sub(start.cast_signed()).is_some())
}

impl<const N: usize> Iterator for PerspectiveRun<N> {
    type Item = [u32; N];

    #[inline]
    fn next(&mut self) -> Option<[u32; N]> {
        if self.block.left == 0 {
            if let Some(values) = self.blocks.next(&mut self.block) {
                return Some(values);
            }
        }
        let Block { values, steps, left } = &mut self.block;
        *left = left.wrapping_sub(1);
        let now = *values;
        for (value, step) in values.iter_mut().zip(*steps) {
            *value = value.wrapping_add(step);
        }
        Some(now)
    }
}
