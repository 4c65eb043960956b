//! Bounding boxes and circles: every verdict is exact.

use aquatint::{
    Point2, Rect,
    clip::{
        bounds::{BoundingBox, BoundingCircle, Verdict},
        window::ClipWindow,
    },
};
use embedded_graphics::geometry::Point;
use proptest::prelude::*;

use super::places;

fn pixel((x, y): (i32, i32)) -> Point {
    Point::new(x, y)
}

fn radius() -> impl Strategy<Value = u32> {
    prop_oneof![4 => 0..30_u32, 4 => 0..3000_u32, 1 => any::<u32>(), 1 => Just(u32::MAX)]
}

fn square(v: i128) -> i128 {
    v * v
}

/// The squared distance between two places.
fn squared(a: (i32, i32), b: (i32, i32)) -> i128 {
    square(i128::from(a.0) - i128::from(b.0)) + square(i128::from(a.1) - i128::from(b.1))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn a_box_holds_its_points_and_touches_them(points in prop::collection::vec(places(), 0..6)) {
        let Some(bounds) = BoundingBox::of(points.iter().copied().map(pixel)) else {
            prop_assert!(points.is_empty());
            return Ok(());
        };
        let range = |axis: fn(&(i32, i32)) -> i32| (points.iter().map(axis).min().unwrap(), points.iter().map(axis).max().unwrap());
        let ((left, right), (top, bottom)) = (range(|p| p.0), range(|p| p.1));
        prop_assert_eq!((bounds.min(), bounds.max()), (Point::new(left, top), Point::new(right, bottom)));
    }

    #[test]
    fn a_box_against_a_window_is_exact(a in places(), b in places(), min in places(), max in places()) {
        let bounds = BoundingBox::of([pixel(a), pixel(b)]).unwrap();
        let axis = |a: i32, b: i32, min: i32, max: i32| {
            let common = a.min(b).max(min)..=a.max(b).min(max);
            (common.is_empty() || min > max, min <= a.min(b) && a.max(b) <= max)
        };
        let (x, y) = (axis(a.0, b.0, min.0, max.0), axis(a.1, b.1, min.1, max.1));
        let expected = match (x, y) {
            ((true, _), _) | (_, (true, _)) => Verdict::Outside,
            ((_, true), (_, true)) => Verdict::Inside,
            _ => Verdict::Crossing,
        };
        prop_assert_eq!(bounds.against(ClipWindow::new(pixel(min), pixel(max))), expected);
    }

    #[test]
    fn a_circle_against_a_window_is_exact(center in places(), radius in radius(), min in places(), max in places()) {
        let circle = BoundingCircle::new(pixel(center), radius);
        let nearest = (center.0.max(min.0).min(max.0), center.1.max(min.1).min(max.1));
        let reach = i128::from(radius);
        let [x, y] = [center.0, center.1].map(i128::from);
        let [left, top, right, bottom] = [min.0, min.1, max.0, max.1].map(i128::from);
        let expected = if left > right || top > bottom || squared(center, nearest) > square(reach) {
            Verdict::Outside
        } else if x - reach >= left && x + reach <= right && y - reach >= top && y + reach <= bottom {
            Verdict::Inside
        } else {
            Verdict::Crossing
        };
        prop_assert_eq!(circle.against(ClipWindow::new(pixel(min), pixel(max))), expected);
    }

    #[test]
    fn circles_against_each_other_are_exact(a in places(), b in places(), one in radius(), other in radius()) {
        let (r, s) = (i128::from(one), i128::from(other));
        let expected = if squared(a, b) > square(r + s) {
            Verdict::Outside
        } else if r <= s && squared(a, b) <= square(s - r) {
            Verdict::Inside
        } else {
            Verdict::Crossing
        };
        prop_assert_eq!(BoundingCircle::new(pixel(a), one).against_circle(&BoundingCircle::new(pixel(b), other)), expected);
    }

    #[test]
    fn a_circle_holds_its_points_and_is_no_larger_than_needed(points in prop::collection::vec(places(), 1..6)) {
        let circle = BoundingCircle::of(points.iter().copied().map(pixel)).unwrap();
        let center = (circle.center().x, circle.center().y);
        let farthest = points.iter().map(|&point| squared(center, point)).max().unwrap();
        let radius = i128::from(circle.radius());
        prop_assert!(farthest <= square(radius));
        prop_assert!(radius == 0 || farthest > square(radius - 1), "not a unit too large");
        // Twice the radius of any circle that holds them is at least the distance of two of them.
        let apart = points.iter().flat_map(|&a| points.iter().map(move |&b| squared(a, b))).max().unwrap();
        prop_assert!(square(2 * (radius - 2).max(0)) <= 2 * apart, "at most √2 times the least, and a unit for rounding");
    }
}

#[test]
fn touching_is_not_outside() {
    let circle = BoundingCircle::new(Point2::from_sixteenths(-3, -4), 5);
    let corner = ClipWindow::new(Point2::default(), Point2::corner(9, 9));
    assert_eq!(circle.against(corner), Verdict::Crossing, "3² + 4² = 5²");
    assert_eq!(BoundingCircle::new(Point2::from_sixteenths(-3, -5), 5).against(corner), Verdict::Outside);
    let touching = BoundingCircle::new(Point2::from_sixteenths(3, 4), 5);
    assert_eq!(circle.against_circle(&touching), Verdict::Crossing);
    assert_eq!(circle.against_circle(&circle), Verdict::Inside);
    assert_eq!(BoundingCircle::new(Point2::from_sixteenths(5, 5), 5).against(Rect::new(0, 0, 1, 1)), Verdict::Inside);
    assert_eq!(BoundingCircle::<Point>::of([]), None);
}
