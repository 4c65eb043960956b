//! The colours of embedded-graphics as light: their codes are taken for sRGB, as everybody takes them.

use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, GrayColor, PixelColor, Rgb555, Rgb565, Rgb666,
    Rgb888, RgbColor,
};

use crate::{
    colour::Light,
    num::{high_u16, low_u8},
    palette::Rgb332,
};

/// A colour that stands for an amount of light: the codes of those of embedded-graphics are sRGB.
pub trait IntoLight: PixelColor {
    /// The luminance.
    fn into_light(self) -> Light;
}

impl IntoLight for Light {
    #[inline]
    fn into_light(self) -> Light {
        self
    }
}

impl IntoLight for BinaryColor {
    /// On is white.
    #[inline]
    fn into_light(self) -> Light {
        if self.is_on() { Light::WHITE } else { Light::BLACK }
    }
}

macro_rules! greys_into_light {
    ($($grey:ty: $step:literal),*) => { $(
        impl IntoLight for $grey {
            #[inline]
            fn into_light(self) -> Light {
                Light::from_srgb(self.luma() * $step)
            }
        }

        impl NearestToLight for $grey {
            /// The nearer in light of the two greys around it.
            #[inline]
            fn nearest_to(light: Light) -> Self {
                let darker = light.to_srgb() / $step;
                let brighter = darker.saturating_add(1).min(255 / $step);
                let [dark, bright] = [darker, brighter].map(|luma| Light::from_srgb(luma * $step).0);
                let is_bright = bright.abs_diff(light.0) <= dark.abs_diff(light.0);
                Self::new(if is_bright { brighter } else { darker })
            }
        }
    )* };
}

greys_into_light!(Gray2: 85, Gray4: 17, Gray8: 1);

/// A grey that can be chosen by its light.
pub(crate) trait NearestToLight {
    /// The grey whose light is the nearest.
    fn nearest_to(light: Light) -> Self;
}

impl NearestToLight for BinaryColor {
    #[inline]
    fn nearest_to(light: Light) -> Self {
        Self::from(light.0 >= 0x8000)
    }
}

/// The sRGB codes of a colour's channels.
pub trait IntoSrgb: PixelColor {
    /// Red, green and blue, 0 to 255.
    fn into_srgb(self) -> [u8; 3];
}

/// A colour that can be chosen by the sRGB codes of its channels.
pub(crate) trait NearestToSrgb {
    /// The colour whose channels are the nearest, each for itself.
    fn nearest_to(srgb: [u8; 3]) -> Self;
}

macro_rules! colours_into_light {
    ($($colour:ty),*) => { $(
        impl IntoSrgb for $colour {
            #[inline]
            fn into_srgb(self) -> [u8; 3] {
                [
                    in_eight_bits::<{ <$colour>::MAX_R }>(self.r()),
                    in_eight_bits::<{ <$colour>::MAX_G }>(self.g()),
                    in_eight_bits::<{ <$colour>::MAX_B }>(self.b()),
                ]
            }
        }

        impl NearestToSrgb for $colour {
            #[inline]
            fn nearest_to([red, green, blue]: [u8; 3]) -> Self {
                Self::new(
                    of_eight_bits::<{ <$colour>::MAX_R }>(red),
                    of_eight_bits::<{ <$colour>::MAX_G }>(green),
                    of_eight_bits::<{ <$colour>::MAX_B }>(blue),
                )
            }
        }

        impl IntoLight for $colour {
            #[inline]
            fn into_light(self) -> Light {
                Light::from_srgb_colour(self.into_srgb())
            }
        }
    )* };
}

colours_into_light!(Rgb332, Rgb555, Rgb565, Rgb666, Rgb888, Bgr555, Bgr565, Bgr666, Bgr888);

/// A channel of 0 to `MAX` as the nearest of 0 to 255.
#[inline]
const fn in_eight_bits<const MAX: u8>(channel: u8) -> u8 {
    let step = const { (0xFF_0000 + MAX as u32 / 2) / MAX as u32 };
    low_u8(high_u16(channel as u32 * step + 0x8000) as u32)
}

/// The nearest channel of 0 to `MAX`.
#[inline]
const fn of_eight_bits<const MAX: u8>(code: u8) -> u8 {
    // code · MAX / 255, rounded: exact for all bytes.
    low_u8((code as u32 * MAX as u32 * 257 + 0x8000) >> 16)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_colour_is_the_nearest_to_itself() {
        for code in 0..=255 {
            assert_eq!(<Gray8 as NearestToLight>::nearest_to(Gray8::new(code).into_light()), Gray8::new(code));
            let pale = Rgb332::nearest_to([code; 3]);
            assert_eq!(Rgb332::nearest_to(pale.into_srgb()), pale);
            let exact = |max: u32| low_u8((u32::from(code) * max * 2 + 255) / 510);
            assert_eq!((of_eight_bits::<31>(code), of_eight_bits::<63>(code)), (exact(31), exact(63)), "{code}");
        }
        for code in 0..4 {
            assert_eq!(<Gray2 as NearestToLight>::nearest_to(Gray2::new(code).into_light()), Gray2::new(code));
        }
    }

    #[test]
    fn greys_are_the_nearest_in_light() {
        for light in (0..=u16::MAX).map(Light) {
            let error = |grey: Gray4| grey.into_light().0.abs_diff(light.0);
            let best = (0..16).map(|code| error(Gray4::new(code))).min();
            assert_eq!(Some(error(<Gray4 as NearestToLight>::nearest_to(light))), best, "{light:?}");
        }
    }
}
