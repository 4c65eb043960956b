//! Piece by piece: the same pixels as those of the whole stroke, without looking for what overlaps.
//!
//! ```text
//!   united  ┏━━━━━┓      one by one  ┏━━━┯━┓      traced once, each piece
//!           ┃     ┃                  ┃   ├─┨      filled where it is met
//!           ┗━━━┓ ┃                  ┗━━━┥ ┃
//! ```
//!
//! All pieces are clockwise, so a pixel is in their union just when it is in one of them. What it costs grows with the
//! number of pieces and not with its square.

use heapless::Vec;

use super::Stroked;
use crate::{
    outline::{Outline, Pen},
    raster::scan::{ActiveEdge, fill},
    space::Point2,
    span::Sink,
    style::Rule,
};

impl<O: Outline> Stroked<O> {
    /// Emits the spans of one piece after the other, inside the bounds of `sink`: for ink that covers.
    ///
    /// The pixels are those of [`spans`](Self::spans), but around corners some come more than once, and rows come
    /// from top to bottom only within a piece. One trace, one fill of a few edges for each piece. 2.2 kB of the stack.
    ///
    /// # Errors
    /// What the sink says.
    pub fn spans_of_pieces<S: Sink>(&self, sink: &mut S) -> Result<(), S::Error> {
        let mut pieces = Pieces { sink, corners: Vec::new(), result: Ok(()) };
        self.trace(&mut pieces);
        pieces.result
    }
}

/// Fills each contour that is drawn: convex ones, and fans of triangles about their first point.
struct Pieces<'s, S: Sink> {
    sink: &'s mut S,
    corners: Vec<Point2, 8>,
    /// Once it is an error, nothing is filled.
    result: Result<(), S::Error>,
}

impl<S: Sink> Pieces<'_, S> {
    fn fill(&mut self) {
        if self.result.is_ok() {
            self.result = fill(&Piece(&self.corners), Rule::NonZero, &mut Vec::<ActiveEdge, 8>::new(), self.sink);
        }
    }
}

impl<S: Sink> Pen for Pieces<'_, S> {
    fn move_to(&mut self, point: Point2) {
        self.corners.clear();
        // There is room.
        let _ = self.corners.push(point);
    }

    fn line_to(&mut self, point: Point2) {
        if self.corners.is_full() {
            self.fill();
            // A long fan goes on with the triangle of its first point, the last one and this.
            if let [first, .., last] = *self.corners {
                self.corners.clear();
                let _ = self.corners.extend_from_slice(&[first, last]);
            }
        }
        let _ = self.corners.push(point);
    }

    fn close(&mut self) {
        self.fill();
        self.corners.clear();
    }
}

/// A closed contour.
struct Piece<'c>(&'c [Point2]);

impl Outline for Piece<'_> {
    fn trace<P: Pen>(&self, pen: &mut P) {
        let [first, rest @ ..] = self.0 else { return };
        pen.move_to(*first);
        for corner in rest {
            pen.line_to(*corner);
        }
        pen.close();
    }
}
