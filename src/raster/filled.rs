//! What can be traced can be drawn: every outline of the crate as a primitive of embedded-graphics.

use embedded_graphics::{
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    pixelcolor::PixelColor,
    primitives::{ContainsPoint, Primitive, Rectangle, StyledDimensions, StyledDrawable},
};
use heapless::Vec;

use crate::{
    affine::Placed,
    arc::{Arc, Chord, Oval, Sector},
    outline::{Outline, bounding_box, center_bounds},
    raster::{
        path::Path,
        polygon::Polygon,
        rounded_rectangle::RoundedRectangle,
        scan::{ActiveEdge, contains, fill},
    },
    style::{FillStyle, Rule},
    svg::SvgPath,
    target::Paint,
};

/// Makes an outline a primitive that can be filled.
macro_rules! primitive {
    ($([$($generics:tt)*] $outline:ty),* $(,)?) => { $(
        impl<$($generics)*> Primitive for $outline {}

        impl<$($generics)*> Dimensions for $outline {
            /// The smallest rectangle of pixels that holds all vertices of the outline.
            fn bounding_box(&self) -> Rectangle {
                bounding_box(self)
            }
        }

        impl<$($generics)*> ContainsPoint for $outline {
            /// Whether the pixel is filled by the non-zero rule.
            fn contains(&self, pixel: Point) -> bool {
                contains(self, Rule::NonZero, pixel)
            }
        }

        impl<C: PixelColor, $($generics)*> StyledDimensions<FillStyle<C>> for $outline {
            /// The smallest rectangle that holds all pixels whose centres are no farther out than the outermost
            /// vertices: every pixel that is filled.
            fn styled_bounding_box(&self, _style: &FillStyle<C>) -> Rectangle {
                center_bounds(self).into()
            }
        }

        impl<C: PixelColor, $($generics)*> StyledDrawable<FillStyle<C>> for $outline {
            type Color = C;
            type Output = ();

            /// Lends the fill a list of 16 edges on the stack, 512 bytes.
            fn draw_styled<D: DrawTarget<Color = C>>(
                &self,
                style: &FillStyle<C>,
                target: &mut D,
            ) -> Result<(), D::Error> {
                draw_filled(self, style, target)
            }
        }
    )* };
}

primitive!(
    [] Polygon<'_>,
    [] Path<'_>,
    [] Oval,
    [] Arc,
    [] Chord,
    [] Sector,
    [] RoundedRectangle,
    [] SvgPath<'_>,
    [O: Outline] Placed<O>,
);

fn draw_filled<O: Outline, D: DrawTarget>(
    outline: &O,
    style: &FillStyle<D::Color>,
    target: &mut D,
) -> Result<(), D::Error> {
    let mut edges = Vec::<ActiveEdge, 16>::new();
    fill(outline, style.rule, &mut edges, &mut Paint::new(target, style.color))
}
