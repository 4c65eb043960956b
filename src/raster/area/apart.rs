//! Rows that all edges go through from border to border, each in pixels of its own: nearly all rows of straight edges.
//!
//! There the coverage of a pixel is that of one edge, and nothing is summed up.

use core::ops::Range;

use super::{
    cells::Cells,
    edge::{AreaEdge, Curved},
};
use crate::{coverage::Covered, span::Sink, style::Rule};

/// Emits rows that all edges go through, as long as they are apart; gives the first in which they are not. The edges
/// stand on that row then.
#[inline]
pub(super) fn emit_rows<C: Curved, S, E>(
    edges: &mut [AreaEdge<C>],
    rows: Range<i32>,
    (cells, rule): (&mut Cells, Rule),
    sink: &mut S,
) -> Result<i32, E>
where
    S: for<'c> Sink<Covered<'c>, Error = E>,
{
    for row in rows.clone() {
        if !are_apart(edges) {
            return Ok(row);
        }
        let (mut at, mut winding) = (0, 0);
        for edge in &*edges {
            if let Some(side) = edge.side(&mut winding, rule) {
                at = cells.emit_edge((edge.from, edge.to), (side, at), row, sink)?;
            }
        }
    }
    Ok(rows.end)
}

/// Whether the edges lie in a row as they are sorted, with no pixel in common. Then they stand on the next row.
#[inline]
fn are_apart<C: Curved>(edges: &mut [AreaEdge<C>]) -> bool {
    let (mut before, mut are_apart) = (i64::MIN, true);
    for edge in &mut *edges {
        let (left, right) = edge.place_whole();
        are_apart &= before < left >> 16;
        before = right >> 16;
    }
    if !are_apart {
        edges.iter_mut().for_each(AreaEdge::retreat);
    }
    are_apart
}
