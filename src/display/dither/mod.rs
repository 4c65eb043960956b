//! Ordered dither: 17 shades from 16 pixels, and more. Lecture 7.4.
//!
//! Every pixel has a threshold by its place on the screen. A light between two levels of the panel, `t` of the way
//! from the darker to the brighter, shows the brighter one where `t` exceeds the threshold: on average over some
//! pixels that is the light that was meant.
//!
//! ```text
//!    0  8  2 10
//!   12  4 14  6        4 × 4: on where t > (rank + ½) / 16
//!    3 11  1  9
//!   15  7 13  5
//! ```
//!
//! | mask | shades | flash | looks |
//! |---|---|---|---|
//! | [`BAYER_2X2`] … [`BAYER_16X16`] | 5, 17, 65, 257 | 4 … 256 bytes | even, with a grid |
//! | [`BLUE_NOISE_16`], [`BLUE_NOISE_64`] | 257 | 256 bytes, 4 KB | grain, no grid |
//! | [`R2Noise`] | 65536 | none | between both |
//! | [halftone](crate::display::halftone) | 17 … 65 | 16 … 64 bytes | dots of different sizes |
//! | [`HATCH_8X8`] … [`CROSS_HATCH_16X16`] | 65, 257 | 64, 256 bytes | lines of a pen |
//! | [`RankMask::new`] | what you bring | | |
//!
//! The thresholds are fixed to the screen. So bands, tiles and partial redraws agree to the pixel, in any order, and
//! a change repaints nothing outside of itself. Tones are linear in light. Where greys lie near black, 17 shades
//! are few: with 4 × 4 on one bit, sRGB codes below 50 are black, with 8 × 8 those below 22.
//!
//! - **Takes** light: [`Dithered`]; colours of embedded-graphics: [`DitheredDrawTarget`]; rows of 8-bit codes:
//!   [`CodeMask`], the fastest.
//! - **Gives** codes to any [`Target`].
//! - **Memory** none but the mask's.
//! - **Cost** integers; no division.

mod blue_noise;
mod codes;
mod draw;
mod frames;
mod hatch;
mod instants;
mod noise;
mod ramp;
mod rank;

pub use blue_noise::{BLUE_NOISE_16, BLUE_NOISE_64};
pub use codes::{CodeMask, PackedRows};
pub use draw::{DitheredDrawTarget, GreyLevels, IntoLight, IntoSrgb, Quantise};
pub use frames::{FrameRateControl, OddFrames};
pub use hatch::{CROSS_HATCH_8X8, CROSS_HATCH_16X16, HATCH_8X8, HATCH_16X16};
pub use instants::Interleaved;
pub use noise::R2Noise;
pub(in crate::display) use rank::even;
pub use rank::{BAYER_2X2, BAYER_4X4, BAYER_8X8, BAYER_16X16, RankMask, UnevenRanks};

use core::ops::Range;

use embedded_graphics::{geometry::Point, image::GetPixel};

use crate::{
    colour::Light,
    display::level::{Levels, Shades},
    num::index,
    phase::{eight, phase, repeated},
    shade::Shade,
    space::Rect,
    target::{Code, Target},
    vary::Ramp,
};
use ramp::Switches;
use rank::Cells;

/// At each pixel, how much of the way between two levels the light must exceed to show the brighter one.
///
/// Thresholds count 65536ths of the step. A light at the brighter level exceeds every threshold, one at the darker
/// level none.
pub trait Mask {
    /// Whether all rows repeat every eight columns, and all columns every eight rows. Flat areas are fast then.
    const REPEATS: bool;
    /// Whether all rows repeat every four columns, which saves half of the comparisons.
    const IN_FOUR: bool = false;

    /// The threshold of a pixel. For all columns and rows.
    fn threshold(&self, column: i32, row: i32) -> u16;

    /// The thresholds of a row from a column on to the right, without end.
    fn row(&self, row: i32, column: i32) -> impl Iterator<Item = u16>;

    /// The thresholds of the columns 0 to 7 of a row.
    #[inline]
    fn eight(&self, row: i32) -> [u16; 8] {
        let mut thresholds = self.row(row, 0);
        [(); 8].map(|()| thresholds.next().unwrap_or_default())
    }
}

impl<M: Mask> Mask for &M {
    const REPEATS: bool = M::REPEATS;
    const IN_FOUR: bool = M::IN_FOUR;

    #[inline]
    fn threshold(&self, column: i32, row: i32) -> u16 {
        (*self).threshold(column, row)
    }

