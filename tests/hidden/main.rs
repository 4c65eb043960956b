//! Hidden surfaces: every method shows the same picture.

mod lecture;
mod object_space;
mod painter;
mod picture;
mod scanline;
mod scenes;
