//! The boundaries in clip space, before the perspective divide. Lecture 3.1.3 and 3.5.
//!
//! Visible is −w ≤ x, y, z ≤ w. In front of that stands a plane of its own, w ≥ ⅛: dividing by a
//! `w` of zero or less is what makes triangles behind the eye reappear upside down.
//!
//! To the sides the boundary is not the edge of the view but a *guard band* four times as wide.
//! Triangles are drawn exactly up to the window by the rasteriser anyway; cutting them only where
//! their coordinates would leave the number range means that almost none is ever cut, and that an
//! edge both of whose ends are within the guard band is the same edge for both its triangles.

use crate::space::{Clip, GUARD_BAND, LEAST_W, Point4};

/// One boundary of the volume.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plane {
    /// In front of the eye: w ≥ ⅛. First, so that the others may rely on it.
    Eye,
    /// Not nearer than the near plane: z ≥ −w.
    Near,
    /// Not farther than the far plane: z ≤ w.
    Far,
    /// x ≥ −4w.
    Left,
    /// x ≤ 4w.
    Right,
    /// y ≥ −4w.
    Bottom,
    /// y ≤ 4w.
    Top,
}

impl Plane {
    /// All of them, in the order in which to clip.
    pub const ALL: [Self; 7] = [Self::Eye, Self::Near, Self::Far, Self::Left, Self::Right, Self::Bottom, Self::Top];

    /// How far inside a point lies, in units of 2⁻¹⁶; negative outside.
    #[must_use]
    pub fn distance(self, point: &Point4<Clip>) -> i64 {
        let [x, y, z, w] = [point.x, point.y, point.z, point.w].map(|v| i64::from(v.to_bits()));
        match self {
            Self::Eye => w - i64::from(LEAST_W.to_bits()),
            Self::Near => w + z,
            Self::Far => w - z,
            Self::Left => GUARD_BAND * w + x,
            Self::Right => GUARD_BAND * w - x,
            Self::Bottom => GUARD_BAND * w + y,
            Self::Top => GUARD_BAND * w - y,
        }
    }
}

/// Outcode in clip space: one bit for each of [`Plane::ALL`] beyond which the point lies.
///
/// Zero: may be projected. Two points with a common bit: nothing between them is visible.
#[must_use]
pub fn outcode(point: &Point4<Clip>) -> u8 {
    Plane::ALL.iter().rev().fold(0, |code, plane| code << 1 | u8::from(plane.distance(point) < 0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::Scalar;

    fn point(x: i32, y: i32, z: i32, w: i32) -> Point4<Clip> {
        let [x, y, z, w] = [x, y, z, w].map(Scalar::from_num);
        Point4::new(x, y, z, w)
    }

    #[test]
    fn every_side_has_its_bit() {
        assert_eq!(outcode(&point(0, 0, 0, 1)), 0);
        assert_eq!(outcode(&point(4, -4, 1, 1)), 0, "on the boundary is inside");
        let outside = [point(0, 0, -2, 1), point(0, 0, 2, 1), point(-5, 0, 0, 1), point(5, 0, 0, 1)];
        assert_eq!(outside.map(|p| outcode(&p)), [2, 4, 8, 16]);
        assert_eq!([point(0, -5, 0, 1), point(0, 5, 0, 1)].map(|p| outcode(&p)), [32, 64]);
        assert_eq!(outcode(&point(0, 0, 0, 0)), 1, "w = 0 is behind the eye plane alone");
        assert_eq!(outcode(&point(0, 0, 0, -1)), 0b111_1111, "behind the eye is outside of everything");
    }

    #[test]
    fn the_ends_of_the_range_do_not_overflow() {
        for v in [Scalar::MIN, Scalar::MAX] {
            for w in [Scalar::MIN, Scalar::MAX] {
                assert!(outcode(&Point4::new(v, v, v, w)) < 1 << Plane::ALL.len());
            }
        }
    }
}
