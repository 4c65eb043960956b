//! Where things are: the spaces of the pipeline, points and vectors in them, and pixel rectangles.
//!
//! A point carries the name of its space in its type, so that a [`Matrix`](crate::Matrix) from
//! world to view cannot be applied to a point of the model:
//!
//! ```text
//! Model ──placement──▶ World ──camera──▶ View ──projection──▶ Clip ──÷w, viewport──▶ screen
//! ```

use core::{marker::PhantomData, ops::Range};

use embedded_graphics::{
    geometry::{Point, Size},
    primitives::Rectangle,
};

use crate::num::{Scalar, Subpixel, bits, format_fixed, saturate_i32, size_i32};

/// Space of one object, as its mesh was made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Model {}
/// Space in which objects, lights and the camera are placed. Right-handed, y up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum World {}
/// Space of the camera: the eye at the origin, looking down −z, y up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum View {}
/// Homogeneous space before the perspective divide: visible is −w ≤ x, y, z ≤ w.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clip {}

/// Clip coordinates must be nearer to zero than this (4096) for intersections to be exact.
pub const CLIP_LIMIT: Scalar = Scalar::from_bits(1 << 28);

/// The least `w` that a clip coordinate may be divided by: ⅛.
pub const LEAST_W: Scalar = Scalar::from_bits(1 << 13);

/// How many times as wide as the view the guard band is, up to which points are projected.
pub const GUARD_BAND: i64 = 4;

/// A point in the three-dimensional space `S`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Point3<S> {
    /// To the right.
    pub x: Scalar,
    /// Up.
    pub y: Scalar,
    /// Towards the viewer.
    pub z: Scalar,
    space: PhantomData<S>,
}

format_fixed! {
    impl[S] |it: Point3<S>| "Point3 {{ x: {}, y: {}, z: {} }}", Fixed(it.x), Fixed(it.y), Fixed(it.z)
}

/// A direction in the three-dimensional space `S`, not moved by translations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vector3<S> {
    /// To the right.
    pub x: Scalar,
    /// Up.
    pub y: Scalar,
    /// Towards the viewer.
    pub z: Scalar,
    space: PhantomData<S>,
}

format_fixed! {
    impl[S] |it: Vector3<S>| "Vector3 {{ x: {}, y: {}, z: {} }}", Fixed(it.x), Fixed(it.y), Fixed(it.z)
}

/// A homogeneous point of the space `S`: stands for `(x/w, y/w, z/w)`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Point4<S> {
    /// To the right.
    pub x: Scalar,
    /// Up.
    pub y: Scalar,
    /// Depth.
    pub z: Scalar,
    /// What the others are divided by.
    pub w: Scalar,
    space: PhantomData<S>,
}

format_fixed! {
    impl[S] |it: Point4<S>| "Point4 {{ x: {}, y: {}, z: {}, w: {} }}", Fixed(it.x), Fixed(it.y), Fixed(it.z), Fixed(it.w)
}

impl<S> Point3<S> {
    /// Where all coordinates are zero.
    pub const ORIGIN: Self = Self::new(Scalar::ZERO, Scalar::ZERO, Scalar::ZERO);

    /// A point from its coordinates.
    #[must_use]
    pub const fn new(x: Scalar, y: Scalar, z: Scalar) -> Self {
        Self { x, y, z, space: PhantomData }
    }
}

impl<S> Vector3<S> {
    /// A vector from its components.
    #[must_use]
    pub const fn new(x: Scalar, y: Scalar, z: Scalar) -> Self {
        Self { x, y, z, space: PhantomData }
    }

    /// The vector of length 1 in the same direction; `None` for the zero vector.
    ///
    /// Each component is right to one unit of the 16.16 format, for every input. One integer
    /// square root and three divisions: for set-up, not for each vertex.
    #[must_use]
    pub fn normalized(self) -> Option<Self> {
        let components = [self.x, self.y, self.z].map(|v| i64::from(v.to_bits()));
        let largest = components.iter().map(|v| v.unsigned_abs()).max()?;
        // Scale up so that short vectors keep their digits: 2³⁰ ≤ largest < 2³¹, sum < 2⁶⁴.
        let shift = largest.checked_ilog2()?;
        let [x, y, z] = components.map(|v| if shift <= 30 { v << (30 - shift) } else { v >> (shift - 30) });
        let squares = [x, y, z].iter().map(|v| v.unsigned_abs().pow(2)).sum::<u64>();
        let length = i64::try_from(squares.isqrt()).ok().filter(|&length| length > 0)?;
        let unit = |v: i64| Scalar::from_bits(saturate_i32(crate::num::divide_round(v << 16, length)));
        Some(Self::new(unit(x), unit(y), unit(z)))
    }
}

