//! Back-face removal. Lecture 5.5.

use crate::space::{Point2, twice_area};

/// Whether a triangle shows its front: its corners run counter-clockwise, as seen.
///
/// Half of the faces of a closed solid are hidden by the other half; this test drops them for the
/// price of two multiplications. On the screen, after the perspective divide, it is exact: the
/// sign of the area *is* the sign of `dot(n, v)`, with no normal to store. A triangle without area
/// shows nothing.
#[must_use]
pub fn is_front(a: Point2, b: Point2, c: Point2) -> bool {
    // y runs down on the screen, so counter-clockwise is negative.
    twice_area(a, b, c) < 0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn winding_decides() {
        //  a
        //  │╲      counter-clockwise as seen: a, b, c
        //  b─c
        let (a, b, c) = (Point2::corner(0, 0), Point2::corner(0, 2), Point2::corner(2, 2));
        assert!(is_front(a, b, c) && is_front(b, c, a));
        assert!(!is_front(a, c, b));
        assert!(!is_front(a, a, b), "no area");
    }
}
