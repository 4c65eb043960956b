//! A triangle that is walked row by row, by whoever has rows to walk.

use core::ops::Range;

use super::triangle;
use crate::{
    edge::{Edge, first_row},
    num::{bits, index, low_u8},
    space::{Point2, Rect, twice_area},
    span::SpanFn,
};

/// A triangle with corners nearer than [`LIMIT`](crate::vary::LIMIT), standing on a row.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Walk {
    /// Of some pixels: its spans, found at once.
    Short(Short),
    /// Any other.
    Long(Edges),
}

/// Rows of a short one, and columns: these are bytes.
const SHORT_ROWS: usize = 16;
const SHORT_PIXELS: i32 = 32;

/// The spans of a triangle, from the present row on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Short {
    left: i32,
    /// The present row among the spans.
    at: u8,
    spans: [[u8; 2]; SHORT_ROWS],
}

/// Two edges of a triangle, one of them its longest.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Edges {
    left: Edge,
    right: Edge,
    /// The second short edge begins at this row …
    turn: i32,
    /// … and is this.
    lower: [Point2; 2],
    long_is_left: bool,
}

impl Walk {
    /// Stands on `row`, which is one of its [rows]. `None` if it holds no pixel from there on, as far as that is cheap to
    /// know.
    pub(crate) fn new(corners: &[Point2; 3], row: i32) -> Option<Self> {
        let (rows, columns) = (row..rows(corners).end, columns(corners));
        let (height, width) = (rows.end - rows.start, columns.end - columns.start);
        if height <= 0 || width <= 0 {
            return None;
        }
        // The product of two coordinates that are nearer than the limit could be too large.
        if height <= 16 && width <= SHORT_PIXELS && height * width <= SHORT_PIXELS {
            return Short::new(corners, Rect::new(columns.start, rows.start, columns.end, rows.end)).map(Self::Short);
        }
        Edges::new(corners, row).map(Self::Long)
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
            let Self { spans, .. } = short.get_or_insert(Self { left: area.left, at: 0, spans: [[0; 2]; SHORT_ROWS] });
            if let Some(span) = spans.get_mut(index(row - area.top)) {
                *span = [columns.start, columns.end].map(|column| low_u8(bits(column - area.left)));
            }
        });
        let Ok(()) = triangle::spans(corners, &mut sink);
        short
    }
}

impl Edges {
    /// `None` if it has no area.
    fn new(&[a, b, c]: &[Point2; 3], row: i32) -> Option<Self> {
        let area = twice_area(a, b, c);
        let ([mut top, mut middle, mut bottom], mut long_is_left) = ([a, b, c], area > 0);
        let mut order = |upper: &mut Point2, lower: &mut Point2| {
            if lower.y < upper.y {
                core::mem::swap(upper, lower);
                long_is_left = !long_is_left;
            }
        };
        order(&mut top, &mut middle);
        order(&mut middle, &mut bottom);
        order(&mut top, &mut middle);
        if area == 0 {
            return None;
        }
        let (turn, lower) = (first_row(middle.y.to_bits()), [middle, bottom]);
        let [upper, below] = if row < turn { [top, middle] } else { lower };
        let (long, short) = (Edge::new(top, bottom, row), Edge::new(upper, below, row));
        let (left, right) = if long_is_left { (long, short) } else { (short, long) };
        Some(Self { left, right, turn, lower, long_is_left })
    }

    #[inline]
    const fn columns(&self) -> Range<i32> {
        self.left.column()..self.right.column()
    }

    #[inline]
    fn advance(&mut self, row: i32) {
        self.left.advance();
        self.right.advance();
        if row == self.turn {
            let [middle, bottom] = self.lower;
            let short = if self.long_is_left { &mut self.right } else { &mut self.left };
            *short = Edge::new(middle, bottom, row);
        }
    }
}

/// The rows whose centres a triangle reaches.
#[inline]
pub(crate) fn rows(corners: &[Point2; 3]) -> Range<i32> {
    let [a, b, c] = corners.each_ref().map(|corner| corner.y.to_bits());
    first_row(a.min(b).min(c))..first_row(a.max(b).max(c))
}

/// The columns whose centres a triangle reaches.
#[inline]
pub(crate) fn columns(corners: &[Point2; 3]) -> Range<i32> {
    // A column is to an edge what a row is to a corner.
    let [a, b, c] = corners.each_ref().map(|corner| corner.x.to_bits());
    first_row(a.min(b).min(c))..first_row(a.max(b).max(c))
}
