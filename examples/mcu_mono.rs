//! The same as `mcu_grey` on a 96 × 16 OLED of one bit a pixel, on I²C, with 8 KiB of RAM and 64 of flash.
//!
//! `cargo run --profile firmware --example mcu_mono --target thumbv6m-none-eabi` runs it on QEMU's
//! `lm3s811evb` board and shows what its panel shows: with `PART=flat` before it lines, text, polygons, a photograph,
//! floods, and what has changed; `PART=soft` soft text; `PART=solid` solids. Run on the desk, the same example prints
//! the bytes that the firmware must have sent.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod features;
#[path = "features/mono.rs"]
mod panel;
mod scene;

#[cfg(target_os = "none")]
mod board;

#[cfg(target_os = "none")]
use features::{Changes, Feature, Floods, Lines, Memory, Photo, Polygons, Scanline, Shadow, Solid, Texts};

// Tells memory.x that this is for the smaller board.
#[cfg(target_os = "none")]
core::arch::global_asm!(".global lm3s811evb", ".equ lm3s811evb, 1");

#[cfg(target_os = "none")]
#[cortex_m_rt::entry]
fn main() -> ! {
    // First in the function: the entry macro makes them mutable references that only `main` has.
    static mut FLAT: (Lines, Polygons, Photo, Floods, Changes) = features::FLAT;
    static mut SOFT: Texts = Texts::NEW;
    static mut SOLID: (Solid, Scanline) = features::SOLID;
    static mut SHADOW: Shadow = Shadow::NEW;
    use board::{ssd0303, stack};

    stack::paint();
    ssd0303::init();
    let memory = Memory { flat: FLAT, soft: SOFT, solid: SOLID };
    features::run(memory, SHADOW, &mut Oled(ssd0303::Window::new(0..96, 0)), ssd0303::bytes_sent)
}

/// The panel of the board, and where on it the next bytes go.
#[cfg(target_os = "none")]
struct Oled(board::ssd0303::Window);

#[cfg(target_os = "none")]
impl features::Screen for Oled {
    fn window(&mut self, area: aquatint::Rect) {
        // All are on the panel.
        let [left, right, page] = [area.left, area.right, area.top / 8].map(|border| u8::try_from(border).unwrap_or(0));
        self.0 = board::ssd0303::Window::new(left..right, page);
    }

    fn data(&mut self, bytes: &[u8]) {
        self.0.data(bytes);
    }
}

#[cfg(not(target_os = "none"))]
fn main() {
    features::print();
}
