//! Wavefront OBJ files to the quantised arrays of a mesh.

use std::path::Path;

use aquatint::model::mesh::{Mesh, MeshError};

/// A mesh that owns its arrays.
#[derive(Clone, Debug)]
pub struct OwnedMesh {
    pub positions: Vec<[i16; 3]>,
    pub normals: Vec<[i8; 3]>,
    pub triangles: Vec<[u16; 3]>,
}

impl OwnedMesh {
    pub fn borrow(&self) -> Result<Mesh<'_>, MeshError> {
        Mesh::new(&self.positions, &self.normals, &self.triangles)
    }

    /// Centres a mesh, scales it into the unit sphere and quantises it. Normals may be missing.
    pub fn quantise(positions: &[[f32; 3]], normals: &[[f32; 3]], triangles: &[[u32; 3]]) -> Result<Self, String> {
        if triangles.is_empty() {
            return Err("has no triangles".into());
        }
        if positions.len() > 1 << 16 {
            return Err(format!("has {} vertices; 65536 is the limit", positions.len()));
        }
        if !positions.iter().flatten().all(|v| v.is_finite()) {
            return Err("has a coordinate that is not a number".into());
        }
        let count = positions.len();
        let index = |i: u32| u16::try_from(i).ok().filter(|&i| usize::from(i) < count);
        let valid = |t: &[u32; 3]| Some([index(t[0])?, index(t[1])?, index(t[2])?]);
        let triangles = triangles.iter().map(valid).collect::<Option<Vec<_>>>();
        let triangles = triangles.ok_or("names a vertex that does not exist")?;
        let smooth = smooth_normals(positions, &triangles);
        let normals = if normals.len() == count { normals } else { &smooth };
        Ok(Self { positions: unit_sphere(positions)?, normals: normals.iter().map(unit_normal).collect(), triangles })
    }
}

/// Longer files are refused rather than held in memory; 65536 vertices take some 5 MB.
const MOST_BYTES: u64 = 1 << 26;

/// Reads a file; what went wrong is a line that a person can act on.
pub fn load(path: &Path) -> Result<OwnedMesh, String> {
    let file = std::fs::metadata(path).map_err(|e| e.to_string())?;
    if file.len() > MOST_BYTES {
        return Err(format!("has {} bytes; {MOST_BYTES} are the limit", file.len()));
    }
    let text = std::fs::read(path).map_err(|e| e.to_string())?;
    let options = tobj::LoadOptions { triangulate: true, single_index: true, ..Default::default() };
    let (models, _) = tobj::load_obj_buf(&mut &text[..], &options, |_| Ok(Default::default()))
        .map_err(|e| format!("is not a Wavefront OBJ file: {e}"))?;
    let (mut positions, mut normals, mut triangles) = (vec![], vec![], vec![]);
    for model in &models {
        let base = u32::try_from(positions.len()).map_err(|_| "is too large")?;
        positions.extend(triples(&model.mesh.positions));
        normals.extend(triples(&model.mesh.normals));
        // Models of lines and points, which have fewer than three vertices a face, are left out.
        if model.mesh.face_arities.is_empty() {
            triangles.extend(triples(&model.mesh.indices).map(|t: [u32; 3]| t.map(|i| i.saturating_add(base))));
        }
    }
    OwnedMesh::quantise(&positions, &normals, &triangles)
}

fn triples<T: Copy>(flat: &[T]) -> impl Iterator<Item = [T; 3]> {
    flat.chunks_exact(3).map(|t| [t[0], t[1], t[2]])
}

/// Area-weighted normals: the sum of the cross products of the triangles around a vertex.
fn smooth_normals(positions: &[[f32; 3]], triangles: &[[u16; 3]]) -> Vec<[f32; 3]> {
    let mut normals = vec![[0.0; 3]; positions.len()];
    for t in triangles {
        let [a, b, c] = t.map(|i| positions[usize::from(i)]);
        let to = |p: [f32; 3]| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
        let ([bx, by, bz], [cx, cy, cz]) = (to(b), to(c));
        let cross = [by * cz - bz * cy, bz * cx - bx * cz, bx * cy - by * cx];
        for &i in t {
            for (sum, part) in normals[usize::from(i)].iter_mut().zip(cross) {
                *sum += part;
            }
        }
    }
    normals
}

#[expect(clippy::cast_possible_truncation, reason = "a float-to-int cast saturates")]
fn unit_normal(normal: &[f32; 3]) -> [i8; 3] {
    let length = normal.iter().map(|v| v * v).sum::<f32>().sqrt();
    if length > 0.0 { normal.map(|v| (v / length * 127.0).round() as i8) } else { [0; 3] }
}

/// 2.14 fixed point, the bounding box centred, the farthest vertex at distance 1.
#[expect(clippy::cast_possible_truncation, reason = "a float-to-int cast saturates")]
fn unit_sphere(positions: &[[f32; 3]]) -> Result<Vec<[i16; 3]>, String> {
    let along = |axis: usize| positions.iter().map(move |p| f64::from(p[axis]));
    let middle = [0, 1, 2].map(|axis| {
        let (low, high) = (along(axis).fold(f64::MAX, f64::min), along(axis).fold(f64::MIN, f64::max));
        f64::midpoint(low, high)
    });
    let centred = |p: &[f32; 3]| [0, 1, 2].map(|axis| f64::from(p[axis]) - middle[axis]);
    let radius = positions.iter().map(|p| centred(p).iter().map(|v| v * v).sum::<f64>()).fold(0.0, f64::max).sqrt();
    if radius <= 0.0 || !radius.is_finite() {
        return Err("has no extent".into());
    }
    Ok(positions.iter().map(|p| centred(p).map(|v| (v / radius * 16_384.0).round() as i16)).collect())
}
