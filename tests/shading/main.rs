//! Shading, tests of depth and sides of faces in small scenes, as pictures; and ramps, perspective and bands.

mod assemblies;
mod bands;
mod common;
mod decals;
mod depth_tests;
mod depths;
#[path = "../exact/mod.rs"]
mod exact;
mod lamps;
mod left_out;
mod mapped;
mod perspective;
mod ramps;
mod refused;
mod sides;
mod verbs;
