//! Convex clip windows with any number of corners.
//!
//! ```text
//!      2 ●───● 3         each edge is a half-plane, on whose inner side
//!       ╱     ╲          the whole window lies: five boundaries
//!    1 ●       ● 4
//!       ╲____╱           convex: the edges turn one way only,
//!           5             and once around
//! ```
//!
//! With the shadow of a polygon for a window, this is clipping to a shadow volume in the plane (lecture 3.3.1).

use crate::{
    edge::LIMIT,
    error::describe,
    space::{Point2, twice_area},
};

use super::window::{HalfPlane, PlanePoint};

/// Why corners are no convex window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum WindowError {
    /// A corner is 4,194,304 pixels or more from the origin.
    OutOfRange,
    /// The corners have no area between them.
    Degenerate,
    /// The outline turns both ways, or more than once around.
    NotConvex,
}

describe! {
    WindowError,
    Self::OutOfRange => "a corner is out of range";
    Self::Degenerate => "a window without area";
    Self::NotConvex => "not convex";
}

/// A convex polygon to clip against, in either orientation.
///
/// Corners may be repeated, or lie on the straight edge between others. The border belongs to the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ConvexWindow<'a> {
    corners: &'a [Point2],
    /// Clockwise as seen on the screen.
    is_clockwise: bool,
}

impl<'a> ConvexWindow<'a> {
    /// Borrows and checks corners. One look at each of them.
    ///
    /// # Errors
    /// [`WindowError`].
    pub fn new(corners: &'a [Point2]) -> Result<Self, WindowError> {
        if !corners.iter().all(|corner| corner.within(LIMIT)) {
            return Err(WindowError::OutOfRange);
        }
        let turns = Turns::of(corners);
        match (turns.right, turns.left) {
            (false, false) => Err(WindowError::Degenerate),
            // Once around, an outline changes between going right and going left twice.
            (right, left) if right == left || turns.reversals != 2 => Err(WindowError::NotConvex),
            (is_clockwise, _) => Ok(Self { corners, is_clockwise }),
        }
    }

    /// The half-planes whose common part it is: as many as it has corners.
    pub fn half_planes(&self) -> impl Iterator<Item = HalfPlane> + use<'a> {
        let is_clockwise = self.is_clockwise;
        let side = move |(a, b)| if is_clockwise { HalfPlane::between(a, b) } else { HalfPlane::between(b, a) };
        edges(self.corners).map(side)
    }
}

/// The edges between corners, the last of them back to the first.
fn edges(corners: &[Point2]) -> impl Iterator<Item = (Point2, Point2)> + Clone + '_ {
    corners.iter().copied().zip(corners.iter().copied().cycle().skip(1))
}

/// How the edges of an outline turn.
#[derive(Default)]
struct Turns {
    right: bool,
    left: bool,
    /// How often the way changes between rightwards and leftwards.
    reversals: u32,
}

impl Turns {
    fn of(corners: &[Point2]) -> Self {
        // Repeated corners have no direction.
        let directions = edges(corners).map(direction).filter(|&direction| direction != Point2::default());
        let mut turns = Self::default();
        let Some(mut before) = directions.clone().last() else { return turns };
        for direction in directions {
            let turn = twice_area(Point2::default(), before, direction);
            turns.right |= turn > 0;
            turns.left |= turn < 0;
            turns.reversals += u32::from(is_rightwards(before) != is_rightwards(direction));
            before = direction;
        }
        turns
    }
}

/// From one point to another; both are in range.
fn direction((a, b): (Point2, Point2)) -> Point2 {
    let ((ax, ay), (bx, by)) = (a.coordinates(), b.coordinates());
    Point2::from_sixteenths(bx.wrapping_sub(ax), by.wrapping_sub(ay))
}

/// One half of all directions: to the right, and straight down.
fn is_rightwards(direction: Point2) -> bool {
    let (x, y) = direction.coordinates();
    (x, y) > (0, 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(corners: &[(i32, i32)]) -> Result<usize, WindowError> {
        let corners: heapless::Vec<_, 16> = corners.iter().map(|&(x, y)| Point2::from_sixteenths(x, y)).collect();
        ConvexWindow::new(&corners).map(|window| window.half_planes().count())
    }

    #[test]
    fn either_orientation_and_needless_corners_are_convex() {
        assert_eq!(check(&[(0, 0), (4, 0), (0, 4)]), Ok(3));
        assert_eq!(check(&[(0, 0), (0, 4), (4, 0)]), Ok(3), "the other way round");
        assert_eq!(check(&[(0, 0), (2, 0), (4, 0), (4, 4), (4, 4), (0, 4)]), Ok(6), "on an edge, and twice");
    }

    #[test]
    fn what_is_not_convex_is_refused() {
        assert_eq!(check(&[(0, 0), (8, 0), (1, 1), (0, 8)]), Err(WindowError::NotConvex), "a dent");
        let pentagram = [(0, -10), (6, 8), (-10, -3), (10, -3), (-6, 8)];
        assert_eq!(check(&pentagram), Err(WindowError::NotConvex), "turns one way only, but twice around");
        assert_eq!(check(&[(0, 0), (4, 4), (4, 0), (0, 4)]), Err(WindowError::NotConvex), "crosses itself");
        assert_eq!(check(&[(0, 0), (9, 0), (4, 0), (4, 4), (0, 4)]), Err(WindowError::NotConvex), "a spike");
        let twice = [(0, 0), (4, 0), (0, 4), (0, 0), (4, 0), (0, 4)];
        assert_eq!(check(&twice), Err(WindowError::NotConvex), "twice around");
    }

    #[test]
    fn what_has_no_area_or_is_too_far_is_refused() {
        assert_eq!(check(&[]), Err(WindowError::Degenerate));
        assert_eq!(check(&[(1, 1), (1, 1), (1, 1)]), Err(WindowError::Degenerate));
        assert_eq!(check(&[(0, 0), (4, 2), (8, 4), (2, 1)]), Err(WindowError::Degenerate));
        for bad in [i32::MIN, i32::MAX, 1 << 26] {
            assert_eq!(check(&[(0, 0), (4, 0), (0, bad)]), Err(WindowError::OutOfRange));
        }
    }
}
