//! What goes wrong with pictures of single instants, and how motion blur mends it. Lecture 6.5.
//!
//! `cargo run --release --example motion` writes `target/motion.png`; a file may be named.
#![cfg(not(target_os = "none"))]

mod scenes;
mod sheet;
mod shutter;

use std::{path::PathBuf, process::ExitCode};

use aquatint_simulator::save_png;
use clap::Parser;
use embedded_graphics::geometry::Point;

use scenes::Scene;
use sheet::Sheet;
use shutter::Shutter;

/// Shows a wagon wheel, a thrown ball and small stars, with and without motion blur.
#[derive(Parser)]
struct Options {
    /// Where to write the picture
    #[arg(default_value = "target/motion.png")]
    out: PathBuf,
}

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("motion: {error}");
            ExitCode::from(2)
        }
    }
}

fn run(options: &Options) -> Result<(), String> {
    let mut sheet = Sheet::new(448, 476)?;
    wheels(&mut sheet, 6)?;
    balls(&mut sheet, 226)?;
    stars(&mut sheet, 392)?;
    save_png(&sheet.picture()?, &options.out).map_err(|error| error.to_string())
}

/// Four frames each of a wheel that seems to stand and of one that seems to turn backwards.
fn wheels(sheet: &mut Sheet, top: i32) -> Result<(), String> {
    sheet.title("WAGON WHEEL", Point::new(8, top));
    for (left, degrees, text) in
        [(84, 45.0, "+45\u{b0} a frame: it stands"), (268, 38.0, "+38\u{b0} a frame: it turns back")]
    {
        sheet.text(text, Point::new(left, top));
        for (row, shutter) in (0..).zip(Shutter::ALL) {
            for (column, frame) in (0..4).zip(0..) {
                let film = shutter.expose(&Scene::Wheel { degrees }, frame)?;
                sheet.paste(&film, Point::new(left + 44 * column, top + 12 + 48 * row), 1);
            }
        }
    }
    for (row, shutter) in (0..).zip(Shutter::ALL) {
        sheet.text(shutter.name(), Point::new(8, top + 25 + 48 * row));
    }
    Ok(())
}

/// All frames of a throw, as the eye keeps them.
fn balls(sheet: &mut Sheet, top: i32) -> Result<(), String> {
    sheet.title("STROBE", Point::new(8, top));
    sheet.text("a ball of 16 pixels, 27 pixels a frame; 12 frames as the eye keeps them", Point::new(84, top));
    for (row, shutter) in (0..).zip([Shutter::Instant, Shutter::Greys, Shutter::Interleaved]) {
        for frame in 0..12 {
            sheet.paste(&shutter.expose(&Scene::Ball, frame)?, Point::new(84, top + 12 + 48 * row), 1);
        }
        sheet.text(shutter.name(), Point::new(8, top + 24 + 48 * row));
    }
    Ok(())
}

/// A frame a row: stars smaller than a pixel, a third of a pixel a frame.
fn stars(sheet: &mut Sheet, top: i32) -> Result<(), String> {
    sheet.title("FLICKER", Point::new(8, top));
    sheet.text("stars of 0.6 pixels that drift; a row a frame, from top to bottom", Point::new(84, top));
    for (left, shutter) in [(84, Shutter::Instant), (268, Shutter::Greys)] {
        for frame in 0..20 {
            sheet.paste(&shutter.expose(&Scene::Stars, frame)?, Point::new(left, top + 12), 3);
        }
    }
    sheet.text("one instant\nand 16, moved\nby parts of\na pixel", Point::new(8, top + 18));
    Ok(())
}
