//! Geometry processing: where it lands on the screen, and in what light. Lecture 2.2.
//!
//! - **Takes** vertices of a mesh and the matrices of object and camera.
//! - **Gives** screen points with depth, facing, and light.
//! - **Memory** none.
//! - **Cost** a vertex: 12 multiplications to clip space, one division to the screen, 3
//!   multiplications for its light.
//!
//! ```text
//!   Model ─placement▶ World ─camera▶ View ─projection▶ Clip ─÷w▶ −1…1 ─viewport▶ pixels
//! ```

/// [`Angle`](angle::Angle), which every stage may use.
pub mod angle {
    pub use crate::angle::Angle;
}
pub mod face;
pub mod light;
pub mod projection;
pub mod transform;
pub mod viewport;
