//! Turning solids: one frame is everything from clearing the picture and the depths to the packed bits.
//!
//! The camera is at the origin and looks down −z, near 0.4, far 20; the height of the view is its distance. A cycle is
//! sixteen frames. In frame `i` the solid is turned by `Rx(0.2 + πi/16)`, then by `Ry(0.1 + 2πi/16)`, angles to the
//! nearest 65536th of a turn, and moved to z = −4. Lamp: 0.1 everywhere, and 0.9 from the direction (0.4, 0.6, 0.69),
//! computed at the vertices and interpolated. Back faces are not drawn; depths are tested. At one bit a
//! pixel, light is dithered 4 × 4.
//!
//! An item draws a whole cycle, and counts are for the mean frame. The wall does not turn: it is one frame.

use core::{convert::Infallible, hint::black_box};

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Size},
    pixelcolor::BinaryColor,
};

#[cfg(not(target_os = "none"))]
use super::solid_models::VERTICES;
use super::{
    Item, Label, OURS, Visitor,
    peers::{Shapes, Surface},
    solid_models::Solid,
    solid_ours::{Memory, Ours},
};
#[cfg(not(target_os = "none"))]
use aquatint::pipeline::MeshVertex;

/// Frames of a cycle.
pub const FRAMES: u16 = 16;

/// A panel by its name.
pub type Panel = (&'static str, Size);

/// The small one, which the board has memory for.
const SMALL: Panel = ("128x64", Size::new(128, 64));

/// How solids lie in frame `i`: about x, then about y, in 65536ths of a turn.
pub fn angles(frame: u16) -> [u16; 2] {
    [2086 + 2048 * frame, 1043_u16.wrapping_add(frame.wrapping_mul(4096))]
}

/// Somebody who draws solids.
pub trait Engine {
    fn size(&self) -> Size;

    /// Makes every pixel dark.
    fn darken(&mut self);

    /// Draws a whole frame, clearing included.
    fn frame(&mut self, solid: Solid, frame: u16);

    /// Whether [`wall`](Self::wall) is drawn.
    const HAS_WALL: bool;

    /// Draws the textured wall, clearing included.
    fn wall(&mut self);

    /// Whether [`flat`](Self::flat) is drawn.
    const HAS_FLAT: bool = false;

    /// Draws a frame with one light a face, clearing included; the cube, which is convex, without depths.
    fn flat(&mut self, _solid: Solid, _frame: u16) {}

    /// Shows the picture as bits, rows of whole bytes, as we would dither it.
    fn picture(&self, look: impl FnOnce(&[u8]));

    /// Which pixels have a depth.
    #[cfg(not(target_os = "none"))]
    fn covered(&mut self) -> Vec<bool>;
}

/// A surface where somebody draws solids.
pub struct Stage<E>(pub E);

impl<E: Engine> Stage<E> {
    #[expect(clippy::unnecessary_wraps, reason = "an item")]
    fn cycle(&mut self, solid: Solid) -> Result<(), Infallible> {
        (0..black_box(FRAMES)).for_each(|frame| self.0.frame(black_box(solid), frame));
        Ok(())
    }

    #[expect(clippy::unnecessary_wraps, reason = "an item")]
    fn flat_cycle(&mut self, solid: Solid) -> Result<(), Infallible> {
        (0..black_box(FRAMES)).for_each(|frame| self.0.flat(black_box(solid), frame));
        Ok(())
    }

    #[expect(clippy::unnecessary_wraps, reason = "an item")]
    fn wall(&mut self) -> Result<(), Infallible> {
        self.0.wall();
        Ok(())
    }
}

impl<E: Engine> OriginDimensions for Stage<E> {
    fn size(&self) -> Size {
        self.0.size()
    }
}

impl<E: Engine> DrawTarget for Stage<E> {
    type Color = BinaryColor;
    type Error = Infallible;

    /// Nothing is drawn like that.
    fn draw_iter<I: IntoIterator<Item = Pixel<BinaryColor>>>(&mut self, _pixels: I) -> Result<(), Infallible> {
        Ok(())
    }

    fn clear(&mut self, _color: BinaryColor) -> Result<(), Infallible> {
        self.0.darken();
        Ok(())
    }
}

impl<E: Engine> Shapes for Stage<E> {}

impl<E: Engine> Surface for Stage<E> {
    fn picture(&self, look: impl FnOnce(&[u8])) {
        self.0.picture(look);
    }
}

/// What everybody draws.
pub fn items<'s, E: Engine>() -> &'s [Item<Stage<E>>] {
    &[("cube", |s| s.cycle(Solid::Cube)), ("torus", |s| s.cycle(Solid::Torus))]
}

/// What those draw who have it.
fn flat_items<'s, E: Engine>() -> &'s [Item<Stage<E>>] {
    &[("cube_flat", |s| s.flat_cycle(Solid::Cube)), ("torus_flat", |s| s.flat_cycle(Solid::Torus))]
}

/// Comes to everybody who draws solids, on every panel.
pub trait Engines {
    fn engine<E: Engine>(&mut self, panel: &'static str, who: &'static str, engine: E);
}

/// Shows what they draw to a visitor.
struct Items<'v, V>(&'v mut V);

