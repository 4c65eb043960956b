//! What can be drawn on one bit a pixel in two dimensions, as one picture.
//!
//! `cargo run --release --example shapes` writes `target/shapes.png`; a file may be named.
#![cfg(not(target_os = "none"))]

use std::{convert::Infallible, path::PathBuf, process::ExitCode};

use aquatint::{
    Affine, Angle, Arc, Brush, Cap, Circle, Dashed, Dithered, Ellipse, FillStyle, Flood, Frame, Ink, Join, Levels,
    Light, Line, LinearGradient, Outline, Oval, Path, Pattern, Placed, Point2, Polygon, Polyline, RadialGradient,
    RoundedRectangle, Rows, Rule, Sector, Segment, Stipple, Stroke, StrokeStyle, Subpixel, Target,
    fragment::{gradient::between, pattern::hatch},
    raster::{
        flood::{Run, words_needed},
        scan::{ActiveEdge, fill},
    },
};
use aquatint_simulator::{Packing, Panel, Zoom, save_png};
use clap::Parser;
use embedded_graphics::{pixelcolor::BinaryColor, prelude::*};
use heapless::Vec as List;

const WIDTH: u32 = 256;
const HEIGHT: u32 = 128;

type Screen = Frame<BinaryColor, Rows, [u8; 4096]>;

/// Draws shapes, strokes, patterns and gradients on a simulated panel.
#[derive(Parser)]
struct Options {
    /// Where to write the picture
    #[arg(default_value = "target/shapes.png")]
    out: PathBuf,
}

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("shapes: {error}");
            ExitCode::from(2)
        }
    }
}

fn run(options: &Options) -> Result<(), String> {
    let mut screen = Screen::with_array([0; 4096], WIDTH, HEIGHT).map_err(|e| e.to_string())?;
    let Ok(()) = draw(&mut screen);
    let panel = Panel { width: WIDTH, height: HEIGHT, packing: Packing::RowsMsbFirst, ..Panel::SSD1306_128X64 };
    let picture = panel.render(screen.bytes(), Zoom { scale: 3, gap: 0 }).map_err(|e| e.to_string())?;
    save_png(&picture, &options.out).map_err(|e| e.to_string())
}

fn draw(screen: &mut Screen) -> Result<(), Infallible> {
    joins_and_caps(screen)?;
    dashes(screen)?;
    curves(screen)?;
    rules(screen)?;
    inks(screen)?;
    flooded(screen)
}

fn at(x: i32, y: i32) -> Point2 {
    Point2::corner(x, y)
}

/// A pen stroke for each join and each cap.
fn joins_and_caps(screen: &mut Screen) -> Result<(), Infallible> {
    let styles = [(Join::Miter { limit: 4 }, Cap::Butt), (Join::Round, Cap::Round), (Join::Bevel, Cap::Square)];
    for (left, (join, cap)) in (0..).step_by(34).zip(styles) {
        let points = [at(left + 6, 26), at(left + 18, 8), at(left + 30, 26)];
        let stroke = Stroke::new(7).with_join(join).with_cap(cap);
        let Ok(polyline) = Polyline::new(&points) else { continue };
        polyline.into_styled(StrokeStyle::new(BinaryColor::On).with_stroke(stroke)).draw(screen)?;
        polyline.into_styled(StrokeStyle::new(BinaryColor::Off)).draw(screen)?;
    }
    for (top, width) in [(5, 1), (10, 2), (16, 3), (24, 5)] {
        let line = Line::new(Point::new(108, top + 5), Point::new(146, top - 3));
        line.into_styled(StrokeStyle::new(BinaryColor::On).with_width(width)).draw(screen)?;
    }
    Ok(())
}

fn dashes(screen: &mut Screen) -> Result<(), Infallible> {
    let lengths = [6, 4, 1, 4].map(Subpixel::from_num);
    let Ok(oval) = Oval::new(at(178, 17), [24, 14].map(Subpixel::from_num)) else { return Ok(()) };
    let stroke = Stroke::new(3).with_cap(Cap::Round);
    let dashed = Dashed::new(oval, &lengths, Subpixel::ZERO);
    dashed.into_styled(StrokeStyle::new(BinaryColor::On).with_stroke(stroke)).draw(screen)?;
    for (row, pattern) in (4..).step_by(5).zip([0xAAAA, 0xCCCC, 0xF0F0, 0xFF18, 0xFF66]) {
        let line = Line::new(Point::new(210, row), Point::new(250, row + 6));
        Stipple::new(pattern).along(line).into_styled(StrokeStyle::new(BinaryColor::On)).draw(screen)?;
    }
    Ok(())
}

