//! How the ways grow: instructions against triangles and against pixels, both by powers of two.

use std::convert::Infallible;

use aquatint::{Line, StrokeStyle};
use embedded_graphics::{
    mono_font::{MonoTextStyle, ascii::FONT_5X8},
    pixelcolor::Gray4,
    prelude::*,
    primitives::{PrimitiveStyle, Rectangle},
    text::{Alignment, Text},
};

use super::{Screen, counted::instructions};

pub const HEIGHT: u32 = 190;

/// The area of the axes.
const AXES: Size = Size::new(150, 150);
/// From 2¹⁵ to 2³¹ instructions.
const LEAST: f64 = 15.0;
const MOST: f64 = 31.0;

/// Benches and what they are called.
const LINES: [(&str, &str); 7] = [
    ("grow_depth", "depth buffer"),
    ("grow_scanline", "scanline"),
    ("grow_tree", "BSP tree"),
    ("grow_object", "object space"),
    ("grow_sort", "depth sort"),
    ("grow_rays", "rays, boxes"),
    ("grow_list", "rays, list"),
];

/// What is counted along an axis: the panels of the benches and the numbers below.
struct Axis {
    title: &'static str,
    panels: &'static [(&'static str, &'static str)],
}

const TRIANGLES: Axis = Axis {
    title: "triangles, on 128 x 64",
    panels: &[("k8", "8"), ("k16", ""), ("k32", "32"), ("k64", ""), ("k128", "128"), ("k256", ""), ("k512", "512")],
};
const PIXELS: Axis = Axis {
    title: "pixels, 64 triangles",
    panels: &[("p64x32", "64x32"), ("p128x64", "128x64"), ("p256x128", "256x128"), ("p512x256", "512x256")],
};

/// Both plots, side by side.
pub fn both(screen: &mut Screen, place: Point) -> Result<(), Infallible> {
    one(screen, place + Point::new(36, 10), &TRIANGLES)?;
    one(screen, place + Point::new(305, 10), &PIXELS)
}

fn one(screen: &mut Screen, place: Point, axis: &Axis) -> Result<(), Infallible> {
    let faint = Gray4::new(4);
    Rectangle::new(place, AXES).into_styled(PrimitiveStyle::with_stroke(faint, 1)).draw(screen)?;
    for (power, name) in [(16.0, "64 k"), (20.0, "1 M"), (24.0, "16 M"), (28.0, "256 M")] {
        let left = Point::new(place.x, place.y + height(power));
        Line::new(left, left + Point::new(AXES.width.cast_signed() - 1, 0))
            .into_styled(StrokeStyle::new(faint))
            .draw(screen)?;
        write(screen, name, left + Point::new(-3, 2), Alignment::Right)?;
    }
    let below = place + Size::new(0, AXES.height + 9);
    for (number, (_, name)) in axis.panels.iter().enumerate() {
        write(screen, name, below + Point::new(along(axis, number), 0), Alignment::Center)?;
    }
    write(screen, axis.title, below + Point::new(75, 10), Alignment::Center)?;
    let mut ends = vec![];
    for (item, name) in LINES {
        let counts = axis.panels.iter().map(|(panel, _)| instructions(item, panel)).enumerate();
        let points: Vec<Point> =
            counts.filter_map(|(at, count)| Some(place + Point::new(along(axis, at), height(log2(count?))))).collect();
        curve(screen, &points)?;
        ends.extend(points.last().map(|last| (last.y, name)));
    }
    // Names below each other, where lines end close together.
    ends.sort_unstable();
    let mut free = i32::MIN;
    for (row, name) in ends {
        free = row.max(free);
        write(screen, name, Point::new(place.x + AXES.width.cast_signed() + 2, free + 2), Alignment::Left)?;
        free += 8;
    }
    Ok(())
}

fn curve(screen: &mut Screen, points: &[Point]) -> Result<(), Infallible> {
    for pair in points.windows(2) {
        Line::new(pair[0], pair[1]).into_styled(StrokeStyle::new(Gray4::WHITE)).draw(screen)?;
    }
    points.iter().try_for_each(|point| {
        let mark = Rectangle::with_center(*point, Size::new(3, 3));
        mark.into_styled(PrimitiveStyle::with_fill(Gray4::WHITE)).draw(screen)
    })
}

#[expect(clippy::cast_precision_loss, reason = "for a plot")]
fn log2(count: u64) -> f64 {
    (count as f64).log2()
}

/// Rows below the upper end of the axes.
#[expect(clippy::cast_possible_truncation, reason = "on the screen")]
fn height(power: f64) -> i32 {
    ((MOST - power) / (MOST - LEAST) * f64::from(AXES.height)).round() as i32
}

/// Columns right of the left end.
fn along(axis: &Axis, number: usize) -> i32 {
    let (number, last) = (number.min(8), axis.panels.len().max(2) - 1);
    10 + 130 * i32::try_from(number).unwrap_or(0) / i32::try_from(last).unwrap_or(1)
}

fn write(screen: &mut Screen, text: &str, at: Point, alignment: Alignment) -> Result<(), Infallible> {
    let style = MonoTextStyle::new(&FONT_5X8, Gray4::new(11));
    Text::with_alignment(text, at, style, alignment).draw(screen).map(|_| ())
}
