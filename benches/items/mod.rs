//! What is measured: every item on every panel, drawn by aquatint and by its peers.
//!
//! The desk counts with callgrind and compares the pixels (`cargo bench`), the firmware counts on
//! emulated cores (`examples/mcu_bench.rs`, run by `.ci/firmware bench`); both walk these lists.
//! To add an item, write a function and name it in `both` (drawn by the peers too) or `alone`. To
//! add another kind of scene, or other peers, write a function like [`panel`] and call it in one of the parts.

mod bands;
#[cfg(not(target_os = "none"))]
mod growth;
mod ours;
mod peers;
mod pictures;
pub mod scanline;
mod scene;
#[cfg(not(target_os = "none"))]
mod skia;
mod soft;
#[cfg(not(target_os = "none"))]
mod soft_peers;
pub mod solid;
#[cfg(not(target_os = "none"))]
mod solid_3dgfx;
#[cfg(not(target_os = "none"))]
mod solid_euc;
pub mod solid_models;
pub mod solid_ours;
#[cfg(not(target_os = "none"))]
pub mod solid_peers;
#[cfg(not(target_os = "none"))]
mod solid_retrofire;
pub mod solid_wall;
#[cfg(not(target_os = "none"))]
mod ways;

use aquatint::{Frame, Pages, Rows};
use embedded_graphics::{
    draw_target::DrawTarget,
    framebuffer::{Framebuffer, buffer_size},
    pixelcolor::{
        BinaryColor, Gray4,
        raw::{BigEndian, RawU1, RawU4},
    },
};

use bands::Bands;
use ours::{Ink, Ours, Packed};
pub use peers::{Shapes, Surface};
#[cfg(not(target_os = "none"))]
#[allow(unused_imports, reason = "the counts have no use for them, the heap has")]
pub use soft::{LENT, PANEL as SOFT};

/// The longest picture: 400 × 240 at one bit.
pub const MEMORY: usize = 12_000;

/// Who is aquatint, in the results.
pub const OURS: &str = "aquatint";

const EMBEDDED_GRAPHICS: &str = "embedded-graphics";

/// What is drawn, on which panel, by whom.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Label {
    pub item: &'static str,
    pub panel: &'static str,
    pub who: &'static str,
    /// How many pictures one draw makes one after the other; counts are for one of them.
    pub frames: u16,
}

impl Label {
    /// Of an item that draws one picture.
    const fn new(item: &'static str, panel: &'static str, who: &'static str) -> Self {
        Self { item, panel, who, frames: 1 }
    }
}

/// Draws an item on a surface.
pub type Draw<S> = fn(&mut S) -> Result<(), <S as DrawTarget>::Error>;

