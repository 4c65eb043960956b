//! Hidden surfaces: who is in front. Lecture 5.
//!
//! - **Takes** spans with a depth, faces on the screen, planes in the object's space, or rays: each way its own.
//! - **Gives** what of them is seen.
//! - **Memory**, **Cost** as follows.
//!
//! All show the same picture: a face that is split keeps its pixels, its depths and its light. Only where two faces are at the
//! same depth to a unit or two of 16 bits may one way show the one and another the other; rays, which round no corner, differ
//! beside edges, too.
//!
//! | way | by | memory | instructions for 8, 64, 512 faces | grows with |
//! |---|---|---|---|---|
//! | back faces alone | [`Convex`](convex::Convex) | none | | faces |
//! | depth buffer | [`draw_mesh`](crate::pipeline::draw_mesh), [`depth`] | 1, 2 or 4 bytes a pixel of the frame or of a band | 49 k, 163 k, 796 k | faces, pixels that they cover |
//! | scanline | [`draw_scene`](crate::pipeline::draw_scene), [`scanline`] | 16 bytes a face, 100 a face of one row, none for pixels | 60 k, 234 k, 1.1 M | faces, rows that they reach |
//! | BSP tree | [`draw_tree`](crate::pipeline::draw_tree), [`bsp`] | flash: some 50 bytes a face | 72 k, 255 k, 1.5 M | faces, and how often they are split |
//! | depth sort | [`draw_sorted`](crate::pipeline::draw_sorted), [`painter`] | 68 bytes a face, 170 a split | 61 k, 265 k, 2.8 M | k log k, and more where faces are close |
//! | object space | [`draw_compared`](crate::pipeline::draw_compared), [`object_space`] | 48 bytes a face | 115 k, 727 k, 20 M | k² |
//! | rays, boxes around them | [`draw_rays`](crate::pipeline::draw_rays), [`raycast`] | 70 bytes a face in all, may be flash | 7.4 M, 10 M, 17 M | pixels · log k |
//! | rays, from a list | the same | none more | 20 M, 120 M, 918 M | pixels · k |
//!
//! (Counted on the desk by `cargo bench -- grow_`: 128 × 64 pixels of one bit, flat faces that lie anyhow and cover 1.2 times the
//! picture; 12 bytes a vertex come to all of them; rays see shadows, too. `examples/assets/hidden.png` has the curves.)
//!
//! **When to take which.** One call and no memory for pixels: `draw_scene`, which is also the only way to pictures larger than
//! the RAM that draws everything once. RAM for the depths, many small faces, several shadings in one picture, pixels that are left
//! out: the depth buffer. A place that does not change: a tree in flash, which is also asked for [what is solid](solid_bsp).
//! What is translucent must come from the back: a tree, or depth sort. A few faces, and a target that must not be given a pixel
//! twice: object space. Balls, shadows, mirrors: rays. One convex solid: back faces alone.

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
