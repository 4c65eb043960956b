//! Tone: light, gamma and colour systems against exact arithmetic, over all input where that is possible.

mod colour_matrix;
mod exact;
mod gamma;
mod hexcone;
mod light;
mod panel;
mod xyz;
mod ycbcr;
