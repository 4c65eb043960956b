//! Sutherland-Hodgman polygon clipping: one boundary at a time, each feeding the next.
//! Lecture 3.3.3.
//!
//! ```text
//!   polygon ──▶ near ──▶ far ──▶ left ──▶ … ──▶ what is visible
//! ```
//!
//! Works on any kind of vertex that can be cut ([`Cut`]), so that points with depth, light or
//! texture coordinates take one path. A concave polygon comes out as one polygon with edges that
//! run along the boundary and back; its winding is exact, so both fill rules stay right.
//!
//! An intersection is the exact one, correctly rounded. It is the same number from both ends of an
//! edge, so two polygons that share an edge still share it when both have been cut: no crack.

use heapless::vec::VecView;

use crate::{
    error::describe,
    num::{divide_floor, low_i32, saturate_u16},
};

/// No room for a further vertex; the output is cut short.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Full;

describe! { Full, Self => "no room for a further vertex"; }

/// A vertex that can be made between two others.
pub trait Cut: Copy {
    /// The vertex where the boundary crosses the edge from `inside` to `outside`, whose signed
    /// distances from the boundary are `crossing.inside ≥ 0` and `crossing.outside < 0`.
    #[must_use]
    fn cut(inside: Self, outside: Self, crossing: Crossing) -> Self;
}

/// How far the ends of an edge lie on the two sides of a boundary, in any unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Crossing {
    inside: i64,
    outside: i64,
}

impl Crossing {
    /// The value at the boundary of what is `inside` and `outside` at the ends, to the nearest.
    ///
    /// Exact where `(outside − inside) · distance` stays below 2⁶²; the clip coordinates that
    /// [`volume`](super::volume) accepts do.
    #[must_use]
    pub const fn coordinate(self, inside: i32, outside: i32) -> i32 {
        low_i32(self.between(inside as i64, outside as i64))
    }

    /// [`coordinate`](Self::coordinate) for an attribute.
    #[must_use]
    pub const fn attribute(self, inside: u16, outside: u16) -> u16 {
        saturate_u16(self.between(inside as i64, outside as i64))
    }

    /// `inside + ⌊(outside − inside) · t + ½⌋`: rounding relative to a whole number is rounding of
    /// the value itself, so that it does not matter from which end one starts.
    const fn between(self, inside: i64, outside: i64) -> i64 {
        let whole = self.inside.wrapping_sub(self.outside);
        let part = (outside - inside).wrapping_mul(self.inside);
        let (quotient, remainder) = divide_floor(part, whole);
        inside + quotient + (remainder >= whole - remainder) as i64
    }
}

/// Keeps the part of a polygon where `distance` is not negative.
///
/// The output is emptied first. A convex polygon gains at most one vertex; any polygon of `n` at
/// most `n / 2`.
///
/// # Errors
/// [`Full`] when the output has no room.
pub fn clip<V: Cut>(polygon: &[V], distance: impl Fn(&V) -> i64, output: &mut VecView<V>) -> Result<(), Full> {
    output.clear();
    let Some(&last) = polygon.last() else { return Ok(()) };
    let (mut previous, mut before) = (last, distance(&last));
    for &vertex in polygon {
        let here = distance(&vertex);
        if before >= 0 && here < 0 {
            let crossing = Crossing { inside: before, outside: here };
            output.push(V::cut(previous, vertex, crossing)).map_err(|_| Full)?;
        } else if before < 0 && here >= 0 {
            let crossing = Crossing { inside: here, outside: before };
            output.push(V::cut(vertex, previous, crossing)).map_err(|_| Full)?;
        }
        if here >= 0 {
            output.push(vertex).map_err(|_| Full)?;
        }
        (previous, before) = (vertex, here);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use heapless::Vec;
    use proptest::prelude::*;

    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    struct Corner(i32, i32);

    impl Cut for Corner {
        fn cut(inside: Self, outside: Self, crossing: Crossing) -> Self {
            Self(crossing.coordinate(inside.0, outside.0), crossing.coordinate(inside.1, outside.1))
        }
    }

    #[test]
    fn a_triangle_loses_a_corner() {
        //   ·    x = 4
        //  ╱ ╲    │
        // ●───────┼──●
        let mut out = Vec::<Corner, 4>::new();
        clip(&[Corner(0, 0), Corner(8, 0), Corner(2, 4)], |v| i64::from(4 - v.0), &mut out).unwrap();
        assert_eq!(out, [Corner(0, 0), Corner(4, 0), Corner(4, 3), Corner(2, 4)]);
    }

    #[test]
    fn all_in_all_out_and_no_room() {
        let square = [Corner(0, 0), Corner(2, 0), Corner(2, 2), Corner(0, 2)];
        let mut out = Vec::<Corner, 4>::new();
        clip(&square, |_| 0, &mut out).unwrap();
        assert_eq!(out, square, "on the boundary is inside");
        clip(&square, |_| -1, &mut out).unwrap();
        assert!(out.is_empty());
        clip(&[], |_: &Corner| 0, &mut out).unwrap();
        assert!(out.is_empty());
        assert_eq!(clip(&square, |v| i64::from(3 - v.0 - v.1), &mut out), Err(Full));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(10_000))]
        #[test]
        fn an_edge_is_cut_at_the_same_place_from_both_ends(
            a in -(1 << 28)..(1 << 28), b in -(1 << 28)..(1 << 28), inside in 0..1_i64 << 31, outside in 1..1_i64 << 31,
        ) {
            let there = Crossing { inside, outside: -outside }.coordinate(a, b);
            let back = Crossing { inside: outside, outside: -inside }.coordinate(b, a);
            prop_assert_eq!(there, back);
            // The exact value, to the nearest.
            let [a, b, i, o, got] = [i64::from(a), i64::from(b), inside, outside, i64::from(there)].map(i128::from);
            let error = (got * (i + o) - (a * o + b * i)).abs() * 2;
            prop_assert!(error <= i + o);
        }
    }
}
