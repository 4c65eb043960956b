//! Fragment processing: what the pixels of a shape look like. Lecture 1.5, 5.4 and 6.
//!
//! - **Takes** spans of pixels, and coverage to [blend]; places of a [texture].
//! - **Gives** colours, or light for a [`Dithered`](crate::Dithered) target.
//! - **Memory** none beyond the pattern or the picture that is lent; an accumulation buffer for [motion] blur.
//! - **Cost** a run of a [pattern] whose width divides 8 costs about what a plain run costs; a
//!   [gradient] some additions a pixel; a [picture] a read a pixel, a [texture] one or four.
//!
//! Patterns, pictures and gradients are [`Ink`](crate::Ink)s, so they fill any shape: `polygon.spans(…, &mut
//! Brush::new(target, ink))`, or as a [`FillStyle`](crate::FillStyle). An ink begins at its *anchor*: the
//! corner of the screen, unless it is moved along with an object.

pub mod blend;
pub mod gradient;
pub mod motion;
pub mod pattern;
pub mod picture;
pub mod shade;
pub mod texture;
pub mod toon;
