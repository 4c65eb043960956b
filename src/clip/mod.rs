//! Clipping: keep the visible part. Lecture 3.
//!
//! ```text
//!   line      ──▶ cohen_sutherland, liang_barsky ──▶ the line inside of a rectangle
//!   polygon   ──▶ sutherland_hodgman ──────────────▶ one polygon inside of a rectangle or a convex window
//!             ──▶ separate ────────────────────────▶ the same as separate polygons
//!   shape     ──▶ bounds ──────────────────────────▶ outside, inside or to be clipped
//!
//!   in space, before the perspective divide:
//!   line      ──▶ cohen_sutherland_3d, liang_barsky_3d ──▶ the line inside of the view, or of any planes
//!   polygon   ──▶ sutherland_hodgman_3d ───────────▶ the polygon inside of clip planes and the view
//!   shape     ──▶ bounding_box_3d, bounding_sphere ▶ outside, inside or to be clipped (frustum); collisions
//! ```
//!
//! - **Takes** lines and points of whole pixels or of sixteenths, against a rectangle ([`window`]); polygons with
//!   any kind of vertex, against a rectangle or a convex window ([`convex`]). Vertices in clip space ([`vertex`]), against
//!   the [`volume`] of the view and planes of any orientation ([`half_space`], [`clip_plane`]).
//! - **Gives** the part on the inner side of the boundaries, borders included.
//! - **Memory** a stage of the caller's for each boundary, for polygons; none for lines.
//! - **Cost** no division unless an intersection is needed, one 64-bit division a coordinate then.
//!
//! Clipping serves geometry: what lies behind the eye must go *before* the perspective divide. It is
//! not used before a two-dimensional fill or line: rounding the new ends would move the pixels of
//! almost every clipped line, and the rasterisers restrict themselves to the window exactly.

pub mod bounding_box_3d;
pub mod bounding_sphere;
pub mod bounds;
pub mod clip_plane;
pub mod cohen_sutherland;
pub mod cohen_sutherland_3d;
pub mod convex;
mod crossing;
pub mod frustum;
pub mod half_space;
pub mod liang_barsky;
pub mod liang_barsky_3d;
mod line_3d;
pub mod separate;
pub mod sutherland_hodgman;
pub mod sutherland_hodgman_3d;
pub mod vertex;
pub mod volume;
pub mod window;
