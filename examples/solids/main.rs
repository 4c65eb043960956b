//! Solids in every fill mode, on four bits and on one bit a pixel, as one picture.
//!
//! `cargo run --release --example solids` writes `target/solids.png`; a file may be named.
#![cfg(not(target_os = "none"))]

mod easel;
mod scenes;

use std::{convert::Infallible, path::PathBuf, process::ExitCode};

use aquatint::{
    BLUE_NOISE_64, Dithered, Frame, Levels, Light, Rows,
    display::dither::{CROSS_HATCH_8X8, Mask},
};
use aquatint_simulator::{Packing, Panel, Zoom, save_png};
use clap::Parser;
use easel::{HEIGHT, Picture, WIDTH};
use embedded_graphics::{
    image::GetPixel,
    mono_font::{MonoTextStyle, ascii::FONT_5X8},
    pixelcolor::{BinaryColor, Gray4},
    prelude::*,
    text::{Alignment, Text},
};

/// Pictures in a row, and what one takes with its name.
const COLUMNS: u32 = 6;
const CELL: Size = Size::new(WIDTH + 4, HEIGHT + 12);

type Screen = Frame<Gray4, Rows, Vec<u8>>;

/// Draws solids in every fill mode on simulated panels.
#[derive(Parser)]
struct Options {
    /// Where to write the picture
    #[arg(default_value = "target/solids.png")]
    out: PathBuf,
}

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("solids: {error}");
            ExitCode::from(2)
        }
    }
}

fn run(options: &Options) -> Result<(), String> {
    let rows = u32::try_from(scenes::ALL.len()).map_err(|error| error.to_string())?.div_ceil(COLUMNS);
    let (width, height) = (COLUMNS * CELL.width, 2 * rows * CELL.height);
    let bytes = vec![0; Frame::<Gray4, Rows, ()>::bytes_needed(width, height)];
    let mut screen = Screen::new(bytes, width, height).map_err(|error| error.to_string())?;
    for (number, scene) in (0..).zip(&scenes::ALL) {
        let picture = easel::draw(scene.draw).map_err(|error| format!("{}: {error}", scene.name))?;
        let (column, row) = (number % COLUMNS, number / COLUMNS);
        for (bits, row) in [(4, row), (1, row + rows)] {
            let place = Point::zero() + CELL.component_mul(Size::new(column, row));
            let Ok(()) = hang(&mut screen, place, &picture, (scene.name, bits));
        }
    }
    let panel = Panel { width, height, packing: Packing::RowsMsbFirst, ..Panel::SSD1322_256X64 };
    let picture = panel.render(screen.bytes(), Zoom { scale: 2, gap: 0 }).map_err(|error| error.to_string())?;
    save_png(&picture, &options.out).map_err(|error| error.to_string())
}

/// A picture of light on the screen, with its name below.
fn hang(screen: &mut Screen, place: Point, picture: &Picture, (name, bits): (&str, u32)) -> Result<(), Infallible> {
    match (bits, name) {
        (4, _) => {
            let shown = |Pixel(at, light)| Pixel(at + place + Point::new(2, 2), light);
            let mut target = Dithered::new(screen, Levels::SRGB_16).into_draw_target::<Light>();
            lights(picture).map(shown).draw(&mut target)?;
        }
        (_, "cross hatch") => one_bit(screen, place, picture, CROSS_HATCH_8X8)?,
        _ => one_bit(screen, place, picture, BLUE_NOISE_64)?,
    }
    let style = MonoTextStyle::new(&FONT_5X8, Gray4::new(11));
    let below = place + CELL - Size::new(CELL.width / 2, 4);
    Text::with_alignment(name, below, style, Alignment::Center).draw(screen).map(|_| ())
}

fn one_bit(screen: &mut Screen, place: Point, picture: &Picture, mask: impl Mask) -> Result<(), Infallible> {
    let bytes = vec![0; Frame::<BinaryColor, Rows, ()>::bytes_needed(WIDTH, HEIGHT)];
    let Ok(mut one) = Frame::<BinaryColor, Rows, _>::new(bytes, WIDTH, HEIGHT) else { return Ok(()) };
    lights(picture)
        .draw(&mut Dithered::new(&mut one, Levels::ONE_BIT).with_method(mask).into_draw_target::<Light>())?;
    let grey = |color: BinaryColor| if color.is_on() { Gray4::WHITE } else { Gray4::BLACK };
    let pixels = one.bounding_box().points().filter_map(|at| Some(Pixel(at, grey(one.pixel(at)?))));
    pixels.map(|Pixel(at, grey)| Pixel(at + place + Point::new(2, 2), grey)).draw(screen)
}

fn lights(picture: &Picture) -> impl Iterator<Item = Pixel<Light>> {
    picture.bounding_box().points().filter_map(|at| Some(Pixel(at, picture.pixel(at)?)))
}
