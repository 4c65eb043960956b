//! Solids as retrofire draws them: shaders, floats, clipping, scanlines, vectors on the heap in every call.

use embedded_graphics::geometry::Size;
use retrofire_core::{
    geom::{Tri, Vertex, Vertex3},
    math::{Color4, Mat4, Matrix, ProjMat3, Vary, point::pt3, rgba},
    render::{
        Colorbuf, Context, Frag, FragmentShader, Framebuf, Model, Ndc, Screen, Target, ctx::FaceCull, raster::Scanline,
        render, shader,
    },
    util::{Buf2, Dims, pixfmt::IntoPixel},
};

use super::{
    solid::Engine,
    solid_models::Solid,
    solid_peers::{Bits, FloatWall, Floats, Turn, byte, texel},
};

/// With pixels of bytes, or of bits.
pub struct Retrofire<P> {
    size: Size,
    pixels: P,
    turns: Vec<Turn>,
    to_screen: Mat4<Ndc, Screen>,
    context: Context,
    cube: Vertices,
    torus: Vertices,
    wall: Textured,
}

/// What colours and depths are written to.
pub trait Pixels: Target {
    fn new(size: Size) -> Self;
    fn clear(&mut self);
    fn depths(&self) -> &[f32];

    /// Dithered, if they are not.
    fn bits(&self, size: Size) -> Bits;
}

/// A solid with its normals at its vertices.
struct Vertices {
    vertices: Vec<Vertex3<[f32; 3]>>,
    triangles: Vec<Tri<usize>>,
}

impl Vertices {
    fn of(solid: Solid) -> Self {
        let Floats { positions, normals, triangles } = Floats::of(solid);
        let vertices = positions.into_iter().zip(normals);
        Self {
            vertices: vertices.map(|([x, y, z], attrib)| Vertex { pos: pt3(x, y, z), attrib }).collect(),
            triangles: triangles.into_iter().map(Tri).collect(),
        }
    }
}

/// The wall.
struct Textured {
    vertices: Vec<Vertex3<(f32, f32)>>,
    triangles: [Tri<usize>; 2],
    to_clip: ProjMat3<Model>,
}

impl Textured {
    fn new(size: Size) -> Self {
        let FloatWall { positions, uvs, triangles, to_clip } = FloatWall::new(size);
        let vertices = positions.into_iter().zip(uvs);
        Self {
            vertices: vertices
                .map(|([x, y, z], [u, v])| Vertex { pos: pt3(x, y, z), attrib: (64.0 * u, 64.0 * v) })
                .collect(),
            triangles: triangles.map(Tri),
            to_clip: Matrix::new(to_clip),
        }
    }
}

fn dims(size: Size) -> Dims {
    Dims(size.width, size.height)
}

impl<P: Pixels> Retrofire<P> {
    #[expect(clippy::cast_precision_loss, reason = "small numbers")]
    pub fn new(size: Size) -> Self {
        let (x, y) = (size.width as f32 / 2.0, size.height as f32 / 2.0);
        let to_screen = [[x, 0.0, 0.0, x], [0.0, -y, 0.0, y], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
        Self {
            size,
            pixels: P::new(size),
            turns: Turn::all(size),
            to_screen: Matrix::new(to_screen),
            // Its front faces run the other way.
            context: Context { face_cull: Some(FaceCull::Front), ..Context::default() },
            cube: Vertices::of(Solid::Cube),
            torus: Vertices::of(Solid::Torus),
            wall: Textured::new(size),
        }
    }
}

impl<P: Pixels> Engine for Retrofire<P> {
    fn size(&self) -> Size {
        self.size
    }

    fn darken(&mut self) {
        self.pixels.clear();
    }

