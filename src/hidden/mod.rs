//! Hidden surfaces: who is in front. Lecture 5.
//!
//! - **Takes** spans with a depth.
//! - **Gives** the parts of them that are seen.
//! - **Memory** one, two or four bytes a pixel of the caller's, for the frame or any part of it; none for
//!   [`Convex`](convex::Convex), in front of which [trees](bsp) put faces in order.
//! - **Cost** one comparison a fragment.
//!
//! The other way around, from the pixels to the objects, go the rays of [`raycast`].

pub mod bsp;
pub mod convex;
pub mod depth;
mod depth_test;
pub mod object_space;
pub mod painter;
pub mod raycast;
pub mod scanline;
pub mod solid_bsp;
pub(crate) mod within;

use core::ops::Range;

use crate::{space::Rect, vary::Ramp};

/// Decides which pixels of a span are seen.
pub trait Hidden {
    /// Whether depths are looked at. If not, none are computed.
    const USES_DEPTH: bool;

    /// The pixels that can be decided.
    fn bounds(&self) -> Rect;

    /// Whether one pixel is seen at a depth.
    fn sees(&mut self, row: i32, column: i32, depth: Ramp<1>) -> bool;

    /// Calls `seen` for the parts of a span that are seen, from the left. `depth` begins at the first column.
    ///
    /// # Errors
    /// The first of `seen`.
    fn split<E>(
        &mut self,
        row: i32,
        columns: Range<i32>,
        depth: Ramp<1>,
        seen: impl FnMut(Range<i32>) -> Result<(), E>,
    ) -> Result<(), E>;

    /// Lets the colours of the pixels pass that are seen. A pixel without a colour is not drawn, and hides nothing.
    fn filter<C>(
        &mut self,
        row: i32,
        columns: Range<i32>,
        depth: Ramp<1>,
        colors: impl Iterator<Item = Option<C>>,
    ) -> impl Iterator<Item = Option<C>>;
}
