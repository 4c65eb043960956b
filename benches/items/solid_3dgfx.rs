//! Solids as embedded-3dgfx draws them: floats, recorded commands, whole pixels, on targets of RGB565 with 16 bits of depth.

use core::convert::Infallible;

use embedded_3dgfx::{
    Z_MAX_VALUE, ZDepth,
    engine::K3dengine,
    pipeline::{
        command_buffer::CommandBuffer,
        rasterize::texture::{Texture, TextureManager},
        renderer::FrameCtx,
        vertex::mesh::{Geometry, K3dMesh, RenderMode},
    },
};
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Point, Size},
    pixelcolor::{Rgb565, RgbColor},
};

use super::{
    solid::Engine,
    solid_models::Solid,
    solid_peers::{Bits, FloatWall, Floats, LAMP, radians},
    solid_wall::{SIDE, TEXTURE},
};

/// With pixels of RGB565, or of bits.
pub struct Embedded3dgfx<P> {
    pixels: P,
    depths: Vec<ZDepth>,
    commands: Box<CommandBuffer<512>>,
    engine: K3dengine,
    cube: K3dMesh<'static>,
    torus: K3dMesh<'static>,
    wall: K3dMesh<'static>,
    textures: TextureManager<1>,
}

/// What it draws on.
pub trait Pixels: DrawTarget<Color = Rgb565, Error = Infallible> + OriginDimensions {
    fn new(size: Size) -> Self;

    /// Dithered, if they are not.
    fn bits(&self) -> Bits;
}

/// The meshes borrow their arrays for as long as the program runs.
fn mesh(solid: Solid) -> K3dMesh<'static> {
    let Floats { positions, normals, triangles } = Floats::of(solid);
    let faces = triangles.iter().map(|&corners| face_normal(corners.map(|at| positions[at]))).collect::<Vec<_>>();
    let geometry = Geometry::new(positions.leak(), triangles.leak()).with_normals(faces.leak());
    let mut mesh = K3dMesh::new(geometry.with_vertex_normals(normals.leak()));
    let [x, y, z] = LAMP.map(|v| v * 0.9);
    // It turns the lamp round, and adds 0.1 of ambient light.
    mesh.set_render_mode(RenderMode::GouraudLightDir([x, y, -z].into()));
    mesh.set_position(0.0, 0.0, -4.0);
    mesh
}

fn wall(size: Size) -> K3dMesh<'static> {
    let FloatWall { positions, uvs, triangles, .. } = FloatWall::new(size);
    let faces = triangles.map(|corners| face_normal(corners.map(|at| positions[at])));
    let geometry = Geometry::new(positions.to_vec().leak(), triangles.to_vec().leak())
        .with_normals(faces.to_vec().leak())
        .with_uvs(uvs.to_vec().leak())
        .with_texture(0);
    let mut mesh = K3dMesh::new(geometry);
    mesh.set_render_mode(RenderMode::Textured);
    mesh
}

fn textures() -> TextureManager<1> {
    let grey = |&grey: &u8| Rgb565::new(grey / 8, grey / 4, grey / 8);
    let texels: Vec<_> = TEXTURE.iter().map(grey).collect();
    let mut textures = TextureManager::new();
    let side = u32::try_from(SIDE).expect("small");
    assert_eq!(textures.add_texture(Texture::new(texels.leak(), side, side)), Some(0));
    textures
}

fn face_normal([a, b, c]: [[f32; 3]; 3]) -> [f32; 3] {
    let minus = |p: [f32; 3], q: [f32; 3]| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    let ([ux, uy, uz], [vx, vy, vz]) = (minus(b, a), minus(c, a));
    let cross = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    let length = cross.iter().map(|v| v * v).sum::<f32>().sqrt();
    cross.map(|v| v / length)
}

impl<P: Pixels> Embedded3dgfx<P> {
    #[expect(clippy::cast_possible_truncation, reason = "small numbers")]
    pub fn new(size: Size) -> Self {
        let mut engine = K3dengine::new(size.width as u16, size.height as u16);
        engine.camera.set_fovy(2.0 * 0.5_f32.atan());
        Self {
            pixels: P::new(size),
            depths: vec![Z_MAX_VALUE; (size.width * size.height) as usize],
            commands: Box::default(),
            engine,
            cube: mesh(Solid::Cube),
            torus: mesh(Solid::Torus),
            wall: wall(size),
            textures: textures(),
        }
    }
}

