//! Cuts: lines across the screen that part the pixels of a shape, none lost and none twice.
//!
//! ```text
//!    ●                       ●               ●
//!    │╲ ╱  a cut             │╲              ·╲
//!    │ ╳               =     │·    +          ╱╲
//!    │╱ ╲                    │╱              ╱  ╲
//!    ●───●                   ●               ···─●
//! ```
//!
//! A piece of a triangle is not a polygon with corners of its own, which would be rounded. It is *the triangle itself*, and
//! on which side of some cuts its pixels lie. Both sides of a cut evaluate the same integers at the same centres of pixels;
//! one keeps what is not negative, the other what is. So the pieces fill the pixels of the triangle exactly, and depth,
//! light and texture are those of the triangle.
//!
//! - **Takes** runs of pixels.
//! - **Gives** the parts of them on one side.
//! - **Memory** 24 bytes a cut.
//! - **Cost** two products of 64 bits a span, and one division where the cut crosses it.

use core::ops::Range;

use crate::{
    edge,
    num::{SUBPIXELS, divide_floor, low_i32},
    space::Point2,
};

/// Rows and columns that cuts tell apart are within this; what lies beyond is on the side of the nearest that is.
const LIMIT: i32 = 1 << 16;

/// A side of a line on the screen: the pixels at whose centres a linear function is not negative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cut {
    /// At the centre of pixel (0, 0): less than 2⁶¹ from zero.
    value: i64,
    /// What is added a column to the right, and a row down: less than 2⁴⁵ from zero.
    across: i64,
    down: i64,
}

impl Cut {
    /// The inner side of an edge of a shape that runs clockwise on the screen, by the rule of [rasterisation](crate::raster):
    /// three such cuts are a triangle, to the pixel.
    ///
    /// The points are taken to the nearest within 4,194,304 pixels. Between two points at the same place, nothing is kept.
    ///
    /// ```
    /// use aquatint::{Point2, cut::Cut};
    ///
    /// // Upwards through the corner of pixel (3, 0), and through that of (6, 3).
    /// let edge = Cut::of_edge(Point2::corner(6, 3), Point2::corner(3, 0));
    /// assert_eq!(edge.keep(1, 0..9), 4..9);
    /// assert_eq!(edge.other().keep(1, 0..9), 0..4);
    /// ```
    #[must_use]
    pub fn of_edge(from: Point2, to: Point2) -> Self {
        let [(x, y), (to_x, to_y)] = [from, to].map(|point| {
            let point = point.nearest_within(edge::LIMIT);
            (i64::from(point.x.to_bits()), i64::from(point.y.to_bits()))
        });
        let (dx, dy) = (to_x - x, to_y - y);
        // A centre on an edge belongs to it if that is a left one, which runs up, or an upper one, which runs right.
        let owns = dy < 0 || (dy == 0 && dx > 0);
        let (pixel, centre) = (i64::from(SUBPIXELS), i64::from(SUBPIXELS / 2));
        Self { value: dx * (centre - y) - dy * (centre - x) - i64::from(!owns), across: -pixel * dy, down: pixel * dx }
    }

    /// Where a value is not negative that is linear in space, like a distance from a plane, on a triangle.
    ///
    /// `corners` are homogeneous places on the screen, `(x·w, y·w, w)` with `x` and `y` in pixels and `w` in any unit,
    /// also of corners behind the eye, where `w < 0`: of the line only what is in front is of use. `values` are those at
    /// the corners, in any unit. A triangle without area is kept whole by either this or the [`other`](Self::other).
    ///
    /// The line is off by a few thousandths of a pixel on screens of 4096; corners count with 30 bits. About a hundred
    /// products of 32 bits.
    ///
    /// Source: M. Olano, T. Greer, "Triangle scan conversion using 2D homogeneous coordinates", 1997.
    ///
    /// ```
    /// use aquatint::cut::Cut;
    ///
    /// // Eight pixels wide, at a distance of 1 on the left and of 3 on the right: its middle is seen at a quarter.
    /// let corners = [[0, 0, 1], [8 * 3, 0, 3], [0, 8, 1]];
    /// let right = Cut::of_values(&corners, [-5, 5, -5]);
    /// assert_eq!(right.keep(0, 0..8), 6..8);
    /// ```
    #[must_use]
    pub fn of_values(corners: &[[i64; 3]; 3], values: [i64; 3]) -> Self {
        let [a, b, c] = fitted(corners, 30);
        let sides = [cross(b, c), cross(c, a), cross(a, b)];
        // The sign of the determinant: negative for a triangle that shows its other side.
        let volume = (0..3).fold(0_i128, |sum, axis| sum + i128::from(at(&a, axis)) * i128::from(at(&sides[0], axis)));
        let ([values], sides) = (fitted(&[values], 30), fitted(&sides, 31));
        let [x, y, one] = [0, 1, 2].map(|axis| {
            let along = |corner: usize| at(&values, corner) * sides.get(corner).map_or(0, |side| at(side, axis));
            (along(0) + along(1) + along(2)) * i64::from(sign(volume))
        });
        // In units of which the constant has 58 bits, and what is added a pixel has 43.
        let too_long = excess(x, 43).max(excess(y, 43)).max(excess(one, 58));
        let (x, y, one) = (x >> too_long, y >> too_long, one >> too_long);
        // Twice, because a centre is at a half.
        Self { value: x + y + 2 * one, across: 2 * x, down: 2 * y }
    }

