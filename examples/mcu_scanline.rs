//! A scene of 400 × 240 pixels in less than 8 KiB of RAM, stack and all: no frame, no depth buffer, one line.
//!
//! A ball and a pyramid stand on the ground, in smooth light. The panel is a memory LCD of one bit a pixel, which takes its
//! lines one by one as they are made; QEMU has none, so the firmware prints what it sends.
//!
//! `cargo run --release --example mcu_scanline --target thumbv6m-none-eabi` runs it on QEMU's `lm3s6965evb` board. Run on
//! the desk, the same example prints the bytes that the firmware must have sent.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod scene;

#[cfg(target_os = "none")]
mod board;

use aquatint::{
    Angle, Dithered, Frame, Levels, Light, Matrix, Model, Point3, Rect, Rows, Scalar, Vector3, Window, World,
    model::{
        mesh::Mesh,
        revolved::{Parts, sphere_triangles, vertices},
    },
    pipeline::{Instance, Scanlines, Scene, SceneMemory},
};
use embedded_graphics::{pixelcolor::BinaryColor, prelude::*};

const PANEL: Rect = Rect::new(0, 0, 400, 240);
const FRAMES: u16 = 2;

/// Eight segments around, five from pole to pole.
static BALL: Parts<{ vertices(8, 5) }, { sphere_triangles(8, 5) }> = Parts::sphere::<8, 5>();

/// What the ground gives back of its light.
const DARK: Light = Light(24_000);

/// A square of sixteen units, and a pyramid on it.
const GROUND: Mesh<'static> = match Mesh::new(
    &[
        [-16_384, 0, -16_384],
        [16_384, 0, -16_384],
        [16_384, 0, 16_384],
        [-16_384, 0, 16_384],
        [800, 0, 900],
        [2_600, 0, 900],
        [1_700, 1_800, 0],
        [800, 0, -900],
        [2_600, 0, -900],
    ],
    &[
        [0, 127, 0],
        [0, 127, 0],
        [0, 127, 0],
        [0, 127, 0],
        [-90, 0, 90],
        [90, 0, 90],
        [0, 90, 90],
        [-90, 0, -90],
        [90, 0, -90],
    ],
    &[[0, 3, 2], [0, 2, 1], [4, 5, 6], [5, 8, 6], [8, 7, 6], [7, 4, 6]],
) {
    Ok(mesh) => match mesh.with_lights(&[
        DARK,
        DARK,
        DARK,
        DARK,
        Light::WHITE,
        Light::WHITE,
        Light::WHITE,
        Light::WHITE,
        Light::WHITE,
    ]) {
        Ok(mesh) => mesh,
        Err(_) => panic!("one light each"),
    },
    Err(_) => panic!("indices are right"),
};

/// Vertices of the ball and of the ground; faces that show; faces in one row.
type Memory = SceneMemory<{ vertices(8, 5) + 9 }, 40, 18>;

/// Where a mesh stands: its size, and its place, all in hundredths.
fn placed(turn: Angle, size: i32, place: [i32; 3]) -> Matrix<Model, World> {
    let number = |hundredths| Scalar::from_num(hundredths) / 100;
    let [x, y, z] = place.map(number);
    Matrix::<Model, Model>::rotation_y(turn)
        .then(&Matrix::<Model, Model>::scale(number(size)))
        .then(&Matrix::translation(x, y, z))
}

/// Seen from a little above.
#[inline(never)]
fn view() -> Option<Scene> {
    let [nil, one] = [Scalar::ZERO, Scalar::ONE];
    let mut scene = scene::scene(PANEL)?;
    let (eye, centre) = (Point3::new(nil, one, one * 3), Point3::new(nil, -one / 5, nil));
    scene.camera.view = Matrix::look_at(eye, centre, Vector3::new(nil, one, nil))?;
    Some(scene)
}

/// What stands where in a frame.
#[inline(never)]
fn instances(number: u16) -> Option<[Instance<'static>; 2]> {
    let turn = Angle(number.wrapping_mul(0x1400));
    let ground = Instance::new(GROUND, placed(turn, 800, [0, -80, 0]));
    Some([Instance::new(BALL.mesh().ok()?, placed(turn, 75, [-70, -5, -30])), ground])
}

/// Draws a frame, a line at a time, and gives each line to `send`. `None` if some of the constants above were wrong.
#[inline(never)]
fn draw(memory: &mut Memory, number: u16, mut send: impl FnMut(&[u8])) -> Option<()> {
    let mut line = Frame::<BinaryColor, Rows, _>::with_array([0; 50], 400, 1).ok()?;
    let instances = instances(number)?;
    let mut rows = Scanlines::new(PANEL, memory.lend());
    rows.begin(&instances, &view()?).ok()?;
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
