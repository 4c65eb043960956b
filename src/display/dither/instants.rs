//! Motion blur without memory: every pixel has an instant of its own, by its rank in a mask. Lecture 6.5.
//!
//! An exposure adds up `N` sub-frames ([`Exposure`](crate::Exposure)) and then dithers their mean. On one bit both
//! steps can be one. A pixel of rank `k` of `K` is drawn as the scene is at the instant `(k + ½) / K` of the frame:
//! where an object covers a pixel's surroundings for a third of the time, a third of the pixels see it.
//!
//! ```text
//!    0  8  2 10      instant 0 draws the pixels of rank 0, instant 1 those of rank 1 …
//!   12  4 14  6
//!    3 11  1  9      ▐███▌→      ▐▞▚▐███▞▌▖
//!   15  7 13  5      at rest     while it moves
//! ```
//!
//! The scene is drawn once for each instant, and each drawing touches only its own pixels: every pixel is written by
//! exactly one of them. What does not move is drawn as if it were drawn once.
//!
//! How near to true motion blur, for the eye, in dB on one bit:
//!
//! | pixels moved a frame | no blur | 8 sub-frames, dithered 4 × 4 | 16 instants |
//! |---|---|---|---|
//! | 4 | 39.4 | 42.6 | 41.8 |
//! | 8 | 31.5 | 42.5 | 40.9 |
//! | 16 | 25.3 | 39.3 | 36.7 |
//!
//! - **Takes** runs and drawings of any colour.
//! - **Gives** those of their pixels that belong to the instant.
//! - **Memory** none.
//! - **Cost** the drawing `N` times. A run in a row without a pixel of the instant (with 4 × 4 and 16 instants,
//!   three rows of four) costs a look at four ranks; else one `write_run`, some instructions a pixel. All
//!   16 instants of a frame of 128 × 64 cost a PC a sixth of what 8 sub-frames and their dither do.
//!
//! Source: A. Keller and W. Heidrich, "Interleaved sampling", Rendering Techniques 2001; in time.

use core::ops::Range;

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    pixelcolor::PixelColor,
    primitives::Rectangle,
};

use super::{RankMask, rank::Cells};
use crate::{
    num::index,
    phase::{phase, repeated},
    space::Rect,
    target::{Target, VisibleColors},
};

/// A target on which only the pixels of one instant can be drawn.
///
/// ```
/// use aquatint::{BAYER_4X4, Frame, Interleaved, Pages};
/// use embedded_graphics::{pixelcolor::BinaryColor, prelude::*, primitives::{Circle, PrimitiveStyle}};
///
/// let mut frame = Frame::<BinaryColor, Pages, _>::with_array([0; 1024], 128, 64).unwrap();
/// for i in 0..16 {
///     let mut instant = Interleaved::new(&mut frame, BAYER_4X4, i, 16);
///     // A ball that moves 32 pixels a frame, at (i + ½) / 16 of it.
///     let at = Point::new(40 + 2 * i32::from(i) + 1, 24);
///     instant.clear(BinaryColor::Off)?;
///     Circle::new(at, 16).into_styled(PrimitiveStyle::with_fill(BinaryColor::On)).draw(&mut instant)?;
/// }
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug)]
pub struct Interleaved<'t, 'm, T, const W: usize, const H: usize> {
    target: &'t mut T,
    mask: RankMask<'m, W, H>,
    ranks: Ranks,
}

impl<'t, 'm, T, const W: usize, const H: usize> Interleaved<'t, 'm, T, W, H> {
    /// Instant `i` of `of` on `target`, by the ranks of `mask`.
    ///
    /// As many instants as the mask has ranks blur most evenly; fewer cost less and have less grain, and what is fast
    /// is seen as so many ghosts. Every pixel belongs to one of the instants `0..of`; with more instants than ranks
    /// some have none, and so has one that is not below `of`.
    pub const fn new(target: &'t mut T, mask: RankMask<'m, W, H>, i: u16, of: u16) -> Self {
        Self { target, mask, ranks: Ranks::new(mask.count(), i, of) }
    }
}

/// Ranks that lie together.
#[derive(Clone, Copy, Debug)]
struct Ranks {
    first: u32,
    count: u32,
}

impl Ranks {
    /// Of an instant, when `count` ranks are shared out in order; at most 256 of them.
    const fn new(count: u32, i: u16, of: u16) -> Self {
        if i >= of {
            return Self { first: 0, count: 0 };
        }
        let (i, of) = (i as u32, of as u32);
        let first = (count * i).div_ceil(of);
        Self { first, count: (count * (i + 1)).div_ceil(of) - first }
    }

