//! The exact edge stepper that every scan conversion of the crate walks on.
//!
//! A pixel is sampled at its centre. Row `y` has its centre at `y + ½`; an edge owns the rows
//! whose centres lie in `upper.y ≤ centre < lower.y` (half-open, so two edges that meet in a
//! vertex own each row once). On its row an edge gives the first column whose centre is *not left*
//! of it. A span from a left edge's column up to, not including, a right edge's column then holds
//! each pixel centre between them exactly once: this is the top-left rule.
//!
//! ```text
//!        upper ●            crossing at the row's centre
//!               ╲   ·  ·  ·╱·  ·  ·   row y, centres at ·
//!                ╲        ╱
//!                 ● lower      column() = first · at or right of the edge
//! ```
//!
//! With `N = (x₀−8)·dy + (16y+8−y₀)·dx` and `D = 16·dy` (all in sixteenths) the column is
//! `⌈N/D⌉`. One row down adds `16·dx` to `N`, kept as quotient and remainder modulo `D`: the walk
//! never rounds, so it never drifts, and entering at any row gives the same columns. Bands, tiles
//! and clipped windows are identical to the whole picture for that reason.
//!
//! Method: the integer edge tracking of Bresenham lines applied to scan conversion; see
//! M. Abrash, *Graphics Programming Black Book*, chapter 39, there without sub-pixels.

use crate::{
    num::{SUBPIXELS, divide_floor, divide_floor_i32, low_i32, low_u32},
    space::{Point2, Rect},
};

/// Coordinates of vertices must be nearer to zero than this, in sixteenths: 4,194,304 pixels.
///
/// Then `dy < 2²⁷`, so the modulus and a remainder plus a step stay below 2³², and `N < 2⁵⁵`.
pub(crate) const LIMIT: u32 = 1 << 26;

/// The first row whose centre is at or below `y` sixteenths.
#[inline]
pub(crate) const fn first_row(y: i32) -> i32 {
    (y + SUBPIXELS / 2 - 1) >> 4
}

/// The pixels whose centres a triangle reaches, along both axes.
#[inline]
pub(crate) fn reached_by([a, b, c]: &[Point2; 3]) -> Rect {
    let reach = |a: i32, b: i32, c: i32| (first_row(a.min(b).min(c)), first_row(a.max(b).max(c)));
    // A column is to an edge what a row is to a corner.
    let (left, right) = reach(a.x.to_bits(), b.x.to_bits(), c.x.to_bits());
    let (top, bottom) = reach(a.y.to_bits(), b.y.to_bits(), c.y.to_bits());
    Rect::new(left, top, right, bottom)
}

/// One edge, standing on a row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Edge {
    column: i32,
    /// Columns to add a row, rounded down …
    step: i32,
    /// … and what that leaves, in parts of `modulus`.
    step_part: u32,
    /// `column · modulus − N`: how far the column lies right of the exact crossing.
    remainder: u32,
    modulus: u32,
}

impl Edge {
    /// The edge from `upper` to `lower`, standing on `row`, which it owns.
    ///
    /// Both points are nearer to zero than [`LIMIT`], and `upper.y < lower.y`.
    pub(crate) fn new(upper: Point2, lower: Point2, row: i32) -> Self {
        let (x, y) = (upper.x.to_bits(), upper.y.to_bits());
        let (dx, dy) = (lower.x.to_bits() - x, lower.y.to_bits() - y);
        let down = row * SUBPIXELS + SUBPIXELS / 2 - y;
        let left = x - SUBPIXELS / 2;
        let (column, remainder) = ceiling_of_crossing(left, down, (dx, dy));
        let (step, part) = divide_floor_i32(dx, dy);
        Self {
            column,
            step,
            step_part: part.cast_unsigned() * SUBPIXELS.cast_unsigned(),
            remainder,
            modulus: dy.cast_unsigned() * SUBPIXELS.cast_unsigned(),
        }
    }

    /// The first column whose centre is not left of the edge.
    #[inline]
    pub(crate) const fn column(&self) -> i32 {
        self.column
    }

    /// Steps to the next row. Wraps where the caller leaves the rows that the edge owns.
    #[inline]
    pub(crate) const fn advance(&mut self) {
        self.column = self.column.wrapping_add(self.step);
        if self.remainder < self.step_part {
            self.column = self.column.wrapping_add(1);
            self.remainder = self.remainder.wrapping_add(self.modulus);
        }
        self.remainder = self.remainder.wrapping_sub(self.step_part);
    }
}

/// `⌈N/D⌉` and `⌈N/D⌉·D − N` for `N = left·dy + down·dx`, `D = 16·dy`.
fn ceiling_of_crossing(left: i32, down: i32, (dx, dy): (i32, i32)) -> (i32, u32) {
    // −N, so that the rounding down of the division is the rounding up that is wanted.
    let small = left.unsigned_abs() | down.unsigned_abs() | dx.unsigned_abs() | dy.unsigned_abs() < 1 << 15;
    if small {
        let (quotient, remainder) = divide_floor_i32(-(left * dy + down * dx), dy * SUBPIXELS);
        return (-quotient, remainder.cast_unsigned());
    }
    let (left, down, dx, dy) = (i64::from(left), i64::from(down), i64::from(dx), i64::from(dy));
    let (quotient, remainder) = divide_floor(-(left * dy + down * dx), dy * i64::from(SUBPIXELS));
    (low_i32(-quotient), low_u32(remainder))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// `⌈N/D⌉` in 128 bits.
    fn exact_column(upper: (i32, i32), lower: (i32, i32), row: i32) -> i128 {
        let [x, y, x1, y1, row] = [upper.0, upper.1, lower.0, lower.1, row].map(i128::from);
        let (dx, dy) = (x1 - x, y1 - y);
        let n = (x - 8) * dy + (16 * row + 8 - y) * dx;
        -(-n).div_euclid(16 * dy)
    }

    fn coordinate() -> impl Strategy<Value = i32> {
        let limit = LIMIT.cast_signed() - 1;
        prop_oneof![-200..200_i32, -20_000..20_000_i32, -limit..=limit, Just(limit), Just(-limit)]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(10_000))]
        #[test]
        fn columns_are_exact_wherever_the_walk_begins(
            x0 in coordinate(), y0 in coordinate(), x1 in coordinate(), y1 in coordinate(), enter in 0..1000_i32,
        ) {
            let ((x0, y0), (x1, y1)) = if y0 < y1 { ((x0, y0), (x1, y1)) } else { ((x1, y1), (x0, y0)) };
            let (first, end) = (first_row(y0), first_row(y1));
            prop_assume!(first < end);
            let enter = first + enter % (end - first);
            let mut edge = Edge::new(Point2::from_sixteenths(x0, y0), Point2::from_sixteenths(x1, y1), enter);
            for row in enter..end.min(enter + 50) {
                prop_assert_eq!(i128::from(edge.column()), exact_column((x0, y0), (x1, y1), row));
                edge.advance();
            }
        }
    }

    #[test]
    fn a_row_belongs_to_the_half_open_interval_of_centres() {
        // Centres at 8, 24, 40 … sixteenths.
        assert_eq!([-9, -8, -7, 7, 8, 9, 24].map(first_row), [-1, -1, 0, 0, 0, 1, 1]);
    }
}
