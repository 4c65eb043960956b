//! Circles and ellipses of whole pixels: embedded-graphics' own, and the definition in 128 bits.

use aquatint::{Circle, Ellipse, FillStyle, Rect, SpanFn, StrokeStyle, Subpixel};
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point, Size},
    pixelcolor::BinaryColor,
    prelude::Transform,
    primitives::{
        self, ContainsPoint, PointsIter, PrimitiveStyleBuilder, Rectangle, StrokeAlignment, StyledDimensions,
        StyledDrawable,
    },
};
use proptest::{prelude::*, sample::select};

use crate::exact::Overdraw;

/// Where everything is drawn: as wide as the widest shape of the tests.
const WINDOW: Rect = Rect::new(-8, -8, 140, 140);

/// A display that counts how often a pixel is drawn.
struct Counted(Overdraw);

impl Dimensions for Counted {
    fn bounding_box(&self) -> Rectangle {
        self.0.window().into()
    }
}

impl DrawTarget for Counted {
    type Color = BinaryColor;
    type Error = std::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<BinaryColor>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        for Pixel(Point { x, y }, _) in pixels {
            self.0.add(y, x..x + 1);
        }
        Ok(())
    }
}

/// What a shape of either crate draws in a style.
fn drawn<S>(shape: &impl StyledDrawable<S, Color = BinaryColor>, style: &S) -> Overdraw {
    let mut display = Counted(Overdraw::new(WINDOW));
    let Ok(_) = shape.draw_styled(style, &mut display);
    display.0
}

/// The spans of a shape, checked for their order: from top to bottom, from left to right, at most `most` a row.
fn spans(
    window: Rect,
    most: usize,
    draw: impl FnOnce(&mut SpanFn<&mut dyn FnMut(i32, std::ops::Range<i32>, ())>),
) -> Overdraw {
    let (mut pixels, mut last, mut in_row) = (Overdraw::new(window), (i32::MIN, i32::MIN), 0);
    let mut take = |row: i32, columns: std::ops::Range<i32>, ()| {
        assert!(last.0 < row || last.0 == row && last.1 < columns.start, "{row}, {columns:?} after {last:?}");
        in_row = if last.0 == row { in_row + 1 } else { 1 };
        assert!(in_row <= most, "{in_row} spans in row {row}");
        last = (row, columns.end);
        pixels.add(row, columns);
    };
    draw(&mut SpanFn::new(window, &mut take));
    pixels
}

const ALIGNMENTS: [StrokeAlignment; 3] = [StrokeAlignment::Inside, StrokeAlignment::Center, StrokeAlignment::Outside];

/// Counts are compared, pictures shown.
fn assert_same(ours: &Overdraw, theirs: &Overdraw, what: &str) {
    assert!(ours == theirs, "{what}\n{}\nshould be\n{}", ours.picture(), theirs.picture());
}

/// Draws all styles of a shape by both crates.
fn compare<A, B>(ours: &A, theirs: &B, widths: &[u16])
where
    A: StyledDrawable<FillStyle<BinaryColor>, Color = BinaryColor>
        + StyledDrawable<StrokeStyle<BinaryColor>, Color = BinaryColor>
        + StyledDimensions<StrokeStyle<BinaryColor>>
        + std::fmt::Debug,
    B: StyledDrawable<primitives::PrimitiveStyle<BinaryColor>, Color = BinaryColor>
        + StyledDimensions<primitives::PrimitiveStyle<BinaryColor>>,
{
    let on = BinaryColor::On;
    let fill = PrimitiveStyleBuilder::new().fill_color(on).build();
    assert_same(&drawn(ours, &FillStyle::new(on)), &drawn(theirs, &fill), &format!("{ours:?}"));
    for &width in widths {
        let stroke = PrimitiveStyleBuilder::new().stroke_color(on).stroke_width(width.into()).build();
        let style = StrokeStyle::new(on).with_width(width);
        assert_same(&drawn(ours, &style), &drawn(theirs, &stroke), &format!("{ours:?}, a stroke of {width}"));
        assert_eq!(ours.styled_bounding_box(&style), theirs.styled_bounding_box(&stroke), "{ours:?}, {width}");
    }
}

