//! Wavefront OBJ files to the quantised arrays of a mesh.
#![allow(dead_code, reason = "each example uses a part")]

use std::{collections::HashMap, path::Path};

use aquatint::model::mesh::{Mesh, MeshError};

/// A mesh as files have it. Normals and texture coordinates are one for each position, or none.
#[derive(Clone, Debug, Default)]
pub struct RawMesh {
    pub positions: Vec<[f32; 3]>,
    pub normals: Vec<[f32; 3]>,
    /// v runs up.
    pub uv: Vec<[f32; 2]>,
    pub triangles: Vec<[u32; 3]>,
}

impl RawMesh {
    /// Refuses what no mesh can be made of.
    fn checked(&self) -> Result<&Self, String> {
        if self.triangles.is_empty() {
            return Err("has no triangles".into());
        }
        if !self.positions.iter().flatten().chain(self.uv.iter().flatten()).all(|v| v.is_finite()) {
            return Err("has a coordinate that is not a number".into());
        }
        Ok(self)
    }

    /// Puts vertices together that are the same in everything. Triangles that lose a side by that are left out.
    pub fn merged(&self) -> Result<Self, String> {
        let count = self.checked()?.positions.len();
        let (has_normals, has_uv) = (self.normals.len() == count, self.uv.len() == count);
        let (mut merged, mut numbers, mut known) = (Self::default(), Vec::with_capacity(count), HashMap::new());
        for (vertex, position) in self.positions.iter().enumerate() {
            let normal = has_normals.then(|| self.normals[vertex]);
            let uv = has_uv.then(|| self.uv[vertex]);
            // A zero is the same with either sign.
            let bits = |v: f32| (v + 0.0).to_bits();
            let key = (position.map(bits), normal.map(|n| n.map(bits)), uv.map(|t| t.map(bits)));
            let next = merged.positions.len();
            let number = *known.entry(key).or_insert(next);
            if number == next {
                merged.positions.push(*position);
                merged.normals.extend(normal);
                merged.uv.extend(uv);
            }
            numbers.push(u32::try_from(number).map_err(|_| "is too large")?);
        }
        for triangle in &self.triangles {
            let number = |i: u32| usize::try_from(i).ok().and_then(|i| numbers.get(i)).copied();
            let [a, b, c] = triangle.map(number);
            let [a, b, c] = [a, b, c].map(|n| n.ok_or("names a vertex that does not exist"));
            let corners = [a?, b?, c?];
            if corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0] {
                merged.triangles.push(corners);
            }
        }
        if merged.triangles.is_empty() {
            return Err("has no triangle with an area".into());
        }
        Ok(merged)
    }

    /// Its normals, or smooth ones where it has none.
    pub fn shading_normals(&self) -> Vec<[f32; 3]> {
        let has_normals = self.normals.len() == self.positions.len();
        if has_normals { self.normals.clone() } else { smooth_normals(&self.positions, &self.triangles) }
    }

    /// The middle of the bounding box, and how far the farthest vertex is from there.
    pub fn sphere(&self) -> Result<([f64; 3], f64), String> {
        let along = |axis: usize| self.positions.iter().map(move |p| f64::from(p[axis]));
        let middle = [0, 1, 2].map(|axis| {
            let (low, high) = (along(axis).fold(f64::MAX, f64::min), along(axis).fold(f64::MIN, f64::max));
            f64::midpoint(low, high)
        });
        let squares = self.positions.iter().map(|p| centred(p, middle).iter().map(|v| v * v).sum::<f64>());
        let radius = squares.fold(0.0, f64::max).sqrt();
        if radius > 0.0 && radius.is_finite() { Ok((middle, radius)) } else { Err("has no extent".into()) }
    }
}

/// A mesh that owns its arrays.
#[derive(Clone, Debug)]
pub struct OwnedMesh {
    pub positions: Vec<[i16; 3]>,
    pub normals: Vec<[i8; 3]>,
    /// Empty, or one for each position.
    pub uv: Vec<[i16; 2]>,
    pub triangles: Vec<[u16; 3]>,
}

impl OwnedMesh {
    pub fn borrow(&self) -> Result<Mesh<'_>, MeshError> {
        let mesh = Mesh::new(&self.positions, &self.normals, &self.triangles)?;
        if self.uv.is_empty() { Ok(mesh) } else { mesh.with_uv(&self.uv) }
    }

    /// Centres a mesh, scales it into the unit sphere and quantises it.
    pub fn of(raw: &RawMesh) -> Result<Self, String> {
        if raw.checked()?.positions.len() > 1 << 16 {
            return Err(format!("has {} vertices; 65536 is the limit", raw.positions.len()));
        }
        let index = |i: u32| u16::try_from(i).ok().filter(|&i| usize::from(i) < raw.positions.len());
        let valid = |t: &[u32; 3]| Some([index(t[0])?, index(t[1])?, index(t[2])?]);
        let triangles = raw.triangles.iter().map(valid).collect::<Option<Vec<_>>>();
        let (middle, radius) = raw.sphere()?;
        Ok(Self {
            positions: raw.positions.iter().map(|p| quantised_place(p, middle, radius)).collect(),
            normals: raw.shading_normals().iter().map(unit_normal).collect(),
            uv: raw
                .uv
                .iter()
                .copied()
                .map(quantised_uv)
                .collect::<Option<_>>()
                .ok_or("has texture coordinates beyond 8")?,
            triangles: triangles.ok_or("names a vertex that does not exist")?,
        })
    }

    /// The same from arrays. Normals may be missing.
    pub fn quantise(positions: &[[f32; 3]], normals: &[[f32; 3]], triangles: &[[u32; 3]]) -> Result<Self, String> {
        let (positions, normals) = (positions.to_vec(), normals.to_vec());
        Self::of(&RawMesh { positions, normals, uv: vec![], triangles: triangles.to_vec() })
    }
}

