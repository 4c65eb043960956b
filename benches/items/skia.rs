//! tiny-skia without antialiasing, into its mask of a byte a pixel: a peer on the desk, with floats and a heap.

use core::convert::Infallible;

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Point, Size},
    pixelcolor::BinaryColor,
};
use tiny_skia::{FillRule, Mask, PathBuilder, Transform};

use super::peers::{Polygons, Shapes, Surface};

/// A picture of tiny-skia's.
pub struct TinySkia(Mask);

impl TinySkia {
    pub fn new() -> Self {
        Self(Mask::new(128, 64).expect("not empty"))
    }
}

impl OriginDimensions for TinySkia {
    fn size(&self) -> Size {
        Size::new(self.0.width(), self.0.height())
    }
}

impl DrawTarget for TinySkia {
    type Color = BinaryColor;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<BinaryColor>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        let width = self.0.width();
        for Pixel(Point { x, y }, color) in pixels {
            let (x, y) = (x.cast_unsigned(), y.cast_unsigned());
            if x < width && y < self.0.height() {
                self.0.data_mut()[(y * width + x) as usize] = if color.is_on() { 255 } else { 0 };
            }
        }
        Ok(())
    }

    fn clear(&mut self, color: BinaryColor) -> Result<(), Infallible> {
        self.0.data_mut().fill(if color.is_on() { 255 } else { 0 });
        Ok(())
    }
}

impl Shapes for TinySkia {
    fn triangle(&mut self, corners: [Point; 3], color: BinaryColor) -> Result<(), Infallible> {
        self.polygon(&corners, color)
    }
}

impl Polygons for TinySkia {
    #[expect(clippy::cast_precision_loss, reason = "small numbers")]
    fn polygon(&mut self, corners: &[Point], _color: BinaryColor) -> Result<(), Infallible> {
        let mut path = PathBuilder::new();
        for (index, corner) in corners.iter().enumerate() {
            let (x, y) = (corner.x as f32, corner.y as f32);
            if index == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
        }
        path.close();
        let path = path.finish().expect("not empty");
        self.0.fill_path(&path, FillRule::Winding, false, Transform::identity());
        Ok(())
    }
}

impl Surface for TinySkia {
    /// Packed as a panel of one bit a pixel has it.
    fn picture(&self, look: impl FnOnce(&[u8])) {
        let byte = |eight: &[u8]| eight.iter().fold(0, |byte, pixel| byte << 1 | u8::from(*pixel > 127));
        look(&self.0.data().chunks(8).map(byte).collect::<Vec<_>>());
    }
}
