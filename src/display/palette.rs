//! Colour panels: dither in each channel, or to a few inks.
//!
//! A panel of `Rgb332` has levels in each channel, and each is dithered by itself in linear light, by the same mask.
//! Electronic paper has three to seven inks, which have to be mixed together:
//!
//! 1. The picture's range is moved into that of the panel: black to its black, white to its white, as measured.
//! 2. For a colour, sixteen inks are chosen one after the other, each so that the sum of those chosen comes nearest
//!    to as many times the colour (in linear light, green weighing four, red two, blue one).
//! 3. The sixteen are sorted from dark to bright. A pixel takes the one that its threshold points at.
//!
//! ```text
//!   orange = 16 × │ red red red red red red red │ yellow yellow yellow … │     threshold ½ ──▶ yellow
//! ```
//!
//! So the mean of a 4 × 4 cell is the best mixture that greedy choice finds, black is all black, and white is all
//! white. It is the pattern dithering of T. Knoll (US patent 6,606,166, expired) in linear light.
//!
//! - **Takes** colours with sRGB codes.
//! - **Gives** the panel's colours.
//! - **Memory** 12 bytes an ink.
//! - **Cost** a channel that of a grey; a colour other than the last one 16 × 15 instructions an ink, the same colour
//!   again about 15.

use core::marker::PhantomData;

use embedded_graphics::pixelcolor::{PixelColor, Rgb565};

use crate::{
    colour::Light,
    display::{
        dither::{IntoSrgb, Quantise},
        level::{Levels, Shades},
    },
    num::low_u8,
    palette::{FourColor, Rgb332, SevenColor, SixColor, ThreeColor},
};

/// A colour with a code for each channel.
pub trait FromChannels: PixelColor {
    /// Levels of the channels, spaced like sRGB codes.
    const SRGB: [Levels<'static>; 3];

    /// From the codes of red, green and blue.
    fn from_channels(codes: [u8; 3]) -> Self;
}

impl FromChannels for Rgb332 {
    const SRGB: [Levels<'static>; 3] = [Levels::SRGB_8, Levels::SRGB_8, Levels::SRGB_4];

    fn from_channels([red, green, blue]: [u8; 3]) -> Self {
        Self::new(red, green, blue)
    }
}

impl FromChannels for Rgb565 {
    const SRGB: [Levels<'static>; 3] = [Levels::SRGB_32, Levels::SRGB_64, Levels::SRGB_32];

    fn from_channels([red, green, blue]: [u8; 3]) -> Self {
        Self::new(red, green, blue)
    }
}

/// Dithers each channel of colours `S` by itself.
///
/// ```
/// use aquatint::{BAYER_4X4, ChannelLevels, DitheredDrawTarget, Frame, Rgb332, Rows};
/// use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
///
/// let mut frame = Frame::<Rgb332, Rows, _>::with_array([0; 96 * 64], 96, 64).unwrap();
/// let mut display = DitheredDrawTarget::new(&mut frame, ChannelLevels::<Rgb888>::srgb::<Rgb332>(), BAYER_4X4);
/// display.clear(Rgb888::new(200, 100, 50))?;
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ChannelLevels<'l, S> {
    channels: [Shades<'l>; 3],
    source: PhantomData<S>,
}

impl<'l, S: IntoSrgb> ChannelLevels<'l, S> {
    /// For a panel whose channels have these levels, as measured.
    #[must_use]
    pub fn new(levels: [Levels<'l>; 3]) -> Self {
        Self { channels: levels.map(Shades::new), source: PhantomData }
    }

    /// For a panel of colours `C` that imitates a monitor.
    #[must_use]
    pub fn srgb<C: FromChannels>() -> Self {
        Self::new(C::SRGB)
    }
}

impl<S: IntoSrgb, C: FromChannels> Quantise<C> for ChannelLevels<'_, S> {
    type From = S;

