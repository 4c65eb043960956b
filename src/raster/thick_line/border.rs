//! A straight border that is walked down row by row, exactly, over the whole range of `i32`.
//!
//! The border stands in column `x + ⌊(32·k·rise + shift) / (32·run)⌋`, where `k` counts the rows from that of a known
//! pixel. One row more adds `rise / run`, kept as a quotient and a remainder: no division after the
//! first, no drift, the same columns wherever the walk begins. The same idea as
//! [`Edge`](crate::edge::Edge), for slopes of 33 bits and a border at an irrational distance.

use crate::num::divide_floor;

/// Distances from the middle of a line are counted in parts of a pixel: half sixteenths.
pub(super) const PARTS: i64 = 32;

/// A border, standing on a row.
#[derive(Clone, Copy, Debug)]
pub(super) struct Border {
    column: i64,
    /// Columns to add a row, rounded down …
    step: i64,
    /// … and what that leaves, in parts of `modulus`.
    step_part: i64,
    /// What the column leaves.
    remainder: i64,
    modulus: i64,
}

impl Border {
    /// A border that stands in the same column in every row.
    pub(super) const fn upright(column: i64) -> Self {
        Self { column, step: 0, step_part: 0, remainder: 0, modulus: 1 }
    }

    /// The border that runs through a column at row 0, `shift` farther right, standing on `row`.
    ///
    /// `run` is positive. It, `rise` and `row` are less than 2³² from zero, `shift` than 2⁵⁰, and the column in that
    /// row than 2⁶².
    pub(super) fn new(column: i64, (rise, run): (i64, i64), shift: i64, row: i64) -> Self {
        let (step, part) = divide_floor(rise, run);
        let (crossing, rest) = multiply_divide_floor(row, rise, run);
        let modulus = PARTS * run;
        let (farther, remainder) = divide_floor(PARTS * rest + shift, modulus);
        Self { column: column + crossing + farther, step, step_part: PARTS * part, remainder, modulus }
    }

    /// Where it stands.
    #[inline]
    pub(super) const fn column(&self) -> i64 {
        self.column
    }

    /// Steps to the next row.
    #[inline]
    pub(super) const fn advance(&mut self) {
        self.column = self.column.wrapping_add(self.step);
        self.remainder = self.remainder.wrapping_add(self.step_part);
        if self.remainder >= self.modulus {
            self.remainder = self.remainder.wrapping_sub(self.modulus);
            self.column = self.column.wrapping_add(1);
        }
    }
}

/// `a · b / divisor`, rounded down, and the remainder. The product may have 64 bits and a sign.
fn multiply_divide_floor(a: i64, b: i64, divisor: i64) -> (i64, i64) {
    let product = a.unsigned_abs().wrapping_mul(b.unsigned_abs());
    let Some(divisor) = core::num::NonZeroU64::new(divisor.unsigned_abs()) else { return (0, 0) };
    let (quotient, remainder) = ((product / divisor).cast_signed(), (product % divisor).cast_signed());
    match ((a < 0) != (b < 0), remainder) {
        (false, _) => (quotient, remainder),
        (true, 0) => (quotient.wrapping_neg(), 0),
        (true, _) => (quotient.wrapping_neg().wrapping_sub(1), divisor.get().cast_signed() - remainder),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn wide(limit: i64) -> impl Strategy<Value = i64> {
        prop_oneof![-40..40_i64, -limit..=limit, Just(limit), Just(-limit)]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(10_000))]
        #[test]
        fn columns_are_exact_wherever_the_walk_begins(
            column in wide(1 << 31), rise in wide((1 << 32) - 1), run in wide((1 << 32) - 1), shift in wide((1 << 50) - 1),
            row in wide((1 << 32) - 60),
        ) {
            let run = run.abs().max(1);
            let [x, m, n, s] = [column, rise, run, shift].map(i128::from);
            let exact = |row: i64| x + (32 * i128::from(row) * m + s).div_euclid(32 * n);
            prop_assume!((row..row + 50).all(|row| exact(row).abs() < 1 << 62));
            let mut border = Border::new(column, (rise, run), shift, row);
            for row in row..row + 50 {
                prop_assert_eq!(i128::from(border.column()), exact(row));
                border.advance();
            }
        }
    }
}
