//! Strokes: thick lines along any outline, with joins and caps.
//!
//! - **Takes** an [`Outline`] and a [`Stroke`]: width, [`Join`], [`Cap`](crate::Cap).
//! - **Gives** an outline again: closed pieces, all of them clockwise on the screen. Filled by the
//!   [non-zero rule](crate::Rule::NonZero) they are one shape, of which no pixel is drawn twice.
//! - **Memory** the first and the last segment of a contour, some 90 bytes.
//! - **Cost** of a trace: for each segment one integer square root and one division, for each mitered corner that
//!   can be seen two divisions, for each step of a round one four multiplications. Four edges a segment, three a
//!   bevel.
//!
//! ```text
//!      ┏━━━━━━━━━━━┯━━━━┓
//!      ┃   strip   │join┃        one strip a segment,
//!      ●┄┄┄┄┄┄┄┄┄┄┄●────┨        one join a corner, outside of the turn,
//!      ┃           ┊    ┃        one cap an end
//!      ┗━━━━━━━━━━━┽┄┄┄┄┃
//!                  ┃    ┃
//! ```
//!
//! **How exact.** A corner of a piece is rounded once, to the nearest sixteenth of a pixel in x and in y, so
//! it is at most 0.71 sixteenths from its place; those of square caps 1, the chords of round borders add ¼.
//! When the corners of a polygon move by at most ε, no point that is farther than ε from its border
//! changes sides. So each strip, join and cap is right for every pixel whose centre is farther than **1/16
//! pixel** from its border, and nothing is drawn farther than that outside of the stroke. Pieces that meet share
//! their corners to the bit, and an edge is walked exactly: no crack can open between them. Strokes
//! of whole width along the axes are exact.
//!
//! The rule is that of SVG: W3C, *Scalable Vector Graphics 2*, section 13.5.

mod cap;
pub mod dash;
mod direction;
pub(super) mod drawable;
mod join;
mod pieces;

use heapless::vec::VecView;

use self::{
    direction::{Direction, between},
    join::{Corner, Segment, turn_for},
};
use crate::{
    edge::LIMIT,
    outline::{FINE, Outline, Pen, is_fine_within, trace_enlarged},
    pieces::Curve,
    raster::scan::{ActiveEdge, fill},
    space::Point2,
    span::Sink,
    style::{Join, Rule, Stroke},
};

/// Points are moved to less than this many sixteenths from the origin, so that their borders are in range.
const REACH: u32 = LIMIT - (1 << 16);

/// The stroke of an outline: itself an outline, to be filled by the non-zero rule.
///
/// Segments without length are skipped. A contour that is nothing but a point becomes a disc or a square
/// by its caps, nothing with butt ones; one that was left open gets caps, one that was closed joins all around.
/// Where a line turns back on itself, a round join is half a disc, and the others end there like a butt cap.
///
/// Coordinates may be anything; points farther than 4,190,208 pixels from the origin are moved there. The width
/// is at most [`Stroke::WIDEST`], wider ones are drawn that wide; one that is not positive draws nothing.
///
/// For antialiasing all of that is done in 256ths of a pixel: [`trace_fine`](Outline::trace_fine).
///
/// ```
/// use aquatint::{Join, Point2, Polygon, Rect, Rule, SpanFn, Stroke, raster::{scan::ActiveEdge, stroke::Stroked}};
///
/// let corners = [(2, 2), (12, 2), (7, 9)].map(|(x, y)| Point2::corner(x, y));
/// let contours = [&corners[..]];
/// let triangle = Polygon::new(&contours).unwrap();
/// let border = Stroked::new(&triangle, Stroke::new(2).with_join(Join::Round));
///
/// let (mut edges, mut pixels) = (heapless::Vec::<ActiveEdge, 16>::new(), 0);
/// let mut sink = SpanFn::new(Rect::new(0, 0, 16, 16), |_, columns: core::ops::Range<i32>, ()| pixels += columns.len());
/// border.spans(&mut edges, &mut sink)?;
/// // The perimeter is 27.2 pixels, the width 2; what overlaps inside the corners counts once.
/// assert_eq!(pixels, 52);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Stroked<O> {
    outline: O,
    shape: Shape,
}

/// A stroke in the numbers that are needed.
#[derive(Clone, Copy, Debug)]
struct Shape {
    stroke: Stroke,
    /// In sixteenths of a pixel; zero draws nothing.
    width: u16,
    /// The step of round borders.
    turn: (i32, i32),
    /// Whether it is enlarged: then curves may be cut into fewer pieces, which are long ones.
    is_large: bool,
}

impl Shape {
    fn new(stroke: Stroke, width: u16) -> Self {
        Self { stroke, width, turn: turn_for(width), is_large: false }
    }

    /// The same sixteen times as wide, if that is in range.
    fn enlarged(&self) -> Option<Self> {
        let width = u16::try_from(i32::from(self.width) * FINE).ok()?;
        Some(Self { is_large: true, ..Self::new(self.stroke, width) })
    }

