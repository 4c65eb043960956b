//! Hidden surfaces: who is in front. Lecture 5.
//!
//! - **Takes** fragments with a depth.
//! - **Gives** which of them are seen.
//! - **Memory** two bytes a pixel of the caller's, for the frame or any part of it.
//! - **Cost** one comparison a fragment.

pub mod depth;
