//! Ellipses of whole pixels: those of embedded-graphics, pixel for pixel, with one difference.
//!
//! ```text
//!      10 × 5                      10 × 5, stroke of 1
//!      · · # # # # # # · ·         · · # # # # # # · ·
//!      # # # # # # # # # #         # # · · · · · · # #
//!      # # # # # # # # # #         # · · · · · · · · #
//!      # # # # # # # # # #         # # · · · · · · # #
//!      · · # # # # # # · ·         · · # # # # # # · ·
//! ```
//!
//! **The difference.** The first row of a narrow ellipse with an even width, such as 2 × 8, holds no centre of a
//! pixel. There embedded-graphics 0.8 stops and draws nothing; here the rows below it are drawn, those pixels
//! which the `contains` of both says to be inside.
//!
//! The machine is `conic.rs`. For ellipses with centres and radii on sixteenths of a pixel see
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
        circle::Circle,
        conic::{Blocks, Conic, Middle, centered, draw},
        round::{Rectangles, Spans, borders, primitive, whole_pixels},
        thin,
    },
    span::Sink,
    style::{FillStyle, StrokeStyle},
};

/// An ellipse of whole pixels, right for all positions and sizes.
///
/// ```
/// use aquatint::{Ellipse, FillStyle};
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
///
/// let mut display = MockDisplay::new();
/// let ellipse = Ellipse::new(Point::zero(), Size::new(10, 5));
/// ellipse.into_styled(FillStyle::new(BinaryColor::On)).draw(&mut display)?;
/// display.assert_pattern(&[
///     "  ######  ",
///     "##########",
///     "##########",
///     "##########",
///     "  ######  ",
/// ]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ellipse {
    /// The top left pixel of the rectangle around it.
    pub top_left: Point,
    /// Its width and height, in pixels.
    pub size: Size,
}

impl Ellipse {
    /// An ellipse in a rectangle.
    #[must_use]
    pub const fn new(top_left: Point, size: Size) -> Self {
        Self { top_left, size }
    }

    /// An ellipse about a pixel. Of two pixels in the middle of a row or a column it is the left or upper one.
    /// A rectangle that would begin outside of 32 bits is moved inside.
    #[must_use]
    pub const fn with_center(center: Point, size: Size) -> Self {
        Self { top_left: centered(center, size), size }
    }

    /// Emits the pixels inside the bounds of `sink`, row by row, one span each.
    ///
    /// Sides from 65,536 pixels on cost about twice as much.
    ///
    /// # Errors
    /// What the sink says.
    pub fn spans<S: Sink>(&self, sink: &mut S) -> Result<(), S::Error> {
        self.draw_filled(&mut Spans(sink))
    }

    /// Emits the pixels of a stroke inside the bounds of `sink`, row by row, two spans each at most.
    ///
    /// `width` is counted in pixels. A stroke that is too wide for a hole fills the ellipse.
    ///
    /// # Errors
    /// What the sink says.
    pub fn stroke_spans<S: Sink>(&self, width: u32, alignment: StrokeAlignment, sink: &mut S) -> Result<(), S::Error> {
        self.draw_stroked(width, alignment, &mut Spans(sink))
    }

    fn draw_filled<B: Blocks>(&self, blocks: &mut B) -> Result<(), B::Error> {
        if let Some(circle) = self.circle() {
            circle.draw_filled(blocks)
        } else if is_giant(self.size) {
            draw(&self.middle(), [Conic::<i128>::ellipse(self.size)], blocks)
        } else {
            draw(&self.middle(), [Conic::<i64>::ellipse(self.size)], blocks)
        }
    }

    fn draw_stroked<B: Blocks>(&self, width: u32, alignment: StrokeAlignment, blocks: &mut B) -> Result<(), B::Error> {
        let sizes @ [outer, _] = borders(self.size, width, alignment);
        let middle = self.middle().resized(outer);
        if let Some(circle) = self.circle() {
            circle.draw_stroked(width, alignment, blocks)
        } else if is_giant(outer) {
            draw(&middle, sizes.map(Conic::<i128>::ellipse), blocks)
        } else {
            draw(&middle, sizes.map(Conic::<i64>::ellipse), blocks)
        }
    }

    fn draw_thin<D: DrawTarget>(&self, middle: &Middle, to: (&mut D, D::Color)) -> Result<(), D::Error> {
        let sizes = borders(self.size, 1, StrokeAlignment::Center);
        match self.circle() {
            Some(circle) => circle.draw_thin(middle, to),
            None if is_giant(self.size) => thin::draw(middle, sizes.map(Conic::<i128>::ellipse), to),
            None => thin::draw(middle, sizes.map(Conic::<i64>::ellipse), to),
        }
    }

    /// The circle that an ellipse of equal sides is.
    fn circle(&self) -> Option<Circle> {
        (self.size.width == self.size.height).then_some(Circle::new(self.top_left, self.size.width))
    }

    const fn size(&self) -> Size {
        self.size
    }

    fn middle(&self) -> Middle {
        Middle::of(self.top_left, self.size)
    }
}

/// Whether products of four sides need more than 64 bits.
const fn is_giant(Size { width, height }: Size) -> bool {
    width | height > 0xFFFF
}

impl From<Circle> for Ellipse {
    fn from(circle: Circle) -> Self {
        Self::new(circle.top_left, Size::new_equal(circle.diameter))
    }
}

impl From<primitives::Ellipse> for Ellipse {
    fn from(ellipse: primitives::Ellipse) -> Self {
        Self::new(ellipse.top_left, ellipse.size)
    }
}

impl ContainsPoint for Ellipse {
    fn contains(&self, point: Point) -> bool {
        match self.circle() {
            Some(circle) => circle.contains(point),
            None => self.middle().contains(&Conic::<i128>::ellipse(self.size), point),
        }
    }
}

primitive!(Ellipse);
