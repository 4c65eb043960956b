//! BSP trees: their order against depth buffers, their pieces, their limits, and solids against brute force.

#[path = "../exact/mod.rs"]
mod exact;
mod lecture;
mod pictures;
mod shapes;
mod solids;
mod trees;
