//! Digital differential analyser and stipple, against what they are at each pixel.

mod exact;

use aquatint::{DdaLine, Line, Rect, SpanFn, Stipple};
use embedded_graphics::geometry::Point;
use exact::{Overdraw, line};
use proptest::{prelude::*, sample::select};

/// Near the window, or as far as numbers go.
fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        5 => -40..60_i32,
        2 => -70_000..70_000_i32,
        1 => any::<i32>(),
        1 => select(vec![i32::MIN, i32::MIN + 1, -1, 0, i32::MAX - 1, i32::MAX]),
    ]
}

fn point() -> impl Strategy<Value = Point> {
    (coordinate(), coordinate()).prop_map(|(x, y)| Point::new(x, y))
}

fn window() -> impl Strategy<Value = Rect> {
    let place = || prop_oneof![6 => -30..30_i32, 1 => select(vec![i32::MIN, i32::MAX - 40])];
    (place(), place(), 0..40_i32, 0..40_i32).prop_map(|(x, y, width, height)| Rect::new(x, y, x + width, y + height))
}

/// The pixels of a line in a window, sorted; each may be drawn once.
fn drawn(window: Rect, draw: impl FnOnce(&mut Overdraw)) -> Vec<(i32, i32)> {
    let mut pixels = Overdraw::new(window);
    draw(&mut pixels);
    let mut drawn: Vec<_> = pixels.places().filter(|&(x, y)| pixels.count(x, y) > 0).collect();
    assert!(drawn.iter().all(|&(x, y)| pixels.count(x, y) == 1), "a pixel is drawn twice");
    drawn.sort_unstable();
    drawn
}

fn dda(ends: (Point, Point), window: Rect) -> Vec<(i32, i32)> {
    drawn(window, |pixels| {
        let Ok(()) =
            DdaLine::new(ends.0, ends.1).spans(&mut SpanFn::new(window, |row, columns, ()| pixels.add(row, columns)));
    })
}

/// The same by the words of the method: a slope of 32 fraction bits, multiplied out at each step.
fn dda_slowly((start, end): (Point, Point), window: Rect) -> Vec<(i32, i32)> {
    let [ax, ay, bx, by] = [start.x, start.y, end.x, end.y].map(i128::from);
    let is_steep = (by - ay).abs() > (bx - ax).abs();
    let swap = |(x, y): (i128, i128)| if is_steep { (y, x) } else { (x, y) };
    let (a, b) = (swap((ax, ay)), swap((bx, by)));
    let (a, b) = if a.0 <= b.0 { (a, b) } else { (b, a) };
    let (run, rise) = ((b.0 - a.0).max(1), b.1 - a.1);
    // Towards plus infinity, on lines that rise by 2³¹ and more towards minus infinity.
    let slope = if rise >= 0 && run >= 1 << 31 { (rise << 32).div_euclid(run) } else { -(-rise << 32).div_euclid(run) };
    let majors = if is_steep { window.rows() } else { window.columns() };
    let majors = majors.map(i128::from).filter(|major| (a.0..=b.0).contains(major));
    let pixels = majors.map(|major| swap((major, a.1 + (((major - a.0) * slope + (1 << 31)) >> 32))));
    let mut pixels: Vec<_> =
        pixels.filter_map(|(x, y)| Some((i32::try_from(x).ok()?, i32::try_from(y).ok()?))).collect();
    pixels.retain(|&(x, y)| window.contains(Point::new(x, y)));
    pixels.sort_unstable();
    pixels
}

/// The pixels of a stippled line: those of the whole line that are on and in the window.
fn stippled_slowly((start, end): (Point, Point), window: Rect, (pattern, times): (u16, u8)) -> Vec<(i32, i32)> {
    let is_steep = start.y.abs_diff(end.y) > start.x.abs_diff(end.x);
    let from_start = |(x, y): (i32, i32)| if is_steep { y.abs_diff(start.y) } else { x.abs_diff(start.x) };
    let is_on = |pixel: u32| pattern >> (15 - pixel / u32::from(times) % 16) & 1 == 1;
    line(Line::new(start, end), window).into_iter().filter(|&pixel| is_on(from_start(pixel))).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn a_clipped_dda_line_has_the_pixels_of_the_whole_one(a in point(), b in point(), window in window()) {
        let pixels = dda((a, b), window);
        prop_assert_eq!(&pixels, &dda_slowly((a, b), window));
        prop_assert_eq!(&pixels, &dda((b, a), window), "the same from both ends");
        if a.x.abs_diff(b.x).max(a.y.abs_diff(b.y)) <= 46_340 {
            prop_assert_eq!(&pixels, &line(Line::new(a, b), window), "Bresenham's");
        }
    }

    #[test]
    fn a_stipple_begins_at_the_start_of_the_line(
        a in point(), b in point(), window in window(), pattern in any::<u16>(), times in 1..=255_u8,
    ) {
        let pixels = drawn(window, |pixels| {
            let mut sink = SpanFn::new(window, |row, columns, ()| pixels.add(row, columns));
            let Ok(()) = Stipple::new(pattern).times(times).along(Line::new(a, b)).spans(&mut sink);
        });
        prop_assert_eq!(pixels, stippled_slowly((a, b), window, (pattern, times)));
    }
}

#[test]
fn every_short_dda_line_is_bresenhams_and_the_same_from_both_ends() {
    let window = Rect::new(-40, -40, 41, 41);
    for (x, y) in (-40..=40).flat_map(|x| (-40..=40).map(move |y| (x, y))) {
        let ends = (Point::zero(), Point::new(x, y));
        let pixels = dda(ends, window);
        assert_eq!(pixels, line(Line::new(ends.0, ends.1), window), "to {x}, {y}");
        assert_eq!(pixels, dda((ends.1, ends.0), window));
    }
}

#[test]
fn stipples() {
    let window = Rect::new(0, 0, 24, 7);
    let mut pixels = Overdraw::new(window);
    let mut draw = |ends: [(i32, i32); 2], stipple: Stipple| {
        let [start, end] = ends.map(|(x, y)| Point::new(x, y));
        let mut sink = SpanFn::new(window, |row, columns, ()| pixels.add(row, columns));
        let Ok(()) = stipple.along(Line::new(start, end)).spans(&mut sink);
    };
    draw([(0, 0), (23, 0)], Stipple::new(0b1111_0011_0000_1100));
    draw([(23, 1), (0, 1)], Stipple::new(0b1111_0011_0000_1100));
    draw([(-5, 2), (23, 2)], Stipple::new(0xAAAA).times(3));
    draw([(0, 3), (23, 6)], Stipple::new(0xEEEE).times(0));
    let expected = "\
####..##....##..####..##
##..####..##....##..####
.###...###...###...###..
###.....................
....###.###.............
............###.###.....
....................###.
";
    assert_eq!(pixels.picture(), expected);
}
