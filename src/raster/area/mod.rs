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
//! | more edges of other outlines | 16 strips, edge by edge | `strips.rs` |
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
mod strips;
mod task;
mod union;

use core::ops::Range;

use heapless::vec::VecView;

pub(super) use self::edge::Straight;
use self::{
    bands::{add_bands, emit_between},
    cells::Cells,
    edge::Curved,
    plain::{add_plain, take_back},
    strips::add_strips,
    task::Task,
    union::{Union, emit_edges},
};
pub use self::{edge::AreaEdge, mask::CoverageMask, oversample::Oversampled};
use crate::{
    coverage::{Coverage, Covered},
    num::{count_i32, index, low_index},
    outline::Outline,
    raster::active::ActiveList,
    space::Rect,
    span::Sink,
    stretch::Columns,
    style::Rule,
};

/// Memory that [`fill`] works with. What it holds before and after means nothing.
#[derive(Debug)]
pub struct Scratch<'m> {
    /// 120 bytes each; 12 are enough for most shapes. It should hold all edges that reach into one row; a curve is one
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
    let Scratch { edges, cells } = scratch;
    fill_by(outline, rule, (edges, usize::MAX), (cells, sink))
}

/// Fills by a rule that is a type, so that what is not needed for it is not linked. Rows with more than `most` edges are
/// summed up as those are that have more than the list holds, if the outline winds one way.
pub(super) fn fill_by<O, R, C, S, E>(
    outline: &O,
    rule: R,
    (edges, most): (&mut VecView<AreaEdge<C>>, usize),
    (cells, sink): (&mut [Coverage], &mut S),
) -> Result<(), E>
where
    O: Outline,
    R: Into<Rule> + Copy,
    C: Curved,
    S: for<'c> Sink<Covered<'c>, Error = E>,
{
    let mut bounds = sink.bounds();
    if low_index(cells.len()) < bounds.width() {
        let mut columns = Columns::NONE;
        Task::<C>::Measure(&mut columns).trace(outline);
        let columns = columns.range();
        (bounds.left, bounds.right) = (bounds.left.max(columns.start), bounds.right.min(columns.end));
    }
    if bounds.is_empty() {
        return Ok(());
    }
    let mut spare = [Coverage::NONE];
    let cells = if cells.is_empty() { &mut spare[..] } else { cells };
    let width = cells.len().min(Cells::MOST).min(index(bounds.width().min(1 << 14).cast_signed()));
    cells.get_mut(..width).unwrap_or_default().fill(Coverage::NONE);
    let mut scan = Scan { outline, rule, list: ActiveList::new(edges), most, cells, width, bounds };
    let mut row = bounds.top;
    while row < bounds.bottom {
        scan.enter(row);
        let is_known = scan.list.knows(row);
        let change = scan.list.next_change(row).min(bounds.bottom);
        if !(is_known && scan.list.active().is_empty()) {
            scan.emit_rows(row..change, sink)?;
        }
        row = change;
    }
    Ok(())
}

/// The rule of strokes.
#[derive(Clone, Copy)]
pub(super) struct NonZero;

impl From<NonZero> for Rule {
    #[inline]
    fn from(_: NonZero) -> Self {
        Self::NonZero
    }
}

/// The state between rows.
struct Scan<'o, 'l, O, R, C> {
    outline: &'o O,
    rule: R,
    list: ActiveList<'l, AreaEdge<C>>,
    /// How many edges may cross a row whose bands are looked for.
    most: usize,
    /// All that were lent.
    cells: &'l mut [Coverage],
    /// How many of them a row takes, or the part of one.
    width: usize,
    bounds: Rect,
}

impl<O: Outline, R: Into<Rule> + Copy, C: Curved> Scan<'_, '_, O, R, C> {
    fn enter(&mut self, row: i32) {
        let outline = self.outline;
        self.list.enter(row, |list| {
            Task::Collect(list, row).trace(outline);
        });
    }

    /// The rows that all active edges go through from border to border.
    fn whole_rows(&mut self) -> Range<i32> {
        let rows = self.list.active().iter().map(AreaEdge::whole_rows);
        rows.fold(i32::MIN..i32::MAX, |all, rows| all.start.max(rows.start)..all.end.min(rows.end))
    }