    /// The other side: keeps exactly what this one does not.
    #[must_use]
    pub const fn other(self) -> Self {
        Self { value: -self.value - 1, across: -self.across, down: -self.down }
    }

    /// Whether a pixel is on this side.
    #[inline]
    #[must_use]
    pub fn keeps(&self, row: i32, column: i32) -> bool {
        self.at(row, column) >= 0
    }

    /// The columns of a run of pixels that are on this side: those from its start, to its end, all or none.
    #[inline]
    #[must_use]
    pub fn keep(&self, row: i32, columns: Range<i32>) -> Range<i32> {
        if columns.is_empty() {
            return columns;
        }
        let (start, end) = (columns.start, columns.end);
        let first = within(start);
        let (left, right) = (self.at(row, start), self.at(row, end.wrapping_sub(1)));
        match (left >= 0, right >= 0) {
            (true, true) => columns,
            (false, false) => start..start,
            (false, true) => first - steps(left, self.across)..end,
            (true, false) => start..first + 1 + steps(left, -self.across),
        }
    }

    /// The function at the centre of a pixel: less than 2⁶³, by what its parts are.
    #[inline]
    fn at(&self, row: i32, column: i32) -> i64 {
        self.value + self.across * i64::from(within(column)) + self.down * i64::from(within(row))
    }
}

/// The nearest row or column that is told apart.
#[inline]
fn within(pixel: i32) -> i32 {
    pixel.clamp(-LIMIT, LIMIT)
}

/// How many times a step fits into a value, rounded down: at most as often as there are columns.
#[inline]
fn steps(value: i64, step: i64) -> i32 {
    low_i32(divide_floor(value, step).0)
}

/// By how many bits a number is longer than `bits` and a sign.
fn excess(value: i64, bits: u32) -> u32 {
    (i64::BITS - value.unsigned_abs().leading_zeros()).saturating_sub(bits)
}

/// Numbers halved together, as often as it takes for all to have `bits` and a sign.
fn fitted<const N: usize>(numbers: &[[i64; 3]; N], bits: u32) -> [[i64; 3]; N] {
    let too_long = numbers.as_flattened().iter().fold(0, |most, &number| most.max(excess(number, bits)));
    numbers.map(|row| row.map(|number| number >> too_long))
}

/// Cross product of vectors with 30 bits and a sign.
fn cross([a, b, c]: [i64; 3], [d, e, f]: [i64; 3]) -> [i64; 3] {
    [b * f - c * e, c * d - a * f, a * e - b * d]
}

fn at(numbers: &[i64; 3], index: usize) -> i64 {
    numbers.get(index).copied().unwrap_or(0)
}

