//! Rows in which edges begin, end or cross: cut into bands in which none does.

use super::{
    cells::{Cells, height_of},
    edge::{AreaEdge, PARTS},
};
use crate::{
    coverage::Covered,
    num::{divide_floor, low_i32},
    raster::active::sort_by_key,
    span::Sink,
    style::Rule,
};

/// Bands in a row as fine as need be; further ones are no lower than a sixteenth of it.
const FINE_BANDS: i32 = 64;

/// Adds what lies inside of a row.
pub(super) fn add_bands(edges: &mut [AreaEdge], cells: &mut Cells, row: i32, rule: Rule) {
    let (mut top, mut bands) = (0, 0);
    while top < PARTS {
        let until = edges.iter().fold(PARTS, |until, edge| edge.next_end(row, (top, until)));
        edges.iter_mut().for_each(|edge| edge.place(row, (top, until)));
        sort_by_key(edges, |edge| (edge.from, edge.to));
        let least = if bands < FINE_BANDS { 1 } else { PARTS / 16 };
        let bottom = first_crossing(edges, until - top).map_or(until, |parts| until.min(top + parts.max(least)));
        if bottom < until {
            edges.iter_mut().for_each(|edge| edge.place(row, (top, bottom)));
            sort_by_key(edges, |edge| edge.from + edge.to);
        }
        add_band(edges, cells, height_of(bottom - top), rule);
        (top, bands) = (bottom, bands + i32::from(bottom < until));
    }
    edges.iter_mut().for_each(|edge| edge.place_all(row));
    sort_by_key(edges, |edge| edge.from.min(edge.to));
}

/// How far down, rounded up, two edges of a band cross first, if any do. They are sorted as they begin, so that it is
/// two neighbours.
fn first_crossing(edges: &[AreaEdge], height: i32) -> Option<i32> {
    let pairs = edges.iter().zip(edges.iter().skip(1)).take_while(|(_, right)| right.is_here());
    pairs.filter(|(left, right)| left.to > right.to).map(|(left, right)| crossing(left, right, height)).min()
}

fn crossing(left: &AreaEdge, right: &AreaEdge, height: i32) -> i32 {
    let (above, below) = (right.from - left.from, left.to - right.to);
    // Rounded up, by rounding down what is negative.
    let (parts, _) = divide_floor(-above * i64::from(height), above + below);
    low_i32(-parts)
}

/// Adds a band whose edges are sorted.
fn add_band(edges: &[AreaEdge], cells: &mut Cells, height: i32, rule: Rule) {
    let mut winding = 0_i32;
    for edge in edges.iter().take_while(|edge| edge.is_here()) {
        if let Some(side) = edge.side(&mut winding, rule) {
            cells.add_edge((edge.from, edge.to), height, side);
        }
    }
}

/// Emits the cells that edges cross one by one, and what is between them as runs. The edges are sorted by where they
/// begin on the left.
pub(super) fn emit_between<S, E>(edges: &[AreaEdge], cells: &mut Cells, row: i32, sink: &mut S) -> Result<(), E>
where
    S: for<'c> Sink<Covered<'c>, Error = E>,
{
    let (mut sum, mut from, mut to) = (0, 0, 0);
    for edge in edges {
        let (first, end) = cells.touched((edge.from, edge.to));
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
