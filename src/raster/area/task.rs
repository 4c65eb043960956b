//! What is done with the stretches of an outline: one pen for all of it, so that an outline is traced by one machine code.

use core::ops::Range;

use super::{
    edge::{AreaEdge, Curved, rows_between},
    strips::Strip,
    union::Union,
};
use crate::{
    outline::{Directed, Outline},
    raster::active::ActiveList,
    stretch::{Columns, Run, Taker, each_stretch},
};

/// Why an outline is traced.
pub(super) enum Task<'t, 'l, C> {
    /// Its edges from a row on, those that begin first.
    Collect(&'t mut ActiveList<'l, AreaEdge<C>>, i32),
    /// The next crossing in a strip.
    Cross(&'t mut Strip),
    /// The sum of some rows.
    Unite(&'t mut Union<'l>),
    /// How far it reaches to both sides.
    Measure(&'t mut Columns),
}

impl<C: Curved> Task<'_, '_, C> {
    /// Traces an outline.
    pub(super) fn trace<O: Outline>(&mut self, outline: &O) {
        each_stretch(outline, self);
    }

    /// Takes a stretch that reaches into some rows.
    #[inline]
    fn take(&mut self, reach: Range<i32>, make: impl FnOnce(i32) -> AreaEdge<C>) {
        match self {
            Self::Collect(list, row) => list.offer(reach, *row, make),
            Self::Cross(strip) => strip.cross(reach, make),
            Self::Unite(union) => union.add(reach, make),
            Self::Measure(_) => {}
        }
    }
}

impl<C: Curved> Taker for Task<'_, '_, C> {
    #[inline]
    fn edge(&mut self, edge: Directed) {
        if let Self::Measure(columns) = self {
            return columns.hold([edge.upper, edge.lower]);
        }
        self.take(rows_between(edge.upper, edge.lower), |row| AreaEdge::new(edge, row));
    }

    fn run(&mut self, run: Run) {
        if let Self::Measure(columns) = self {
            return columns.hold(run.curve.hull());
        }
        self.take(rows_between(run.vertex(0), run.vertex(run.len())), |row| AreaEdge::of_run(run, row));
    }

    fn rows(&self) -> Range<i32> {
        match self {
            Self::Collect(list, row) => list.open_rows(*row),
            Self::Cross(strip) => strip.rows(),
            Self::Unite(union) => union.rows(),
            Self::Measure(_) => i32::MIN..i32::MAX,
        }
    }
}
