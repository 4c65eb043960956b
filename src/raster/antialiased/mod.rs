//! Every shape as a `Drawable` with an [`AntialiasedStyle`]: ours, and those of embedded-graphics.
//!
//! ```text
//!   shape.into_styled(AntialiasedStyle::fill(color)).draw(&mut Blended::new(&mut frame))
//! ```
//!
//! - **Takes** outlines, lines between pixels, circles and rectangles of pixels.
//! - **Gives** a target runs of [`Alpha`] colours, by [area averaging](super::area).
//! - **Memory** four to five kB of the stack, for rectangles eight, 2 kB of it the list (12 edges or curves, of strokes 32
//!   straight edges) and 128 cells; lend them to [`fill`] where that is too much.

mod primitives;
mod rings;

use core::ops::Range;

use embedded_graphics::{
    draw_target::DrawTarget,
    pixelcolor::PixelColor,
    primitives::{Rectangle, StyledDimensions, StyledDrawable},
};
use heapless::Vec;

use crate::{
    affine::Placed,
    arc::{Arc, Chord, Oval, Sector},
    blend::Alpha,
    coverage::{Coverage, CoverageCurve, Covered},
    outline::{Extent, Outline},
    raster::{
        area::{AreaEdge, NonZero, Scratch, Straight, fill, fill_by},
        path::Path,
        polygon::Polygon,
        polyline::Polyline,
        rounded_rectangle::RoundedRectangle,
        stroke::{Stroked, dash::Dashed, drawable::grown},
    },
    space::Rect,
    span::Sink,
    style::{AntialiasedStyle, Rule},
    svg::SvgPath,
    target::run_area,
    text::Text,
    typeface::Typeface,
};

/// Gives the coverage of a shape to a display, as colours.
struct SoftPaint<'d, D: DrawTarget, C> {
    display: &'d mut D,
    bounds: Rect,
    color: C,
    curve: CoverageCurve,
}

impl<C: PixelColor, D: DrawTarget<Color = Alpha<C>>> Sink<Covered<'_>> for SoftPaint<'_, D, C> {
    type Error = D::Error;

    fn bounds(&self) -> Rect {
        self.bounds
    }

    fn span(&mut self, row: i32, columns: Range<i32>, covered: Covered<'_>) -> Result<(), D::Error> {
        let area = run_area(row, &columns);
        let color = |coverage| Alpha::new(self.color, self.curve.bend(coverage));
        match covered {
            Covered::Evenly(coverage) => self.display.fill_solid(&area, color(coverage)),
            Covered::Each(cells) => self.display.fill_contiguous(&area, cells.iter().copied().map(color)),
        }
    }
}

/// Fills an outline with one colour.
fn paint<O, C, D>(outline: &O, (color, rule): (C, Rule), curve: CoverageCurve, display: &mut D) -> Result<(), D::Error>
where
    O: Outline,
    C: PixelColor,
    D: DrawTarget<Color = Alpha<C>>,
{
    let (mut edges, mut cells) = (Vec::<AreaEdge, 12>::new(), [Coverage::NONE; 128]);
    let bounds = display.bounding_box().into();
    let mut sink = SoftPaint { display, bounds, color, curve };
    fill(outline, rule, Scratch { edges: &mut edges, cells: &mut cells }, &mut sink)
}

/// Draws the inside of an outline and then the border of another, if they are wanted.
fn draw<C: PixelColor, D: DrawTarget<Color = Alpha<C>>>(
    inside: Option<impl Outline>,
    border: Option<impl Outline>,
    style: &AntialiasedStyle<C>,
    display: &mut D,
) -> Result<(), D::Error> {
    if let (Some(inside), Some(color)) = (inside, style.fill_color) {
        paint(&inside, (color, style.rule), style.curve, display)?;
    }
    border.map_or(Ok(()), |border| draw_border(border, style, display))
}

/// Draws the stroke of an outline, if it is wanted: where more than 12 edges cross a row, by summing up their areas.
fn draw_border<C: PixelColor, D: DrawTarget<Color = Alpha<C>>>(
    border: impl Outline,
    style: &AntialiasedStyle<C>,
    display: &mut D,
) -> Result<(), D::Error> {
    let Some(color) = style.stroke_color else { return Ok(()) };
    let (stroked, reach) = Stroked::new(border, style.stroke).measured();
    let bounds = Rect::from(display.bounding_box()).intersection(reach);
    let (mut edges, mut cells) = (Vec::<AreaEdge<Straight>, 32>::new(), [Coverage::NONE; 128]);
    let mut sink = SoftPaint { display, bounds, color, curve: style.curve };
    fill_by(&stroked, NonZero, (&mut edges, 12), (&mut cells, &mut sink))
}

