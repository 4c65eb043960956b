//! The left and the right edge of a triangle, walked down together.
//!
//! ```text
//!          ● top
//!         ╱  ╲ short edge
//!   long ╱     ● middle
//!  edge ╱   ╱  second short edge
//!      ● bottom
//! ```

use core::ops::Range;

use crate::{
    edge::{Edge, first_row},
    space::{Point2, twice_area},
};

/// Two edges of a triangle, one of them its longest, standing on a row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct EdgePair {
    left: Edge,
    right: Edge,
    /// The second short edge begins at this row …
    turn: i32,
    /// … and is this.
    lower: [Point2; 2],
    long_is_left: bool,
}

impl EdgePair {
    /// On a row whose centres the triangle reaches. `None` if it has no area.
    #[inline]
    pub(super) fn new(&[a, b, c]: &[Point2; 3], row: i32) -> Option<Self> {
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

    /// The pixels between them; maybe none, then the end may be before the start.
    #[inline]
    pub(super) const fn columns(&self) -> Range<i32> {
        self.left.column()..self.right.column()
    }

    /// Goes down to `row`, the one below, whose centres the triangle reaches, too.
    #[inline]
    pub(super) fn advance(&mut self, row: i32) {
        self.left.advance();
        self.right.advance();
        if row == self.turn {
            let [middle, bottom] = self.lower;
            let short = if self.long_is_left { &mut self.right } else { &mut self.left };
            *short = Edge::new(middle, bottom, row);
        }
    }
}
