//! What a picture is made of, drawn as light on any target: a photograph, a ramp, a mesh.

use std::convert::Infallible;

use aquatint::{
    Light, Matrix, Model, Rect, Target, World,
    hidden::depth::DepthBuffer,
    model::mesh::Mesh,
    pipeline::{Instance, MeshVertex, Workspace, draw_mesh},
};

use crate::{photo::Photo, scene};

pub fn show_photo(target: &mut impl Target<Color = Light, Error = Infallible>, place: Rect, photo: &Photo) {
    for (row, lights) in place.rows().zip(photo.rows()) {
        let Ok(()) = target.write_run(row, place.columns(), lights.iter().copied().map(Some));
    }
}

/// Black to white, in equal steps of light.
pub fn show_ramp(target: &mut impl Target<Color = Light, Error = Infallible>, place: Rect) {
    let steps = (place.width().max(2) - 1) as usize;
    let light = |at: usize| u16::try_from(at * usize::from(u16::MAX) / steps).unwrap_or(u16::MAX);
    for row in place.rows() {
        let Ok(()) = target.write_run(row, place.columns(), (0..).map(|at| Some(Light(light(at)))));
    }
}

/// A mesh on black, as it stands in the world.
pub fn show_mesh(
    target: &mut impl Target<Color = Light, Error = Infallible>,
    place: Rect,
    mesh: Mesh<'_>,
    placement: Matrix<Model, World>,
) -> Result<(), String> {
    for row in place.rows() {
        let Ok(()) = target.fill_run(row, place.columns(), [Light::BLACK]);
    }
    let mut vertices = vec![MeshVertex::default(); mesh.positions().len()];
    let mut depths = vec![0_u16; place.width() as usize * place.height() as usize];
    let mut depth = DepthBuffer::new(&mut depths, place).map_err(|e| format!("{e:?}"))?;
    let mut workspace = Workspace { vertices: &mut vertices, hidden: &mut depth };
    let scene = scene::scene(place).ok_or("no camera")?;
    draw_mesh(&Instance::new(mesh, placement), &scene, &mut workspace, target).map_err(|e| format!("{e:?}"))
}
