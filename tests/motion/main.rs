//! Motion blur: exposures of sub-frames, instants by the rank of a pixel, and how good both are.

#[macro_use]
#[path = "../reference/mod.rs"]
mod reference;

#[path = "../eye/mod.rs"]
mod eye;

mod exposure;
mod instants;
mod quality;
