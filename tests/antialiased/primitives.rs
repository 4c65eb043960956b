//! Shapes with an antialiased style: where they lie, their boxes, and any numbers.

use std::f64::consts::PI;

use aquatint::{
    Affine, Alpha, Angle, AntialiasedStyle, Arc, Blended, Cap, Chord, Circle, Coverage, Covered, Dashed, Ellipse,
    Frame, Hershey, Join, Line, Outline, Oval, Path, Placed, Point2, Polygon, Polyline, Rect, RoundedRectangle, Rows,
    Rule, Scalar, Sector, Segment, SpanFn, Stroke, Stroked, Subpixel, Text,
    raster::area::{AreaEdge, Scratch, fill},
};
use embedded_graphics::{
    image::GetPixel,
    pixelcolor::{BinaryColor, Gray4, Gray8},
    prelude::*,
    primitives::{self, PrimitiveStyle, Rectangle, StyledDimensions, StyledDrawable},
};
use heapless::Vec as List;
use proptest::{array::uniform4, prelude::*, sample::select};

use super::{Record, points};

const SIZE: Size = Size::new(40, 40);

/// The covered part of each pixel of what is drawn.
fn coverage(draw: impl FnOnce(&mut Record<Gray8>)) -> Vec<u16> {
    let mut record = Record::new(SIZE);
    draw(&mut record);
    points(SIZE).map(|point| record.at(point).map_or(0, |alpha| alpha.coverage.parts())).collect()
}

/// Whether embedded-graphics draws each pixel.
fn theirs(
    shape: &impl StyledDrawable<PrimitiveStyle<BinaryColor>, Color = BinaryColor, Output = ()>,
    width: u32,
) -> Vec<bool> {
    let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 200], 40, 40).expect("memory enough");
    let Ok(()) = shape.draw_styled(&PrimitiveStyle::with_stroke(BinaryColor::On, width), &mut frame);
    points(SIZE).map(|point| frame.pixel(point) == Some(BinaryColor::On)).collect()
}

fn stroked(
    shape: &impl StyledDrawable<AntialiasedStyle<Gray8>, Color = Alpha<Gray8>, Output = ()>,
    width: u16,
) -> Vec<u16> {
    coverage(|record| {
        let Ok(()) = shape.draw_styled(&AntialiasedStyle::stroke(Gray8::WHITE, width), record);
    })
}

fn light(parts: &[u16]) -> f64 {
    parts.iter().map(|&parts| f64::from(parts) / 32_768.0).sum()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn borders_of_rectangles_are_those_of_embedded_graphics(at in (-9..30_i32, -9..30_i32), size in (1..30_u32, 1..30_u32), width in 1..6_u16) {
        let rectangle = Rectangle::new(Point::new(at.0, at.1), Size::new(size.0, size.1));
        let expected = theirs(&rectangle, width.into());
        let ours = stroked(&rectangle, width);
        for (point, (ours, theirs)) in points(SIZE).zip(ours.into_iter().zip(expected)) {
            prop_assert_eq!(ours, if theirs { 32_768 } else { 0 }, "{:?}", point);
        }
    }

    #[test]
    fn circles_of_one_pixel_lie_on_those_of_embedded_graphics(at in (0..10_i32, 0..10_i32), diameter in 1..30_u32) {
        let circle = primitives::Circle::new(Point::new(at.0, at.1), diameter);
        let (ours, theirs) = (stroked(&circle, 1), theirs(&circle, 1));
        // A ring from the border of the circle to a pixel inside of it.
        let radius = f64::from(diameter) / 2.0;
        let area = PI * (radius * radius - (radius - 1.0).max(0.0).powi(2));
        prop_assert!((light(&ours) / area - 1.0).abs() < 0.01, "{} {area}", light(&ours));
        for (point, (part, is_theirs)) in points(SIZE).zip(ours.iter().zip(&theirs)) {
            prop_assert!(!*is_theirs || *part > 0, "{:?} is not covered", point);
            let around = Rectangle::new(point - Point::new(1, 1), Size::new(3, 3)).points();
            let is_near = around.filter(|place| Rectangle::new(Point::zero(), SIZE).contains(*place)).any(|place| theirs[place.y as usize * 40 + place.x as usize]);
            prop_assert!(*part == 0 || is_near, "{:?} is far from it", point);
        }
        prop_assert_eq!(ours, stroked(&Circle::new(Point::new(at.0, at.1), diameter), 1));
    }

    #[test]
    fn insides_are_the_shapes_and_lines_go_from_centre_to_centre(ends in uniform4(3..36_i32), size in (0..30_u32, 0..30_u32), width in 1..5_u16) {
        let [x, y, to_x, to_y] = ends;
        let (from, to) = (Point::new(x, y), Point::new(to_x, to_y));
        let line = stroked(&primitives::Line::new(from, to), width);
        let length = f64::from(to_x - x).hypot(f64::from(to_y - y));
        // Of short and thick ones a part is out of sight.
        if width == 1 {
            prop_assert!((light(&line) - length).abs() <= 0.01 * length + 0.001, "{} {length}", light(&line));
        }
        prop_assert_eq!(line, stroked(&Line::new(from, to), width));
        let fill = AntialiasedStyle::fill(Gray8::WHITE);
        let filled = coverage(|record| {
            let Ok(()) = primitives::Ellipse::new(Point::new(2, 3), Size::new(size.0, size.1)).into_styled(fill).draw(record);
        });
        let area = PI / 4.0 * f64::from(size.0 * size.1);
        prop_assert!((light(&filled) - area).abs() <= 0.005 * area + 0.01, "{} {area}", light(&filled));
        let again = coverage(|record| {
            let Ok(()) = Ellipse::new(Point::new(2, 3), Size::new(size.0, size.1)).into_styled(fill).draw(record);
        });
        prop_assert_eq!(filled, again);
        let corners = [from, to, Point::new(20, 20)];
        let triangle = coverage(|record| {
            let Ok(()) = primitives::Triangle::new(corners[0], corners[1], corners[2]).into_styled(fill).draw(record);
        });
        let twice = f64::from((to_x - x) * (20 - y) - (20 - x) * (to_y - y)).abs();
        prop_assert!((light(&triangle) - twice / 2.0).abs() <= 0.01);
    }
}

