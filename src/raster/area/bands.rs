//! Rows in which edges begin, end or cross: cut into bands in which none does.

use super::{
    cells::{Cells, height_of},
    edge::{AreaEdge, Curved, PARTS},
};
use crate::{
    coverage::Covered,
    num::{divide_floor, low_i32},
    raster::active::sort_by_key,
    span::Sink,
    style::Rule,
};

/// Bands in a row that end at a crossing, as fine as need be; further ones are no lower than a sixteenth of it.
const FINE_BANDS: i32 = 64;

/// Adds what lies inside of a row.
pub(super) fn add_bands<C: Curved>(edges: &mut [AreaEdge<C>], cells: &mut Cells, row: i32, rule: Rule) {
    let (mut top, mut bands) = (0, 0);
    while top < PARTS {
        let until = edges.iter().fold(PARTS, |until, edge| edge.next_end(row, (top, until)));
        let bottom = if are_ordered(edges, row, (top, until)) {
            until
        } else {
            let least = if bands < FINE_BANDS { 1 } else { PARTS / 16 };
            uncrossed(edges, row, (top, until), least)
        };
        add_band(edges, cells, height_of(bottom - top), rule);
        for edge in &mut *edges {
            edge.go_on(row, bottom);
        }
        (top, bands) = (bottom, bands + i32::from(bottom < until));
    }
    sort_by_key(edges, |edge| edge.touched().0);
}

/// Places the edges in a band. Whether they lie there as they are sorted, and none crosses another.
#[inline]
fn are_ordered<C: Curved>(edges: &mut [AreaEdge<C>], row: i32, band: (i32, i32)) -> bool {
    let (mut from, mut to, mut are_ordered) = (i64::MIN, i64::MIN, true);
    for edge in edges {
        edge.place(row, band);
        are_ordered &= from <= edge.from && to <= edge.to;
        (from, to) = (edge.from, edge.to);
    }
    are_ordered
}

/// Sorts the edges of a band. Where it ends above the first crossing, but for the least height of a band.
fn uncrossed<C: Curved>(edges: &mut [AreaEdge<C>], row: i32, (top, until): (i32, i32), least: i32) -> i32 {
    sort_by_key(edges, |edge| (edge.from, edge.to));
    let Some(parts) = first_crossing(edges, until - top) else { return until };
    let bottom = until.min(top + parts.max(least));
    for edge in &mut *edges {
        edge.place(row, (top, bottom));
    }
    // Those that cross in its middle in one order, whatever it was before.
    sort_by_key(edges, |edge| (edge.from + edge.to, edge.from));
    bottom
}

/// How far down, rounded up, two edges of a band cross first, if any do. They are sorted as they begin, so that it is
/// two neighbours.
fn first_crossing<C: Curved>(edges: &[AreaEdge<C>], height: i32) -> Option<i32> {
    let pairs = edges.iter().zip(edges.iter().skip(1)).take_while(|(_, right)| right.is_here());
    pairs.filter(|(left, right)| left.to > right.to).map(|(left, right)| crossing(left, right, height)).min()
}

fn crossing<C: Curved>(left: &AreaEdge<C>, right: &AreaEdge<C>, height: i32) -> i32 {
    let (above, below) = (right.from - left.from, left.to - right.to);
    // Rounded up, by rounding down what is negative.
    let (parts, _) = divide_floor(-above * i64::from(height), above + below);
    low_i32(-parts)
}

/// Adds a band whose edges are sorted.
fn add_band<C: Curved>(edges: &mut [AreaEdge<C>], cells: &mut Cells, height: i32, rule: Rule) {
    let mut winding = 0_i32;
    for edge in edges.iter_mut().take_while(|edge| edge.is_here()) {
        if let Some(side) = edge.side(&mut winding, rule) {
            cells.add_edge((edge.from, edge.to), height, side);
            edge.touch(cells.touched((edge.from, edge.to)));
        }
    }
}

/// Emits the cells that edges cross one by one, and what is between them as runs. The edges are sorted by where they
/// begin on the left.
pub(super) fn emit_between<C: Curved, S, E>(
    edges: &[AreaEdge<C>],
    cells: &mut Cells,
    row: i32,
    sink: &mut S,
) -> Result<(), E>
where
    S: for<'c> Sink<Covered<'c>, Error = E>,
{
    let (mut sum, mut from, mut to) = (0, 0, 0);
    for (first, end) in edges.iter().map(AreaEdge::touched).filter(|(first, end)| first <= end) {
        if first > to {
            cells.emit((from, to), &mut sum, row, sink)?;
            cells.emit_even((to, first), &mut sum, row, sink)?;
            from = first;
        }
        to = to.max(end);
    }
    cells.emit((from, to), &mut sum, row, sink)?;
    // Nothing is left but zero.
    cells.emit_even((to, to), &mut sum, row, sink)
}