/// Draws strokes of all alignments by both crates.
fn compare_alignments<B>(
    theirs: &B,
    width: u32,
    ours: impl Fn(StrokeAlignment, &mut SpanFn<&mut dyn FnMut(i32, std::ops::Range<i32>, ())>),
) where
    B: StyledDrawable<primitives::PrimitiveStyle<BinaryColor>, Color = BinaryColor> + std::fmt::Debug,
{
    for alignment in ALIGNMENTS {
        let style = PrimitiveStyleBuilder::new()
            .stroke_color(BinaryColor::On)
            .stroke_width(width)
            .stroke_alignment(alignment)
            .build();
        let pixels = spans(WINDOW, 2, |sink| ours(alignment, sink));
        assert_same(&pixels, &drawn(theirs, &style), &format!("{theirs:?}, {width} {alignment:?}"));
    }
}

#[test]
fn circles_of_all_diameters_are_those_of_embedded_graphics() {
    for diameter in 0..=100 {
        let theirs = primitives::Circle::new(Point::new(12, 15), diameter);
        compare(&Circle::from(theirs), &theirs, &[0, 1, 2, 3, 4, 5, 8, 13, 20]);
        let ours = Circle::with_center(Point::new(60, 61), diameter);
        assert_eq!(ours, primitives::Circle::with_center(Point::new(60, 61), diameter).into());
        for width in [1, 2, 7] {
            compare_alignments(&theirs, width, |alignment, sink| {
                let Ok(()) = Circle::from(theirs).stroke_spans(width, alignment, sink);
            });
        }
    }
}

/// Whether embedded-graphics draws an ellipse: it gives up in the first row without a pixel.
fn has_first_row(size: Size) -> bool {
    primitives::Ellipse::new(Point::zero(), size).points().next().is_some()
}

#[test]
fn ellipses_of_many_sizes_are_those_of_embedded_graphics() {
    let mut compared = 0;
    for width in (0..=40).chain([63, 64, 99, 100]) {
        for height in (0..=40).chain([63, 64, 99, 100]) {
            let theirs = primitives::Ellipse::new(Point::new(15, 12), Size::new(width, height));
            let widths = [1, 2, 3, 6, 11].into_iter().filter(|stroke| {
                let outside = u32::from(*stroke) / 2 * 2;
                has_first_row(theirs.size + Size::new_equal(outside))
            });
            if has_first_row(theirs.size) {
                compare(&Ellipse::from(theirs), &theirs, &widths.collect::<Vec<_>>());
                compared += 1;
            }
            let center = Point::new(60, 61);
            let ours = Ellipse::with_center(center, theirs.size);
            assert_eq!(ours, primitives::Ellipse::with_center(center, theirs.size).into());
        }
    }
    assert!(compared > 1800, "{compared}");
    let theirs = primitives::Ellipse::new(Point::new(40, 40), Size::new(34, 51));
    for width in 0..30 {
        compare_alignments(&theirs, width, |alignment, sink| {
            let Ok(()) = Ellipse::from(theirs).stroke_spans(width, alignment, sink);
        });
    }
}

#[test]
fn a_narrow_ellipse_is_drawn_although_its_first_row_is_empty() {
    let size = Size::new(2, 10);
    assert!(!has_first_row(size), "the documented difference is gone");
    let pixels = spans(Rect::new(0, 0, 2, 10), 1, |sink| {
        let Ok(()) = Ellipse::new(Point::zero(), size).spans(sink);
    });
    let theirs = primitives::Ellipse::new(Point::zero(), size);
    assert!(pixels.places().all(|(x, y)| pixels.count(x, y) == u32::from(theirs.contains(Point::new(x, y)))));
    assert_eq!(pixels.picture(), "..\n##\n##\n##\n##\n##\n##\n##\n##\n..\n");
}

