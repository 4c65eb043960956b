//! Circles of whole pixels: those of embedded-graphics, pixel for pixel.
//!
//! ```text
//!      diameter 5              diameter 6, stroke of 1
//!      · # # # ·               · # # # # ·
//!      # # # # #               # # · · # #
//!      # # # # #               # · · · · #
//!      # # # # #               # · · · · #
//!      · # # # ·               # # · · # #
//!                              · # # # # ·
//! ```
//!
//! The machine is `conic.rs`. For circles with centres and radii on sixteenths of a pixel see
//! [`Oval`](crate::Oval).

use embedded_graphics::{
    draw_target::DrawTarget,
    geometry::{Dimensions, Point, Size},
    pixelcolor::PixelColor,
    primitives::{self, ContainsPoint, Primitive, Rectangle, StrokeAlignment, StyledDimensions, StyledDrawable},
    transform::Transform,
};

use crate::{
    raster::{
        conic::{Blocks, Conic, Middle, centered, draw},
        round::{Rectangles, Spans, borders, primitive, whole_pixels},
        thin,
    },
    span::Sink,
    style::{FillStyle, StrokeStyle},
};

/// A circle of whole pixels, right for all positions and diameters.
///
/// ```
/// use aquatint::{Circle, StrokeStyle};
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
///
/// let mut display = MockDisplay::new();
/// Circle::new(Point::zero(), 6).into_styled(StrokeStyle::new(BinaryColor::On)).draw(&mut display)?;
/// display.assert_pattern(&[
///     " #### ",
///     "##  ##",
///     "#    #",
///     "#    #",
///     "##  ##",
///     " #### ",
/// ]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Circle {
    /// The top left pixel of the square around it.
    pub top_left: Point,
    /// Its height and width, in pixels.
    pub diameter: u32,
}

impl Circle {
    /// A circle in a square.
    #[must_use]
    pub const fn new(top_left: Point, diameter: u32) -> Self {
        Self { top_left, diameter }
    }

    /// A circle about a pixel. With an even diameter that is the upper left one of four in the middle.
    /// A square that would begin outside of 32 bits is moved inside.
    #[must_use]
    pub const fn with_center(center: Point, diameter: u32) -> Self {
        Self { top_left: centered(center, Size::new_equal(diameter)), diameter }
    }

    /// Emits the pixels inside the bounds of `sink`, row by row, one span each.
    ///
    /// # Errors
    /// What the sink says.
    pub fn spans<S: Sink>(&self, sink: &mut S) -> Result<(), S::Error> {
        self.draw_filled(&mut Spans(sink))
    }

    /// Emits the pixels of a stroke inside the bounds of `sink`, row by row, two spans each at most.
    ///
    /// `width` is counted in pixels. A stroke that is too wide for a hole fills the circle.
    ///
    /// # Errors
    /// What the sink says.
    pub fn stroke_spans<S: Sink>(&self, width: u32, alignment: StrokeAlignment, sink: &mut S) -> Result<(), S::Error> {
        self.draw_stroked(width, alignment, &mut Spans(sink))
    }

    pub(super) fn draw_filled<B: Blocks>(&self, blocks: &mut B) -> Result<(), B::Error> {
        draw(&self.middle(), [Conic::circle(self.diameter)], blocks)
    }

    pub(super) fn draw_stroked<B: Blocks>(
        &self,
        width: u32,
        alignment: StrokeAlignment,
        blocks: &mut B,
    ) -> Result<(), B::Error> {
        let sizes @ [outer, _] = borders(self.size(), width, alignment);
        draw(&self.middle().resized(outer), sizes.map(|size| Conic::circle(size.width)), blocks)
    }

    pub(super) fn draw_thin<D: DrawTarget>(&self, middle: &Middle, to: (&mut D, D::Color)) -> Result<(), D::Error> {
        let sizes = borders(self.size(), 1, StrokeAlignment::Center);
        thin::draw(middle, sizes.map(|size| Conic::circle(size.width)), to)
    }

    const fn size(&self) -> Size {
        Size::new_equal(self.diameter)
    }

    fn middle(&self) -> Middle {
        Middle::of(self.top_left, self.size())
    }
}

impl From<primitives::Circle> for Circle {
    fn from(circle: primitives::Circle) -> Self {
        Self::new(circle.top_left, circle.diameter)
    }
}

impl ContainsPoint for Circle {
    fn contains(&self, point: Point) -> bool {
        self.middle().contains(&Conic::circle(self.diameter), point)
    }
}

primitive!(Circle);
