//! The whole pipeline at work: a mesh, a photograph and a caption on three simulated panels.
//!
//! `cargo run --release --example demo` shows a frame in the terminal, writes pictures to
//! `target/demo/`, and opens a live window where there is a display.
#![cfg(not(target_os = "none"))]

mod live;
mod obj;
mod parts;
mod photo;
mod record;
#[path = "../scene/mod.rs"]
mod scene;
mod screens;
mod torus;

use std::{
    io::{Cursor, Write},
    path::PathBuf,
    process::ExitCode,
};

use aquatint::{Angle, display::dither::Method, model::mesh::Mesh};
use aquatint_simulator::{WindowError, braille, display_available};
use clap::Parser;

/// Draws a spinning mesh and a dithered photograph on three simulated panels.
#[derive(Parser)]
struct Options {
    /// Wavefront OBJ file to show in place of the bunny
    #[arg(long, value_name = "FILE.obj")]
    model: Option<PathBuf>,
    /// PNG file to show in place of the photograph
    #[arg(long, value_name = "FILE.png")]
    image: Option<PathBuf>,
    /// Where to write the pictures
    #[arg(long, value_name = "DIR", default_value = "target/demo")]
    out: PathBuf,
    /// Length of the animation; the mesh turns once around in 64
    #[arg(long, value_name = "N", default_value_t = scene::FRAMES_PER_TURN, value_parser = clap::value_parser!(u16).range(1..))]
    frames: u16,
    /// Open a live window, or say why not
    #[arg(long, conflicts_with = "no_window")]
    window: bool,
    /// Open no window even where there is a display
    #[arg(long)]
    no_window: bool,
}

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("demo: {error}");
            ExitCode::from(2)
        }
    }
}

fn run(options: &Options) -> Result<(), String> {
    // Everything that may be refused is looked at before anything is written.
    if options.window && !display_available() {
        return Err(WindowError::NoDisplay.to_string());
    }
    let own = options.model.as_ref().map(|path| obj::load(path).map_err(|e| format!("{} {e}", path.display())));
    let (own, torus) = (own.transpose()?, torus::torus()?);
    let own = own.as_ref().map(|mesh| mesh.borrow().map_err(|e| format!("{e:?}"))).transpose()?;
    let torus = torus.borrow().map_err(|e| format!("{e:?}"))?;
    let meshes: Vec<Mesh> = own.into_iter().chain([scene::BUNNY, torus]).collect();
    let photo = match &options.image {
        Some(path) => photo::load(path).map_err(|e| format!("{} {e}", path.display()))?,
        None => photo::decode(Cursor::new(include_bytes!("../assets/photo.png")))?,
    };
    let mut screens = screens::all(&photo);
    let caption = "aquatint";
    let content = screens::Content {
        mesh: meshes[0],
        placement: scene::turned(Angle(0), Angle(0)),
        method: Method::Ordered4x4,
        caption,
    };

    let still = record::at(&content, record::STILL);
    let oled = &mut screens[0];
    let panel = oled.panel;
    let codes = panel.codes(oled.draw(&still)?).map_err(|e| e.to_string())?;
    let written = record::record(&mut screens, &content, options.frames, &options.out)?;
    let report = written.iter().map(|path| format!("wrote {}\n", path.display()));
    let text = braille(&codes, 1) + &report.collect::<String>();
    // Not `print!`, which panics when whoever read it has gone.
    std::io::stdout().write_all(text.as_bytes()).map_err(|e| e.to_string())?;
    if options.window || (display_available() && !options.no_window) {
        live::run(&mut screens, &meshes, caption)?;
    }
    Ok(())
}
