//! A solid in smooth light, with a depth buffer.

use aquatint::{
    Dithered, Light, Rect,
    hidden::depth::DepthBuffer,
    model::solids::ICOSAHEDRON,
    pipeline::{Instance, MeshVertex, Workspace, draw_mesh},
};

use super::{Feature, PICTURE, Picture, Screen, send};
use crate::{
    panel::{HEIGHT, LEVELS},
    scene,
};

/// A square at the left.
const AREA: Rect = Rect::new(0, 0, HEIGHT.cast_signed(), HEIGHT.cast_signed());

/// An icosahedron that turns.
pub struct Solid {
    picture: Picture,
    depths: [u16; (HEIGHT * HEIGHT) as usize],
    vertices: [MeshVertex; ICOSAHEDRON.positions().len()],
}

impl Feature for Solid {
    const NEW: Self = Self {
        picture: PICTURE,
        depths: [0; (HEIGHT * HEIGHT) as usize],
        vertices: [MeshVertex::EMPTY; ICOSAHEDRON.positions().len()],
    };

    fn draw(&mut self, number: u16, screen: &mut impl Screen) -> Option<()> {
        let Self { picture, depths, vertices } = self;
        let mut light = Dithered::new(picture, LEVELS);
        let Ok(()) = light.fill_area(AREA, Light::BLACK);
        let mut depth = DepthBuffer::new(depths, AREA).ok()?;
        let mut workspace = Workspace { vertices, hidden: &mut depth };
        let instance = Instance::new(ICOSAHEDRON, scene::placement(number * 2));
        draw_mesh(&instance, &scene::scene(AREA)?, &mut workspace, &mut light).ok()?;
        send(picture, screen)
    }
}
