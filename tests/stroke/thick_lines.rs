//! Thick lines between pixels against the inequalities that define them, squared, in 128-bit integers.

use core::ops::Range;

use aquatint::{Cap, Line, Rect, SpanFn, Stroke, StrokeStyle, Subpixel};
use embedded_graphics::{
    geometry::Point,
    pixelcolor::BinaryColor,
    primitives::{Rectangle, StyledDimensions},
};
use proptest::{prelude::*, sample::select};

use crate::exact::Overdraw;

/// The pixels of a thick line.
fn drawn(line: Line, stroke: Stroke, window: Rect) -> Overdraw {
    let mut pixels = Overdraw::new(window);
    let Ok(()) =
        line.stroke_spans(stroke, &mut SpanFn::new(window, |row, columns: Range<i32>, ()| pixels.add(row, columns)));
    pixels
}

/// Whether `value < width · |d|`, where a point on the border is moved inwards or not.
fn is_below(value: i128, (square, is_inwards): (i128, bool)) -> bool {
    // Beyond 2⁶⁰ its square might not fit, and the width times the length is less than 2⁵⁰.
    let value = value.clamp(-(1 << 60), 1 << 60);
    value < 0 || value * value < square || value * value == square && is_inwards
}

/// Whether the centre of a pixel is in the area. A point infinitesimally right of and below it decides.
fn is_inside(line: Line, stroke: Stroke, (x, y): (i32, i32)) -> bool {
    let [ax, ay, bx, by, x, y] = [line.start.x, line.start.y, line.end.x, line.end.y, x, y].map(i128::from);
    let width = i128::from(stroke.width.to_bits());
    let disc = |cx: i128, cy: i128| {
        let (x, y) = (32 * (x - cx), 32 * (y - cy));
        let distance = x * x + y * y;
        stroke.cap == Cap::Round
            && (distance < width * width || distance == width * width && (x < 0 || x == 0 && y < 0))
    };
    let (dx, dy) = if line.start == line.end { (1, 0) } else { (bx - ax, by - ay) };
    let square = width * width * (dx * dx + dy * dy);
    let (c, along) = (32 * ((x - ax) * dy - (y - ay) * dx), 32 * ((x - ax) * dx + (y - ay) * dy));
    let beyond = 32 * ((x - bx) * dx + (y - by) * dy);
    // The derivatives of c and of along, to the right and, where these are zero, downwards.
    let (right, ahead) = (if dy == 0 { -dx } else { dy }, if dx == 0 { dy } else { dx });
    let in_strip = is_below(c, (square, right < 0)) && is_below(-c, (square, right > 0));
    let in_length = match stroke.cap {
        Cap::Square => is_below(-along, (square, ahead > 0)) && is_below(beyond, (square, ahead < 0)),
        Cap::Butt if line.start == line.end => false,
        _ => along >= 0 && beyond <= 0,
    };
    in_strip && in_length || disc(ax, ay) || disc(bx, by)
}

fn cap() -> impl Strategy<Value = Cap> {
    select(vec![Cap::Butt, Cap::Round, Cap::Square])
}

/// Any width but that of Bresenham's line.
fn width() -> impl Strategy<Value = i32> {
    prop_oneof![3 => (2..12_i32).prop_map(|pixels| pixels * 16), 3 => 1..200_i32, 1 => 1..0xFFFF_i32]
        .prop_filter("thick", |width| *width != 16)
}

fn stroke() -> impl Strategy<Value = Stroke> {
    (width(), cap()).prop_map(|(width, cap)| Stroke::of_width(Subpixel::from_bits(width)).with_cap(cap))
}

fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        5 => -20..30_i32,
        1 => -3000..3000_i32,
        1 => any::<i32>(),
        1 => select(vec![i32::MIN, i32::MIN + 1, i32::MAX - 1, i32::MAX, 0]),
    ]
}

fn line() -> impl Strategy<Value = Line> {
    let point = || (coordinate(), coordinate()).prop_map(|(x, y)| Point::new(x, y));
    prop_oneof![
        4 => (point(), point()).prop_map(|(a, b)| Line::new(a, b)),
        1 => (point(), coordinate()).prop_map(|(a, x)| Line::new(a, Point::new(x, a.y))),
        1 => (point(), coordinate()).prop_map(|(a, y)| Line::new(a, Point::new(a.x, y))),
        1 => (point(), -9..9_i32).prop_map(|(a, d)| Line::new(a, Point::new(a.x.saturating_add(d), a.y))),
    ]
}

/// A window of 20 × 15 pixels about a point of the line.
fn window(line: Line, along: f64, (x, y): (i32, i32)) -> Rect {
    let at = |a: i32, b: i32, by: i32, size: i32| {
        let value = f64::from(a) + along * (f64::from(b) - f64::from(a)) + f64::from(by);
        #[expect(clippy::cast_possible_truncation, reason = "saturates")]
        let value = value as i32;
        value.clamp(i32::MIN + size, i32::MAX - size)
    };
    let (left, top) = (at(line.start.x, line.end.x, x, 20), at(line.start.y, line.end.y, y, 15));
    Rect::new(left, top, left + 20, top + 15)
}

