//! Motion blur: an exposure of equal sub-frames, added in light. Lecture 6.5.
//!
//! A picture of one instant is a sample in time, and time has an alias as space has: a fast ball is a row of separate
//! balls (strobe), a wheel stands or turns backwards (wagon wheel), what is smaller than a pixel flickers. A shutter
//! that stays open sees the mean over all instants instead. So does the mean of `N` pictures, each drawn with its
//! objects where they are at `(i + ½) / N` of the frame. It is light that is averaged, not
//! codes: that would end at 25 to 45 dB however many there are.
//!
//! ```text
//!   instants  ⅛      ⅜      ⅝      ⅞           shown
//!            ●··    ·●·    ·●·    ··●
//!            ──1/4──▶──1/4──▶──1/4──▶──1/4──▶  ░▒░   ──Dithered──▶ panel
//! ```
//!
//! How many sub-frames: half of the pixels that the fastest object moves in a frame. Then the eye finds 57 to 65 dB
//! between the picture and 256 sub-frames; with a quarter of them 43 to 52 dB. That is for smooth sub-frames: the
//! edges of sharp ones lie on whole pixels, so that those end at 50 dB. On one bit the dither's own noise is 40 dB:
//! there more than 4 to 8 are not seen, and [`Interleaved`](crate::Interleaved) comes near with no memory.
//!
//! Sub-frames that are moved by parts of a pixel, too, are averaged over the pixel's area: that is antialiasing, and
//! the cure for what flickers while it hardly moves.
//!
//! - **Takes** pictures of any colour, and how much light a colour is.
//! - **Gives** a picture in light.
//! - **Memory** the accumulation buffer, 2 bytes a pixel, and a picture of one sub-frame. By bands of 8 rows of 128
//!   that is 2 KB and, on one bit, 128 bytes.
//! - **Cost** for each sub-frame its drawing, and for each pixel a read, a comparison and, where it is not black, an
//!   addition; two multiplications where the colour changes along a row. No division.
//!
//! Source: P. Haeberli and K. Akeley, "The accumulation buffer: hardware support for high-quality rendering",
//! SIGGRAPH 1990.

use core::ops::Range;

use embedded_graphics::{geometry::Point, image::GetPixel};

use crate::{
    colour::Light,
    error::describe,
    num::{count_i32, saturate_u16},
    space::Rect,
    target::Target,
};

/// Pixels that are added up before they are written.
const CHUNK: usize = 64;

/// The number of sub-frames is not 1 to 256.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OddSubframes;

describe! { OddSubframes, Self => "the number of sub-frames is not 1 to 256"; }

/// An exposure: the mean of `N` sub-frames, in an accumulation buffer of the caller's.
///
/// The buffer is any picture in light that can be written and read: a [`Frame`](crate::Frame) of [`Light`] in
/// [`Words`](crate::Words), or a [`Window`](crate::Window) on one. It needs no clearing: the first sub-frame writes,
/// the others add.
///
/// Nothing drifts. Of light `L`, sub-frame `i` adds `⌊L (i+1) / N⌋ − ⌊L i / N⌋`, so that a pixel that does not
/// change keeps exactly its light, however many sub-frames there are. One that changes `k` times is less than
/// `k` of 65535 steps away from the mean.
///
/// A ball that moves 32 pixels a frame, on an OLED of one bit, band by band:
///
/// ```
/// use aquatint::{Dithered, Exposure, Frame, IntoLight, Levels, Light, Pages, Rows, Window, Words};
/// use embedded_graphics::{pixelcolor::BinaryColor, prelude::*, primitives::{Circle, PrimitiveStyle}};
///
/// const SUBFRAMES: u16 = 16;
/// let mut screen = Frame::<BinaryColor, Pages, _>::with_array([0; 1024], 128, 64).unwrap();
/// let mut light = Frame::<Light, Words, _>::with_array([0; 2 * 128 * 8], 128, 8).unwrap();
/// let mut instant = Frame::<BinaryColor, Rows, _>::with_array([0; 128], 128, 8).unwrap();
/// for top in (0..64).step_by(8) {
///     let (mut light, mut instant) = (Window::band(&mut light, top), Window::band(&mut instant, top));
///     let mut exposure = Exposure::new(&mut light, SUBFRAMES)?;
///     for i in 0..SUBFRAMES {
///         // At (i + ½) / 16 of the frame.
///         let at = Point::new(40 + 2 * i32::from(i) + 1, 24);
///         instant.fill_solid(&instant.bounding_box(), BinaryColor::Off)?;
///         Circle::new(at, 16).into_styled(PrimitiveStyle::with_fill(BinaryColor::On)).draw(&mut instant)?;
///         exposure.add(&instant, IntoLight::into_light)?;
///     }
///     exposure.show(&mut Dithered::new(&mut screen, Levels::ONE_BIT))?;
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Exposure<'s, S> {
    sum: &'s mut S,
    /// How many sub-frames have been added, of how many.
    taken: u16,
    of: u16,
}

impl<'s, S> Exposure<'s, S> {
    /// Opens the shutter for `subframes` pictures, which are added up in `sum`.
    ///
    /// # Errors
    /// [`OddSubframes`]: it is 1 to 256.
    pub const fn new(sum: &'s mut S, subframes: u16) -> Result<Self, OddSubframes> {
        if subframes == 0 || subframes > 256 {
            return Err(OddSubframes);
        }
        Ok(Self { sum, taken: 0, of: subframes })
    }

