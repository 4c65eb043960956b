//! Indexed triangle meshes, quantised so that a thousand triangles take 15 kB of flash.

use super::assembly::{Assembly, Faces};
use crate::{colour::Light, error::describe};

/// A mesh: vertices with a place and a normal, and triangles that name three of them.
///
/// Places are 2.14 fixed point: 16384 is 1.0, the range is −2 to 2 − 2⁻¹⁴. Normals have a length of
/// 127. Front faces run counter-clockwise as seen from outside.
///
/// A constant mesh is checked while compiling:
///
/// ```
/// use aquatint::model::mesh::Mesh;
///
/// const ONE: i16 = 16384;
/// const TETRAHEDRON: Mesh = match Mesh::new(
///     &[[ONE, ONE, ONE], [-ONE, -ONE, ONE], [-ONE, ONE, -ONE], [ONE, -ONE, -ONE]],
///     &[[73, 73, 73], [-73, -73, 73], [-73, 73, -73], [73, -73, -73]],
///     &[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
/// ) {
///     Ok(mesh) => mesh,
///     Err(_) => panic!("bad mesh"),
/// };
/// assert_eq!(TETRAHEDRON.triangles().count(), 4);
/// ```
///
/// What else a vertex or a face may have is added by the methods whose names begin with `with`.
#[derive(Clone, Copy, Debug)]
pub struct Mesh<'a> {
    positions: &'a [[i16; 3]],
    normals: &'a [[i8; 3]],
    assembly: Assembly<'a>,
    uv: Option<&'a [[i16; 2]]>,
    lights: Option<&'a [Light]>,
    face_normals: Option<&'a [[i8; 3]]>,
}

/// Why arrays do not make a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum MeshError {
    /// The number of normals is not the number of positions.
    NormalCount,
    /// This triangle names a vertex that does not exist.
    NoSuchVertex {
        /// The triangle, counted from 0.
        triangle: usize,
    },
    /// This index of a strip, a fan or a polygon names a vertex that does not exist.
    NoSuchIndex {
        /// The index, counted from 0.
        at: usize,
    },
    /// A polygon has fewer than three corners, or all together do not have as many as there are indices.
    PolygonCounts,
    /// The number of texture coordinates is not the number of positions.
    UvCount,
    /// The number of lights is not the number of positions.
    LightCount,
    /// The number of face normals is not the number of faces.
    FaceNormalCount {
        /// How many faces there are.
        needed: usize,
    },
}

describe! { MeshError,
    Self::NormalCount => "there is not one normal for each position";
    Self::NoSuchVertex { triangle } => "triangle {triangle} names a vertex that does not exist";
    Self::NoSuchIndex { at } => "index {at} names a vertex that does not exist";
    Self::PolygonCounts => "polygons have fewer than 3 corners, or do not add up to the indices";
    Self::UvCount => "there is not one texture coordinate for each position";
    Self::LightCount => "there is not one light for each position";
    Self::FaceNormalCount { needed } => "there is not one normal for each of the {needed} faces";
}

impl<'a> Mesh<'a> {
    /// Borrows and checks three arrays.
    ///
    /// # Errors
    /// [`MeshError`]: the arrays do not fit together.
    pub const fn new(
        positions: &'a [[i16; 3]],
        normals: &'a [[i8; 3]],
        triangles: &'a [[u16; 3]],
    ) -> Result<Self, MeshError> {
        Self::with_assembly(positions, normals, Assembly::Triangles(triangles))
    }

    /// A mesh whose triangles come from a strip, fans or polygons.
    ///
    /// # Errors
    /// [`MeshError`]: the arrays do not fit together.
    pub const fn with_assembly(
        positions: &'a [[i16; 3]],
        normals: &'a [[i8; 3]],
        assembly: Assembly<'a>,
    ) -> Result<Self, MeshError> {
        if positions.len() != normals.len() {
            return Err(MeshError::NormalCount);
        }
        if !assembly.adds_up() {
            return Err(MeshError::PolygonCounts);
        }
        match (assembly.first_wrong(positions.len()), assembly) {
            (None, _) => Ok(Self { positions, normals, assembly, uv: None, lights: None, face_normals: None }),
            (Some(triangle), Assembly::Triangles(_)) => Err(MeshError::NoSuchVertex { triangle }),
            (Some(at), _) => Err(MeshError::NoSuchIndex { at }),
        }
    }

    /// The mesh with texture coordinates, one for each vertex: 4.12 fixed point, 4096 is the width of the texture,
    /// u to the right and v down from its upper left corner. Beyond it, to ±8, the texture repeats.
    ///
    /// # Errors
    /// [`MeshError::UvCount`].
    pub const fn with_uv(self, uv: &'a [[i16; 2]]) -> Result<Self, MeshError> {
        if uv.len() == self.positions.len() { Ok(Self { uv: Some(uv), ..self }) } else { Err(MeshError::UvCount) }
    }

