//! Runs the entries on the board and prints how deep the stack was.

use core::{arch::asm, hint::black_box};

use crate::{
    board::{report, semihosting, stack},
    hostile,
};

unsafe extern "C" {
    /// The word after the stack's first, from cortex-m-rt's linker script.
    static _stack_start: u32;
}

/// Calls an entry with hostile values, many times, and prints what it used at most of the stack.
///
/// The name is printed first, so that it is known which entry hangs.
pub fn call<M>(name: &str, entry: fn(&mut M), memory: &mut M, rounds: u32) {
    semihosting::puts("entry ");
    semihosting::puts(name);
    semihosting::puts("\n");
    report("used", deepest(entry, memory, rounds));
}

/// Bytes of stack below this function's own.
#[inline(never)]
fn deepest<M>(entry: fn(&mut M), memory: &mut M, rounds: u32) -> u32 {
    stack::paint();
    for round in 0..rounds {
        hostile::begin(round);
        black_box(entry)(memory);
    }
    let in_use = (&raw const _stack_start).addr() as u32 - stack_pointer();
    stack::high_water() - in_use
}

/// Inlined: that of the caller.
#[inline(always)]
fn stack_pointer() -> u32 {
    let here;
    // SAFETY: reads a register.
    unsafe { asm!("mov {}, sp", out(reg) here, options(nomem, nostack, preserves_flags)) };
    here
}

/// After the last entry.
pub fn end() -> ! {
    semihosting::exit(0)
}
