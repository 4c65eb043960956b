//! Rows that all edges go through from border to border, each in pixels of its own: nearly all rows of straight edges.
//!
//! There the coverage of a pixel is that of one edge, and nothing is summed up.

use super::{cells::Cells, edge::AreaEdge};
use crate::{coverage::Covered, span::Sink, style::Rule};

/// Whether the edges, of which all go through the row, lie there as they are sorted, with no pixel in common. Then
/// they stand on the next row already.
#[inline]
pub(super) fn are_apart(edges: &mut [AreaEdge]) -> bool {
    let (mut before, mut are_apart) = (i64::MIN, true);
    for edge in &mut *edges {
        edge.place_whole();
        let (left, right) = (edge.from.min(edge.to), edge.from.max(edge.to));
        are_apart &= before < left >> 16;
        before = right >> 16;
    }
    if !are_apart {
        edges.iter_mut().for_each(AreaEdge::retreat);
    }
    are_apart
}

/// Emits a part of a row of edges that are apart.
#[inline]
pub(super) fn emit_apart<S, E>(
    edges: &[AreaEdge],
    cells: &mut Cells,
    (row, rule): (i32, Rule),
    sink: &mut S,
) -> Result<(), E>
where
    S: for<'c> Sink<Covered<'c>, Error = E>,
{
    let (mut at, mut winding) = (0, 0);
    for edge in edges {
        if let Some(side) = edge.side(&mut winding, rule) {
            at = cells.emit_edge((edge.from, edge.to), (side, at), row, sink)?;
        }
    }
    Ok(())
}