/// Longer files are refused rather than held in memory; 65536 vertices take some 5 MB.
const MOST_BYTES: u64 = 1 << 26;

/// The bytes of a file; what went wrong is a line that a person can act on.
pub fn bytes(path: &Path) -> Result<Vec<u8>, String> {
    let file = std::fs::metadata(path).map_err(|e| e.to_string())?;
    if file.len() > MOST_BYTES {
        return Err(format!("has {} bytes; {MOST_BYTES} are the limit", file.len()));
    }
    std::fs::read(path).map_err(|e| e.to_string())
}

/// Reads a file.
pub fn load(path: &Path) -> Result<OwnedMesh, String> {
    OwnedMesh::of(&read(&bytes(path)?)?)
}

/// The text of a Wavefront OBJ file.
pub fn read(text: &[u8]) -> Result<RawMesh, String> {
    let options = tobj::LoadOptions { triangulate: true, single_index: true, ..Default::default() };
    let (models, _) = tobj::load_obj_buf(&mut &*text, &options, |_| Ok(Default::default()))
        .map_err(|e| format!("is not a Wavefront OBJ file: {e}"))?;
    let mut raw = RawMesh::default();
    for model in &models {
        let base = u32::try_from(raw.positions.len()).map_err(|_| "is too large")?;
        raw.positions.extend(groups(&model.mesh.positions));
        raw.normals.extend(groups(&model.mesh.normals));
        raw.uv.extend(model.mesh.texcoords.chunks_exact(2).map(|t| [t[0], t[1]]));
        // Models of lines and points, which have fewer than three vertices a face, are left out.
        if model.mesh.face_arities.is_empty() {
            raw.triangles.extend(groups(&model.mesh.indices).map(|t: [u32; 3]| t.map(|i| i.saturating_add(base))));
        }
    }
    Ok(raw)
}

fn groups<T: Copy>(flat: &[T]) -> impl Iterator<Item = [T; 3]> {
    flat.chunks_exact(3).map(|t| [t[0], t[1], t[2]])
}

/// Area-weighted normals: the sum of the cross products of the triangles around a vertex.
fn smooth_normals(positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> Vec<[f32; 3]> {
    let mut normals = vec![[0.0; 3]; positions.len()];
    let at = |i: u32| usize::try_from(i).unwrap_or(usize::MAX);
    for t in triangles {
        let [a, b, c] = t.map(|i| positions.get(at(i)).copied().unwrap_or_default());
        let to = |p: [f32; 3]| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
        let ([bx, by, bz], [cx, cy, cz]) = (to(b), to(c));
        let cross = [by * cz - bz * cy, bz * cx - bx * cz, bx * cy - by * cx];
        for &i in t {
            if let Some(normal) = normals.get_mut(at(i)) {
                normal.iter_mut().zip(cross).for_each(|(sum, part)| *sum += part);
            }
        }
    }
    normals
}

pub fn centred(place: &[f32; 3], middle: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|axis| f64::from(place[axis]) - middle[axis])
}

/// 2.14 fixed point, the bounding box centred, the farthest vertex at distance 1.
#[expect(clippy::cast_possible_truncation, reason = "a float-to-int cast saturates")]
fn quantised_place(place: &[f32; 3], middle: [f64; 3], radius: f64) -> [i16; 3] {
    centred(place, middle).map(|v| (v / radius * 16_384.0).round() as i16)
}

#[expect(clippy::cast_possible_truncation, reason = "a float-to-int cast saturates")]
fn unit_normal(normal: &[f32; 3]) -> [i8; 3] {
    let length = normal.iter().map(|v| v * v).sum::<f32>().sqrt();
    if length > 0.0 { normal.map(|v| (v / length * 127.0).round() as i8) } else { [0; 3] }
}

/// 4.12 fixed point, v downwards from the upper left corner.
#[expect(clippy::cast_possible_truncation, reason = "a float-to-int cast saturates")]
fn quantised_uv([u, v]: [f32; 2]) -> Option<[i16; 2]> {
    let parts = [u, 1.0 - v].map(|v| (v * 4096.0).round());
    parts.iter().all(|v| (-32_768.0..=32_767.0).contains(v)).then(|| parts.map(|v| v as i16))
}
