//! Scan conversion of outlines, the machine of the [polygon fill](super::polygon). Lecture 4.2.
//!
//! Row by row, the edges that cross the row's centre line are kept sorted by the column of the
//! crossing; walking along them from the left, the fill rule says between which of them is inside.
//!
//! ```text
//!   row y  ·····┃·####┃···┃#######┃··     crossings, from left to right
//!   winding   0    1    0     1     0     non-zero: filled where it is not 0
//! ```
//!
//! **Memory** is one list of edges of the caller's, 32 bytes each. Besides those that cross the row it holds as many of
//! those that begin next as there is room for, so that the outline is not traced again for each of them.
//!
//! A row with more active edges than the list holds is filled by tracing the outline for one
//! crossing after the other: slower (6 to 50 times), with the same pixels. The list's length is a
//! matter of speed alone.

use core::ops::Range;

use embedded_graphics::geometry::Point;
use heapless::vec::VecView;

use crate::{
    edge::Edge,
    outline::{Outline, each_edge},
    raster::active::{ActiveList, RowEdge, sort_by_key},
    space::Rect,
    span::Sink,
    style::Rule,
};

/// An edge that crosses the present row, or that waits for its first row.
#[derive(Clone, Copy, Debug)]
pub struct ActiveEdge {
    edge: Edge,
    first_row: i32,
    end_row: i32,
    winding: i32,
}

/// Emits the spans of what an outline encloses, from top to bottom and from left to right, inside the
/// bounds of `sink`. Open contours are closed by a straight edge.
///
/// `edges` is scratch memory, emptied first; see the [module](self) on its length. Cost: one trace of the
/// outline each time that the list has run empty of waiting edges, one edge set-up (a 64-bit division at
/// most) for each visible edge, an addition for each edge and row.
///
/// # Errors
/// What the sink says.
pub fn fill<O: Outline, S: Sink>(
    outline: &O,
    rule: Rule,
    edges: &mut VecView<ActiveEdge>,
    sink: &mut S,
) -> Result<(), S::Error> {
    let bounds = sink.bounds();
    if bounds.is_empty() {
        return Ok(());
    }
    let mut scan = Scan { outline, list: ActiveList::new(edges) };
    let mut row = bounds.top;
    while row < bounds.bottom {
        scan.enter(row);
        let change = scan.list.next_change(row).min(bounds.bottom);
        let is_known = scan.list.knows(row);
        match scan.list.active() {
            [] if is_known => {}
            [one, other] if is_known => emit_pair(row..change, (&mut one.edge, &mut other.edge), sink)?,
            _ => scan.emit(row..change, rule, sink)?,
        }
        row = change;
    }
    Ok(())
}

impl RowEdge for ActiveEdge {
    #[inline]
    fn first_row(&self) -> i32 {
        self.first_row
    }

    #[inline]
    fn end_row(&self) -> i32 {
        self.end_row
    }
}

/// The most edges that cross one row: how long a list must be for [`fill`] never to be slow.
///
/// No memory; cost is that of as many traces as the outline has edges.
///
/// ```
/// use aquatint::{Point2, Polygon, raster::scan::peak_edges};
///
/// let zigzag = [(0, 0), (2, 9), (4, 0), (6, 9), (8, 0), (10, 9)].map(|(x, y)| Point2::corner(x, y));
/// assert_eq!(peak_edges(&Polygon::new(&[&zigzag]).unwrap()), 6);
/// ```
#[must_use]
pub fn peak_edges<O: Outline>(outline: &O) -> usize {
    let mut peak = 0;
    // The number grows only where an edge begins.
    each_edge(outline, |begins| {
        let (row, mut active) = (begins.first_row(), 0_usize);
        each_edge(outline, |edge| active += usize::from((edge.first_row()..edge.end_row()).contains(&row)));
        peak = peak.max(active);
    });
    peak
}

/// Whether the centre of a pixel is inside of an outline: whether [`fill`] fills it. One trace, no memory.
#[must_use]
pub fn contains<O: Outline>(outline: &O, rule: Rule, pixel: Point) -> bool {
    let mut winding = 0_i32;
    each_edge(outline, |edge| {
        let owns = (edge.first_row()..edge.end_row()).contains(&pixel.y);
        if owns && Edge::new(edge.upper, edge.lower, pixel.y).column() <= pixel.x {
            winding = winding.wrapping_add(edge.winding);
        }
    });
    winding & rule.mask() != 0
}

/// The state between rows.
struct Scan<'o, 'l, O> {
    outline: &'o O,
    list: ActiveList<'l, ActiveEdge>,
}

impl<O: Outline> Scan<'_, '_, O> {
    fn enter(&mut self, row: i32) {
        let outline = self.outline;
        self.list.enter(row, |list| {
            each_edge(outline, |edge| {
                let end_row = edge.end_row();
                list.offer(edge.first_row()..end_row, row, |first_row| ActiveEdge {
                    edge: Edge::new(edge.upper, edge.lower, first_row),
                    first_row,
                    end_row,
                    winding: edge.winding,
                });
            });
        });
    }

    /// The spans of rows that have the same active edges.
    fn emit<S: Sink>(&mut self, rows: Range<i32>, rule: Rule, sink: &mut S) -> Result<(), S::Error> {
        for row in rows {
            let mut crossings = Crossings::new(rule, sink.bounds(), row);
            if !self.list.knows(row) {
                self.emit_by_selection(&mut crossings, sink)?;
                continue;
            }
            let active = self.list.active();
            sort_by_key(active, |active| active.edge.column());
            for active in active {
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
        let mut left = i64::MIN;
        loop {
            // The nearest column right of `left`, and what the crossings there wind together.
            let mut next: Option<(i32, i32)> = None;
            each_edge(self.outline, |edge| {
                if !(edge.first_row()..edge.end_row()).contains(&at) {
                    return;
                }
                let column = Edge::new(edge.upper, edge.lower, at).column();
                if i64::from(column) > left {
                    next = Some(match next {
                        Some((nearest, _)) if column < nearest => (column, edge.winding),
                        Some((nearest, winding)) if column == nearest => (nearest, winding + edge.winding),
                        Some(nearer) => nearer,
                        None => (column, edge.winding),
                    });
                }
            });
            let Some((column, winding)) = next else { return row.finish(sink) };
            row.cross(column, winding, sink)?;
            left = i64::from(column);
        }
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
        Self { mask: rule.mask(), bounds, row, winding: 0, from: i32::MIN, to: i32::MIN }
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