fn sign(value: i128) -> i8 {
    i8::from(value > 0) - i8::from(value < 0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        raster::triangle::spans,
        space::{Rect, twice_area},
        span::SpanFn,
    };
    use proptest::prelude::*;

    fn number() -> impl Strategy<Value = i64> {
        let ends = prop::sample::select(&[i64::MIN, i64::MAX, 0, 1, -1][..]);
        prop_oneof![ends, -9..9_i64, -5000..5000_i64, any::<i64>(), any::<i32>().prop_map(i64::from)]
    }

    fn place(reach: i32) -> impl Strategy<Value = Point2> {
        (-reach..reach, -reach..reach).prop_map(|(x, y)| Point2::from_sixteenths(x, y))
    }

    /// The pixels of a triangle in a window, and those that its edges keep of it.
    fn pixels(corners: [Point2; 3], cuts: &[Cut]) -> ([u32; 24], [u32; 24]) {
        let window = Rect::new(-4, -4, 20, 20);
        let mut drawn = [0_u32; 24];
        let mut sink = SpanFn::new(window, |row, columns: Range<i32>, ()| mark(&mut drawn, row, columns));
        spans(&corners, &mut sink).unwrap();
        let mut kept = [0; 24];
        for row in window.rows() {
            let columns = cuts.iter().fold(window.columns(), |columns, cut| cut.keep(row, columns));
            mark(&mut kept, row, columns);
        }
        (drawn, kept)
    }

    fn mark(rows: &mut [u32; 24], row: i32, columns: Range<i32>) {
        for column in columns {
            rows[crate::num::index(row + 4)] |= 1 << (column + 4);
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(3000))]
        #[test]
        fn three_edges_are_a_triangle(a in place(400), b in place(400), c in place(400)) {
            let (b, c) = if twice_area(a, b, c) < 0 { (c, b) } else { (b, c) };
            let (drawn, kept) = pixels([a, b, c], &[Cut::of_edge(a, b), Cut::of_edge(b, c), Cut::of_edge(c, a)]);
            prop_assume!(twice_area(a, b, c) != 0);
            prop_assert_eq!(drawn, kept);
        }

        #[test]
        fn the_other_side_of_an_edge_is_the_edge_back(a in place(i32::MAX), b in place(i32::MAX), c in place(99)) {
            for (from, to) in [(a, b), (a, c), (c, a)] {
                prop_assume!(from.nearest_within(edge::LIMIT) != to.nearest_within(edge::LIMIT));
                prop_assert_eq!(Cut::of_edge(from, to).other(), Cut::of_edge(to, from));
            }
        }

        #[test]
        fn what_one_side_keeps_the_other_does_not(
            corners in prop::array::uniform3(prop::array::uniform3(number())), values in prop::array::uniform3(number()),
            row in any::<i32>(), near in -99..99_i32, start in any::<i32>(), length in 0..999_i32,
        ) {
            let cut = Cut::of_values(&corners, values);
            prop_assert_eq!(cut.other().other(), cut);
            for (row, start) in [(near, -near), (row, start), (near, start)] {
                let columns = start..start.saturating_add(length);
                let (one, other) = (cut.keep(row, columns.clone()), cut.other().keep(row, columns.clone()));
                prop_assert_eq!(one.len() + other.len(), columns.len());
                for column in columns {
                    prop_assert_eq!(one.contains(&column), cut.keeps(row, column));
                    prop_assert_eq!(other.contains(&column), !cut.keeps(row, column));
                }
            }
        }

        /// Corners anywhere, also behind the eye: by the point of the triangle's plane that is seen at a pixel.
        #[test]
        fn values_are_seen_where_they_are(
            corners in prop::array::uniform3((-99..99_i64, -99..99_i64, -60..60_i64)),
            values in prop::array::uniform3(-999..999_i64), row in -40..40_i32, column in -40..40_i32,
        ) {
            let [a, b, c] = corners.map(|(x, y, w)| [x * 16, y * 16, w]);
            let centre = [2 * i64::from(column) + 1, 2 * i64::from(row) + 1, 2];
            let dot = |[a, b, c]: [i64; 3], [d, e, f]: [i64; 3]| a * d + b * e + c * f;
            let volume = dot(a, cross(b, c));
            let weights = [cross(b, c), cross(c, a), cross(a, b)].map(|side| dot(side, centre) * volume.signum());
            let value = dot(weights, values);
            prop_assert_eq!(Cut::of_values(&[a, b, c], values).keeps(row, column), value >= 0);
        }
    }

    #[test]
    fn a_point_is_no_edge() {
        let point = Point2::corner(1, 2);
        assert!(Cut::of_edge(point, point).keep(2, -5..5).is_empty());
        assert_eq!(Cut::of_edge(point, point).other().keep(2, -5..5), -5..5);
    }
}
