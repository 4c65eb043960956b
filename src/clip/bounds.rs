//! Bounding boxes and circles: whole shapes are rejected, accepted or clipped before work is done. Lecture 3.4.1.
//!
//! ```text
//!   ┌─────────────────┐      Inside    draw it, nothing needs to be clipped
//!   │  ┌───┐       ┌──┼─┐    Crossing  clip it
//!   │  └───┘       └──┼─┘    Outside   no work at all
//!   └─────────────────┘ ┌───┐
//!                       └───┘
//! ```
//!
//! Made once from the points of a shape, then asked as often as there are windows. All answers are exact for all
//! coordinates, in integers: a circle's test squares distances and takes no root. Boxes, circles and windows are
//! closed: to touch is not to be outside.

use crate::num::{saturate_i32, saturate_u32};

use super::window::{Borders, ClipWindow, PlanePoint};

/// Where a bounded shape lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Verdict {
    /// No point of the bounds is in the window: reject the shape.
    Outside,
    /// All of the bounds are in the window: accept the shape unclipped.
    Inside,
    /// Neither; the shape has to be clipped, and may yet be outside or inside itself.
    Crossing,
}

/// An axis-aligned bounding box, in the unit of its points. `min` and `max` belong to it.
///
/// ```
/// use aquatint::{Point2, Rect, clip::bounds::{BoundingBox, Verdict}};
///
/// let star = [(64, 2), (82, 60), (33, 24), (95, 24), (46, 60)].map(|(x, y)| Point2::corner(x, y));
/// let bounds = BoundingBox::of(star).unwrap();
/// assert_eq!(bounds.against(Rect::new(0, 0, 128, 64)), Verdict::Inside);
/// assert_eq!(bounds.against(Rect::new(0, 0, 64, 64)), Verdict::Crossing);
/// assert_eq!(bounds.against(Rect::new(0, 0, 32, 64)), Verdict::Outside);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BoundingBox<P> {
    min: P,
    max: P,
}

impl<P: PlanePoint> BoundingBox<P> {
    /// The least box that holds all points; `None` without points.
    pub fn of(points: impl IntoIterator<Item = P>) -> Option<Self> {
        let mut points = points.into_iter().map(P::coordinates);
        let first = points.next()?;
        let (min, max) = points
            .fold((first, first), |(min, max), (x, y)| ((min.0.min(x), min.1.min(y)), (max.0.max(x), max.1.max(y))));
        Some(Self { min: P::at(min), max: P::at(max) })
    }

    /// Least x and y.
    pub const fn min(&self) -> P {
        self.min
    }

    /// Greatest x and y.
    pub const fn max(&self) -> P {
        self.max
    }

    /// Where the box lies: against a window, a rectangle of pixels, or another box.
    #[must_use]
    pub fn against(&self, window: impl Into<ClipWindow<P>>) -> Verdict {
        let (own, window) = (ClipWindow::from(*self).borders(), window.into().borders());
        let is_apart = own.max.0 < window.min.0
            || own.min.0 > window.max.0
            || own.max.1 < window.min.1
            || own.min.1 > window.max.1;
        if is_apart || window.is_empty() {
            Verdict::Outside
        } else if window.outcode(own.min, own.max).is_inside() {
            Verdict::Inside
        } else {
            Verdict::Crossing
        }
    }
}

impl<P: PlanePoint> From<BoundingBox<P>> for ClipWindow<P> {
    fn from(bounds: BoundingBox<P>) -> Self {
        Self::new(bounds.min, bounds.max)
    }
}

/// A bounding circle, its inside included, in the unit of its points. It turns with its shape.
///
/// ```
/// use aquatint::{Point2, Rect, clip::bounds::{BoundingCircle, Verdict}};
///
/// let ball = BoundingCircle::new(Point2::corner(70, 70), 8 * 16);
/// let screen = Rect::new(0, 0, 64, 64);
/// // Its box reaches into the corner of the screen, the circle does not.
/// assert_eq!(ball.against(screen), Verdict::Outside);
/// assert_eq!(ball.against_circle(&BoundingCircle::new(Point2::corner(60, 70), 2 * 16)), Verdict::Crossing);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BoundingCircle<P> {
    center: P,
    radius: u32,
}