    /// Rows in which the same edges are active, or more than the list can hold.
    #[inline]
    fn emit_rows<S, E>(&mut self, rows: Range<i32>, sink: &mut S) -> Result<(), E>
    where
        S: for<'c> Sink<Covered<'c>, Error = E>,
    {
        if !self.list.knows(rows.start) {
            return self.emit_crowded(rows, sink);
        }
        let whole = self.whole_rows();
        let mut row = rows.start;
        while row < rows.end {
            if self.is_one_part() && whole.contains(&row) && (!C::ARE_NONE || self.list.active().len() <= self.most) {
                let mut cells = Cells::new(self.cells.get_mut(..self.width).unwrap_or_default(), self.bounds.left);
                let rows = row..rows.end.min(whole.end);
                row = apart::emit_rows(self.list.active(), rows, (&mut cells, self.rule.into()), sink)?;
            }
            if row < rows.end {
                self.emit_row(row, sink)?;
                row += 1;
            }
        }
        Ok(())
    }

    /// Whether what overlaps may be summed up.
    fn is_union(&self) -> bool {
        O::WINDS_ONE_WAY && self.rule.into() == Rule::NonZero
    }

    /// Whether the cells hold a whole row.
    fn is_one_part(&self) -> bool {
        self.bounds.width() <= low_index(self.width)
    }

    /// How many cells the part of a row has that begins in a column.
    fn cells_from(&self, at: i32) -> usize {
        index(self.bounds.right.abs_diff(at).min(low_index(self.width)).cast_signed())
    }

    /// One row, in as many parts as the cells make of it. Its stack is not needed while the outline is traced.
    #[cfg_attr(target_os = "none", inline(never))]
    fn emit_row<S, E>(&mut self, row: i32, sink: &mut S) -> Result<(), E>
    where
        S: for<'c> Sink<Covered<'c>, Error = E>,
    {
        let is_united = C::ARE_NONE && self.is_union() && self.list.active().len() > self.most;
        self.list.active().iter_mut().for_each(AreaEdge::begin_row);
        let mut at = self.bounds.left;
        while at < self.bounds.right {
            let length = self.cells_from(at);
            let (edges, cells) = (self.list.active(), self.cells.get_mut(..length).unwrap_or_default());
            let mut cells = Cells::new(cells, at);
            if is_united {
                emit_edges(edges, &mut cells, row, sink)?;
            } else {
                add_row(edges, &mut cells, row, self.rule.into());
                emit_between(edges, &mut cells, row, sink)?;
            }
            at = at.saturating_add(count_i32(length));
        }
        self.list.active().iter_mut().for_each(AreaEdge::advance);
        Ok(())
    }

    /// Rows of which there is no list.
    #[cold]
    fn emit_crowded<S, E>(&mut self, rows: Range<i32>, sink: &mut S) -> Result<(), E>
    where
        S: for<'c> Sink<Covered<'c>, Error = E>,
    {
        let mut row = rows.start;
        while row < rows.end {
            let mut next = row.saturating_add(1);
            let mut at = self.bounds.left;
            while at < self.bounds.right {
                let length = self.cells_from(at);
                if self.is_union() {
                    let most = if self.is_one_part() { count_i32(self.cells.len() / length.max(1)) } else { 1 };
                    next = rows.end.min(row.saturating_add(most));
                    Union::new(self.cells, (at, length), row..next).emit::<C, _, _, _>(self.outline, sink)?;
                } else {
                    let mut cells = Cells::new(self.cells.get_mut(..length).unwrap_or_default(), at);
                    add_strips::<C, O>(self.outline, &mut cells, row, self.rule.into());
                    cells.emit_all(row, sink)?;
                }
                at = at.saturating_add(count_i32(length));
            }
            row = next;
        }
        Ok(())
    }
}

/// Adds what lies inside of a row.
fn add_row<C: Curved>(edges: &mut [AreaEdge<C>], cells: &mut Cells, row: i32, rule: Rule) {
    let begin = |edges: &mut [AreaEdge<C>]| edges.iter_mut().for_each(|edge| edge.begin_part(row));
    begin(edges);
    if !add_plain(edges, cells, row) {
        take_back(edges, cells);
        begin(edges);
        add_bands(edges, cells, row, rule);
    }
}
