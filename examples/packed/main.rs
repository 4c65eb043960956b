//! The same pictures in every packing of rows, and unpacked, as text.
//!
//! `cargo run --example packed` prints a line for each picture and packing:
//!
//! ```text
//! picture NAME BITS ORDER WIDTH HEIGHT PACKED PIXELS
//! ```
//!
//! `PACKED` are the bytes of a frame, in hexadecimal; `PIXELS` the codes of the same drawing where pixels are not packed, a
//! byte each, from the top left. `.ci/pl110` lets somebody else's display controller unpack the former, and compares.
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

use aquatint::{Blend, Code, Frame, Inverted, LsbFirst, MsbFirst, Rows, TrueType, display::layout::Layout};
use embedded_graphics::{
    image::GetPixel,
    pixelcolor::{BinaryColor, Gray2, Gray4, Gray8},
    prelude::*,
};
use pictures::Material;
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
    Ok(lines)
}

/// All packings of a colour.
fn in_colour<C: Code + Blend>(lines: &mut String, material: &Material) -> Result<(), String> {
    all::<C, Rows<MsbFirst>>(lines, "msb", material)?;
    all::<C, Rows<LsbFirst>>(lines, "lsb", material)?;
    all::<C, Inverted<Rows<MsbFirst>>>(lines, "msb-inverted", material)?;
    all::<C, Inverted<Rows<LsbFirst>>>(lines, "lsb-inverted", material)
}

/// All pictures in a packing.
fn all<C: Code + Blend, L: Layout<C>>(lines: &mut String, order: &str, material: &Material) -> Result<(), String> {
    /// A picture on both kinds of screen.
    macro_rules! line {
        ($($name:ident)*) => { $({
            let bytes = vec![0; Frame::<C, L, ()>::bytes_needed(WIDTH, HEIGHT)];
            let mut packed = Frame::<C, L, _>::new(bytes, WIDTH, HEIGHT).map_err(|error| error.to_string())?;
            let mut unpacked = Unpacked::new(Size::new(WIDTH, HEIGHT), C::from_code(0));
            let Ok(()) = packed.clear(C::from_code(0));
            let (Ok(()), Ok(())) = (pictures::$name(&mut packed, material), pictures::$name(&mut unpacked, material));
            let codes = unpacked.bounding_box().points().filter_map(|point| unpacked.pixel(point)).map(C::code);
            let (packed, codes) = (hex(packed.bytes().iter().copied()), hex(codes));
            let _ = writeln!(lines, "picture {} {} {order} {WIDTH} {HEIGHT} {packed} {codes}", stringify!($name), C::BITS);
        })* };
    }
    line!(pixels lines polygons photo text flood solid);
    Ok(())
}

fn hex(bytes: impl Iterator<Item = u8>) -> String {
    bytes.fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}
