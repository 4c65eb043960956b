//! A second model that needs no file.

use std::f32::consts::TAU;

use crate::obj::OwnedMesh;

/// A ring: 36 by 20 faces, cut into triangles.
pub fn torus() -> Result<OwnedMesh, String> {
    const AROUND: u16 = 36;
    const ACROSS: u16 = 20;
    let vertices = (0..AROUND).flat_map(|i| (0..ACROSS).map(move |j| (i, j)));
    let (positions, normals): (Vec<_>, Vec<_>) = vertices
        .map(|(i, j)| {
            let (u, v) = (f32::from(i) / f32::from(AROUND) * TAU, f32::from(j) / f32::from(ACROSS) * TAU);
            let normal = [u.cos() * v.cos(), v.sin(), u.sin() * v.cos()];
            ([u.cos() + 0.45 * normal[0], 0.45 * normal[1], u.sin() + 0.45 * normal[2]], normal)
        })
        .unzip();
    let at = |i: u16, j: u16| u32::from(i % AROUND * ACROSS + j % ACROSS);
    let faces = (0..AROUND).flat_map(|i| (0..ACROSS).map(move |j| (i, j))).flat_map(|(i, j)| {
        let [a, b, c, d] = [at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)];
        [[a, b, c], [a, c, d]]
    });
    OwnedMesh::quantise(&positions, &normals, &faces.collect::<Vec<_>>())
}
