//! A triangle that is walked row by row, by whoever has rows to walk.

use core::ops::Range;

use crate::{
    edge::{Edge, first_row},
    space::{Point2, twice_area},
};

/// Two edges of a triangle, standing on a row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Walk {
    long: Edge,
    short: Edge,
    /// The second short edge begins at this row …
    turn: i32,
    /// … and is this.
    lower: [Point2; 2],
    long_is_left: bool,
}

impl Walk {
    /// A triangle with corners nearer than [`LIMIT`](crate::vary::LIMIT), standing on `row`, which is one of its
    /// [rows](rows). `None` if it has no area.
    pub(crate) fn new(&[a, b, c]: &[Point2; 3], row: i32) -> Option<Self> {
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
        if area == 0 || !rows(&[a, b, c]).contains(&row) {
            return None;
        }
        let (turn, lower) = (first_row(middle.y.to_bits()), [middle, bottom]);
        let [upper, below] = if row < turn { [top, middle] } else { lower };
        Some(Self { long: Edge::new(top, bottom, row), short: Edge::new(upper, below, row), turn, lower, long_is_left })
    }

    /// Its pixels in the row it stands on; maybe none, then the end may be before the start.
    #[inline]
    pub(crate) const fn columns(&self) -> Range<i32> {
        let (long, short) = (self.long.column(), self.short.column());
        if self.long_is_left { long..short } else { short..long }
    }

    /// Goes down to `row`, the one below, which is also one of the triangle's.
    #[inline]
    pub(crate) fn advance(&mut self, row: i32) {
        self.long.advance();
        if row == self.turn {
            let [middle, bottom] = self.lower;
            self.short = Edge::new(middle, bottom, row);
        } else {
            self.short.advance();
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
