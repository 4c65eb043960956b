//! Solids as aquatint draws them: on a packed frame of one bit a pixel, with two bytes of depth a pixel.

use aquatint::{
    Angle, Dithered, Frame, Levels, Light, Matrix, Model, Rect, Rows, Scalar, Vector3, View, World,
    geometry::{light::Lamp, projection::Lens, viewport::Viewport},
    hidden::depth::DepthBuffer,
    model::mesh::Mesh,
    pipeline::{Camera, Instance, MeshVertex, Scene, Workspace, draw_mesh},
};
use embedded_graphics::{
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Size},
    pixelcolor::BinaryColor,
};

use super::{
    solid::{Engine, angles},
    solid_models::Solid,
};

/// What is lent: a bit and a depth a pixel, and a vertex for each of the largest solid.
pub struct Memory<'m> {
    pub bytes: &'m mut [u8],
    pub depths: &'m mut [u16],
    pub vertices: &'m mut [MeshVertex],
}

pub struct Ours<'m> {
    frame: Frame<BinaryColor, Rows, &'m mut [u8]>,
    depth: DepthBuffer<'m>,
    vertices: &'m mut [MeshVertex],
    scene: Scene,
    cube: Mesh<'static>,
    torus: Mesh<'static>,
}

impl<'m> Ours<'m> {
    pub fn new(memory: Memory<'m>, size: Size) -> Option<Self> {
        let rect = Rect::of_size(size);
        Some(Self {
            frame: Frame::new(memory.bytes, size.width, size.height).ok()?,
            depth: DepthBuffer::new(memory.depths, rect).ok()?,
            vertices: memory.vertices,
            scene: scene(rect)?,
            cube: mesh(Solid::Cube)?,
            torus: mesh(Solid::Torus)?,
        })
    }
}

fn mesh(solid: Solid) -> Option<Mesh<'static>> {
    let model = solid.model();
    Mesh::new(model.positions, model.normals, model.triangles).ok()
}

/// Of 53.13°, whose half has the tangent ½.
const FIELD_OF_VIEW: Angle = Angle(9672);

fn scene(rect: Rect) -> Option<Scene> {
    let number = |thousandths: i32| Scalar::from_num(thousandths) / 1000;
    let aspect = Scalar::from_num(rect.width()) / Scalar::from_num(rect.height());
    let lens = Lens { field_of_view: FIELD_OF_VIEW, aspect, near: number(400), far: number(20_000) };
    let direction = Vector3::new(number(400), number(600), number(690));
    let camera = Camera {
        view: Matrix::<World, View>::translation(Scalar::ZERO, Scalar::ZERO, number(-4000)),
        projection: Matrix::perspective(lens).ok()?,
        viewport: Viewport::new(rect).ok()?,
    };
    Some(Scene { camera, light: Lamp { direction, ambient: Light(6_554), diffuse: Light(58_981) } })
}

impl Engine for Ours<'_> {
    fn size(&self) -> Size {
        self.frame.size()
    }

    fn darken(&mut self) {
        let Ok(()) = self.frame.clear(BinaryColor::Off);
    }

    fn frame(&mut self, solid: Solid, frame: u16) {
        self.darken();
        self.depth.clear();
        let [about_x, about_y] = angles(frame).map(Angle);
        let placement = Matrix::<Model, Model>::rotation_x(about_x).then(&Matrix::rotation_y(about_y));
        let mesh = match solid {
            Solid::Cube => self.cube,
            Solid::Torus => self.torus,
        };
        let mut workspace = Workspace { vertices: self.vertices, hidden: &mut self.depth };
        let mut light = Dithered::new(&mut self.frame, Levels::ONE_BIT);
        // A solid that was refused would show as an empty picture.
        let _ = draw_mesh(&Instance::new(mesh, placement), &self.scene, &mut workspace, &mut light);
    }

    /// Set when [`wall`](Engine::wall) draws.
    const HAS_WALL: bool = false;

    /// The pipeline has no textures yet.
    fn wall(&mut self) {}

    fn picture(&self, look: impl FnOnce(&[u8])) {
        look(self.frame.bytes());
    }

    #[cfg(not(target_os = "none"))]
    fn covered(&mut self) -> Vec<bool> {
        let window = self.depth.window();
        let mut row = |row| self.depth.run(row, window.columns()).expect("inside").iter().map(|&z| z > 0).collect();
        window.rows().flat_map(|y| -> Vec<bool> { row(y) }).collect()
    }
}
