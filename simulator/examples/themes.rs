//! Every theme in one figure: ramps of all sixteen greys, a disc and a row of lines.
//!
//! Usage: `themes FILE.png`

use std::error::Error;
use std::path::Path;

use aquatint_simulator::{Packing, Panel, Picture, Response, Theme, Zoom, save_png};

const SIZE: (u32, u32) = (160, 48);

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args_os().nth(1).ok_or("usage: themes FILE.png")?;
    let zoom = Zoom { scale: 5, gap: 1 };
    let pictures: Vec<Picture> =
        Theme::ALL.iter().map(|&theme| panel(theme).render(&chart(), zoom)).collect::<Result<_, _>>()?;
    let figure = Picture::above(&pictures, 16, [96, 98, 100]);
    save_png(&figure, Path::new(&path))?;
    Ok(())
}

fn panel(theme: Theme) -> Panel {
    Panel {
        name: "chart",
        width: SIZE.0,
        height: SIZE.1,
        bits: 4,
        packing: Packing::RowsMsbFirst,
        response: Response::Srgb,
        theme,
    }
}

/// The left pixel of each two in the high nibble.
fn chart() -> Vec<u8> {
    let pairs = (0..SIZE.0 * SIZE.1 / 2).map(|pair| (pair * 2 % SIZE.0, pair * 2 / SIZE.0));
    pairs.map(|(x, y)| code_at(x, y) << 4 | code_at(x + 1, y)).collect()
}

/// From the left: a disc, lines ever farther apart, and a ramp above its opposite.
fn code_at(x: u32, y: u32) -> u8 {
    match x {
        0..48 => {
            let (dx, dy) = (x.abs_diff(24), y.abs_diff(24));
            if dx * dx + dy * dy < 20 * 20 { 15 } else { 0 }
        }
        48..80 => {
            let spacing = y / 12 + 2;
            if x.is_multiple_of(spacing) { 15 } else { 0 }
        }
        _ => {
            let [.., step] = ((x - 80) / 5).to_be_bytes();
            if y < 24 { step } else { 15 - step }
        }
    }
}
