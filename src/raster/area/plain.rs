//! Rows in which nothing overlaps: each edge adds its area by its winding, whatever the others do.
//!
//! That is the usual row of a shape whose contours do not cross: no edge needs to know where others begin and end, so
//! that curves of many pieces cost no more than their pieces. It is only right where the winding number is nowhere
//! beyond 0 and 1, or 0 and −1; so that is looked at afterwards, and else the row is summed up again in
//! [bands](super::bands).

use super::{
    cells::{Cells, Side, height_of},
    edge::{AreaEdge, Curved, PARTS},
};
use crate::raster::active::sort_by_key;

/// Adds all edges of a row, which are sorted from left to right then. Whether that is the coverage of the row.
pub(super) fn add_plain<C: Curved>(edges: &mut [AreaEdge<C>], cells: &mut Cells, row: i32) -> bool {
    for edge in &mut *edges {
        add_pieces(edge, cells, row);
    }
    // In one order, whatever it was before: so bands of a picture are the whole to the bit.
    sort_by_key(edges, |edge| (edge.from, edge.to, edge.winding()));
    lie_side_by_side(edges) && wind_once(edges)
}

/// Takes back what was added.
#[cold]
pub(super) fn take_back<C: Curved>(edges: &[AreaEdge<C>], cells: &mut Cells) {
    for edge in edges {
        cells.clear(edge.touched());
    }
}

/// Adds an edge, or all pieces of a curve, and remembers how far they reach.
fn add_pieces<C: Curved>(edge: &mut AreaEdge<C>, cells: &mut Cells, row: i32) {
    let side = if edge.winding() > 0 { Side::Left } else { Side::Right };
    let (begin, mut end) = edge.ends_in(row);
    let (mut least, mut most) = (i64::MAX, i64::MIN);
    edge.each_piece(row, |(from, to), (top, bottom)| {
        (least, most, end) = (least.min(from.min(to)), most.max(from.max(to)), bottom);
        cells.add_edge((from, to), height_of(bottom - top), side);
    });
    edge.go_on(row, PARTS);
    edge.is_between((least, most), (begin, end));
    edge.touch(cells.touched((least, most)));
}

/// Whether no two edges that are there at the same height reach over each other.
fn lie_side_by_side<C: Curved>(edges: &[AreaEdge<C>]) -> bool {
    let mut rest = edges;
    while let [left, others @ ..] = rest {
        let near = others.iter().take_while(|right| right.from < left.to);
        let parts = left.parts();
        if near.map(AreaEdge::parts).any(|other| parts.start < other.end && other.start < parts.end) {
            return false;
        }
        rest = others;
    }
    true
}

/// Whether the edges, from left to right, lead in and out by turns, in the same way wherever one begins or ends.
fn wind_once<C: Curved>(edges: &[AreaEdge<C>]) -> bool {
    let begins_and_ends = edges.iter().flat_map(|edge| [edge.parts().start, edge.parts().end]);
    let mut heights = core::iter::once(0).chain(begins_and_ends.filter(|part| (1..PARTS).contains(part)));
    let mut way = 0;
    heights.all(|part| {
        let Some(here) = way_at(edges, part) else { return false };
        let is_same = way == 0 || here == 0 || way == here;
        way = if way == 0 { here } else { way };
        is_same
    })
}

/// Which way the first edge at a height winds, 0 where there is none; nothing where the edges do not wind by turns.
fn way_at<C: Curved>(edges: &[AreaEdge<C>], part: i32) -> Option<i32> {
    let (mut way, mut last) = (0, 0);
    for edge in edges.iter().filter(|edge| edge.parts().contains(&part)) {
        if edge.winding() == last {
            return None;
        }
        last = edge.winding();
        way = if way == 0 { last } else { way };
    }
    Some(way)
}
