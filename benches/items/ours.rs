//! How aquatint draws: its own shapes, images as blits, and text from a sheet that was loaded before.

use core::convert::Infallible;

use aquatint::{
    Circle, Code, FillStyle, Frame, GlyphSheet, Line, Point2, Polygon, Rows, StrokeStyle,
    display::{
        blit::{Blit, Coded, RasterOp},
        layout::Layout,
    },
};
use embedded_graphics::{
    Drawable, Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point, Size},
    mono_font::ascii::FONT_6X10,
    pixelcolor::BinaryColor,
    primitives::{Primitive, Rectangle},
};

use heapless::Vec;

use super::{
    peers::{Polygons, Shapes, Surface},
    pictures::{BITS_SIZE, bits},
};

/// The colours of the panels.
pub trait Ink: Code + Coded + From<BinaryColor> {}
impl<C: Code + Coded + From<BinaryColor>> Ink for C {}

/// The layouts of the panels.
pub trait Packed<C: Ink>: Layout<C> + Layout<BinaryColor> {}
impl<C: Ink, L: Layout<C> + Layout<BinaryColor>> Packed<C> for L {}

/// The characters of the texts. In rows they take 732 bytes, in pages 768.
pub type Sheet<L> = GlyphSheet<'static, L, [u8; 768]>;

/// Loads the sheet. Too small a memory would show as missing items in the results.
pub fn load<L: Layout<BinaryColor>>() -> Option<Sheet<L>> {
    GlyphSheet::load(&FONT_6X10, [0; 768]).ok()
}

/// A frame, or a window on one, and what it is written on with.
pub struct Ours<'s, T, L> {
    pub target: T,
    pub sheet: &'s Sheet<L>,
}

impl<T: Dimensions, L> Dimensions for Ours<'_, T, L> {
    fn bounding_box(&self) -> Rectangle {
        self.target.bounding_box()
    }
}

impl<T: DrawTarget, L> DrawTarget for Ours<'_, T, L> {
    type Color = T::Color;
    type Error = T::Error;

    fn draw_iter<I: IntoIterator<Item = Pixel<T::Color>>>(&mut self, pixels: I) -> Result<(), T::Error> {
        self.target.draw_iter(pixels)
    }

    fn fill_contiguous<I: IntoIterator<Item = T::Color>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), T::Error> {
        self.target.fill_contiguous(area, colors)
    }

    fn fill_solid(&mut self, area: &Rectangle, color: T::Color) -> Result<(), T::Error> {
        self.target.fill_solid(area, color)
    }

    fn clear(&mut self, color: T::Color) -> Result<(), T::Error> {
        self.target.clear(color)
    }
}

impl<C, T, L> Shapes for Ours<'_, T, L>
where
    C: Ink,
    T: DrawTarget<Color = C, Error = Infallible> + Blit<Color = C>,
    L: Layout<BinaryColor>,
{
    fn line(&mut self, [start, end]: [Point; 2], color: C) -> Result<(), Infallible> {
        Line::new(start, end).into_styled(StrokeStyle::new(color)).draw(&mut self.target)
    }

    fn triangle(&mut self, corners: [Point; 3], color: C) -> Result<(), Infallible> {
        fill(&corners.map(|Point { x, y }| Point2::corner(x, y)), color, &mut self.target)
    }

    fn circle(&mut self, corner: Point, diameter: u32, color: C) -> Result<(), Infallible> {
        Circle::new(corner, diameter).into_styled(StrokeStyle::new(color)).draw(&mut self.target)
    }

    fn disc(&mut self, corner: Point, diameter: u32, color: C) -> Result<(), Infallible> {
        Circle::new(corner, diameter).into_styled(FillStyle::new(color)).draw(&mut self.target)
    }

    fn text(&mut self, text: &str, at: Point, color: C) -> Result<(), Infallible> {
        self.sheet.draw(&mut self.target, text, at, color);
        Ok(())
    }

    /// Bits are copied; on deeper pixels, those that are on are painted.
    fn image(&mut self, at: Point) -> Result<(), Infallible> {
        let Size { width, height } = BITS_SIZE;
        if <C as Code>::BITS == 1 {
            let Ok(bits) = Frame::<C, Rows, _>::new(bits(), width, height) else { return Ok(()) };
            self.target.blit(&bits, at, RasterOp::Copy);
        } else {
            let Ok(bits) = Frame::<BinaryColor, Rows, _>::new(bits(), width, height) else { return Ok(()) };
            self.target.fill_solid(&Rectangle::new(at, BITS_SIZE), BinaryColor::Off.into())?;
            self.target.paint(&bits, at, BinaryColor::On.into());
        }
        Ok(())
    }
}

impl<C: Ink, L: Packed<C>> Polygons for Ours<'_, Frame<C, L, &mut [u8]>, L> {
    fn polygon(&mut self, corners: &[Point], color: C) -> Result<(), Infallible> {
        let corners = corners.iter().map(|&Point { x, y }| Point2::corner(x, y));
        fill(&corners.collect::<Vec<_, 12>>(), color, &mut self.target)
    }
}

impl<C: Ink, L: Packed<C>> Surface for Ours<'_, Frame<C, L, &mut [u8]>, L> {
    fn picture(&self, look: impl FnOnce(&[u8])) {
        look(self.target.bytes());
    }
}

/// Fills one contour.
pub fn fill<D: DrawTarget>(corners: &[Point2], color: D::Color, target: &mut D) -> Result<(), D::Error> {
    let contours = [corners];
    // Corners out of range would show as a picture that differs from the peer's, or is empty.
    let Ok(polygon) = Polygon::new(&contours) else { return Ok(()) };
    polygon.into_styled(FillStyle::new(color)).draw(target)
}
