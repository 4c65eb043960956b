//! Circles and rectangles of whole pixels: their borders are what lies between two of them.
//!
//! ```text
//!   ┌───────────┐      two contours instead of a stroke, whose pieces are many and overlap: exact, and some
//!   │ ┌───────┐ │      thousand times faster for a circle
//!   │ └───────┘ │
//!   └───────────┘
//! ```

use embedded_graphics::{
    draw_target::DrawTarget,
    geometry::Size,
    pixelcolor::PixelColor,
    primitives::{self, Rectangle, StyledDrawable},
};

use super::{
    draw, paint,
    primitives::{oval, rectangle},
};
use crate::{
    blend::Alpha,
    num::Subpixel,
    outline::{Outline, Pen},
    raster::{circle::Circle, rounded_rectangle::RoundedRectangle},
    style::{AntialiasedStyle, Join, Rule},
};

/// A shape without a smaller one in it.
struct Ring<O>(O, Option<O>);

impl<O: Outline> Outline for Ring<O> {
    fn trace<P: Pen>(&self, pen: &mut P) {
        self.0.trace(pen);
        if let Some(inner) = &self.1 {
            inner.trace(pen);
        }
    }

    fn trace_fine<P: Pen>(&self, pen: &mut P) {
        self.0.trace_fine(pen);
        if let Some(inner) = &self.1 {
            inner.trace_fine(pen);
        }
    }
}

/// Draws a shape that can be made smaller by so many sixteenths of a pixel all around.
fn draw_ring<O: Outline, C: PixelColor, D: DrawTarget<Color = Alpha<C>>>(
    shape: impl Fn(i32) -> Option<O>,
    style: &AntialiasedStyle<C>,
    target: &mut D,
) -> Result<(), D::Error> {
    if let (Some(inside), Some(color)) = (shape(0), style.fill_color) {
        paint(&inside, (color, style.rule), style.curve, target)?;
    }
    let width = i32::from(style.stroke.sixteenths());
    // Of an odd number of sixteenths the greater half is outside.
    let (outer, inner) = (style.inset() - (width + 1) / 2, style.inset() + width / 2);
    match (shape(outer), style.stroke_color) {
        (Some(outer), Some(color)) if width > 0 => {
            paint(&Ring(outer, shape(inner)), (color, Rule::EvenOdd), style.curve, target)
        }
        _ => Ok(()),
    }
}

macro_rules! circles {
    ($($circle:ty),+) => { $(
        impl<C: PixelColor> StyledDrawable<AntialiasedStyle<C>> for $circle {
            type Color = Alpha<C>;
            type Output = ();

            /// By area averaging, with four to five kB of the stack. Circles that reach 4,194,304 pixels from the origin are
            /// not drawn.
            fn draw_styled<D: DrawTarget<Color = Alpha<C>>>(
                &self,
                style: &AntialiasedStyle<C>,
                target: &mut D,
            ) -> Result<(), D::Error> {
                let is_drawn = self.diameter > 0;
                let size = Size::new_equal(self.diameter);
                draw_ring(|inset| oval(self.top_left, size, inset).filter(|_| is_drawn), style, target)
            }
        }
    )+ };
}

circles!(Circle, primitives::Circle);

impl<C: PixelColor> StyledDrawable<AntialiasedStyle<C>> for Rectangle {
    type Color = Alpha<C>;
    type Output = ();

    /// By area averaging, with eight kB of the stack. Rectangles that reach 4,194,304 pixels from the origin are
    /// not drawn.
    fn draw_styled<D: DrawTarget<Color = Alpha<C>>>(
        &self,
        style: &AntialiasedStyle<C>,
        target: &mut D,
    ) -> Result<(), D::Error> {
        let is_drawn = self.size.width > 0 && self.size.height > 0;
        let sharp = |inset| {
            let shape = rectangle(*self, [0; 4], inset).filter(|_| is_drawn);
            shape.map(|shape: RoundedRectangle| shape.with_radii([Subpixel::ZERO; 4]))
        };
        // A miter of a right angle is √2 times as long as the stroke is wide.
        match style.stroke.join {
            Join::Miter { limit: 2.. } => draw_ring(sharp, style, target),
            _ => draw(sharp(0), sharp(style.inset()), style, target),
        }
    }
}
