//! Lines, text, polygons, a photograph, soft text, floods and solids on a 128 × 64 OLED of four bits a pixel, on SPI.
//!
//! `cargo run --release --example mcu_grey --target thumbv7m-none-eabi` runs it on QEMU's
//! `lm3s6965evb` board and shows what its panel shows. Run on the desk, the same example prints
//! the bytes that the firmware must have sent.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod features;
#[path = "features/grey.rs"]
mod panel;
mod scene;

#[cfg(target_os = "none")]
mod board;

use features::Tour;

#[cfg(target_os = "none")]
#[cortex_m_rt::entry]
fn main() -> ! {
    // First in the function: the entry macro makes it a mutable reference that only `main` has.
    static mut TOUR: Tour = Tour::NEW;
    use board::{look, report, semihosting, ssd0323, stack};

    stack::paint();
    ssd0323::init();
    let is_done = TOUR.go(&mut Oled, &mut look).is_some();
    report("bus", ssd0323::bytes_sent());
    report("stack", stack::high_water());
    semihosting::exit(u8::from(!is_done))
}

/// The panel of the board.
#[cfg(target_os = "none")]
struct Oled;

#[cfg(target_os = "none")]
impl features::Screen for Oled {
    fn window(&mut self, area: aquatint::Rect) {
        let [left, right, top, bottom] = [area.left, area.right, area.top, area.bottom].map(|border| border as u8);
        board::ssd0323::window(left..right, top..bottom);
    }

    fn data(&mut self, bytes: &[u8]) {
        board::ssd0323::data(bytes);
    }
}

#[cfg(not(target_os = "none"))]
fn main() {
    features::print(Box::new(Tour::NEW));
}