    #[inline]
    fn quantise(&mut self, color: S, threshold: u16) -> C {
        let [red, green, blue] = &mut self.channels;
        let [r, g, b] = color.into_srgb().map(Light::from_srgb);
        C::from_channels([red.code(r, threshold), green.code(g, threshold), blue.code(b, threshold)])
    }
}

/// The inks of a panel, 2 to 16, with the sRGB colours that they have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Palette<C, const N: usize> {
    /// From dark to bright.
    inks: [Ink<C>; N],
    darkest: C,
    /// The darkest and the brightest.
    range: [[u16; 3]; 2],
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Ink<C> {
    color: C,
    /// In 1024ths, so that sums of sixteen have squares of 32 bits.
    lights: [i32; 3],
}

impl<C: Copy, const N: usize> Palette<C, N> {
    /// The panel's colours, and what they look like in sRGB, as measured or as the maker says.
    #[must_use]
    pub const fn new(inks: [(C, [u8; 3]); N]) -> Self {
        const { assert!(N >= 2 && N <= 16, "inks are 2 to 16") };
        let (mut inks, mut at) = (inks, 1);
        // Insertion sort by luminance.
        while at < N {
            let mut to = at;
            while to > 0 && luminance(inks[to].1) < luminance(inks[to - 1].1) {
                (inks[to], inks[to - 1]) = (inks[to - 1], inks[to]);
                to -= 1;
            }
            at += 1;
        }
        let range = [lights(inks[0].1), lights(inks[N - 1].1)];
        let (mut sorted, mut at) = ([Ink { color: inks[0].0, lights: [0; 3] }; N], 0);
        while at < N {
            sorted[at] = Ink { color: inks[at].0, lights: coarse(lights(inks[at].1)) };
            at += 1;
        }
        Self { inks: sorted, darkest: inks[0].0, range }
    }

    /// A colour in the range of the panel, in 1024ths.
    #[inline]
    fn in_range(&self, srgb: [u8; 3]) -> [i32; 3] {
        let [blacks, whites] = self.range;
        let mut ends = blacks.into_iter().zip(whites);
        coarse(srgb.map(|code| {
            let (black, white) = ends.next().unwrap_or((0, u16::MAX));
            // 0 to 65536, so that white is white.
            let share = i64::from(Light::from_srgb(code).0);
            let share = share + (share >> 15);
            crate::num::saturate_u16(i64::from(black) + (((i64::from(white) - i64::from(black)) * share) >> 16))
        }))
    }

