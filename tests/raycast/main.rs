//! Rays per pixel: shapes against doubles, hierarchies against lists, pictures, and the scenes of the other method.
#![expect(clippy::cast_precision_loss, clippy::cast_possible_truncation, reason = "oracles with a margin")]

#[path = "../exact/mod.rs"]
mod exact;

mod hierarchies;
mod meshes;
mod oracle;
mod pictures;
mod refused;
mod same_scene;
mod scenes;
mod shapes;
mod watertight;