    /// How far from its line the stroke reaches in x or in y, in sixteenths, rounded up.
    fn reach(&self) -> u32 {
        // The corner of a square cap is √2 times half the width from the line, a tip `limit` times.
        let times = match self.stroke.join {
            Join::Miter { limit } => u32::from(limit).max(2),
            Join::Round | Join::Bevel => 2,
        };
        u32::from(self.width) * times / 2 + 2
    }
}

impl<O: Outline> Stroked<O> {
    /// The stroke of an outline, or of a reference to one.
    pub fn new(outline: O, stroke: Stroke) -> Self {
        Self { outline, shape: Shape::new(stroke, stroke.sixteenths()) }
    }

    /// Emits the spans of the whole inside the bounds of `sink`, from top to bottom and from left to right: [`fill`].
    ///
    /// Each pixel comes once. `edges` is scratch memory; a row crosses two edges for each segment there, two for each
    /// join or cap. Where the list is too short for a row the [fill](crate::raster::scan) is slow: then lend more, or draw
    /// [piece by piece](Self::spans_of_pieces).
    ///
    /// # Errors
    /// What the sink says.
    pub fn spans<S: Sink>(&self, edges: &mut VecView<ActiveEdge>, sink: &mut S) -> Result<(), S::Error> {
        fill(self, Rule::NonZero, edges, sink)
    }
}

impl<O: Outline> Outline for Stroked<O> {
    const WINDS_ONE_WAY: bool = true;

    fn trace<P: Pen>(&self, pen: &mut P) {
        if self.shape.width > 0 {
            let mut stroker = Stroker::new(pen, self.shape);
            self.outline.trace(&mut stroker);
            stroker.end();
        }
    }

    /// Corners are rounded to 256ths of a pixel where the stroke is less than 256 pixels wide and less than 262,144
    /// pixels from the origin. To know that, the inner outline is traced once more.
    fn trace_fine<P: Pen>(&self, pen: &mut P) {
        let large = self.shape.enlarged().filter(|_| is_fine_within(&self.outline, self.shape.reach()));
        let Some(shape) = large else { return trace_enlarged(self, pen) };
        if shape.width > 0 {
            let mut stroker = Stroker::new(pen, shape);
            self.outline.trace_fine(&mut stroker);
            stroker.end();
        }
    }
}

/// What has been drawn of a contour.
#[derive(Clone, Copy, Debug)]
enum Path {
    /// Nothing, not even a point.
    Begun,
    /// A point.
    Point,
    /// Segments; the first and the last of them.
    Segments(Segment, Segment),
}

/// The pen that the inner outline draws with.
struct Stroker<'p, P> {
    pen: &'p mut P,
    shape: Shape,
    begin: Point2,
    last: Point2,
    path: Path,
}

impl<P: Pen> Pen for Stroker<'_, P> {
    fn move_to(&mut self, point: Point2) {
        self.end();
        self.begin = point.clamped(REACH);
        self.last = self.begin;
    }

    fn line_to(&mut self, point: Point2) {
        let point = point.clamped(REACH);
        let run = between(self.last, point);
        let Some(direction) = Direction::of(run) else {
            if matches!(self.path, Path::Begun) {
                self.path = Path::Point;
            }
            return;
        };
        let segment = Segment { run, direction, side: direction.right().half(self.shape.width) };
        self.path = if let Path::Segments(first, last) = self.path {
            self.join(last, segment);
            Path::Segments(first, segment)
        } else {
            Path::Segments(segment, segment)
        };
        self.strip(segment, point);
        self.last = point;
    }

    fn curve_to(&mut self, curve: &Curve) {
        let curve = if self.shape.is_large { curve.coarser() } else { *curve };
        curve.each(|vertex| self.line_to(vertex));
    }

    fn close(&mut self) {
        self.line_to(self.begin);
        if let Path::Segments(first, last) = self.path {
            self.join(last, first);
            self.path = Path::Begun;
        }
    }
}

impl<'p, P: Pen> Stroker<'p, P> {
    fn new(pen: &'p mut P, shape: Shape) -> Self {
        Self { pen, shape, begin: Point2::default(), last: Point2::default(), path: Path::Begun }
    }

    /// A contour ends that has not been closed.
    fn end(&mut self) {
        let ends = match self.path {
            Path::Begun => return,
            // A closed contour of one point comes here, too.
            Path::Point => [(self.begin, Direction::EAST.reversed()), (self.begin, Direction::EAST)],
            Path::Segments(first, last) => [(self.begin, first.direction.reversed()), (self.last, last.direction)],
        };
        let Shape { stroke: Stroke { cap, .. }, width, turn, .. } = self.shape;
        for (at, direction) in ends {
            cap::cap(at, direction, (cap, width, turn), self.pen);
        }
        self.path = Path::Begun;
    }

    fn strip(&mut self, segment: Segment, to: Point2) {
        let (right, left) = (segment.side, segment.side.reversed());
        self.pen.move_to(left.from(self.last));
        self.pen.line_to(left.from(to));
        self.pen.line_to(right.from(to));
        self.pen.line_to(right.from(self.last));
        self.pen.close();
    }

    fn join(&mut self, before: Segment, after: Segment) {
        let Shape { stroke, width, turn, .. } = self.shape;
        if let Some(corner) = Corner::between(self.last, before, after) {
            corner.join(stroke.join, width, turn, self.pen);
        }
    }
}