/// Whether a pixel is inside, by the definition. In sixteenths of what 128 bits hold: sides are those of `u32`.
fn is_inside(top_left: Point, size: Size, point: Point) -> bool {
    let [width, height] = [size.width, size.height].map(i128::from);
    let x = 2 * (i128::from(point.x) - i128::from(top_left.x)) - (width - 1);
    let y = 2 * (i128::from(point.y) - i128::from(top_left.y)) - (height - 1);
    if x.abs() >= width || y.abs() >= height {
        return false;
    }
    if width == height {
        let threshold = width * width - if width <= 4 { width / 2 } else { 0 };
        return x * x + y * y < threshold;
    }
    // x²·h² + y²·w² < w²·h², in two halves: y²·w² < (w² − x²)·h².
    let (left, right) = (square_product(y, width), product(width * width - x * x, height * height));
    left < right
}

/// `a²·b²` in 256 bits.
fn square_product(a: i128, b: i128) -> (u128, u128) {
    product(a * a, b * b)
}

/// A product of numbers below 2⁶⁵ in halves of 2⁶⁴.
fn product(a: i128, b: i128) -> (u128, u128) {
    let (a, b) = (a.unsigned_abs(), b.unsigned_abs());
    let half = |v: u128| (v >> 64, v & u128::from(u64::MAX));
    let ((ah, al), (bh, bl)) = (half(a), half(b));
    let low = al * bl;
    let middle = (low >> 64) + ah * bl + al * bh;
    (ah * bh * (1 << 64) + middle, low & u128::from(u64::MAX))
}

fn position() -> impl Strategy<Value = i32> {
    prop_oneof![
        4 => -40..30_i32,
        2 => -2_000_000..2_000_000_i32,
        1 => any::<i32>(),
        1 => select(vec![i32::MIN, i32::MIN + 1, i32::MAX - 3, i32::MAX]),
    ]
}

fn side() -> impl Strategy<Value = u32> {
    prop_oneof![
        4 => 0..60_u32,
        2 => 65_520..65_560_u32,
        2 => 0..4_000_000_u32,
        1 => any::<u32>(),
        1 => select(vec![u32::MAX, u32::MAX - 1, 1 << 31, (1 << 31) - 1, 1, 2]),
    ]
}

/// A window somewhere on the boundary of a shape, or at the origin.
fn window(top_left: Point, size: Size, (on, dx, dy): (usize, i32, i32)) -> Rect {
    let at = |from: i32, side: u32, part: u32| i64::from(from) + i64::from(side) * i64::from(part) / 8;
    // The eight points of a compass, a corner, and the diagonal, where both coordinates move.
    let (px, py) = [(0, 4), (4, 0), (8, 4), (4, 8), (1, 1), (7, 1), (1, 7), (7, 7), (2, 1), (4, 4)][on % 10];
    let clamp = |v: i64| i32::try_from(v.clamp(-2_147_483_600, 2_147_483_600)).expect("clamped");
    let (x, y) = (clamp(at(top_left.x, size.width, px)), clamp(at(top_left.y, size.height, py)));
    let (left, top) = if on == 10 { (-4, -4) } else { (x + dx, y + dy) };
    Rect::new(left, top, left.saturating_add(19), top.saturating_add(17))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn pixels_are_those_whose_centres_are_inside_wherever_the_window_is(
        (x, y) in (position(), position()), (width, height) in (side(), side()),
        is_circle in any::<bool>(), look in (0..11_usize, -20..4_i32, -20..4_i32),
    ) {
        let (top_left, size) = (Point::new(x, y), Size::new(width, if is_circle { width } else { height }));
        let window = window(top_left, size, look);
        let ellipse = Ellipse::new(top_left, size);
        let pixels = spans(window, 1, |sink| {
            let Ok(()) = ellipse.spans(sink);
        });
        for (x, y) in pixels.places() {
            let (point, box_end) = (Point::new(x, y), i64::from(i32::MAX));
            // A box that ends behind 32 bits has the rows and columns in front of it.
            let expected = is_inside(top_left, size, point) && i64::from(x) < box_end && i64::from(y) < box_end;
            prop_assert_eq!(pixels.count(x, y), u32::from(expected), "{}, {}", x, y);
            prop_assert_eq!(ellipse.contains(point), expected);
        }
    }

    #[test]
    fn a_stroke_is_what_is_between_two_ellipses(
        (x, y) in (position(), position()), (width, height) in (side(), side()), is_circle in any::<bool>(),
        stroke in prop_oneof![0..9_u32, side()], look in (0..11_usize, -20..4_i32, -20..4_i32),
    ) {
        let (top_left, size) = (Point::new(x, y), Size::new(width, if is_circle { width } else { height }));
        let window = window(top_left, size, look);
        let pixels = spans(window, 2, |sink| {
            let Ok(()) = Ellipse::new(top_left, size).stroke_spans(stroke, StrokeAlignment::Inside, sink);
        });
        let inside = size.saturating_sub(Size::new_equal(stroke.saturating_mul(2)));
        let [dx, dy] = [size.width - inside.width, size.height - inside.height].map(|v| v / 2);
        let inner = (i64::from(x) + i64::from(dx), i64::from(y) + i64::from(dy));
        // What begins behind 32 bits has no pixel there.
        let inner = i32::try_from(inner.0).ok().zip(i32::try_from(inner.1).ok()).map(|(x, y)| Point::new(x, y));
        for (x, y) in pixels.places() {
            let point = Point::new(x, y);
            let hole = inner.is_some_and(|inner| is_inside(inner, inside, point));
            let expected = is_inside(top_left, size, point) && !hole;
            prop_assert_eq!(pixels.count(x, y), u32::from(expected), "{}, {}", x, y);
        }
    }
}

