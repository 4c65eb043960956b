//! The spinning mesh on a 128 × 64 OLED of four bits a pixel, drawn by a Cortex-M from flash.
//!
//! `cargo run --release --example mcu_oled --target thumbv7m-none-eabi` runs it on QEMU's
//! `lm3s6965evb` board and shows what its panel shows. Run on the desk, the same example prints
//! the bytes that the firmware must have sent.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod scene;

#[cfg(target_os = "none")]
mod board;

#[cfg(target_os = "none")]
use aquatint::model::assembly::Assembly;
use aquatint::{
    Dithered, Frame, Levels, Rect, Rows,
    hidden::depth::DepthBuffer,
    pipeline::{Instance, MeshVertex, Workspace, draw_mesh},
};
use embedded_graphics::{
    mono_font::{MonoTextStyle, ascii::FONT_6X10},
    pixelcolor::Gray4,
    prelude::*,
    text::Text,
};

/// Frames that are shown: an eighth of a turn.
const FRAMES: u16 = 8;
/// The part of the panel that the mesh fills.
const AREA: Rect = Rect::new(0, 0, 64, 64);

/// All the memory that a picture takes, 34 KiB. Zero bytes, so that none of it takes flash.
struct Memory {
    bytes: [u8; 128 * 64 / 2],
    depths: [u16; 64 * 64],
    vertices: [MeshVertex; scene::BUNNY.positions().len()],
}

impl Memory {
    #[expect(clippy::large_stack_arrays, reason = "the firmware has it in a static")]
    const NEW: Self = Self {
        bytes: [0; 128 * 64 / 2],
        depths: [0; 64 * 64],
        vertices: [MeshVertex::EMPTY; scene::BUNNY.positions().len()],
    };
}

/// What of the flash is the mesh.
#[cfg(target_os = "none")]
const MESH_BYTES: usize = {
    let mesh = scene::BUNNY;
    let triangles = match mesh.assembly() {
        Assembly::Triangles(triangles) => triangles.len(),
        _ => 0,
    };
    mesh.positions().len() * 9 + triangles * 6
};

/// Draws one frame; `None` if some of the constants above were wrong. A function of its own, so that a
/// profiler can count it alone.
#[inline(never)]
fn draw(memory: &mut Memory, number: u16) -> Option<()> {
    let mut frame = Frame::<Gray4, Rows, _>::new(&mut memory.bytes[..], 128, 64).ok()?;
    let Ok(()) = frame.clear(Gray4::BLACK);
    let mut depth = DepthBuffer::new(&mut memory.depths, AREA).ok()?;
    let mut workspace = Workspace { vertices: &mut memory.vertices, hidden: &mut depth };
    let instance = Instance::new(scene::BUNNY, scene::placement(number));
    // The emulated panel shows code n as the grey 17n of a monitor.
    let mut light = Dithered::new(&mut frame, Levels::SRGB_16);
    draw_mesh(&instance, &scene::scene(AREA)?, &mut workspace, &mut light).ok()?;
    let style = MonoTextStyle::new(&FONT_6X10, Gray4::WHITE);
    let Ok(_) = Text::new("aquatint", Point::new(72, 34), style).draw(&mut frame);
    Some(())
}

#[cfg(target_os = "none")]
#[cortex_m_rt::entry]
fn main() -> ! {
    // First in the function: the entry macro makes it a mutable reference that only `main` has.
    static mut MEMORY: Memory = Memory::NEW;
    use board::{report, semihosting, show, ssd0323, stack, ticks};

    stack::paint();
    ssd0323::init();
    for number in 0..FRAMES {
        let mut drawn = None;
        let instructions = ticks::measure(|| drawn = draw(MEMORY, number));
        if drawn.is_none() {
            semihosting::exit(1);
        }
        show(number.into(), &MEMORY.bytes);
        report("instructions", instructions);
    }
    report("stack", stack::high_water());
    report("mesh", u32::try_from(MESH_BYTES).unwrap_or(0));
    semihosting::exit(0)
}

#[cfg(not(target_os = "none"))]
fn main() {
    let mut memory = Memory::NEW;
    for number in 0..FRAMES {
        draw(&mut memory, number).expect("the constants fit");
        print!("frame {number} ");
        for byte in memory.bytes {
            print!("{byte:02x}");
        }
        println!();
    }
}