/// A heart of two cubics, pies, a turned rounded rectangle, whole-pixel circles.
fn curves(screen: &mut Screen) -> Result<(), Infallible> {
    let heart = [
        Segment::MoveTo(at(22, 78)),
        Segment::CubicTo(at(-8, 58), at(8, 28), at(22, 46)),
        Segment::CubicTo(at(36, 28), at(52, 58), at(22, 78)),
        Segment::Close,
    ];
    let on = FillStyle::new(BinaryColor::On);
    if let Ok(heart) = Path::new(&heart) {
        heart.into_styled(on).draw(screen)?;
    }
    if let Ok(pie) = Oval::circle(at(66, 58), Subpixel::from_num(18)) {
        for (start, sweep) in [(0, 20_000), (21_500, 14_000), (37_000, 27_000)] {
            Sector(Arc::new(pie, Angle(start), sweep)).into_styled(on).draw(screen)?;
        }
    }
    if let Ok(card) = RoundedRectangle::new([at(92, 44), at(126, 72)], Subpixel::from_num(8)) {
        let turned = Placed::new(card, Affine::turn(Angle(3600)).about(at(109, 58)));
        turned.into_styled(StrokeStyle::new(BinaryColor::On).with_width(3)).draw(screen)?;
    }
    Circle::new(Point::new(132, 42), 33).into_styled(StrokeStyle::new(BinaryColor::On)).draw(screen)?;
    Circle::new(Point::new(138, 48), 21).into_styled(on).draw(screen)?;
    Ellipse::new(Point::new(168, 42), Size::new(20, 33))
        .into_styled(StrokeStyle::new(BinaryColor::On).with_width(3))
        .draw(screen)
}

/// One star, both fill rules.
fn rules(screen: &mut Screen) -> Result<(), Infallible> {
    for (left, rule) in [(192, Rule::NonZero), (222, Rule::EvenOdd)] {
        let star = [(16, 0), (25, 32), (0, 12), (32, 12), (7, 32)].map(|(x, y)| at(left + x, 42 + y));
        let contours = [&star[..]];
        if let Ok(star) = Polygon::new(&contours) {
            star.into_styled(FillStyle::new(BinaryColor::On).with_rule(rule)).draw(screen)?;
        }
    }
    Ok(())
}

/// Hatches, and gradients in dithered light, in rounded boxes.
fn inks(screen: &mut Screen) -> Result<(), Infallible> {
    let (on, off) = (BinaryColor::On, BinaryColor::Off);
    boxed(screen, 2, Pattern::from_bits(hatch::DIAGONAL, on, off))?;
    boxed(screen, 36, Pattern::from_bits(hatch::BRICKS, on, off))?;
    boxed(screen, 70, Pattern::from_bits(hatch::DOTS, on, off))?;
    let mut light = Dithered::new(screen, Levels::ONE_BIT);
    boxed(&mut light, 104, LinearGradient::new(at(104, 84), at(134, 124), between(Light::BLACK, Light::WHITE)))?;
    boxed(&mut light, 138, RadialGradient::new(at(148, 96), 26 * 16, between(Light::WHITE, Light::BLACK)))
}

fn boxed<I: Ink>(
    target: &mut impl Target<Color = I::Color, Error = Infallible>,
    left: i32,
    ink: I,
) -> Result<(), Infallible> {
    let corners = [at(left, 84), at(left + 30, 124)];
    let Ok(shape) = RoundedRectangle::new(corners, Subpixel::from_num(6)) else { return Ok(()) };
    paint(&shape, target, ink)
}

/// Any outline, any target, any ink.
fn paint<I: Ink>(
    outline: &impl Outline,
    target: &mut impl Target<Color = I::Color, Error = Infallible>,
    ink: I,
) -> Result<(), Infallible> {
    fill(outline, Rule::NonZero, &mut List::<ActiveEdge, 16>::new(), &mut Brush::new(target, ink))
}

/// The space between two ovals, flooded with a pattern.
fn flooded(screen: &mut Screen) -> Result<(), Infallible> {
    for (width, height) in [(72, 42), (36, 24)] {
        let ring = Ellipse::with_center(Point::new(212, 104), Size::new(width, height));
        ring.into_styled(StrokeStyle::new(BinaryColor::On).with_width(2)).draw(screen)?;
    }
    let (mut memory, mut queue) = ([0; words_needed(WIDTH, HEIGHT)], [Run::default(); 8]);
    let weave = Pattern::from_bits(hatch::DIAGONAL_CROSS, BinaryColor::On, BinaryColor::Off);
    // Nothing can be refused: the bitmap is as large as the screen.
    let _ = Flood::new(&mut memory, &mut queue).fill_with(screen, Point::new(184, 104), weave);
    Ok(())
}
