//! The OLED of the board lm3s811evb: an SSD0303 with 96×16 pixels of one bit, eight rows to a byte, the upper one lowest.
//!
//! It hangs on I²C at address 3Dh. QEMU's model obeys pages, columns and data, one command to a transfer.

use super::register::{Peripheral, Register};
use core::{
    ops::Range,
    sync::atomic::{AtomicU32, Ordering},
};

const RCGC1: Register = Register::new(Peripheral::SystemControl, 0x104);
const RCGC1_I2C: u32 = 1 << 12;
const RCGC2: Register = Register::new(Peripheral::SystemControl, 0x108);
const RCGC2_PORT_B: u32 = 1 << 1;

const PORT_B_AFSEL: Register = Register::new(Peripheral::GpioPortB, 0x420);
const PORT_B_ODR: Register = Register::new(Peripheral::GpioPortB, 0x50C);
const PORT_B_DEN: Register = Register::new(Peripheral::GpioPortB, 0x51C);
/// PB2 is the clock, PB3 the data; both are open drain.
const I2C_PINS: u32 = 1 << 2 | 1 << 3;

const I2CMSA: Register = Register::new(Peripheral::I2c, 0x000);
const PANEL_ADDRESS: u32 = 0x3D << 1;
const I2CMCS: Register = Register::new(Peripheral::I2c, 0x004);
const I2CMCS_RUN: u32 = 1 << 0;
const I2CMCS_START: u32 = 1 << 1;
const I2CMCS_STOP: u32 = 1 << 2;
const I2CMCS_BUSY: u32 = 1 << 0;
const I2CMDR: Register = Register::new(Peripheral::I2c, 0x008);
const I2CMTPR: Register = Register::new(Peripheral::I2c, 0x00C);
/// The core starts at 12 MHz: 12 / (20 · (1 + 1)) = 300 kHz on the wire.
const I2CMTPR_PERIOD: u32 = 1;
const I2CMCR: Register = Register::new(Peripheral::I2c, 0x020);
const I2CMCR_MASTER: u32 = 1 << 4;

/// Before a command, and before data.
const COMMAND: u8 = 0x80;
const DATA: u8 = 0x40;

const SET_PAGE: u8 = 0xB0;
const SET_COLUMN_LOW: u8 = 0x00;
const SET_COLUMN_HIGH: u8 = 0x10;
/// The panel's left column in the controller's memory.
const FIRST_COLUMN: u8 = 36;

/// Bytes that were sent, commands too; the address that begins a transfer is none.
static SENT: AtomicU32 = AtomicU32::new(0);

/// Bytes that were sent since the start, commands too.
pub fn bytes_sent() -> u32 {
    SENT.load(Ordering::Relaxed)
}

/// Wakes the port and the panel.
pub fn init() {
    RCGC1.set(RCGC1_I2C);
    RCGC2.set(RCGC2_PORT_B);
    RCGC2.read(); // A clock needs three cycles before its peripheral may be touched.

    PORT_B_AFSEL.set(I2C_PINS);
    PORT_B_ODR.set(I2C_PINS);
    PORT_B_DEN.set(I2C_PINS);

    I2CMCR.write(I2CMCR_MASTER);
    I2CMTPR.write(I2CMTPR_PERIOD);
    I2CMSA.write(PANEL_ADDRESS);

    // Off, start line 0, unmirrored, show the memory, not inverted, top row first, on.
    for byte in [0xAE, 0x40, 0xA0, 0xA4, 0xA6, 0xC0, 0xAF] {
        command(byte);
    }
}

/// Where data go: columns of some pages, from left to right and then down.
#[derive(Clone, Debug)]
pub struct Window {
    columns: Range<u8>,
    page: u8,
    column: u8,
}

impl Window {
    pub const fn new(columns: Range<u8>, first_page: u8) -> Self {
        let column = columns.start;
        Self { columns, page: first_page, column }
    }

    /// Sends columns of eight pixels. Further calls go on where the last one stopped.
    pub fn data(&mut self, mut bytes: &[u8]) {
        while let Some((now, rest)) =
            bytes.split_at_checked(self.room().min(bytes.len())).filter(|(now, _)| !now.is_empty())
        {
            self.run(now);
            bytes = rest;
        }
    }

    /// Columns up to the end of the page.
    fn room(&self) -> usize {
        usize::from(self.columns.end.saturating_sub(self.column))
    }

    /// Columns of one page.
    fn run(&mut self, bytes: &[u8]) {
        let column = self.column + FIRST_COLUMN;
        command(SET_PAGE | self.page);
        command(SET_COLUMN_LOW | column & 15);
        command(SET_COLUMN_HIGH | column >> 4);
        transfer(DATA, bytes);
        self.column += u8::try_from(bytes.len()).unwrap_or(0); // No more than there is room for.
        if self.column == self.columns.end {
            (self.column, self.page) = (self.columns.start, self.page + 1);
        }
    }
}

fn command(byte: u8) {
    transfer(COMMAND, &[byte]);
}

/// One transfer: what it is, and its bytes.
fn transfer(kind: u8, bytes: &[u8]) {
    // Load and store: Cortex-M0 has no more, and nobody else writes.
    SENT.store(bytes_sent() + 1 + u32::try_from(bytes.len()).unwrap_or(0), Ordering::Relaxed);
    put(kind, I2CMCS_START | I2CMCS_RUN);
    for &byte in bytes {
        put(byte, I2CMCS_RUN);
    }
    I2CMCS.write(I2CMCS_STOP);
}

fn put(byte: u8, how: u32) {
    I2CMDR.write(byte.into());
    I2CMCS.write(how);
    while I2CMCS.read() & I2CMCS_BUSY != 0 {}
}
