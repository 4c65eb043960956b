//! Rows of which there is no list of edges: 16 strips, in which the edges are upright.

use core::ops::Range;

use super::{
    cells::{Cells, Side, height_of},
    edge::{AreaEdge, Curved, PARTS},
    task::Task,
};
use crate::{outline::Outline, style::Rule};

/// Adds a row.
#[cold]
pub(super) fn add_strips<C: Curved, O: Outline>(outline: &O, cells: &mut Cells, row: i32, rule: Rule) {
    for middle in (PARTS / 32..PARTS).step_by(16) {
        let (mut left, mut winding) = (i64::MIN, 0_i32);
        // The nearest crossing right of `left` again and again.
        while let Some((x, winds)) = Strip::next_crossing::<C, O>(outline, (row, middle), left) {
            if let Some(side) = Side::passed(&mut winding, winds, rule) {
                cells.add_edge((x, x), height_of(PARTS / 16), side);
            }
            left = x;
        }
    }
}

/// A search for the next crossing in a strip.
pub(super) struct Strip {
    row: i32,
    middle: i32,
    left: i64,
    next: Option<(i64, i32)>,
}

impl Strip {
    /// Where edges cross the middle of a strip next to the right, and what they wind there together.
    fn next_crossing<C: Curved, O: Outline>(outline: &O, (row, middle): (i32, i32), left: i64) -> Option<(i64, i32)> {
        let mut strip = Self { row, middle, left, next: None };
        Task::<C>::Cross(&mut strip).trace(outline);
        strip.next
    }

    /// Its row.
    pub(super) fn rows(&self) -> Range<i32> {
        self.row..self.row.saturating_add(1)
    }

    /// Takes the crossing of a stretch if it is nearer.
    #[cold]
    pub(super) fn cross<C: Curved>(&mut self, reach: Range<i32>, make: impl FnOnce(i32) -> AreaEdge<C>) {
        let &mut Self { row, middle, left, .. } = self;
        if !reach.contains(&row) {
            return;
        }
        let mut edge = make(row);
        while edge.go_on(row, middle) {}
        let x = edge.at(middle);
        if edge.crosses(row, middle) && x > left {
            self.next = Some(match self.next {
                Some((nearest, winding)) if x == nearest => (nearest, winding + edge.winding()),
                Some((nearest, winding)) if x > nearest => (nearest, winding),
                _ => (x, edge.winding()),
            });
        }
    }
}