/// The box of a style holds what is drawn.
fn is_in_box<S>(shape: &S, style: AntialiasedStyle<Gray8>)
where
    S: Outline + StyledDimensions<AntialiasedStyle<Gray8>>,
{
    let bounds = shape.styled_bounding_box(&style);
    // What the style draws, with memory enough for it.
    let mut sink = SpanFn::new(Rect::of_size(SIZE), |row: i32, columns: std::ops::Range<i32>, covered: Covered<'_>| {
        for (offset, column) in columns.enumerate() {
            let is_drawn = covered.at(offset) != Coverage::NONE;
            assert!(!is_drawn || bounds.contains(Point::new(column, row)), "{column}, {row} is outside of {bounds:?}");
        }
    });
    let (mut edges, mut cells) = (List::<AreaEdge, 4096>::new(), [Coverage::NONE; 64]);
    if style.fill_color.is_some() {
        let Ok(()) = fill(shape, style.rule, Scratch { edges: &mut edges, cells: &mut cells }, &mut sink);
    }
    if style.stroke_color.is_some() {
        let stroked = Stroked::new(shape, style.stroke);
        let Ok(()) = fill(&stroked, Rule::NonZero, Scratch { edges: &mut edges, cells: &mut cells }, &mut sink);
    }
}

fn style() -> impl Strategy<Value = AntialiasedStyle<Gray8>> {
    let joins = select(vec![Join::Miter { limit: 4 }, Join::Miter { limit: 20 }, Join::Round, Join::Bevel]);
    let caps = select(vec![Cap::Butt, Cap::Round, Cap::Square]);
    (joins, caps, -3..200_i32, any::<bool>(), any::<bool>()).prop_map(|(join, cap, width, is_filled, is_stroked)| {
        let stroke = Stroke::of_width(Subpixel::from_bits(width)).with_join(join).with_cap(cap);
        let style = AntialiasedStyle::stroke(Gray8::WHITE, 1).with_shape(stroke);
        AntialiasedStyle {
            fill_color: is_filled.then_some(Gray8::WHITE),
            stroke_color: style.stroke_color.filter(|_| is_stroked),
            ..style
        }
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn boxes_hold_what_is_drawn(
        style in style(), points in uniform4((-100..700_i32, -100..700_i32)), radii in (0..300_i32, 0..300_i32), start: u16,
        sweep in -70_000..70_000_i32, map in uniform4(-100_000..100_000_i32),
    ) {
        let points = points.map(|(x, y)| Point2::from_sixteenths(x, y));
        // What has no inside.
        let line = AntialiasedStyle { fill_color: None, ..style };
        let contours = [&points[..]];
        let oval = Oval::new(points[0], [radii.0, radii.1].map(Subpixel::from_bits)).expect("in range");
        let arc = Arc::new(oval, Angle(start), sweep);
        let segments = [Segment::MoveTo(points[0]), Segment::CubicTo(points[1], points[2], points[3]), Segment::Close];
        let path = Path::new(&segments).expect("in range");
        is_in_box(&Polygon::new(&contours).expect("in range"), style);
        is_in_box(&Polyline::new(&points).expect("in range"), line);
        is_in_box(&path, style);
        is_in_box(&oval, style);
        is_in_box(&arc, line);
        is_in_box(&Chord(arc), style);
        is_in_box(&Sector(arc), style);
        is_in_box(&RoundedRectangle::new([points[0], points[1]], Subpixel::from_bits(radii.0)).expect("in range"), style);
        let [a, b, c, d] = map.map(Scalar::from_bits);
        is_in_box(&Placed::new(path, Affine::new([a, b], [c, d], points[2])), style);
        let lengths = [radii.0, radii.1].map(Subpixel::from_bits);
        is_in_box(&Dashed::new(path, &lengths, Subpixel::ZERO), line);
        is_in_box(&Text::new(&Hershey::SIMPLEX, "Ag,\n@", Subpixel::from_bits(radii.0), points[0]), style);
    }

}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1_000))]

    #[test]
    fn any_numbers_are_drawn_without_a_panic(
        style in style(), numbers in prop::array::uniform6(number()), sizes in uniform4(prop_oneof![0..50_u32, any::<u32>(), select(vec![u32::MAX, 1 << 31, 1 << 22])]),
    ) {
        let [x, y, to_x, to_y, other_x, other_y] = numbers;
        let (at, to, other) = (Point::new(x, y), Point::new(to_x, to_y), Point::new(other_x, other_y));
        let (size, radii) = (Size::new(sizes[0], sizes[1]), Size::new(sizes[2], sizes[3]));
        let mut frame = Frame::<Gray8, Rows, _>::with_array([0; 48], 8, 6).expect("memory enough");
        let mut target = Blended::new(&mut frame);
        let Ok(()) = Line::new(at, to).into_styled(style).draw(&mut target);
        let Ok(()) = Circle::new(at, sizes[0]).into_styled(style).draw(&mut target);
        let Ok(()) = Ellipse::new(at, size).into_styled(style).draw(&mut target);
        let Ok(()) = primitives::Line::new(at, to).into_styled(style).draw(&mut target);
        let Ok(()) = primitives::Circle::new(at, sizes[0]).into_styled(style).draw(&mut target);
        let Ok(()) = primitives::Ellipse::new(at, size).into_styled(style).draw(&mut target);
        let Ok(()) = primitives::Triangle::new(at, to, other).into_styled(style).draw(&mut target);
        let Ok(()) = primitives::Polyline::new(&[at, to, other]).into_styled(style).draw(&mut target);
        let ends = [at, to];
        let moved = primitives::Polyline { translate: other, ..primitives::Polyline::new(&ends) };
        let Ok(()) = moved.into_styled(style).draw(&mut target);
        let area = Rectangle::new(at, size);
        let Ok(()) = area.into_styled(style).draw(&mut target);
        let Ok(()) = primitives::RoundedRectangle::with_equal_corners(area, radii).into_styled(style).draw(&mut target);
        // What a target is told by others.
        let glass = Alpha::new(Gray8::new(99), Coverage::new(9999));
        let Ok(()) = target.fill_solid(&area, glass);
        let Ok(()) = target.fill_contiguous(&area, std::iter::repeat_n(glass, 5000));
        let Ok(()) = target.draw_iter([Pixel(at, glass), Pixel(to, glass)]);
        // Ours.
        let [a, b, c] = [(x, y), (to_x, to_y), (other_x, other_y)].map(|(x, y)| Point2::from_sixteenths(x, y));
        let text = Text::new(&Hershey::SIMPLEX, "Ag", Subpixel::from_bits(other_x), a);
        let Ok(()) = text.into_styled(style).draw(&mut target);
        let _ = text.into_styled(style).bounding_box();
        if let Ok(oval) = Oval::new(a, [b.x, b.y]) {
            let Ok(()) = oval.into_styled(style).draw(&mut target);
            let _ = oval.into_styled(style).bounding_box();
            let Ok(()) = Sector(Arc::new(oval, Angle(17), other_y)).into_styled(style).draw(&mut target);
        }
        let corners = [a, b, c];
        if let Ok(polyline) = Polyline::closed(&corners) {
            let Ok(()) = polyline.into_styled(style).draw(&mut target);
            let _ = polyline.into_styled(style).bounding_box();
            let lengths = [b.x, c.y];
            let Ok(()) = Dashed::new(polyline, &lengths, c.x).into_styled(style).draw(&mut target);
        }
    }
}

