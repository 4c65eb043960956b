//! CIE XYZ, chromaticities and gamuts: colour as it is measured. Lecture 7.1.2 and 7.1.3.
//!
//! X, Y and Z are what a standard eye takes in; Y is the luminance. The chromaticity
//! `x = X/(X+Y+Z), y = Y/(X+Y+Z)` describes a colour without regard for its intensity. The colours that a
//! display can mix from three primaries are a triangle there, its *gamut*.
//!
//! ```text
//!   y │   ___
//!     │  /   \__           the horseshoe: colours of the spectrum
//!     │ |   G   \__
//!     │ |  / \     \__     the triangle: what a display with the primaries R, G, B can show
//!     │  \ | W `-R    \
//!     │   \ B`´  ___.-´
//!     │    `--´´
//!     └────────────────── x
//! ```
//!
//! White is D65 throughout, that of sRGB. XYZ is linear: it is made of [`Light`], never of codes.
//!
//! **Accuracy**: XYZ within 0.01 of a step of light; there and back every colour of 3 × 16 bits is the same.
//! Chromaticities are the nearest of 1/65536. **Cost**: nine multiplications of 64 bits a colour; chromaticities
//! divide. **Flash**: 72 bytes of coefficients.
//! Source: CIE 15; IEC 61966-2-1 for the primaries, from which the coefficients are computed exactly.

use crate::{
    colour::Light,
    error::describe,
    num::{divide_round, format_fixed, low_i32, saturate_i32, saturate_u16},
};

/// A tristimulus value: a light with 12 bits behind the point. 65535 is the luminance of white; ±524,288.
pub type Tristimulus = fixed::types::I20F12;

/// A colour in CIE XYZ.
///
/// ```
/// use aquatint::{Light, Xyz};
///
/// let orange = [255, 128, 0].map(Light::from_srgb);
/// let xyz = Xyz::from_linear(orange);
/// assert_eq!(xyz.to_linear(), Ok(orange));
/// assert_eq!(xyz.y.to_num::<i32>(), 24_052); // 37 % of the luminance of white
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Xyz {
    /// X, near to red.
    pub x: Tristimulus,
    /// Y, the luminance.
    pub y: Tristimulus,
    /// Z, near to blue.
    pub z: Tristimulus,
}

format_fixed! {
    impl[] |it: Xyz| "Xyz {{ x: {}, y: {}, z: {} }}", Fixed(it.x), Fixed(it.y), Fixed(it.z)
}

/// A colour that an sRGB display cannot show, with each channel clipped to what it can.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OutOfGamut(pub [Light; 3]);

describe! { OutOfGamut, Self(_) => "the display cannot show this colour"; }

impl Xyz {
    /// From linear light of the sRGB primaries (see [`Light::from_srgb`]).
    #[must_use]
    pub fn from_linear(rgb: [Light; 3]) -> Self {
        let channels = rgb.map(|light| i32::from(light.0));
        let [x, y, z] = FROM_LINEAR.map(|row| dot(row, channels));
        let tristimulus = |value: i64| Tristimulus::from_bits(low_i32((value + 0x800) >> 12));
        Self { x: tristimulus(x), y: tristimulus(y), z: tristimulus(z) }
    }

    /// The linear light of the sRGB primaries, to the nearest.
    ///
    /// # Errors
    /// [`OutOfGamut`] with the channels clipped, where one is below 0 or above 65535 after rounding.
    pub fn to_linear(self) -> Result<[Light; 3], OutOfGamut> {
        let values = [self.x, self.y, self.z].map(Tristimulus::to_bits);
        let channels = TO_LINEAR.map(|row| (dot(row, values) + (1 << 35)) >> 36);
        let lights = channels.map(|channel| Light(saturate_u16(channel)));
        let is_shown = channels.iter().all(|channel| (0..=0xFFFF).contains(channel));
        if is_shown { Ok(lights) } else { Err(OutOfGamut(lights)) }
    }

