//! Rasterisation: which pixels. Lecture 4.
//!
//! - **Takes** lines between pixels, whole-pixel circles and ellipses; polygons, paths, strokes and triangles
//!   with points on sixteenths of a pixel.
//! - **Gives** spans to a [`Sink`](crate::Sink), restricted to its bounds without moving a pixel; with their coverage
//!   where they are antialiased.
//! - **Memory** a list of edges of the caller's for outlines, and a row of cells for coverage; none for lines, circles and
//!   triangles.
//! - **Cost** proportional to what is visible plus the number of edges, never to how large a
//!   coordinate is.
//!
//! | from | to | by |
//! |---|---|---|
//! | two pixels | the line between them | [`bresenham`], [`dda`], with a pattern [`stipple`], as an area [`thick_line`] |
//! | a square, a rectangle of pixels | what it holds | [`circle`], [`ellipse`] |
//! | [`polygon`], [`path`], [`rounded_rectangle`], [`polyline`], arcs, [text](crate::Text), [SVG](crate::SvgPath) … | what they enclose | [`scan`] |
//! | the same | what a pen along them covers | [`stroke`], then [`scan`] |
//! | the same, and lines, circles, rectangles | how much of each pixel they cover | [`area`], with colours [`antialiased`] |
//! | three corners with attributes | ramps | [`triangle`] |
//! | two ends with attributes | ramps | [`ramp_line`] |
//! | a picture and a pixel of it | the region around it | [`flood`] |
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

mod active;
pub mod antialiased;
pub mod area;
mod axes;
pub mod bresenham;
pub mod circle;
mod conic;
pub mod dda;
mod edge_pair;
pub mod ellipse;
mod filled;
pub mod flood;
pub mod path;
pub mod polygon;
pub mod polyline;
pub mod ramp_line;
mod round;
pub mod rounded_rectangle;
pub mod scan;
pub mod stipple;
pub mod stroke;
mod text;
pub mod thick_line;
mod thin;
pub mod triangle;
pub(crate) mod walk;
