//! How deep the stack has been: paint what lies below it, see later how much paint is left.

use core::arch::asm;

unsafe extern "C" {
    /// The first word after the static variables, from cortex-m-rt's linker script.
    static mut __sheap: u32;
    /// The word after the stack's first, which grows down from the end of RAM.
    static _stack_start: u32;
}

const PAINT: u32 = 0xC0DE_5EED;

/// Paints the free RAM. To be called first thing in `main`, while no interrupt is on that could
/// put its frame where the paint goes.
#[inline(never)]
pub fn paint() {
    // SAFETY: between the last static variable and the stack pointer lies RAM that nobody owns:
    // there is no heap here. Being one block, it cannot be parted by code that moves the pointer.
    unsafe {
        asm!(
            "mov {end}, sp",
            "2:",
            "cmp {word}, {end}",
            "bhs 3f",
            "str {paint}, [{word}]",
            "adds {word}, #4",
            "b 2b",
            "3:",
            word = inout(reg) &raw mut __sheap => _,
            end = out(reg) _,
            paint = in(reg) PAINT,
            options(nostack),
        );
    }
}

/// Bytes of stack used at most since `paint`, and at least those in use then.
#[inline(never)]
pub fn high_water() -> u32 {
    let top = &raw const _stack_start;
    let mut word = (&raw const __sheap).cast::<u32>();
    // SAFETY: reads words of RAM, all of them initialised by `paint` or by the stack over it.
    while word < top && unsafe { word.read_volatile() } == PAINT {
        word = word.wrapping_add(1);
    }
    (top as u32).wrapping_sub(word as u32)
}
