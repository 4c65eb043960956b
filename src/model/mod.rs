//! Modelling: what is drawn. Lecture 2.1.
//!
//! - **Takes** arrays and fonts that may live in flash.
//! - **Gives** a [`Mesh`](mesh::Mesh) whose indices are known to be right, of triangles, strips, fans or polygons;
//!   ready-made [solids] and [round ones](revolved); [typefaces](crate::Typeface) for
//!   [text](crate::text).
//! - **Memory** none: everything is borrowed.
//! - **Cost** one look at every index, at compile time for a constant. Of a font only the beginnings of its tables.

pub mod assembly;
pub mod hershey;
pub mod mesh;
pub mod revolved;
pub mod solids;
#[cfg(feature = "ttf")]
pub mod ttf;
