//! Clipping: keep the visible part. Lecture 3.
//!
//! - **Takes** lines with whole pixel ends ([`cohen_sutherland`]), polygons with any kind of
//!   vertex ([`sutherland_hodgman`]), points in clip space ([`volume`]).
//! - **Gives** the part on the inner side of the boundaries.
//! - **Memory** two lists of vertices of the caller's, for polygons; none for lines.
//! - **Cost** no division unless an intersection is needed, one 64-bit division a coordinate then.
//!
//! Clipping serves geometry: what lies behind the eye must go *before* the perspective divide. It is
//! not used before a two-dimensional fill or line: rounding the new ends would move the pixels of
//! almost every clipped line, and the rasterisers restrict themselves to the window exactly.

pub mod cohen_sutherland;
pub mod sutherland_hodgman;
pub mod volume;
