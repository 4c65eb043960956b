//! HLS: hue, lightness and saturation, on a double cone. Lecture 7.1.4.
//!
//! ```text
//!     L 510        white          the double cone from the side: a cube that stands on its black
//!                   ╱│╲           corner. Lightness goes up, saturation outwards (1 on the surface
//!     L 255  ──── ╱  │  ╲ ◀ hue   at every height), the hue around.
//!                 ╲  │  ╱
//!                   ╲│╱
//!     L 0          black
//! ```
//!
//! The numbers are chosen so that nothing is lost: all 16,777,216 colours come back exactly. That takes hues of
//! 1536 steps and a lightness of 511; no 8-bit lightness can do it.
//!
//! HLS is made of codes, for people who choose colours. Its lightness is neither light nor what the eye sees
//! (yellow and blue have the same); mix and compare in [`Light`](crate::Light).
//!
//! **Cost**: two divisions of 32 bits one way, none the other. **Flash**: no table.
//! Source: Foley, van Dam, Feiner, Hughes, *Computer Graphics*, 13.3.5, with red at 0 as everybody has it since;
//! Joblove and Greenberg, *Color Spaces for Computer Graphics*, SIGGRAPH 1978.

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};

use super::hexcone;
use crate::num::low_u8;

/// A colour by hue, lightness and saturation.
///
/// ```
/// use aquatint::Hls;
///
/// let orange = Hls::from_rgb([255, 128, 0]);
/// assert_eq!(orange, Hls { hue: 129, lightness: 255, saturation: 255 });
/// let pale = Hls { lightness: 400, ..orange };
/// assert_eq!(pale.to_rgb(), [255, 200, 145]);
/// assert_eq!(Hls { hue: orange.hue + 768, ..orange }.to_rgb(), [0, 127, 255]); // the opposite
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Hls {
    /// 0 to 1535 around the circle: 0 red, 256 yellow, 512 green, 768 cyan, 1024 blue, 1280 magenta; more
    /// goes around again. 0 for greys.
    pub hue: u16,
    /// The sum of the highest and the lowest channel: 0 black, 510 white; more counts as 510.
    pub lightness: u16,
    /// 0 grey to 255, the purest that there is at this lightness.
    pub saturation: u8,
}

impl Hls {
    /// From sRGB codes. Hue and saturation are the exact ones, rounded to the nearest. Two divisions.
    #[must_use]
    pub fn from_rgb(rgb: [u8; 3]) -> Self {
        let (low, high) = hexcone::extent(rgb);
        let lightness = u16::from(high) + u16::from(low);
        let saturation = hexcone::quotient(u32::from(high - low) * 255, purest(lightness));
        Self { hue: hexcone::hue(rgb), lightness, saturation: low_u8(saturation) }
    }

    /// The sRGB codes: exactly those that [`from_rgb`](Self::from_rgb) was given, and for other numbers
    /// within one code of the exact colour. No division.
    #[must_use]
    pub fn to_rgb(self) -> [u8; 3] {
        let lightness = self.lightness.min(510);
        let chroma = hexcone::divided_by_255(purest(lightness) * u32::from(self.saturation));
        // Half of lightness and chroma, to the nearest; a fraction of the chroma makes no difference to it. The
        // sum of highest and lowest is the lightness, so the lowest is as near.
        let high = (u32::from(lightness) + chroma).div_ceil(2);
        let low = u32::from(lightness).saturating_sub(high);
        hexcone::colour(self.hue, low_u8(low), low_u8(high))
    }
}

/// The chroma of the purest colours of a lightness: 255 half-way up, 0 at black and white.
fn purest(lightness: u16) -> u32 {
    u32::from(lightness.min(510_u16.saturating_sub(lightness)))
}

impl From<Rgb888> for Hls {
    fn from(colour: Rgb888) -> Self {
        Self::from_rgb([colour.r(), colour.g(), colour.b()])
    }
}

impl From<Hls> for Rgb888 {
    fn from(colour: Hls) -> Self {
        let [red, green, blue] = colour.to_rgb();
        Self::new(red, green, blue)
    }
}
