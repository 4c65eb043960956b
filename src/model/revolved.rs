//! Round meshes of any fineness, made while compiling: spheres, tori, cylinders, cones; and flat grids.
//!
//! A line in a plane, its profile, is turned about the y axis:
//!
//! ```text
//!      sphere         torus          cylinder         cone
//!      │╲             │              │───┐            │╲
//!      │ ╲            │  ╱‾╲         │   │            │ ╲
//!      │ ╱            │  ╲_╱         │   │            │  ╲
//!      │╱             │              │───┘            │───╲
//! ```
//!
//! All fit the unit sphere or the unit cylinder, and have normals and texture coordinates: `u` runs once around,
//! `v` down the profile. The seam where the texture begins has its vertices twice.
//!
//! - **Takes** how many segments go around, and how many rings there are.
//! - **Gives** arrays for a constant, and a [`Mesh`] that borrows them.
//! - **Memory** 13 bytes of flash a vertex, 6 a triangle.
//! - **Cost** none on the device.

use super::mesh::{Mesh, MeshError};
use crate::{
    angle::sine_and_cosine,
    num::{count, low_i32, low_index, low_u16, saturate_i16},
};

/// Arrays of a mesh with `V` vertices and `T` triangles. Ask the functions of this module for the two numbers.
///
/// ```
/// use aquatint::model::{mesh::Mesh, revolved::{Parts, torus_triangles, vertices}};
///
/// const RING: Parts<{ vertices(16, 8) }, { torus_triangles(16, 8) }> = Parts::torus::<16, 8>(6_000);
/// const MESH: Mesh = match RING.mesh() {
///     Ok(mesh) => mesh,
///     Err(_) => panic!(),
/// };
/// assert_eq!(MESH.triangles().count(), 256);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Parts<const V: usize, const T: usize> {
    positions: [[i16; 3]; V],
    normals: [[i8; 3]; V],
    uv: [[i16; 2]; V],
    triangles: [[u16; 3]; T],
}

/// Vertices of a surface of so many segments around and so many rings: one more of each.
#[must_use]
pub const fn vertices(segments: usize, rings: usize) -> usize {
    (segments + 1) * (rings + 1)
}

/// Triangles of a torus, and of a grid: two for each segment of each ring.
#[must_use]
pub const fn torus_triangles(segments: usize, rings: usize) -> usize {
    2 * segments * rings
}

/// Triangles of a sphere: at the poles only one for each segment.
#[must_use]
pub const fn sphere_triangles(segments: usize, rings: usize) -> usize {
    2 * segments * (rings - 1)
}

/// A point of the profile, in 2.14: its distance from the axis and height, and the normal in both directions.
#[derive(Clone, Copy)]
struct Profile {
    radius: i64,
    height: i64,
    normal: (i64, i64),
}

/// 1 in 2.14.
const ONE: i64 = 1 << 14;

/// Cosine and sine of part of a turn, in 2.14.
const fn around(part: usize, of: usize) -> (i64, i64) {
    let of = if of == 0 { 1 } else { of as u64 };
    let (sin, cos) = sine_and_cosine(low_index(count((((part as u64) << 32) / of) & 0xFFFF_FFFF)));
    (rounded(cos, 17), rounded(sin, 17))
}

/// A number without its lowest bits, to the nearest.
const fn rounded(value: i64, bits: u32) -> i64 {
    (value + (1 << (bits - 1))) >> bits
}

impl<const V: usize, const T: usize> Parts<V, T> {
    /// A ball of radius 1, its poles up and down: `vertices(SEGMENTS, RINGS)`, [`sphere_triangles`].
    #[must_use]
    pub const fn sphere<const SEGMENTS: usize, const RINGS: usize>() -> Self {
        const { assert!(V == vertices(SEGMENTS, RINGS) && T == sphere_triangles(SEGMENTS, RINGS)) }
        let mut parts = Self::EMPTY;
        let mut row = 0;
        while row <= RINGS {
            // From the lower pole to the upper one: half a turn.
            let (up, out) = around(row, 2 * RINGS);
            let out = if row == RINGS { 0 } else { out };
            parts = parts.with_row(row, SEGMENTS, RINGS, Profile { radius: out, height: -up, normal: (out, -up) });
            row += 1;
        }
        parts.with_triangles(SEGMENTS, RINGS)
    }

