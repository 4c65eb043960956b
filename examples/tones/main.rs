//! One photograph by every way there is to show tones on few colours, on one sheet.
//!
//! `cargo run --release --example tones -- PHOTO.png` writes `target/tones.png`.
#![cfg(not(target_os = "none"))]

mod methods;
mod photo;
mod sheet;

use std::{path::PathBuf, process::ExitCode};

use aquatint_simulator::save_png;
use clap::Parser;

/// Shows a photograph in one bit a pixel, in greys and in inks, by all methods.
#[derive(Parser)]
struct Options {
    /// PNG file of any kind
    #[arg(value_name = "PHOTO.png")]
    photo: PathBuf,
    /// Where to write the sheet
    #[arg(short, long, value_name = "OUT.png", default_value = "target/tones.png")]
    out: PathBuf,
    /// Columns of each picture
    #[arg(long, value_name = "N", default_value_t = 192, value_parser = clap::value_parser!(u32).range(16..=1024))]
    width: u32,
}

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("tones: {error}");
            ExitCode::from(2)
        }
    }
}

fn run(options: &Options) -> Result<(), String> {
    let photo = photo::load(&options.photo).map_err(|error| format!("{} {error}", options.photo.display()))?;
    let photo = photo.scaled_to_width(options.width)?;
    let sheet = sheet::sheet(&methods::all(&photo)?)?;
    save_png(&sheet, &options.out).map_err(|error| error.to_string())?;
    println!("wrote {}", options.out.display());
    Ok(())
}
