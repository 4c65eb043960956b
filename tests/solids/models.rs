//! Closed meshes: a cube, a torus and a bunny.

use core::f64::consts::TAU;

use aquatint::{Rect, model::mesh::Mesh};

use super::renderer::{Scene, camera, place, unit};

const BUNNY: Mesh<'static> = include!("../../examples/assets/bunny.rs");

/// A mesh to be placed. Its coordinates are within 2.
pub struct Model {
    pub name: &'static str,
    positions: Vec<[i16; 3]>,
    normals: Vec<[i8; 3]>,
    triangles: Vec<[u16; 3]>,
}

impl Model {
    /// The mesh in a pose.
    pub fn scene(&self, placement: aquatint::Matrix<aquatint::Model, aquatint::World>, view: Rect) -> Scene {
        // A texture from the front through to the back.
        let uv = |[x, y, _]: &[i16; 3]| [x, y].map(|v| 0.5 + f64::from(*v) / 80_000.0);
        Scene {
            positions: self.positions.clone(),
            normals: self.normals.clone(),
            uvs: self.positions.iter().map(uv).collect(),
            triangles: self.triangles.clone(),
            face_normals: self.triangles.iter().map(|triangle| self.face_normal(*triangle)).collect(),
            placement,
            camera: camera(view),
        }
    }

    fn face_normal(&self, triangle: [u16; 3]) -> [i8; 3] {
        let [a, b, c] = triangle.map(|corner| self.positions[usize::from(corner)].map(f64::from));
        let way = |to: [f64; 3]| [0, 1, 2].map(|axis| to[axis] - a[axis]);
        let ([bx, by, bz], [cx, cy, cz]) = (way(b), way(c));
        normal(unit([by * cz - bz * cy, bz * cx - bx * cz, bx * cy - by * cx]))
    }
}

/// Edge 2, normals along the diagonals.
pub fn cube() -> Model {
    let side = |vertex: usize, axis: usize| if vertex >> axis & 1 == 1 { 1.0 } else { -1.0 };
    let faces = [[1, 3, 7, 5], [0, 4, 6, 2], [2, 6, 7, 3], [0, 1, 5, 4], [4, 5, 7, 6], [0, 2, 3, 1]];
    Model {
        name: "cube",
        positions: (0..8).map(|vertex| place([0, 1, 2].map(|axis| side(vertex, axis)))).collect(),
        normals: (0..8).map(|vertex| normal([0, 1, 2].map(|axis| side(vertex, axis) / 3_f64.sqrt()))).collect(),
        triangles: faces.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect(),
    }
}

/// 28 × 18 segments about the z axis, radii 1 and 0.5.
pub fn torus() -> Model {
    let (around, across) = (28, 18);
    let segments = || (0..around).flat_map(move |i| (0..across).map(move |j| (i, j)));
    let (mut positions, mut normals) = (vec![], vec![]);
    for (i, j) in segments() {
        let (u, v) = (f64::from(i) / f64::from(around) * TAU, f64::from(j) / f64::from(across) * TAU);
        let from_axis = 1.0 + 0.5 * v.cos();
        positions.push(place([from_axis * u.cos(), from_axis * u.sin(), 0.5 * v.sin()]));
        normals.push(normal([v.cos() * u.cos(), v.cos() * u.sin(), v.sin()]));
    }
    let at = |i: u16, j: u16| i % around * across + j % across;
    let faces = segments().flat_map(|(i, j)| {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    Model { name: "torus", positions, normals, triangles: faces.collect() }
}

/// That of the examples.
pub fn bunny() -> Model {
    Model {
        name: "bunny",
        positions: BUNNY.positions().to_vec(),
        normals: BUNNY.normals().to_vec(),
        triangles: BUNNY.triangles().collect(),
    }
}

#[expect(clippy::cast_possible_truncation, reason = "a float-to-int cast saturates")]
fn normal(unit: [f64; 3]) -> [i8; 3] {
    unit.map(|v| (v * 127.0).round() as i8)
}
