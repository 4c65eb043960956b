//! Scanline polygon fill: any number of contours, concave, crossing themselves, with holes.
//! Lecture 4.2.
//!
//! Row by row, the edges that cross the row's centre line are kept in a list sorted by the column
//! of the crossing; walking along them from the left, the fill rule says between which of them is
//! inside.
//!
//! ```text
//!   row y  ·····┃·####┃···┃#######┃··     crossings, from left to right
//!   winding   0    1    0     1     0     non-zero: filled where it is not 0
//! ```
//!
//! Vertices that lie on a scanline, horizontal edges and coincident edges (lecture 4.2.3) need no
//! special care: centres lie at halves, every edge owns a half-open range of rows, a horizontal
//! edge owns none, and crossings in the same column are summed before the rule is asked.
//!
//! **Memory** is a list of active edges of the caller's, 28 bytes each. A row with more active
//! edges than it holds is filled by searching the vertices for one crossing after the other:
//! slower (6 to 50 times), with the same pixels. The list's length is a matter of speed alone.

use core::ops::Range;

use embedded_graphics::{
    draw_target::DrawTarget,
    geometry::Dimensions,
    pixelcolor::PixelColor,
    primitives::{Primitive, Rectangle, StyledDimensions, StyledDrawable},
};
use heapless::vec::{Vec, VecView};

use crate::{
    edge::{Edge, LIMIT, first_row},
    error::OutOfRange,
    space::{Point2, Rect},
    span::Sink,
    style::{FillStyle, Rule},
    target::Paint,
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

/// An edge that crosses the present row.
#[derive(Clone, Copy, Debug)]
pub struct ActiveEdge {
    edge: Edge,
    end_row: i32,
    winding: i32,
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

    /// Emits the spans inside the bounds of `sink`, from top to bottom and from left to right.
    ///
    /// `active` is scratch memory, emptied first; see the [module](self) on its length. Cost: one look at
    /// each vertex for every row in which an edge begins, one edge set-up for each visible edge, an
    /// addition for each edge and row.
    ///
    /// # Errors
    /// What the sink says.
    pub fn spans<S: Sink>(&self, rule: Rule, active: &mut VecView<ActiveEdge>, sink: &mut S) -> Result<(), S::Error> {
        let bounds = sink.bounds();
        if bounds.is_empty() {
            return Ok(());
        }
        active.clear();
        let mut scan = Scan { polygon: self, active, next_start: i32::MIN, is_complete: false };
        let mut row = bounds.top;
        while row < bounds.bottom {
            scan.enter(row);
            let change = scan.next_change(row).min(bounds.bottom);
            match scan.active.as_mut_slice() {
                [] if scan.is_complete => {}
                [one, other] => emit_pair(row..change, (&mut one.edge, &mut other.edge), sink)?,
                _ => scan.emit(row..change, rule, sink)?,
            }
            row = change;
        }
        Ok(())
    }

    /// Every edge that owns a row: its upper end, its lower end, and which way it winds.
    fn edges(&self) -> impl Iterator<Item = (Point2, Point2, i32)> + 'a {
        let pairs = |contour: &'a [Point2]| contour.iter().zip(contour.iter().cycle().skip(1));
        self.contours.iter().flat_map(move |contour| pairs(contour)).filter_map(|(&a, &b)| {
            let (upper, lower, winding) = if a.y <= b.y { (a, b, 1) } else { (b, a, -1) };
            (first_row(upper.y.to_bits()) < first_row(lower.y.to_bits())).then_some((upper, lower, winding))
        })
    }
}

/// The state between rows.
struct Scan<'p, 'l> {
    polygon: &'p Polygon<'p>,
    active: &'l mut VecView<ActiveEdge>,
    /// The first row at which an edge begins that is not in the list yet.
    next_start: i32,
    /// Whether the list holds all edges of the present row.
    is_complete: bool,
}

impl Scan<'_, '_> {
    /// Brings the list up to `row`: drops the edges that have ended, takes in those that begin.
    fn enter(&mut self, row: i32) {
        self.active.retain(|edge| row < edge.end_row);
        if self.is_complete && row < self.next_start {
            return;
        }
        let only_new = self.is_complete;
        if !only_new {
            self.active.clear();
        }
        self.is_complete = true;
        self.next_start = i32::MAX;
        for (upper, lower, winding) in self.polygon.edges() {
            let (first, end_row) = (first_row(upper.y.to_bits()), first_row(lower.y.to_bits()));
            if first > row {
                self.next_start = self.next_start.min(first);
            } else if row < end_row && (first == row || !only_new) {
                let edge = ActiveEdge { edge: Edge::new(upper, lower, row), end_row, winding };
                self.is_complete &= self.active.push(edge).is_ok();
            }
        }
        if !self.is_complete {
            self.active.clear();
        }
    }

    /// The first row below `row` in which other edges are active.
    fn next_change(&self, row: i32) -> i32 {
        if !self.is_complete {
            return row.saturating_add(1);
        }
        self.active.iter().map(|edge| edge.end_row).fold(self.next_start, i32::min)
    }

    /// The spans of rows that have the same active edges.
    fn emit<S: Sink>(&mut self, rows: Range<i32>, rule: Rule, sink: &mut S) -> Result<(), S::Error> {
        for row in rows {
            let mut crossings = Crossings::new(rule, sink.bounds(), row);
            if !self.is_complete {
                self.emit_by_selection(&mut crossings, sink)?;
                continue;
            }
            sort_by_column(self.active);
            for active in self.active.iter_mut() {
                crossings.cross(active.edge.column(), active.winding, sink)?;
                active.edge.advance();
            }
            crossings.finish(sink)?;
        }
        Ok(())
    }

