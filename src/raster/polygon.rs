//! Scanline polygon fill: any number of contours, concave, crossing themselves, with holes.
//! Lecture 4.2.
//!
//! Vertices that lie on a scanline, horizontal edges and coincident edges (lecture 4.2.3) need no
//! special care: centres lie at halves, every edge owns a half-open range of rows, a horizontal
//! edge owns none, and crossings in the same column are summed before the rule is asked.
//!
//! The machine is [`scan`](super::scan), for every kind of outline.

use heapless::vec::VecView;

use crate::{
    edge::LIMIT,
    error::OutOfRange,
    outline::{Outline, Pen},
    raster::scan::{ActiveEdge, fill},
    space::Point2,
    span::Sink,
    style::Rule,
};

/// Closed contours of straight edges. The last vertex of each is joined to its first.
///
/// ```
/// use aquatint::{FillStyle, Point2, Polygon};
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
///
/// let outside = [(0, 0), (7, 0), (7, 5), (0, 5)].map(|(x, y)| Point2::corner(x, y));
/// let hole = [(2, 2), (2, 3), (5, 3), (5, 2)].map(|(x, y)| Point2::corner(x, y));
/// let contours = [&outside[..], &hole[..]];
/// let frame = Polygon::new(&contours).unwrap();
///
/// let mut display = MockDisplay::new();
/// frame.into_styled(FillStyle::new(BinaryColor::On)).draw(&mut display)?;
/// display.assert_pattern(&[
///     "#######",
///     "#######",
///     "##   ##",
///     "#######",
///     "#######",
/// ]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Polygon<'a> {
    contours: &'a [&'a [Point2]],
}

impl<'a> Polygon<'a> {
    /// Borrows and checks contours. Contours of fewer than three vertices hold no pixel.
    ///
    /// # Errors
    /// [`OutOfRange`] when a vertex is 4,194,304 pixels or more from the origin.
    pub fn new(contours: &'a [&'a [Point2]]) -> Result<Self, OutOfRange> {
        let in_range = contours.iter().all(|contour| contour.iter().all(|vertex| vertex.within(LIMIT)));
        if in_range { Ok(Self { contours }) } else { Err(OutOfRange) }
    }

    /// Emits the spans inside the bounds of `sink`, from top to bottom and from left to right: [`fill`].
    ///
    /// # Errors
    /// What the sink says.
    pub fn spans<S: Sink>(&self, rule: Rule, edges: &mut VecView<ActiveEdge>, sink: &mut S) -> Result<(), S::Error> {
        fill(self, rule, edges, sink)
    }
}

impl Outline for Polygon<'_> {
    #[inline]
    fn trace<P: Pen>(&self, pen: &mut P) {
        for contour in self.contours {
            if let [first, rest @ ..] = contour {
                pen.move_to(*first);
                for vertex in rest {
                    pen.line_to(*vertex);
                }
                pen.close();
            }
        }
    }
}
