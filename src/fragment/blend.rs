//! Targets that are blended on, and inks of which only a part shows. Lecture 1.5, 6.4.
//!
//! ```text
//!   antialiased shape ──Covered──▶ SoftBrush ─┐
//!   Alpha colours of embedded-graphics ───────┼──▶ Blended: read, mix in light, write ──▶ frame
//!   CoverageMask ─────Covered──▶ SoftBrush ───┘
//! ```
//!
//! - **Takes** coverage of an [`Ink`], or drawings in [`Alpha`] colours.
//! - **Gives** a target colours mixed with those it has.
//! - **Memory** 32 colours on the stack.
//! - **Cost** what covers whole pixels with [`Over`](BlendMode::Over) costs what it costs without blending; else some
//!   130 instructions a pixel to read and to write, 100 more to decode, mix and encode where a pixel is not like the one
//!   before.
//!
//! On one bit a pixel, a pixel is on from half of the light on. Coverage can be dithered instead: blend on
//! [`Dithered`](crate::Dithered). That helps text and long shallow edges, and harms lines of one pixel.

use core::ops::Range;

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    image::GetPixel,
    primitives::Rectangle,
};

use crate::{
    blend::{Alpha, Blend, BlendMode},
    coverage::{Coverage, CoverageCurve, Covered},
    num::index,
    phase::repeated,
    space::Rect,
    span::Sink,
    target::{Ink, Target, VisibleColors},
};

/// A target that can be read, to be blended on: a `DrawTarget` of [`Alpha`] colours.
///
/// What can be read are frames, windows and parts of them, [`Dithered`](crate::Dithered) on these, which takes
/// lights, and, by [`PerPixel`](crate::PerPixel), displays of others that implement `GetPixel`. For a display that cannot be read there
/// is [`OnBackground`].
///
/// ```
/// use aquatint::{AntialiasedStyle, Blended, Frame, Rows};
/// use embedded_graphics::{pixelcolor::Gray4, prelude::*, primitives::Circle};
///
/// let mut frame = Frame::<Gray4, Rows, _>::with_array([0; 24], 8, 6).unwrap();
/// let mut screen = Blended::new(&mut frame);
/// // A circle of embedded-graphics'.
/// Circle::new(Point::new(1, 0), 6).into_styled(AntialiasedStyle::fill(Gray4::WHITE)).draw(&mut screen)?;
/// // What is covered by 58 % has code 12 of 15.
/// assert_eq!(frame.bytes()[..4], [0x03, 0xCF, 0xFC, 0x30]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug)]
pub struct Blended<'t, T> {
    target: &'t mut T,
    mode: BlendMode,
}

impl<'t, T> Blended<'t, T>
where
    T: Target + GetPixel<Color = <T as Target>::Color>,
    <T as Target>::Color: Blend,
{
    /// What is drawn covers what is there.
    pub const fn new(target: &'t mut T) -> Self {
        Self { target, mode: BlendMode::Over }
    }

    /// The same in another mode.
    #[must_use]
    pub fn with_mode(self, mode: BlendMode) -> Self {
        Self { mode, ..self }
    }

    /// Fills antialiased shapes with an ink: takes their coverage.
    pub fn brush<I: Ink<Color = <T as Target>::Color>>(&mut self, ink: I) -> SoftBrush<'_, T, I> {
        SoftBrush { target: self.target, mode: self.mode, curve: CoverageCurve::LINEAR, ink }
    }

    fn blend(
        &mut self,
        (row, columns): (i32, Range<i32>),
        colors: impl Iterator<Item = Alpha<<T as Target>::Color>>,
    ) -> Result<(), T::Error> {
        blend_run(self.target, self.mode, (row, columns), colors.map(Some))
    }
}

