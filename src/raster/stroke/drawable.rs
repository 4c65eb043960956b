//! Every outline as a `Drawable` with a [`StrokeStyle`].
//!
//! Up to 96 visible edges (some 20 segments) a stroke is drawn as one shape, each pixel once. Larger ones are
//! drawn piece by piece: the same pixels, those around corners more than once, in a time that does not grow with the
//! square of the segments. A display gets one colour, so nothing of that is seen.

use core::ops::Range;

use embedded_graphics::{
    draw_target::DrawTarget,
    geometry::Dimensions,
    pixelcolor::PixelColor,
    primitives::{Primitive, Rectangle, StyledDimensions, StyledDrawable},
};
use heapless::vec::Vec;

use super::{Stroked, dash::Dashed};
use crate::{
    affine::Placed,
    arc::{Arc, Chord, Oval, Sector},
    num::SUBPIXELS,
    outline::{Outline, bounding_box, each_edge, pixel_bounds},
    raster::{path::Path, polygon::Polygon, polyline::Polyline, rounded_rectangle::RoundedRectangle, scan::ActiveEdge},
    space::Rect,
    span::Sink,
    style::{Join, Stroke, StrokeStyle},
    svg::SvgPath,
    target::Paint,
    text::Text,
    typeface::Typeface,
};

/// Edges in the list on the stack: 768 bytes.
const LIST: usize = 24;
/// With more visible edges than this, uniting the pieces takes longer than drawing them one by one.
const MOST_EDGES: usize = 4 * LIST;

/// Draws the stroke of an outline: small ones as one shape, others piece by piece, which gives the same pixels.
fn draw<O: Outline, D: DrawTarget>(outline: &O, style: &StrokeStyle<D::Color>, target: &mut D) -> Result<(), D::Error> {
    let stroked = Stroked::new(outline, style.stroke);
    let mut sink = Paint::new(target, style.color);
    if visible_edges(&stroked, sink.bounds().rows()) > MOST_EDGES {
        stroked.spans_of_pieces(&mut sink)
    } else {
        stroked.spans(&mut Vec::<ActiveEdge, LIST>::new(), &mut sink)
    }
}

fn visible_edges<O: Outline>(outline: &O, rows: Range<i32>) -> usize {
    let mut edges = 0;
    each_edge(outline, |edge| {
        edges += usize::from(edge.first_row() < rows.end && rows.start < edge.end_row());
    });
    edges
}

/// Makes outlines drawable along their contours.
macro_rules! stroked {
    ($([$($generics:tt)*] $shape:ty),+ $(,)?) => { $(
        impl<C: PixelColor, $($generics)*> StyledDimensions<StrokeStyle<C>> for $shape {
            /// The smallest rectangle of pixels that holds all corners of the stroke.
            fn styled_bounding_box(&self, style: &StrokeStyle<C>) -> Rectangle {
                bounding_box(&Stroked::new(self, style.stroke))
            }
        }

        impl<C: PixelColor, $($generics)*> StyledDrawable<StrokeStyle<C>> for $shape {
            type Color = C;
            type Output = ();

            /// Along all contours, with 24 edges on the stack, 768 bytes. Of more than 96 visible edges, some 20
            /// segments, pixels around corners are drawn more than once.
            fn draw_styled<D: DrawTarget<Color = C>>(
                &self,
                style: &StrokeStyle<C>,
                target: &mut D,
            ) -> Result<(), D::Error> {
                draw(self, style, target)
            }
        }
    )+ };
}

stroked!(
    [] Polygon<'_>,
    [] Polyline<'_>,
    [] Path<'_>,
    [] Oval,
    [] Arc,
    [] Chord,
    [] Sector,
    [] RoundedRectangle,
    [] SvgPath<'_>,
    [O: Outline] Placed<O>,
);

impl<O: Outline> Primitive for Dashed<'_, O> {}

impl<O: Outline> Dimensions for Dashed<'_, O> {
    /// The smallest rectangle of pixels that holds all points of the outline that is dashed.
    fn bounding_box(&self) -> Rectangle {
        bounding_box(self.outline())
    }
}

impl<C: PixelColor, O: Outline> StyledDimensions<StrokeStyle<C>> for Dashed<'_, O> {
    /// A rectangle of pixels that holds the stroke, whatever the dashes.
    fn styled_bounding_box(&self, style: &StrokeStyle<C>) -> Rectangle {
        let is_drawn = style.stroke.sixteenths() > 0;
        if is_drawn { grown(pixel_bounds(self.outline()), style.stroke).into() } else { Rectangle::zero() }
    }
}

impl<C: PixelColor, O: Outline> StyledDrawable<StrokeStyle<C>> for Dashed<'_, O> {
    type Color = C;
    type Output = ();

    /// As other outlines; dashes that cannot be seen on the target cost nothing.
    fn draw_styled<D: DrawTarget<Color = C>>(&self, style: &StrokeStyle<C>, target: &mut D) -> Result<(), D::Error> {
        let seen = grown(target.bounding_box().into(), style.stroke);
        draw(&self.seen(seen), style, target)
    }
}

impl<C: PixelColor, F: Typeface> StyledDimensions<StrokeStyle<C>> for Text<'_, F> {
    /// The smallest rectangle of pixels that holds all corners of the strokes.
    fn styled_bounding_box(&self, style: &StrokeStyle<C>) -> Rectangle {
        bounding_box(&Stroked::new(self, style.stroke))
    }
}

impl<C: PixelColor, F: Typeface> StyledDrawable<StrokeStyle<C>> for Text<'_, F> {
    type Color = C;
    type Output = ();

    /// One glyph after the other, as other outlines; those that cannot be seen on the target are skipped.
    fn draw_styled<D: DrawTarget<Color = C>>(&self, style: &StrokeStyle<C>, target: &mut D) -> Result<(), D::Error> {
        let seen = grown(target.bounding_box().into(), style.stroke);
        self.glyphs(seen).try_for_each(|glyph| draw(&glyph, style, target))
    }
}

/// A rectangle and as much around it as a stroke reaches from its line.
pub(in crate::raster) fn grown(area: Rect, stroke: Stroke) -> Rect {
    // A tip is `limit` times half the width from the line, the corner of a square cap √2 times.
    let times = match stroke.join {
        Join::Miter { limit } => i32::from(limit).max(2),
        _ => 2,
    };
    let reach = i32::from(stroke.sixteenths()) * times / (2 * SUBPIXELS) + 1;
    Rect::new(
        area.left.saturating_sub(reach),
        area.top.saturating_sub(reach),
        area.right.saturating_add(reach),
        area.bottom.saturating_add(reach),
    )
}
