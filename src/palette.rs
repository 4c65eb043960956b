//! Colours that panels have and embedded-graphics has not.

use embedded_graphics::pixelcolor::{
    BinaryColor, PixelColor, Rgb565, Rgb888, RgbColor,
    raw::{RawData, RawU2, RawU4, RawU8},
};

/// Eight bits a pixel: three of red, three of green, two of blue.
///
/// A quarter of the memory of a 24-bit picture, half of that of [`Rgb565`]; SSD1331, SSD1351 and many
/// TFT controllers take it. The code is `0bRRR_GGG_BB`.
///
/// ```
/// use aquatint::{Frame, Rgb332, Rows};
/// use embedded_graphics::prelude::*;
///
/// let mut frame = Frame::<Rgb332, Rows, _>::with_array([0; 96 * 64], 96, 64).unwrap();
/// frame.clear(Rgb332::YELLOW)?;
/// assert_eq!(frame.bytes()[0], 0b111_111_00);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rgb332(u8);

impl Rgb332 {
    /// A colour of red and green from 0 to 7 and blue from 0 to 3; higher bits are ignored.
    #[must_use]
    pub const fn new(red: u8, green: u8, blue: u8) -> Self {
        Self((red & 7) << 5 | (green & 7) << 2 | (blue & 3))
    }
}

impl PixelColor for Rgb332 {
    type Raw = RawU8;
}

impl From<RawU8> for Rgb332 {
    fn from(code: RawU8) -> Self {
        Self(code.into_inner())
    }
}

impl From<Rgb332> for RawU8 {
    fn from(color: Rgb332) -> Self {
        Self::new(color.0)
    }
}

impl RgbColor for Rgb332 {
    const MAX_R: u8 = 7;
    const MAX_G: u8 = 7;
    const MAX_B: u8 = 3;
    const BLACK: Self = Self::new(0, 0, 0);
    const RED: Self = Self::new(7, 0, 0);
    const GREEN: Self = Self::new(0, 7, 0);
    const BLUE: Self = Self::new(0, 0, 3);
    const YELLOW: Self = Self::new(7, 7, 0);
    const MAGENTA: Self = Self::new(7, 0, 3);
    const CYAN: Self = Self::new(0, 7, 3);
    const WHITE: Self = Self::new(7, 7, 3);

    fn r(&self) -> u8 {
        self.0 >> 5
    }

    fn g(&self) -> u8 {
        self.0 >> 2 & 7
    }

    fn b(&self) -> u8 {
        self.0 & 3
    }
}

/// A channel of 0 to `from` as the nearest of 0 to `to`.
const fn rescaled(channel: u8, from: u8, to: u8) -> u8 {
    let [nearest, _] = ((channel as u16 * to as u16 + from as u16 / 2) / from as u16).to_le_bytes();
    nearest
}

impl From<Rgb888> for Rgb332 {
    /// The nearest colour, channel by channel.
    fn from(color: Rgb888) -> Self {
        Self::new(rescaled(color.r(), 255, 7), rescaled(color.g(), 255, 7), rescaled(color.b(), 255, 3))
    }
}

impl From<Rgb332> for Rgb888 {
    fn from(color: Rgb332) -> Self {
        Self::new(rescaled(color.r(), 7, 255), rescaled(color.g(), 7, 255), rescaled(color.b(), 3, 255))
    }
}

impl From<Rgb565> for Rgb332 {
    /// The nearest colour, channel by channel.
    fn from(color: Rgb565) -> Self {
        Self::new(rescaled(color.r(), 31, 7), rescaled(color.g(), 63, 7), rescaled(color.b(), 31, 3))
    }
}

impl From<Rgb332> for Rgb565 {
    fn from(color: Rgb332) -> Self {
        Self::new(rescaled(color.r(), 7, 31), rescaled(color.g(), 7, 63), rescaled(color.b(), 3, 31))
    }
}

impl From<BinaryColor> for Rgb332 {
    /// On is white.
    fn from(color: BinaryColor) -> Self {
        if color.is_on() { Self::WHITE } else { Self::BLACK }
    }
}

