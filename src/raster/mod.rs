//! Rasterisation: which pixels. Lecture 4.
//!
//! - **Takes** lines between pixels, and polygons and triangles with corners on sixteenths of a
//!   pixel.
//! - **Gives** spans to a [`Sink`](crate::Sink), restricted to its bounds without moving a pixel.
//! - **Memory** a list of active edges of the caller's for polygons; none for lines and triangles.
//! - **Cost** proportional to what is visible plus the number of edges, never to how large a
//!   coordinate is.
//!
//! **The rule.** A pixel belongs to an area when its centre, at halves, is inside. A centre
//! exactly on a left or top edge is inside, on a right or bottom edge outside. So areas that share
//! an edge share no pixel and leave none.
//!
//! ```text
//!     0   1   2   3   4
//!   0 ┌───┬───┬───┬───┐        · pixel centre
//!     │ · │ · │ · │ · │        ● corner of the area
//!   1 ├───●━━━━━━━━━━━●        # drawn: centre inside
//!     │ · ┃ # │ # │ #╱│
//!   2 ├───╂───┼───┼─╱─┤
//!     │ · ┃ # │ # ╱ · │
//!   3 └───●━━━━━━━┴───┘
//! ```

mod axes;
pub mod bresenham;
pub mod dda;
pub mod flood;
pub mod polygon;
pub mod scan;
pub mod stipple;
pub mod triangle;
