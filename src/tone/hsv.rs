//! HSV: hue, saturation and value, on a single hexcone. Lecture 7.1.1.
//!
//! ```text
//!      white in the middle        The highest channel is the value, so pure colours and white are
//!     ◀──────────────▶ V 255      on the same level; the saturation is how much of it the lowest
//!       ╲          ╱              channel lacks.
//!         ╲      ╱
//!           ╲  ╱
//!          black      V 0
//! ```
//!
//! All 16,777,216 colours come back exactly. Like [HLS](super::hls) it is made of codes, for choosing colours.
//!
//! **Cost**: two divisions of 32 bits one way, none the other. **Flash**: no table.
//! Source: Smith, *Color Gamut Transform Pairs*, SIGGRAPH 1978.

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};

use super::hexcone;
use crate::num::low_u8;

/// A colour by hue, saturation and value.
///
/// ```
/// use aquatint::Hsv;
///
/// let sky = Hsv::from_rgb([64, 160, 255]);
/// assert_eq!(sky, Hsv { hue: 895, saturation: 191, value: 255 });
/// assert_eq!(sky.to_rgb(), [64, 160, 255]);
/// assert_eq!(Hsv { value: 128, ..sky }.to_rgb(), [32, 80, 128]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Hsv {
    /// 0 to 1535 around the circle: 0 red, 256 yellow, 512 green, 768 cyan, 1024 blue, 1280 magenta; more
    /// goes around again. 0 for greys.
    pub hue: u16,
    /// 0 grey to 255 pure.
    pub saturation: u8,
    /// The highest channel.
    pub value: u8,
}

impl Hsv {
    /// From sRGB codes. Hue and saturation are the exact ones, rounded to the nearest. Two divisions.
    #[must_use]
    pub fn from_rgb(rgb: [u8; 3]) -> Self {
        let (low, value) = hexcone::extent(rgb);
        let saturation = hexcone::quotient(u32::from(value - low) * 255, value.into());
        Self { hue: hexcone::hue(rgb), saturation: low_u8(saturation), value }
    }

    /// The sRGB codes: exactly those that [`from_rgb`](Self::from_rgb) was given, and for other numbers
    /// within one code of the exact colour. No division.
    #[must_use]
    pub fn to_rgb(self) -> [u8; 3] {
        let chroma = hexcone::divided_by_255(u32::from(self.value) * u32::from(self.saturation) + 127);
        hexcone::colour(self.hue, self.value.saturating_sub(low_u8(chroma)), self.value)
    }
}

impl From<Rgb888> for Hsv {
    fn from(colour: Rgb888) -> Self {
        Self::from_rgb([colour.r(), colour.g(), colour.b()])
    }
}

impl From<Hsv> for Rgb888 {
    fn from(colour: Hsv) -> Self {
        let [red, green, blue] = colour.to_rgb();
        Self::new(red, green, blue)
    }
}
