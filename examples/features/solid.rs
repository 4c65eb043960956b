//! A solid in smooth light, with a depth buffer.

use aquatint::{
    Dithered, Rect,
    hidden::depth::DepthBuffer,
    model::solids::ICOSAHEDRON,
    pipeline::{Instance, MeshVertex, Workspace, draw_mesh},
};

use super::{BYTES, Feature, Screen, black, send};
use crate::{
    panel::{HEIGHT, LEVELS},
    scene,
};

/// A square at the left.
const AREA: Rect = Rect::new(0, 0, HEIGHT.cast_signed(), HEIGHT.cast_signed());

/// An icosahedron that turns.
pub struct Solid {
    bytes: [u8; BYTES],
    depths: [u16; (HEIGHT * HEIGHT) as usize],
    vertices: [MeshVertex; ICOSAHEDRON.positions().len()],
}

impl Feature for Solid {
    const NEW: Self = Self {
        bytes: [0; BYTES],
        depths: [0; (HEIGHT * HEIGHT) as usize],
        vertices: [MeshVertex::EMPTY; ICOSAHEDRON.positions().len()],
    };

    fn draw(&mut self, number: u16, screen: &mut impl Screen) -> Option<()> {
        let Self { bytes, depths, vertices } = self;
        let mut picture = black(bytes)?;
        let mut light = Dithered::new(&mut picture, LEVELS);
        let mut depth = DepthBuffer::new(depths, AREA).ok()?;
        let mut workspace = Workspace { vertices, hidden: &mut depth };
        let instance = Instance::new(ICOSAHEDRON, scene::placement(number * 2));
        draw_mesh(&instance, &scene::scene(AREA)?, &mut workspace, &mut light).ok()?;
        send(&picture, screen);
        Some(())
    }
}