impl<P: PlanePoint> BoundingCircle<P> {
    /// A circle from its centre and radius.
    #[must_use]
    pub const fn new(center: P, radius: u32) -> Self {
        Self { center, radius }
    }

    /// A circle around the middle of the points' box that holds all of them; `None` without points.
    ///
    /// Its radius is at most √2 times, and a unit more, than that of the least circle. One square root.
    pub fn of(points: impl IntoIterator<Item = P, IntoIter: Clone>) -> Option<Self> {
        let points = points.into_iter();
        let bounds = ClipWindow::from(BoundingBox::of(points.clone())?).borders();
        let middle = |min: i32, max: i32| saturate_i32((i64::from(min) + i64::from(max)) >> 1);
        let center = (middle(bounds.min.0, bounds.max.0), middle(bounds.min.1, bounds.max.1));
        // From the middle no coordinate is farther than 2³¹, so the sum is below 2⁶⁴.
        let square = |(x, y): (i32, i32)| {
            u64::from(x.abs_diff(center.0)).pow(2).saturating_add(u64::from(y.abs_diff(center.1)).pow(2))
        };
        let farthest = points.map(|point| square(point.coordinates())).max()?;
        let root = farthest.isqrt();
        let radius = saturate_u32(root + u64::from(root * root < farthest));
        Some(Self { center: P::at(center), radius })
    }

    /// The centre.
    pub const fn center(&self) -> P {
        self.center
    }

    /// The radius.
    #[must_use]
    pub const fn radius(&self) -> u32 {
        self.radius
    }

    /// Where the circle lies: against a window, a rectangle of pixels, or a box.
    #[must_use]
    pub fn against(&self, window: impl Into<ClipWindow<P>>) -> Verdict {
        let Borders { min, max } = window.into().borders();
        let center = self.center.coordinates();
        let x = Offset::of(center.0, (min.0, max.0));
        let y = Offset::of(center.1, (min.1, max.1));
        if min.0 > max.0 || min.1 > max.1 || !is_within(x.outside, y.outside, u64::from(self.radius)) {
            Verdict::Outside
        } else if x.inside.min(y.inside) >= i64::from(self.radius) {
            Verdict::Inside
        } else {
            Verdict::Crossing
        }
    }

    /// Where the circle lies against another one: [`Verdict::Outside`] when they have no point in common.
    #[must_use]
    pub fn against_circle(&self, other: &Self) -> Verdict {
        let (own, center) = (self.center.coordinates(), other.center.coordinates());
        let (x, y) = (own.0.abs_diff(center.0), own.1.abs_diff(center.1));
        let (radius, wanted) = (u64::from(self.radius), u64::from(other.radius));
        if !is_within(x, y, radius + wanted) {
            Verdict::Outside
        } else if wanted >= radius && is_within(x, y, wanted - radius) {
            Verdict::Inside
        } else {
            Verdict::Crossing
        }
    }
}

/// A coordinate against a closed range.
struct Offset {
    /// How far it lies beside the range, 0 when inside.
    outside: u32,
    /// How far it lies from the nearer border, negative when outside.
    inside: i64,
}

impl Offset {
    fn of(at: i32, (min, max): (i32, i32)) -> Self {
        let [from_min, to_max] = [i64::from(at) - i64::from(min), i64::from(max) - i64::from(at)];
        let inside = from_min.min(to_max);
        Self { outside: saturate_u32(inside.min(0).unsigned_abs()), inside }
    }
}

/// Whether `x² + y² ≤ radius²`, for a radius below 2³³: `y² ≤ (radius − x)·(radius + x)`, which fits if it is not
/// larger anyway.
fn is_within(x: u32, y: u32, radius: u64) -> bool {
    let Some(rest) = radius.checked_sub(u64::from(x)) else { return false };
    rest.checked_mul(radius + u64::from(x)).is_none_or(|rest| u64::from(y).pow(2) <= rest)
}
