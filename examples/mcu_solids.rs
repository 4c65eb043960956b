//! Two built-in solids on a 128 × 64 OLED of four bits a pixel: a textured ball in smooth light, and a dodecahedron whose
//! faces carry their edges.
//!
//! `cargo run --release --example mcu_solids --target thumbv7m-none-eabi` runs it on QEMU's
//! `lm3s6965evb` board and shows what its panel shows. Run on the desk, the same example prints
//! the bytes that the firmware must have sent.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod scene;

#[cfg(target_os = "none")]
mod board;

use aquatint::{
    Dithered, Frame, Levels, Light, Rect, Rows, Target,
    fragment::{
        shade::{Flat, Gouraud, Plain, Textured},
        texture::{Sampler, Texture},
    },
    geometry::light::Surface,
    hidden::{convex::Convex, depth::DepthBuffer},
    model::{
        revolved::{Parts, sphere_triangles, vertices},
        solids::DODECAHEDRON,
    },
    pipeline::{DepthBias, Instance, Material, MeshVertex, Workspace, draw_mesh, draw_wireframe},
};
use embedded_graphics::{pixelcolor::Gray4, prelude::*};

/// Frames that are shown: an eighth of a turn.
const FRAMES: u16 = 8;
/// The parts of the panel that the two solids fill.
const LEFT: Rect = Rect::new(0, 0, 64, 64);
const RIGHT: Rect = Rect::new(64, 0, 128, 64);

/// Sixteen segments around, ten from pole to pole.
static BALL: Parts<{ vertices(16, 10) }, { sphere_triangles(16, 10) }> = Parts::sphere::<16, 10>();

/// Bricks, 64 × 32 texels of a bit each.
static BRICKS: [u8; 256] = {
    let rows = [0b1110_1111, 0b1110_1111, 0b1110_1111, 0, 0b1111_1110, 0b1111_1110, 0b1111_1110, 0];
    let (mut bytes, mut at) = ([0; 256], 0);
    while at < bytes.len() {
        bytes[at] = rows[at / 8 % 8];
        at += 1;
    }
    bytes
};
/// What its two codes stand for.
static MORTAR_AND_BRICK: [Light; 2] = [Light(6_000), Light::WHITE];

/// All the memory that a picture takes, 14 KiB. Zero bytes, so that none of it takes flash.
struct Memory {
    bytes: [u8; 128 * 64 / 2],
    depths: [u16; 64 * 64],
    vertices: [MeshVertex; vertices(16, 10)],
}

impl Memory {
    const NEW: Self =
        Self { bytes: [0; 128 * 64 / 2], depths: [0; 64 * 64], vertices: [MeshVertex::EMPTY; vertices(16, 10)] };
}

/// Draws one frame; `None` if some of the constants above were wrong. A function of its own, so that a
/// profiler can count it alone.
#[inline(never)]
fn draw(memory: &mut Memory, number: u16) -> Option<()> {
    let Memory { bytes, depths, vertices } = memory;
    let mut frame = Frame::<Gray4, Rows, _>::new(&mut bytes[..], 128, 64).ok()?;
    let Ok(()) = frame.clear(Gray4::BLACK);
    // The emulated panel shows code n as the grey 17n of a monitor.
    let mut light = Dithered::new(&mut frame, Levels::SRGB_16);
    ball(&mut light, vertices, number)?;
    dodecahedron(&mut light, (vertices, depths), number)
}

/// Convex, so it needs no depth.
fn ball(light: &mut impl Target<Color = Light>, vertices: &mut [MeshVertex], number: u16) -> Option<()> {
    let texture = Texture::new(&BRICKS, 64, 32, &MORTAR_AND_BRICK).ok()?;
    let shading = Textured::new(Sampler::new(texture), Gouraud);
    let ball = Instance::new(BALL.mesh().ok()?, scene::placement(number)).with_material(Material::new(shading));
    draw_mesh(&ball, &scene::scene(LEFT)?, &mut Workspace { vertices, hidden: &mut Convex }, light).ok()
}

/// Flat grey faces, and white lines on them.
fn dodecahedron(
    light: &mut impl Target<Color = Light>,
    (vertices, depths): (&mut [MeshVertex], &mut [u16]),
    number: u16,
) -> Option<()> {
    let (scene, placement) = (scene::scene(RIGHT)?, scene::placement(number.wrapping_mul(3)));
    let mut depth = DepthBuffer::new(depths, RIGHT).ok()?;
    let mut workspace = Workspace { vertices, hidden: &mut depth };
    let solid = Instance::new(DODECAHEDRON, placement);
    let (bias, surface) = (DepthBias::BEHIND_LINES, Surface { diffuse: 28_000, ..Surface::MATTE });
    let faces = solid.with_material(Material { bias, surface, ..Material::new(Flat) });
    draw_mesh(&faces, &scene, &mut workspace, light).ok()?;
    let edges = solid.with_material(Material::new(Plain(Light::WHITE)));
    draw_wireframe(&edges, &scene, &mut workspace, light).ok()
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