    #[inline]
    fn row(&self, row: i32, column: i32) -> impl Iterator<Item = u16> {
        (*self).row(row, column)
    }

    #[inline]
    fn eight(&self, row: i32) -> [u16; 8] {
        (*self).eight(row)
    }
}

/// How light between two levels is shown, chosen while the program runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Method {
    /// 4 × 4 ordered dither: the default.
    #[default]
    Ordered4x4,
    /// No dither: the nearer of the two levels.
    Nearest,
}

impl Method {
    #[inline]
    fn thresholds(self, row: i32) -> &'static [u16; 4] {
        static ORDERED: [[u16; 4]; 4] = BAYER_4X4.thresholds();
        let [first, second, third, fourth] = &ORDERED;
        match (self, row & 3) {
            (Self::Nearest, _) => &[0x8000; 4],
            (Self::Ordered4x4, 0) => first,
            (Self::Ordered4x4, 1) => second,
            (Self::Ordered4x4, 2) => third,
            (Self::Ordered4x4, _) => fourth,
        }
    }
}

impl Mask for Method {
    const REPEATS: bool = true;
    const IN_FOUR: bool = true;

    #[inline]
    fn threshold(&self, column: i32, row: i32) -> u16 {
        phase(self.thresholds(row), column).unwrap_or_default()
    }

    #[inline]
    fn row(&self, row: i32, column: i32) -> impl Iterator<Item = u16> {
        Cells::new(self.thresholds(row), column)
    }

    #[inline]
    fn eight(&self, row: i32) -> [u16; 8] {
        // Four that come twice: what is computed of them is computed once.
        let &[a, b, c, d] = self.thresholds(row);
        [a, b, c, d, a, b, c, d]
    }
}

/// Takes light and gives the panel's codes, dithered: a [`Target`] of light on a target of colours.
///
/// ```
/// use aquatint::{Dithered, Frame, Levels, Light, Rows, Target};
/// use embedded_graphics::pixelcolor::BinaryColor;
///
/// let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 4], 8, 4).unwrap();
/// let mut dithered = Dithered::new(&mut frame, Levels::ONE_BIT);
/// for row in 0..4 {
///     dithered.fill_run(row, 0..8, [Light(32_768)]).unwrap();
/// }
/// assert_eq!(frame.bytes(), [0b1010_1010, 0b0101_0101, 0b1010_1010, 0b0101_0101]);
/// ```
#[derive(Debug)]
pub struct Dithered<'t, 'l, T, M = Method> {
    target: &'t mut T,
    shades: Shades<'l>,
    /// For the step of the shades, if any are known.
    switches: Switches,
    mask: M,
}

impl<'t, 'l, T: Target> Dithered<'t, 'l, T>
where
    T::Color: Code,
{
    /// Dithers onto `target`, whose codes give `levels` of light, by 4 × 4 ordered dither.
    ///
    /// With fewer levels than the target has codes, the codes above are not used; codes that the
    /// target does not have lose their upper bits.
    pub const fn new(target: &'t mut T, levels: Levels<'l>) -> Self {
        Self { target, shades: Shades::new(levels), switches: Switches::UNKNOWN, mask: Method::Ordered4x4 }
    }
}

impl<'t, 'l, T, M> Dithered<'t, 'l, T, M> {
    /// The same by another [`Method`] or another mask.
    #[must_use]
    pub fn with_method<N: Mask>(self, mask: N) -> Dithered<'t, 'l, T, N> {
        Dithered { target: self.target, shades: self.shades, switches: Switches::UNKNOWN, mask }
    }

    /// A `DrawTarget` of `C`, such as `Gray8` or `Rgb888`: all drawings of embedded-graphics dithered as they are
    /// drawn, with no buffer.
    ///
    /// ```
    /// use aquatint::{Dithered, Frame, Levels, Pages};
    /// use embedded_graphics::{pixelcolor::{BinaryColor, Rgb888}, prelude::*};
    ///
    /// let mut frame = Frame::<BinaryColor, Pages, _>::with_array([0; 1024], 128, 64).unwrap();
    /// let mut display = Dithered::new(&mut frame, Levels::ONE_BIT).into_draw_target::<Rgb888>();
    /// display.clear(Rgb888::new(255, 0, 0))?;
    /// // Red has 21 % of the light of white: 3 pixels of 16.
    /// assert_eq!(frame.bytes().iter().map(|byte| byte.count_ones()).sum::<u32>(), 128 * 64 * 3 / 16);
    /// # Ok::<(), core::convert::Infallible>(())
    /// ```
    pub fn into_draw_target<C: IntoLight>(self) -> DitheredDrawTarget<'t, T, GreyLevels<'l, C>, M> {
        DitheredDrawTarget::of(self.target, GreyLevels::of(self.shades), self.mask)
    }
}