impl<S> Point4<S> {
    /// A homogeneous point from its coordinates.
    #[must_use]
    pub const fn new(x: Scalar, y: Scalar, z: Scalar, w: Scalar) -> Self {
        Self { x, y, z, w, space: PhantomData }
    }
}

/// A point on the screen, to a sixteenth of a pixel. x grows to the right, y downwards.
///
/// Whole coordinates are the corners of pixels. A pixel belongs to a shape when its *centre*,
/// at halves, lies inside.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Point2 {
    /// To the right.
    pub x: Subpixel,
    /// Down.
    pub y: Subpixel,
}

format_fixed! {
    impl[] |it: Point2| "Point2 {{ x: {}, y: {} }}", Fixed(it.x), Fixed(it.y)
}

impl Point2 {
    /// A point from its coordinates.
    #[must_use]
    pub const fn new(x: Subpixel, y: Subpixel) -> Self {
        Self { x, y }
    }

    /// The top left corner of pixel `(x, y)`; coordinates beyond the 28.4 format saturate.
    #[must_use]
    pub const fn corner(x: i32, y: i32) -> Self {
        Self::from_sixteenths(x.saturating_mul(crate::num::SUBPIXELS), y.saturating_mul(crate::num::SUBPIXELS))
    }

    /// A point from coordinates counted in sixteenths of a pixel.
    #[must_use]
    pub const fn from_sixteenths(x: i32, y: i32) -> Self {
        Self { x: Subpixel::from_bits(x), y: Subpixel::from_bits(y) }
    }

    /// Whether both coordinates, in sixteenths of a pixel, are less than `limit` from zero.
    pub(crate) const fn within(self, limit: u32) -> bool {
        self.x.to_bits().unsigned_abs() < limit && self.y.to_bits().unsigned_abs() < limit
    }

    /// [`clamped`](Self::clamped), fast for points that are within.
    #[inline]
    pub(crate) fn nearest_within(self, limit: u32) -> Self {
        if self.within(limit) { self } else { self.clamped(limit) }
    }

    /// The nearest point that is [`within`](Self::within) a limit.
    pub(crate) fn clamped(self, limit: u32) -> Self {
        let end = size_i32(limit.saturating_sub(1));
        Self::from_sixteenths(self.x.to_bits().clamp(-end, end), self.y.to_bits().clamp(-end, end))
    }
}

/// Twice the area of a screen triangle, in square sixteenths of a pixel: positive where its
/// corners run clockwise as seen on the screen (y down), negative where counter-clockwise.
///
/// Exact while the coordinates are less than 2³⁰ sixteenths from zero, modulo 2⁶⁴ beyond.
#[must_use]
pub fn twice_area(a: Point2, b: Point2, c: Point2) -> i64 {
    let from_a = |p: Point2| {
        let x = i64::from(p.x.to_bits()) - i64::from(a.x.to_bits());
        let y = i64::from(p.y.to_bits()) - i64::from(a.y.to_bits());
        (x, y)
    };
    let ((bx, by), (cx, cy)) = (from_a(b), from_a(c));
    bx.wrapping_mul(cy).wrapping_sub(cx.wrapping_mul(by))
}

/// A rectangle of whole pixels: `left` and `top` belong to it, `right` and `bottom` do not.
///
/// ```text
///   left        right
/// top ┌───┬───┬───┐     3 columns, 2 rows: left 0, top 0,
///     ├───┼───┼───┤                        right 3, bottom 2
/// bot └───┴───┴───┘
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rect {
    /// First column inside.
    pub left: i32,
    /// First row inside.
    pub top: i32,
    /// First column behind.
    pub right: i32,
    /// First row below.
    pub bottom: i32,
}

impl Rect {
    /// A rectangle from its four borders. It is empty where a far border does not exceed a near one.
    #[must_use]
    pub const fn new(left: i32, top: i32, right: i32, bottom: i32) -> Self {
        Self { left, top, right, bottom }
    }

