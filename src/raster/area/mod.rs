//! Area averaging: how much of each pixel an outline covers, exactly. Lecture 6.4.
//!
//! The inside of an outline by either winding rule, cut by the pixels; no samples. Each edge adds the area right of it
//! to the pixels that it crosses, on the left of the inside, or takes it away, on the right. Where contours overlap, only
//! the borders of their union may do so: there a row is cut into *bands* in which no edge begins, ends or crosses
//! another, so that the edges have an order and the rule says which of them are borders.
//!
//! | row | how | file |
//! |---|---|---|
//! | edges go through, each in pixels of its own | coverage of one edge, no sum | `apart.rs` |
//! | nothing overlaps | all edges are summed up, then it is looked at whether that was right | `plain.rs` |
//! | the rest | bands | `bands.rs` |
//! | more edges of a [stroke](super::stroke) than the list holds | all of them are summed up, what overlaps counts once | `union.rs` |
//! | more edges of other outlines | 16 strips, edge by edge | here |
//!
//! ```text
//!   ┌───┬───┬───┬───┐
//!   │  ╱│   │   │╲  │ ┐ one band           evenly: no pixel between two borders is looked at
//!   │ ╱ │   │   │ ╲ │ ┘
//!   ├╱──┼───┼───┼──╲┤
//!   │╲  │   │   │  ╱│ ┐ two, because       a corner lies in the row
//!   │ ╲ │   │   │ ╱ │ ┘ the edges turn
//!   └───┴───┴───┴───┘
//! ```
//!
//! - **Takes** any [`Outline`], traced [finely](Outline::trace_fine): corners on 256ths of a pixel.
//! - **Gives** spans with their [`Coverage`]: runs of even coverage, and pixel by pixel where edges are. Pixels that
//!   are not covered may be among them.
//! - **Memory** of the caller's: a list of edges, and cells for one row, two bytes each. Both may be short: cells for a
//!   part of the row are used again and again, and a row of more edges than the list holds is sampled in 16 strips.
//! - **Cost** an edge 100 instructions to set up (a division); then about 100 for each row that it crosses and 20 for
//!   each pixel; a division more for a row in which it crosses a column. A curve 150 for each of its pieces.
//!
//! **How exact.** An area is right to 0.05/256 of a pixel where no edges cross; shapes that abut sum to all of a pixel
//! but for 8/32768, and tiles agree as well, bands to the bit. Edges that cross are parted to 1/256 of a row: that is
//! 2/256 at most. In a row with more than 64 crossings it is 4/256, in one with more edges than the list holds 1/16.
//! A curve is right to 1.5/256 each time that it goes through a pixel. Of a stroke with more edges in a row than the list
//! holds, a pixel in which borders of two pieces cross may be covered too much, by at most what they share.
//!
//! Exact bands improve on the scan converter of cairo (`cairo-tor-scan-converter.c`), which falls back to 15 strips in
//! every row with a corner.

mod apart;
mod bands;
mod cells;
mod edge;
mod mask;
mod oversample;
mod plain;
mod union;

use core::ops::Range;

use heapless::vec::VecView;

use self::{
    bands::{add_bands, emit_between},
    cells::{Cells, Side, height_of},
    plain::{add_plain, take_back},
    union::add_union,
};
pub use self::{edge::AreaEdge, mask::CoverageMask, oversample::Oversampled};
use crate::{
    coverage::{Coverage, Covered},
    num::{index, low_index},
    outline::Outline,
    raster::{active::ActiveList, area::edge::PARTS},
    space::Rect,
    span::Sink,
    stretch::{columns, each_stretch},
    style::Rule,
};

/// Memory that [`fill`] works with. What it holds before and after means nothing.
#[derive(Debug)]
pub struct Scratch<'m> {
    /// 136 bytes each; 12 are enough for most shapes. It should hold all edges that reach into one row; a curve is one
    /// for each time that it goes down or up.
    pub edges: &'m mut VecView<AreaEdge>,
    /// Two bytes each; best as many as the row is wide. Any number will do.
    pub cells: &'m mut [Coverage],
}

