//! Which part of a segment is near enough to the window to be cut.
//!
//! ```text
//!          ╭┄┄┄┄┄┄┄╮
//!         ┊┌───────┐┊
//!   ●━━━━━╋╋━━━━━━━╋╋━━━━━━━━●     the projection of the centre, and as far before and behind it as
//!         ┊│ window│┊              the radius of the disc: no division
//!         ┊└───────┘┊
//!          ╰┄┄┄┄┄┄┄╯
//! ```

use core::ops::Range;

use super::pattern::unit;
use crate::{
    edge::LIMIT,
    num::SUBPIXELS,
    outline::{FINE, enlarged},
    raster::stroke::direction::{Direction, between},
    space::{Point2, Rect},
};

/// A disc about the window: what is outside of it needs no dashes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sight {
    centre: Point2,
    radius: i64,
}

impl Sight {
    pub(super) fn of(window: Rect) -> Self {
        let end = (LIMIT.cast_signed() - 1) / SUBPIXELS;
        let [left, top, right, bottom] =
            [window.left, window.top, window.right, window.bottom].map(|v| v.clamp(-end, end));
        let half = SUBPIXELS / 2;
        let centre = Point2::from_sixteenths((left + right) * half, (top + bottom) * half);
        Self { centre, radius: unit((right - left).max(0) * half) + unit((bottom - top).max(0) * half) }
    }

    /// The same sixteen times as large.
    pub(super) fn enlarged(self) -> Self {
        Self { centre: enlarged(self.centre), radius: self.radius * i64::from(FINE) }
    }

    /// The part of a segment that is in the disc.
    pub(super) fn part(&self, from: Point2, direction: Direction, length: i64) -> Range<i64> {
        let to_centre = between(from, self.centre);
        let (along, across) = (direction.ahead(to_centre), direction.right().ahead(to_centre));
        if across.abs() > self.radius {
            return length..length;
        }
        let [start, end] = [along - self.radius, along + self.radius].map(|at| at.max(0).min(length));
        start..end
    }
}
