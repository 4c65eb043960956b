//! Solids as euc draws them: shaders, floats, every pixel of a bounding box; no clipping.

use embedded_graphics::geometry::Size;
use euc::{Pipeline, Target, buffer::Buffer2d, rasterizer::Triangles};

use super::{
    solid::Engine,
    solid_models::Solid,
    solid_peers::{Bits, FloatWall, Floats, Turn, byte, texel},
};

/// Its own buffer, of a byte a pixel.
pub type Bytes = Buffer2d<u8>;

/// With pixels of bytes, or of bits.
pub struct Euc<P> {
    size: Size,
    pixels: P,
    depth: Buffer2d<f32>,
    turns: Vec<Turn>,
    cube: Corners,
    torus: Corners,
    wall: FloatWall,
}

/// What colours are written to.
pub trait Pixels: Target<Item = u8> {
    fn new(size: Size) -> Self;

    /// Dithered, if they are not.
    fn bits(&self, size: Size) -> Bits;
}

/// A solid, and its vertices in the order in which the triangles name them.
struct Corners {
    solid: Floats,
    vertices: Vec<usize>,
}

impl Corners {
    fn of(solid: Solid) -> Self {
        let solid = Floats::of(solid);
        Self { vertices: solid.triangles.iter().copied().flatten().collect(), solid }
    }
}

fn lengths(size: Size) -> [usize; 2] {
    [size.width as usize, size.height as usize]
}

impl<P: Pixels> Euc<P> {
    pub fn new(size: Size) -> Self {
        Self {
            size,
            pixels: P::new(size),
            depth: Buffer2d::new(lengths(size), 1.0),
            turns: Turn::all(size),
            cube: Corners::of(Solid::Cube),
            torus: Corners::of(Solid::Torus),
            wall: FloatWall::new(size),
        }
    }
}

/// Its shaders.
struct Shaded<'a> {
    solid: &'a Floats,
    turn: &'a Turn,
}

impl Pipeline for Shaded<'_> {
    type Vertex = usize;
    type VsOut = f32;
    type Pixel = u8;

    fn vert(&self, &at: &usize) -> ([f32; 4], f32) {
        let [x, y, z] = self.solid.positions[at];
        let place = self.turn.to_clip.map(|[a, b, c, d]| a * x + b * y + c * z + d);
        (place, self.turn.light(self.solid.normals[at]))
    }

    fn frag(&self, &light: &f32) -> u8 {
        byte(light)
    }
}

/// Those of the wall.
struct Textured<'a>(&'a FloatWall);

impl Pipeline for Textured<'_> {
    type Vertex = usize;
    type VsOut = (f32, f32);
    type Pixel = u8;

    fn vert(&self, &at: &usize) -> ([f32; 4], (f32, f32)) {
        let [x, y, z] = self.0.positions[at];
        (self.0.to_clip.map(|[a, b, c, d]| a * x + b * y + c * z + d), self.0.uvs[at].map(|part| part * 64.0).into())
    }

    fn frag(&self, &(u, v): &(f32, f32)) -> u8 {
        texel([u, v])
    }
}

impl<P: Pixels> Engine for Euc<P> {
    fn size(&self) -> Size {
        self.size
    }

    fn darken(&mut self) {
        self.pixels.clear(0);
    }

    fn frame(&mut self, solid: Solid, frame: u16) {
        self.pixels.clear(0);
        self.depth.clear(1.0);
        let Corners { solid, vertices } = match solid {
            Solid::Cube => &self.cube,
            Solid::Torus => &self.torus,
        };
        let shaded = Shaded { solid, turn: &self.turns[usize::from(frame)] };
        shaded.draw::<Triangles<_>, _>(vertices, &mut self.pixels, Some(&mut self.depth));
    }

    const HAS_WALL: bool = true;

    fn wall(&mut self) {
        self.pixels.clear(0);
        self.depth.clear(1.0);
        let vertices = self.wall.triangles.as_flattened();
        Textured(&self.wall).draw::<Triangles<_>, _>(vertices, &mut self.pixels, Some(&mut self.depth));
    }

    fn picture(&self, look: impl FnOnce(&[u8])) {
        look(&self.pixels.bits(self.size).bytes);
    }

    fn covered(&mut self) -> Vec<bool> {
        self.depth.as_ref().iter().map(|&depth| depth < 1.0).collect()
    }
}

impl Pixels for Bytes {
    fn new(size: Size) -> Self {
        Self::new(lengths(size), 0)
    }

    fn bits(&self, size: Size) -> Bits {
        Bits::of(size, self.as_ref().iter().copied())
    }
}

impl Pixels for Bits {
    fn new(size: Size) -> Self {
        Self::new(size)
    }

    fn bits(&self, _size: Size) -> Bits {
        self.clone()
    }
}

/// Safe; the trait asks for unsafe functions.
impl Target for Bits {
    type Item = u8;

    fn size(&self) -> [usize; 2] {
        [self.width, self.bytes.len() * 8 / self.width]
    }

    unsafe fn set(&mut self, [x, y]: [usize; 2], grey: u8) {
        self.plot(x, y, grey);
    }

    /// Pixels are not read.
    unsafe fn get(&self, _place: [usize; 2]) -> u8 {
        0
    }

    fn clear(&mut self, _grey: u8) {
        self.bytes.fill(0);
    }
}
