//! Lines, text, polygons, a photograph, soft text, floods and solids on a 128 × 64 OLED of four bits a pixel, on SPI.
//!
//! `cargo run --profile firmware --example mcu_grey --target thumbv7m-none-eabi` runs it on QEMU's
//! `lm3s6965evb` board and shows what its panel shows. Run on the desk, the same example prints
//! the bytes that the firmware must have sent.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod features;
#[path = "features/grey.rs"]
mod panel;
mod scene;

#[cfg(target_os = "none")]
mod board;

#[cfg(target_os = "none")]
use features::{Changes, Feature, Floods, Lines, Memory, Photo, Polygons, Scanline, Shadow, Solid, Texts};

#[cfg(target_os = "none")]
#[cortex_m_rt::entry]
fn main() -> ! {
    // First in the function: the entry macro makes them mutable references that only `main` has.
    static mut FLAT: (Lines, Polygons, Photo, Floods, Changes) = features::FLAT;
    static mut SOFT: Texts = Texts::NEW;
    static mut SOLID: (Solid, Scanline) = features::SOLID;
    static mut SHADOW: Shadow = Shadow::NEW;
    use board::{ssd0323, stack};

    stack::paint();
    ssd0323::init();
    let memory = Memory { flat: FLAT, soft: SOFT, solid: SOLID };
    features::run(memory, SHADOW, &mut Oled, ssd0323::bytes_sent)
}

/// The panel of the board.
#[cfg(target_os = "none")]
struct Oled;

#[cfg(target_os = "none")]
impl features::Screen for Oled {
    fn window(&mut self, area: aquatint::Rect) {
        let borders = [area.left, area.right, area.top, area.bottom];
        // All are on the panel.
        let [left, right, top, bottom] = borders.map(|border| u8::try_from(border).unwrap_or(0));
        board::ssd0323::window(left..right, top..bottom);
    }

    fn data(&mut self, bytes: &[u8]) {
        board::ssd0323::data(bytes);
    }
}

#[cfg(not(target_os = "none"))]
fn main() {
    features::print();
}
