//! Antialiased shapes: coverage of a byte a pixel, row by row.

use core::{convert::Infallible, hint::black_box};

use aquatint::{
    Coverage, CoverageMask, Outline, Path, Point2, Polygon, Polyline, Rule, Segment, Stroke, Stroked,
    raster::area::{AreaEdge, Scratch, fill},
};
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Point, Size},
    pixelcolor::BinaryColor,
};
use heapless::Vec;

use super::{
    Item, MEMORY,
    peers::{Polygons, Shapes, Surface},
    scene::{HEART, star_fill, tri_fill},
};

/// What the surfaces of coverage are called.
pub const PANEL: &str = "a8";

/// Of all surfaces of coverage.
pub const SIZE: Size = Size::new(128, 64);

/// Edges and cells that our fill is lent.
const EDGES: usize = 16;
const CELLS: usize = 128;

/// The memory of both, in bytes.
#[allow(dead_code, reason = "only a test asks")]
#[cfg(not(target_os = "none"))]
pub const LENT: usize = EDGES * size_of::<AreaEdge>() + CELLS * size_of::<Coverage>();

/// Those who draw antialiased.
pub trait Soft: Polygons {
    /// Two cubic Béziers: an end, two control points, another end, two control points.
    fn heart(&mut self, points: [Point; 6]);

    /// A line of a width in pixels, between points.
    fn stroke(&mut self, ends: [Point; 2], width: u16);
}

pub fn items<'s, S: Soft>() -> &'s [Item<S>] {
    &[
        ("tri_fill_aa", tri_fill),
        ("star_fill_aa", star_fill),
        ("path_fill_aa", |s| {
            s.heart(black_box(HEART).map(Point::from));
            Ok(())
        }),
        ("line_aa", |s| stroke(s, 1)),
        ("thick_line_aa", |s| stroke(s, 5)),
    ]
}

/// The shallow line.
#[expect(clippy::unnecessary_wraps, reason = "an item")]
fn stroke<S: Soft>(surface: &mut S, width: u16) -> Result<(), S::Error> {
    surface.stroke(black_box([Point::new(7, 9), Point::new(106, 34)]), black_box(width));
    Ok(())
}

/// As aquatint draws.
pub struct Alpha<'m>(CoverageMask<&'m mut [u8]>);

impl<'m> Alpha<'m> {
    /// Too small a memory would show as missing items in the results.
    pub fn new(memory: &'m mut [u8; MEMORY]) -> Option<Self> {
        let needed = usize::try_from(SIZE.width * SIZE.height).ok()?;
        Some(Self(CoverageMask::new(memory.get_mut(..needed)?, SIZE)?))
    }

    fn fill(&mut self, outline: &impl Outline) {
        let (mut edges, mut cells) = (Vec::<AreaEdge, EDGES>::new(), [Coverage::NONE; CELLS]);
        let Ok(()) = fill(outline, Rule::NonZero, Scratch { edges: &mut edges, cells: &mut cells }, &mut self.0);
    }
}

impl OriginDimensions for Alpha<'_> {
    fn size(&self) -> Size {
        SIZE
    }
}

impl DrawTarget for Alpha<'_> {
    type Color = BinaryColor;
    type Error = Infallible;

    /// Nothing is drawn like that.
    fn draw_iter<I: IntoIterator<Item = Pixel<BinaryColor>>>(&mut self, _pixels: I) -> Result<(), Infallible> {
        Ok(())
    }

    fn clear(&mut self, _color: BinaryColor) -> Result<(), Infallible> {
        self.0.clear();
        Ok(())
    }
}

impl Shapes for Alpha<'_> {
    fn triangle(&mut self, corners: [Point; 3], color: BinaryColor) -> Result<(), Infallible> {
        self.polygon(&corners, color)
    }
}

impl Polygons for Alpha<'_> {
    fn polygon(&mut self, corners: &[Point], _color: BinaryColor) -> Result<(), Infallible> {
        let corners: Vec<_, 12> = corners.iter().map(|&Point { x, y }| Point2::corner(x, y)).collect();
        if let Ok(polygon) = Polygon::new(&[&corners]) {
            self.fill(&polygon);
        }
        Ok(())
    }
}

impl Soft for Alpha<'_> {
    fn heart(&mut self, points: [Point; 6]) {
        let [tip, a, b, top, c, d] = points.map(|Point { x, y }| Point2::corner(x, y));
        let heart = [Segment::MoveTo(tip), Segment::CubicTo(a, b, top), Segment::CubicTo(c, d, tip), Segment::Close];
        if let Ok(heart) = Path::new(&heart) {
            self.fill(&heart);
        }
    }

    fn stroke(&mut self, ends: [Point; 2], width: u16) {
        let ends = ends.map(|Point { x, y }| Point2::corner(x, y));
        if let Ok(line) = Polyline::new(&ends) {
            self.fill(&Stroked::new(line, Stroke::new(width)));
        }
    }
}

impl Surface for Alpha<'_> {
    fn picture(&self, look: impl FnOnce(&[u8])) {
        look(self.0.bytes());
    }
}

/// Those who read fonts.
#[cfg(not(target_os = "none"))]
pub trait Writes: Soft {
    /// A word in Inter, 24 pixels an em, its baseline beginning at (4, 40): the font is read for it.
    fn write(&mut self, word: &str);
}

#[cfg(not(target_os = "none"))]
pub fn words<'s, S: Writes>() -> &'s [Item<S>] {
    &[("word_aa", |s| {
        s.write(black_box("Aquatint"));
        Ok(())
    })]
}

/// The font, as its file is.
#[cfg(not(target_os = "none"))]
pub fn font() -> &'static [u8] {
    black_box(include_bytes!("../../examples/assets/inter.ttf"))
}

#[cfg(not(target_os = "none"))]
impl Writes for Alpha<'_> {
    fn write(&mut self, word: &str) {
        use aquatint::{Rect, Subpixel, Text, TrueType};

        // A font that cannot be read would show as an empty picture.
        let Ok(font) = TrueType::parse(font()) else { return };
        let text = Text::new(&font, word, Subpixel::from_num(24), Point2::corner(4, 40));
        text.glyphs(Rect::of_size(SIZE)).for_each(|glyph| self.fill(&glyph));
    }
}
