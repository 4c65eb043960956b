//! A line seen along its driving axis, the longer one: what every stepper of lines begins with.
//!
//! ```text
//!    ●━┓                     major  0 1 2 3 4 5 6 7     one step a pixel
//!      ┗━━┓                  minor  0 0 1 1 1 2 2 2     the distance gone across
//!         ┗━━●
//! ```
//!
//! The end with the lesser major coordinate comes first, so that a line is the same from both ends.

use core::ops::Range;

use embedded_graphics::geometry::Point;

use crate::{outcode::Outcode, space::Rect, span::Sink};

/// A line in canonical direction, standing on a pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Axes {
    /// Driving axis vertical?
    pub(super) is_steep: bool,
    pub(super) major: i32,
    pub(super) minor: i32,
    /// +1 or −1: where the minor axis leads as the major one grows.
    pub(super) direction: i32,
    /// Lengths along the axes; both fit 32 bits for any two points.
    pub(super) along: u32,
    pub(super) across: u32,
}

impl Axes {
    /// The line between two pixels, on its first pixel.
    pub(super) fn new(start: Point, end: Point) -> Self {
        let (width, height) = (start.x.abs_diff(end.x), start.y.abs_diff(end.y));
        let is_steep = height > width;
        let axes = |p: Point| if is_steep { (p.y, p.x) } else { (p.x, p.y) };
        let (a, b) = (axes(start), axes(end));
        let (first, last) = if a.0 <= b.0 { (a, b) } else { (b, a) };
        let direction = if first.1 <= last.1 { 1 } else { -1 };
        let (along, across) = (width.max(height), width.min(height));
        Self { is_steep, major: first.0, minor: first.1, direction, along, across }
    }

    /// The steps of the line whose pixels lie in a window. `first_step_with` says at which step the minor axis
    /// has gone a distance of one or more.
    ///
    /// Outcodes decide most lines, as in Cohen-Sutherland.
    pub(super) fn visible(
        &self,
        (start, end): (Point, Point),
        window: Rect,
        first_step_with: impl Fn(u64) -> u64,
    ) -> Range<u64> {
        let (start, end) = (Outcode::of(start, window), Outcode::of(end, window));
        let all = 0..u64::from(self.along) + 1;
        if window.is_empty() || !(start & end).is_inside() {
            return 0..0;
        }
        if start.is_inside() && end.is_inside() { all } else { self.crossing(all, window, first_step_with) }
    }

    /// The steps at which both coordinates lie in a window.
    fn crossing(&self, steps: Range<u64>, window: Rect, first_step_with: impl Fn(u64) -> u64) -> Range<u64> {
        let (columns, rows) = (window.columns(), window.rows());
        let (major, minor) = if self.is_steep { (rows, columns) } else { (columns, rows) };
        let ahead = |from: i32, to: i32| (i64::from(to) - i64::from(from)).max(0).unsigned_abs();
        // One more than the distance to a coordinate that is still inside.
        let past = |from: i32, to: i32| (i64::from(to) - i64::from(from) + 1).max(0).unsigned_abs();
        let on_major = ahead(self.major, major.start)..ahead(self.major, major.end);
        // How far the minor axis has to go to come in, and to leave.
        let (enter, leave) = if self.direction > 0 {
            (ahead(self.minor, minor.start), ahead(self.minor, minor.end))
        } else {
            (past(minor.end, self.minor), past(minor.start, self.minor))
        };
        let step = |distance| if distance == 0 { 0 } else { first_step_with(distance) };
        let start = steps.start.max(on_major.start).max(step(enter));
        start..steps.end.min(on_major.end).min(step(leave))
    }

    /// Goes along and across from the first pixel.
    pub(super) fn go(&mut self, along: u32, across: u32) {
        self.major = self.major.saturating_add_unsigned(along);
        self.minor = if self.direction > 0 {
            self.minor.saturating_add_unsigned(across)
        } else {
            self.minor.saturating_sub_unsigned(across)
        };
    }

    /// A pixel.
    #[inline]
    pub(super) const fn point(&self) -> Point {
        if self.is_steep { Point::new(self.minor, self.major) } else { Point::new(self.major, self.minor) }
    }
}

/// Emits single pixels in the order of a line, neighbours in a row as one span.
pub(super) fn emit_runs<S: Sink>(mut points: impl Iterator<Item = Point>, sink: &mut S) -> Result<(), S::Error> {
    let Some(Point { x, y }) = points.next() else { return Ok(()) };
    let (mut row, mut columns) = (y, x..x.saturating_add(1));
    for Point { x, y } in points {
        if y == row && x == columns.end {
            columns.end = x.saturating_add(1);
        } else {
            sink.span(row, columns, ())?;
            (row, columns) = (y, x..x.saturating_add(1));
        }
    }
    sink.span(row, columns, ())
}
