//! Error diffusion, scaling, and how good dithers are.

mod curve;
mod flat;
mod oracle;
mod photo;
mod picture;
mod quality;
mod rows;
mod scale;
