//! What is left of a triangle behind the planes that have cut it: only to see on which side of further planes it lies.
//!
//! Nothing of this is ever drawn, so it may be rounded; it decides where a piece is put, not what it looks like.

use super::plane::{FINER, Plane, place_of};
use crate::num::divide_round;

/// So many planes may cut a piece.
pub const MOST_CUTS: usize = 32;

/// A triangle gains at most one corner at each plane.
const MOST_CORNERS: usize = 3 + MOST_CUTS;

/// Corners that cutting has made are in a plane if they are within this of it, in 2⁻²²: they are rounded to one each time.
const NEAR: i64 = 2;

/// On which side of a plane something lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    /// In front, perhaps touching it.
    Front,
    /// Behind, perhaps touching it.
    Back,
    /// In it.
    Within,
    /// On both sides.
    Both,
}

/// A convex polygon.
#[derive(Clone, Copy)]
pub(super) struct Polygon {
    /// The corners of the triangle, which are exact.
    corners: [[i64; 3]; 3],
    /// 2.22 numbers.
    places: [[i64; 3]; MOST_CORNERS],
    count: usize,
}

impl Polygon {
    pub(super) const fn new([a, b, c]: [[i16; 3]; 3]) -> Self {
        let corners = [place_of(a), place_of(b), place_of(c)];
        let mut places = [[0; 3]; MOST_CORNERS];
        [places[0], places[1], places[2]] = corners;
        Self { corners, places, count: 3 }
    }

    /// On which side it lies, what is closer than some 2⁻¹⁴ left aside.
    pub(super) const fn side(&self, plane: &Plane, tolerance: u8) -> Side {
        let exact = ((tolerance as i64) << FINER) * plane.steepest();
        let rounded = exact + NEAR * plane.steepest();
        let (mut is_front, mut is_back, mut at) = (false, false, 0);
        while at < self.count && at < MOST_CORNERS {
            let (corner, distance) = (self.places[at], plane.of_place(self.places[at]));
            let near = if self.is_corner(corner) { exact } else { rounded };
            is_front |= distance > near;
            is_back |= distance < -near;
            at += 1;
        }
        match (is_front, is_back) {
            (true, true) => Side::Both,
            (true, false) => Side::Front,
            (false, true) => Side::Back,
            (false, false) => Side::Within,
        }
    }

    /// The part of it in front of a plane, or behind it.
    pub(super) const fn cut(&self, plane: &Plane, is_front: bool) -> Self {
        let mut part = Self { count: 0, ..*self };
        let mut at = 0;
        while at < self.count && at < MOST_CORNERS {
            let here = self.places[at];
            let next = if at + 1 < self.count && at + 1 < MOST_CORNERS { self.places[at + 1] } else { self.places[0] };
            let (distance, further) = (plane.of_place(here), plane.of_place(next));
            if (distance >= 0) == is_front {
                part.push(here);
            }
            // From the front to the back on both parts, so that they get the same corner.
            if distance >= 0 && further < 0 {
                part.push(crossing(here, next, distance, further));
            } else if distance < 0 && further >= 0 {
                part.push(crossing(next, here, further, distance));
            }
            at += 1;
        }
        part
    }

    const fn push(&mut self, place: [i64; 3]) {
        if self.count < MOST_CORNERS {
            self.places[self.count] = place;
            self.count += 1;
        }
    }

    const fn is_corner(&self, place: [i64; 3]) -> bool {
        let [a, b, c] = self.corners;
        is_same(place, a) || is_same(place, b) || is_same(place, c)
    }
}

const fn is_same([a, b, c]: [i64; 3], [d, e, f]: [i64; 3]) -> bool {
    a == d && b == e && c == f
}

/// Where an edge passes a plane, by the distances of its ends: `distance ≥ 0 > further`.
const fn crossing(from: [i64; 3], to: [i64; 3], distance: i64, further: i64) -> [i64; 3] {
    let whole = distance - further;
    // To 37 bits; an edge has 24 along each axis, and a sign.
    let shift = (i64::BITS - whole.leading_zeros()).saturating_sub(37);
    let (part, whole) = (distance >> shift, whole >> shift);
    let ([a, b, c], [d, e, f]) = (from, to);
    [
        a + divide_round((d - a) * part, whole),
        b + divide_round((e - b) * part, whole),
        c + divide_round((f - c) * part, whole),
    ]
}

const _: () = assert!(16 + FINER <= 24, "an edge is less than 2²⁴ along each axis");
