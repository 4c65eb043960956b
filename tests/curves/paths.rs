//! Paths: what reaches the pen, and what is filled.

use aquatint::{
    Angle, Arc, Flatten, OutOfRange, Oval, Path, Pen, Point2, Rect, Rule, Segment, SpanFn, Subpixel,
    raster::scan::{ActiveEdge, fill},
};
use heapless::Vec as List;
use proptest::{prelude::*, sample::select};

use crate::{
    exact::{Overdraw, is_inside},
    recorder::Recorder,
};

const fn at(x: i32, y: i32) -> Point2 {
    Point2::from_sixteenths(x, y)
}

/// What reaches the pen.
fn traced(segments: &[Segment]) -> String {
    Recorder::of(&Path::new(segments).expect("in range")).svg()
}

fn quarter() -> Arc {
    Oval::circle(at(0, 0), Subpixel::from_bits(2)).expect("in range").arc(Angle(0), 16_384)
}

#[test]
fn contours_begin_and_end_as_documented() {
    use Segment::{Close, LineTo, MoveTo};
    let cases: [(&[Segment], &str); 12] = [
        (&[], ""),
        (&[Close, MoveTo(at(1, 2)), MoveTo(at(3, 4)), Close], ""),
        (&[LineTo(at(3, 4))], "M0,0 L3,4"),
        (&[MoveTo(at(1, 2)), MoveTo(at(3, 4)), LineTo(at(5, 6)), MoveTo(at(7, 8))], "M3,4 L5,6"),
        (&[MoveTo(at(1, 2)), LineTo(at(3, 4)), Close, Close], "M1,2 L3,4 Z"),
        (&[MoveTo(at(1, 2)), LineTo(at(3, 4)), Close, LineTo(at(5, 6))], "M1,2 L3,4 Z M1,2 L5,6"),
        (&[LineTo(at(3, 4)), Close, LineTo(at(5, 6))], "M0,0 L3,4 Z M0,0 L5,6"),
        (&[MoveTo(at(1, 2)), LineTo(at(1, 2))], "M1,2 L1,2"),
        (&[Segment::Arc(quarter())], "M2,0 L1,1 L0,2"),
        (&[MoveTo(at(9, 9)), Segment::Arc(quarter()), Close], "M9,9 L2,0 L1,1 L0,2 Z"),
        (&[Segment::Arc(quarter()), Close, Segment::Arc(quarter())], "M2,0 L1,1 L0,2 Z M2,0 L1,1 L0,2"),
        (&[LineTo(at(2, 0)), Segment::Arc(quarter())], "M0,0 L2,0 L1,1 L0,2"),
    ];
    for (segments, expected) in cases {
        assert_eq!(traced(segments), expected, "{segments:?}");
    }
}

#[test]
fn curves_begin_where_the_contour_has_come_to() {
    let [a, b, c, d] = [at(100, 20), at(300, 700), at(900, 40), at(10, 20)];
    let segments = [Segment::MoveTo(a), Segment::CubicTo(b, c, d), Segment::QuadTo(a, b), Segment::Close];
    let mut by_hand = Recorder::default();
    by_hand.move_to(a);
    aquatint::curve::cubic(&mut by_hand, [a, b, c, d]);
    aquatint::curve::quadratic(&mut by_hand, [d, a, b]);
    by_hand.close();
    assert_eq!(traced(&segments), by_hand.svg());
    // The adaptor without a list of segments.
    let mut direct = Recorder::default();
    let mut pen = Flatten::new(&mut direct);
    pen.move_to(a);
    pen.cubic_to(b, c, d);
    pen.quad_to(a, b);
    pen.close();
    assert_eq!(direct, by_hand);
}

#[test]
fn points_out_of_range_are_refused() {
    let good = at((1 << 26) - 1, 1 - (1 << 26));
    assert!(Path::new(&[Segment::CubicTo(good, good, good), Segment::Close]).is_ok());
    for bad in [at(1 << 26, 0), at(0, -(1 << 26)), at(i32::MIN, 0), at(0, i32::MAX)] {
        for segment in [
            Segment::MoveTo(bad),
            Segment::LineTo(bad),
            Segment::QuadTo(bad, good),
            Segment::QuadTo(good, bad),
            Segment::CubicTo(bad, good, good),
            Segment::CubicTo(good, bad, good),
            Segment::CubicTo(good, good, bad),
        ] {
            assert_eq!(Path::new(&[Segment::Close, segment]), Err(OutOfRange), "{segment:?}");
        }
    }
}

const WINDOW: Rect = Rect::new(-2, -2, 12, 9);

fn point() -> impl Strategy<Value = Point2> {
    let coordinate = || {
        prop_oneof![
            60 => -60..220_i32,
            20 => (-3..13_i32).prop_map(|pixel| pixel * 16 + 8),
            10 => -2000..2000_i32,
            1 => select(vec![(1 << 26) - 1, 1 - (1 << 26)]),
        ]
    };
    (coordinate(), coordinate()).prop_map(|(x, y)| at(x, y))
}

fn segment() -> impl Strategy<Value = Segment> {
    let radius = || (0..200_i32).prop_map(Subpixel::from_bits);
    let arc = ((-60..220_i32, -60..220_i32), [radius(), radius()], any::<u16>(), -70_000..70_000_i32);
    prop_oneof![
        1 => point().prop_map(Segment::MoveTo),
        2 => point().prop_map(Segment::LineTo),
        2 => (point(), point()).prop_map(|(a, b)| Segment::QuadTo(a, b)),
        2 => (point(), point(), point()).prop_map(|(a, b, c)| Segment::CubicTo(a, b, c)),
        1 => arc.prop_map(|((x, y), radii, start, sweep)| {
            let oval = Oval::new(at(x, y), radii).expect("in range");
            Segment::Arc(oval.arc(Angle(start), sweep))
        }),
        1 => Just(Segment::Close),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn a_path_holds_the_pixels_whose_centres_are_inside_its_vertices(
        segments in prop::collection::vec(segment(), 0..7), is_even_odd in any::<bool>(),
    ) {
        let rule = if is_even_odd { Rule::EvenOdd } else { Rule::NonZero };
        let path = Path::new(&segments).expect("in range");
        let contours = Recorder::of(&path).contours;
        let (mut edges, mut pixels) = (List::<ActiveEdge, 16>::new(), Overdraw::new(WINDOW));
        let mut sink = SpanFn::new(WINDOW, |row, columns, ()| pixels.add(row, columns));
        let Ok(()) = fill(&path, rule, &mut edges, &mut sink);
        for place in pixels.places() {
            let expected = u32::from(is_inside(&contours, rule, place));
            prop_assert_eq!(pixels.count(place.0, place.1), expected, "{:?}", place);
        }
    }
}
