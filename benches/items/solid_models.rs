//! The solids, made while compiling: in the 2.14 of our meshes, so that all draw the same vertices.
#![expect(clippy::cast_possible_truncation, reason = "small numbers, rounded while compiling")]

use core::f64::consts::{FRAC_1_SQRT_2, TAU};

/// What is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Solid {
    /// Edge 2, eight shared vertices, 12 triangles, normals along the diagonals.
    Cube,
    /// 28 × 18 segments, radii 1 and 0.5, 504 vertices, 1008 triangles, smooth normals.
    Torus,
}

/// Places in 2.14, normals of length 127, triangles counter-clockwise as seen from outside.
#[derive(Clone, Copy, Debug)]
pub struct Model {
    pub positions: &'static [[i16; 3]],
    pub normals: &'static [[i8; 3]],
    pub triangles: &'static [[u16; 3]],
    /// One normal a triangle.
    pub face_normals: &'static [[i8; 3]],
}

/// The most vertices of a solid.
pub const VERTICES: usize = 504;

impl Solid {
    pub fn model(self) -> Model {
        match self {
            Self::Cube => CUBE.model(),
            Self::Torus => TORUS.model(),
        }
    }
}

struct Arrays<const V: usize, const T: usize> {
    positions: [[i16; 3]; V],
    normals: [[i8; 3]; V],
    triangles: [[u16; 3]; T],
    face_normals: [[i8; 3]; T],
}

impl<const V: usize, const T: usize> Arrays<V, T> {
    fn model(&'static self) -> Model {
        let Self { positions, normals, triangles, face_normals } = self;
        Model { positions, normals, triangles, face_normals }
    }

    /// With normals of faces, from cross products.
    const fn with_face_normals(mut self) -> Self {
        let mut face = 0;
        while face < T {
            let [a, b, c] = self.triangles[face];
            let from = self.positions[a as usize];
            let (u, v) = (between(from, self.positions[b as usize]), between(from, self.positions[c as usize]));
            let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
            let length = (cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]).isqrt();
            let mut axis = 0;
            while axis < 3 {
                self.face_normals[face][axis] = (cross[axis] * 127 / length) as i8;
                axis += 1;
            }
            face += 1;
        }
        self
    }
}

static CUBE: Arrays<8, 12> = cube().with_face_normals();
static TORUS: Arrays<VERTICES, 1008> = torus().with_face_normals();

/// Fifty triangles that lie anyhow, some through others.
pub fn triangles() -> Model {
    SOUP.model()
}

static SOUP: Arrays<150, 50> = soup().with_face_normals();

/// In 2.10, so that squares fit.
const fn between(from: [i16; 3], to: [i16; 3]) -> [i64; 3] {
    [(to[0] as i64 - from[0] as i64) / 16, (to[1] as i64 - from[1] as i64) / 16, (to[2] as i64 - from[2] as i64) / 16]
}

/// Bit 0 of a vertex's number is its side along x, bit 1 along y, bit 2 along z.
const fn cube() -> Arrays<8, 12> {
    let mut arrays =
        Arrays { positions: [[0; 3]; 8], normals: [[0; 3]; 8], triangles: [[0; 3]; 12], face_normals: [[0; 3]; 12] };
    let mut vertex = 0;
    while vertex < 8 {
        let mut axis = 0;
        while axis < 3 {
            let side = if vertex >> axis & 1 == 1 { 1.0 } else { -1.0 };
            arrays.positions[vertex][axis] = nearest(side * ONE) as i16;
            arrays.normals[vertex][axis] = nearest(side * 127.0 / SQRT_3) as i8;
            axis += 1;
        }
        vertex += 1;
    }
    // Around each face, beginning at a corner: right, left, top, bottom, front, back.
    let faces: [[u16; 4]; 6] = [[1, 3, 7, 5], [0, 4, 6, 2], [2, 6, 7, 3], [0, 1, 5, 4], [4, 5, 7, 6], [0, 2, 3, 1]];
    let mut face = 0;
    while face < 6 {
        (arrays.triangles[2 * face], arrays.triangles[2 * face + 1]) = halves(faces[face]);
        face += 1;
    }
    arrays
}

const AROUND: usize = 28;
const ACROSS: usize = 18;

