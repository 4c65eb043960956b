//! How a line in space meets a boundary: what both line clippers compute with.

use crate::num::saturate_u32;

use super::crossing::{Crossing, Cut};

/// A place on the way of a line: after `part / whole` of it, 0 at its start and 1 at its end.
#[derive(Clone, Copy, Debug)]
pub(super) struct Parameter {
    part: u64,
    whole: u64,
}

/// What a line does at a boundary, on its way from its start to its end.
#[derive(Clone, Copy, Debug)]
pub(super) enum Meeting {
    /// It is inside all the way.
    Inside,
    /// It is outside all the way.
    Outside,
    /// It begins outside and is inside from there on.
    Enters(Parameter),
    /// It is inside up to there and ends outside.
    Leaves(Parameter),
}

impl Meeting {
    /// Of a line whose ends lie so far inside of the boundary.
    #[inline]
    pub(super) const fn of(at_start: i64, at_end: i64) -> Self {
        let place = Parameter { part: at_start.unsigned_abs(), whole: at_start.abs_diff(at_end) };
        match (at_start >= 0, at_end >= 0) {
            (true, true) => Self::Inside,
            (false, false) => Self::Outside,
            (false, true) => Self::Enters(place),
            (true, false) => Self::Leaves(place),
        }
    }

    /// Whether a place on the line is outside.
    pub(super) fn is_outside(&self, place: Parameter) -> bool {
        match *self {
            Self::Inside => false,
            Self::Outside => true,
            Self::Enters(entry) => entry.is_after(place),
            Self::Leaves(exit) => place.is_after(exit),
        }
    }
}

impl Parameter {
    /// Whether it comes later than another place. Exact, by cross multiplication.
    pub(super) fn is_after(self, other: Self) -> bool {
        let [whole, other_whole] = [self.whole, other.whole].map(saturate_u32);
        if u64::from(whole) == self.whole && u64::from(other_whole) == other.whole {
            // Within the range of clip coordinates: no part exceeds its whole, so 64 bits do.
            return self.part * other.whole > other.part * self.whole;
        }
        u128::from(self.part) * u128::from(other.whole) > u128::from(other.part) * u128::from(self.whole)
    }

    /// The vertex where the line enters: its end is the inside.
    pub(super) fn entry<V: Cut>(self, start: V, end: V) -> V {
        V::cut(end, start, Crossing::of(self.whole - self.part, self.whole))
    }

    /// The vertex where the line leaves: its start is the inside.
    pub(super) fn exit<V: Cut>(self, start: V, end: V) -> V {
        V::cut(start, end, Crossing::of(self.part, self.whole))
    }
}
