//! Any outline, any bounds and any memory: no panic, spans inside of the bounds and in order.

use std::ops::Range;

use aquatint::{
    Arc, Chord, Coverage, Covered, Outline, Oval, Pen, Point2, Polygon, Polyline, Rect, Rule, Sink, SpanFn, Stroke,
    Stroked, Subpixel,
    raster::area::{AreaEdge, Oversampled, Scratch, fill},
};
use heapless::{Vec as List, vec::VecView};
use proptest::{collection::vec, prelude::*, sample::select};

use super::{drawn, polygons::covered, rule};

/// Any number, and the ends of all ranges.
fn hostile() -> impl Strategy<Value = i32> {
    let limits = [1 << 22, 1 << 26, 1 << 30];
    let ends = limits.into_iter().flat_map(|end| [end - 1, end, 1 - end, -end]).chain([i32::MIN, i32::MAX, 0]);
    prop_oneof![-300..300_i32, any::<i32>(), select(ends.collect::<Vec<_>>())]
}

/// Some points as an outline of a stranger.
#[derive(Clone, Debug)]
struct Anything(Vec<(u8, Point2)>);

impl Outline for Anything {
    fn trace<P: Pen>(&self, pen: &mut P) {
        for (verb, point) in &self.0 {
            match verb {
                0 => pen.move_to(*point),
                1 => pen.close(),
                _ => pen.line_to(*point),
            }
        }
    }

    /// As far out as numbers go.
    fn trace_fine<P: Pen>(&self, pen: &mut P) {
        self.trace(pen);
    }
}

fn anything() -> impl Strategy<Value = Anything> {
    let step = (0..8_u8, hostile(), hostile()).prop_map(|(verb, x, y)| (verb, Point2::from_sixteenths(x, y)));
    vec(step, 0..8).prop_map(Anything)
}

/// A window of a few pixels anywhere.
fn window() -> impl Strategy<Value = Rect> {
    (hostile(), hostile(), 0..40_i32, 0..12_i32).prop_map(|(left, top, width, height)| {
        Rect::new(left, top, left.saturating_add(width), top.saturating_add(height))
    })
}

/// Rows are given as often as there is a part in them, columns in order.
fn is_calm<O: Outline>(
    outline: &O,
    (window, rule): (Rect, Rule),
    edges: &mut VecView<AreaEdge>,
    cells: &mut [Coverage],
) {
    let ours = covered(outline, rule, window, edges, cells);
    assert!(ours.iter().all(|part| *part <= 32_768));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3_000))]

    #[test]
    fn any_outline_is_drawn_in_any_window(shape in anything(), window in window(), rule in rule(), cells in 0..50_usize) {
        let mut cells = vec![Coverage::FULL; cells];
        is_calm(&shape, (window, rule), &mut List::<AreaEdge, 0>::new(), &mut cells);
        is_calm(&shape, (window, rule), &mut List::<AreaEdge, 2>::new(), &mut cells);
        is_calm(&shape, (window, rule), &mut List::<AreaEdge, 16>::new(), &mut cells);
        is_calm(&Stroked::new(&shape, Stroke::new(3)), (window, rule), &mut List::<AreaEdge, 16>::new(), &mut cells);
    }

    #[test]
    fn far_windows_show_far_shapes(far in (0..8_i32, 0..8_i32), sign in (any::<bool>(), any::<bool>())) {
        // The corner of the plane of edges, 4,194,304 pixels out: a square that reaches beyond is cut there.
        let side = |far: i32, sign: bool| if sign { (1 << 22) - 9 + far } else { 9 - far - (1 << 22) };
        let (x, y) = (side(far.0, sign.0), side(far.1, sign.1));
        let corners = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)].map(|(x, y)| Point2::from_sixteenths(16 * x + 8, 16 * y));
        let contours = [&corners[..]];
        let square = Polygon::new(&contours).expect("in range");
        let ours = drawn(&square, Rule::NonZero, Rect::new(x - 1, y - 1, x + 3, y + 2));
        prop_assert_eq!(ours, [0, 0, 0, 0, 0, 16_384, 16_384, 0, 0, 0, 0, 0]);
    }

    #[test]
    fn oversampled_spans_may_be_any(window in window(), rows in vec((hostile(), hostile(), hostile()), 0..8), cells in 0..50_usize) {
        let mut cells = vec![Coverage::FULL; cells];
        let mut sink = SpanFn::new(window, |row, columns: Range<i32>, _: Covered<'_>| {
            assert_eq!(window.clip_run(row, columns.clone()), Some(columns));
        });
        let mut fine = Oversampled::new(&mut cells, &mut sink);
        let bounds = fine.bounds();
        for (row, from, to) in rows {
            if let Some(columns) = bounds.clip_run(row, from..to) {
                let Ok(()) = fine.span(row, columns, ());
            }
        }
        let Ok(()) = fine.finish();
    }
}

#[test]
fn a_small_shape_in_all_the_plane_takes_no_time() {
    let window = Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX);
    let dot = Oval::circle(Point2::corner(5, 5), Subpixel::from_num(2)).expect("in range");
    let mut area = 0.0;
    // Rows of four billion pixels, a few cells at a time, would take hours: the cells are looked for where the edges are.
    let narrow = Rect { left: -20_000, right: 20_000, ..window };
    let mut sink = SpanFn::new(narrow, |_, columns: Range<i32>, covered: Covered<'_>| {
        area += (0..columns.len()).map(|offset| f64::from(covered.at(offset).parts())).sum::<f64>() / 32_768.0;
    });
    let (mut edges, mut cells) = (List::<AreaEdge, 16>::new(), [Coverage::NONE; 64]);
    let Ok(()) = fill(&dot, Rule::NonZero, Scratch { edges: &mut edges, cells: &mut cells }, &mut sink);
    assert!((area - 12.566).abs() < 0.02, "{area}");
}

#[test]
fn nothing_is_drawn_of_nothing_and_on_nothing() {
    let corners = [(0, 0), (90, 0), (90, 90)].map(|(x, y)| Point2::from_sixteenths(x, y));
    let contours = [&corners[..]];
    let triangle = Polygon::new(&contours).expect("in range");
    for empty in [Rect::default(), Rect::new(0, 0, 9, 0), Rect::new(9, 9, 0, 0), Rect::new(i32::MAX, 0, i32::MIN, 5)] {
        let mut sink = SpanFn::new(empty, |_, _, _: Covered<'_>| panic!("a span"));
        let (mut edges, mut cells) = (List::<AreaEdge, 4>::new(), [Coverage::NONE; 4]);
        let Ok(()) = fill(&triangle, Rule::NonZero, Scratch { edges: &mut edges, cells: &mut cells }, &mut sink);
    }
    let window = Rect::new(0, 0, 8, 8);
    let point = Oval::circle(Point2::corner(3, 3), Subpixel::ZERO).expect("in range");
    let chord = Chord(Arc::new(point, aquatint::Angle(0), 1));
    let line = Polyline::closed(&corners[..2]).expect("in range");
    let none = [
        drawn(&point, Rule::NonZero, window),
        drawn(&chord, Rule::NonZero, window),
        drawn(&line, Rule::NonZero, window),
    ];
    assert!(none.iter().flatten().all(|part| *part == 0));
}