    fn frame(&mut self, solid: Solid, frame: u16) {
        self.pixels.clear();
        let turn = &self.turns[usize::from(frame)];
        let to_clip = ProjMat3::<Model>::new(turn.to_clip);
        let Vertices { vertices, triangles } = match solid {
            Solid::Cube => &self.cube,
            Solid::Torus => &self.torus,
        };
        let shader = shader::new(
            |vertex: Vertex3<[f32; 3]>, ()| Vertex {
                pos: to_clip.apply(&vertex.pos),
                attrib: turn.light(vertex.attrib),
            },
            |fragment: Frag<f32>, ()| {
                let grey = byte(fragment.var);
                rgba(grey, grey, grey, 255)
            },
        );
        render(triangles, vertices, &shader, (), self.to_screen, &mut self.pixels, &self.context);
    }

    const HAS_WALL: bool = true;

    fn wall(&mut self) {
        self.pixels.clear();
        let Textured { vertices, triangles, to_clip } = &self.wall;
        let shader = shader::new(
            |vertex: Vertex3<(f32, f32)>, ()| Vertex { pos: to_clip.apply(&vertex.pos), attrib: vertex.attrib },
            |fragment: Frag<(f32, f32)>, ()| {
                let grey = texel(fragment.var.into());
                rgba(grey, grey, grey, 255)
            },
        );
        render(triangles, vertices, &shader, (), self.to_screen, &mut self.pixels, &self.context);
    }

    fn picture(&self, look: impl FnOnce(&[u8])) {
        look(&self.pixels.bits(self.size).bytes);
    }

    fn covered(&mut self) -> Vec<bool> {
        self.pixels.depths().iter().map(|&depth| depth > 0.0).collect()
    }
}

/// Its own frame buffer, of a byte a pixel.
pub type Bytes = Framebuf<Colorbuf<Buf2<u8>, Grey>, Buf2<f32>>;

/// One of the channels.
#[derive(Clone, Copy, Debug, Default)]
pub struct Grey;

impl IntoPixel<u8, Grey> for Color4 {
    #[inline]
    fn into_pixel(self, _format: Grey) -> u8 {
        self.0[0]
    }
}

impl Pixels for Bytes {
    fn new(size: Size) -> Self {
        Self { color_buf: Colorbuf::new(Buf2::new(dims(size))), depth_buf: Buf2::new(dims(size)) }
    }

    fn clear(&mut self) {
        self.color_buf.buf.fill(0);
        self.depth_buf.fill(0.0);
    }

    fn depths(&self) -> &[f32] {
        self.depth_buf.data()
    }

    fn bits(&self, size: Size) -> Bits {
        Bits::of(size, self.color_buf.buf.data().iter().copied())
    }
}

/// A target of bits.
pub struct Packed {
    bits: Bits,
    depths: Vec<f32>,
}

impl Pixels for Packed {
    fn new(size: Size) -> Self {
        let bits = Bits::new(size);
        Self { depths: vec![0.0; bits.bytes.len() * 8], bits }
    }

    fn clear(&mut self) {
        self.bits.bytes.fill(0);
        self.depths.fill(0.0);
    }

    fn depths(&self) -> &[f32] {
        &self.depths
    }

    fn bits(&self, _size: Size) -> Bits {
        self.bits.clone()
    }
}

/// As its own frame buffer does it.
impl Target for Packed {
    fn rasterize<V: Vary, U: Copy, Fs: FragmentShader<V, U>>(
        &mut self,
        mut line: Scanline<V>,
        shader: &Fs,
        uniform: U,
        context: &Context,
    ) {
        let (y, columns) = (line.y, line.xs.start..line.xs.end.max(line.xs.start));
        let width = self.bits.width;
        let depths = &mut self.depths[y * width..][columns.clone()];
        for ((fragment, depth), x) in line.fragments().zip(depths).zip(columns) {
            let new = fragment.pos.z();
            if context.depth_test(new, *depth)
                && let Some(color) = shader.shade_fragment(fragment, uniform)
            {
                self.bits.plot(x, y, color.0[0]);
                *depth = new;
            }
        }
    }
}