impl<V: Visitor> Engines for Items<'_, V> {
    fn engine<E: Engine>(&mut self, panel: &'static str, who: &'static str, engine: E) {
        let mut stage = Stage(engine);
        for &(item, draw) in items() {
            self.0.visit(Label { item, panel, who, frames: FRAMES }, &mut stage, draw);
        }
        for &(item, draw) in flat_items().iter().filter(|_| E::HAS_FLAT) {
            self.0.visit(Label { item, panel, who, frames: FRAMES }, &mut stage, draw);
        }
        if E::HAS_WALL {
            self.0.visit(Label::new("quad", panel, who), &mut stage, Stage::wall);
        }
    }
}

/// What we draw on the small panel, for the board. Too small a memory would show as missing items in the results.
#[cfg(target_os = "none")]
pub fn small(memory: Memory<'_>, visitor: &mut impl Visitor) {
    let (panel, size) = SMALL;
    if let Some(ours) = Ours::new(memory, size) {
        Items(visitor).engine(panel, OURS, ours);
    }
}

/// What everybody draws on all panels.
#[cfg(not(target_os = "none"))]
pub fn all(visitor: &mut impl Visitor) {
    each(&mut Items(visitor));
}

/// Everybody on all panels.
#[cfg(not(target_os = "none"))]
pub fn each(engines: &mut impl Engines) {
    for panel in [SMALL, ("320x240", Size::new(320, 240)), ("400x240", Size::new(400, 240))] {
        ours(panel, engines);
        peers(panel, engines);
    }
}

#[cfg(not(target_os = "none"))]
fn ours((panel, size): Panel, engines: &mut impl Engines) {
    let pixels = (size.width * size.height) as usize;
    let (mut bytes, mut depths, mut vertices) =
        (vec![0; pixels / 8], vec![0; pixels], vec![MeshVertex::EMPTY; VERTICES]);
    let memory = Memory { bytes: &mut bytes, depths: &mut depths, vertices: &mut vertices };
    engines.engine(panel, OURS, Ours::new(memory, size).expect("enough memory"));
}

/// Each with its usual pixels, and with bits.
#[cfg(not(target_os = "none"))]
fn peers((panel, size): Panel, engines: &mut impl Engines) {
    use super::{solid_3dgfx as gfx, solid_euc as euc, solid_peers::Bits, solid_retrofire as retrofire};

    engines.engine(panel, "embedded-3dgfx", gfx::Embedded3dgfx::<gfx::Words>::new(size));
    engines.engine(panel, "embedded-3dgfx-1bit", gfx::Embedded3dgfx::<gfx::Packed>::new(size));
    engines.engine(panel, "euc", euc::Euc::<euc::Bytes>::new(size));
    engines.engine(panel, "euc-1bit", euc::Euc::<Bits>::new(size));
    engines.engine(panel, "retrofire", retrofire::Retrofire::<retrofire::Bytes>::new(size));
    engines.engine(panel, "retrofire-1bit", retrofire::Retrofire::<retrofire::Packed>::new(size));
}
