//! Blending: what is drawn and what is there become one colour, in light. Lecture 1.5, 6.4 and 7.3.
//!
//! ```text
//!   drawn ──────────┐
//!                   ├──▶ mode ──▶ so much of it as is covered, the rest of what was there
//!   there already ──┘
//! ```
//!
//! A pixel that is half covered by white on black gives half of the light, which is sRGB code 188 and not 128. So
//! colours are decoded, mixed in light, and encoded again.

use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, PixelColor, Rgb555, Rgb565, Rgb666, Rgb888,
};

use crate::{
    colour::Light,
    coverage::Coverage,
    num::{high_u16, saturate_u16},
    palette::Rgb332,
    srgb::{IntoLight, IntoSrgb, NearestToLight, NearestToSrgb},
};

/// How a colour is combined with the one that is there.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum BlendMode {
    /// It covers what is there: the default. With parts of pixels it is alpha blending.
    #[default]
    Over,
    /// Lights are added, up to white: shapes that share a pixel, each with its own part of the area, are averaged by
    /// area on black.
    Add,
    /// Lights are multiplied, white being 1: filters, shadows.
    Multiply,
    /// Darknesses are multiplied: never darker than either.
    Screen,
    /// The darker of both.
    Darken,
    /// The brighter of both.
    Lighten,
}

impl BlendMode {
    /// A light combined with the light that is there, as far as the pixel is covered.
    ///
    /// ```
    /// use aquatint::{BlendMode, Coverage, Light};
    ///
    /// let (half, grey) = (Coverage::new(16_384), Light(20_000));
    /// assert_eq!(BlendMode::Over.mix(Light::WHITE, Light::BLACK, half), Light(32_768));
    /// assert_eq!(BlendMode::Add.mix(grey, grey, half), Light(30_000));
    /// assert_eq!(BlendMode::Multiply.mix(Light::WHITE, grey, Coverage::FULL), grey);
    /// ```
    #[inline]
    #[must_use]
    pub const fn mix(self, drawn: Light, under: Light, coverage: Coverage) -> Light {
        let combined = match self {
            Self::Over => drawn,
            Self::Add => {
                // By the part that is covered, not the sum cut off at white.
                let part = part_of(drawn.0 as i32, coverage);
                return Light(under.0.saturating_add(saturate_u16(part as i64)));
            }
            Self::Multiply => Light(product(drawn.0, under.0)),
            Self::Screen => Light(!product(!drawn.0, !under.0)),
            Self::Darken => Light(if drawn.0 < under.0 { drawn.0 } else { under.0 }),
            Self::Lighten => Light(if drawn.0 > under.0 { drawn.0 } else { under.0 }),
        };
        let change = part_of(combined.0 as i32 - under.0 as i32, coverage);
        Light(saturate_u16(under.0 as i64 + change as i64))
    }
}

/// A part of a difference of lights, rounded to the nearest.
#[inline]
const fn part_of(difference: i32, coverage: Coverage) -> i32 {
    // At most 65535 · 2¹⁵ and a half.
    (difference * coverage.parts() as i32 + (1 << 14)) >> 15
}

/// The product where 65535 is 1, rounded to the nearest.
#[inline]
const fn product(a: u16, b: u16) -> u16 {
    let product = a as u32 * b as u32;
    // p / 65535, by p / 65536 · (1 + 1/65536).
    high_u16(product.saturating_add(product >> 16).saturating_add(0x8000))
}

/// A colour that can be mixed with another.
///
/// Greys and RGB colours of embedded-graphics are decoded as sRGB and encoded again, to the grey whose light is the
/// nearest, or channel by channel. For a panel with other levels, or to dither what is mixed, draw [`Light`] on a
/// [`Dithered`](crate::Dithered) target.
pub trait Blend: PixelColor {
    /// This colour, drawn over another one, where it covers so much of the pixel.
    #[must_use]
    fn blend(self, under: Self, mode: BlendMode, coverage: Coverage) -> Self;
}

impl Blend for Light {
    #[inline]
    fn blend(self, under: Self, mode: BlendMode, coverage: Coverage) -> Self {
        mode.mix(self, under, coverage)
    }
}

macro_rules! greys {
    ($($grey:ty),*) => { $(
        impl Blend for $grey {
            #[inline]
            fn blend(self, under: Self, mode: BlendMode, coverage: Coverage) -> Self {
                Self::nearest_to(mode.mix(self.into_light(), under.into_light(), coverage))
            }
        }
    )* };
}

greys!(BinaryColor, Gray2, Gray4, Gray8);

