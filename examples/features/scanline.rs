//! Two solids without a frame: eight rows at a time, each row drawn once.

use aquatint::{
    Dithered, Frame, Light, Matrix, Rect, Scalar, Window, World,
    model::solids::{CUBE, DODECAHEDRON},
    pipeline::{Instance, Scanlines, SceneMemory},
};

use super::{Feature, PANEL, Screen};
use crate::{
    panel::{Color, LEVELS, Layout, WIDTH},
    scene,
};

/// Rows that are sent together: a page of one bit a pixel.
const BAND: u32 = 8;
const BYTES: usize = Frame::<Color, Layout, ()>::bytes_needed(WIDTH, BAND);
const VERTICES: usize = CUBE.positions().len() + DODECAHEDRON.positions().len();

/// Eight rows, and what of the scene is in them.
pub struct Scanline {
    bytes: [u8; BYTES],
    memory: SceneMemory<VERTICES, 32, 16>,
}

impl Feature for Scanline {
    const NEW: Self = Self { bytes: [0; BYTES], memory: SceneMemory::NEW };

    fn draw(&mut self, number: u16, screen: &mut impl Screen) -> Option<()> {
        let instances = instances(number);
        let mut rows = Scanlines::new(PANEL, self.memory.lend());
        rows.begin(&instances, &scene::scene(PANEL)?).ok()?;
        while let Some(top) = rows.row() {
            let band = Rect::new(PANEL.left, top, PANEL.right, (top + BAND.cast_signed()).min(PANEL.bottom));
            let mut frame = Frame::<Color, Layout, _>::new(&mut self.bytes[..], WIDTH, BAND).ok()?;
            let mut window = Window::band(&mut frame, top);
            let mut light = Dithered::new(&mut window, LEVELS);
            let Ok(()) = light.fill_area(band, Light::BLACK);
            for _ in band.rows() {
                let Ok(()) = rows.draw_row(&mut light);
            }
            screen.window(band);
            screen.data(frame.bytes());
        }
        Some(())
    }
}

/// A cube in front of a dodecahedron.
fn instances(number: u16) -> [Instance<'static>; 2] {
    let beside = |turn: u16, half: i32| {
        let [side, before] = [Scalar::from_num(half) / 2, Scalar::from_num(-half) / 4];
        scene::placement(turn).then(&Matrix::<World, World>::translation(side, Scalar::ZERO, before))
    };
    [Instance::new(CUBE, beside(number * 5, -1)), Instance::new(DODECAHEDRON, beside(number * 2, 1))]
}
