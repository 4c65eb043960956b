//! Faces that wait for their first row, and those that reach into the present one.

use core::ops::Range;

use super::buckets::NONE;
use crate::{
    edge::reached_by,
    fragment::shade::Shading,
    hidden::scanline::RowDepth,
    illumination::Illumination,
    num::low_i16,
    pipeline::{
        fragments::{Begun, begin},
        listed::{ListedFace, intersection},
        surface::Surface,
    },
    raster::walk::Walk,
    space::Rect,
};

/// A face that waits for its first row: 16 bytes.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct WaitingFace {
    listed: ListedFace,
    pub(super) first_row: i16,
    /// The next face of its bucket.
    pub(super) next: u16,
}

/// A face that reaches into the present row.
#[derive(Clone, Debug)]
pub struct ActiveFace<F> {
    walk: Walk,
    /// Its pixels in the row, as far as they lie in the window.
    columns: [i16; 2],
    pub(super) depth: RowDepth,
    /// What is added to the depth from row to row.
    down: u32,
    pub(super) end_row: i16,
    pub(super) instance: u8,
    pub(super) face: F,
}

impl WaitingFace {
    /// In no bucket yet.
    pub(super) fn new(listed: ListedFace, first_row: i32) -> Self {
        Self { listed, first_row: low_i16(first_row), next: NONE }
    }

    /// Takes it up in a row; `order` is its place among all faces. `None` if it shows no pixel from there on.
    pub(super) fn begin<S: Shading, I: Illumination>(
        &self,
        surfaces: &[Surface<'_, S, I>],
        (row, order): (i32, u16),
        window: Rect,
    ) -> Option<ActiveFace<S::Face>> {
        let listed = self.listed;
        let (surface, piece) = listed.placed(surfaces)?;
        let walk = Walk::new(&piece.positions, row)?;
        let Begun { face, depth } = begin(surface, &listed.triangle(), &piece, true);
        let [at_origin] = depth.at(row, 0).fine();
        let ([across], [down]) = (depth.across, depth.down);
        let end_row = low_i16(reached_by(&piece.positions).bottom.min(window.bottom));
        let depth = RowDepth { depth: at_origin, across, order };
        let columns = short(intersection(walk.columns(), &window.columns()));
        Some(ActiveFace { walk, columns, depth, down, end_row, instance: listed.instance(), face })
    }
}

impl<F> ActiveFace<F> {
    /// Its pixels in the row.
    #[inline]
    pub(super) fn columns(&self) -> Range<i32> {
        let [start, end] = self.columns.map(i32::from);
        start..end
    }

    #[inline]
    pub(super) fn start(&self) -> i32 {
        let [start, _] = self.columns;
        start.into()
    }

    /// Goes down to a row.
    #[inline]
    pub(super) fn advance(&mut self, row: i32, window: &Range<i32>) {
        self.walk.advance(row);
        self.columns = short(intersection(self.walk.columns(), window));
        self.depth.depth = self.depth.depth.wrapping_add(self.down);
    }
}

/// Columns of a viewport are within 4096, unless there are none.
#[inline]
fn short(columns: Range<i32>) -> [i16; 2] {
    if columns.is_empty() { [0; 2] } else { [columns.start, columns.end].map(low_i16) }
}
