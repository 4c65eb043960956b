//! The same as `mcu_grey` on a 96 × 16 OLED of one bit a pixel, on I²C, with 8 KiB of RAM.
//!
//! `cargo run --release --example mcu_mono --target thumbv6m-none-eabi` runs it on QEMU's
//! `lm3s811evb` board and shows what its panel shows. Run on the desk, the same example prints
//! the bytes that the firmware must have sent.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod features;
#[path = "features/mono.rs"]
mod panel;
mod scene;

#[cfg(target_os = "none")]
mod board;

use features::Tour;

// Tells memory.x that this is for the smaller board.
#[cfg(target_os = "none")]
core::arch::global_asm!(".global lm3s811evb", ".equ lm3s811evb, 1");

#[cfg(target_os = "none")]
#[cortex_m_rt::entry]
fn main() -> ! {
    // First in the function: the entry macro makes it a mutable reference that only `main` has.
    static mut TOUR: Tour = Tour::NEW;
    use board::{look, report, semihosting, ssd0303, stack};

    stack::paint();
    ssd0303::init();
    let is_done = TOUR.go(&mut Oled(ssd0303::Window::new(0..96, 0)), &mut look).is_some();
    report("bus", ssd0303::bytes_sent());
    report("stack", stack::high_water());
    semihosting::exit(u8::from(!is_done))
}

/// The panel of the board, and where on it the next bytes go.
#[cfg(target_os = "none")]
struct Oled(board::ssd0303::Window);

#[cfg(target_os = "none")]
impl features::Screen for Oled {
    fn window(&mut self, area: aquatint::Rect) {
        let [left, right, page] = [area.left, area.right, area.top / 8].map(|border| border as u8);
        self.0 = board::ssd0303::Window::new(left..right, page);
    }

    fn data(&mut self, bytes: &[u8]) {
        self.0.data(bytes);
    }
}

#[cfg(not(target_os = "none"))]
fn main() {
    features::print(Box::new(Tour::NEW));
}
