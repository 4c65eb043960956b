//! Counts on a Cortex-M what `cargo bench` counts on the desk: the instructions of each item.
//!
//! `.ci/firmware bench` runs it as Cortex-M0, M3 and M4 and writes `benches/results.tsv`. It prints
//! lines `count ITEM WHO INSTRUCTIONS`. The board has not enough flash for all items at once: `BENCH_PART` says,
//! when compiling, which of them.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
mod board;

#[cfg(target_os = "none")]
#[path = "../benches/items/mod.rs"]
mod items;

#[cfg(target_os = "none")]
use aquatint::pipeline::{MeshVertex, SceneMemory};

#[cfg(target_os = "none")]
#[cortex_m_rt::entry]
fn main() -> ! {
    // First in the function: the entry macro makes it a mutable reference that only `main` has.
    static mut MEMORY: [u8; items::MEMORY] = [0; items::MEMORY];
    static mut DEPTHS: [u16; 128 * 64] = [0; 128 * 64];
    static mut VERTICES: [MeshVertex; items::solid_models::VERTICES] =
        [MeshVertex::EMPTY; items::solid_models::VERTICES];
    static mut SMOOTH: items::scanline::Smooth = SceneMemory::NEW;
    static mut FLAT: items::scanline::Soup = SceneMemory::NEW;

    match option_env!("BENCH_PART") {
        Some("pages") => items::pages(MEMORY, &mut counting::Printer),
        Some("rows") => items::rows(MEMORY, &mut counting::Printer),
        Some("grey") => items::grey(MEMORY, &mut counting::Printer),
        Some("solid") => {
            items::solids(
                items::solid_ours::Memory { bytes: MEMORY, depths: DEPTHS, vertices: VERTICES },
                &mut counting::Printer,
            );
        }
        Some("scanline") => {
            items::scanline::turning(MEMORY, SMOOTH, &mut counting::Printer);
            items::scanline::triangles(MEMORY, FLAT, &mut counting::Printer);
        }
        _ => items::single(MEMORY, &mut counting::Printer),
    }
    board::semihosting::exit(0)
}

#[cfg(target_os = "none")]
mod counting {
    use core::hint::black_box;

    use crate::{
        board::{
            semihosting::{decimal, exit, puts},
            ticks,
        },
        items::{self, Draw, Label, Surface, Visitor},
    };

    /// Counts each item and prints the number.
    pub struct Printer;

    impl Visitor for Printer {
        fn visit<S: Surface>(&mut self, label: Label, surface: &mut S, draw: Draw<S>) {
            let something = instructions(surface, draw);
            let nothing = instructions(surface, items::nothing);
            print(label, something.wrapping_sub(nothing) / u32::from(label.frames));
        }
    }

    /// What one call takes, on a dark surface.
    fn instructions<S: Surface>(surface: &mut S, draw: Draw<S>) -> u32 {
        let mut is_drawn = items::darken(surface).is_ok();
        let taken = ticks::measure(|| is_drawn &= black_box(draw)(black_box(surface)).is_ok());
        if !is_drawn {
            exit(1);
        }
        taken
    }

    fn print(label: Label, count: u32) {
        for text in ["count ", label.item, "/", label.panel, " ", label.who, " "] {
            puts(text);
        }
        decimal(count);
        puts("\n");
    }
}

#[cfg(not(target_os = "none"))]
fn main() {
    println!("this one is firmware: run .ci/firmware bench");
}
