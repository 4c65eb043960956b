//! Soft borders on four, two and one bits a pixel, blending, and scalable text, as one picture.
//!
//! `cargo run --release --example antialiasing` writes `target/antialiasing.png`; a file may be named.
#![cfg(not(target_os = "none"))]

use std::{convert::Infallible, path::PathBuf, process::ExitCode};

use aquatint::{
    Affine, Angle, AntialiasedStyle, BlendMode, Blended, Coverage, Dithered, Frame, Hershey, Levels, Light, Oval,
    Point2, Polyline, RadialGradient, Rows, Rule, Scalar, Stroke, Subpixel, SvgPath, Text, TrueType, Words,
    fragment::gradient::between,
    raster::area::{AreaEdge, Scratch, fill},
};
use aquatint_simulator::{Packing, Panel, Zoom, save_png};
use clap::Parser;
use embedded_graphics::{
    image::GetPixel,
    pixelcolor::{BinaryColor, Gray2, Gray4},
    prelude::*,
    primitives::{Circle, Line, PrimitiveStyle, Rectangle, RoundedRectangle, Triangle},
};
use heapless::Vec as List;

const WIDTH: u32 = 256;
const HEIGHT: u32 = 160;
const STRIP: u32 = 24;

type Screen = Frame<Gray4, Rows, Vec<u8>>;

/// An icon of 24 units, checked while compiling.
static HEART: SvgPath = match SvgPath::new(
    "M12 21.35l-1.45-1.32C5.4 15.36 2 12.28 2 8.5 2 5.42 4.42 3 7.5 3c1.74 0 3.41.81 4.5 2.09C13.09 3.81 14.76 3 16.5 3 \
     19.58 3 22 5.42 22 8.5c0 3.78-3.4 6.86-8.55 11.54L12 21.35z",
) {
    Ok(path) => path,
    Err(_) => panic!("no path data"),
};

/// Draws shapes and text with soft borders on a simulated panel.
#[derive(Parser)]
struct Options {
    /// Where to write the picture
    #[arg(default_value = "target/antialiasing.png")]
    out: PathBuf,
}

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("antialiasing: {error}");
            ExitCode::from(2)
        }
    }
}

fn run(options: &Options) -> Result<(), String> {
    let font = TrueType::parse(include_bytes!("assets/inter.ttf")).map_err(|error| error.to_string())?;
    let bytes = vec![0; Frame::<Gray4, Rows, ()>::bytes_needed(WIDTH, HEIGHT)];
    let mut screen = Screen::new(bytes, WIDTH, HEIGHT).map_err(|error| error.to_string())?;
    let Ok(()) = draw(&mut screen, &font);
    let panel = Panel { width: WIDTH, height: HEIGHT, packing: Packing::RowsMsbFirst, ..Panel::SSD1322_256X64 };
    let picture = panel.render(screen.bytes(), Zoom { scale: 3, gap: 0 }).map_err(|error| error.to_string())?;
    save_png(&picture, &options.out).map_err(|error| error.to_string())
}

fn draw(screen: &mut Screen, font: &TrueType) -> Result<(), Infallible> {
    primitives(screen)?;
    lines(screen)?;
    text(screen, font)?;
    modes(screen)?;
    depths(screen, font)
}

/// Shapes of embedded-graphics.
fn primitives(screen: &mut Screen) -> Result<(), Infallible> {
    let style = AntialiasedStyle::fill(Gray4::new(5)).with_stroke(Gray4::WHITE, 1);
    let mut screen = Blended::new(screen);
    Circle::new(Point::new(3, 3), 37).into_styled(style).draw(&mut screen)?;
    let square = Rectangle::new(Point::new(46, 4), Size::new(26, 16));
    square.into_styled(style).draw(&mut screen)?;
    let card = Rectangle::new(Point::new(46, 24), Size::new(26, 16));
    RoundedRectangle::with_equal_corners(card, Size::new(6, 6)).into_styled(style).draw(&mut screen)?;
    let corners = [Point::new(79, 38), Point::new(95, 5), Point::new(112, 34)];
    Triangle::new(corners[0], corners[1], corners[2]).into_styled(style).draw(&mut screen)
}

/// From hairlines up, and a line every 15 degrees.
fn lines(screen: &mut Screen) -> Result<(), Infallible> {
    let mut screen = Blended::new(screen);
    for (row, sixteenths) in (4..).step_by(6).zip([4, 8, 16, 24, 32, 48]) {
        let style = AntialiasedStyle::stroke(Gray4::WHITE, 1);
        let style = style.with_shape(Stroke::of_width(Subpixel::from_bits(sixteenths)));
        Line::new(Point::new(120, row + 6), Point::new(158, row)).into_styled(style).draw(&mut screen)?;
    }
    let center = Point2::from_sixteenths(188 * 16 + 8, 22 * 16 + 8);
    for angle in (0..24).map(|hour| Angle(hour * 2731)) {
        let [x, y] = [angle.cos(), angle.sin()].map(|part| Subpixel::from_num(part * Scalar::from_num(19)));
        let ray = [center, Point2::new(center.x + x, center.y + y)];
        if let Ok(ray) = Polyline::new(&ray) {
            ray.into_styled(AntialiasedStyle::stroke(Gray4::WHITE, 1)).draw(&mut screen)?;
        }
    }
    Ok(())
}

