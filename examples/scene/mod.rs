//! The spinning mesh that the desk and the firmware draw alike.
#![allow(dead_code, reason = "each example uses a part")]

use aquatint::{
    Angle, Light, Matrix, Model, Rect, Scalar, Vector3, View, World,
    geometry::{light::Lamp, projection::Lens, viewport::Viewport},
    model::mesh::Mesh,
    pipeline::{Camera, Scene},
};

/// The Stanford bunny, 1839 vertices and 3674 triangles.
pub const BUNNY: Mesh<'static> = include!("../assets/bunny.rs");

/// Frames in which the mesh turns once around.
pub const FRAMES_PER_TURN: u16 = 64;

/// In parts of a turn: 65536 / 64.
const TURN_A_FRAME: u16 = 1024;

/// A camera three units away from a mesh of radius 1, filling `area`; `None` for an empty one.
pub fn scene(area: Rect) -> Option<Scene> {
    let aspect = Scalar::checked_from_num(area.width())?.checked_div(Scalar::checked_from_num(area.height())?)?;
    // The unit sphere touches the upper and lower borders.
    let field_of_view = Angle::from_degrees(if aspect < 1 { 47.0 } else { 39.0 });
    let lens = Lens { field_of_view, aspect, near: Scalar::ONE, far: Scalar::from_num(8) };
    let camera = Camera {
        view: Matrix::<World, View>::translation(Scalar::ZERO, Scalar::ZERO, Scalar::from_num(-3)),
        projection: Matrix::perspective(lens).ok()?,
        viewport: Viewport::new(area).ok()?,
    };
    let light = Lamp {
        direction: Vector3::new(Scalar::from_num(-2), Scalar::from_num(3), Scalar::from_num(3)),
        ambient: Light(2_500),
        diffuse: Light(62_000),
    };
    Some(Scene { camera, light })
}

/// Where the mesh stands in a frame: turned about the upright axis, and nodding a little.
pub fn placement(frame: u16) -> Matrix<Model, World> {
    // Angles wrap at a full turn by themselves.
    turned(Angle(frame.wrapping_mul(TURN_A_FRAME)), Angle(0x400))
}

/// The mesh turned by two angles, as by a hand that drags.
pub fn turned(around: Angle, down: Angle) -> Matrix<Model, World> {
    Matrix::<Model, Model>::rotation_y(around).then(&Matrix::rotation_x(down))
}