/// Electronic paper of three colours.
///
/// In [`Planes`](crate::Planes): plane 0 is the controller's black and white memory (1 is white), plane 1
/// that of the third colour (1 is coloured), as SSD1680 and its kin have them.
///
/// ```
/// use aquatint::{Frame, Planes, ThreeColor};
/// use embedded_graphics::{prelude::*, primitives::{PrimitiveStyle, Rectangle}};
///
/// let mut frame = Frame::<ThreeColor, Planes, _>::with_array([0; 4], 8, 2).unwrap();
/// frame.clear(ThreeColor::White)?;
/// let stamp = Rectangle::new(Point::new(0, 1), Size::new(4, 1));
/// stamp.into_styled(PrimitiveStyle::with_fill(ThreeColor::Chromatic)).draw(&mut frame)?;
/// assert_eq!(frame.plane(0), [0b1111_1111, 0b0000_1111]);
/// assert_eq!(frame.plane(1), [0b0000_0000, 0b1111_0000]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum ThreeColor {
    /// Black.
    Black,
    /// The paper.
    #[default]
    White,
    /// Red or yellow, as the panel has it.
    Chromatic,
}

impl PixelColor for ThreeColor {
    type Raw = RawU2;
}

impl From<RawU2> for ThreeColor {
    /// Where the plane of the third colour has a 1, the other does not count.
    fn from(code: RawU2) -> Self {
        match code.into_inner() {
            0 => Self::Black,
            1 => Self::White,
            _ => Self::Chromatic,
        }
    }
}

impl From<ThreeColor> for RawU2 {
    fn from(color: ThreeColor) -> Self {
        Self::new(match color {
            ThreeColor::Black => 0b00,
            ThreeColor::White => 0b01,
            ThreeColor::Chromatic => 0b10,
        })
    }
}

impl From<BinaryColor> for ThreeColor {
    /// On is ink, as drawings and texts of one bit mean it on paper.
    fn from(color: BinaryColor) -> Self {
        if color.is_on() { Self::Black } else { Self::White }
    }
}

/// A colour of electronic paper with several inks, by the codes of its controller.
macro_rules! inks {
    ($(#[$doc:meta])* $name:ident($raw:ident) { $($ink:ident = $code:literal),* }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub enum $name {
            $(
                #[doc = concat!("Code ", $code, ".")]
                $ink = $code,
            )*
            /// The paper, code 1.
            #[default]
            White = 1,
        }

        impl PixelColor for $name {
            type Raw = $raw;
        }

        impl From<$raw> for $name {
            /// Codes that the controller does not have are white.
            fn from(code: $raw) -> Self {
                match code.into_inner() {
                    $($code => Self::$ink,)*
                    _ => Self::White,
                }
            }
        }

        impl From<$name> for $raw {
            fn from(color: $name) -> Self {
                Self::new(color as u8)
            }
        }

        impl From<BinaryColor> for $name {
            /// On is ink, as drawings and texts of one bit mean it on paper.
            fn from(color: BinaryColor) -> Self {
                if color.is_on() { Self::Black } else { Self::White }
            }
        }
    };
}

inks! {
    /// Electronic paper of four colours, two bits a pixel, as JD79660 and its kin take them.
    FourColor(RawU2) { Black = 0, Yellow = 2, Red = 3 }
}

inks! {
    /// Electronic paper of six colours (Spectra 6, E6), four bits a pixel.
    SixColor(RawU4) { Black = 0, Yellow = 2, Red = 3, Blue = 5, Green = 6 }
}

inks! {
    /// Electronic paper of seven colours (`ACeP`, Gallery), four bits a pixel.
    SevenColor(RawU4) { Black = 0, Green = 2, Blue = 3, Red = 4, Yellow = 5, Orange = 6 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_code_of_332_survives_both_ways() {
        for code in 0..=255 {
            let color = Rgb332::from(RawU8::new(code));
            assert_eq!(RawU8::from(color).into_inner(), code);
            assert_eq!(Rgb332::from(Rgb888::from(color)), color);
            assert_eq!(Rgb332::from(Rgb565::from(color)), color);
            assert_eq!(Rgb332::new(color.r(), color.g(), color.b()), color);
        }
    }

    #[test]
    fn a_channel_becomes_the_nearest() {
        for value in 0..=255_u8 {
            let error = |level: u8, levels: f64| (f64::from(level) / levels - f64::from(value) / 255.0).abs();
            let color = Rgb332::from(Rgb888::new(value, value, value));
            for other in 0..8 {
                assert!(error(color.r(), 7.0) <= error(other, 7.0) + 1e-9, "{value}");
                assert!(error(color.b(), 3.0) <= error(other & 3, 3.0) + 1e-9, "{value}");
            }
        }
    }

    #[test]
    fn conversions_keep_black_and_white() {
        for (rgb, six) in [(Rgb888::BLACK, Rgb565::BLACK), (Rgb888::WHITE, Rgb565::WHITE)] {
            assert_eq!(Rgb888::from(Rgb332::from(rgb)), rgb);
            assert_eq!(Rgb565::from(Rgb332::from(six)), six);
            assert_eq!(Rgb565::from(Rgb332::from(rgb)), six);
        }
    }
}