impl<P: Pixels> Engine for Embedded3dgfx<P> {
    fn size(&self) -> Size {
        self.pixels.size()
    }

    fn darken(&mut self) {
        let Ok(()) = self.pixels.clear(Rgb565::BLACK);
    }

    fn frame(&mut self, solid: Solid, frame: u16) {
        self.darken();
        let mesh = match solid {
            Solid::Cube => &mut self.cube,
            Solid::Torus => &mut self.torus,
        };
        let [about_x, about_y] = radians(frame);
        mesh.set_attitude(about_x, about_y, 0.0);
        let Size { width, height } = self.pixels.size();
        let mut context = FrameCtx { zbuffer: &mut self.depths, width: width as usize, height: height as usize };
        // Recording also orders to clear the depths.
        let recorded = self.engine.record([&*mesh], &mut self.commands, None);
        let drawn = self.engine.execute(&mut self.pixels, &mut context, &self.commands, None);
        assert!(recorded.is_ok() && drawn.is_ok());
    }

    const HAS_WALL: bool = true;

    fn wall(&mut self) {
        self.darken();
        let Size { width, height } = self.pixels.size();
        let mut context = FrameCtx { zbuffer: &mut self.depths, width: width as usize, height: height as usize };
        let recorded = self.engine.record([&self.wall], &mut self.commands, None);
        let Self { engine, pixels, commands, textures, .. } = self;
        let drawn = engine.execute_with_textures(pixels, &mut context, commands, textures, None);
        assert!(recorded.is_ok() && drawn.is_ok());
    }

    fn picture(&self, look: impl FnOnce(&[u8])) {
        look(&self.pixels.bits().bytes);
    }

    fn covered(&mut self) -> Vec<bool> {
        self.depths.iter().map(|&depth| depth < Z_MAX_VALUE).collect()
    }
}

/// The place of a pixel.
fn place(point: Point) -> (usize, usize) {
    (point.x.cast_unsigned() as usize, point.y.cast_unsigned() as usize)
}

fn luma(color: Rgb565) -> u8 {
    let (red, green, blue) = (u16::from(color.r()) * 527, u16::from(color.g()) * 259, u16::from(color.b()) * 527);
    let [high, _] = ((red >> 6) * 77 + (green >> 6) * 151 + (blue >> 6) * 28).to_be_bytes();
    high
}

/// Two bytes a pixel.
pub struct Words {
    size: Size,
    pixels: Vec<Rgb565>,
}

impl Pixels for Words {
    fn new(size: Size) -> Self {
        Self { size, pixels: vec![Rgb565::BLACK; (size.width * size.height) as usize] }
    }

    fn bits(&self) -> Bits {
        Bits::of(self.size, self.pixels.iter().copied().map(luma))
    }
}

impl OriginDimensions for Words {
    fn size(&self) -> Size {
        self.size
    }
}

impl DrawTarget for Words {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(point, color) in pixels {
            let (x, y) = place(point);
            self.pixels[y * self.size.width as usize + x] = color;
        }
        Ok(())
    }

    fn clear(&mut self, color: Rgb565) -> Result<(), Infallible> {
        self.pixels.fill(color);
        Ok(())
    }
}

/// A bit a pixel.
pub struct Packed(Bits);

impl Pixels for Packed {
    fn new(size: Size) -> Self {
        Self(Bits::new(size))
    }

    fn bits(&self) -> Bits {
        self.0.clone()
    }
}

impl OriginDimensions for Packed {
    #[expect(clippy::cast_possible_truncation, reason = "small numbers")]
    fn size(&self) -> Size {
        Size::new(self.0.width as u32, (self.0.bytes.len() * 8 / self.0.width) as u32)
    }
}

impl DrawTarget for Packed {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(point, color) in pixels {
            let (x, y) = place(point);
            self.0.plot(x, y, luma(color));
        }
        Ok(())
    }

    fn clear(&mut self, _color: Rgb565) -> Result<(), Infallible> {
        self.0.bytes.fill(0);
        Ok(())
    }
}
