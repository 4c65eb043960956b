//! Polylines: points joined by straight lines, to be drawn with a [stroke](super::stroke).
//!
//! ```text
//!       ●────●              open: caps at both ends
//!      ╱      ╲
//!     ●        ●            closed: the last point is joined to the first
//! ```

use embedded_graphics::{
    geometry::Dimensions,
    primitives::{Primitive, Rectangle},
};

use crate::{
    edge::LIMIT,
    error::OutOfRange,
    outline::{Outline, Pen, bounding_box},
    space::Point2,
};

/// A borrowed sequence of points, open or closed.
///
/// A stroke of it is an area of pixel centres, whatever its width: so one pixel wide means every pixel whose centre is
/// at most half a pixel away. That has no gap, and is *not* Bresenham's line, which joins whole pixels: for that
/// draw a [`Line`](crate::Line) between each two of them.
///
/// ```
/// use aquatint::{Cap, Join, Point2, Polyline, Stroke, StrokeStyle};
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
///
/// let points = [(1, 5), (1, 1), (7, 1)].map(|(x, y)| Point2::corner(x, y));
/// let mut display = MockDisplay::new();
/// let polyline = Polyline::new(&points).unwrap();
/// polyline.into_styled(StrokeStyle::new(BinaryColor::On).with_width(2)).draw(&mut display)?;
/// display.assert_pattern(&[
///     "#######",
///     "#######",
///     "##     ",
///     "##     ",
///     "##     ",
/// ]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Polyline<'a> {
    points: &'a [Point2],
    is_closed: bool,
}

impl<'a> Polyline<'a> {
    /// Borrows and checks the points of an open polyline. A single point is a dot by its caps.
    ///
    /// # Errors
    /// [`OutOfRange`] when a point is 4,194,304 pixels or more from the origin.
    pub fn new(points: &'a [Point2]) -> Result<Self, OutOfRange> {
        let in_range = points.iter().all(|point| point.within(LIMIT));
        if in_range { Ok(Self { points, is_closed: false }) } else { Err(OutOfRange) }
    }

    /// The same of a closed one, which has a join in place of two caps.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn closed(points: &'a [Point2]) -> Result<Self, OutOfRange> {
        Self::new(points).map(|open| Self { is_closed: true, ..open })
    }
}

impl Outline for Polyline<'_> {
    #[inline]
    fn trace<P: Pen>(&self, pen: &mut P) {
        let [first, rest @ ..] = self.points else { return };
        pen.move_to(*first);
        for point in rest {
            pen.line_to(*point);
        }
        if self.is_closed {
            pen.close();
        } else if rest.is_empty() {
            // A pen that has drawn nowhere leaves no dot.
            pen.line_to(*first);
        }
    }
}

impl Primitive for Polyline<'_> {}

impl Dimensions for Polyline<'_> {
    /// The smallest rectangle of pixels that holds all points; a stroke reaches farther.
    fn bounding_box(&self) -> Rectangle {
        bounding_box(self)
    }
}
