//! Both line clippers: exact, equal to each other, for every unit.

use aquatint::{
    Point2, Rect,
    clip::{cohen_sutherland, liang_barsky, window::ClipWindow},
};
use embedded_graphics::geometry::Point;
use proptest::prelude::*;

use super::{oracle, places};

type Segment = ((i32, i32), (i32, i32));

/// Both clippers on pixels and on sixteenths: four answers that must be one.
fn clipped((a, b): Segment, (min, max): Segment) -> [Option<Segment>; 4] {
    let pixel = |(x, y)| Point::new(x, y);
    let fixed = |(x, y)| Point2::from_sixteenths(x, y);
    let pixels = ((pixel(a), pixel(b)), ClipWindow::new(pixel(min), pixel(max)));
    let points = ((fixed(a), fixed(b)), ClipWindow::new(fixed(min), fixed(max)));
    let of_pixels = |(a, b): (Point, Point)| ((a.x, a.y), (b.x, b.y));
    let of_points = |(a, b)| (oracle::place(a), oracle::place(b));
    [
        cohen_sutherland::clip(pixels.0, pixels.1).map(of_pixels),
        liang_barsky::clip(pixels.0, pixels.1).map(of_pixels),
        cohen_sutherland::clip(points.0, points.1).map(of_points),
        liang_barsky::clip(points.0, points.1).map(of_points),
    ]
}

/// Windows of all kinds: mostly a rectangle, now and then empty.
fn windows() -> impl Strategy<Value = Segment> {
    prop_oneof![
        6 => (places(), places()).prop_map(|(a, b)| ((a.0.min(b.0), a.1.min(b.1)), (a.0.max(b.0), a.1.max(b.1)))),
        2 => (places(), 0..40_i32, 0..40_i32).prop_map(|((x, y), w, h)| ((x, y), (x.saturating_add(w), y.saturating_add(h)))),
        1 => (places(), places()),
    ]
}

/// Lines that pass a corner of the window by a hair: through a corner, give or take one, at any distance.
fn lines_past_a_corner() -> impl Strategy<Value = (Segment, Segment)> {
    let hair = || (-1..=1_i32, -1..=1_i32);
    (windows(), places(), hair(), 1..4_i64, any::<bool>()).prop_map(|(window, a, hair, far, is_first)| {
        let corner = if is_first { (window.0.0, window.1.1) } else { window.1 };
        let beyond = |a: i32, corner: i32, hair: i32| {
            let end = i64::from(corner) + (i64::from(corner) - i64::from(a)) * far + i64::from(hair);
            i32::try_from(end).unwrap_or(if end < 0 { i32::MIN } else { i32::MAX })
        };
        ((a, (beyond(a.0, corner.0, hair.0), beyond(a.1, corner.1, hair.1))), window)
    })
}

fn is_exact(line: Segment, window: Segment) -> Result<(), TestCaseError> {
    let expected = oracle::line_part(line, window).map(|(part, _)| part);
    prop_assert_eq!(clipped(line, window), [expected; 4]);
    let turned = expected.map(|(near, far)| (far, near));
    prop_assert_eq!(clipped((line.1, line.0), window), [turned; 4], "the same both ways");
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn both_clippers_are_exact(a in places(), b in places(), window in windows()) {
        is_exact((a, b), window)?;
    }

    #[test]
    fn lines_that_pass_a_corner_by_a_hair_are_judged_exactly((line, window) in lines_past_a_corner()) {
        is_exact(line, window)?;
    }
}

#[test]
fn a_line_from_end_to_end_of_the_range_that_grazes_a_corner() {
    // Cuts that are rounded before they are judged make the answer depend on the direction.
    let line = ((-1, i32::MAX), (i32::MAX, i32::MIN));
    is_exact(line, ((i32::MAX - 1, i32::MIN), (i32::MAX - 1, i32::MIN + 1))).unwrap();
}

#[test]
fn every_line_of_a_small_grid_is_exact() {
    let window = ((2, 1), (4, 2));
    let grid = || (0..=6).flat_map(|x| (0..=4).map(move |y| (x, y)));
    for (a, b) in grid().flat_map(|a| grid().map(move |b| (a, b))) {
        is_exact((a, b), window).unwrap();
    }
}

#[test]
fn the_cases_of_the_lecture() {
    let window = Rect::new(10, 10, 20, 20);
    let line = |a, b, c, d| {
        let line = (Point::new(a, b), Point::new(c, d));
        let part = cohen_sutherland::clip(line, window);
        assert_eq!(liang_barsky::clip(line, window), part);
        part
    };
    assert_eq!(line(12, 12, 18, 15), Some((Point::new(12, 12), Point::new(18, 15))), "inside");
    assert_eq!(line(0, 0, 30, 5), None, "both above");
    assert_eq!(line(0, 15, 15, 15), Some((Point::new(10, 15), Point::new(15, 15))), "one end in");
    assert_eq!(line(0, 12, 40, 16), Some((Point::new(10, 13), Point::new(19, 14))), "through");
    assert_eq!(line(0, 18, 12, 30), None, "both outside, passes the corner");
    assert_eq!(line(0, 0, 30, 30), Some((Point::new(10, 10), Point::new(19, 19))), "cut at two borders each");
    let empty = Rect::new(5, 5, 5, 5);
    assert_eq!(cohen_sutherland::clip((Point::zero(), Point::zero()), empty), None, "empty window");
    assert_eq!(liang_barsky::clip((Point::zero(), Point::zero()), empty), None, "empty window");
}

#[test]
fn a_rounded_cut_decides_nothing() {
    // At the top border the line is 10.4 to the right, beyond the last column; rounded it would be inside.
    let window = Rect::new(0, 0, 11, 11);
    let line = (Point::new(10, -1), Point::new(14, 9));
    assert_eq!(cohen_sutherland::clip(line, window), None);
    assert_eq!(liang_barsky::clip(line, window), None);
}