    /// A ring of outer radius 1 made of a tube, whose radius is in 2.14: `vertices(SEGMENTS, SIDES)`,
    /// [`torus_triangles`].
    #[must_use]
    pub const fn torus<const SEGMENTS: usize, const SIDES: usize>(tube: u16) -> Self {
        const { assert!(V == vertices(SEGMENTS, SIDES) && T == torus_triangles(SEGMENTS, SIDES)) }
        let tube = if tube as i64 > ONE / 2 { ONE / 2 } else { tube as i64 };
        let mut parts = Self::EMPTY;
        let mut row = 0;
        while row <= SIDES {
            let (out, up) = around(row % SIDES, SIDES);
            let (radius, height) = (ONE - tube + rounded(tube * out, 14), rounded(tube * up, 14));
            parts = parts.with_row(row, SEGMENTS, SIDES, Profile { radius, height, normal: (out, up) });
            row += 1;
        }
        parts.with_triangles(SEGMENTS, SIDES)
    }

    /// A can of radius 1 and height 2 with lids: `vertices(SEGMENTS, 5)`, `torus_triangles(SEGMENTS, 2)`.
    #[must_use]
    pub const fn cylinder<const SEGMENTS: usize>() -> Self {
        const { assert!(V == vertices(SEGMENTS, 5) && T == torus_triangles(SEGMENTS, 2)) }
        let rows = [(0, -1, 0, -1), (1, -1, 0, -1), (1, -1, 1, 0), (1, 1, 1, 0), (1, 1, 0, 1), (0, 1, 0, 1)];
        let mut parts = Self::EMPTY;
        let mut row = 0;
        while row < rows.len() {
            let (radius, height, out, up) = rows[row];
            let profile = Profile { radius: radius * ONE, height: height * ONE, normal: (out * ONE, up * ONE) };
            parts = parts.with_row(row, SEGMENTS, 5, profile);
            row += 1;
        }
        parts.with_triangles(SEGMENTS, 5)
    }

    /// A cone of radius 1 and height 2 on its base: `vertices(SEGMENTS, 3)`, `torus_triangles(SEGMENTS, 1)`.
    #[must_use]
    pub const fn cone<const SEGMENTS: usize>() -> Self {
        const { assert!(V == vertices(SEGMENTS, 3) && T == torus_triangles(SEGMENTS, 1)) }
        // The side rises 2 on 1: its normal is (2, 1) over the root of 5.
        let (out, up) = (14_654, 7_327);
        let base = Profile { radius: 0, height: -ONE, normal: (0, -ONE) };
        let rim = Profile { radius: ONE, ..base };
        let side = Profile { normal: (out, up), ..rim };
        let tip = Profile { radius: 0, height: ONE, normal: (out, up) };
        let parts = Self::EMPTY.with_row(0, SEGMENTS, 3, base).with_row(1, SEGMENTS, 3, rim);
        parts.with_row(2, SEGMENTS, 3, side).with_row(3, SEGMENTS, 3, tip).with_triangles(SEGMENTS, 3)
    }

