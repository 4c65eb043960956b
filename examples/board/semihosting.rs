//! Text to and from the host through the debugger (Arm semihosting), without `fmt`.
//!
//! Only under QEMU or a debugger: with neither, the breakpoint is a fault.

use core::arch::asm;

const SYS_WRITEC: usize = 0x03;
const SYS_READC: usize = 0x07;
const SYS_EXIT_EXTENDED: usize = 0x20;
const ADP_STOPPED_APPLICATION_EXIT: usize = 0x2_0026;

/// One request to the host; `argument` points to what the operation reads.
fn call(operation: usize, argument: *const usize) -> usize {
    let answer;
    // SAFETY: the host takes the operation in r0 and its argument in r1, answers in r0 and
    // changes nothing else. None of the operations used here writes to the firmware's memory.
    unsafe {
        asm!(
            "bkpt 0xAB",
            inout("r0") operation => answer,
            in("r1") argument,
            options(nostack, preserves_flags),
        );
    }
    answer
}

/// Prints one byte.
pub fn putc(byte: u8) {
    let word = usize::from(byte); // The host reads the first byte of it: little-endian.
    call(SYS_WRITEC, &raw const word);
}

/// Prints a string.
pub fn puts(text: &str) {
    for byte in text.bytes() {
        putc(byte);
    }
}

/// Prints a number in decimal.
pub fn decimal(mut value: u32) {
    let mut unit = 1_000_000_000;
    while unit > 1 && value < unit {
        unit /= 10;
    }
    while unit > 0 {
        let mut digit = b'0';
        while value >= unit {
            value -= unit;
            digit += 1;
        }
        putc(digit);
        unit /= 10;
    }
}

/// Prints bytes as pairs of hexadecimal digits.
pub fn hex(bytes: &[u8]) {
    for byte in bytes {
        for nibble in [byte >> 4, byte & 15] {
            putc(nibble + if nibble < 10 { b'0' } else { b'a' - 10 });
        }
    }
}

/// Waits for a byte from the host.
pub fn getc() -> u8 {
    call(SYS_READC, core::ptr::null()).to_le_bytes()[0]
}

/// Ends the run with an exit code.
pub fn exit(code: u8) -> ! {
    let reason = [ADP_STOPPED_APPLICATION_EXIT, usize::from(code)];
    loop {
        // Again and again: a debugger may let the core go on.
        call(SYS_EXIT_EXTENDED, (&raw const reason).cast());
    }
}
