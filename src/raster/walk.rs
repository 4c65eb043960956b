//! A triangle that is walked row by row, by whoever has rows to walk.

use core::ops::Range;

use super::{
    edge_pair::EdgePair,
    triangle::{LONGEST, is_small, spans},
};
use crate::{
    edge::reached_by,
    num::{bits, index, low_u8},
    space::{Point2, Rect},
    span::SpanFn,
};

/// A triangle with corners nearer than [`LIMIT`](crate::vary::LIMIT), standing on a row.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Walk {
    /// Of some pixels: its spans, found at once.
    Short(Short),
    /// Any other.
    Long(EdgePair),
}

/// The spans of a triangle, from the present row on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Short {
    left: i32,
    /// The present row among the spans.
    at: u8,
    spans: [[u8; 2]; LONGEST as usize],
}

impl Walk {
    /// Stands on `row`, whose centres it reaches. `None` if it holds no pixel from there on, as far as that is cheap to know.
    pub(crate) fn new(corners: &[Point2; 3], row: i32) -> Option<Self> {
        let below = Rect { top: row, ..reached_by(corners) };
        if below.is_empty() {
            None
        } else if is_small(below) {
            Short::new(corners, below).map(Self::Short)
        } else {
            EdgePair::new(corners, row).map(Self::Long)
        }
    }

    /// Its pixels in the row it stands on; maybe none, then the end may be before the start.
    #[inline]
    pub(crate) fn columns(&self) -> Range<i32> {
        match self {
            Self::Short(Short { left, at, spans }) => {
                let [start, end] = spans.get(usize::from(*at)).copied().unwrap_or_default();
                *left + i32::from(start)..*left + i32::from(end)
            }
            Self::Long(edges) => edges.columns(),
        }
    }

    /// Goes down to `row`, the one below, which is also one of the triangle's.
    #[inline]
    pub(crate) fn advance(&mut self, row: i32) {
        match self {
            Self::Short(short) => short.at = short.at.saturating_add(1),
            Self::Long(edges) => edges.advance(row),
        }
    }
}

impl Short {
    /// All that is in an area, which has the rows from the present one on.
    fn new(corners: &[Point2; 3], area: Rect) -> Option<Self> {
        let mut short = None;
        let mut sink = SpanFn::new(area, |row: i32, columns: Range<i32>, ()| {
            let Self { spans, .. } =
                short.get_or_insert(Self { left: area.left, at: 0, spans: [[0; 2]; LONGEST as usize] });
            if let Some(span) = spans.get_mut(index(row - area.top)) {
                *span = [columns.start, columns.end].map(|column| low_u8(bits(column - area.left)));
            }
        });
        let Ok(()) = spans(corners, &mut sink);
        short
    }
}
