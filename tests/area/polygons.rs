//! Polygons, simple ones and any.

use std::ops::Range;

use aquatint::{
    Coverage, Covered, Outline, Pen, Point2, Polygon, Rect, Rule, SpanFn,
    raster::area::{AreaEdge, Scratch, fill},
};
use heapless::{Vec as List, vec::VecView};
use proptest::{collection::vec, prelude::*};

use super::{WINDOW, drawn, oracle, point, rule, worst};

/// The covered parts of the pixels of a window, each of them given once at most.
pub fn covered(
    outline: &impl Outline,
    rule: Rule,
    window: Rect,
    edges: &mut VecView<AreaEdge>,
    cells: &mut [Coverage],
) -> Vec<u16> {
    let width = window.columns().len();
    let mut picture = vec![0; width * window.rows().len()];
    let mut last = None;
    let mut sink = SpanFn::new(window, |row: i32, columns: Range<i32>, covered: Covered<'_>| {
        assert!(window.clip_run(row, columns.clone()) == Some(columns.clone()), "{row} {columns:?} in {window:?}");
        assert!(last.is_none_or(|(before, end)| (before, end) <= (row, columns.start)), "out of order");
        last = Some((row, columns.end));
        if let Covered::Each(cells) = covered {
            assert_eq!(cells.len(), columns.len());
        }
        for (offset, column) in columns.enumerate() {
            let place = (row - window.top) as usize * width + (column - window.left) as usize;
            picture[place] = covered.at(offset).parts();
        }
    });
    let Ok(()) = fill(outline, rule, Scratch { edges, cells }, &mut sink);
    picture
}

/// The greatest error, in 256ths of a pixel.
fn error(outline: &impl Outline, rule: Rule) -> f64 {
    worst(&drawn(outline, rule, WINDOW), &oracle::coverage(outline, rule, WINDOW))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2_000))]

    #[test]
    fn triangles_are_right_to_a_twentieth_of_a_step(corners in [point(), point(), point()]) {
        let contours = [&corners[..]];
        let polygon = Polygon::new(&contours).unwrap();
        let worst = error(&polygon, Rule::NonZero);
        prop_assert!(worst <= 0.05, "{worst}");
    }

    #[test]
    fn any_polygon_is_right_to_two_steps(corners in vec(point(), 3..9), rule in rule()) {
        let contours = [&corners[..]];
        let polygon = Polygon::new(&contours).unwrap();
        let worst = error(&polygon, rule);
        prop_assert!(worst <= 2.0, "{worst}");
    }

    #[test]
    fn a_list_too_short_is_right_to_a_sixteenth(corners in vec(point(), 3..9), rule in rule(), cells in 0..40_usize) {
        let contours = [&corners[..]];
        let polygon = Polygon::new(&contours).unwrap();
        let mut cells = vec![Coverage::FULL; cells];
        let none = covered(&polygon, rule, WINDOW, &mut List::<AreaEdge, 0>::new(), &mut cells);
        let few = covered(&polygon, rule, WINDOW, &mut List::<AreaEdge, 3>::new(), &mut cells);
        let exact = oracle::coverage(&polygon, rule, WINDOW);
        prop_assert!(worst(&none, &exact) <= 16.0, "{}", worst(&none, &exact));
        prop_assert!(worst(&few, &exact) <= 16.0, "{}", worst(&few, &exact));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Dozens of crossings in a row.
    #[test]
    fn tangles_are_right_to_four_steps(corners in vec((0..50_i32, 0..50_i32), 24), rule in rule()) {
        let corners: Vec<_> = corners.into_iter().map(|(x, y)| Point2::from_sixteenths(x, y)).collect();
        let contours = [&corners[..]];
        let polygon = Polygon::new(&contours).unwrap();
        let worst = error(&polygon, rule);
        prop_assert!(worst <= 4.0, "{worst}");
    }
}

/// Nothing goes through the row's upper border; below it the polygon winds one way and then, behind a flat edge that
/// crosses it, the other.
#[test]
fn a_row_may_begin_with_nothing_and_wind_both_ways() {
    let corners = [(83, 325), (83, 332), (0, 332), (0, 344)].map(|(x, y)| Point2::from_sixteenths(x, y));
    let contours = [&corners[..]];
    let polygon = Polygon::new(&contours).unwrap();
    for rule in [Rule::NonZero, Rule::EvenOdd] {
        let worst = error(&polygon, rule);
        assert!(worst <= 1.0, "{worst}");
    }
}

#[test]
fn crossings_behind_many_corners_are_parted_finely() {
    // 80 corners cut the upper third of a row into bands; below them two flat edges cross soon.
    let corners = (0..80).map(|corner| (6000 + 4 * corner, corner));
    let path = FinePath(vec![
        std::iter::once((6000, 80)).chain(corners).chain([(6400, 80)]).collect(),
        vec![(0, 90), (6144, 250), (0, 250)],
        vec![(700, 90), (-10_000, 250), (700, 250)],
    ]);
    for rule in [Rule::NonZero, Rule::EvenOdd] {
        let worst = error(&path, rule);
        assert!(worst <= 1.0, "{worst}");
    }
}

/// Contours on 256ths of a pixel.
struct FinePath(Vec<Vec<(i32, i32)>>);

impl Outline for FinePath {
    fn trace<P: Pen>(&self, _: &mut P) {}

    fn trace_fine<P: Pen>(&self, pen: &mut P) {
        for contour in &self.0 {
            let mut points = contour.iter().map(|&(x, y)| Point2::from_sixteenths(x, y));
            pen.move_to(points.next().expect("a corner"));
            points.for_each(|point| pen.line_to(point));
            pen.close();
        }
    }
}
