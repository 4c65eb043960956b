//! Rows of contours that all wind the same way, of which there is no list: pieces of a stroke.
//!
//! All of their areas are added up, and what exceeds a pixel is cut off. That is the area of their union but where borders
//! of two pieces cross a pixel together. One trace does for as many rows as the cells hold:
//!
//! ```text
//!   cells  │ row 7 │ row 8 │ row 9 │ spare │
//! ```

use core::ops::Range;

use super::{
    cells::{Cells, Side, height_of},
    edge::{AreaEdge, Curved, PARTS},
    task::Task,
};
use crate::{
    coverage::{Coverage, Covered},
    num::index,
    outline::Outline,
    span::Sink,
};

/// Heights are taken 32 times smaller, so that up to 31 pieces may lie upon each other.
const SHIFT: u32 = 5;

/// Rows that are summed up together.
pub(super) struct Union<'m> {
    /// Those of one row after the other.
    cells: &'m mut [Coverage],
    width: usize,
    left: i32,
    rows: Range<i32>,
}

impl<'m> Union<'m> {
    /// Rows of so many cells each, from a column on.
    pub(super) fn new(cells: &'m mut [Coverage], (left, width): (i32, usize), rows: Range<i32>) -> Self {
        cells.fill(Coverage::NONE);
        Self { cells, width, left, rows }
    }

    /// Adds up all pieces of an outline and emits what they cover.
    pub(super) fn emit<C, O, S, E>(&mut self, outline: &O, sink: &mut S) -> Result<(), E>
    where
        C: Curved,
        O: Outline,
        S: for<'c> Sink<Covered<'c>, Error = E>,
    {
        Task::<C>::Unite(self).trace(outline);
        self.rows().try_for_each(|row| {
            let mut cells = self.row(row);
            cells.unite(SHIFT);
            cells.emit_all(row, sink)
        })
    }

    pub(super) fn rows(&self) -> Range<i32> {
        self.rows.clone()
    }

    /// Adds a stretch to the rows that it reaches into.
    #[cold]
    pub(super) fn add<C: Curved>(&mut self, reach: Range<i32>, make: impl FnOnce(i32) -> AreaEdge<C>) {
        let rows = reach.start.max(self.rows.start)..reach.end.min(self.rows.end);
        if rows.is_empty() {
            return;
        }
        let mut edge = make(rows.start);
        for row in rows {
            add_edge(&mut edge, &mut self.row(row), row);
            edge.go_on(row, PARTS);
            edge.advance();
        }
    }

    /// The cells of one of the rows.
    fn row(&mut self, row: i32) -> Cells<'_> {
        let first = index(row.wrapping_sub(self.rows.start)).saturating_mul(self.width);
        let cells = self.cells.get_mut(first..).and_then(|cells| cells.get_mut(..self.width));
        Cells::new(cells.unwrap_or_default(), self.left)
    }
}

/// Adds the part of an edge that is in a row.
#[inline(never)]
fn add_edge<C: Curved>(edge: &mut AreaEdge<C>, cells: &mut Cells, row: i32) {
    let side = if edge.winding() > 0 { Side::Left } else { Side::Right };
    edge.each_piece(row, |crossed, (top, bottom)| {
        cells.add_edge(crossed, height_of(bottom - top) >> SHIFT, side);
    });
}

/// Emits the part of a row that straight edges cover together.
#[cold]
pub(super) fn emit_edges<C, S, E>(edges: &mut [AreaEdge<C>], cells: &mut Cells, row: i32, sink: &mut S) -> Result<(), E>
where
    C: Curved,
    S: for<'c> Sink<Covered<'c>, Error = E>,
{
    for edge in edges {
        add_edge(edge, cells, row);
    }
    cells.unite(SHIFT);
    cells.emit_all(row, sink)
}
