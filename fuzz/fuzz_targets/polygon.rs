//! Every pixel of a polygon agrees with the winding number at its centre, by both rules.
#![no_main]

#[path = "../../tests/exact/mod.rs"]
mod exact;

use std::convert::Infallible;

use aquatint::{FillStyle, Point2, Polygon, Rect, Rule};
use arbitrary::Arbitrary;
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::Dimensions,
    pixelcolor::BinaryColor,
    prelude::{Drawable, Primitive},
    primitives::Rectangle,
};
use libfuzzer_sys::fuzz_target;

/// Coordinates near the window, or as far away as is accepted and a little more.
#[derive(Arbitrary, Debug)]
enum Coordinate {
    Near(i16),
    Center(i8),
    Far(i32),
}

#[derive(Arbitrary, Debug)]
struct Input {
    contours: Vec<Vec<(Coordinate, Coordinate)>>,
    corner: (i8, i8),
    size: (u8, u8),
}

struct Canvas(exact::Overdraw);

impl Dimensions for Canvas {
    fn bounding_box(&self) -> Rectangle {
        self.0.window().into()
    }
}

impl DrawTarget for Canvas {
    type Color = BinaryColor;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<BinaryColor>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        pixels.into_iter().for_each(|Pixel(at, _)| self.0.add(at.y, at.x..at.x + 1));
        Ok(())
    }
}

fn sixteenths(coordinate: &Coordinate) -> i32 {
    match *coordinate {
        Coordinate::Near(value) => i32::from(value % 600),
        Coordinate::Center(pixel) => i32::from(pixel % 40) * 16 + 8,
        Coordinate::Far(value) => value % ((1 << 26) + 1),
    }
}

fuzz_target!(|input: Input| {
    let contours: Vec<Vec<Point2>> = input
        .contours
        .iter()
        .take(4)
        .map(|contour| {
            contour.iter().take(20).map(|(x, y)| Point2::from_sixteenths(sixteenths(x), sixteenths(y))).collect()
        })
        .collect();
    let borrowed: Vec<&[Point2]> = contours.iter().map(Vec::as_slice).collect();
    let is_far = |v: &Point2| v.x.to_bits().unsigned_abs() >= 1 << 26 || v.y.to_bits().unsigned_abs() >= 1 << 26;
    let Ok(polygon) = Polygon::new(&borrowed) else {
        assert!(contours.iter().flatten().any(is_far));
        return;
    };
    let (left, top) = (i32::from(input.corner.0 % 30), i32::from(input.corner.1 % 30));
    let window = Rect::new(left, top, left + i32::from(input.size.0 % 25), top + i32::from(input.size.1 % 25));
    for rule in [Rule::NonZero, Rule::EvenOdd] {
        let mut canvas = Canvas(exact::Overdraw::new(window));
        let Ok(()) = polygon.into_styled(FillStyle::new(BinaryColor::On).with_rule(rule)).draw(&mut canvas);
        for (x, y) in canvas.0.places() {
            assert_eq!(canvas.0.count(x, y), u32::from(exact::is_inside(&contours, rule, (x, y))), "{rule:?} {x}, {y}");
        }
    }
});
