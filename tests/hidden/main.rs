//! Hidden surfaces: every method shows the same picture.

mod every;
mod lecture;
mod numbered;
mod object_space;
mod painter;
mod picture;
mod scanline;
mod scenes;
mod sizes;
