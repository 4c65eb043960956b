//! Probes: scenes that other renderers have failed, each for every fill mode.

pub mod degenerate;
pub mod depth_pairs;
pub mod far_vertices;
pub mod near_plane;
pub mod shared_edges;
pub mod texture;
pub mod watertight;

use super::renderer::{Picture, Renderer, Scene, number};
use aquatint::{Matrix, Model, World};

/// Draws each triangle by itself and counts writes, so that nothing is hidden.
pub fn one_by_one<R: Renderer>(scene: &Scene) -> Picture {
    let mut picture = Picture::new(scene.camera.viewport.rect());
    for triangle in 0..scene.triangles.len() {
        R::draw(&[scene.only(triangle)], &mut picture).expect("in range");
    }
    picture
}

/// So many times as large, with mesh places between −2 and 2.
pub fn scaled(by: f64) -> Matrix<Model, World> {
    Matrix::scale(number(by))
}
