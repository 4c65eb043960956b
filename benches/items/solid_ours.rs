//! Solids as aquatint draws them: on a packed frame of one bit a pixel, with two bytes of depth a pixel.

use aquatint::{
    Angle, Dithered, Frame, Levels, Light, Matrix, Model, Rect, Rows, Scalar, Vector3, View, World,
    fragment::{
        shade::{Flat, Textured, Unlit},
        texture::{Sampler, Texture},
    },
    geometry::{light::Lamp, projection::Lens, viewport::Viewport},
    hidden::{convex::Convex, depth::DepthBuffer},
    model::mesh::Mesh,
    pipeline::{Camera, Instance, Material, MeshVertex, Scene, Workspace, draw_mesh},
};
use embedded_graphics::{
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Size},
    pixelcolor::BinaryColor,
};

use super::{
    solid::{Engine, angles},
    solid_models::{Model as Arrays, Solid},
    solid_wall::{SCALE, TEXTURE, Wall},
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
    /// By number.
    solids: [Mesh<'static>; 2],
}

impl<'m> Ours<'m> {
    pub fn new(memory: Memory<'m>, size: Size) -> Option<Self> {
        let rect = Rect::of_size(size);
        Some(Self {
            frame: Frame::new(memory.bytes, size.width, size.height).ok()?,
            depth: DepthBuffer::new(memory.depths, rect).ok()?,
            vertices: memory.vertices,
            scene: scene(rect)?,
            solids: [mesh(Solid::Cube)?, mesh(Solid::Torus)?],
        })
    }
}

fn mesh(solid: Solid) -> Option<Mesh<'static>> {
    mesh_of(solid.model())
}

pub fn mesh_of(model: Arrays) -> Option<Mesh<'static>> {
    let mesh = Mesh::new(model.positions, model.normals, model.triangles).ok()?;
    mesh.with_face_normals(model.face_normals).ok()
}

/// How a solid lies.
pub fn placement(frame: u16) -> Matrix<Model, World> {
    let [about_x, about_y] = angles(frame).map(Angle);
    Matrix::<Model, Model>::rotation_x(about_x).then(&Matrix::rotation_y(about_y))
}

/// The light of a texel: its code is an amount.
static GREYS: [Light; 256] = {
    let (mut lights, mut code) = ([Light::BLACK; 256], 0);
    while code < 256 {
        lights[code] = Light::naive_from_code(code.to_le_bytes()[0]);
        code += 1;
    }
    lights
};

/// Of 53.13°, whose half has the tangent ½.
const FIELD_OF_VIEW: Angle = Angle(9672);

pub fn scene(rect: Rect) -> Option<Scene> {
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
        let mut workspace = Workspace { vertices: self.vertices, hidden: &mut self.depth };
        let mut light = Dithered::new(&mut self.frame, Levels::ONE_BIT);
        // A solid that was refused would show as an empty picture.
        let _ = draw_mesh(
            &Instance::new(self.solids[solid as usize], placement(frame)),
            &self.scene,
            &mut workspace,
            &mut light,
        );
    }

    const HAS_FLAT: bool = true;

    fn flat(&mut self, solid: Solid, frame: u16) {
        self.darken();
        let instance = Instance::new(self.solids[solid as usize], placement(frame)).with_material(Material::new(Flat));
        let mut light = Dithered::new(&mut self.frame, Levels::ONE_BIT);
        let _ = if solid == Solid::Cube {
            let mut workspace = Workspace { vertices: self.vertices, hidden: &mut Convex };
            draw_mesh(&instance, &self.scene, &mut workspace, &mut light)
        } else {
            self.depth.clear();
            let mut workspace = Workspace { vertices: self.vertices, hidden: &mut self.depth };
            draw_mesh(&instance, &self.scene, &mut workspace, &mut light)
        };
    }

    const HAS_WALL: bool = true;

    fn wall(&mut self) {
        self.darken();
        self.depth.clear();
        let Wall { positions, uvs, triangles } = Wall::new(self.frame.size());
        let uvs = uvs.map(|uv| uv.map(|v| i16::try_from(v >> 4).unwrap_or(i16::MAX)));
        let mesh = Mesh::new(&positions, &[[0, 0, 127]; 4], &triangles).and_then(|mesh| mesh.with_uv(&uvs));
        let (Ok(mesh), Ok(texture)) = (mesh, Texture::new(&TEXTURE, 64, 64, &GREYS)) else { return };
        let shading = Textured::new(Sampler::new(texture), Unlit);
        let placement = Matrix::scale(Scalar::from_num(SCALE));
        let instance = Instance::new(mesh, placement).with_material(Material::new(shading));
        let mut scene = self.scene;
        scene.camera.view = Matrix::IDENTITY;
        let mut workspace = Workspace { vertices: self.vertices, hidden: &mut self.depth };
        let mut light = Dithered::new(&mut self.frame, Levels::ONE_BIT);
        let _ = draw_mesh(&instance, &scene, &mut workspace, &mut light);
    }

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