macro_rules! colours {
    ($($colour:ty),*) => { $(
        impl Blend for $colour {
            #[inline]
            fn blend(self, under: Self, mode: BlendMode, coverage: Coverage) -> Self {
                let [red, green, blue] = self.into_srgb();
                let [red_under, green_under, blue_under] = under.into_srgb();
                let mix = |drawn, under| mode.mix(Light::from_srgb(drawn), Light::from_srgb(under), coverage).to_srgb();
                Self::nearest_to([mix(red, red_under), mix(green, green_under), mix(blue, blue_under)])
            }
        }
    )* };
}

colours!(Rgb332, Rgb555, Rgb565, Rgb666, Rgb888, Bgr555, Bgr565, Bgr666, Bgr888);

/// A colour that covers a part of a pixel: what antialiased shapes are drawn in, on a
/// [`Blended`](crate::Blended) target.
///
/// ```
/// use aquatint::{Alpha, Coverage};
/// use embedded_graphics::pixelcolor::Gray4;
///
/// let glass = Alpha::new(Gray4::new(15), Coverage::from_byte(128));
/// assert_eq!(Alpha::from(Gray4::new(3)), Alpha::new(Gray4::new(3), Coverage::FULL));
/// # assert_ne!(glass.coverage, Coverage::FULL);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Alpha<C> {
    /// The colour.
    pub color: C,
    /// How much of the pixel it takes, or how little one sees through it.
    pub coverage: Coverage,
}

impl<C> Alpha<C> {
    /// A colour and how much of a pixel it covers.
    #[inline]
    #[must_use]
    pub const fn new(color: C, coverage: Coverage) -> Self {
        Self { color, coverage }
    }
}

impl<C> From<C> for Alpha<C> {
    fn from(color: C) -> Self {
        Self { color, coverage: Coverage::FULL }
    }
}

impl<C: PixelColor> PixelColor for Alpha<C> {
    type Raw = ();
}

#[cfg(test)]
mod tests {
    use super::*;
    use embedded_graphics::pixelcolor::GrayColor;

    const MODES: [BlendMode; 6] = [
        BlendMode::Over,
        BlendMode::Add,
        BlendMode::Multiply,
        BlendMode::Screen,
        BlendMode::Darken,
        BlendMode::Lighten,
    ];

    /// The mode in real numbers.
    fn exact(mode: BlendMode, [drawn, under]: [f64; 2], coverage: f64) -> f64 {
        let combined = match mode {
            BlendMode::Over => drawn,
            BlendMode::Add => return (under + drawn * coverage).min(1.0),
            BlendMode::Multiply => drawn * under,
            BlendMode::Screen => drawn + under - drawn * under,
            BlendMode::Darken => drawn.min(under),
            BlendMode::Lighten => drawn.max(under),
        };
        under + (combined - under) * coverage
    }

    #[test]
    fn lights_are_mixed_to_the_nearest() {
        for mode in MODES {
            for drawn in (0..=u16::MAX).step_by(257 * 5) {
                for under in (0..=u16::MAX).step_by(257 * 3) {
                    for parts in [0, 1, 100, 8_192, 16_384, 32_767, 32_768] {
                        let ours = mode.mix(Light(drawn), Light(under), Coverage::new(parts)).0;
                        let lights = [drawn, under].map(|light| f64::from(light) / 65_535.0);
                        let exact = exact(mode, lights, f64::from(parts) / 32_768.0) * 65_535.0;
                        assert!(
                            (f64::from(ours) - exact).abs() <= 1.01,
                            "{mode:?} {drawn} {under} {parts}: {ours} {exact}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn nothing_changes_nothing_and_all_covers_all() {
        for code in 0..=255 {
            for (a, b) in [(Gray8::new(code), Gray8::new(255 - code)), (Gray8::new(code), Gray8::BLACK)] {
                assert_eq!(a.blend(b, BlendMode::Over, Coverage::NONE), b);
                assert_eq!(a.blend(b, BlendMode::Over, Coverage::FULL), a);
            }
            let (a, b) = (Rgb888::new(code, 7, 255 - code), Rgb888::new(90, code, 1));
            assert_eq!(a.blend(b, BlendMode::Over, Coverage::NONE), b);
            assert_eq!(a.blend(b, BlendMode::Over, Coverage::FULL), a);
        }
    }

    #[test]
    fn half_of_the_light_is_code_188() {
        let half = Coverage::new(1 << 14);
        assert_eq!(Gray8::WHITE.blend(Gray8::BLACK, BlendMode::Over, half), Gray8::new(188));
        assert_eq!(Gray8::BLACK.blend(Gray8::WHITE, BlendMode::Over, half), Gray8::new(188));
        let red = Rgb888::new(255, 0, 0).blend(Rgb888::new(0, 0, 255), BlendMode::Over, half);
        assert_eq!(red, Rgb888::new(188, 0, 188));
        assert_eq!(BinaryColor::On.blend(BinaryColor::Off, BlendMode::Over, half), BinaryColor::On);
    }
}