#[test]
fn extremes_neither_panic_nor_take_long() {
    let ends = [i32::MIN, -1, 0, i32::MAX];
    let sides = [0, 1, 2, 65_535, 65_536, 1 << 31, u32::MAX - 1, u32::MAX];
    for (x, y) in ends.into_iter().flat_map(|x| ends.map(|y| (x, y))) {
        for (width, height) in sides.into_iter().flat_map(|width| sides.map(|height| (width, height))) {
            let size = Size::new(width, height);
            for ellipse in [Ellipse::new(Point::new(x, y), size), Ellipse::with_center(Point::new(x, y), size)] {
                let on = BinaryColor::On;
                let _ = drawn(&ellipse, &FillStyle::new(on));
                for pixels in [0, 1, u16::MAX] {
                    let style = StrokeStyle::new(on).with_width(pixels);
                    let _ = (drawn(&ellipse, &style), ellipse.styled_bounding_box(&style));
                }
                let moved = ellipse.translate(Point::new(i32::MAX, i32::MIN));
                let _ = (moved.contains(Point::new(y, x)), moved.bounding_box());
                for alignment in ALIGNMENTS {
                    let _ = spans(Rect::new(0, 0, 9, 9), 2, |sink| {
                        let Ok(()) = ellipse.stroke_spans(u32::MAX, alignment, sink);
                    });
                }
            }
        }
    }
}

#[test]
fn widths_round_to_whole_pixels_and_never_to_none() {
    let circle = Circle::new(Point::new(20, 20), 30);
    let stroke = |sixteenths: i32| {
        let stroke = aquatint::Stroke::of_width(Subpixel::from_bits(sixteenths));
        drawn(&circle, &StrokeStyle::new(BinaryColor::On).with_stroke(stroke))
    };
    let whole = |pixels: u16| drawn(&circle, &StrokeStyle::new(BinaryColor::On).with_width(pixels));
    let cases = [(i32::MIN, 0), (-1, 0), (0, 0), (1, 1), (23, 1), (24, 2), (39, 2), (40, 3), (i32::MAX, u16::MAX)];
    for (sixteenths, pixels) in cases {
        assert_same(&stroke(sixteenths), &whole(pixels), &sixteenths.to_string());
    }
}
