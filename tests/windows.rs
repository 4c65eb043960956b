//! Bands, parts and turned displays show what the whole, upright frame shows.

use core::convert::Infallible;

use aquatint::{
    Alpha, Blended, Code, Columns, Coverage, Dithered, FillStyle, Frame, Inverted, Levels, Light, Line, Pages, Planes,
    Point2, Polygon, Rect, Rows, StrokeStyle, Target, Turn, Turned, Window, display::layout::Layout,
};
use embedded_graphics::{
    image::GetPixel,
    mono_font::{MonoTextStyle, ascii::FONT_6X10},
    pixelcolor::{BinaryColor, Gray2, Gray4},
    prelude::*,
    primitives::{Circle, PrimitiveStyle, Rectangle},
    text::Text,
};
use proptest::prelude::*;

const WIDTH: u32 = 45;
const HEIGHT: u32 = 37;

/// Shapes of ours and of embedded-graphics.
fn draw_shapes<D: DrawTarget<Error = Infallible>>(target: &mut D, on: D::Color) {
    let star = [(20, 1), (30, 35), (3, 13), (41, 12), (9, 36)].map(|(x, y)| Point2::corner(x, y));
    let Ok(()) = Polygon::new(&[&star]).expect("in range").into_styled(FillStyle::new(on)).draw(target);
    let line = Line::new(Point::new(-300, 90), Point::new(70, -5));
    let Ok(()) = line.into_styled(StrokeStyle::new(on)).draw(target);
    let Ok(()) = Circle::new(Point::new(22, 18), 20).into_styled(PrimitiveStyle::with_stroke(on, 3)).draw(target);
    let Ok(_) = Text::new("tint", Point::new(18, 9), MonoTextStyle::new(&FONT_6X10, on)).draw(target);
    let area = Rectangle::new(Point::new(-5, 30), Size::new(20, 40));
    let Ok(()) = target.fill_contiguous(&area, core::iter::repeat(on));
}

/// Dithered light: runs of one shade, and a ramp with holes.
fn draw_tones<T: Target<Error = Infallible>>(target: &mut T, levels: Levels)
where
    T::Color: Code,
{
    let mut light = Dithered::new(target, levels);
    for row in 0..20_u16 {
        let Ok(()) = light.fill_run(row.into(), i32::from(row) - 9..30, [Light(3000 * row)]);
        let ramp = (0..50_u16).map(|at| (at % 7 != 0).then_some(Light(at * 1300)));
        let Ok(()) = light.write_run(i32::from(row) + 17, -3..47, ramp);
    }
}

/// The whole picture on a frame of its own.
fn whole<C: Code, L: Layout<C>>(levels: Levels) -> Frame<C, L, Vec<u8>> {
    let bytes = vec![0; Frame::<C, L, ()>::bytes_needed(WIDTH, HEIGHT)];
    let mut frame = Frame::new(bytes, WIDTH, HEIGHT).expect("large enough");
    draw_tones(&mut frame, levels);
    draw_shapes(&mut frame, C::from_code(u8::MAX));
    frame
}

fn codes<C: Code>(target: &impl GetPixel<Color = C>, width: i32, rows: core::ops::Range<i32>) -> Vec<Option<u8>> {
    let places = rows.flat_map(|y| (0..width).map(move |x| Point::new(x, y)));
    places.map(|place| target.pixel(place).map(Code::code)).collect()
}

fn bands_make_the_picture<C: Code, L: Layout<C>>(levels: Levels) {
    let whole = whole::<C, L>(levels);
    for height in [1, 5, 8, 16, HEIGHT] {
        let mut bytes = vec![0; Frame::<C, L, ()>::bytes_needed(WIDTH, height)];
        for top in (0..HEIGHT.cast_signed()).step_by(height as usize) {
            bytes.fill(0);
            let mut frame = Frame::<C, L, _>::new(&mut bytes[..], WIDTH, height).expect("large enough");
            let mut band = Window::band(&mut frame, top);
            draw_tones(&mut band, levels);
            draw_shapes(&mut band, C::from_code(u8::MAX));
            let rows = top..(top + height.cast_signed()).min(HEIGHT.cast_signed());
            let expected = codes(&whole, 45, rows.clone());
            assert_eq!(codes(&band, 45, rows.clone()), expected, "band of {height} at {top}");
            assert_eq!(codes(&frame, 45, rows.start - top..rows.end - top), expected);
        }
    }
}