impl<T: Target, M: Mask> Dithered<'_, '_, T, M>
where
    T::Color: Code,
{
    /// Gives an area one light. With a mask that repeats every eight pixels, that costs what a solid area costs and
    /// the computing of 64 pixels.
    ///
    /// # Errors
    /// What the display behind says.
    pub fn fill_area(&mut self, area: Rect, light: Light) -> Result<(), T::Error> {
        if M::REPEATS {
            let tile = [0, 1, 2, 3, 4, 5, 6, 7].map(|row| self.flat(row, light));
            return self.target.fill_tile(area, &tile);
        }
        let visible = area.intersection(self.target.bounds());
        visible.rows().try_for_each(|row| self.fill_run(row, visible.columns(), [light]))
    }

    /// The colours of the columns 0 to 7 of a row of one light.
    #[inline]
    fn flat(&mut self, row: i32, light: Light) -> [T::Color; 8] {
        self.shades.eight(light, self.mask.eight(row)).map(T::Color::from_code)
    }
}

impl<T: Target, M: Mask> Target for Dithered<'_, '_, T, M>
where
    T::Color: Code,
{
    type Color = Light;
    type Error = T::Error;

    fn bounds(&self) -> Rect {
        self.target.bounds()
    }

    fn fill_run<const N: usize>(&mut self, row: i32, columns: Range<i32>, colors: [Light; N]) -> Result<(), T::Error> {
        if let ([light], true) = (colors.as_slice(), M::REPEATS) {
            return self.fill_flat(row, columns, *light);
        }
        if let (Some(lights), true) = (eight(&colors), M::REPEATS) {
            let mut thresholds = self.mask.eight(row).into_iter();
            let codes =
                lights.map(|light| T::Color::from_code(self.shades.code(light, thresholds.next().unwrap_or_default())));
            return self.target.fill_run(row, columns, codes);
        }
        let Some(visible) = self.target.bounds().clip_run(row, columns) else { return Ok(()) };
        self.write_run(row, visible.clone(), repeated(&colors, visible.start).map(Some))
    }

    fn write_run(
        &mut self,
        row: i32,
        columns: Range<i32>,
        mut colors: impl Iterator<Item = Option<Light>>,
    ) -> Result<(), T::Error> {
        let Some(visible) = self.target.bounds().clip_run(row, columns.clone()) else { return Ok(()) };
        if let Some(last) = index(visible.start.saturating_sub(columns.start)).checked_sub(1) {
            colors.nth(last);
        }
        // A copy that lives in registers.
        let mut shades = self.shades;
        let codes = colors
            .zip(self.mask.row(row, visible.start))
            .map(move |(light, threshold)| light.map(|light| T::Color::from_code(shades.code(light, threshold))));
        self.target.write_run(row, visible, codes)
    }

    #[inline(never)]
    fn set(&mut self, row: i32, column: i32, light: Light) -> Result<(), T::Error> {
        let code = self.shades.code(light, self.mask.threshold(column, row));
        self.target.set(row, column, T::Color::from_code(code))
    }

    fn write_all(
        &mut self,
        row: i32,
        columns: Range<i32>,
        lights: impl Iterator<Item = Light>,
    ) -> Result<(), T::Error> {
        if M::REPEATS && self.shades.is_one_step() {
            self.write_one_step(row, columns, lights)
        } else {
            self.write_run(row, columns, lights.map(Some))
        }
    }

    #[inline]
    fn fill_shade(&mut self, row: i32, columns: Range<i32>, shade: &mut Shade) -> Result<(), T::Error> {
        if M::REPEATS { self.draw_shade(row, columns, shade) } else { self.fill_run(row, columns, [shade.light()]) }
    }

    #[inline]
    fn fill_ramp(&mut self, row: i32, columns: Range<i32>, light: Ramp<1>) -> Result<(), T::Error> {
        self.draw_ramp(row, columns, light)
    }
}

/// The light that is shown, by the levels of the panel: so that one can [blend](crate::Blended) on it.
impl<T, C, M> GetPixel for Dithered<'_, '_, T, M>
where
    T: GetPixel<Color = C>,
    C: Code,
{
    type Color = Light;

    fn pixel(&self, point: Point) -> Option<Light> {
        self.shades.light(self.target.pixel(point)?.code())
    }
}
