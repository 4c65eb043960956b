//! Clipping: keep the visible part. Lecture 3.
//!
//! ```text
//!   line      ──▶ cohen_sutherland, liang_barsky ──▶ the line inside of a rectangle
//!   polygon   ──▶ sutherland_hodgman ──────────────▶ one polygon inside of a rectangle or a convex window
//!             ──▶ separate ────────────────────────▶ the same as separate polygons
//!   shape     ──▶ bounds ──────────────────────────▶ outside, inside or to be clipped
//! ```
//!
//! - **Takes** lines and points of whole pixels or of sixteenths, against a rectangle ([`window`]); polygons with
//!   any kind of vertex, against a rectangle or a convex window ([`convex`]); points in clip space ([`volume`]).
//! - **Gives** the part on the inner side of the boundaries, borders included.
//! - **Memory** a stage of the caller's for each boundary, for polygons; none for lines.
//! - **Cost** no division unless an intersection is needed, one 64-bit division a coordinate then.
//!
//! Clipping serves geometry: what lies behind the eye must go *before* the perspective divide. It is
//! not used before a two-dimensional fill or line: rounding the new ends would move the pixels of
//! almost every clipped line, and the rasterisers restrict themselves to the window exactly.

pub mod bounds;
pub mod cohen_sutherland;
pub mod convex;
mod crossing;
pub mod liang_barsky;
pub mod separate;
pub mod sutherland_hodgman;
pub mod volume;
pub mod window;