    /// Without a list: looks for the next crossing to the right again and again.
    #[cold]
    fn emit_by_selection<S: Sink>(&self, row: &mut Crossings, sink: &mut S) -> Result<(), S::Error> {
        let at = row.row;
        let crossings = || {
            self.polygon.edges().filter_map(|(upper, lower, winding)| {
                let owned = first_row(upper.y.to_bits())..first_row(lower.y.to_bits());
                owned.contains(&at).then(|| (Edge::new(upper, lower, at).column(), winding))
            })
        };
        let next =
            |left: i64| crossings().filter(|&(column, _)| i64::from(column) > left).min_by_key(|&(column, _)| column);
        let mut left = i64::MIN;
        while let Some((column, _)) = next(left) {
            let winding = crossings().filter(|&(c, _)| c == column).map(|(_, winding)| winding).sum();
            row.cross(column, winding, sink)?;
            left = i64::from(column);
        }
        row.finish(sink)
    }
}

/// The spans of rows with two edges: contours are closed, so one leads in and the other out by any rule.
fn emit_pair<S: Sink>(rows: Range<i32>, (one, other): (&mut Edge, &mut Edge), sink: &mut S) -> Result<(), S::Error> {
    let Rect { left, right, .. } = sink.bounds();
    for row in rows {
        let (a, b) = (one.column(), other.column());
        let columns = a.min(b).max(left)..a.max(b).min(right);
        if !columns.is_empty() {
            sink.span(row, columns, ())?;
        }
        one.advance();
        other.advance();
    }
    Ok(())
}

/// Insertion sort: between rows almost nothing changes its place, and the code is small.
fn sort_by_column(active: &mut [ActiveEdge]) {
    if active.is_sorted_by_key(|active| active.edge.column()) {
        return;
    }
    for end in 2..=active.len() {
        let Some(mut sorted) = active.get_mut(..end) else { return };
        while let [rest @ .., left, right] = sorted {
            if left.edge.column() <= right.edge.column() {
                break;
            }
            core::mem::swap(left, right);
            let next = rest.len() + 1;
            let Some(shorter) = sorted.get_mut(..next) else { return };
            sorted = shorter;
        }
    }
}

/// The walk along one row: takes crossings from left to right, gives spans.
struct Crossings {
    /// The bits of the winding number that the rule looks at: all, or the lowest.
    mask: i32,
    bounds: Rect,
    row: i32,
    winding: i32,
    /// The last span, held back because another may follow without a gap.
    from: i32,
    to: i32,
}

impl Crossings {
    #[inline]
    const fn new(rule: Rule, bounds: Rect, row: i32) -> Self {
        let mask = match rule {
            Rule::NonZero => -1,
            Rule::EvenOdd => 1,
        };
        Self { mask, bounds, row, winding: 0, from: i32::MIN, to: i32::MIN }
    }

    #[inline]
    fn cross<S: Sink>(&mut self, column: i32, winding: i32, sink: &mut S) -> Result<(), S::Error> {
        let was_inside = self.winding & self.mask != 0;
        self.winding = self.winding.wrapping_add(winding);
        let is_inside = self.winding & self.mask != 0;
        if was_inside && !is_inside {
            self.to = column;
        } else if is_inside && !was_inside && column > self.to {
            self.finish(sink)?;
            self.from = column;
        }
        Ok(())
    }

    /// Emits what was held back.
    #[inline]
    fn finish<S: Sink>(&mut self, sink: &mut S) -> Result<(), S::Error> {
        if self.from >= self.to {
            return Ok(());
        }
        let columns = self.from.max(self.bounds.left)..self.to.min(self.bounds.right);
        if columns.is_empty() { Ok(()) } else { sink.span(self.row, columns, ()) }
    }
}

impl Primitive for Polygon<'_> {}

impl Dimensions for Polygon<'_> {
    /// The smallest rectangle of pixels that holds all corners of the polygon.
    fn bounding_box(&self) -> Rectangle {
        let vertices = || self.contours.iter().flat_map(|contour| contour.iter());
        let range = |axis: fn(&Point2) -> i32| Some((vertices().map(axis).min()?, vertices().map(axis).max()?));
        let bounds = range(|v| v.x.to_bits()).zip(range(|v| v.y.to_bits()));
        bounds.map_or(Rectangle::zero(), |((left, right), (top, bottom))| {
            Rect::new(left >> 4, top >> 4, (right + 15) >> 4, (bottom + 15) >> 4).into()
        })
    }
}

impl<C: PixelColor> StyledDimensions<FillStyle<C>> for Polygon<'_> {
    fn styled_bounding_box(&self, _style: &FillStyle<C>) -> Rectangle {
        self.bounding_box()
    }
}

impl<C: PixelColor> StyledDrawable<FillStyle<C>> for Polygon<'_> {
    type Color = C;
    type Output = ();

    /// Lends the fill a list of 16 active edges on the stack, 448 bytes.
    fn draw_styled<D: DrawTarget<Color = C>>(&self, style: &FillStyle<C>, target: &mut D) -> Result<(), D::Error> {
        let mut active = Vec::<ActiveEdge, 16>::new();
        self.spans(style.rule, &mut active, &mut Paint::new(target, style.color))
    }
}
