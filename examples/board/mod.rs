//! The boards of the `mcu_*` examples: lm3s6965evb, a Cortex-M3 with 256 KiB of flash, 64 KiB of
//! RAM and a 128×64 OLED of 4 bits a pixel (SSD0323); and lm3s811evb, with 64 KiB, 8 KiB and one of 96×16
//! single bits (SSD0303). QEMU emulates all of them, panels included, and runs them with a Cortex-M0 or M4
//! in place of the M3 as well.
//!
//! Nothing here belongs to aquatint: it is the hundred lines of driver that any firmware brings.
//! There is no `fmt` and no panic path, so what an example costs in flash is the drawing.
#![allow(dead_code, reason = "each example uses a part of the board")]

mod register;
pub mod semihosting;
pub mod ssd0303;
pub mod ssd0323;
pub mod stack;
pub mod ticks;

use core::panic::PanicInfo;
use cortex_m_rt::{ExceptionFrame, exception};

/// Sends a whole packed frame to the panel and lets the host look at it.
pub fn show(frame: u32, bytes: &[u8]) {
    ssd0323::window(0..ssd0323::WIDTH, 0..ssd0323::HEIGHT);
    ssd0323::data(bytes);
    look(frame, bytes);
}

/// Tells the host what the whole panel must show now and waits until it has looked.
///
/// For firmware that sends the panel less than a frame: `show` is `window`, `data`, `look`.
pub fn look(frame: u32, bytes: &[u8]) {
    semihosting::puts("frame ");
    semihosting::decimal(frame);
    semihosting::puts(" ");
    semihosting::hex(bytes);
    semihosting::puts("\nREADY\n");
    semihosting::getc();
}

/// Prints a number the host keeps account of, `instructions 1234` or `stack 560`.
pub fn report(what: &str, value: u32) {
    semihosting::puts(what);
    semihosting::puts(" ");
    semihosting::decimal(value);
    semihosting::puts("\n");
}

/// Says where, without `fmt`: formatting the message would cost more flash than the example.
#[panic_handler]
fn panic(info: &PanicInfo) -> ! {
    semihosting::puts("PANIC");
    if let Some(place) = info.location() {
        semihosting::puts(" at ");
        semihosting::puts(place.file());
        semihosting::puts(":");
        semihosting::decimal(place.line());
    }
    semihosting::puts("\n");
    semihosting::exit(1)
}

/// Ends the run: the default handler loops for ever, and the host would have to guess why.
// SAFETY: replaces no handler that anything relies on, and never returns to the faulting code.
#[exception]
unsafe fn HardFault(frame: &ExceptionFrame) -> ! {
    semihosting::puts("FAULT at ");
    semihosting::hex(&frame.pc().to_be_bytes());
    semihosting::puts("\n");
    semihosting::exit(1)
}