    /// The rectangle of this size at the origin; sizes beyond `i32` saturate.
    #[must_use]
    pub const fn of_size(size: Size) -> Self {
        Self::new(0, 0, size_i32(size.width), size_i32(size.height))
    }

    /// The columns inside.
    #[must_use]
    pub const fn columns(self) -> Range<i32> {
        self.left..self.right
    }

    /// The rows inside.
    #[must_use]
    pub const fn rows(self) -> Range<i32> {
        self.top..self.bottom
    }

    /// Whether no pixel is inside.
    #[must_use]
    pub const fn is_empty(self) -> bool {
        self.left >= self.right || self.top >= self.bottom
    }

    /// Columns across, 0 when empty.
    #[must_use]
    pub const fn width(self) -> u32 {
        if self.left >= self.right { 0 } else { bits(self.right).wrapping_sub(bits(self.left)) }
    }

    /// Rows down, 0 when empty.
    #[must_use]
    pub const fn height(self) -> u32 {
        if self.top >= self.bottom { 0 } else { bits(self.bottom).wrapping_sub(bits(self.top)) }
    }

    /// Whether a pixel is inside.
    #[must_use]
    pub fn contains(self, point: Point) -> bool {
        self.columns().contains(&point.x) && self.rows().contains(&point.y)
    }

    /// The pixels that are in both. Where there are none it has no rows, however high both are: nobody walks down them.
    #[must_use]
    pub fn intersection(self, other: Self) -> Self {
        let (left, right) = (self.left.max(other.left), self.right.min(other.right));
        let (top, bottom) = (self.top.max(other.top), self.bottom.min(other.bottom));
        Self::new(left, top, right, if left < right { bottom } else { top })
    }

    /// The part of a run of columns that lies inside on `row`, if any does.
    #[must_use]
    pub fn clip_run(self, row: i32, columns: Range<i32>) -> Option<Range<i32>> {
        let visible = columns.start.max(self.left)..columns.end.min(self.right);
        (self.rows().contains(&row) && !visible.is_empty()).then_some(visible)
    }
}

impl From<Rectangle> for Rect {
    fn from(area: Rectangle) -> Self {
        let Point { x, y } = area.top_left;
        let Size { width, height } = area.size;
        Self::new(x, y, x.saturating_add_unsigned(width), y.saturating_add_unsigned(height))
    }
}

impl From<Rect> for Rectangle {
    fn from(rect: Rect) -> Self {
        Self::new(Point::new(rect.left, rect.top), Size::new(rect.width(), rect.height()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_vector_has_length_one_whatever_it_came_from() {
        for raw in [[3, 4, 0], [1, 0, 0], [i32::MIN, i32::MAX, 1], [-7, 900, 65_536 * 3], [1, 1, 1]] {
            let [x, y, z] = raw.map(Scalar::from_bits);
            let unit = Vector3::<World>::new(x, y, z).normalized().expect("not zero");
            let exact = raw.map(f64::from);
            let length = exact.iter().map(|v| v * v).sum::<f64>().sqrt();
            for (component, exact) in [unit.x, unit.y, unit.z].into_iter().zip(exact) {
                let error = component.to_num::<f64>() - exact / length;
                assert!(error.abs() <= 1.01 / 65_536.0, "{raw:?}: {error}");
            }
        }
        assert_eq!(Vector3::<World>::new(Scalar::ZERO, Scalar::ZERO, Scalar::ZERO).normalized(), None);
    }

    #[test]
    fn a_rectangle_at_the_ends_of_i32_saturates() {
        let huge = Rectangle::new(Point::new(i32::MAX - 1, i32::MIN), Size::new(u32::MAX, u32::MAX));
        assert_eq!(Rect::from(huge), Rect::new(i32::MAX - 1, i32::MIN, i32::MAX, i32::MAX));
        assert_eq!(Rect::new(i32::MIN, 0, i32::MAX, 1).width(), u32::MAX);
        assert_eq!(Rect::new(5, 0, 3, 1).width(), 0);
    }

    #[test]
    fn area_is_positive_clockwise_on_the_screen() {
        let [a, b, c] = [Point2::corner(0, 0), Point2::corner(2, 0), Point2::corner(0, 1)];
        assert_eq!(twice_area(a, b, c), 2 * 16 * 16);
        assert_eq!(twice_area(a, c, b), -2 * 16 * 16);
    }
}