    /// The chromaticity; `None` for black and whatever else sums to nothing. Two divisions.
    #[must_use]
    pub fn chromaticity(self) -> Option<Chromaticity> {
        let [x, y, z] = [self.x, self.y, self.z].map(|value| i64::from(value.to_bits()));
        let sum = x + y + z;
        let part = |value: i64| saturate_u16(divide_round(value << 16, sum));
        (sum > 0).then(|| Chromaticity { x: part(x), y: part(y) })
    }
}

/// From linear light of sRGB to XYZ, in parts of 2²⁴.
const FROM_LINEAR: [[i32; 3]; 3] =
    [[6_918_770, 5_999_270, 3_027_965], [3_567_491, 11_998_539, 1_211_186], [324_317, 1_999_757, 15_947_283]];

/// Its inverse, in parts of 2²⁴.
const TO_LINEAR: [[i32; 3]; 3] =
    [[54_374_453, -25_793_010, -8_365_300], [-16_261_210, 31_473_512, 697_178], [933_318, -3_422_165, 17_733_039]];

fn dot(row: [i32; 3], column: [i32; 3]) -> i64 {
    row.into_iter().zip(column).map(|(weight, value)| i64::from(weight) * i64::from(value)).sum()
}

/// A place in the CIE 1931 diagram, in parts of 65536.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Chromaticity {
    /// The share of X.
    pub x: u16,
    /// The share of Y.
    pub y: u16,
}

impl Chromaticity {
    /// The white of sRGB, daylight.
    pub const D65: Self = Self::from_ten_thousandths(3127, 3290);

    /// From decimals as tables of primaries have them, to the nearest: 0.3127 is 3127. Up to 9999.
    #[must_use]
    pub const fn from_ten_thousandths(x: u16, y: u16) -> Self {
        Self { x: ten_thousandths(x), y: ten_thousandths(y) }
    }

    /// The colour of this chromaticity and a luminance, saturated; `None` where y is 0. Two divisions.
    #[must_use]
    pub fn with_luminance(self, luminance: Light) -> Option<Xyz> {
        let [x, y] = [self.x, self.y].map(i64::from);
        let luminance = i64::from(luminance.0) << 12;
        let share = |part: i64| Tristimulus::from_bits(saturate_i32(divide_round(luminance * part, y)));
        (y > 0).then(|| Xyz { x: share(x), y: share(y), z: share(0x1_0000 - x - y) })
    }
}

const fn ten_thousandths(value: u16) -> u16 {
    saturate_u16(divide_round((value as i64) << 16, 10_000))
}

/// The triangle of the colours that three primaries can be mixed to.
///
/// ```
/// use aquatint::{Chromaticity, Gamut};
///
/// let laser = Chromaticity::from_ten_thousandths(1700, 7970); // green of 532 nm
/// assert!(Gamut::SRGB.contains(Chromaticity::D65));
/// assert!(!Gamut::SRGB.contains(laser));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Gamut {
    /// The chromaticities of the primaries, in any order.
    pub primaries: [Chromaticity; 3],
}

impl Gamut {
    /// The primaries of sRGB and BT.709.
    pub const SRGB: Self = Self {
        primaries: [
            Chromaticity::from_ten_thousandths(6400, 3300),
            Chromaticity::from_ten_thousandths(3000, 6000),
            Chromaticity::from_ten_thousandths(1500, 600),
        ],
    };

    /// Whether a chromaticity is in the triangle; its edges and corners are. Six multiplications of 64 bits.
    ///
    /// A triangle without an area contains nothing. Whether the display can also give the *intensity* is for
    /// [`Xyz::to_linear`] to say.
    #[must_use]
    pub fn contains(&self, place: Chromaticity) -> bool {
        let [a, b, c] = self.primaries;
        let sides = [turn(a, b, place), turn(b, c, place), turn(c, a, place)];
        turn(a, b, c) != 0 && (sides.iter().all(|side| *side >= 0) || sides.iter().all(|side| *side <= 0))
    }
}

/// Twice the area of a triangle, positive if it runs anticlockwise.
fn turn(a: Chromaticity, b: Chromaticity, c: Chromaticity) -> i64 {
    let gap = |from: u16, to: u16| i64::from(to) - i64::from(from);
    gap(a.x, b.x) * gap(a.y, c.y) - gap(a.y, b.y) * gap(a.x, c.x)
}
