//! A textured wall that recedes from depth 2 at the left end of the view to 6 at the right, and fills it.
//!
//! Its corners are at ±0.998 of the view. u = (depth − 2)/4 and v = 0.5 − y/5.988 run from 0 to 1; the nearest of 64 × 64
//! texels is shown, without light.

use embedded_graphics::geometry::Size;

/// How much the mesh has to be scaled up.
pub const SCALE: i16 = 4;

/// Texels across and down.
pub const SIDE: usize = 64;

/// Bottom left, bottom right, top right, top left, and two triangles.
#[derive(Clone, Copy, Debug)]
pub struct Wall {
    /// In 2.14, a quarter of its size.
    pub positions: [[i16; 3]; 4],
    /// In 16.16: 65536 is the far end of the texture.
    pub uvs: [[u32; 2]; 4],
    pub triangles: [[u16; 3]; 2],
}

impl Wall {
    /// The wall that fills a view of this size: its width depends on it.
    #[expect(clippy::cast_possible_truncation, reason = "small numbers")]
    pub fn new(size: Size) -> Self {
        // 0.998 · 16384 / 4 = 4087.808
        let [width, height] = [size.width, size.height].map(u64::from);
        let part = |thousands: u64| ((thousands * width / height + 500) / 1000) as i16;
        let (left, right) = (-part(4_087_808), part(3 * 4_087_808));
        let (low, high, near, far) = (4_088, 12_263, -2 * 4096, -6 * 4096);
        Self {
            positions: [[left, -low, near], [right, -high, far], [right, high, far], [left, low, near]],
            uvs: [[0, 43_691], [65_536, 65_536], [65_536, 0], [0, 21_845]],
            triangles: [[0, 1, 2], [0, 2, 3]],
        }
    }
}

/// Linear greys, row by row: brighter to the right and downwards, under stripes.
pub static TEXTURE: [u8; SIDE * SIDE] = {
    let mut texels = [0; SIDE * SIDE];
    let mut at: u16 = 0;
    while at < 4096 {
        let (u, v) = (at % 64, at / 64);
        let [grey, _] = (u + v + u / 8 % 2 * 64 + v / 8 % 2 * 64).to_le_bytes();
        texels[at as usize] = grey;
        at += 1;
    }
    texels
};

/// The texel at the centre of a pixel, exactly.
#[cfg(not(target_os = "none"))]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "inside of the texture")]
pub fn exact_texel(size: Size, (x, y): (u32, u32)) -> u8 {
    let [width, height] = [size.width, size.height].map(f64::from);
    // Seen from above the ray goes along (across, 1), and the wall from (−0.998 · aspect, 2) by (3.992 · aspect, 4).
    let aspect = width / height;
    let across = (2.0 * (f64::from(x) + 0.5) / width - 1.0) * aspect / 2.0;
    let up = 1.0 - 2.0 * (f64::from(y) + 0.5) / height;
    let depth = 11.976 * aspect / (3.992 * aspect - 4.0 * across);
    let texel = |part: f64| (part * 64.0).clamp(0.0, 63.0) as usize;
    TEXTURE[texel(0.5 - up * depth / 2.0 / 5.988) * SIDE + texel((depth - 2.0) / 4.0)]
}