/// An item by its name.
type Item<S> = (&'static str, Draw<S>);

/// Comes to every item on every surface.
pub trait Visitor {
    /// The surface holds what was drawn before.
    fn visit<S: Surface>(&mut self, label: Label, surface: &mut S, draw: Draw<S>);
}

/// Draws nothing: what calling an item costs.
#[expect(clippy::unnecessary_wraps, reason = "called in place of an item")]
pub fn nothing<S: Shapes>(_surface: &mut S) -> Result<(), S::Error> {
    Ok(())
}

/// Makes every pixel dark.
pub fn darken<S: Shapes>(surface: &mut S) -> Result<(), S::Error> {
    surface.clear(BinaryColor::Off.into())
}

/// Shows everything that is measured to `visitor`.
#[cfg(not(target_os = "none"))]
pub fn all(memory: &mut [u8; MEMORY], visitor: &mut impl Visitor) {
    pages(memory, visitor);
    rows(memory, visitor);
    grey(memory, visitor);
    single(memory, visitor);
    written(memory, visitor);
    desk(visitor);
    solid::all(visitor);
    growth::all(visitor);
    ways::all(visitor);
    scanline::turning(memory, &mut Box::new(scanline::Smooth::NEW), visitor);
    scanline::triangles(memory, &mut Box::new(scanline::Soup::NEW), visitor);
}

/// What is measured on pages. The parts are apart because the board of the firmware has not enough flash for all.
pub fn pages(memory: &mut [u8; MEMORY], visitor: &mut impl Visitor) {
    panel::<BinaryColor, Pages>("v128", (128, 64), memory, visitor);
    // embedded-graphics has no buffer of vertical bytes; this driver has its own.
    peer("v128", "ssd1306", peers::ssd1306, visitor);
}

/// What is measured on rows of one bit a pixel, narrow and wide.
pub fn rows(memory: &mut [u8; MEMORY], visitor: &mut impl Visitor) {
    panel::<BinaryColor, Rows>("h128", (128, 64), memory, visitor);
    peer("h128", EMBEDDED_GRAPHICS, OneBit::<128, 64, { buffer_size::<BinaryColor>(128, 64) }>::new, visitor);
    panel::<BinaryColor, Rows>("h400", (400, 240), memory, visitor);
    peer("h400", EMBEDDED_GRAPHICS, OneBit::<400, 240, { buffer_size::<BinaryColor>(400, 240) }>::new, visitor);
}

/// What is measured on rows of four bits a pixel.
pub fn grey(memory: &mut [u8; MEMORY], visitor: &mut impl Visitor) {
    panel::<Gray4, Rows>("g256", (256, 64), memory, visitor);
    peer("g256", EMBEDDED_GRAPHICS, FourBits::<256, 64, { buffer_size::<Gray4>(256, 64) }>::new, visitor);
}

/// Shows what a peer can that runs on the desk only.
#[cfg(not(target_os = "none"))]
fn desk(visitor: &mut impl Visitor) {
    let mut surface = skia::TinySkia::new();
    for &(item, draw) in scene::polygons() {
        visitor.visit(Label::new(item, "h128", "tiny-skia"), &mut surface, draw);
    }
    soft_peer("tiny-skia", soft_peers::TinySkia::new(), visitor);
    soft_peer("zeno", soft_peers::Zeno::new(), visitor);
    soft_peer("ab_glyph_rasterizer", soft_peers::AbGlyph::new(), visitor);
    for &(item, draw) in soft::words() {
        let label = Label::new(item, soft::PANEL, "ab_glyph_rasterizer");
        visitor.visit(label, &mut soft_peers::AbGlyph::new(), draw);
    }
}

/// Shows what we can on the desk only.
#[cfg(not(target_os = "none"))]
fn written(memory: &mut [u8; MEMORY], visitor: &mut impl Visitor) {
    let Some(mut mask) = soft::Alpha::new(memory) else { return };
    for &(item, draw) in soft::words() {
        visitor.visit(Label::new(item, soft::PANEL, OURS), &mut mask, draw);
    }
}

#[cfg(not(target_os = "none"))]
fn soft_peer<S: soft::Soft>(who: &'static str, mut surface: S, visitor: &mut impl Visitor) {
    for &(item, draw) in soft::items() {
        visitor.visit(Label::new(item, soft::PANEL, who), &mut surface, draw);
    }
}

/// What is drawn in three dimensions on the board.
#[cfg(target_os = "none")]
pub fn solids(memory: solid_ours::Memory<'_>, visitor: &mut impl Visitor) {
    solid::small(memory, visitor);
}

/// What is done to bytes, not to a surface, and what one panel is enough for.
pub fn single(memory: &mut [u8; MEMORY], visitor: &mut impl Visitor) {
    let (Some(sheet), Ok(target)) = (ours::load(), Frame::<BinaryColor, Rows, _>::new(&mut memory[..], 128, 64)) else {
        return;
    };
    let mut frame = Ours { target, sheet: &sheet };
    visitor.visit(Label::new("transpose", "h128", OURS), &mut frame, scene::transpose);
    for &(item, draw) in scene::outlines().iter().chain(scene::photographs()) {
        visitor.visit(Label::new(item, "h128", OURS), &mut frame, draw);
    }
    let Some(mut mask) = soft::Alpha::new(memory) else { return };
    for &(item, draw) in soft::items() {
        visitor.visit(Label::new(item, soft::PANEL, OURS), &mut mask, draw);
    }
}

type OneBit<const W: usize, const H: usize, const N: usize> = Framebuffer<BinaryColor, RawU1, BigEndian, W, H, N>;
type FourBits<const W: usize, const H: usize, const N: usize> = Framebuffer<Gray4, RawU4, BigEndian, W, H, N>;

/// Shows all items as aquatint draws them on one panel.
#[inline(never)]
fn panel<C, L>(name: &'static str, (width, height): (u32, u32), memory: &mut [u8; MEMORY], visitor: &mut impl Visitor)
where
    C: Ink,
    L: Packed<C>,
{
    // Too small a memory would show as missing items in the results.
    let (Some(sheet), Ok(target)) = (ours::load(), Frame::<C, L, _>::new(&mut memory[..], width, height)) else {
        return;
    };
    let mut frame = Ours { target, sheet: &sheet };
    for &(item, draw) in scene::both().iter().chain(scene::alone()) {
        visitor.visit(Label::new(item, name, OURS), &mut frame, draw);
    }
    let mut bands = Bands::<C, L>::new(memory, (width, height), &sheet);
    visitor.visit(Label::new("eight_bands", name, OURS), &mut bands, Bands::draw);
}

/// Shows the items that a peer can draw, on a surface of its own.
#[inline(never)]
fn peer<S: Surface>(panel: &'static str, who: &'static str, surface: impl FnOnce() -> S, visitor: &mut impl Visitor) {
    let mut surface = surface();
    for &(item, draw) in scene::both() {
        visitor.visit(Label::new(item, panel, who), &mut surface, draw);
    }
}