    /// How many sub-frames have been added.
    #[must_use]
    pub const fn taken(&self) -> u16 {
        self.taken
    }
}

impl<S: Target<Color = Light> + GetPixel<Color = Light>> Exposure<'_, S> {
    /// Adds the next sub-frame; `light` says how much a colour is, as `IntoLight::into_light` does, or for a picture
    /// in light `core::convert::identity`.
    ///
    /// The picture has the coordinates of the buffer; where it has no pixel it is black. Sub-frames beyond the last
    /// one are not added.
    ///
    /// # Errors
    /// What the buffer says.
    pub fn add<P: GetPixel>(&mut self, picture: &P, light: impl FnMut(P::Color) -> Light) -> Result<(), S::Error> {
        if self.taken >= self.of {
            return Ok(());
        }
        let mut shares = Shares { light, share: Share::new(self.taken, self.of), last: None };
        let Rect { left, right, .. } = self.sum.bounds();
        for row in self.sum.bounds().rows() {
            for start in (left..right).step_by(CHUNK) {
                let end = start.saturating_add(count_i32(CHUNK)).min(right);
                self.add_run(row, start..end, |at| picture.pixel(at).map_or(0, |color| shares.of(color)))?;
            }
        }
        self.taken = self.taken.saturating_add(1);
        Ok(())
    }

    /// Adds to at most [`CHUNK`] pixels what a function says.
    #[inline]
    fn add_run(&mut self, row: i32, columns: Range<i32>, mut more: impl FnMut(Point) -> u16) -> Result<(), S::Error> {
        let (is_first, mut sums, mut is_changed) = (self.taken == 0, [None; CHUNK], false);
        for (column, sum) in columns.clone().zip(&mut sums) {
            let at = Point::new(column, row);
            let more = more(at);
            if is_first {
                *sum = Some(Light(more));
            } else if more > 0 {
                // The roundings of changing light may make a few steps more than white.
                *sum = self.sum.pixel(at).map(|Light(sum)| Light(sum.saturating_add(more)));
            }
            is_changed |= sum.is_some();
        }
        if is_changed { self.sum.write_run(row, columns, sums.into_iter()) } else { Ok(()) }
    }

    /// Writes what has been exposed so far on a target of light, such as [`Dithered`](crate::Dithered), in the
    /// coordinates of the buffer.
    ///
    /// # Errors
    /// What the display behind says.
    pub fn show<T: Target<Color = Light>>(&self, target: &mut T) -> Result<(), T::Error> {
        let area = self.sum.bounds().intersection(target.bounds());
        area.rows().try_for_each(|row| {
            let lights = area.columns().map(|column| self.sum.pixel(Point::new(column, row)));
            target.write_run(row, area.columns(), lights)
        })
    }
}

/// What the colours of a sub-frame add. Neighbours are mostly alike, so the last one is remembered.
struct Shares<C, F> {
    light: F,
    share: Share,
    last: Option<(C, u16)>,
}

impl<C: Copy + PartialEq, F: FnMut(C) -> Light> Shares<C, F> {
    #[inline]
    fn of(&mut self, color: C) -> u16 {
        match self.last {
            Some((last, share)) if last == color => share,
            _ => {
                let share = self.share.of((self.light)(color));
                self.last = Some((color, share));
                share
            }
        }
    }
}

/// The part of its light that a sub-frame adds.
#[derive(Clone, Copy, Debug)]
struct Share {
    /// `i / N` and `(i + 1) / N` of 2³², rounded up.
    before: u64,
    after: u64,
}

impl Share {
    /// Of sub-frame `i` of `n`, at least one.
    const fn new(i: u16, n: u16) -> Self {
        // 2³² / n, rounded up.
        let step = (u32::MAX / n as u32) as u64 + 1;
        Self { before: i as u64 * step, after: (i as u64 + 1) * step }
    }

    /// `⌊L (i+1) / N⌋ − ⌊L i / N⌋`, exact.
    ///
    /// The step is too large by less than 1, so `L k` steps (`L k < 2²⁴`) are by less than 2²⁴ of 2³²: by less than
    /// 1/256, which is at most the 1/N that a fraction `x / N` lacks to the next whole number.
    #[inline]
    fn of(self, Light(light): Light) -> u16 {
        let upto = |part: u64| (u64::from(light) * part) >> 32;
        saturate_u16(upto(self.after).wrapping_sub(upto(self.before)).cast_signed())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_share_is_exact() {
        for n in 1..=256_u16 {
            let step = if (8..=250).contains(&n) { 509 } else { 1 };
            for i in [0, 1, n / 2, n.saturating_sub(2), n - 1].into_iter().filter(|&i| i < n) {
                let share = Share::new(i, n);
                let (i, n) = (u32::from(i), u32::from(n));
                for light in (0..=u16::MAX).step_by(step).chain(u16::MAX - 600..=u16::MAX) {
                    let exact = u32::from(light) * (i + 1) / n - u32::from(light) * i / n;
                    assert_eq!(u32::from(share.of(Light(light))), exact, "{light}, {i} of {n}");
                }
            }
        }
    }
}
