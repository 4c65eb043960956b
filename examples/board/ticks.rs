//! Counts instructions with `SysTick`. Exact under `qemu-system-arm -icount shift=3`, and
//! only there.
//!
//! With that switch an instruction takes 8 ns of emulated time. RCC.SYSDIV = 0, which silicon does
//! not allow, makes a tick last 5 ns in QEMU, so there are 1.6 ticks to an instruction and none
//! hides between two ticks. The 24 bits of the counter hold 10,485,760 instructions; a handler
//! counts how often they ran out, and what the handler itself costs is measured and taken off.

use super::register::{Peripheral, Register};
use core::{
    arch::asm,
    hint::black_box,
    sync::atomic::{AtomicU32, Ordering, compiler_fence},
};
use cortex_m_rt::exception;

const RCC: Register = Register::new(Peripheral::SystemControl, 0x060);
const RCC_SYSDIV: u32 = 0xF << 23;

const SYST_CSR: Register = Register::new(Peripheral::CoreControl, 0x010);
const SYST_CSR_ENABLE: u32 = 1 << 0;
const SYST_CSR_TICKINT: u32 = 1 << 1;
const SYST_CSR_CLKSOURCE: u32 = 1 << 2;
const SYST_RVR: Register = Register::new(Peripheral::CoreControl, 0x014);
const SYST_RVR_MAX: u32 = 0x00FF_FFFF;
const SYST_CVR: Register = Register::new(Peripheral::CoreControl, 0x018);
const ICSR: Register = Register::new(Peripheral::CoreControl, 0xD04);
const ICSR_PENDSTSET: u32 = 1 << 26;

/// 2^24 ticks of 5 ns in instructions of 8 ns: no remainder.
const INSTRUCTIONS_A_WRAP: u32 = (1 << 24) / 8 * 5;

/// How often the handler ran since the counter was started.
static WRAPS: AtomicU32 = AtomicU32::new(0);

#[exception]
fn SysTick() {
    // The only writer while the counter runs: load and store will do, and Cortex-M0 has no more.
    WRAPS.store(WRAPS.load(Ordering::Relaxed) + 1, Ordering::Relaxed);
}

/// Instructions since `start`, those of the handler among them, and how often it ran.
#[derive(Clone, Copy, Debug)]
struct Reading {
    instructions: u32,
    handled: u32,
}

/// The instructions that `work` takes, up to 4 × 10⁹.
///
/// Two runs of the same binary agree exactly. The number is right to ±3: that much can the
/// compiler's code around `work` differ from the code around the empty work taken off.
pub fn measure(work: impl FnOnce()) -> u32 {
    let nothing = bracket(|| ()).instructions;
    // The handler called by hand, against the same code with the request left out. The wrap that
    // it counts then is none.
    let request = |bits| bracket(|| ICSR.write(black_box(bits))).instructions;
    let handler = request(ICSR_PENDSTSET).wrapping_sub(INSTRUCTIONS_A_WRAP + request(0));

    let taken = bracket(work);
    taken.instructions.wrapping_sub(nothing).wrapping_sub(taken.handled.wrapping_mul(handler))
}

/// Runs `work` between two readings and gives their difference.
#[inline(never)]
fn bracket(work: impl FnOnce()) -> Reading {
    start();
    let before = read();
    compiler_fence(Ordering::SeqCst); // Keeps the work's memory accesses between the readings.
    work();
    compiler_fence(Ordering::SeqCst);
    let after = read();
    // Off between measurements: waiting for the host would else go on counting wraps.
    SYST_CSR.write(0);
    Reading {
        instructions: after.instructions.wrapping_sub(before.instructions),
        handled: after.handled.wrapping_sub(before.handled),
    }
}

fn start() {
    RCC.clear(RCC_SYSDIV);
    WRAPS.store(0, Ordering::Relaxed);
    SYST_RVR.write(SYST_RVR_MAX);
    SYST_CVR.write(0); // Any write clears it; the next tick loads it from RVR.
    SYST_CSR.write(SYST_CSR_ENABLE | SYST_CSR_TICKINT | SYST_CSR_CLKSOURCE);
}

/// Every call takes the same instructions: no branch, so that the difference of two is exact.
#[inline(never)]
fn read() -> Reading {
    // SAFETY: masks interrupts for a few instructions; nothing here relies on them being masked
    // or not, and no caller has them masked.
    unsafe { asm!("cpsid i", options(nostack, preserves_flags)) };
    let left = SYST_CVR.read();
    let pending = ICSR.read();
    let handled = WRAPS.load(Ordering::Relaxed);
    // SAFETY: undoes the above.
    unsafe { asm!("cpsie i", options(nostack, preserves_flags)) };

    // A wrap whose handler has still to run, and that came before `left` was read: then `left` is
    // large. Small, it means that the counter ran out just after.
    let unhandled = (pending >> 26) & (left >> 23);
    let wraps = handled + (unhandled & 1);
    let ticks = SYST_RVR_MAX - left;
    // Both scales began in the same instruction, so to the nearest is exact, whatever the phase.
    Reading { instructions: wraps * INSTRUCTIONS_A_WRAP + (ticks * 5 + 4) / 8, handled }
}
