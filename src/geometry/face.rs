//! Back-face removal. Lecture 5.5.
//!
//! Half of the faces of a closed solid are hidden by the other half. There are two ways to drop them:
//!
//! - On the screen, after the perspective divide, [`side`] asks which way the corners run. That is exact: the sign
//!   of the area *is* the sign of `dot(n, v)`, and no normal need be stored.
//! - In the model, before anything is transformed, [`faces_viewer`] asks for that dot product itself: three
//!   products, where the face has a normal.
//!
//! ```text
//!    a          a
//!    │╲        ╱│     on the screen: counter-clockwise is the front,
//!    b─c      c─b     clockwise the back
//! ```

use crate::{
    num::{bits, low_i32},
    space::{Model, Point2, Point3, twice_area},
};

/// A side of a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Side {
    /// The one from which its corners run counter-clockwise.
    Front,
    /// The other one.
    Back,
}

/// Which sides of the faces of a surface are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Faces {
    /// Fronts: for closed solids, seen from outside.
    #[default]
    Front,
    /// Backs: the inside of a room, or the far half of a solid.
    Back,
    /// Both: for leaves, sheets, and whatever has holes.
    Both,
}

impl Faces {
    /// Whether a side is drawn.
    #[inline]
    #[must_use]
    pub const fn includes(self, side: Side) -> bool {
        matches!((self, side), (Self::Both, _) | (Self::Front, Side::Front) | (Self::Back, Side::Back))
    }

    /// The side of a triangle that is drawn, if one is: by [twice its area](twice_area) on the screen.
    ///
    /// A triangle without area shows nothing.
    ///
    /// ```
    /// use aquatint::geometry::face::{Faces, Side};
    ///
    /// assert_eq!(Faces::Both.shows(-512), Some(Side::Front));
    /// assert_eq!(Faces::Both.shows(512), Some(Side::Back)); // light it by the normal turned around
    /// assert_eq!(Faces::Front.shows(512), None);
    /// ```
    #[inline]
    #[must_use]
    pub const fn shows(self, twice_area: i64) -> Option<Side> {
        match self {
            // y runs down on the screen, so counter-clockwise is negative.
            Self::Front | Self::Both if twice_area < 0 => Some(Side::Front),
            Self::Back | Self::Both if twice_area > 0 => Some(Side::Back),
            _ => None,
        }
    }
}

/// The side that a triangle shows; `None` where it has no area.
///
/// Two 32-bit products where its corners are less than 2048 pixels apart, long ones otherwise.
#[inline]
#[must_use]
pub fn side(a: Point2, b: Point2, c: Point2) -> Option<Side> {
    Faces::Both.shows(signed_area(a, b, c))
}

/// Whether a triangle shows its front: its corners run counter-clockwise, as seen. Costs what [`side`] costs.
#[inline]
#[must_use]
pub fn is_front(a: Point2, b: Point2, c: Point2) -> bool {
    side(a, b, c) == Some(Side::Front)
}

/// [`twice_area`], with short products where they do.
#[inline]
pub(crate) fn signed_area(a: Point2, b: Point2, c: Point2) -> i64 {
    match (short(a, b), short(a, c)) {
        // Below 2³⁰ each.
        (Some((bx, by)), Some((cx, cy))) => i64::from(bx * cy - cx * by),
        _ => twice_area(a, b, c),
    }
}

/// The way between two points, if it fits 15 bits and a sign.
#[inline]
fn short(from: Point2, to: Point2) -> Option<(i32, i32)> {
    let x = to.x.to_bits().checked_sub(from.x.to_bits())?;
    let y = to.y.to_bits().checked_sub(from.y.to_bits())?;
    // A number and its complement, whichever is not negative, have the same digits.
    let digits = |v: i32| bits(v ^ (v >> 31));
    (digits(x) | digits(y) < 1 << 15).then_some((x, y))
}

/// Whether a face that passes through `place` with this normal (of any length) is seen from its front by an eye:
/// `dot(normal, eye − place) ≥ 0`. All in the object's own space.
///
/// Exact. The normal is quantised to 7 bits, so that a face seen almost edge-on, within half a degree, may be taken
/// for one that is not; [`is_front`] decides such faces.
///
/// ```
/// use aquatint::{Point3, Scalar, geometry::face::faces_viewer};
///
/// let eye = Point3::new(Scalar::ZERO, Scalar::ZERO, Scalar::from_num(3));
/// assert!(faces_viewer([0, 0, 127], [0, 0, 16384], eye));
/// assert!(!faces_viewer([0, 0, -127], [0, 0, -16384], eye));
/// ```
#[must_use]
pub fn faces_viewer(normal: [i8; 3], place: [i16; 3], eye: Point3<Model>) -> bool {
    // Places have 14 fraction bits, the eye 16.
    let [px, py, pz] = place.map(|v| i64::from(v) << 2);
    let [ex, ey, ez] = [eye.x, eye.y, eye.z].map(|v| i64::from(v.to_bits()));
    let (x, y, z) = (ex - px, ey - py, ez - pz);
    let normal = normal.map(i32::from);
    let near = |v: i64| v.unsigned_abs() < 1 << 22;
    let [a, b, c] = normal;
    if near(x) && near(y) && near(z) {
        // Less than 64 away: below 2²⁹ each.
        return a * low_i32(x) + b * low_i32(y) + c * low_i32(z) >= 0;
    }
    let [a, b, c] = normal.map(i64::from);
    a * x + b * y + c * z >= 0
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
        assert_eq!([side(a, b, c), side(a, c, b), side(a, a, b)], [Some(Side::Front), Some(Side::Back), None]);
    }

    #[test]
    fn each_choice_shows_its_sides() {
        let areas = [-1, 0, 1, i64::MIN, i64::MAX];
        let (front, back) = (Some(Side::Front), Some(Side::Back));
        assert_eq!(areas.map(|area| Faces::Front.shows(area)), [front, None, None, front, None]);
        assert_eq!(areas.map(|area| Faces::Back.shows(area)), [None, None, back, None, back]);
        assert_eq!(areas.map(|area| Faces::Both.shows(area)), [front, None, back, front, back]);
    }
}
