//! What changes across a triangle: attributes that are linear on the screen, exactly stepped.
//!
//! An attribute is a `u16` (a depth, a light …). Over a triangle it is a plane; along a span it is
//! a ramp. Both are kept in 16.16 *modulo 2³²*: the steps of a sliver may be far out of range, but
//! at the pixel centres inside the triangle the sums come out right again. Gradients are rounded
//! to 2⁻¹⁶ of a unit a pixel, so a value is off by less than 2⁻¹⁷ for each pixel of distance from
//! the first vertex: 0.03 units across 4000 pixels, and a value never leaves the range of its
//! three corners by more than that, which the half added for rounding absorbs.

use crate::{
    num::{SUBPIXELS, bits, divide_round, high_u16, low_u32},
    space::{Point2, twice_area},
};

/// A corner: where it is on the screen, and what it carries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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

impl<const N: usize> Iterator for Ramp<N> {
    type Item = [u16; N];

    #[inline]
    fn next(&mut self) -> Option<[u16; N]> {
        let now = self.values.map(high_u16);
        for (value, step) in self.values.iter_mut().zip(self.steps) {
            *value = value.wrapping_add(step);
        }
        Some(now)
    }
}

/// `N` attributes over the plane of the screen, fixed by the three corners of a triangle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plane<const N: usize> {
    /// At the centre of pixel (0, 0), with the half for rounding in it.
    origin: [u32; N],
    across: [u32; N],
    down: [u32; N],
}

/// Corners of triangles must be nearer to zero than this, in sixteenths: 65,536 pixels.
///
/// Then a gradient's numerator stays below 2⁶⁰.
pub(crate) const LIMIT: u32 = 1 << 20;

impl<const N: usize> Plane<N> {
    /// The plane through three corners nearer than [`LIMIT`] that are not in line.
    ///
    /// Two 64-bit divisions an attribute.
    pub(crate) fn through([a, b, c]: &[Vertex<N>; 3]) -> Self {
        let area = twice_area(a.position, b.position, c.position);
        let (area, sign) = (area.abs(), area.signum());
        let (to_b, to_c) = (between(a.position, b.position), between(a.position, c.position));
        let mut plane = Self { origin: [0; N], across: [0; N], down: [0; N] };
        let outputs = plane.origin.iter_mut().zip(&mut plane.across).zip(&mut plane.down);
        let corners = a.attributes.into_iter().zip(b.attributes).zip(c.attributes);
        for (((origin, across), down), ((va, vb), vc)) in outputs.zip(corners) {
            let (rise_b, rise_c) = (i64::from(vb) - i64::from(va), i64::from(vc) - i64::from(va));
            // Per pixel, in 16.16: sixteen times the gradient per sixteenth.
            let gradient = |numerator: i64| divide_round((sign * numerator) << 20, area);
            let along_x = gradient(rise_b * to_c.1 - rise_c * to_b.1);
            let along_y = gradient(rise_c * to_b.0 - rise_b * to_c.0);
            let half = i64::from(SUBPIXELS / 2);
            let (x, y) = (half - i64::from(a.position.x.to_bits()), half - i64::from(a.position.y.to_bits()));
            let offset = along_x.wrapping_mul(x).wrapping_add(along_y.wrapping_mul(y)) >> 4;
            *origin = low_u32((i64::from(va) << 16) + 0x8000).wrapping_add(low_u32(offset));
            (*across, *down) = (low_u32(along_x), low_u32(along_y));
        }
        plane
    }

    /// The ramp that starts at the centre of a pixel and runs to the right.
    ///
    /// Two 32-bit multiplications an attribute, no division.
    #[inline]
    pub(crate) fn at(&self, row: i32, column: i32) -> Ramp<N> {
        let mut values = self.origin;
        for ((value, across), down) in values.iter_mut().zip(self.across).zip(self.down) {
            *value = value.wrapping_add(across.wrapping_mul(bits(column))).wrapping_add(down.wrapping_mul(bits(row)));
        }
        Ramp { values, steps: self.across }
    }
}

fn between(from: Point2, to: Point2) -> (i64, i64) {
    let difference = |a: i32, b: i32| i64::from(b) - i64::from(a);
    (difference(from.x.to_bits(), to.x.to_bits()), difference(from.y.to_bits(), to.y.to_bits()))
}