fn text(screen: &mut Screen, font: &TrueType) -> Result<(), Infallible> {
    let mut screen = Blended::new(screen);
    let white = AntialiasedStyle::fill(Gray4::WHITE);
    for (row, size, words) in [
        (53, 10, "Aquatint: AVATAR, Wölfe & 0123"),
        (68, 13, "kerned, on 256ths of a pixel"),
        (89, 20, "Aquatint, Wölfe"),
    ] {
        let text = Text::new(font, words, Subpixel::from_num(size), Point2::corner(3, row));
        text.into_styled(white).draw(&mut screen)?;
    }
    let turned = Affine::turn(Angle::from_degrees(-24.0));
    let text = Text::new(font, "turned", Subpixel::from_num(15), Point2::corner(208, 62)).with_map(turned);
    text.into_styled(white).draw(&mut screen)?;
    let strokes = Text::new(&Hershey::DUPLEX, "Hershey", Subpixel::from_num(17), Point2::corner(186, 88));
    strokes.into_styled(AntialiasedStyle::stroke(Gray4::WHITE, 1)).draw(&mut screen)?;
    let icon = HEART.scaled(Scalar::from_num(1.4)).translate(Point::new(214, 3));
    icon.into_styled(AntialiasedStyle::fill(Gray4::WHITE)).draw(&mut screen)
}

/// Three balls of light in each mode, kept in light and dithered at the end.
fn modes(screen: &mut Screen) -> Result<(), Infallible> {
    let modes = [
        BlendMode::Over,
        BlendMode::Add,
        BlendMode::Screen,
        BlendMode::Lighten,
        BlendMode::Multiply,
        BlendMode::Darken,
    ];
    for (left, mode) in (3..).step_by(42).zip(modes) {
        let Ok(mut light) = Frame::<Light, Words, _>::with_array([0; 2 * 40 * 36], 40, 36) else { continue };
        let is_dark = matches!(mode, BlendMode::Multiply | BlendMode::Darken);
        light.clear(if is_dark { Light::WHITE } else { Light::BLACK })?;
        for (x, y) in [(20, 13), (13, 23), (27, 23)] {
            ball(&mut light, Point2::corner(x, y), mode)?;
        }
        let shown = light.bounding_box().points().filter_map(|at| Some(Pixel(at, light.pixel(at)?)));
        let mut target = Dithered::new(screen, Levels::LINEAR_16).into_draw_target::<Light>();
        shown.map(|Pixel(at, light)| Pixel(at + Point::new(left, 96), light)).draw(&mut target)?;
    }
    Ok(())
}

fn ball(light: &mut Frame<Light, Words, [u8; 2880]>, center: Point2, mode: BlendMode) -> Result<(), Infallible> {
    let Ok(oval) = Oval::circle(center, Subpixel::from_num(11)) else { return Ok(()) };
    let shade = RadialGradient::new(center, 14 * 16, between(Light(52_000), Light(9_000)));
    let (mut edges, mut cells) = (List::<AreaEdge, 8>::new(), [Coverage::NONE; 40]);
    let scratch = Scratch { edges: &mut edges, cells: &mut cells };
    fill(&oval, Rule::NonZero, scratch, &mut Blended::new(light).with_mode(mode).brush(shade))
}

/// The same words on two bits, on one bit by a threshold, and on one bit with dithered coverage.
fn depths(screen: &mut Screen, font: &TrueType) -> Result<(), Infallible> {
    let words = |words, left| Text::new(font, words, Subpixel::from_num(19), Point2::corner(left, 18));
    let Ok(mut two) = Frame::<Gray2, Rows, _>::with_array([0; 64 * STRIP as usize], WIDTH, STRIP) else {
        return Ok(());
    };
    words("2 bits", 3).into_styled(AntialiasedStyle::fill(Gray2::WHITE)).draw(&mut Blended::new(&mut two))?;
    let Ok(mut one) = Frame::<BinaryColor, Rows, _>::with_array([0; 32 * STRIP as usize], WIDTH, STRIP) else {
        return Ok(());
    };
    words("1 bit", 72).into_styled(AntialiasedStyle::fill(BinaryColor::On)).draw(&mut Blended::new(&mut one))?;
    let mut dithered = Dithered::new(&mut one, Levels::ONE_BIT);
    let style = AntialiasedStyle::fill(Light::WHITE);
    words("1 bit, dithered", 124).into_styled(style).draw(&mut Blended::new(&mut dithered))?;
    let strip = Rectangle::new(Point::new(0, 0), Size::new(WIDTH, STRIP));
    for at in strip.points() {
        let is_on = one.pixel(at).is_some_and(BinaryColor::is_on);
        let grey = if is_on { 15 } else { 5 * two.pixel(at).map_or(0, |grey| grey.luma()) };
        Pixel(at + Point::new(0, 134), Gray4::new(grey)).draw(screen)?;
    }
    let rule = Line::new(Point::new(0, 133), Point::new(255, 133));
    rule.into_styled(PrimitiveStyle::with_stroke(Gray4::new(4), 1)).draw(screen)
}