    #[inline]
    const fn holds(self, rank: u8) -> bool {
        (rank as u32).wrapping_sub(self.first) < self.count
    }
}

/// Whether the pixels of a row belong to the instant, from one on to the right, without end.
#[derive(Clone, Debug)]
struct Passing<'m, const W: usize> {
    cells: Cells<'m, u8, W>,
    ranks: Ranks,
}

impl<const W: usize> Iterator for Passing<'_, W> {
    type Item = bool;

    #[inline]
    fn next(&mut self) -> Option<bool> {
        self.cells.next().map(|rank| self.ranks.holds(rank))
    }
}

impl<'m, T, const W: usize, const H: usize> Interleaved<'_, 'm, T, W, H> {
    /// Which pixels of a run belong to the instant, if any does.
    #[inline]
    fn passing(&self, row: i32, columns: &Range<i32>) -> Option<Passing<'m, W>> {
        let passing = Passing { cells: Cells::new(self.mask.ranks(row), columns.start), ranks: self.ranks };
        passing.clone().take(columns.len().min(W)).any(|passes| passes).then_some(passing)
    }
}

impl<T: Target, const W: usize, const H: usize> Target for Interleaved<'_, '_, T, W, H> {
    type Color = T::Color;
    type Error = T::Error;

    fn bounds(&self) -> Rect {
        self.target.bounds()
    }

    fn fill_run<const N: usize>(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: [T::Color; N],
    ) -> Result<(), T::Error> {
        let Some(visible) = self.target.bounds().clip_run(row, columns) else { return Ok(()) };
        let Some(passing) = self.passing(row, &visible) else { return Ok(()) };
        if let [color] = *colors.as_slice() {
            return self.target.write_run(row, visible, passing.map(|passes| passes.then_some(color)));
        }
        let colors = repeated(&colors, visible.start).zip(passing);
        self.target.write_run(row, visible, colors.map(|(color, passes)| passes.then_some(color)))
    }

    fn write_run(
        &mut self,
        row: i32,
        columns: Range<i32>,
        mut colors: impl Iterator<Item = Option<T::Color>>,
    ) -> Result<(), T::Error> {
        let Some(visible) = self.target.bounds().clip_run(row, columns.clone()) else { return Ok(()) };
        if let Some(last) = index(visible.start.saturating_sub(columns.start)).checked_sub(1) {
            colors.nth(last);
        }
        let Some(passing) = self.passing(row, &visible) else {
            // Colours of an area go on in the next row.
            colors.nth(visible.len().saturating_sub(1));
            return Ok(());
        };
        self.target.write_run(row, visible, colors.zip(passing).map(|(color, passes)| color.filter(|_| passes)))
    }
}

impl<T: Target, const W: usize, const H: usize> Dimensions for Interleaved<'_, '_, T, W, H> {
    fn bounding_box(&self) -> Rectangle {
        self.target.bounds().into()
    }
}

impl<T, C, const W: usize, const H: usize> DrawTarget for Interleaved<'_, '_, T, W, H>
where
    C: PixelColor,
    T: Target<Color = C> + DrawTarget<Color = C, Error = <T as Target>::Error>,
{
    type Color = C;
    type Error = <T as Target>::Error;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        let (mask, ranks) = (self.mask, self.ranks);
        let passes = move |Point { x, y }| phase(mask.ranks(y), x).is_some_and(|rank| ranks.holds(rank));
        self.target.draw_iter(pixels.into_iter().filter(|Pixel(at, _)| passes(*at)))
    }

    fn fill_contiguous<I: IntoIterator<Item = C>>(&mut self, area: &Rectangle, colors: I) -> Result<(), Self::Error> {
        let area = Rect::from(*area);
        let visible = area.intersection(self.target.bounds());
        let mut colors = VisibleColors::new(colors.into_iter(), area, visible);
        visible.rows().try_for_each(|row| self.write_run(row, visible.columns(), colors.row().map(Some)))
    }

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), Self::Error> {
        let visible = Rect::from(*area).intersection(self.target.bounds());
        visible.rows().try_for_each(|row| self.fill_run(row, visible.columns(), [color]))
    }

    fn clear(&mut self, color: C) -> Result<(), Self::Error> {
        self.fill_solid(&self.bounding_box(), color)
    }
}