/// About the z axis.
const fn torus() -> Arrays<VERTICES, 1008> {
    let mut arrays = Arrays {
        positions: [[0; 3]; VERTICES],
        normals: [[0; 3]; VERTICES],
        triangles: [[0; 3]; 1008],
        face_normals: [[0; 3]; 1008],
    };
    let mut at = 0;
    while at < VERTICES {
        let (i, j) = (at / ACROSS, at % ACROSS);
        let (sin_u, cos_u) = sine_and_cosine(turn(i, AROUND));
        let (sin_v, cos_v) = sine_and_cosine(turn(j, ACROSS));
        let from_axis = 1.0 + 0.5 * cos_v;
        arrays.positions[at] = places([from_axis * cos_u, from_axis * sin_u, 0.5 * sin_v]);
        let normal = [cos_v * cos_u, cos_v * sin_u, sin_v];
        let mut axis = 0;
        while axis < 3 {
            arrays.normals[at][axis] = nearest(normal[axis] * 127.0) as i8;
            axis += 1;
        }
        let around = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
        (arrays.triangles[2 * at], arrays.triangles[2 * at + 1]) = halves(around);
        at += 1;
    }
    arrays
}

/// How far from the middle of the view a triangle may be, and a corner from the middle of its triangle, in 2.14.
const REACH: [i32; 3] = [24_576, 13_107, 16_384];
const SIZE: i32 = 7_373;

const fn soup() -> Arrays<150, 50> {
    let mut arrays = Arrays {
        positions: [[0; 3]; 150],
        normals: [[0, 0, 127]; 150],
        triangles: [[0; 3]; 50],
        face_normals: [[0; 3]; 50],
    };
    let (mut state, mut face) = (1, 0);
    while face < 50 {
        let mut axis = 0;
        while axis < 3 {
            state = next(state);
            let (middle, mut corner) = (within(state, REACH[axis]), 0);
            while corner < 3 {
                state = next(state);
                arrays.positions[3 * face + corner][axis] = (middle + within(state, SIZE)) as i16;
                arrays.triangles[face][corner] = (3 * face + corner) as u16;
                corner += 1;
            }
            axis += 1;
        }
        face += 1;
    }
    arrays
}

/// D. H. Lehmer's generator.
const fn next(state: i64) -> i64 {
    state * 48_271 % 2_147_483_647
}

/// From −reach to reach.
const fn within(state: i64, reach: i32) -> i32 {
    (((state >> 14) as i32 - (1 << 16)) * (reach >> 4)) >> 12
}

const fn vertex(i: usize, j: usize) -> u16 {
    ((i % AROUND) * ACROSS + j % ACROSS) as u16
}

const fn halves([a, b, c, d]: [u16; 4]) -> ([u16; 3], [u16; 3]) {
    ([a, b, c], [a, c, d])
}

const ONE: f64 = 16_384.0;
const SQRT_3: f64 = 1.732_050_807_568_877_2;

const fn places([x, y, z]: [f64; 3]) -> [i16; 3] {
    [nearest(x * ONE) as i16, nearest(y * ONE) as i16, nearest(z * ONE) as i16]
}

const fn nearest(value: f64) -> i32 {
    (value + if value < 0.0 { -0.5 } else { 0.5 }) as i32
}

#[expect(clippy::cast_precision_loss, reason = "small numbers")]
const fn turn(part: usize, of: usize) -> f64 {
    part as f64 / of as f64
}

/// Of an angle in turns, 0 to 1, by the series about the nearest eighth: exact to 10⁻¹⁵.
const fn sine_and_cosine(turns: f64) -> (f64, f64) {
    let eighth = nearest(turns * 8.0);
    let rest = (turns - eighth as f64 / 8.0) * TAU;
    let (mut sin, mut cos, mut term, mut power) = (0.0, 0.0, 1.0, 0);
    while power < 16 {
        match power & 3 {
            0 => cos += term,
            1 => sin += term,
            2 => cos -= term,
            _ => sin -= term,
        }
        power += 1;
        term *= rest / power as f64;
    }
    let (sin_e, cos_e) = match eighth & 7 {
        0 => (0.0, 1.0),
        1 => (FRAC_1_SQRT_2, FRAC_1_SQRT_2),
        2 => (1.0, 0.0),
        3 => (FRAC_1_SQRT_2, -FRAC_1_SQRT_2),
        4 => (0.0, -1.0),
        5 => (-FRAC_1_SQRT_2, -FRAC_1_SQRT_2),
        6 => (-1.0, 0.0),
        _ => (-FRAC_1_SQRT_2, FRAC_1_SQRT_2),
    };
    (sin_e * cos + cos_e * sin, cos_e * cos - sin_e * sin)
}
