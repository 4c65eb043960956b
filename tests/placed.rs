//! Outlines that are moved, turned and scaled; and the words that embedded-graphics has for shapes.

mod exact;

use aquatint::{
    Affine, Angle, FillStyle, Line, Outline, Oval, Pen, Placed, Point2, Polygon, Rect, Rule, Scalar, SpanFn, Subpixel,
    raster::scan::{ActiveEdge, contains, fill, peak_edges},
};
use embedded_graphics::{
    geometry::{Dimensions, Point},
    pixelcolor::BinaryColor,
    primitives::{ContainsPoint, StyledDimensions},
    transform::Transform,
};
use exact::{Overdraw, is_inside};
use heapless::Vec as List;
use proptest::{array::uniform4, collection::vec, prelude::*, sample::select};

const WINDOW: Rect = Rect::new(-3, -2, 29, 24);

fn element() -> impl Strategy<Value = Scalar> {
    prop_oneof![4 => -150_000..150_000_i32, 1 => select(vec![i32::MIN, i32::MAX, 0, 1]), 1 => any::<i32>()]
        .prop_map(Scalar::from_bits)
}

fn sixteenths() -> impl Strategy<Value = i32> {
    prop_oneof![6 => -200..500_i32, 1 => any::<i32>(), 1 => select(vec![i32::MIN, i32::MAX, 0, 8])]
}

fn point() -> impl Strategy<Value = Point2> {
    (sixteenths(), sixteenths()).prop_map(|(x, y)| Point2::from_sixteenths(x, y))
}

fn affine() -> impl Strategy<Value = Affine> {
    (uniform4(element()), point()).prop_map(|([a, b, c, d], origin)| Affine::new([a, b], [c, d], origin))
}

/// The nearest whole number to `a·x + b·y + origin`, ties up.
fn exact_coordinate(map: [i32; 2], point: Point2, origin: i32) -> i32 {
    let [a, b, x, y, origin] = [map[0], map[1], point.x.to_bits(), point.y.to_bits(), origin].map(i128::from);
    let nearest = (a * x + b * y + (1 << 15)).div_euclid(1 << 16) + origin;
    i32::try_from(nearest.clamp(i32::MIN.into(), i32::MAX.into())).expect("clamped")
}

fn pixels<O: Outline>(outline: &O, rule: Rule) -> Overdraw {
    let (mut edges, mut pixels) = (List::<ActiveEdge, 8>::new(), Overdraw::new(WINDOW));
    let Ok(()) = fill(outline, rule, &mut edges, &mut SpanFn::new(WINDOW, |row, columns, ()| pixels.add(row, columns)));
    pixels
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn points_go_where_they_should(elements in uniform4(element()), origin in point(), at in point()) {
        let [a, b, c, d] = elements;
        let got = Affine::new([a, b], [c, d], origin).apply(at);
        let [a, b, c, d] = elements.map(Scalar::to_bits);
        prop_assert_eq!(got.x.to_bits(), exact_coordinate([a, b], at, origin.x.to_bits()));
        prop_assert_eq!(got.y.to_bits(), exact_coordinate([c, d], at, origin.y.to_bits()));
    }

    #[test]
    fn one_map_after_the_other_is_one_map(
        first in uniform4(-100_000..100_000_i32), second in uniform4(-100_000..100_000_i32),
        by in (-999..999_i32, -999..999_i32), at in (-999..999_i32, -999..999_i32),
    ) {
        let map = |[a, b, c, d]: [i32; 4]| {
            let [a, b, c, d] = [a, b, c, d].map(Scalar::from_bits);
            Affine::new([a, b], [c, d], Point2::from_sixteenths(by.0, by.1))
        };
        let at = Point2::from_sixteenths(at.0, at.1);
        let (step_by_step, at_once) = (map(second).apply(map(first).apply(at)), map(first).then(map(second)).apply(at));
        // Rounded twice to a sixteenth here, once to 2⁻¹⁶ of an element there.
        let near = |a: Subpixel, b: Subpixel| a.to_bits().abs_diff(b.to_bits()) <= 3;
        prop_assert!(near(step_by_step.x, at_once.x) && near(step_by_step.y, at_once.y));
    }

    #[test]
    fn hostile_maps_neither_panic_nor_leave_the_window(maps in vec(affine(), 1..4), corners in vec(point(), 0..6)) {
        let clamped: Vec<_> = corners.iter().map(|p| {
            let end = (1 << 26) - 1;
            Point2::from_sixteenths(p.x.to_bits().clamp(-end, end), p.y.to_bits().clamp(-end, end))
        }).collect();
        let contours = [&clamped[..]];
        let map = maps.into_iter().fold(Affine::IDENTITY, Affine::then);
        let placed = Placed::new(Polygon::new(&contours).expect("in range"), map);
        let drawn = pixels(&placed, Rule::NonZero);
        // Where the edges stay in range, the mapped corners are what is filled.
        let mapped: Vec<_> = clamped.iter().map(|&corner| map.apply(corner)).collect();
        let in_range = |p: &Point2| p.x.to_bits().unsigned_abs() < 1 << 26 && p.y.to_bits().unsigned_abs() < 1 << 26;
        if mapped.iter().all(in_range) {
            let mapped = [mapped];
            for (x, y) in drawn.places() {
                prop_assert_eq!(drawn.count(x, y), u32::from(is_inside(&mapped, Rule::NonZero, (x, y))));
            }
        }
    }

    #[test]
    fn a_pixel_is_contained_when_it_is_filled(corners in vec((-60..500_i32, -60..450_i32), 0..9), by in (-9..9_i32, -9..9_i32)) {
        let corners: Vec<_> = corners.iter().map(|&(x, y)| Point2::from_sixteenths(x, y)).collect();
        let contours = [&corners[..]];
        let polygon = Polygon::new(&contours).expect("in range");
        for rule in [Rule::NonZero, Rule::EvenOdd] {
            let drawn = pixels(&polygon, rule);
            let bounds = Rect::from(polygon.styled_bounding_box(&FillStyle::new(BinaryColor::On).with_rule(rule)));
            for (x, y) in drawn.places() {
                let is_drawn = drawn.count(x, y) == 1;
                prop_assert_eq!(contains(&polygon, rule, Point::new(x, y)), is_drawn);
                prop_assert!(!is_drawn || bounds.contains(Point::new(x, y)));
            }
        }
        // And moved by whole pixels it is the same elsewhere.
        let (here, there) = (Placed::new(polygon, Affine::IDENTITY), Placed::new(polygon, Affine::IDENTITY).translate(Point::new(by.0, by.1)));
        for (x, y) in pixels(&polygon, Rule::NonZero).places() {
            prop_assert_eq!(here.contains(Point::new(x, y)), there.contains(Point::new(x + by.0, y + by.1)));
        }
        let mut moved = here;
        moved.translate_mut(Point::new(by.0, by.1));
        prop_assert_eq!(moved, there);
    }

    #[test]
    fn the_peak_of_edges_is_what_a_list_must_hold(corners in vec((-60..500_i32, -60..450_i32), 0..12)) {
        let corners: Vec<_> = corners.iter().map(|&(x, y)| Point2::from_sixteenths(x, y)).collect();
        let contours = [&corners[..]];
        let polygon = Polygon::new(&contours).expect("in range");
        // Edges that own the centre of a row, row by row.
        let edges = corners.iter().zip(corners.iter().cycle().skip(1));
        let crosses = |row: i32| {
            let centre = row * 16 + 8;
            let owns = |(a, b): (&Point2, &Point2)| {
                let (a, b) = (a.y.to_bits(), b.y.to_bits());
                a.min(b) <= centre && centre < a.max(b)
            };
            edges.clone().filter(|&edge| owns(edge)).count()
        };
        prop_assert_eq!(peak_edges(&polygon), (-5..30).map(crosses).max().expect("rows"));
    }
}

