//! Rows of contours that all wind the same way, of which there is no list: pieces of a stroke.
//!
//! All of their areas are added up, in one trace, and what exceeds a pixel is cut off. That is the area of their union but
//! where borders of two pieces cross a pixel together.

use super::{
    cells::{Cells, Side, height_of},
    edge::AreaEdge,
};
use crate::{outline::Outline, stretch::each_stretch};

/// Heights are taken 32 times smaller, so that up to 31 pieces may lie upon each other.
const SHIFT: u32 = 5;

/// Adds a row.
pub(super) fn add_union<O: Outline>(outline: &O, cells: &mut Cells, row: i32) {
    each_stretch(outline, |stretch| {
        if AreaEdge::rows_of(&stretch).contains(&row) {
            let mut edge = AreaEdge::new(stretch, row);
            let side = if edge.winding() > 0 { Side::Left } else { Side::Right };
            edge.each_piece(row, |crossed, (top, bottom)| {
                cells.add_edge(crossed, height_of(bottom - top) >> SHIFT, side);
            });
        }
    });
    cells.unite(SHIFT);
}
