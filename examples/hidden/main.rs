//! Hidden surfaces: one scene in every way, what each of them takes, and how that grows.
//!
//! `cargo run --release --example hidden` writes `target/hidden.png`; a file may be named. RAM is what must be lent, overdraw
//! how often a pixel that is seen is given, instructions are those that `cargo bench` has counted on the desk.
#![cfg(not(target_os = "none"))]

mod counted;
mod plot;
#[path = "../scene/ways.rs"]
mod ways;

use std::{convert::Infallible, path::PathBuf, process::ExitCode};

use aquatint::{Dithered, Frame, Levels, Rows};
use aquatint_simulator::{Packing, Panel, Zoom, save_png};
use clap::Parser;
use counted::{Counted, instructions};
use embedded_graphics::{
    mono_font::{MonoTextStyle, ascii::FONT_5X8},
    pixelcolor::Gray4,
    prelude::*,
    text::{Alignment, Baseline, Text, TextStyleBuilder},
};
use ways::{WINDOW, Way, Ways};

/// Pictures in a row, and what one takes with its captions.
const COLUMNS: u32 = 4;
const CELL: Size = Size::new(WINDOW.width() + 6, WINDOW.height() + 42);

pub type Screen = Frame<Gray4, Rows, Vec<u8>>;

/// Draws one scene in every way, and how they grow.
#[derive(Parser)]
struct Options {
    /// Where to write the picture
    #[arg(default_value = "target/hidden.png")]
    out: PathBuf,
}

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("hidden: {error}");
            ExitCode::from(2)
        }
    }
}

fn run(options: &Options) -> Result<(), String> {
    let rows = u32::try_from(Way::ALL.len()).map_err(|error| error.to_string())?.div_ceil(COLUMNS);
    let (width, height) = (COLUMNS * CELL.width, rows * CELL.height + plot::HEIGHT);
    let bytes = vec![0; Frame::<Gray4, Rows, ()>::bytes_needed(width, height)];
    let mut screen = Screen::new(bytes, width, height).map_err(|error| error.to_string())?;
    let mut ways = Ways::new();
    for (number, way) in (0..).zip(Way::ALL) {
        let place = Point::zero() + CELL.component_mul(Size::new(number % COLUMNS, number / COLUMNS));
        let Ok(()) = hang(&mut screen, place, (&mut ways, way));
    }
    let Ok(()) = plot::both(&mut screen, Point::zero() + Size::new(0, rows * CELL.height));
    let panel = Panel { width, height, packing: Packing::RowsMsbFirst, ..Panel::SSD1322_256X64 };
    let picture = panel.render(screen.bytes(), Zoom { scale: 2, gap: 0 }).map_err(|error| error.to_string())?;
    save_png(&picture, &options.out).map_err(|error| error.to_string())
}

/// A picture with what it took.
fn hang(screen: &mut Screen, place: Point, (ways, way): (&mut Ways, Way)) -> Result<(), Infallible> {
    let mut part = aquatint::Window::part(screen, picture_area(place));
    let mut counted = Counted::new(Dithered::new(&mut part, Levels::SRGB_16));
    ways.draw(way, &mut counted);
    let overdraw = counted.overdraw();
    let [item, name] = way.names();
    let lines = [
        name.to_owned(),
        match (way.ram(), ways.flash(way)) {
            (ram, 0) => format!("{ram} bytes of RAM"),
            (ram, flash) => format!("{ram} RAM, {flash} flash"),
        },
        instructions(item, "128x64").map_or_else(String::new, |count| format!("{count} instructions")),
        format!("each pixel {overdraw:.2} times"),
    ];
    for (line, text) in (0..).zip(&lines) {
        let bright = MonoTextStyle::new(&FONT_5X8, if line == 0 { Gray4::WHITE } else { Gray4::new(9) });
        let below = place + Size::new(CELL.width / 2, WINDOW.height() + 4 + 9 * line);
        let style = TextStyleBuilder::new().alignment(Alignment::Center).baseline(Baseline::Top).build();
        Text::with_text_style(text, below, bright, style).draw(screen)?;
    }
    Ok(())
}

/// The pixels of a picture on the screen.
fn picture_area(place: Point) -> aquatint::Rect {
    let (left, top) = (place.x + 3, place.y + 2);
    aquatint::Rect::new(left, top, left + WINDOW.width().cast_signed(), top + WINDOW.height().cast_signed())
}