/// Counts how often it is traced.
struct Traced<'c, O>(&'c std::cell::Cell<u32>, O);

impl<O: Outline> Outline for Traced<'_, O> {
    fn trace<P: Pen>(&self, pen: &mut P) {
        self.0.set(self.0.get() + 1);
        self.1.trace(pen);
    }
}

#[test]
fn the_work_is_bounded_by_what_is_seen() {
    // A triangle about the window, up to 50,000 times as large: as many spans, and traced as often.
    for times in [1, 16, 256, 50_000] {
        let corners = [(-40, -30), (70, -20), (10, 60)].map(|(x, y)| Point2::corner(x * times, y * times));
        let (contours, traces, mut spans) = ([&corners[..]], std::cell::Cell::new(0), 0);
        let outline = Traced(&traces, Polygon::new(&contours).expect("in range"));
        let mut edges = List::<ActiveEdge, 4>::new();
        let Ok(()) = fill(&outline, Rule::NonZero, &mut edges, &mut SpanFn::new(WINDOW, |_, _, ()| spans += 1));
        assert_eq!((spans, traces.get()), (26, 1), "{times} times as large");
    }
}

#[test]
fn a_list_that_holds_all_edges_is_filled_by_one_trace() {
    let oval = Oval::new(Point2::corner(13, 11), [Subpixel::from_num(12), Subpixel::from_num(10)]).expect("in range");
    let count = |capacity: usize| {
        let traces = std::cell::Cell::new(0);
        let outline = Traced(&traces, oval);
        let sink = &mut SpanFn::new(WINDOW, |_, _, ()| {});
        let Ok(()) = match capacity {
            128 => fill(&outline, Rule::NonZero, &mut List::<ActiveEdge, 128>::new(), sink),
            16 => fill(&outline, Rule::NonZero, &mut List::<ActiveEdge, 16>::new(), sink),
            _ => fill(&outline, Rule::NonZero, &mut List::<ActiveEdge, 2>::new(), sink),
        };
        traces.get()
    };
    let (all, some, few) = (count(128), count(16), count(2));
    assert!(all == 1 && some > 1 && some < 12 && few < 100, "{all}, {some}, {few}");
}

#[test]
fn a_square_turned_by_an_eighth() {
    let corners = [(0, 0), (10, 0), (10, 10), (0, 10)].map(|(x, y)| Point2::corner(x, y));
    let contours = [&corners[..]];
    let turned =
        Affine::turn(Angle(1 << 13)).about(Point2::corner(5, 5)).then(Affine::translation(Point2::corner(3, 3)));
    let mut drawn = Overdraw::new(Rect::new(0, 0, 16, 16));
    let window = drawn.window();
    let Ok(()) = fill(
        &Placed::new(Polygon::new(&contours).expect("in range"), turned),
        Rule::NonZero,
        &mut List::<ActiveEdge, 4>::new(),
        &mut SpanFn::new(window, |row, columns, ()| drawn.add(row, columns)),
    );
    assert_eq!(drawn.picture(), include_str!("pictures/turned_square.txt"), "\n{}", drawn.picture());
}

#[test]
fn a_line_moves() {
    let line = Line::new(Point::new(1, 2), Point::new(i32::MAX, 4));
    let moved = line.translate(Point::new(5, -7));
    assert_eq!(moved, Line::new(Point::new(6, -5), Point::new(i32::MAX, -3)));
    assert_eq!(moved.bounding_box().top_left, Point::new(6, -5));
}