/// Any number, and the ends of all ranges.
fn number() -> impl Strategy<Value = i32> {
    let ends = vec![i32::MIN, i32::MAX, 1 << 22, (1 << 22) - 1, -(1 << 22), 1 << 26, (1 << 26) - 1, 1 - (1 << 26), 0];
    prop_oneof![-60..100_i32, any::<i32>(), select(ends)]
}

#[test]
fn a_far_line_crosses_the_picture_where_it_should() {
    // From end to end of all coordinates, through the middle of the picture. The border of what is that far is on
    // sixteenths of a pixel: the line is 1.06 pixels wide.
    let mut frame = Frame::<Gray4, Rows, _>::with_array([0; 800], 40, 40).expect("memory enough");
    let far = 2_000_000_000;
    let line = primitives::Line::new(Point::new(20 - far, 20 - far), Point::new(20 + far, 20 + far));
    let Ok(()) = line.into_styled(AntialiasedStyle::stroke(Gray4::WHITE, 1)).draw(&mut Blended::new(&mut frame));
    for at in 0..40 {
        let expected = [(-2, 0), (-1, 8), (0, 15), (1, 8), (2, 0)];
        for (by, code) in expected {
            let color = frame.pixel(Point::new(at + by, at));
            assert!(color.is_none_or(|color| color.luma() == code), "{at} {by}: {color:?}");
        }
    }
}
