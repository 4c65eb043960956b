//! The same pictures in every packing of rows, and unpacked, as text.
//!
//! `cargo run --example packed` prints a line for each picture and packing:
//!
//! ```text
//! picture NAME BITS ORDER WIDTH HEIGHT PACKED PIXELS
//! ```
//!
//! `PACKED` are the bytes of a frame, in hexadecimal; `PIXELS` the codes of the same drawing where pixels are not packed, a
//! byte each or, of 16 bits, two, from the top left. `.ci/pl110` lets somebody else's display controller unpack the former, and compares.
#![cfg(not(target_os = "none"))]

#[path = "../demo/parts.rs"]
mod parts;
#[path = "../demo/photo.rs"]
mod photo;
mod pictures;
#[path = "../scene/mod.rs"]
mod scene;
mod unpacked;

use std::{fmt::Write, path::Path, process::ExitCode};

use aquatint::{
    Code, Frame, Inverted, Light, LsbFirst, MsbFirst, Rows, TrueType, Words,
    display::layout::{Layout, Order},
};
use embedded_graphics::{
    image::GetPixel,
    pixelcolor::{BinaryColor, Gray2, Gray4, Gray8},
    prelude::*,
};
use pictures::{Grey, Material};
use unpacked::Unpacked;

const WIDTH: u32 = 128;
const HEIGHT: u32 = 64;

fn main() -> ExitCode {
    match run() {
        Ok(lines) => {
            print!("{lines}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("packed: {error}");
            ExitCode::from(2)
        }
    }
}

fn run() -> Result<String, String> {
    let photo = photo::load(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/examples/assets/photo.png")))?;
    let font = TrueType::parse(include_bytes!("../assets/inter.ttf")).map_err(|error| error.to_string())?;
    let material = Material { photo: photo.fitted(88, 64), font };
    let mut lines = String::new();
    in_colour::<BinaryColor>(&mut lines, &material)?;
    in_colour::<Gray2>(&mut lines, &material)?;
    in_colour::<Gray4>(&mut lines, &material)?;
    in_colour::<Gray8>(&mut lines, &material)?;
    in_words::<MsbFirst>(&mut lines, "msb", &material)?;
    in_words::<LsbFirst>(&mut lines, "lsb", &material)?;
    Ok(lines)
}

/// All packings of a colour.
fn in_colour<C: Code + Grey>(lines: &mut String, material: &Material) -> Result<(), String> {
    in_codes::<C, Rows<MsbFirst>>(lines, "msb", material)?;
    in_codes::<C, Rows<LsbFirst>>(lines, "lsb", material)?;
    in_codes::<C, Inverted<Rows<MsbFirst>>>(lines, "msb-inverted", material)?;
    in_codes::<C, Inverted<Rows<LsbFirst>>>(lines, "lsb-inverted", material)
}

/// Calls `line` with each picture's name, and with the function that draws it on a packed and on an unpacked screen.
macro_rules! all {
    ($color:ty, $layout:ty, $lines:ident, $order:ident, $material:ident: $($name:ident by $draw:ident),*) => { $({
        let (mut packed, mut unpacked) = screens::<$color, $layout>()?;
        pictures::$draw(&mut packed, $material).map_err(|error| error.to_string())?;
        pictures::$draw(&mut unpacked, $material).map_err(|error| error.to_string())?;
        line($lines, (stringify!($name), $order), &packed, &unpacked);
    })* };
}

fn in_codes<C: Code + Grey, L: Layout<C>>(lines: &mut String, order: &str, material: &Material) -> Result<(), String> {
    all!(C, L, lines, order, material: pixels by pixels, lines by lines, polygons by polygons, light by light);
    all!(C, L, lines, order, material: text by text, flood by flood, solid by solid);
    Ok(())
}

fn in_words<O: Order>(lines: &mut String, order: &str, material: &Material) -> Result<(), String> {
    all!(Light, Words<O>, lines, order, material: pixels by pixels, lines by lines, polygons by polygons, light by pure_light);
    all!(Light, Words<O>, lines, order, material: text by text, flood by flood, solid by pure_solid);
    Ok(())
}

/// Two black screens.
#[expect(clippy::type_complexity, reason = "a pair")]
fn screens<C: Grey, L: Layout<C>>() -> Result<(Frame<C, L, Vec<u8>>, Unpacked<C>), String> {
    let (size, black) = (Size::new(WIDTH, HEIGHT), C::from_highest(0));
    let bytes = vec![0; Frame::<C, L, ()>::bytes_needed(WIDTH, HEIGHT)];
    let mut packed = Frame::new(bytes, WIDTH, HEIGHT).map_err(|error| error.to_string())?;
    let Ok(()) = packed.clear(black);
    Ok((packed, Unpacked::new(size, black)))
}

/// Adds the line of a picture.
fn line<C: Grey, L: Layout<C>>(
    lines: &mut String,
    (name, order): (&str, &str),
    packed: &Frame<C, L, Vec<u8>>,
    unpacked: &Unpacked<C>,
) {
    let _ = write!(lines, "picture {name} {} {order} {WIDTH} {HEIGHT} ", C::BITS);
    packed.bytes().iter().for_each(|byte| {
        let _ = write!(lines, "{byte:02x}");
    });
    lines.push(' ');
    let digits = if C::BITS > 8 { 4 } else { 2 };
    for color in unpacked.bounding_box().points().filter_map(|point| unpacked.pixel(point)) {
        let _ = write!(lines, "{:0digits$x}", color.code());
    }
    lines.push('\n');
}