#[test]
fn bands_of_every_layout_make_the_picture() {
    bands_make_the_picture::<BinaryColor, Rows>(Levels::ONE_BIT);
    bands_make_the_picture::<BinaryColor, Pages>(Levels::ONE_BIT);
    bands_make_the_picture::<BinaryColor, Inverted<Columns>>(Levels::ONE_BIT);
    bands_make_the_picture::<Gray2, Planes>(Levels::new(&[0, 9000, 30_000, 65_535]).expect("rising"));
    bands_make_the_picture::<Gray4, Rows>(Levels::LINEAR_16);
}

#[test]
fn bands_of_whole_pages_have_the_bytes_of_the_picture() {
    let whole = whole::<BinaryColor, Pages>(Levels::ONE_BIT);
    for (page, expected) in whole.lines().enumerate() {
        let mut frame = Frame::<BinaryColor, Pages, _>::with_array([0; 45], WIDTH, 8).expect("large enough");
        let mut band = Window::band(&mut frame, i32::try_from(8 * page).expect("few"));
        draw_tones(&mut band, Levels::ONE_BIT);
        draw_shapes(&mut band, BinaryColor::On);
        // The last page reaches below the picture.
        let rows = if page == 4 { 0b1_1111 } else { 0xFF };
        let (got, expected) = (frame.bytes().iter(), expected.iter());
        assert!(got.map(|byte| byte & rows).eq(expected.map(|byte| byte & rows)), "page {page}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn a_part_is_drawn_on_as_a_frame_of_its_own(left in -50..50_i32, top in -45..45_i32, width in 0..60_i32, height in 0..50_i32) {
        let (mut frame, mut alone) = (whole::<Gray4, Rows>(Levels::LINEAR_16), whole::<Gray4, Rows>(Levels::LINEAR_16));
        let before = whole::<Gray4, Rows>(Levels::LINEAR_16);
        let area = Rect::new(left, top, left + width, top + height);
        let mut part = Window::part(&mut frame, area);
        draw_tones(&mut part, Levels::LINEAR_16);
        draw_shapes(&mut part, Gray4::new(5));
        let Ok(()) = alone.clear(Gray4::new(0));
        // The same drawing on an empty frame, to see which pixels it leaves alone.
        draw_tones(&mut alone, Levels::LINEAR_16);
        draw_shapes(&mut alone, Gray4::new(5));
        for (x, y) in (0..37).flat_map(|y| (0..45).map(move |x| (x, y))) {
            let got = frame.pixel(Point::new(x, y));
            if !(area.columns().contains(&x) && area.rows().contains(&y)) {
                prop_assert_eq!(got, before.pixel(Point::new(x, y)), "{}, {} is outside", x, y);
            } else if let Some(color) = alone.pixel(Point::new(x - left, y - top)).filter(|color| color.luma() > 0) {
                prop_assert_eq!(got, Some(color), "{}, {}", x, y);
            }
        }
    }

    #[test]
    fn extremes_of_windows_and_turns_do_not_panic(x in any::<i32>(), y in any::<i32>(), width in any::<u32>(), top in any::<i32>()) {
        let mut frame = whole::<BinaryColor, Pages>(Levels::ONE_BIT);
        let area = Rectangle::new(Point::new(x, y), Size::new(width, width));
        let mut band = Window::band(&mut frame, top);
        let Ok(()) = band.fill_solid(&area, BinaryColor::On);
        let Ok(()) = band.draw_iter([Pixel(Point::new(x, y), BinaryColor::On)]);
        let Ok(()) = band.fill_run(y, x..top, [BinaryColor::On; 4]);
        prop_assert!(band.pixel(Point::new(x, y)).is_none() || y >= top);
        let mut part = Window::part(&mut frame, Rect::from(area));
        let Ok(()) = part.fill_run(y, x..top, [BinaryColor::Off; 1]);
        for turn in TURNS {
            let mut turned = Turned::new(&mut frame, turn);
            let Ok(()) = turned.fill_solid(&area, BinaryColor::Off);
            let Ok(()) = turned.draw_iter([Pixel(Point::new(x, y), BinaryColor::On)]);
            let Ok(()) = turned.fill_run(y, x..top, [BinaryColor::On, BinaryColor::Off, BinaryColor::On, BinaryColor::On]);
            let _ = turned.pixel(Point::new(x, y));
        }
    }
}

const TURNS: [Turn; 5] =
    [Turn::Clockwise, Turn::Half, Turn::CounterClockwise, Turn::MirroredLeftRight, Turn::MirroredTopBottom];

/// Where a pixel of the upright picture of 45 × 37 is on the display.
fn turned_place(turn: Turn, (x, y): (i32, i32)) -> Point {
    match turn {
        Turn::Clockwise => Point::new(36 - y, x),
        Turn::Half => Point::new(44 - x, 36 - y),
        Turn::CounterClockwise => Point::new(y, 44 - x),
        Turn::MirroredLeftRight => Point::new(44 - x, y),
        Turn::MirroredTopBottom => Point::new(x, 36 - y),
    }
}

#[test]
fn a_turned_display_shows_the_upright_picture_turned() {
    let upright = whole::<BinaryColor, Rows>(Levels::ONE_BIT);
    for turn in TURNS {
        let is_quarter = matches!(turn, Turn::Clockwise | Turn::CounterClockwise);
        let (width, height) = if is_quarter { (HEIGHT, WIDTH) } else { (WIDTH, HEIGHT) };
        let bytes = vec![0; Frame::<BinaryColor, Pages, ()>::bytes_needed(width, height)];
        let mut frame = Frame::<BinaryColor, Pages, _>::new(bytes, width, height).expect("large enough");
        let mut turned = Turned::new(&mut frame, turn);
        assert_eq!(turned.size(), Size::new(WIDTH, HEIGHT));
        draw_tones(&mut turned, Levels::ONE_BIT);
        draw_shapes(&mut turned, BinaryColor::On);
        assert_eq!(codes(&turned, 45, 0..37), codes(&upright, 45, 0..37), "{turn:?}");
        for (x, y) in (0..37).flat_map(|y| (0..45).map(move |x| (x, y))) {
            let (here, there) = (upright.pixel(Point::new(x, y)), frame.pixel(turned_place(turn, (x, y))));
            assert_eq!(there, here, "{turn:?}: {x}, {y}");
        }
    }
}

/// A walk over all of its columns would take minutes.
#[test]
fn a_turned_display_takes_the_longest_run() {
    for turn in [Turn::Clockwise, Turn::Half, Turn::CounterClockwise] {
        let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 3], 8, 3).expect("room");
        let mut turned = Turned::new(&mut frame, turn);
        let Ok(()) = turned.write_run(1, i32::MIN..i32::MAX, core::iter::repeat(Some(BinaryColor::On)));
        let (width, seen) = (turned.size().width, turned.bounds().width());
        assert_eq!(width, seen);
        let on: u32 = frame.bytes().iter().map(|byte| byte.count_ones()).sum();
        assert_eq!(on, width, "{turn:?}");
    }
}

/// No columns, two thousand million rows.
#[test]
fn rows_without_columns_are_not_walked() {
    let mut frame = Frame::<Gray4, Rows, _>::with_array([0; 0], 0, u32::MAX).expect("no byte is needed");
    let area = Rectangle::new(Point::zero(), Size::new(5, u32::MAX));
    let Ok(()) = Blended::new(&mut frame).fill_solid(&area, Alpha::new(Gray4::WHITE, Coverage::FULL));
    assert!(Rect::new(3, 0, 3, 9).intersection(Rect::new(0, -5, 9, 90)).rows().is_empty());
    assert_eq!(Rect::new(0, 0, 9, 9).intersection(Rect::new(2, 3, 5, 90)), Rect::new(2, 3, 5, 9));
}