/// Mixes the colours of a run with those of a target.
fn blend_run<T>(
    target: &mut T,
    mode: BlendMode,
    (row, columns): (i32, Range<i32>),
    colors: impl Iterator<Item = Option<Alpha<<T as Target>::Color>>>,
) -> Result<(), T::Error>
where
    T: Target + GetPixel<Color = <T as Target>::Color>,
    <T as Target>::Color: Blend,
{
    let Some(visible) = target.bounds().clip_run(row, columns.clone()) else { return Ok(()) };
    let mut colors = colors.skip(index(visible.start.saturating_sub(columns.start)));
    let mut mixed = [None; 32];
    let mut column = visible.start;
    // Neighbours are often alike.
    let mut known = None;
    let mut mix = |drawn: Alpha<<T as Target>::Color>, under| match known {
        Some((before, below, mixed)) if before == drawn && below == under => mixed,
        _ => {
            let mixed = drawn.color.blend(under, mode, drawn.coverage);
            known = Some((drawn, under, mixed));
            mixed
        }
    };
    while column < visible.end {
        let end = column.saturating_add(32).min(visible.end);
        let under = (column..end).map(|column| target.pixel(Point::new(column, row)));
        for ((place, under), drawn) in mixed.iter_mut().zip(under).zip(&mut colors) {
            let drawn = drawn.filter(|drawn| drawn.coverage != Coverage::NONE);
            *place = drawn.zip(under).map(|(drawn, under)| mix(drawn, under));
        }
        target.write_run(row, column..end, mixed.iter_mut().map(Option::take))?;
        column = end;
    }
    Ok(())
}

impl<T: Target> Dimensions for Blended<'_, T> {
    fn bounding_box(&self) -> Rectangle {
        self.target.bounds().into()
    }
}

impl<T> DrawTarget for Blended<'_, T>
where
    T: Target + GetPixel<Color = <T as Target>::Color>,
    <T as Target>::Color: Blend,
{
    type Color = Alpha<<T as Target>::Color>;
    type Error = T::Error;

    fn draw_iter<I: IntoIterator<Item = Pixel<Self::Color>>>(&mut self, pixels: I) -> Result<(), T::Error> {
        for Pixel(Point { x, y }, color) in pixels {
            self.blend((y, x..x.saturating_add(1)), core::iter::once(color))?;
        }
        Ok(())
    }

    fn fill_contiguous<I: IntoIterator<Item = Self::Color>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), T::Error> {
        let area = Rect::from(*area);
        let visible = area.intersection(self.target.bounds());
        let mut colors = VisibleColors::new(colors.into_iter(), area, visible);
        visible.rows().try_for_each(|row| self.blend((row, visible.columns()), colors.row()))
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Self::Color) -> Result<(), T::Error> {
        let visible = Rect::from(*area).intersection(self.target.bounds());
        let is_opaque = color.coverage == Coverage::FULL && self.mode == BlendMode::Over;
        visible.rows().try_for_each(|row| {
            if is_opaque {
                self.target.fill_run(row, visible.columns(), [color.color])
            } else {
                self.blend((row, visible.columns()), core::iter::repeat(color))
            }
        })
    }
}

/// A display that cannot be read, as if it had one colour: a `DrawTarget` of [`Alpha`] colours.
///
/// Right where shapes are drawn on that colour, such as text on a cleared area.
///
/// ```
/// use aquatint::{AntialiasedStyle, OnBackground};
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8, prelude::*, primitives::Line};
///
/// let mut display = MockDisplay::<Gray8>::new();
/// let line = Line::new(Point::new(1, 1), Point::new(5, 3));
/// line.into_styled(AntialiasedStyle::stroke(Gray8::WHITE, 1)).draw(&mut OnBackground::new(&mut display, Gray8::BLACK))?;
/// assert!(display.get_pixel(Point::new(3, 2)).is_some_and(|grey| grey.luma() > 200));
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug)]
pub struct OnBackground<'d, D: DrawTarget> {
    display: &'d mut D,
    background: D::Color,
}

impl<'d, D: DrawTarget> OnBackground<'d, D> {
    /// Draws on a display that has this colour everywhere.
    pub const fn new(display: &'d mut D, background: D::Color) -> Self {
        Self { display, background }
    }
}

impl<D: DrawTarget> Dimensions for OnBackground<'_, D> {
    fn bounding_box(&self) -> Rectangle {
        self.display.bounding_box()
    }
}

impl<D: DrawTarget<Color: Blend>> DrawTarget for OnBackground<'_, D> {
    type Color = Alpha<D::Color>;
    type Error = D::Error;

    fn draw_iter<I: IntoIterator<Item = Pixel<Self::Color>>>(&mut self, pixels: I) -> Result<(), D::Error> {
        let background = self.background;
        let drawn = pixels.into_iter().filter(|Pixel(_, color)| color.coverage != Coverage::NONE);
        self.display.draw_iter(drawn.map(|Pixel(point, Alpha { color, coverage })| {
            Pixel(point, color.blend(background, BlendMode::Over, coverage))
        }))
    }

    fn fill_solid(&mut self, area: &Rectangle, Alpha { color, coverage }: Self::Color) -> Result<(), D::Error> {
        if coverage == Coverage::NONE {
            return Ok(());
        }
        self.display.fill_solid(area, color.blend(self.background, BlendMode::Over, coverage))
    }
}

