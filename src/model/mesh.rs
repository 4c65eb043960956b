//! Indexed triangle meshes, quantised so that a thousand triangles take 15 kB of flash.

use crate::error::describe;

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
/// assert_eq!(TETRAHEDRON.triangles().len(), 4);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Mesh<'a> {
    positions: &'a [[i16; 3]],
    normals: &'a [[i8; 3]],
    triangles: &'a [[u16; 3]],
}

/// Why arrays do not make a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshError {
    /// The number of normals is not the number of positions.
    NormalCount,
    /// This triangle names a vertex that does not exist.
    NoSuchVertex {
        /// The triangle, counted from 0.
        triangle: usize,
    },
}

describe! { MeshError,
    Self::NormalCount => "there is not one normal for each position";
    Self::NoSuchVertex { triangle } => "triangle {triangle} names a vertex that does not exist";
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
        if positions.len() != normals.len() {
            return Err(MeshError::NormalCount);
        }
        let mut triangle = 0;
        while triangle < triangles.len() {
            let [a, b, c] = triangles[triangle];
            let count = positions.len();
            if a as usize >= count || b as usize >= count || c as usize >= count {
                return Err(MeshError::NoSuchVertex { triangle });
            }
            triangle += 1;
        }
        Ok(Self { positions, normals, triangles })
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

    /// Texture coordinates.
    #[must_use]
    pub const fn uv(&self) -> Option<&'a [[i16; 2]]> {
        None
    }

    /// Colours.
    #[must_use]
    pub const fn lights(&self) -> Option<&'a [crate::colour::Light]> {
        None
    }

    /// Normals of faces.
    #[must_use]
    pub const fn face_normals(&self) -> Option<&'a [[i8; 3]]> {
        None
    }

    /// Three vertices a triangle, each a valid index.
    #[must_use]
    pub const fn triangles(&self) -> &'a [[u16; 3]] {
        self.triangles
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
}
