//! The OLED: an SSD0323 with 128×64 pixels of 4 bits, the left pixel in the high half of a byte.
//!
//! It hangs on SSI0 (a PL022) with the data/command line on PC7. QEMU's model obeys the window
//! and data commands and ignores contrast, grey table, remap and on/off, which are here for the
//! real part.

use super::register::{Peripheral, Register};
use core::{
    ops::Range,
    sync::atomic::{AtomicU32, Ordering},
};

pub const WIDTH: u8 = 128;
pub const HEIGHT: u8 = 64;

const RCGC1: Register = Register::new(Peripheral::SystemControl, 0x104);
const RCGC1_SSI0: u32 = 1 << 4;
const RCGC2: Register = Register::new(Peripheral::SystemControl, 0x108);
const RCGC2_PORTS_A_C: u32 = 1 << 0 | 1 << 2;

const PORT_A_AFSEL: Register = Register::new(Peripheral::GpioPortA, 0x420);
const PORT_A_DEN: Register = Register::new(Peripheral::GpioPortA, 0x51C);
/// PA2 is the clock, PA3 chip select, PA5 the data to the panel.
const SSI_PINS: u32 = 1 << 2 | 1 << 3 | 1 << 5;

const PORT_C_DIR: Register = Register::new(Peripheral::GpioPortC, 0x400);
const PORT_C_DEN: Register = Register::new(Peripheral::GpioPortC, 0x51C);
/// PC7 tells data (high) from commands (low).
const DATA_PIN: u32 = 1 << 7;
/// Bits 2..10 of a GPIODATA address mask the pins, so this register is PC7 alone.
const PORT_C_DATA_PIN: Register = Register::new(Peripheral::GpioPortC, (DATA_PIN as usize) << 2);

const SSICR0: Register = Register::new(Peripheral::Ssi0, 0x000);
/// 8 bits a word; clock idle high, sampled on the second edge (SPI mode 3).
const SSICR0_MODE: u32 = 0x07 | 1 << 6 | 1 << 7;
const SSICR1: Register = Register::new(Peripheral::Ssi0, 0x004);
const SSICR1_ENABLE: u32 = 1 << 1;
const SSIDR: Register = Register::new(Peripheral::Ssi0, 0x008);
const SSISR: Register = Register::new(Peripheral::Ssi0, 0x00C);
const SSISR_TRANSMIT_NOT_FULL: u32 = 1 << 1;
const SSISR_RECEIVE_NOT_EMPTY: u32 = 1 << 2;
const SSISR_BUSY: u32 = 1 << 4;
const SSICPSR: Register = Register::new(Peripheral::Ssi0, 0x010);
/// The core starts at 12 MHz: 3 MHz on the wire, and the panel takes 4.
const SSICPSR_DIVISOR: u32 = 4;

const SET_COLUMNS: u8 = 0x15;
const SET_ROWS: u8 = 0x75;

/// Bytes that were sent, commands too.
static SENT: AtomicU32 = AtomicU32::new(0);

/// Bytes that were sent since the start, commands too.
pub fn bytes_sent() -> u32 {
    SENT.load(Ordering::Relaxed)
}

/// Wakes the port and the panel.
pub fn init() {
    RCGC1.set(RCGC1_SSI0);
    RCGC2.set(RCGC2_PORTS_A_C);
    RCGC2.read(); // A clock needs three cycles before its peripheral may be touched.

    PORT_A_AFSEL.set(SSI_PINS);
    PORT_A_DEN.set(SSI_PINS);
    PORT_C_DIR.set(DATA_PIN);
    PORT_C_DEN.set(DATA_PIN);

    SSICR1.write(0); // The mode may only change while the port is off.
    SSICPSR.write(SSICPSR_DIVISOR);
    SSICR0.write(SSICR0_MODE);
    SSICR1.write(SSICR1_ENABLE);

    command(&[
        0xAE, // display off
        0xA8, 0x3F, // 64 rows
        0xA0, 0x00, // unmirrored, columns before rows
        0xA1, 0x00, // start line
        0xA2, 0x00, // offset
        0x81, 0x40, // contrast
        0xA4, // show the memory
        0xAF, // display on
    ]);
}

/// Chooses the pixels that `data` fills, left to right and then down. Columns are even.
pub fn window(columns: Range<u8>, rows: Range<u8>) {
    let (left, right) = (columns.start / 2, columns.end / 2);
    let (top, bottom) = (rows.start, rows.end);
    // The panel counts columns by bytes and takes the last one, not the one after it.
    command(&[SET_COLUMNS, left, right.saturating_sub(1)]);
    command(&[SET_ROWS, top, bottom.saturating_sub(1)]);
}

/// Sends packed pixels into the window. Further calls go on where the last one stopped.
pub fn data(bytes: &[u8]) {
    send(DATA_PIN, bytes);
}

fn command(bytes: &[u8]) {
    send(0, bytes);
}

fn send(data_pin: u32, bytes: &[u8]) {
    PORT_C_DATA_PIN.write(data_pin);
    // Load and store: Cortex-M0 has no more, and nobody else writes.
    SENT.store(bytes_sent() + u32::try_from(bytes.len()).unwrap_or(0), Ordering::Relaxed);
    for &byte in bytes {
        transfer(byte);
    }
    // The pin belongs to the byte on the wire: it may not change before the last one has left.
    while SSISR.read() & SSISR_BUSY != 0 {}
}

fn transfer(byte: u8) {
    while SSISR.read() & SSISR_TRANSMIT_NOT_FULL == 0 {}
    SSIDR.write(u32::from(byte));
    // SPI receives a byte for every byte sent. The panel's mean nothing, but they must be taken:
    // the emulated port stops sending when its receive FIFO is full.
    while SSISR.read() & SSISR_RECEIVE_NOT_EMPTY != 0 {
        SSIDR.read();
    }
}
