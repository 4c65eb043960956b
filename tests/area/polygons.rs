//! Polygons, simple ones and any.

use std::ops::Range;

use aquatint::{
    Coverage, Covered, Outline, Point2, Polygon, Rect, Rule, SpanFn,
    raster::area::{AreaEdge, Scratch, fill},
};
use heapless::{Vec as List, vec::VecView};
use proptest::prelude::*;

use crate::oracle;

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

const WINDOW: Rect = Rect { left: -3, top: -2, right: 29, bottom: 22 };

/// The greatest error, in 256ths of a pixel.
fn error(outline: &impl Outline, rule: Rule) -> f64 {
    let (mut edges, mut cells) = (List::<AreaEdge, 64>::new(), [Coverage::NONE; 32]);
    let ours = covered(outline, rule, WINDOW, &mut edges, &mut cells);
    let exact = oracle::coverage(outline, rule, WINDOW);
    let errors = ours.iter().zip(&exact).map(|(ours, exact)| (f64::from(*ours) / 128.0 - exact * 256.0).abs());
    errors.fold(0.0, f64::max)
}

fn point() -> impl Strategy<Value = Point2> {
    let coordinate = || prop_oneof![4 => -100..500_i32, 1 => -5000..5000_i32];
    (coordinate(), coordinate()).prop_map(|(x, y)| Point2::from_sixteenths(x, y))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2_000))]

    #[test]
    fn triangles_are_right_to_a_tenth_of_a_step(corners in [point(), point(), point()]) {
        let contours = [&corners[..]];
        let polygon = Polygon::new(&contours).unwrap();
        let worst = error(&polygon, Rule::NonZero);
        prop_assert!(worst <= 0.1, "{worst}");
    }

    #[test]
    fn any_polygon_is_right_to_seven_steps(corners in prop::collection::vec(point(), 3..9), rule in prop_oneof![Just(Rule::NonZero), Just(Rule::EvenOdd)]) {
        let contours = [&corners[..]];
        let polygon = Polygon::new(&contours).unwrap();
        let worst = error(&polygon, rule);
        prop_assert!(worst <= 7.0, "{worst}");
    }

    #[test]
    fn the_memory_is_a_matter_of_speed(corners in prop::collection::vec(point(), 3..9), cells in 0..40_usize) {
        let contours = [&corners[..]];
        let polygon = Polygon::new(&contours).unwrap();
        let mut whole = [Coverage::NONE; 32];
        let expected = covered(&polygon, Rule::NonZero, WINDOW, &mut List::<AreaEdge, 16>::new(), &mut whole);
        let mut cells = vec![Coverage::FULL; cells];
        let ours = covered(&polygon, Rule::NonZero, WINDOW, &mut List::<AreaEdge, 16>::new(), &mut cells);
        for (ours, expected) in ours.iter().zip(&expected) {
            prop_assert!(ours.abs_diff(*expected) <= 8, "{ours} {expected}");
        }
        let none = covered(&polygon, Rule::NonZero, WINDOW, &mut List::<AreaEdge, 0>::new(), &mut cells);
        let exact = oracle::coverage(&polygon, Rule::NonZero, WINDOW);
        for (ours, exact) in none.iter().zip(&exact) {
            prop_assert!((f64::from(*ours) / 128.0 - exact * 256.0).abs() <= 32.0, "{ours} {exact}");
        }
    }
}
