//! Drawings of embedded-graphics, dithered as they are drawn.
//!
//! A `DrawTarget` of one colour type on a target of another: what is drawn in `Gray8` or `Rgb888` arrives as codes
//! of the panel. There is no buffer; a pixel depends on its colour and its place only.
//!
//! ```text
//!   Text, Image, Circle … ──Rgb888──▶ DitheredDrawTarget ──codes──▶ frame or display
//!                                      Quantise + Mask
//! ```
//!
//! - **Takes** pixels, areas and rows of colours, in any order.
//! - **Gives** the panel's codes.
//! - **Memory** none.
//! - **Cost** a flat area what a solid one costs, with a mask that repeats in eight pixels; else the mask's and the
//!   quantiser's a pixel.

use core::marker::PhantomData;

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    pixelcolor::PixelColor,
    primitives::Rectangle,
};

use super::{Mask, Method};
pub use crate::srgb::{IntoLight, IntoSrgb};
use crate::{
    display::level::{Levels, Shades},
    space::Rect,
    target::{Code, Target, VisibleColors},
};

/// Chooses what of a panel shows a colour, given a threshold of 0 to 65535.
pub trait Quantise<To>: Copy {
    /// What is drawn with.
    type From: PixelColor;

    /// The panel's colour. Over all thresholds, the mean of what is chosen is the colour that was meant.
    fn quantise(&mut self, color: Self::From, threshold: u16) -> To;
}

/// Greys of a panel for colours `C`.
#[derive(Clone, Copy, Debug)]
pub struct GreyLevels<'l, C> {
    shades: Shades<'l>,
    color: PhantomData<C>,
}

impl<'l, C: IntoLight> GreyLevels<'l, C> {
    /// On a panel whose codes give these levels of light.
    #[must_use]
    pub const fn new(levels: Levels<'l>) -> Self {
        Self::of(Shades::new(levels))
    }

    pub(super) const fn of(shades: Shades<'l>) -> Self {
        Self { shades, color: PhantomData }
    }
}

impl<C: IntoLight, To: Code> Quantise<To> for GreyLevels<'_, C> {
    type From = C;

    #[inline]
    fn quantise(&mut self, color: C, threshold: u16) -> To {
        To::from_code(self.shades.code(color.into_light(), threshold))
    }
}

/// A `DrawTarget` of the quantiser's colours on a target of the panel's.
///
/// The target is a frame, a window on one, or [`OnDrawTarget`](crate::OnDrawTarget), which lends a display driver.
#[derive(Debug)]
pub struct DitheredDrawTarget<'t, T, Q, M = Method> {
    target: &'t mut T,
    quantiser: Q,
    mask: M,
}

impl<'t, T, Q, M> DitheredDrawTarget<'t, T, Q, M> {
    pub(super) fn of(target: &'t mut T, quantiser: Q, mask: M) -> Self {
        Self { target, quantiser, mask }
    }
}

impl<'t, T: Target, Q: Quantise<T::Color>, M: Mask> DitheredDrawTarget<'t, T, Q, M> {
    /// Dithers onto `target` with a quantiser and a mask.
    pub const fn new(target: &'t mut T, quantiser: Q, mask: M) -> Self {
        Self { target, quantiser, mask }
    }

    /// The colours of the columns 0 to 7 of a row of one colour.
    fn flat(&mut self, row: i32, color: Q::From) -> [T::Color; 8] {
        self.mask.eight(row).map(|threshold| self.quantiser.quantise(color, threshold))
    }

    /// A part of a row that is not hidden.
    fn write(&mut self, row: i32, area: Rect, colors: impl Iterator<Item = Q::From>) -> Result<(), T::Error> {
        // A copy that lives in registers.
        let mut quantiser = self.quantiser;
        let shown = colors.zip(self.mask.row(row, area.left));
        self.target.write_run(row, area.columns(), shown.map(move |(color, at)| Some(quantiser.quantise(color, at))))
    }
}

impl<T: Target, Q, M> Dimensions for DitheredDrawTarget<'_, T, Q, M> {
    fn bounding_box(&self) -> Rectangle {
        self.target.bounds().into()
    }
}

impl<T, C, Q, M> DrawTarget for DitheredDrawTarget<'_, T, Q, M>
where
    C: PixelColor,
    T: Target<Color = C> + DrawTarget<Color = C, Error = <T as Target>::Error>,
    Q: Quantise<C>,
    M: Mask,
{
    type Color = Q::From;
    type Error = <T as Target>::Error;

    fn draw_iter<I: IntoIterator<Item = Pixel<Q::From>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        let (mut quantiser, mask) = (self.quantiser, &self.mask);
        let shown = move |Pixel(at @ Point { x, y }, color)| Pixel(at, quantiser.quantise(color, mask.threshold(x, y)));
        self.target.draw_iter(pixels.into_iter().map(shown))
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Self::Error>
    where
        I: IntoIterator<Item = Q::From>,
    {
        let area = Rect::from(*area);
        let visible = area.intersection(self.target.bounds());
        let mut colors = VisibleColors::new(colors.into_iter(), area, visible);
        visible.rows().try_for_each(|row| self.write(row, visible, colors.row()))
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Q::From) -> Result<(), Self::Error> {
        if M::REPEATS {
            let tile = [0, 1, 2, 3, 4, 5, 6, 7].map(|row| self.flat(row, color));
            return self.target.fill_tile((*area).into(), &tile);
        }
        let visible = Rect::from(*area).intersection(self.target.bounds());
        visible.rows().try_for_each(|row| self.write(row, visible, core::iter::repeat(color)))
    }

    fn clear(&mut self, color: Q::From) -> Result<(), Self::Error> {
        self.fill_solid(&self.bounding_box(), color)
    }
}
