//! The waist of the pipeline: rasterisers emit horizontal spans, everything behind consumes them.
//!
//! ```text
//! lines ─────┐                         ┌───▶ ink on a target
//! polygons ──┼──▶ span(row, columns) ──┼───▶ depth test and shade
//! triangles ─┘                         └───▶ your own closure
//! ```

use core::ops::Range;

use crate::space::Rect;

/// Takes spans: runs of pixels in one row, with a payload that says what they carry.
///
/// The payload decides which rasteriser fits which consumer at compile time: `()` is shape alone,
/// [`Ramp`](crate::vary::Ramp) carries interpolated attributes.
///
/// Contract, kept by every rasteriser of this crate: `columns` is not empty and lies, like `row`,
/// inside [`bounds`](Self::bounds); an area's rows come from top to bottom, the spans of a row from
/// left to right, and none overlaps another.
pub trait Sink<P = ()> {
    /// What can go wrong while drawing; [`Infallible`](core::convert::Infallible) in memory.
    type Error;

    /// The pixels that are wanted. Nothing is emitted, and little is computed, outside.
    fn bounds(&self) -> Rect;

    /// One run of pixels.
    ///
    /// # Errors
    /// Whatever the place where the pixels go to says; drawing stops there.
    fn span(&mut self, row: i32, columns: Range<i32>, payload: P) -> Result<(), Self::Error>;
}

/// A [`Sink`] made of a rectangle and a closure that cannot fail.
///
/// ```
/// use aquatint::{Rect, Sink, SpanFn};
///
/// let mut pixels = 0;
/// let window = Rect::new(0, 0, 8, 8);
/// let mut count = SpanFn::new(window, |_row, columns: core::ops::Range<i32>, ()| pixels += columns.len());
/// count.span(3, 1..5, ()).unwrap();
/// assert_eq!(pixels, 4);
/// ```
#[derive(Debug)]
pub struct SpanFn<F> {
    bounds: Rect,
    take: F,
}

impl<F> SpanFn<F> {
    /// Calls `take(row, columns, payload)` for every span inside `bounds`.
    pub const fn new(bounds: Rect, take: F) -> Self {
        Self { bounds, take }
    }
}

impl<P, F: FnMut(i32, Range<i32>, P)> Sink<P> for SpanFn<F> {
    type Error = core::convert::Infallible;

    fn bounds(&self) -> Rect {
        self.bounds
    }

    fn span(&mut self, row: i32, columns: Range<i32>, payload: P) -> Result<(), Self::Error> {
        (self.take)(row, columns, payload);
        Ok(())
    }
}
