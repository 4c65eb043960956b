//! Outcodes: on which sides of a window a point lies, a bit a side. Lecture 3.2.2.
//!
//! ```text
//!   1001 │ 1000 │ 1010        bits: top, bottom, right, left
//!  ──────┼──────┼──────       (top is above the first row: y grows downwards)
//!   0001 │ 0000 │ 0010
//!  ──────┼──────┼──────
//!   0101 │ 0100 │ 0110
//! ```
//!
//! Two outcodes decide most lines without arithmetic: both zero, all of it is inside; a bit that
//! both have, all of it is outside.

use core::ops::BitAnd;

use embedded_graphics::geometry::Point;

use crate::space::Rect;

/// x and y, in any unit.
type Place = (i32, i32);

/// The sides of a rectangle beyond which a pixel lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Outcode(u8);

impl Outcode {
    const LEFT: u8 = 1;
    const RIGHT: u8 = 2;
    const BELOW: u8 = 4;
    const ABOVE: u8 = 8;

    /// Classifies a pixel against a window.
    #[must_use]
    pub fn of(point: Point, window: Rect) -> Self {
        let bit = |outside: bool, bit: u8| if outside { bit } else { 0 };
        Self(
            bit(point.x < window.left, Self::LEFT)
                | bit(point.x >= window.right, Self::RIGHT)
                | bit(point.y >= window.bottom, Self::BELOW)
                | bit(point.y < window.top, Self::ABOVE),
        )
    }

    /// Classifies a place between whole coordinates, given as those below and above it, against a closed
    /// window, given as its first and last coordinates.
    ///
    /// Exact: a number is less than a whole one if the whole number below it is, and greater if the one above
    /// it is.
    pub(crate) const fn of_place((floor, ceiling): (Place, Place), (min, max): (Place, Place)) -> Self {
        let left = if floor.0 < min.0 { Self::LEFT } else { 0 };
        let right = if ceiling.0 > max.0 { Self::RIGHT } else { 0 };
        let below = if ceiling.1 > max.1 { Self::BELOW } else { 0 };
        let above = if floor.1 < min.1 { Self::ABOVE } else { 0 };
        Self(left | right | below | above)
    }

    /// Inside: beyond no side.
    #[must_use]
    pub const fn is_inside(self) -> bool {
        self.0 == 0
    }

    /// Left of the window.
    #[must_use]
    pub const fn is_left(self) -> bool {
        self.0 & Self::LEFT != 0
    }

    /// Right of the window.
    #[must_use]
    pub const fn is_right(self) -> bool {
        self.0 & Self::RIGHT != 0
    }

    /// Under the last row.
    #[must_use]
    pub const fn is_below(self) -> bool {
        self.0 & Self::BELOW != 0
    }

    /// Over the first row.
    #[must_use]
    pub const fn is_above(self) -> bool {
        self.0 & Self::ABOVE != 0
    }
}

/// The sides that two points share: a line between them lies outside if there is one.
impl BitAnd for Outcode {
    type Output = Self;

    fn bitand(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }
}
