//! Hidden surfaces: every method shows the same picture.

mod picture;
mod scanline;
mod scenes;
