//! Rectangular clip windows, for points of any unit, and the half-planes that windows are made of.
//!
//! ```text
//!          top                    a half-plane: what lies to the right of the way
//!      ┌────▶────┐                from one point to another, as seen on the screen;
//! left ▲         ▼ right          four of them are a rectangle
//!      └────◀────┘
//!         bottom
//! ```
//!
//! A clip window is *closed*: all of its border belongs to it, because a clipped line ends there. A
//! [`Rect`] of pixels becomes one in two ways: for pixels ([`Point`]) it reaches to the last row and
//! column inside, for points on sixteenths ([`Point2`]) to the far corners of those.

use embedded_graphics::geometry::Point;

use crate::{
    edge::LIMIT,
    error::OutOfRange,
    outcode::Outcode,
    space::{Point2, Rect},
    vary::Vertex,
};

/// A point of the plane whose coordinates are whole numbers of some unit.
pub trait PlanePoint: Copy {
    /// x and y.
    fn coordinates(self) -> (i32, i32);

    /// The point there.
    fn at(coordinates: (i32, i32)) -> Self;
}

/// Pixels.
impl PlanePoint for Point {
    fn coordinates(self) -> (i32, i32) {
        (self.x, self.y)
    }

    fn at((x, y): (i32, i32)) -> Self {
        Self::new(x, y)
    }
}

/// Sixteenths of a pixel.
impl PlanePoint for Point2 {
    fn coordinates(self) -> (i32, i32) {
        (self.x.to_bits(), self.y.to_bits())
    }

    fn at((x, y): (i32, i32)) -> Self {
        Self::from_sixteenths(x, y)
    }
}

/// A closed rectangle: `min` and `max` belong to it. Empty where a coordinate of `min` exceeds that of `max`.
///
/// ```
/// use aquatint::{Point2, Rect, clip::window::ClipWindow};
/// use embedded_graphics::geometry::Point;
///
/// let screen = Rect::new(0, 0, 128, 64);
/// assert_eq!(ClipWindow::<Point>::from(screen).max, Point::new(127, 63));
/// assert_eq!(ClipWindow::<Point2>::from(screen).max, Point2::corner(128, 64));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ClipWindow<P> {
    /// Least x and y inside.
    pub min: P,
    /// Greatest x and y inside.
    pub max: P,
}

impl<P: PlanePoint> ClipWindow<P> {
    /// The rectangle between two corners.
    #[must_use]
    pub const fn new(min: P, max: P) -> Self {
        Self { min, max }
    }

    fn empty() -> Self {
        Self::new(P::at((i32::MAX, i32::MAX)), P::at((i32::MIN, i32::MIN)))
    }

    /// On which sides a point lies.
    #[must_use]
    pub fn outcode(&self, point: P) -> Outcode {
        let place = point.coordinates();
        self.borders().outcode(place, place)
    }

    /// The four half-planes whose common part it is: left, top, right, bottom.
    #[must_use]
    pub fn half_planes(&self) -> [HalfPlane; 4] {
        let Borders { min, max } = self.borders();
        let side = |corner, along| HalfPlane { corner, along };
        [side(min, (0, -1)), side(min, (1, 0)), side(max, (0, 1)), side(max, (-1, 0))]
    }

    pub(super) fn borders(&self) -> Borders {
        Borders { min: self.min.coordinates(), max: self.max.coordinates() }
    }
}

/// The pixels of the rectangle.
impl From<Rect> for ClipWindow<Point> {
    fn from(rect: Rect) -> Self {
        if rect.is_empty() {
            return Self::empty();
        }
        // Not empty, so not at the least number.
        Self::new(Point::new(rect.left, rect.top), Point::new(rect.right.wrapping_sub(1), rect.bottom.wrapping_sub(1)))
    }
}

/// The area of the rectangle's pixels, with all of its border. Coordinates beyond the 28.4 format saturate.
impl From<Rect> for ClipWindow<Point2> {
    fn from(rect: Rect) -> Self {
        if rect.is_empty() {
            return Self::empty();
        }
        Self::new(Point2::corner(rect.left, rect.top), Point2::corner(rect.right, rect.bottom))
    }
}

/// A clip window without its unit: what the algorithms compute with.
#[derive(Clone, Copy, Debug)]
pub(super) struct Borders {
    pub(super) min: (i32, i32),
    pub(super) max: (i32, i32),
}

impl Borders {
    pub(super) const fn is_empty(self) -> bool {
        self.min.0 > self.max.0 || self.min.1 > self.max.1
    }

    /// On which sides a place lies that is known as the whole coordinates around it.
    pub(super) const fn outcode(self, floor: (i32, i32), ceiling: (i32, i32)) -> Outcode {
        Outcode::of_place((floor, ceiling), (self.min, self.max))
    }
}

