//! The ends of the range: nothing panics, and what cannot be computed sixteen times as large is as ever.

use aquatint::{
    Affine, Angle, Cap, Chord, Dashed, Join, Outline, Oval, Path, Pen, Placed, Point2, Polygon, Polyline, Rect,
    RoundedRectangle, Scalar, Sector, Segment, Stroke, Stroked, Subpixel,
};
use proptest::{array::uniform4, collection::vec, prelude::*, sample::select};

use super::{Recorder, coarse, enlarged, fine, hostile, hostile_point, in_range};

/// Behind this curves are traced as ever, in sixteenths.
const FAR: i32 = 1 << 22;

fn is_near(point: Point2) -> bool {
    [point.x, point.y].iter().all(|v| v.to_bits().unsigned_abs() < FAR.unsigned_abs())
}

fn is_in_range(traced: &Recorder) -> bool {
    traced.contours.iter().flatten().all(|(x, y)| x.unsigned_abs().max(y.unsigned_abs()) <= 1 << 30)
}

fn segment() -> impl Strategy<Value = Segment> {
    let point = || hostile_point().prop_map(in_range);
    prop_oneof![
        2 => point().prop_map(Segment::MoveTo),
        2 => point().prop_map(Segment::LineTo),
        2 => (point(), point()).prop_map(|(a, b)| Segment::QuadTo(a, b)),
        2 => (point(), point(), point()).prop_map(|(a, b, c)| Segment::CubicTo(a, b, c)),
        1 => Just(Segment::Close),
    ]
}

fn points_of(segment: &Segment) -> Vec<Point2> {
    match *segment {
        Segment::MoveTo(a) | Segment::LineTo(a) => vec![a],
        Segment::QuadTo(a, b) => vec![a, b],
        Segment::CubicTo(a, b, c) => vec![a, b, c],
        Segment::Arc(_) | Segment::Close => vec![],
    }
}

fn stroke() -> impl Strategy<Value = Stroke> {
    let joins = vec![Join::Miter { limit: 4 }, Join::Miter { limit: 255 }, Join::Round, Join::Bevel];
    let width = prop_oneof![0..400_i32, select(vec![4095, 4096, 65_535, i32::MAX, i32::MIN, -1]), any::<i32>()];
    (width, select(joins), select(vec![Cap::Butt, Cap::Round, Cap::Square]))
        .prop_map(|(width, join, cap)| Stroke::of_width(Subpixel::from_bits(width)).with_join(join).with_cap(cap))
}

/// Straight edges between any points: the one outline whose trace is not checked.
struct Anything(Vec<Point2>);

impl Outline for Anything {
    fn trace<P: Pen>(&self, pen: &mut P) {
        pen.move_to(Point2::default());
        self.0.iter().for_each(|&point| pen.line_to(point));
        pen.close();
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn paths_are_as_ever_where_they_reach_too_far(segments in vec(segment(), 0..6)) {
        let path = Path::new(&segments).expect("in range");
        let traced = fine(&path);
        prop_assert!(is_in_range(&traced));
        if !segments.iter().flat_map(points_of).all(is_near) {
            prop_assert_eq!(traced, enlarged(&path));
        }
    }

    #[test]
    fn round_shapes_are_as_ever_where_they_reach_too_far(
        center in hostile_point(), radii in (hostile(), hostile()), start: u16, sweep: i32,
    ) {
        if let Ok(oval) = Oval::new(center, [radii.0, radii.1].map(Subpixel::from_bits)) {
            let arc = oval.arc(Angle(start), sweep);
            let segments = [Segment::Arc(arc)];
            let path = Path::new(&segments).expect("in range");
            let traced = [fine(&oval), fine(&arc), fine(&Chord(arc)), fine(&Sector(arc)), fine(&path)];
            prop_assert!(traced.iter().all(is_in_range));
            let reach = |center: Subpixel, radius: i32| center.to_bits().unsigned_abs() + radius.unsigned_abs();
            if reach(center.x, radii.0).max(reach(center.y, radii.1)) >= FAR.unsigned_abs() {
                let as_ever = [enlarged(&oval), enlarged(&arc), enlarged(&Chord(arc)), enlarged(&Sector(arc)), enlarged(&path)];
                prop_assert_eq!(traced, as_ever);
            }
        }
        if let Ok(shape) = RoundedRectangle::new([center, Point2::default()], Subpixel::from_bits(radii.0)) {
            let traced = fine(&shape);
            prop_assert!(is_in_range(&traced));
            prop_assert!(is_near(center) || traced == enlarged(&shape));
        }
    }

    #[test]
    fn strokes_are_as_ever_where_they_reach_too_far(points in vec(hostile_point(), 1..5), stroke in stroke(), offset in hostile()) {
        let anything = Anything(points.clone());
        let clamped: Vec<_> = points.iter().copied().map(in_range).collect();
        let line = Polyline::new(&clamped).expect("in range");
        let lengths = [Subpixel::from_bits(offset), Subpixel::from_bits(1 << 20)];
        let dashed = Dashed::new(&anything, &lengths, Subpixel::from_bits(offset.wrapping_mul(3)));
        let seen = Dashed::new(&line, &lengths, Subpixel::ZERO).within(Rect::new(-9, i32::MIN, i32::MAX, 9));
        let traced = [fine(&Stroked::new(&line, stroke)), fine(&Stroked::new(&anything, stroke)), fine(&dashed), fine(&seen)];
        prop_assert!(traced.iter().all(is_in_range));
        prop_assert!(is_in_range(&fine(&Stroked::new(&dashed, stroke))));
        if !points.iter().all(|&point| is_near(point)) || stroke.width.to_bits() > 4095 {
            prop_assert_eq!(&traced[0], &enlarged(&Stroked::new(&line, stroke)));
            prop_assert_eq!(&traced[1], &enlarged(&Stroked::new(&anything, stroke)));
        }
        if !points.iter().all(|&point| is_near(point)) {
            prop_assert_eq!(&traced[2], &enlarged(&dashed));
            prop_assert_eq!(&traced[3], &enlarged(&seen));
        }
    }

    #[test]
    fn whatever_is_placed_anywhere_does_not_panic(
        elements in uniform4(hostile()), to in hostile_point(), points in vec(hostile_point(), 1..5), stroke in stroke(),
    ) {
        let [a, b, c, d] = elements.map(Scalar::from_bits);
        let map = Affine::new([a, b], [c, d], to);
        let placed = Placed::new(Anything(points), map);
        prop_assert_eq!(fine(&placed).contours[0].len(), coarse(&placed).contours[0].len());
        prop_assert!(is_in_range(&fine(&Stroked::new(&placed, stroke))));
        fine(&Placed::new(placed, map));
    }
}

#[test]
fn corners_need_nothing_and_moves_are_exact() {
    let end = (1 << 26) - 1;
    let corners = [(-end, 0), (end, 5), (7, end)].map(|(x, y)| Point2::from_sixteenths(x, y));
    let contours = [&corners[..]];
    let polygon = Polygon::new(&contours).expect("in range");
    assert_eq!(fine(&polygon), enlarged(&polygon));
    assert_eq!(fine(&&polygon), enlarged(&polygon));
    let near = [(-3, 0), (5, 5), (7, -9)].map(|(x, y)| Point2::from_sixteenths(x, y));
    let contours = [&near[..]];
    let moved = Placed::new(
        Polygon::new(&contours).expect("in range"),
        Affine::translation(Point2::from_sixteenths(11, 20 - end)),
    );
    assert_eq!(fine(&moved), enlarged(&moved));
}
