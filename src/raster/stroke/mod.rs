//! Strokes: thick lines along any outline, with joins and caps.
//!
//! - **Takes** an [`Outline`] and a [`Stroke`]: width, [`Join`], [`Cap`](crate::Cap).
//! - **Gives** an outline again: closed pieces, all of them clockwise on the screen. Filled by the
//!   [non-zero rule](crate::Rule::NonZero) they are one shape, of which no pixel is drawn twice.
//! - **Memory** the first and the last segment of a contour, some 90 bytes.
//! - **Cost** of a trace: for each segment near the [heights](Pen::heights) that are wanted one integer square root and one division, for each mitered corner that
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

use core::ops::Range;

use heapless::vec::VecView;

use self::{
    direction::{Direction, between},
    join::{Ahead, Corner, Segment, is_gentle, turn_for},
};
use crate::{
    edge::LIMIT,
    num::Subpixel,
    outline::{Extent, FINE, FINE_ERROR, Outline, Pen, is_fine_within},
    pieces::Curve,
    raster::scan::{ActiveEdge, fill},
    space::{Point2, Rect},
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
    /// Whether it can be drawn in 256ths of a pixel, if that was looked at.
    is_fine: Option<bool>,
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
        Self { outline, shape: Shape::new(stroke, stroke.sixteenths()), is_fine: None }
    }

    /// The same, knowing whether it can be drawn in 256ths of a pixel, and the pixels outside of which there is nothing of
    /// it. One trace of the outline, for all of those to come.
    pub(in crate::raster) fn measured(self) -> (Self, Rect) {
        let (extent, reach) = (Extent::of(&self.outline), self.shape.reach());
        let bounds = extent.pixels_within(reach.saturating_add(FINE_ERROR));
        (Self { is_fine: Some(extent.is_fine_within(reach)), ..self }, bounds)
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
        if self.shape.width == 0 {
            return;
        }
        let large = self
            .shape
            .enlarged()
            .filter(|_| self.is_fine.unwrap_or_else(|| is_fine_within(&self.outline, self.shape.reach())));
        // One stroker for both, so that there is one machine code.
        let mut scaled = Scaled { pen, times: if large.is_some() { 1 } else { FINE } };
        let mut stroker = Stroker::new(&mut scaled, large.unwrap_or(self.shape));
        if large.is_some() {
            self.outline.trace_fine(&mut stroker);
        } else {
            self.outline.trace(&mut stroker);
        }
        stroker.end();
    }
}

/// Draws so many times as large. What comes is in range: strokes are.
struct Scaled<'p, P> {
    pen: &'p mut P,
    times: i32,
}

impl<P> Scaled<'_, P> {
    #[inline]
    const fn scaled(&self, point: Point2) -> Point2 {
        let [x, y] = [point.x.to_bits(), point.y.to_bits()];
        Point2::from_sixteenths(x.wrapping_mul(self.times), y.wrapping_mul(self.times))
    }
}

impl<P: Pen> Pen for Scaled<'_, P> {
    #[inline]
    fn move_to(&mut self, point: Point2) {
        self.pen.move_to(self.scaled(point));
    }

    #[inline]
    fn line_to(&mut self, point: Point2) {
        self.pen.line_to(self.scaled(point));
    }

    #[inline]
    fn close(&mut self) {
        self.pen.close();
    }

    #[inline]
    fn heights(&self) -> Range<Subpixel> {
        let wanted = self.pen.heights();
        if self.times == 1 {
            return wanted;
        }
        let [start, end] = [wanted.start, wanted.end].map(|height| height.to_bits() / FINE);
        Subpixel::from_bits(start - 1)..Subpixel::from_bits(end + 1)
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
    Segments(Ahead, Ahead),
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
        if run == (0, 0) {
            if matches!(self.path, Path::Begun) {
                self.path = Path::Point;
            }
            return;
        }
        let mut segment = Ahead::new(run);
        if let Path::Segments(_, mut last) = self.path {
            self.join(&mut last, &mut segment);
        }
        self.strip(&mut segment, point);
        self.path = match self.path {
            Path::Segments(first, _) => Path::Segments(first, segment),
            _ => Path::Segments(segment, segment),
        };
        self.last = point;
    }

    fn curve_to(&mut self, curve: &Curve) {
        let curve = if self.shape.is_large { curve.coarser() } else { *curve };
        curve.each(|vertex| self.line_to(vertex));
    }

    fn close(&mut self) {
        self.line_to(self.begin);
        if let Path::Segments(mut first, mut last) = self.path {
            self.join(&mut last, &mut first);
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
        match self.path {
            Path::Begun => {}
            // A closed contour of one point comes here, too.
            Path::Point => {
                self.cap(self.begin, Some(Direction::EAST.reversed()));
                self.cap(self.begin, Some(Direction::EAST));
            }
            Path::Segments(mut first, mut last) => {
                let backwards = self.direction(self.begin, &mut first).map(Direction::reversed);
                let ahead = self.direction(self.last, &mut last);
                self.cap(self.begin, backwards);
                self.cap(self.last, ahead);
            }
        }
        self.path = Path::Begun;
    }

    /// The direction of a segment, if the cap at one of its ends is of interest.
    fn direction(&self, end: Point2, segment: &mut Ahead) -> Option<Direction> {
        let is_seen = self.is_seen([end, end], self.shape.reach());
        if is_seen { Some(segment.segment(self.shape.width)?.direction) } else { None }
    }

    fn cap(&mut self, at: Point2, direction: Option<Direction>) {
        let Shape { stroke: Stroke { cap, .. }, width, turn, .. } = self.shape;
        if let Some(direction) = direction {
            cap::cap(at, direction, (cap, width, turn), self.pen);
        }
    }

    /// Whether what is no farther than `reach` from a segment is of interest.
    fn is_seen(&self, [from, to]: [Point2; 2], reach: u32) -> bool {
        let Range { start, end } = self.pen.heights();
        let (least, most) = (from.y.min(to.y), from.y.max(to.y));
        let reach = Subpixel::from_bits(reach.cast_signed());
        least.saturating_sub(reach) < end && most.saturating_add(reach) > start
    }

    fn strip(&mut self, segment: &mut Ahead, to: Point2) {
        let width = self.shape.width;
        if !self.is_seen([self.last, to], u32::from(width) / 2 + 2) {
            return;
        }
        let Some(Segment { side: right, .. }) = segment.segment(width) else { return };
        let left = right.reversed();
        self.pen.move_to(left.from(self.last));
        self.pen.line_to(left.from(to));
        self.pen.line_to(right.from(to));
        self.pen.line_to(right.from(self.last));
        self.pen.close();
    }

    fn join(&mut self, before: &mut Ahead, after: &mut Ahead) {
        let Shape { stroke, width, turn, .. } = self.shape;
        // Where the line turns by less than a right angle the tip is less than √2 times half the width away.
        let is_near = |reach: u32| self.is_seen([self.last, self.last], reach);
        if !is_near(self.shape.reach()) || !is_near(u32::from(width) * 3 / 4 + 2) && is_gentle(before.run, after.run) {
            return;
        }
        let (Some(before), Some(after)) = (before.segment(width), after.segment(width)) else { return };
        if let Some(corner) = Corner::between(self.last, before, after) {
            corner.join(stroke.join, width, turn, self.pen);
        }
    }
}