/// Takes the coverage of antialiased shapes and fills it with an ink.
///
/// ```
/// use aquatint::{
///     Blended, Coverage, Frame, LinearGradient, Light, Point2, Oval, Rule, Subpixel, Words,
///     fragment::gradient::between,
///     raster::area::{Scratch, fill},
/// };
///
/// // A picture in light, two bytes a pixel.
/// let mut picture = Frame::<Light, Words, _>::with_array([0; 2 * 16 * 16], 16, 16).unwrap();
/// let [left, right] = [0, 16].map(|x| Point2::corner(x, 8));
/// let sky = LinearGradient::new(left, right, between(Light::BLACK, Light::WHITE));
/// let ball = Oval::circle(Point2::corner(8, 8), Subpixel::from_num(7)).unwrap();
///
/// let (mut edges, mut cells) = (heapless::Vec::<_, 16>::new(), [Coverage::NONE; 16]);
/// let scratch = Scratch { edges: &mut edges, cells: &mut cells };
/// fill(&ball, Rule::NonZero, scratch, &mut Blended::new(&mut picture).brush(sky))?;
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug)]
pub struct SoftBrush<'t, T, I> {
    target: &'t mut T,
    mode: BlendMode,
    curve: CoverageCurve,
    ink: I,
}

impl<T, I> SoftBrush<'_, T, I> {
    /// The same with coverage bent by a curve.
    #[must_use]
    pub fn with_curve(self, curve: CoverageCurve) -> Self {
        Self { curve, ..self }
    }
}

impl<T, I> Sink<Covered<'_>> for SoftBrush<'_, T, I>
where
    T: Target + GetPixel<Color = <T as Target>::Color>,
    <T as Target>::Color: Blend,
    I: Ink<Color = <T as Target>::Color>,
{
    type Error = T::Error;

    fn bounds(&self) -> Rect {
        self.target.bounds()
    }

    fn span(&mut self, row: i32, columns: Range<i32>, covered: Covered<'_>) -> Result<(), T::Error> {
        if covered == Covered::Evenly(Coverage::FULL) && self.mode == BlendMode::Over {
            return self.ink.fill(self.target, row, columns);
        }
        let Self { target, mode, curve, ink } = self;
        let mut veil = Veil { target: *target, mode: *mode, curve: *curve, covered, first: columns.start };
        ink.fill(&mut veil, row, columns)
    }
}

/// A target on which colours cover what the run of a shape covers.
struct Veil<'t, 'c, T> {
    target: &'t mut T,
    mode: BlendMode,
    curve: CoverageCurve,
    covered: Covered<'c>,
    /// The column in which the run begins.
    first: i32,
}

impl<T> Target for Veil<'_, '_, T>
where
    T: Target + GetPixel<Color = <T as Target>::Color>,
    <T as Target>::Color: Blend,
{
    type Color = <T as Target>::Color;
    type Error = T::Error;

    fn bounds(&self) -> Rect {
        self.target.bounds()
    }

    fn fill_run<const N: usize>(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: [Self::Color; N],
    ) -> Result<(), T::Error> {
        let colors = repeated(&colors, columns.start).map(Some);
        self.write_run(row, columns, colors)
    }

    fn write_run(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: impl Iterator<Item = Option<Self::Color>>,
    ) -> Result<(), T::Error> {
        let Self { covered, curve, first, .. } = *self;
        let Some(visible) = self.bounds().clip_run(row, columns.clone()) else { return Ok(()) };
        let hidden = index(visible.start.saturating_sub(columns.start));
        let offsets = index(visible.start.saturating_sub(first))..;
        let shown = colors
            .skip(hidden)
            .zip(offsets)
            .map(|(color, offset)| color.map(|color| Alpha::new(color, curve.bend(covered.at(offset)))));
        blend_run(self.target, self.mode, (row, visible), shown)
    }
}
