//! Lines, polygons and bounds against windows: exact, within the bounds of their memory, harmless.
#![no_main]

#[path = "../../tests/clip/oracle.rs"]
mod oracle;

use aquatint::{
    Point2,
    clip::{
        bounds::{BoundingBox, BoundingCircle, Verdict},
        cohen_sutherland,
        convex::ConvexWindow,
        liang_barsky,
        separate::{Node, separate},
        sutherland_hodgman::{Pipeline, clip_to_rectangle},
        window::{Boundary, ClipWindow, HalfPlane},
    },
};
use arbitrary::Arbitrary;
use heapless::Vec as List;
use libfuzzer_sys::fuzz_target;

/// Windows have up to eight boundaries, polygons up to twelve vertices.
const BOUNDARIES: usize = 8;
const VERTICES: usize = 12;

#[derive(Arbitrary, Debug)]
struct Input {
    line: (oracle::Place, oracle::Place),
    window: (oracle::Place, oracle::Place),
    subject: Vec<oracle::Place>,
    convex: Vec<(i16, i16)>,
    /// Subjects near the window instead of anywhere.
    is_near: bool,
    sample: (i16, i16),
}

fn point((x, y): oracle::Place) -> Point2 {
    Point2::from_sixteenths(x, y)
}

fuzz_target!(|input: Input| {
    let bounds = ClipWindow::new(point(input.window.0), point(input.window.1));
    check_line(input.line, input.window, bounds);

    let near = |(x, y): oracle::Place| if input.is_near { (x % 32_768, y % 32_768) } else { (x, y) };
    let subject: Vec<_> = input.subject.iter().take(VERTICES).map(|&place| point(near(place))).collect();
    check_rectangle(&subject, bounds);
    check_bounds(&subject, bounds);

    let corners: Vec<_> = input.convex.iter().take(BOUNDARIES).map(|&(x, y)| point((x.into(), y.into()))).collect();
    if let Ok(window) = ConvexWindow::new(&corners) {
        let half_planes: Vec<_> = window.half_planes().collect();
        let place = (i32::from(input.sample.0), i32::from(input.sample.1));
        check_convex(&subject, &half_planes, place);
    }
});

fn check_line(line: (oracle::Place, oracle::Place), window: oracle::Window, bounds: ClipWindow<Point2>) {
    let expected = oracle::line_part(line, window).map(|((near, far), _)| (point(near), point(far)));
    let ends = (point(line.0), point(line.1));
    assert_eq!(cohen_sutherland::clip(ends, bounds), expected);
    assert_eq!(liang_barsky::clip(ends, bounds), expected);
}

fn check_rectangle(subject: &[Point2], bounds: ClipWindow<Point2>) {
    let mut clipped = List::<Point2, { VERTICES + 4 * (VERTICES / 2) }>::new();
    clip_to_rectangle(subject, bounds, &mut clipped).expect("the bound");
    assert!(clipped.len() <= subject.len() + 4 * (subject.len() / 2));
    assert!(clipped.iter().all(|&vertex| bounds.outcode(vertex).is_inside()));
}

fn check_bounds(subject: &[Point2], bounds: ClipWindow<Point2>) {
    let mut clipped = List::<Point2, { VERTICES + 4 * (VERTICES / 2) }>::new();
    clip_to_rectangle(subject, bounds, &mut clipped).expect("the bound");
    let a_box = BoundingBox::of(subject.iter().copied()).map(|shape| shape.against(bounds));
    let circle = BoundingCircle::of(subject.iter().copied()).map(|shape| shape.against(bounds));
    for verdict in [a_box, circle].into_iter().flatten() {
        match verdict {
            Verdict::Outside => assert!(clipped.is_empty()),
            Verdict::Inside => assert_eq!(&clipped[..], subject),
            Verdict::Crossing => {}
        }
    }
}

fn check_convex(subject: &[Point2], half_planes: &[HalfPlane], place: oracle::Place) {
    let (mut stages, mut clipped) = (List::<_, BOUNDARIES>::new(), vec![]);
    let mut pipeline = Pipeline::build(half_planes.iter().copied(), &mut stages).expect("as many");
    let Ok(()) = pipeline.clip(subject, |vertex| {
        clipped.push(vertex);
        Ok::<(), core::convert::Infallible>(())
    });
    // Rounding may in theory break the bound; then this is to be known.
    assert!(clipped.len() <= subject.len() + half_planes.len() * (subject.len() / 2));

    let mut memory = List::<Node, { VERTICES + 2 * BOUNDARIES * (VERTICES / 2) }>::new();
    let mut pieces = separate(&[subject], half_planes.iter().copied(), &mut memory).expect("the bound");
    let (mut corners, mut winding) = (List::<Point2, 256>::new(), 0);
    while pieces.next_into(&mut corners).expect("as long as the memory") {
        winding += oracle::winding(&corners, place);
    }

    let reach = i32::try_from(half_planes.len().div_ceil(2)).expect("few");
    let is_inside = half_planes.iter().all(|side| {
        // Well inside: what is cut was rounded.
        let near = |x, y| point((place.0 + x * reach, place.1 + y * reach));
        [near(-1, -1), near(1, -1), near(-1, 1), near(1, 1)].iter().all(|corner| Boundary::distance(side, corner) > 0)
    });
    if is_inside && !oracle::edges(subject).any(|edge| oracle::is_near(place, edge, reach)) {
        let expected = oracle::winding(subject, place);
        assert_eq!((oracle::winding(&clipped, place), winding), (expected, expected));
    }
}
