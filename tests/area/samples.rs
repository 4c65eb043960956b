//! Oversampling against samples that are counted one by one.

#[path = "../exact/mod.rs"]
mod exact;

use std::ops::Range;

use aquatint::{
    Circle, Coverage, Covered, Ellipse, Line, Oversampled, Point2, Polygon, Rect, Sink, SpanFn, Stroke,
    raster::scan::ActiveEdge,
};
use embedded_graphics::geometry::{Point, Size};
use exact::{Overdraw, is_inside};
use heapless::Vec as List;
use proptest::{collection::vec, prelude::*};

use super::rule;

const WINDOW: Rect = Rect { left: -2, top: -3, right: 18, bottom: 13 };
/// The window four times as large.
const LARGE: Rect = Rect { left: -8, top: -12, right: 72, bottom: 52 };

/// Sixteenths of each pixel, by oversampling.
fn oversampled(draw: impl FnOnce(&mut dyn FnMut(i32, Range<i32>))) -> Vec<u32> {
    let mut picture = vec![0; WINDOW.width() as usize * WINDOW.height() as usize];
    let mut sink = SpanFn::new(WINDOW, |row: i32, columns: Range<i32>, covered: Covered<'_>| {
        assert_eq!(WINDOW.clip_run(row, columns.clone()), Some(columns.clone()));
        for (offset, column) in columns.enumerate() {
            let parts = covered.at(offset).parts();
            assert_eq!(parts % 2048, 0);
            let place = (row - WINDOW.top) as usize * WINDOW.width() as usize + (column - WINDOW.left) as usize;
            assert_eq!(picture[place], 0, "{column}, {row} twice");
            picture[place] = u32::from(parts / 2048);
        }
    });
    let mut row = [Coverage::FULL; 20];
    let mut fine = Oversampled::new(&mut row, &mut sink);
    assert_eq!(fine.bounds(), LARGE);
    draw(&mut |row, columns| {
        let Ok(()) = fine.span(row, columns, ());
    });
    let Ok(()) = fine.finish();
    picture
}

/// Samples of each pixel.
fn counted(mut is_inside: impl FnMut(i32, i32) -> bool) -> Vec<u32> {
    let pixels = WINDOW.rows().flat_map(|y| WINDOW.columns().map(move |x| (x, y)));
    pixels
        .map(|(x, y)| {
            let samples = (4 * y..4 * y + 4).flat_map(|y| (4 * x..4 * x + 4).map(move |x| (x, y)));
            u32::try_from(samples.filter(|&(x, y)| is_inside(x, y)).count()).expect("sixteen at most")
        })
        .collect()
}

/// Draws with a rasteriser twice: into the samples, and into pixels of the large window that are counted.
fn check(draw: impl Fn(&mut SpanFn<&mut dyn FnMut(i32, Range<i32>, ())>)) -> Result<(), TestCaseError> {
    let ours = oversampled(|take| draw(&mut SpanFn::new(LARGE, &mut |row, columns, ()| take(row, columns))));
    let mut large = Overdraw::new(LARGE);
    draw(&mut SpanFn::new(LARGE, &mut |row, columns, ()| large.add(row, columns)));
    prop_assert_eq!(ours, counted(|x, y| large.count(x, y) > 0));
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn polygons_are_counted(corners in vec((-300..1400_i32, -300..1100_i32), 3..7), rule in rule()) {
        let corners: Vec<_> = corners.into_iter().map(|(x, y)| Point2::from_sixteenths(x, y)).collect();
        let contours = [&corners[..]];
        let polygon = Polygon::new(&contours).expect("in range");
        let ours = oversampled(|take| {
            let mut sink = SpanFn::new(LARGE, |row, columns, ()| take(row, columns));
            let Ok(()) = polygon.spans(rule, &mut List::<ActiveEdge, 16>::new(), &mut sink);
        });
        let contours = [corners.clone()];
        prop_assert_eq!(ours, counted(|x, y| is_inside(&contours, rule, (x, y))));
    }

    #[test]
    fn circles_and_ellipses_are_counted(at in (-30..70_i32, -30..60_i32), size in (0..90_u32, 0..90_u32)) {
        let at = Point::new(at.0, at.1);
        check(|sink| {
            let Ok(()) = Circle::new(at, size.0).spans(sink);
        })?;
        check(|sink| {
            let Ok(()) = Ellipse::new(at, Size::new(size.0, size.1)).spans(sink);
        })?;
    }

    #[test]
    fn thick_lines_are_counted(ends in prop::array::uniform4(-40..100_i32), width in 1..40_u16) {
        let [x, y, to_x, to_y] = ends;
        check(|sink| {
            let Ok(()) = Line::new(Point::new(x, y), Point::new(to_x, to_y)).stroke_spans(Stroke::new(width), sink);
        })?;
    }
}
