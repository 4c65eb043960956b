//! Tone: what becomes of light and colour between the scene and the panel. Lecture 7.
//!
//! - **Takes** codes of pictures, light, or numbers of some colour system.
//! - **Gives** light, or codes of another system.
//! - **Memory** none; tables in flash, as each item says, only if it is used.
//! - **Cost** integers throughout. [Gamma](gamma) and the [colour matrix](colour_matrix) divide nothing and are
//!   meant for every pixel; conversions to [HLS](hls), [HSV](hsv) and [chromaticities](xyz) divide, for set-up.
//!
//! # Light, not codes
//!
//! The codes of a picture are spaced for the eye, which sees ratios: the step from 10 to 11 and that from 200 to
//! 201 look about alike, but the second is eleven times the light. A panel, a camera and a half-covered pixel
//! obey sums of *light*. The mean of black and white is half the light, which is code 188; the mean of the codes,
//! 128, is 22 % of it. So edges that are blended on codes look ragged and thin, blurred pictures grow dark at their
//! seams, and a dither that takes codes for light shows a mid-grey more than twice as bright as it is.
//!
//! ```text
//!   light 1 ┤                    ▄█
//!           │                 ▄▀▀
//!         ½ ┤─────────────▄▄▀▀│          code 188: half of the light
//!           │        ▄▄▄▀▀    │
//!      0.22 ┤▄▄▄▄▀▀▀▀│        │          code 128: 22 %
//!           └────────┴────────┴──────
//!           0       128      188    255
//! ```
//!
//! Therefore everything here works on [`Light`](crate::Light) unless the system itself is defined on codes (HLS,
//! HSV, luma and Y′CbCr are), and whatever takes codes for light says so: its name begins with `naive`.

pub mod colour_matrix;
mod filter;
pub mod gamma;
mod hexcone;
pub mod hls;
pub mod hsv;
pub mod luma;
pub mod panel;
pub mod xyz;
pub mod ycbcr;