    /// How many of sixteen pixels each ink and those before it cover.
    fn shares(&self, srgb: [u8; 3]) -> [u8; N] {
        let (meant, mut counts, mut missing) = (self.in_range(srgb), [0_u8; N], [0_i32; 3]);
        for _ in 0..16 {
            missing = plus(missing, meant, 1);
            let distances = self.inks.iter().map(|ink| distance(plus(missing, ink.lights, -1)));
            // The first of the nearest.
            let (nearest, _) = distances.enumerate().min_by_key(|&(_, far)| far).unwrap_or_default();
            if let (Some(count), Some(ink)) = (counts.get_mut(nearest), self.inks.get(nearest)) {
                *count += 1;
                missing = plus(missing, ink.lights, -1);
            }
        }
        let mut sum = 0;
        counts.map(|count| {
            sum += count;
            sum
        })
    }
}

/// Black, white and red, as they are named; three-colour panels are darker and differ from each other.
pub const NOMINAL_RED: Palette<ThreeColor, 3> = Palette::new([
    (ThreeColor::Black, [0, 0, 0]),
    (ThreeColor::White, [255, 255, 255]),
    (ThreeColor::Chromatic, [255, 0, 0]),
]);

/// Black, white and yellow, as they are named.
pub const NOMINAL_YELLOW: Palette<ThreeColor, 3> = Palette::new([
    (ThreeColor::Black, [0, 0, 0]),
    (ThreeColor::White, [255, 255, 255]),
    (ThreeColor::Chromatic, [255, 255, 0]),
]);

/// Four inks, as they are named.
pub const NOMINAL_4: Palette<FourColor, 4> = Palette::new([
    (FourColor::Black, [0, 0, 0]),
    (FourColor::White, [255, 255, 255]),
    (FourColor::Yellow, [255, 255, 0]),
    (FourColor::Red, [255, 0, 0]),
]);

/// Six inks of a Spectra 6 panel of 7.3 inches, measured with a camera against paper white (`OpenDisplay`,
/// epaper-dithering).
pub const SPECTRA_6: Palette<SixColor, 6> = Palette::new([
    (SixColor::Black, [26, 13, 35]),
    (SixColor::White, [185, 202, 205]),
    (SixColor::Yellow, [202, 184, 0]),
    (SixColor::Red, [121, 9, 0]),
    (SixColor::Blue, [0, 69, 139]),
    (SixColor::Green, [40, 82, 57]),
]);

/// Seven inks, as they are named.
pub const NOMINAL_7: Palette<SevenColor, 7> = Palette::new([
    (SevenColor::Black, [0, 0, 0]),
    (SevenColor::White, [255, 255, 255]),
    (SevenColor::Green, [0, 255, 0]),
    (SevenColor::Blue, [0, 0, 255]),
    (SevenColor::Red, [255, 0, 0]),
    (SevenColor::Yellow, [255, 255, 0]),
    (SevenColor::Orange, [255, 128, 0]),
]);

const fn lights([red, green, blue]: [u8; 3]) -> [u16; 3] {
    [Light::from_srgb(red).0, Light::from_srgb(green).0, Light::from_srgb(blue).0]
}

const fn luminance(srgb: [u8; 3]) -> u16 {
    Light::from_srgb_colour(srgb).0
}

/// 1024ths.
const fn coarse([red, green, blue]: [u16; 3]) -> [i32; 3] {
    [(red >> 6) as i32, (green >> 6) as i32, (blue >> 6) as i32]
}

#[inline]
const fn plus([r, g, b]: [i32; 3], [red, green, blue]: [i32; 3], times: i32) -> [i32; 3] {
    [r + times * red, g + times * green, b + times * blue]
}

/// At most 7 × (16 × 1024)², which 32 bits hold.
#[inline]
const fn distance([red, green, blue]: [i32; 3]) -> u32 {
    (2 * red * red).unsigned_abs() + (4 * green * green).unsigned_abs() + (blue * blue).unsigned_abs()
}

/// Mixes the inks of a palette to colours `S`.
///
/// ```
/// use aquatint::{BAYER_4X4, DitheredDrawTarget, Frame, InkMix, Rows, SixColor, display::palette::SPECTRA_6};
/// use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
///
/// let mut frame = Frame::<SixColor, Rows, _>::with_array([0; 8 * 8 / 2], 8, 8).unwrap();
/// let mut display = DitheredDrawTarget::new(&mut frame, InkMix::<Rgb888, _, 6>::new(&SPECTRA_6), BAYER_4X4);
/// display.clear(Rgb888::WHITE)?;
/// assert_eq!(frame.bytes(), [0x11; 32]); // white is code 1
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct InkMix<'p, S, C, const N: usize> {
    palette: &'p Palette<C, N>,
    /// The last colour, and how many of sixteen pixels each ink and those before it cover.
    last: [u8; 3],
    shares: [u8; N],
    source: PhantomData<S>,
}

impl<'p, S: IntoSrgb, C: Copy, const N: usize> InkMix<'p, S, C, N> {
    /// With the inks of a palette.
    #[must_use]
    pub fn new(palette: &'p Palette<C, N>) -> Self {
        // Black is the darkest ink, which is the first.
        Self { palette, last: [0; 3], shares: [16; N], source: PhantomData }
    }
}

impl<S: IntoSrgb, C: Copy, const N: usize> Quantise<C> for InkMix<'_, S, C, N> {
    type From = S;

    fn quantise(&mut self, color: S, threshold: u16) -> C {
        let srgb = color.into_srgb();
        if srgb != self.last {
            (self.last, self.shares) = (srgb, self.palette.shares(srgb));
        }
        // Low thresholds turn bright first.
        let place = low_u8(15 - (u32::from(threshold) >> 12));
        let ink = self.shares.iter().position(|&share| place < share).unwrap_or(0);
        self.palette.inks.get(ink).map_or(self.palette.darkest, |ink| ink.color)
    }
}