/// A rectangle that holds all that is drawn.
fn bounds<C>(outline: &impl Outline, style: &AntialiasedStyle<C>) -> Rectangle {
    let mut extent = Extent(None);
    outline.trace_fine(&mut extent);
    if style.stroke_color.is_some() {
        Stroked::new(outline, style.stroke).trace_fine(&mut extent);
    }
    pixels(&extent).into()
}

/// The pixels of fine contours, which may lie a sixteenth of a pixel outside of the coarse ones, at a tip much farther.
fn pixels(Extent(extent): &Extent) -> Rect {
    let Some((least, most)) = extent else { return Rect::default() };
    // Where edges cross rows is rounded to the left.
    let [left, top] = [least.x.to_bits().saturating_sub(1), least.y.to_bits()].map(|v| v >> 8);
    let [right, bottom] = [most.x, most.y].map(|v| v.to_bits().saturating_add(255) >> 8);
    Rect::new(left, top, right, bottom)
}

/// Makes outlines drawable with soft borders; those that have an inside, and those that are only lines.
macro_rules! antialiased {
    ($inside:expr; $([$($generics:tt)*] $shape:ty),+ $(,)?) => { $(
        impl<C: PixelColor, $($generics)*> StyledDimensions<AntialiasedStyle<C>> for $shape {
            /// A rectangle that holds all pixels that are drawn.
            fn styled_bounding_box(&self, style: &AntialiasedStyle<C>) -> Rectangle {
                bounds(&self, style)
            }
        }

        impl<C: PixelColor, $($generics)*> StyledDrawable<AntialiasedStyle<C>> for $shape {
            type Color = Alpha<C>;
            type Output = ();

            /// By area averaging, with four to five kB of the stack.
            fn draw_styled<D: DrawTarget<Color = Alpha<C>>>(
                &self,
                style: &AntialiasedStyle<C>,
                target: &mut D,
            ) -> Result<(), D::Error> {
                let has_inside: bool = $inside;
                draw(has_inside.then_some(self), Some(self), style, target)
            }
        }
    )+ };
}

antialiased!(
    true;
    [] Polygon<'_>,
    [] Path<'_>,
    [] Oval,
    [] Chord,
    [] Sector,
    [] RoundedRectangle,
    [] SvgPath<'_>,
    [O: Outline] Placed<O>,
);
antialiased!(
    false;
    [] Polyline<'_>,
    [] Arc,
);

impl<C: PixelColor, O: Outline> StyledDimensions<AntialiasedStyle<C>> for Dashed<'_, O> {
    /// A rectangle of pixels that holds the stroke, whatever the dashes.
    fn styled_bounding_box(&self, style: &AntialiasedStyle<C>) -> Rectangle {
        let is_drawn = style.stroke_color.is_some() && style.stroke.sixteenths() > 0;
        if !is_drawn {
            return Rectangle::zero();
        }
        let mut extent = Extent(None);
        self.outline().trace_fine(&mut extent);
        grown(pixels(&extent), style.stroke).into()
    }
}

impl<C: PixelColor, O: Outline> StyledDrawable<AntialiasedStyle<C>> for Dashed<'_, O> {
    type Color = Alpha<C>;
    type Output = ();

    /// As other outlines; dashes that cannot be seen on the target cost nothing.
    fn draw_styled<D: DrawTarget<Color = Alpha<C>>>(
        &self,
        style: &AntialiasedStyle<C>,
        target: &mut D,
    ) -> Result<(), D::Error> {
        let dashes = self.seen(grown(target.bounding_box().into(), style.stroke));
        draw(None::<&Self>, Some(&dashes), style, target)
    }
}

impl<C: PixelColor, F: Typeface> StyledDimensions<AntialiasedStyle<C>> for Text<'_, F> {
    /// A rectangle that holds all pixels that are drawn. Traces all glyphs.
    fn styled_bounding_box(&self, style: &AntialiasedStyle<C>) -> Rectangle {
        bounds(self, style)
    }
}

impl<C: PixelColor, F: Typeface> StyledDrawable<AntialiasedStyle<C>> for Text<'_, F> {
    type Color = Alpha<C>;
    type Output = ();

    /// One glyph after the other, those that can be seen. Fonts that are made of lines have a stroke and no inside.
    fn draw_styled<D: DrawTarget<Color = Alpha<C>>>(
        &self,
        style: &AntialiasedStyle<C>,
        target: &mut D,
    ) -> Result<(), D::Error> {
        let seen = grown(target.bounding_box().into(), style.stroke);
        self.glyphs(seen).try_for_each(|glyph| {
            if F::HAS_INSIDE {
                return draw(Some(&glyph), Some(&glyph), style, target);
            }
            draw_border(glyph, style, target)
        })
    }
}