/// One side of a straight line, the line included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HalfPlane {
    corner: (i32, i32),
    along: (i32, i32),
}

impl HalfPlane {
    /// What lies to the right of the way from `from` to `to` as seen on the screen (y down). All of the
    /// plane where the two are equal.
    ///
    /// # Errors
    /// [`OutOfRange`] when one of them is 4,194,304 pixels or more from the origin.
    pub fn new(from: Point2, to: Point2) -> Result<Self, OutOfRange> {
        if from.within(LIMIT) && to.within(LIMIT) { Ok(Self::between(from, to)) } else { Err(OutOfRange) }
    }

    /// [`new`](Self::new) for points that are known to be in range.
    pub(super) fn between(from: Point2, to: Point2) -> Self {
        let (corner, end) = (from.coordinates(), to.coordinates());
        Self { corner, along: (end.0.wrapping_sub(corner.0), end.1.wrapping_sub(corner.1)) }
    }

    /// How far inside a place is, in a unit of this half-plane's own; negative outside. Exact for any place:
    /// the line's direction is below 2²⁷, a difference of coordinates below 2³².
    pub(super) fn distance(self, place: (i32, i32)) -> i64 {
        let (x, y) = self.offset(place);
        i64::from(self.along.0) * y - i64::from(self.along.1) * x
    }

    /// How far along the line a place is, in the same unit.
    pub(super) fn position(self, place: (i32, i32)) -> i64 {
        let (x, y) = self.offset(place);
        i64::from(self.along.0) * x + i64::from(self.along.1) * y
    }

    /// From the corner to a place.
    fn offset(self, (x, y): (i32, i32)) -> (i64, i64) {
        (i64::from(x) - i64::from(self.corner.0), i64::from(y) - i64::from(self.corner.1))
    }
}

/// A boundary that vertices are inside or outside of.
pub trait Boundary<V> {
    /// How far inside a vertex lies, in any unit that is the same for all; negative outside.
    fn distance(&self, vertex: &V) -> i64;
}

impl<V, B: Boundary<V>> Boundary<V> for &B {
    #[inline]
    fn distance(&self, vertex: &V) -> i64 {
        (**self).distance(vertex)
    }
}

impl<P: PlanePoint> Boundary<P> for HalfPlane {
    fn distance(&self, vertex: &P) -> i64 {
        HalfPlane::distance(*self, vertex.coordinates())
    }
}

impl<const N: usize> Boundary<Vertex<N>> for HalfPlane {
    fn distance(&self, vertex: &Vertex<N>) -> i64 {
        HalfPlane::distance(*self, vertex.position.coordinates())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn empty_rectangles_stay_empty_and_others_keep_their_border() {
        for rect in [Rect::new(0, 0, 0, 5), Rect::new(3, 3, 2, 9), Rect::new(i32::MIN, 0, i32::MIN, 1)] {
            assert!(ClipWindow::<Point>::from(rect).borders().is_empty());
            assert!(ClipWindow::<Point2>::from(rect).borders().is_empty());
        }
        let all = Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX);
        assert_eq!(ClipWindow::<Point>::from(all).max, Point::new(i32::MAX - 1, i32::MAX - 1));
        assert_eq!(ClipWindow::<Point2>::from(all).min, Point2::from_sixteenths(i32::MIN, i32::MIN));
    }

    #[test]
    fn half_planes_of_a_rectangle_agree_with_its_outcodes() {
        let window = ClipWindow::new(Point::new(-2, 1), Point::new(3, 1));
        for (x, y) in (-4..6).flat_map(|x| (-1..4).map(move |y| (x, y))) {
            let code = window.outcode(Point::new(x, y));
            let outside = window.half_planes().map(|side| side.distance((x, y)) < 0);
            assert_eq!(outside, [code.is_left(), code.is_above(), code.is_right(), code.is_below()], "{x}, {y}");
        }
    }

    #[test]
    fn the_ends_of_the_range_do_not_overflow() {
        let far = (1 << 26) - 1;
        let slanted = HalfPlane::new(Point2::from_sixteenths(far, -far), Point2::from_sixteenths(-far, far)).unwrap();
        for place in [(i32::MIN, i32::MIN), (i32::MAX, i32::MAX), (i32::MIN, i32::MAX)] {
            assert!(slanted.distance(place).unsigned_abs() < 1 << 61);
            assert!(slanted.position(place).unsigned_abs() < 1 << 61);
        }
        assert!(HalfPlane::new(Point2::default(), Point2::from_sixteenths(0, i32::MIN)).is_err());
        assert_eq!(slanted.distance((far, -far)), 0);
    }
}