    /// A flat square from −1 to 1 in x and z that is seen from above: `vertices(COLUMNS, ROWS)`,
    /// `torus_triangles(COLUMNS, ROWS)`. Its texture lies upright for whom looks down −z.
    #[must_use]
    pub const fn grid<const COLUMNS: usize, const ROWS: usize>() -> Self {
        const { assert!(V == vertices(COLUMNS, ROWS) && T == torus_triangles(COLUMNS, ROWS)) }
        let mut parts = Self::EMPTY;
        let mut vertex = 0;
        while vertex < V {
            let (column, row) = (vertex % (COLUMNS + 1), vertex / (COLUMNS + 1));
            let (u, v) = (share(column, COLUMNS), share(ROWS - row, ROWS));
            // From 0 … 4096 to −1 … 1.
            parts.positions[vertex] = [saturate_i16(8 * u - ONE), 0, saturate_i16(8 * v - ONE)];
            parts.normals[vertex] = [0, 127, 0];
            parts.uv[vertex] = [saturate_i16(u), saturate_i16(v)];
            vertex += 1;
        }
        parts.with_triangles(COLUMNS, ROWS)
    }

    /// The mesh that borrows these arrays.
    ///
    /// # Errors
    /// [`MeshError`], where there are more than 65536 vertices.
    pub const fn mesh(&self) -> Result<Mesh<'_>, MeshError> {
        match Mesh::new(&self.positions, &self.normals, &self.triangles) {
            Ok(mesh) => mesh.with_uv(&self.uv),
            Err(error) => Err(error),
        }
    }

    const EMPTY: Self = Self { positions: [[0; 3]; V], normals: [[0; 3]; V], uv: [[0; 2]; V], triangles: [[0; 3]; T] };

    /// Turns a point of the profile once around.
    const fn with_row(mut self, row: usize, segments: usize, rings: usize, profile: Profile) -> Self {
        let mut column = 0;
        while column <= segments {
            let (cos, sin) = around(column % segments, segments);
            let vertex = row * (segments + 1) + column;
            let Profile { radius, height, normal: (out, up) } = profile;
            // Beginning at +z, towards +x: to the right, seen from outside.
            let place = [rounded(radius * sin, 14), height, rounded(radius * cos, 14)];
            let normal = [rounded(out * sin, 14), up, rounded(out * cos, 14)];
            self.positions[vertex] = [saturate_i16(place[0]), saturate_i16(place[1]), saturate_i16(place[2])];
            self.normals[vertex] = [byte(normal[0]), byte(normal[1]), byte(normal[2])];
            self.uv[vertex] = [saturate_i16(share(column, segments)), saturate_i16(share(rings - row, rings))];
            column += 1;
        }
        self
    }

    /// Two triangles for each quadrangle, but none that has two corners at the same place.
    const fn with_triangles(mut self, segments: usize, rings: usize) -> Self {
        let (mut triangle, mut quad) = (0, 0);
        while quad < segments * rings {
            let lower = quad / segments * (segments + 1) + quad % segments;
            let (a, b) = (lower, lower + 1);
            let (c, d) = (lower + segments + 2, lower + segments + 1);
            let corners = [[a, b, c], [a, c, d]];
            let mut half = 0;
            while half < 2 {
                let [p, q, r] = corners[half];
                if triangle < T && !(self.same(p, q) || self.same(q, r) || self.same(r, p)) {
                    self.triangles[triangle] = [index_of(p), index_of(q), index_of(r)];
                    triangle += 1;
                }
                half += 1;
            }
            quad += 1;
        }
        self
    }

    const fn same(&self, a: usize, b: usize) -> bool {
        let ([x, y, z], [u, v, w]) = (self.positions[a], self.positions[b]);
        x == u && y == v && z == w
    }
}

/// Part of 4096.
const fn share(part: usize, of: usize) -> i64 {
    let of = if of == 0 { 1 } else { low_index(of) as i64 };
    (low_index(part) as i64 * 4096 + of / 2) / of
}

/// A component in 2.14 of a normal of length 127.
const fn byte(component: i64) -> i8 {
    let value = rounded(component * 127, 14);
    saturate_i16(value * 256).to_be_bytes()[0].cast_signed()
}

/// The number of a vertex; those past the last that a mesh can name become the last.
const fn index_of(vertex: usize) -> u16 {
    if vertex > u16::MAX as usize { u16::MAX } else { low_u16(low_i32(low_index(vertex) as i64)) }
}
