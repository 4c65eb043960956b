//! Cohen-Sutherland line clipping. Lecture 3.2.2.
//!
//! ```text
//!        ●                    both outcodes zero:           accept
//!  ┌─────┼──────┐             a bit that both have:         reject
//!  │      ╲     │             else cut at the boundary of   and look again
//!  │       ╲────●             a bit that is set,
//!  └────────────┘
//! ```
//!
//! Best where most lines lie outside altogether: two outcodes reject those. Some lines are cut more
//! than once an end; [`liang_barsky`](super::liang_barsky) divides at most twice.
//!
//! Every cut is made on the *original* line: moving an end, rounding it and cutting the moved line
//! again, as the textbook does, drifts by hundreds of pixels on long lines and decides wrongly on
//! some. And it is judged before it is rounded: a place between two whole coordinates is beyond the
//! far border if the larger is, and beyond the near border if the smaller is. So accepting and
//! rejecting is exact, and the ends are the true intersections, to the nearest.

use crate::outcode::Outcode;

use super::{
    crossing::Crossing,
    window::{Borders, ClipWindow, PlanePoint},
};

/// The part of the line from `start` to `end` that lies in `window`, ends included; `None` if it
/// has none.
///
/// For pixels against a [`Rect`](crate::Rect), for points on sixteenths against a rectangle of those, or a
/// `Rect`. Right for all coordinates: a line is accepted exactly if it has a point in the closed window. Ends
/// that are cut lie on the boundary and within half a unit of the line, ties to the larger coordinate.
/// The result is that of [`liang_barsky`](super::liang_barsky). At most four 64-bit divisions, none for a
/// line that is accepted or rejected by its ends.
///
/// For *drawing*, use [`raster::bresenham`](crate::raster::bresenham), which clips without moving
/// a pixel.
///
/// ```
/// use aquatint::{Point2, Rect, clip::{cohen_sutherland::clip, window::ClipWindow}};
/// use embedded_graphics::geometry::Point;
///
/// let window = Rect::new(0, 0, 10, 10);
/// let part = clip((Point::new(-5, 0), Point::new(15, 20)), window);
/// assert_eq!(part, Some((Point::new(0, 5), Point::new(4, 9))));
///
/// // The same in sixteenths of a pixel. The window then reaches to the far corner of its last pixel.
/// let part = clip((Point2::corner(-5, 0), Point2::corner(15, 20)), window);
/// assert_eq!(part, Some((Point2::corner(0, 5), Point2::corner(5, 10))));
/// ```
#[must_use]
pub fn clip<P: PlanePoint>((start, end): (P, P), window: impl Into<ClipWindow<P>>) -> Option<(P, P)> {
    let line = (start.coordinates(), end.coordinates());
    clip_line(line, window.into().borders()).map(|(near, far)| (P::at(near), P::at(far)))
}

/// A line by its ends, in any unit.
type Line = ((i32, i32), (i32, i32));

fn clip_line(line: Line, window: Borders) -> Option<Line> {
    if window.is_empty() {
        return None;
    }
    let (mut near, mut far) = (Place::end(line.0), Place::end(line.1));
    // At most two cuts an end; the bound makes plain that this ends.
    for _ in 0..5 {
        let (near_code, far_code) = (near.outcode(window), far.outcode(window));
        if near_code.is_inside() && far_code.is_inside() {
            return Some((near.nearest, far.nearest));
        }
        if !(near_code & far_code).is_inside() {
            return None;
        }
        if near_code.is_inside() {
            far = Place::cut(line, window, far_code);
        } else {
            near = Place::cut(line, window, near_code);
        }
    }
    None
}

/// A place on the line: the whole coordinates around it, and the nearest.
struct Place {
    floor: (i32, i32),
    nearest: (i32, i32),
    ceiling: (i32, i32),
}

impl Place {
    const fn end(at: (i32, i32)) -> Self {
        Self { floor: at, nearest: at, ceiling: at }
    }

    const fn outcode(&self, window: Borders) -> Outcode {
        window.outcode(self.floor, self.ceiling)
    }

    /// Where the line crosses the boundary of a set bit. The ends of the line lie on two sides of it, or a bit
    /// would be common to both.
    fn cut((a, b): Line, window: Borders, code: Outcode) -> Self {
        if code.is_above() || code.is_below() {
            let y = if code.is_above() { window.min.1 } else { window.max.1 };
            let x = Crossing::after(a.1.abs_diff(y), a.1.abs_diff(b.1)).between(a.0, b.0);
            Self { floor: (x.floor, y), nearest: (x.nearest, y), ceiling: (x.ceiling, y) }
        } else {
            let x = if code.is_left() { window.min.0 } else { window.max.0 };
            let y = Crossing::after(a.0.abs_diff(x), a.0.abs_diff(b.0)).between(a.1, b.1);
            Self { floor: (x, y.floor), nearest: (x, y.nearest), ceiling: (x, y.ceiling) }
        }
    }
}
