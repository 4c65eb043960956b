//! What a picture is drawn on: light for every pixel, depths, and a camera.

use std::convert::Infallible;

use aquatint::{
    Alpha, Angle, Blended, Frame, Light, Matrix, Model, OnDrawTarget, Rect, Scalar, Vector3, View, Words, World,
    fragment::shade::{LineShading, Shading},
    geometry::{light::Lamp, light::Lighting, projection::Lens, viewport::Viewport},
    hidden::depth::DepthBuffer,
    pipeline::{Camera, DrawError, Instance, MeshVertex, Scene, Unpainted, Workspace, draw_mesh, draw_wireframe},
};
use embedded_graphics::geometry::OriginDimensions;

pub const WIDTH: u32 = 92;
pub const HEIGHT: u32 = 76;

pub type Picture = Frame<Light, Words, Vec<u8>>;
pub type Drawn = Result<(), DrawError<Infallible>>;

pub struct Easel<'a> {
    pub picture: &'a mut Picture,
    pub depth: DepthBuffer<'a>,
    vertices: &'a mut [MeshVertex],
    pub camera: Camera,
    pub lamp: Lamp,
}

/// A picture by one of the scenes.
pub fn draw(scene: fn(&mut Easel) -> Drawn) -> Result<Picture, String> {
    let bytes = vec![0; Frame::<Light, Words, ()>::bytes_needed(WIDTH, HEIGHT)];
    let mut picture = Picture::new(bytes, WIDTH, HEIGHT).map_err(|error| error.to_string())?;
    let mut depths = vec![0_u16; WIDTH as usize * HEIGHT as usize];
    let window = Rect::of_size(picture.size());
    let depth = DepthBuffer::new(&mut depths, window).map_err(|error| error.to_string())?;
    let mut vertices = vec![MeshVertex::EMPTY; 1024];
    let camera = camera(window).ok_or("no camera")?;
    let mut easel = Easel { picture: &mut picture, depth, vertices: &mut vertices, camera, lamp: lamp() };
    scene(&mut easel).map_err(|error| error.to_string())?;
    Ok(picture)
}

impl Easel<'_> {
    /// Faces, in the light of the lamp.
    pub fn faces<S: Shading<Color = Light>>(&mut self, solid: &Instance<'_, S>) -> Drawn {
        self.faces_in(solid, self.lamp)
    }

    pub fn faces_in<S: Shading<Color = Light>>(&mut self, solid: &Instance<'_, S>, light: impl Lighting) -> Drawn {
        let Self { picture, depth, vertices, camera, .. } = self;
        draw_mesh(solid, &Scene { camera: *camera, light }, &mut Workspace { vertices, hidden: depth }, *picture)
    }

    /// Faces that only hide what is behind them.
    pub fn unseen<S: Shading>(&mut self, solid: &Instance<'_, S>) -> Drawn {
        let Self { depth, vertices, camera, lamp, .. } = self;
        let scene = Scene { camera: *camera, light: *lamp };
        draw_mesh(solid, &scene, &mut Workspace { vertices, hidden: depth }, &mut Unpainted::new())
    }

    pub fn edges<S: LineShading<Color = Light>>(&mut self, solid: &Instance<'_, S>) -> Drawn {
        let Self { picture, depth, vertices, camera, lamp } = self;
        let scene = Scene { camera: *camera, light: *lamp };
        draw_wireframe(solid, &scene, &mut Workspace { vertices, hidden: depth }, *picture)
    }

    /// Faces that are mixed with what is behind them.
    pub fn glass<S: Shading<Color = Alpha<Light>>>(&mut self, solid: &Instance<'_, S>) -> Drawn {
        let Self { picture, depth, vertices, camera, lamp } = self;
        let scene = Scene { camera: *camera, light: *lamp };
        let mut blended = Blended::new(*picture);
        draw_mesh(solid, &scene, &mut Workspace { vertices, hidden: depth }, &mut OnDrawTarget::new(&mut blended))
    }
}

pub fn number(value: f64) -> Scalar {
    Scalar::saturating_from_num(value)
}

/// Turned about the upright axis, then nodding.
pub fn turned(around: f32, down: f32) -> Matrix<Model, World> {
    Matrix::<Model, Model>::rotation_y(Angle::from_degrees(around)).then(&Matrix::rotation_x(Angle::from_degrees(down)))
}

/// Three away from the origin; a ball of radius 1 fills the height.
fn camera(window: Rect) -> Option<Camera> {
    let aspect = number(f64::from(window.width()) / f64::from(window.height()));
    let lens = Lens { field_of_view: Angle::from_degrees(40.0), aspect, near: Scalar::ONE, far: number(12.0) };
    Some(Camera {
        view: Matrix::<World, View>::translation(Scalar::ZERO, Scalar::ZERO, number(-3.0)),
        projection: Matrix::perspective(lens).ok()?,
        viewport: Viewport::new(window).ok()?,
    })
}

fn lamp() -> Lamp {
    let direction = Vector3::new(number(-3.0), number(2.2), number(1.4));
    Lamp { direction, ambient: Light(2_000), diffuse: Light(60_000) }
}
