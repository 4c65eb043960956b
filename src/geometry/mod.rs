//! Geometry processing: where it lands on the screen, and in what light. Lecture 2.2.
//!
//! - **Takes** vertices of a mesh and the matrices of object and camera.
//! - **Gives** screen points with depth, facing, light, and fog.
//! - **Memory** none.
//! - **Cost** a vertex, in instructions of a Cortex-M0: 171 to clip space, 569 to the screen (of which one division
//!   takes 192), 62 for the light of one [lamp](light::Lamp).
//!
//! ```text
//!   Model ─placement▶ World ─camera▶ View ─projection▶ Clip ─÷w▶ −1…1 ─viewport▶ pixels
//! ```
//!
//! All roundings of that chain together, on a view of 400 × 240 pixels with a field of 60°, against floating
//! point; half a sixteenth of each is the last rounding to sixteenths of a pixel:
//!
//! | near plane | place, sixteenths of a pixel | depth, of 65536 |
//! |---|---|---|
//! | ⅛ | 1.75 | 14 |
//! | ½ | 0.88 | 4 |
//! | 1 | 0.75 | 2 |

/// [`Angle`](angle::Angle), which every stage may use.
pub mod angle {
    pub use crate::angle::Angle;
}
pub mod face;
/// [`Fog`](fog::Fog), which every stage may use.
pub mod fog {
    pub use crate::fog::{BadFog, Fog};
}
pub mod inverse;
pub mod light;
pub mod lights;
pub mod projection;
pub mod quaternion;
pub mod transform;
pub mod viewport;
