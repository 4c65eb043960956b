//! Liang-Barsky line clipping. Lecture 3.2.3.
//!
//! The line is `a + t · (b − a)` with t from 0 to 1. Each border is crossed at some t, inwards or
//! outwards; what is inside of all four begins where the last border is crossed inwards, and ends where
//! the first is crossed outwards.
//!
//! ```text
//!            │  b                 crossings inwards    left      t = 1/5
//!     ───────┼─╱──                                     bottom    t = 2/5   the last: enters here
//!      │     │╱                   crossings outwards   right     t = 4/5   the first: leaves here
//!     ─┼────╱┼───                                      top       t = 9/10
//!      │  ╱  │                    2/5 ≤ 4/5: visible
//! ```
//!
//! No t is computed. Each is kept as distance over length, both below 2³², and two are compared by cross
//! multiplication in 64 bits, exactly and for all coordinates. So there is a division only for an end
//! that is cut, after the line is accepted: 0, 1 or 2.
//!
//! Y.-D. Liang and B. A. Barsky, "A new concept and method for line clipping", ACM Transactions on Graphics
//! 3(1), 1984.

use super::{
    crossing::Crossing,
    window::{Borders, ClipWindow, PlanePoint},
};

/// The part of the line from `start` to `end` that lies in `window`, ends included; `None` if it
/// has none.
///
/// Takes and gives what [`cohen_sutherland::clip`](super::cohen_sutherland::clip) does, to the last bit: exact
/// decisions for all coordinates, ends to the nearest. At most two 64-bit divisions.
///
/// ```
/// use aquatint::{Point2, Rect, clip::{liang_barsky::clip, window::ClipWindow}};
///
/// // A window that is no rectangle of whole pixels.
/// let window = ClipWindow::new(Point2::from_sixteenths(-8, -8), Point2::from_sixteenths(24, 8));
/// let part = clip((Point2::corner(-1, 0), Point2::corner(3, 1)), window);
/// assert_eq!(part, Some((Point2::from_sixteenths(-8, 2), Point2::from_sixteenths(16, 8))));
/// ```
#[must_use]
pub fn clip<P: PlanePoint>((start, end): (P, P), window: impl Into<ClipWindow<P>>) -> Option<(P, P)> {
    let (a, b) = (start.coordinates(), end.coordinates());
    let (enters, leaves) = visible(a, b, window.into().borders())?;
    let point = |cut: Option<BorderCrossing>, end: P| cut.map_or(end, |cut| P::at(cut.place(a, b)));
    Some((point(enters, start), point(leaves, end)))
}

/// Which coordinate is the same all along a border.
#[derive(Clone, Copy, Debug)]
enum Axis {
    X,
    Y,
}

/// Where a line crosses a border: after `distance / length` of its way, `distance ≤ length`.
#[derive(Clone, Copy, Debug)]
struct BorderCrossing {
    axis: Axis,
    border: i32,
    distance: u32,
    length: u32,
}

impl BorderCrossing {
    /// Whether it comes later on the way than another one.
    fn is_after(&self, other: &Self) -> bool {
        u64::from(self.distance) * u64::from(other.length) > u64::from(other.distance) * u64::from(self.length)
    }

    /// The nearest point on the border: the one division of an end.
    fn place(&self, a: (i32, i32), b: (i32, i32)) -> (i32, i32) {
        let crossing = Crossing::after(self.distance, self.length);
        match self.axis {
            Axis::X => (self.border, crossing.coordinate(a.1, b.1)),
            Axis::Y => (crossing.coordinate(a.0, b.0), self.border),
        }
    }
}

/// The borders by which a visible line enters and leaves, `None` where it begins or ends inside.
type Visible = (Option<BorderCrossing>, Option<BorderCrossing>);

/// Accepts or rejects, without a division.
fn visible(a: (i32, i32), b: (i32, i32), window: Borders) -> Option<Visible> {
    if window.is_empty() {
        return None;
    }
    let (x_enters, x_leaves) = between_borders(Axis::X, (a.0, b.0), (window.min.0, window.max.0))?;
    let (y_enters, y_leaves) = between_borders(Axis::Y, (a.1, b.1), (window.min.1, window.max.1))?;
    let enters = either(x_enters, y_enters, BorderCrossing::is_after);
    let leaves = either(x_leaves, y_leaves, |x, y| y.is_after(x));
    let is_past = enters.zip(leaves).is_some_and(|(enters, leaves)| enters.is_after(&leaves));
    (!is_past).then_some((enters, leaves))
}

/// The one of two that there is, or `one` of both if that is the choice.
fn either<T>(one: Option<T>, other: Option<T>, choose_one: impl Fn(&T, &T) -> bool) -> Option<T> {
    match (one, other) {
        (Some(one), Some(other)) => Some(if choose_one(&one, &other) { one } else { other }),
        (one, other) => one.or(other),
    }
}

/// Where the line comes in between two borders, and where it goes out; `None` if it never is between them.
fn between_borders(axis: Axis, (from, to): (i32, i32), (min, max): (i32, i32)) -> Option<Visible> {
    if from.max(to) < min || from.min(to) > max {
        return None;
    }
    let crossing = |border| BorderCrossing { axis, border, distance: from.abs_diff(border), length: from.abs_diff(to) };
    if from <= to {
        Some(((from < min).then(|| crossing(min)), (to > max).then(|| crossing(max))))
    } else {
        Some(((from > max).then(|| crossing(max)), (to < min).then(|| crossing(min))))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_end_is_divided_for_only_if_it_is_cut() {
        let window = Borders { min: (0, 0), max: (10, 10) };
        let cut = |a, b| visible(a, b, window).map(|(enters, leaves)| [enters, leaves].iter().flatten().count());
        assert_eq!(cut((1, 1), (9, 5)), Some(0), "inside");
        assert_eq!(cut((0, 0), (10, 10)), Some(0), "on the border is inside");
        assert_eq!(cut((-3, 2), (5, 5)), Some(1), "one end");
        assert_eq!(cut((-3, 2), (15, 5)), Some(2), "through");
        assert_eq!(cut((-30, -31), (40, 42)), Some(2), "through, past all four borders");
        assert_eq!(cut((-3, 8), (4, 15)), None, "past the corner");
        assert_eq!(cut((-5, 5), (5, 15)), Some(2), "through the corner itself");
        assert_eq!(cut((-5, 3), (-1, 3)), None, "beside");
    }
}
