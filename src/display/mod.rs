//! Display: how the panel shows it. Lecture 7.
//!
//! - **Takes** light, or colours, in runs.
//! - **Gives** the bytes that the panel's controller expects, in its own order.
//! - **Memory** a frame of the caller's.
//! - **Cost** a run of one colour, or of one dithered shade, some instructions a byte; a row of 8-bit codes to one
//!   bit 3 to 5 instructions a pixel, a run of changing light 30 to 50.
//!
//! ```text
//!   light ──levels, dither──▶ codes ──layout──▶ bytes of the frame ──▶ bus
//! ```

pub mod blit;
pub mod diffuse;
pub mod dirty;
pub mod dither;
pub mod font;
pub mod frame;
pub mod halftone;
pub mod layout;
pub mod level;
pub mod palette;
pub mod reencode;
pub mod region;
pub mod scale;
pub mod transpose;
pub mod turned;
pub mod window;
