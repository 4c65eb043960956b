//! Pictures row by row, with no depth for each pixel: the scenes of [`solid`](super::solid), and fifty triangles.
//!
//! The triangles lie anyhow before the eye, some through others, each flat and of one light, about 900 pixels large on
//! 400 × 240, and cover half of it; a row meets up to fifteen.

use core::{convert::Infallible, hint::black_box};

use aquatint::{
    Dithered, Frame, Levels, Light, Matrix, Rows, Scalar, Target,
    fragment::shade::{Flat, Gouraud, Shading},
    geometry::face::Faces,
    pipeline::{Instance, Material, SceneMemory, draw_scene},
};
#[cfg(not(target_os = "none"))]
use aquatint::{
    hidden::depth::DepthBuffer,
    pipeline::{Workspace, draw_mesh},
};
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Size},
    pixelcolor::BinaryColor,
};

use super::{
    Label, OURS, Visitor,
    peers::{Shapes, Surface},
    solid::{FRAMES, Panel},
    solid_models::{self, Solid},
    solid_ours::{mesh_of, placement, scene},
};

/// For turning solids.
pub type Smooth = SceneMemory<504, 560, 110, Gouraud>;
/// For fifty triangles.
pub type Soup = SceneMemory<150, 50, 40, Flat>;

/// The wide panel.
const WIDE: Panel = ("400x240", Size::new(400, 240));
/// The small one.
const SMALL: Panel = ("128x64", Size::new(128, 64));

/// Who draws by rows.
pub struct ByRows<'m, S: Shading, const V: usize, const F: usize, const A: usize> {
    frame: Frame<BinaryColor, Rows, &'m mut [u8]>,
    memory: &'m mut SceneMemory<V, F, A, S>,
    shading: S,
}

impl<'m, S: Shading<Color = Light> + Copy, const V: usize, const F: usize, const A: usize> ByRows<'m, S, V, F, A> {
    fn new(bytes: &'m mut [u8], memory: &'m mut SceneMemory<V, F, A, S>, size: Size, shading: S) -> Option<Self> {
        Some(Self { frame: Frame::new(bytes, size.width, size.height).ok()?, memory, shading })
    }

    /// What is refused would show as an empty picture.
    fn draw(&mut self, instance: Instance<'_, S>) -> Option<()> {
        let Ok(()) = self.frame.clear(BinaryColor::Off);
        let scene = scene(self.frame.bounds())?;
        let mut light = Dithered::new(&mut self.frame, Levels::ONE_BIT);
        draw_scene(&[instance], &scene, self.memory, &mut light).ok()
    }

    #[expect(clippy::unnecessary_wraps, reason = "an item")]
    fn cycle(&mut self, solid: Solid) -> Result<(), Infallible> {
        for frame in 0..black_box(FRAMES) {
            let Some(mesh) = mesh_of(black_box(solid).model()) else { continue };
            let _ = self.draw(Instance::new(mesh, placement(frame)).with_material(Material::new(self.shading)));
        }
        Ok(())
    }

    #[expect(clippy::unnecessary_wraps, reason = "an item")]
    fn soup(&mut self) -> Result<(), Infallible> {
        if let Some(soup) = soup(self.shading) {
            let _ = self.draw(black_box(soup));
        }
        Ok(())
    }
}

/// Fifty triangles, seen from both sides.
fn soup<S: Shading>(shading: S) -> Option<Instance<'static, S>> {
    let placement = Matrix::scale(Scalar::from_num(3) / 2);
    Some(
        Instance::new(mesh_of(solid_models::triangles())?, placement)
            .with_material(Material { faces: Faces::Both, ..Material::new(shading) }),
    )
}

impl<S: Shading, const V: usize, const F: usize, const A: usize> OriginDimensions for ByRows<'_, S, V, F, A> {
    fn size(&self) -> Size {
        self.frame.size()
    }
}

impl<S: Shading, const V: usize, const F: usize, const A: usize> DrawTarget for ByRows<'_, S, V, F, A> {
    type Color = BinaryColor;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<BinaryColor>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        self.frame.draw_iter(pixels)
    }

    fn clear(&mut self, color: BinaryColor) -> Result<(), Infallible> {
        self.frame.clear(color)
    }
}

impl<S: Shading, const V: usize, const F: usize, const A: usize> Shapes for ByRows<'_, S, V, F, A> {}

impl<S: Shading, const V: usize, const F: usize, const A: usize> Surface for ByRows<'_, S, V, F, A> {
    fn picture(&self, look: impl FnOnce(&[u8])) {
        look(self.frame.bytes());
    }
}

/// Turning solids in smooth light.
pub fn turning(bytes: &mut [u8], memory: &mut Smooth, visitor: &mut impl Visitor) {
    turning_on(SMALL, bytes, memory, visitor);
    turning_on(WIDE, bytes, memory, visitor);
}

fn turning_on((panel, size): Panel, bytes: &mut [u8], memory: &mut Smooth, visitor: &mut impl Visitor) {
    let Some(mut rows) = ByRows::new(bytes, memory, size, Gouraud) else { return };
    let label = |item| Label { item, panel, who: OURS, frames: FRAMES };
    visitor.visit(label("cube_rows"), &mut rows, |rows| rows.cycle(Solid::Cube));
    visitor.visit(label("torus_rows"), &mut rows, |rows| rows.cycle(Solid::Torus));
}

/// Fifty flat triangles on the wide panel.
pub fn triangles(bytes: &mut [u8], memory: &mut Soup, visitor: &mut impl Visitor) {
    let Some(mut rows) = ByRows::new(bytes, memory, WIDE.1, Flat) else { return };
    visitor.visit(Label::new("soup_rows", WIDE.0, OURS), &mut rows, ByRows::soup);
    #[cfg(not(target_os = "none"))]
    visitor.visit(Label::new("soup", WIDE.0, OURS), &mut rows, ByRows::soup_by_depth);
}

#[cfg(not(target_os = "none"))]
impl<const V: usize, const F: usize, const A: usize> ByRows<'_, Flat, V, F, A> {
    /// With a depth a pixel, for which the board has no memory.
    #[expect(clippy::unnecessary_wraps, reason = "an item")]
    fn soup_by_depth(&mut self) -> Result<(), Infallible> {
        let Ok(()) = self.frame.clear(BinaryColor::Off);
        let mut depths = vec![0_u32; 400 * 240];
        let mut hidden = DepthBuffer::new(&mut depths, self.frame.bounds()).expect("one each");
        let mut workspace = Workspace { vertices: self.memory.lend().vertices, hidden: &mut hidden };
        let scene = scene(self.frame.bounds()).expect("a view");
        let mut light = Dithered::new(&mut self.frame, Levels::ONE_BIT);
        draw_mesh(&soup(Flat).expect("a mesh"), &scene, &mut workspace, &mut light).expect("in range");
        Ok(())
    }
}
