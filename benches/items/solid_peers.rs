//! What peers that draw solids in floats have in common: the same vertices, matrices and light, made before counting.

use embedded_graphics::geometry::Size;

use super::{
    solid::{FRAMES, angles},
    solid_models::Solid,
    solid_wall::{SCALE, SIDE, TEXTURE, Wall},
};

/// A solid in floats.
#[derive(Clone, Debug)]
pub struct Floats {
    pub positions: Vec<[f32; 3]>,
    pub normals: Vec<[f32; 3]>,
    pub triangles: Vec<[usize; 3]>,
}

impl Floats {
    pub fn of(solid: Solid) -> Self {
        let model = solid.model();
        Self {
            positions: model.positions.iter().map(|place| place.map(|v| f32::from(v) / 16_384.0)).collect(),
            normals: model.normals.iter().map(|normal| normal.map(|v| f32::from(v) / 127.0)).collect(),
            triangles: model.triangles.iter().map(|corners| corners.map(usize::from)).collect(),
        }
    }
}

/// One of the frames of a cycle.
#[derive(Clone, Copy, Debug)]
pub struct Turn {
    /// Rows of the matrix from the solid to clip space.
    pub to_clip: [[f32; 4]; 4],
    /// Towards the lamp, as the solid sees it.
    pub lamp: [f32; 3],
}

/// Towards the lamp.
pub const LAMP: [f32; 3] = [0.400_75, 0.601_13, 0.691_30];

impl Turn {
    /// All frames of a cycle.
    pub fn all(size: Size) -> Vec<Self> {
        (0..FRAMES).map(|frame| Self::new(size, frame)).collect()
    }

    fn new(size: Size, frame: u16) -> Self {
        let [(sin_x, cos_x), (sin_y, cos_y)] = radians(frame).map(f32::sin_cos);
        let rotation =
            [[cos_y, sin_y * sin_x, sin_y * cos_x], [0.0, cos_x, -sin_x], [-sin_y, cos_y * sin_x, cos_y * cos_x]];
        let [right, up, back] = rotation;
        let to_clip = projected(size, rotation, 4.0);
        let lamp = [0, 1, 2].map(|axis| right[axis] * LAMP[0] + up[axis] * LAMP[1] + back[axis] * LAMP[2]);
        Self { to_clip, lamp }
    }

    /// The light of a vertex, 0 to 1.
    #[inline]
    pub fn light(&self, [x, y, z]: [f32; 3]) -> f32 {
        let [lx, ly, lz] = self.lamp;
        0.1 + 0.9 * (x * lx + y * ly + z * lz).max(0.0)
    }
}

/// The matrix from something turned, and moved so far in front of the eye, to clip space.
#[expect(clippy::cast_precision_loss, reason = "small numbers")]
pub fn projected(size: Size, [right, up, back]: [[f32; 3]; 3], distance: f32) -> [[f32; 4]; 4] {
    let (near, far) = (0.4, 20.0);
    let (a, b) = ((far + near) / (far - near), 2.0 * far * near / (far - near));
    let across = 2.0 * size.height as f32 / size.width as f32;
    let row = |factor: f32, [x, y, z]: [f32; 3], w: f32| [factor * x, factor * y, factor * z, w];
    [row(across, right, 0.0), row(2.0, up, 0.0), row(-a, back, distance * a - b), row(-1.0, back, distance)]
}

/// The textured wall in floats.
#[derive(Clone, Debug)]
pub struct FloatWall {
    pub positions: [[f32; 3]; 4],
    /// 0 to 1.
    pub uvs: [[f32; 2]; 4],
    pub triangles: [[usize; 3]; 2],
    pub to_clip: [[f32; 4]; 4],
}

impl FloatWall {
    #[expect(clippy::cast_precision_loss, reason = "small numbers")]
    pub fn new(size: Size) -> Self {
        let Wall { positions, uvs, triangles } = Wall::new(size);
        Self {
            positions: positions.map(|place| place.map(|v| f32::from(v) / 16_384.0 * f32::from(SCALE))),
            uvs: uvs.map(|uv| uv.map(|v| v as f32 / 65_536.0)),
            triangles: triangles.map(|corners| corners.map(usize::from)),
            to_clip: projected(size, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], 0.0),
        }
    }
}

/// The texel at a place counted in texels, as shaders look it up.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it saturates, and is masked")]
#[inline]
pub fn texel([u, v]: [f32; 2]) -> u8 {
    let [u, v] = [u, v].map(|part| part as i32 as usize & (SIDE - 1));
    TEXTURE[v * SIDE + u]
}

/// The angles of a frame, about x and about y.
pub fn radians(frame: u16) -> [f32; 2] {
    angles(frame).map(|part| f32::from(part) / 65_536.0 * core::f32::consts::TAU)
}

/// A byte to the nearest.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
#[inline]
pub fn byte(light: f32) -> u8 {
    (light * 255.0 + 0.5) as u8
}

/// A packed picture of one bit a pixel, dithered 4 × 4.
#[derive(Clone, Debug)]
pub struct Bits {
    pub width: usize,
    pub bytes: Vec<u8>,
}

/// Ours: `(rank + ½) / 16` of the light.
const THRESHOLDS: [[u8; 4]; 4] = [[8, 136, 40, 168], [200, 72, 232, 104], [56, 184, 24, 152], [248, 120, 216, 88]];

impl Bits {
    pub fn new(size: Size) -> Self {
        let width = size.width as usize;
        Self { width, bytes: vec![0; width * size.height as usize / 8] }
    }

    /// Grey over the threshold of its place is bright.
    #[inline]
    pub fn plot(&mut self, x: usize, y: usize, grey: u8) {
        let (byte, bit) = (&mut self.bytes[(y * self.width + x) / 8], 0x80 >> (x & 7));
        if grey > THRESHOLDS[y & 3][x & 3] { *byte |= bit } else { *byte &= !bit }
    }

    /// A picture of bytes, dithered.
    pub fn of(size: Size, greys: impl Iterator<Item = u8>) -> Self {
        let mut bits = Self::new(size);
        greys.enumerate().for_each(|(at, grey)| bits.plot(at % bits.width, at / bits.width, grey));
        bits
    }
}