    /// The mesh with the own light of each vertex: what the lecture calls its colour.
    ///
    /// # Errors
    /// [`MeshError::LightCount`].
    pub const fn with_lights(self, lights: &'a [Light]) -> Result<Self, MeshError> {
        let fits = lights.len() == self.positions.len();
        if fits { Ok(Self { lights: Some(lights), ..self }) } else { Err(MeshError::LightCount) }
    }

    /// The mesh with normals of its faces, for flat shading and for [finding
    /// backs](crate::geometry::face::faces_viewer) early: one for each polygon, or for each triangle of the
    /// [assembly](Self::faces), of length 127.
    ///
    /// # Errors
    /// [`MeshError::FaceNormalCount`].
    pub const fn with_face_normals(self, normals: &'a [[i8; 3]]) -> Result<Self, MeshError> {
        let needed = self.assembly.face_count();
        if normals.len() == needed {
            Ok(Self { face_normals: Some(normals), ..self })
        } else {
            Err(MeshError::FaceNormalCount { needed })
        }
    }

    /// Places of the vertices, in 2.14.
    #[must_use]
    pub const fn positions(&self) -> &'a [[i16; 3]] {
        self.positions
    }

    /// Normals of the vertices, of length 127.
    #[must_use]
    pub const fn normals(&self) -> &'a [[i8; 3]] {
        self.normals
    }

    /// Texture coordinates of the vertices, in 4.12.
    #[must_use]
    pub const fn uv(&self) -> Option<&'a [[i16; 2]]> {
        self.uv
    }

    /// The vertices' own light.
    #[must_use]
    pub const fn lights(&self) -> Option<&'a [Light]> {
        self.lights
    }

    /// Normals of the faces, of length 127, by the number of the face.
    #[must_use]
    pub const fn face_normals(&self) -> Option<&'a [[i8; 3]]> {
        self.face_normals
    }

    /// How its indices make triangles.
    #[must_use]
    pub const fn assembly(&self) -> Assembly<'a> {
        self.assembly
    }

    /// Its triangles, and of which face each is.
    #[must_use]
    pub const fn faces(&self) -> Faces<'a> {
        self.assembly.faces()
    }

    /// Three vertices a triangle, each a valid index.
    pub fn triangles(&self) -> impl Iterator<Item = [u16; 3]> + use<'a> {
        self.assembly.triangles()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrong_arrays_are_refused() {
        let (place, normal) = ([[0; 3]; 3], [[0; 3]; 3]);
        assert!(Mesh::new(&place, &normal, &[[0, 1, 2]]).is_ok());
        assert_eq!(Mesh::new(&place, &normal[..2], &[]).unwrap_err(), MeshError::NormalCount);
        let wrong = Mesh::new(&place, &normal, &[[0, 1, 2], [0, 3, 2]]);
        assert_eq!(wrong.unwrap_err(), MeshError::NoSuchVertex { triangle: 1 });
        assert!(Mesh::new(&[], &[], &[]).is_ok());
    }

    #[test]
    fn wrong_indices_are_refused() {
        let (place, normal) = ([[0; 3]; 5], [[0; 3]; 5]);
        let of = |assembly| Mesh::with_assembly(&place, &normal, assembly).map(|mesh| mesh.triangles().count());
        assert_eq!(of(Assembly::Strip(&[0, 1, 2, 65_535, 2, 3, 4])), Ok(2));
        assert_eq!(of(Assembly::Fan(&[0, 1, 2, 5])), Err(MeshError::NoSuchIndex { at: 3 }));
        assert_eq!(of(Assembly::Polygons { counts: &[5], indices: &[0, 1, 2, 3, 4] }), Ok(3));
        let corners = &[0, 1, 2, 65_535];
        let restart = Assembly::Polygons { counts: &[4], indices: corners };
        assert_eq!(of(restart), Err(MeshError::NoSuchIndex { at: 3 }));
        for counts in [&[3_u8][..], &[5], &[2, 2], &[]] {
            assert_eq!(of(Assembly::Polygons { counts, indices: corners }), Err(MeshError::PolygonCounts));
        }
    }

    #[test]
    fn wrong_attributes_are_refused() {
        let mesh = Mesh::new(&[[0; 3]; 3], &[[0; 3]; 3], &[[0, 1, 2], [2, 1, 0]]).unwrap();
        assert_eq!(mesh.with_uv(&[[0; 2]; 2]).unwrap_err(), MeshError::UvCount);
        assert_eq!(mesh.with_lights(&[Light::WHITE; 4]).unwrap_err(), MeshError::LightCount);
        assert_eq!(mesh.with_face_normals(&[[0; 3]; 3]).unwrap_err(), MeshError::FaceNormalCount { needed: 2 });
        let full = mesh.with_uv(&[[1; 2]; 3]).unwrap().with_lights(&[Light::WHITE; 3]).unwrap();
        let full = full.with_face_normals(&[[0, 0, 127]; 2]).unwrap();
        assert!(full.uv().is_some() && full.lights().is_some() && full.face_normals().is_some());
        assert!(mesh.uv().is_none() && mesh.lights().is_none() && mesh.face_normals().is_none());
    }
}