/// Where the border is not computed to the bit: width × length of 2²⁸ square pixels and more.
fn is_exact(line: Line, stroke: Stroke) -> bool {
    let length =
        (f64::from(line.start.x) - f64::from(line.end.x)).hypot(f64::from(line.start.y) - f64::from(line.end.y));
    length * f64::from(stroke.width.to_bits()) < f64::from(u32::MAX) - 2.0
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn the_pixels_are_those_whose_centres_are_in_the_strip(
        line in line(), stroke in stroke(), along in prop_oneof![Just(0.0), Just(1.0), 0.0..1.0], by in (-30..15_i32, -25..15_i32),
    ) {
        let window = window(line, along, by);
        let pixels = drawn(line, stroke, window);
        // Half a sixteenth wider or narrower where the distance of the borders is rounded.
        let other = |by: i32| Stroke { width: Subpixel::from_bits(stroke.width.to_bits() + by), ..stroke };
        for (x, y) in pixels.places() {
            let count = pixels.count(x, y);
            if is_exact(line, stroke) {
                prop_assert_eq!(count, u32::from(is_inside(line, stroke, (x, y))), "{}, {}", x, y);
            } else {
                prop_assert!(count <= u32::from(is_inside(line, other(1), (x, y))), "{}, {}", x, y);
                prop_assert!(count >= u32::from(is_inside(line, other(-1), (x, y))), "{}, {}", x, y);
            }
        }
    }

    #[test]
    fn a_thick_line_is_the_same_from_both_ends(line in line(), stroke in stroke()) {
        for window in [Rect::new(-30, -30, 40, 40), window(line, 0.3, (-9, -9))] {
            let there = drawn(line, stroke, window);
            prop_assert_eq!(there, drawn(Line::new(line.end, line.start), stroke, window));
        }
    }

    #[test]
    fn all_its_pixels_are_in_its_box(line in line(), stroke in stroke(), along in 0.0..=1.0, by in (-30..15_i32, -25..15_i32)) {
        let bounds = Rect::from(line.styled_bounding_box(&StrokeStyle::new(BinaryColor::On).with_stroke(stroke)));
        let pixels = drawn(line, stroke, window(line, along, by));
        for (x, y) in pixels.places().filter(|&(x, y)| pixels.count(x, y) > 0) {
            prop_assert!(bounds.contains(Point::new(x, y)), "{}, {} is not in {:?}", x, y, bounds);
        }
    }
}

#[test]
fn the_area_is_width_times_length_at_every_angle() {
    let window = Rect::new(-420, -420, 420, 420);
    for degrees in 0..360 {
        let (sine, cosine) = f64::from(degrees).to_radians().sin_cos();
        #[expect(clippy::cast_possible_truncation, reason = "small")]
        let end = Point::new((397.0 * cosine).round() as i32, (397.0 * sine).round() as i32);
        for pixels in [2_u16, 3, 5, 12] {
            let drawn = drawn(Line::new(Point::zero(), end), Stroke::new(pixels), window);
            let area: u32 = drawn.places().map(|(x, y)| drawn.count(x, y)).sum();
            let exact = f64::from(pixels) * f64::from(end.x).hypot(f64::from(end.y));
            let ratio = f64::from(area) / exact;
            // Along the step from one centre on the line to the next, centres lie in lines 1/step apart: on a diagonal
            // only √½. The strip holds a whole number of these lines, at most one more or less than it is wide.
            let steps = (1..=397).rev().find(|steps| end.x % steps == 0 && end.y % steps == 0).expect("1");
            let step = f64::from(end.x / steps).hypot(f64::from(end.y / steps));
            let allowed = 0.007 + 1.0 / (f64::from(pixels) * step);
            assert!((ratio - 1.0).abs() <= allowed, "{degrees} degrees, width {pixels}: {ratio}");
            assert!(step < 150.0 || (ratio - 1.0).abs() <= 0.01, "{degrees} degrees, width {pixels}: {ratio}");
        }
    }
}

#[test]
fn widths_that_are_not_positive_draw_nothing_and_one_pixel_is_bresenhams_line() {
    let window = Rect::new(-5, -5, 15, 15);
    let line = Line::new(Point::new(0, 1), Point::new(9, 5));
    for width in [0, -1, i32::MIN] {
        let nothing = Stroke::of_width(Subpixel::from_bits(width)).with_cap(Cap::Square);
        assert_eq!(drawn(line, nothing, window), Overdraw::new(window));
        assert_eq!(line.styled_bounding_box(&StrokeStyle::new(BinaryColor::On).with_stroke(nothing)).size.width, 0);
    }
    let mut thin = Overdraw::new(window);
    let Ok(()) = line.spans(&mut SpanFn::new(window, |row, columns: Range<i32>, ()| thin.add(row, columns)));
    assert_eq!(drawn(line, Stroke::new(1).with_cap(Cap::Round), window), thin);
    let wide = Stroke::of_width(Subpixel::MAX);
    assert_eq!(drawn(line, wide, window), drawn(line, Stroke::of_width(Stroke::WIDEST), window));
}

#[test]
fn a_huge_line_takes_work_for_the_visible_rows_only() {
    let line = Line::new(Point::new(i32::MIN, i32::MIN), Point::new(i32::MAX, i32::MAX));
    let mut spans = 0;
    let Ok(()) = line.stroke_spans(
        Stroke::new(8),
        &mut SpanFn::new(Rect::new(0, 0, 64, 48), |row: i32, columns: Range<i32>, ()| {
            spans += 1;
            // 8 · √2 = 11.3 columns, cut off at the window.
            assert_eq!(columns, (row - 5).max(0)..(row + 6), "row {row}");
        }),
    );
    assert_eq!(spans, 48);
    let _: Rectangle = line.styled_bounding_box(&StrokeStyle::new(BinaryColor::On).with_width(u16::MAX));
}
