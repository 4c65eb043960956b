//! A scene of 400 × 240 pixels in less than 8 KiB of RAM, stack and all: no frame, no depth buffer, one line.
//!
//! A ball and a cube stand on the ground, in smooth light. The panel is a memory LCD of one bit a pixel, which takes its
//! lines one by one as they are made; QEMU has none, so the firmware prints what it sends.
//!
//! `cargo run --release --example mcu_scanline --target thumbv6m-none-eabi` runs it on QEMU's `lm3s6965evb` board. Run on
//! the desk, the same example prints the bytes that the firmware must have sent.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod scene;

#[cfg(target_os = "none")]
mod board;

use aquatint::{
    Angle, Dithered, Frame, Levels, Matrix, Model, Point3, Rect, Rows, Scalar, Vector3, Window, World,
    model::{
        mesh::Mesh,
        revolved::{Parts, sphere_triangles, vertices},
        solids::CUBE_FACES,
    },
    pipeline::{Instance, Scanlines, Scene, SceneMemory},
};
use embedded_graphics::{pixelcolor::BinaryColor, prelude::*};

const PANEL: Rect = Rect::new(0, 0, 400, 240);
const FRAMES: u16 = 2;

/// Ten segments around, six from pole to pole.
static BALL: Parts<{ vertices(10, 6) }, { sphere_triangles(10, 6) }> = Parts::sphere::<10, 6>();

/// A square of sixteen units.
const GROUND: Mesh<'static> = match Mesh::new(
    &[[-16_384, 0, -16_384], [16_384, 0, -16_384], [16_384, 0, 16_384], [-16_384, 0, 16_384]],
    &[[0, 127, 0]; 4],
    &[[0, 3, 2], [0, 2, 1]],
) {
    Ok(mesh) => mesh,
    Err(_) => panic!("indices are right"),
};

/// Vertices of the ball, the cube and the ground; faces that show; faces in one row.
type Memory = SceneMemory<{ vertices(10, 6) + 24 + 4 }, 64, 24>;

/// Where a mesh stands: its size, and its place on the ground.
fn placed(turn: Angle, size: f32, [x, y, z]: [f32; 3]) -> Matrix<Model, World> {
    let number = Scalar::saturating_from_num;
    Matrix::<Model, Model>::rotation_y(turn)
        .then(&Matrix::<Model, Model>::scale(number(size)))
        .then(&Matrix::translation(number(x), number(y), number(z)))
}

/// From a little above.
fn view() -> Option<Scene> {
    let [nil, one] = [Scalar::ZERO, Scalar::ONE];
    let mut scene = scene::scene(PANEL)?;
    let (eye, centre) = (Point3::new(nil, one, one * 3), Point3::new(nil, -one / 5, nil));
    scene.camera.view = Matrix::look_at(eye, centre, Vector3::new(nil, one, nil))?;
    Some(scene)
}

/// Draws a frame, a line at a time, and gives each line to `send`. `None` if some of the constants above were wrong.
#[inline(never)]
fn draw(memory: &mut Memory, number: u16, mut send: impl FnMut(&[u8])) -> Option<()> {
    let turn = Angle(number.wrapping_mul(0x1400));
    let mut ground = Instance::new(GROUND, placed(Angle(0), 8.0, [0.0, -0.8, 0.0]));
    ground.material.surface.diffuse = 24_000;
    let instances = [
        Instance::new(BALL.mesh().ok()?, placed(turn, 0.75, [-0.7, -0.05, -0.3])),
        Instance::new(CUBE_FACES, placed(turn, 0.7, [0.9, -0.4, 0.1])),
        ground,
    ];
    let mut line = Frame::<BinaryColor, Rows, _>::with_array([0; 50], 400, 1).ok()?;
    let mut rows = Scanlines::new(&instances, &view()?, PANEL, memory.lend()).ok()?;
    while let Some(row) = rows.row() {
        let Ok(()) = line.clear(BinaryColor::Off);
        let mut band = Window::band(&mut line, row);
        let Ok(()) = rows.draw_row(&mut Dithered::new(&mut band, Levels::ONE_BIT));
        send(line.bytes());
    }
    Some(())
}

#[cfg(target_os = "none")]
#[cortex_m_rt::entry]
fn main() -> ! {
    // First in the function: the entry macro makes it a mutable reference that only `main` has.
    static mut MEMORY: Memory = Memory::NEW;
    use board::{report, semihosting, stack, ticks};

    stack::paint();
    for number in 0..FRAMES {
        // Once to see what is sent, and once to count, without printing.
        for prints in [true, false] {
            if prints {
                semihosting::puts("sent ");
                semihosting::decimal(number.into());
                semihosting::puts(" ");
            }
            let send = |line: &[u8]| {
                if prints {
                    semihosting::hex(line);
                }
            };
            let mut drawn = None;
            let instructions = ticks::measure(|| drawn = draw(MEMORY, number, send));
            if drawn.is_none() {
                semihosting::exit(1);
            }
            if prints {
                semihosting::puts("\n");
            } else {
                report("instructions", instructions);
            }
        }
    }
    report("stack", stack::high_water());
    semihosting::exit(0)
}

#[cfg(not(target_os = "none"))]
fn main() {
    let mut memory = Box::new(Memory::NEW);
    for number in 0..FRAMES {
        print!("sent {number} ");
        let print = |line: &[u8]| line.iter().for_each(|byte| print!("{byte:02x}"));
        draw(&mut memory, number, print).expect("the constants fit");
        println!();
    }
}
