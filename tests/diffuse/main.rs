//! Error diffusion, scaling, and how good dithers are.

#[path = "../eye/mod.rs"]
mod eye;

mod curve;
mod flat;
mod oracle;
mod photo;
mod picture;
mod quality;
mod rows;
mod scale;
