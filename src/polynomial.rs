//! Bézier curves as polynomials of their parameter: vertices by number, or one after the other by forward differences.
//!
//! Both are exact in whole units of `2^−3k` sixteenths until a vertex is rounded, so that they agree to the bit, and a
//! walk does not drift. T. O. Sederberg, *Computer Aided Geometric Design*, chapter 4, for forward differences.

use crate::{num::low_i32, space::Point2};

/// The longest second difference; of a cubic one at the start and at the end, three times.
pub(crate) fn bend([x, y]: [Axis; 2]) -> u64 {
    length(x.square, y.square).max(length(x.square + 3 * x.cube, y.square + 3 * y.cube))
}

/// No less than the length of a vector, and at most an eighth more.
fn length(x: i64, y: i64) -> u64 {
    let (x, y) = (x.unsigned_abs(), y.unsigned_abs());
    x.max(y) + x.min(y).div_ceil(2)
}

/// One coordinate as a polynomial of the parameter: `cube·t³ + square·t² + line·t + start`.
#[derive(Clone, Copy)]
pub(crate) struct Axis {
    cube: i64,
    square: i64,
    line: i64,
    start: i64,
}

impl Axis {
    pub(crate) fn of_quadratic(points: [Point2; 3]) -> [Self; 2] {
        [points.map(|point| point.x), points.map(|point| point.y)].map(|axis| {
            let [from, control, to] = axis.map(|v| i64::from(v.to_bits()));
            Self { cube: 0, square: from - 2 * control + to, line: 2 * (control - from), start: from }
        })
    }

    pub(crate) fn of_cubic(points: [Point2; 4]) -> [Self; 2] {
        [points.map(|point| point.x), points.map(|point| point.y)].map(|axis| {
            let [from, one, other, to] = axis.map(|v| i64::from(v.to_bits()));
            let square = 3 * (from - 2 * one + other);
            Self { cube: to - from + 3 * (one - other), square, line: 3 * (one - from), start: from }
        })
    }

    /// The coordinate at `number / 2^k`, in sixteenths.
    const fn at(self, k: u32, number: u32) -> i32 {
        let t = number as i64;
        // Sums may leave 64 bits on the way, and are back in the end.
        let value = self.cube.wrapping_mul(t).wrapping_add(self.square << k).wrapping_mul(t);
        let value = value.wrapping_add(self.line << (2 * k)).wrapping_mul(t).wrapping_add(self.start << (3 * k));
        rounded(value, k)
    }

    /// The differences of 2^k steps, at the start.
    const fn differences(self, k: u32) -> Differences {
        Differences {
            value: self.start << (3 * k),
            first: self.cube + (self.square << k) + (self.line << (2 * k)),
            second: 6 * self.cube + ((2 * self.square) << k),
            third: 6 * self.cube,
        }
    }
}

/// A coordinate in units of 2^−3k sixteenths, to the nearest sixteenth. The curve stays between its control points.
#[inline]
const fn rounded(value: i64, k: u32) -> i32 {
    low_i32((value + (1 << (3 * k) >> 1)) >> (3 * k))
}

/// A coordinate and its differences, in units of 2^−3k sixteenths.
struct Differences {
    value: i64,
    first: i64,
    second: i64,
    third: i64,
}

impl Differences {
    /// The coordinate at the next step, in sixteenths.
    #[inline]
    fn next(&mut self, k: u32) -> i32 {
        self.value += self.first;
        self.first += self.second;
        self.second += self.third;
        rounded(self.value, k)
    }
}

pub(crate) fn vertex([x, y]: [Axis; 2], k: u32, number: u32) -> Point2 {
    Point2::from_sixteenths(x.at(k, number), y.at(k, number))
}

/// Gives the ends of the first pieces by forward differences: nothing is rounded on the way, so nothing drifts.
#[inline]
pub(crate) fn step(axes: [Axis; 2], (k, pieces): (u32, u32), mut give: impl FnMut(Point2)) {
    let [mut x, mut y] = axes.map(|axis| axis.differences(k));
    for _ in 0..pieces {
        give(Point2::from_sixteenths(x.next(k), y.next(k)));
    }
}
