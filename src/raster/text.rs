//! Text as a `Drawable`, filled glyph by glyph.

use embedded_graphics::{
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    pixelcolor::PixelColor,
    primitives::{ContainsPoint, Primitive, Rectangle, StyledDimensions, StyledDrawable},
    transform::Transform,
};
use heapless::Vec;

use crate::{
    num::SUBPIXELS,
    outline::{bounding_box, center_bounds},
    raster::scan::{ActiveEdge, contains, fill},
    space::{Point2, Rect},
    span::Sink,
    style::{FillStyle, Rule},
    target::Paint,
    text::Text,
    typeface::Typeface,
};

/// Edges in the list on the stack: 1 kB. A letter of a serif font has more, but not side by side.
const LIST: usize = 32;

impl<F: Typeface> Primitive for Text<'_, F> {}

impl<F: Typeface> Dimensions for Text<'_, F> {
    /// The smallest rectangle of pixels that holds all vertices of all glyphs. Traces them.
    fn bounding_box(&self) -> Rectangle {
        bounding_box(self)
    }
}

impl<F: Typeface> ContainsPoint for Text<'_, F> {
    /// Whether a glyph fills the pixel by the non-zero rule.
    fn contains(&self, pixel: Point) -> bool {
        let window = Rect::new(pixel.x, pixel.y, pixel.x.saturating_add(1), pixel.y.saturating_add(1));
        self.glyphs(window).any(|glyph| contains(&glyph, Rule::NonZero, pixel))
    }
}

impl<F: Typeface> Transform for Text<'_, F> {
    /// The same text so many pixels to the right and down.
    fn translate(&self, by: Point) -> Self {
        let at = self.place();
        let along = |from: i32, pixels: i32| from.saturating_add(pixels.saturating_mul(SUBPIXELS));
        self.with_place(Point2::from_sixteenths(along(at.x.to_bits(), by.x), along(at.y.to_bits(), by.y)))
    }

    fn translate_mut(&mut self, by: Point) -> &mut Self {
        *self = self.translate(by);
        self
    }
}

impl<C: PixelColor, F: Typeface> StyledDimensions<FillStyle<C>> for Text<'_, F> {
    /// The smallest rectangle that holds all pixels whose centres are no farther out than the outermost
    /// vertices: every pixel that is filled. Traces all glyphs.
    fn styled_bounding_box(&self, _style: &FillStyle<C>) -> Rectangle {
        center_bounds(self).into()
    }
}

impl<C: PixelColor, F: Typeface> StyledDrawable<FillStyle<C>> for Text<'_, F> {
    type Color = C;
    type Output = ();

    /// One glyph after the other, with a list of 32 edges on the stack, 1 kB. Pixels where glyphs overlap are drawn
    /// more than once; glyphs that cannot be seen on the target are skipped.
    fn draw_styled<D: DrawTarget<Color = C>>(&self, style: &FillStyle<C>, target: &mut D) -> Result<(), D::Error> {
        let mut edges = Vec::<ActiveEdge, LIST>::new();
        let mut paint = Paint::new(target, style.color);
        let seen = paint.bounds();
        self.glyphs(seen).try_for_each(|glyph| fill(&glyph, style.rule, &mut edges, &mut paint))
    }
}