/// Emits the coverage of what an outline encloses, from top to bottom and from left to right, inside the bounds of
/// `sink`. Open contours are closed by a straight edge.
///
/// ```
/// use aquatint::{Coverage, Covered, Point2, Polygon, Rect, Rule, SpanFn, raster::area::{Scratch, fill}};
///
/// // From the middle of one pixel to the middle of another.
/// let corners = [(8, 0), (40, 0), (40, 16), (8, 16)].map(|(x, y)| Point2::from_sixteenths(x, y));
/// let contours = [&corners[..]];
/// let square = Polygon::new(&contours).unwrap();
///
/// let (mut edges, mut cells) = (heapless::Vec::<_, 16>::new(), [Coverage::NONE; 8]);
/// let mut picture = [[0; 4]; 2];
/// let mut sink = SpanFn::new(Rect::new(0, 0, 4, 2), |row, columns: core::ops::Range<i32>, covered: Covered<'_>| {
///     for (offset, column) in columns.enumerate() {
///         picture[row as usize][column as usize] = covered.at(offset).to_byte();
///     }
/// });
/// fill(&square, Rule::NonZero, Scratch { edges: &mut edges, cells: &mut cells }, &mut sink)?;
/// assert_eq!(picture, [[128, 255, 128, 0], [0; 4]]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
///
/// # Errors
/// What the sink says.
pub fn fill<O, S, E>(outline: &O, rule: Rule, scratch: Scratch<'_>, sink: &mut S) -> Result<(), E>
where
    O: Outline,
    S: for<'c> Sink<Covered<'c>, Error = E>,
{
    let mut bounds = sink.bounds();
    if low_index(scratch.cells.len()) < bounds.width() {
        let columns = columns(outline);
        (bounds.left, bounds.right) = (bounds.left.max(columns.start), bounds.right.min(columns.end));
    }
    if bounds.is_empty() {
        return Ok(());
    }
    let mut spare = [Coverage::NONE];
    let cells = if scratch.cells.is_empty() { &mut spare[..] } else { scratch.cells };
    let width = cells.len().min(Cells::MOST).min(index(bounds.width().min(1 << 14).cast_signed()));
    let Some(cells) = cells.get_mut(..width) else { return Ok(()) };
    cells.fill(Coverage::NONE);
    let mut scan = Scan { outline, rule, list: ActiveList::new(scratch.edges), cells, bounds };
    let mut row = bounds.top;
    while row < bounds.bottom {
        scan.enter(row);
        let is_known = scan.list.knows(row);
        let change = if is_known { scan.list.next_change(row).min(bounds.bottom) } else { row + 1 };
        if !(is_known && scan.list.active().is_empty()) {
            scan.emit_rows(row..change, sink)?;
        }
        row = change;
    }
    Ok(())
}

/// The state between rows.
struct Scan<'o, 'l, O> {
    outline: &'o O,
    rule: Rule,
    list: ActiveList<'l, AreaEdge>,
    cells: &'l mut [Coverage],
    bounds: Rect,
}

impl<O: Outline> Scan<'_, '_, O> {
    fn enter(&mut self, row: i32) {
        let outline = self.outline;
        self.list.enter(row, |list| {
            each_stretch(outline, |stretch| {
                list.offer(AreaEdge::rows_of(&stretch), row, |first_row| AreaEdge::new(stretch, first_row));
            });
        });
    }

    /// The rows that all active edges go through from border to border.
    fn whole_rows(&mut self) -> Range<i32> {
        let rows = self.list.active().iter().map(AreaEdge::whole_rows);
        rows.fold(i32::MIN..i32::MAX, |all, rows| all.start.max(rows.start)..all.end.min(rows.end))
    }

    /// Rows in which the same edges are active.
    #[inline]
    fn emit_rows<S, E>(&mut self, rows: Range<i32>, sink: &mut S) -> Result<(), E>
    where
        S: for<'c> Sink<Covered<'c>, Error = E>,
    {
        let whole = self.whole_rows();
        let is_one_part = self.bounds.width() <= low_index(self.cells.len()) && self.list.knows(rows.start);
        let mut row = rows.start;
        while row < rows.end {
            if is_one_part && whole.contains(&row) {
                let mut cells = Cells::new(self.cells, self.bounds.left);
                let rows = row..rows.end.min(whole.end);
                row = apart::emit_rows(self.list.active(), rows, (&mut cells, self.rule), sink)?;
            }
            if row < rows.end {
                self.emit_row(row, sink)?;
                row += 1;
            }
        }
        Ok(())
    }

    /// One row, in as many parts as the cells make of it.
    fn emit_row<S, E>(&mut self, row: i32, sink: &mut S) -> Result<(), E>
    where
        S: for<'c> Sink<Covered<'c>, Error = E>,
    {
        let Rect { left, right, .. } = self.bounds;
        let is_known = self.list.knows(row);
        let edges = self.list.active();
        edges.iter_mut().for_each(AreaEdge::begin_row);
        let mut at = left;
        while at < right {
            let length = right.abs_diff(at).min(low_index(self.cells.len()));
            let cells = self.cells.get_mut(..index(length.cast_signed())).unwrap_or_default();
            let mut cells = Cells::new(cells, at);
            if is_known {
                add_row(edges, &mut cells, row, self.rule);
                emit_between(edges, &mut cells, row, sink)?;
            } else if O::WINDS_ONE_WAY && self.rule == Rule::NonZero {
                add_union(self.outline, &mut cells, row);
                cells.emit_all(row, sink)?;
            } else {
                add_strips(self.outline, &mut cells, row, self.rule);
                cells.emit_all(row, sink)?;
            }
            at = at.saturating_add_unsigned(length);
        }
        edges.iter_mut().for_each(AreaEdge::advance);
        Ok(())
    }
}

/// Adds what lies inside of a row.
fn add_row(edges: &mut [AreaEdge], cells: &mut Cells, row: i32, rule: Rule) {
    let begin = |edges: &mut [AreaEdge]| edges.iter_mut().for_each(|edge| edge.begin_part(row));
    begin(edges);
    if !add_plain(edges, cells, row) {
        take_back(edges, cells);
        begin(edges);
        add_bands(edges, cells, row, rule);
    }
}

/// Adds a row of which there is no list of edges: 16 strips, in which the edges are upright.
#[cold]
fn add_strips<O: Outline>(outline: &O, cells: &mut Cells, row: i32, rule: Rule) {
    for middle in (PARTS / 32..PARTS).step_by(16) {
        let (mut left, mut winding) = (i64::MIN, 0_i32);
        // The nearest crossing right of `left` again and again.
        while let Some((x, winds)) = next_crossing(outline, (row, middle), left) {
            if let Some(side) = Side::passed(&mut winding, winds, rule) {
                cells.add_edge((x, x), height_of(PARTS / 16), side);
            }
            left = x;
        }
    }
}

/// Where edges cross the middle of a strip next to the right, and what they wind there together.
fn next_crossing<O: Outline>(outline: &O, (row, middle): (i32, i32), left: i64) -> Option<(i64, i32)> {
    let mut next: Option<(i64, i32)> = None;
    each_stretch(outline, |stretch| {
        if !AreaEdge::rows_of(&stretch).contains(&row) {
            return;
        }
        let mut edge = AreaEdge::new(stretch, row);
        while edge.go_on(row, middle) {}
        let x = edge.at(middle);
        if edge.crosses(row, middle) && x > left {
            next = Some(match next {
                Some((nearest, winding)) if x == nearest => (nearest, winding + edge.winding()),
                Some((nearest, winding)) if x > nearest => (nearest, winding),
                _ => (x, edge.winding()),
            });
        }
    });
    next
}
