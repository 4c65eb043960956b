//! Pictures side by side, each with its name.

use aquatint_simulator::Picture;
use embedded_graphics::{
    mono_font::{MonoTextStyle, ascii::FONT_6X10},
    pixelcolor::Rgb888,
    prelude::*,
    primitives::Rectangle,
    text::{Baseline, Text},
};

use crate::methods::Shown;

const DESK: [u8; 3] = [36, 38, 42];
const INK: Rgb888 = Rgb888::new(235, 235, 235);
const MARGIN: u32 = 8;
/// Below each picture, for its name.
const LINE: u32 = 14;
/// About as wide as high, whatever the photograph's shape.
const WIDEST: u32 = 1800;

/// What pictures are laid out on.
struct Canvas {
    size: Size,
    rgb: Vec<u8>,
}

impl OriginDimensions for Canvas {
    fn size(&self) -> Size {
        self.size
    }
}

impl DrawTarget for Canvas {
    type Color = Rgb888;
    type Error = core::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb888>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        for Pixel(point, color) in pixels {
            if let (Ok(x), Ok(y)) = (usize::try_from(point.x), usize::try_from(point.y)) {
                let (width, height) = (self.size.width as usize, self.size.height as usize);
                if x < width && y < height {
                    self.rgb[3 * (y * width + x)..][..3].copy_from_slice(&[color.r(), color.g(), color.b()]);
                }
            }
        }
        Ok(())
    }
}

/// All pictures, which are of one size, in rows.
pub fn sheet(pictures: &[Shown]) -> Result<Picture, String> {
    let one = pictures.first().map_or(Size::zero(), |shown| shown.photo.size);
    let pitch = one + Size::new(MARGIN, MARGIN + LINE);
    let columns = (WIDEST / pitch.width).clamp(1, 8) as usize;
    let rows = pictures.len().div_ceil(columns);
    let extent = |count: usize, length: u32| u32::try_from(count).unwrap_or(u32::MAX).saturating_mul(length) + MARGIN;
    let size = Size::new(extent(columns, pitch.width), extent(rows, pitch.height));
    let rgb = DESK.repeat(size.width as usize * size.height as usize);
    let mut canvas = Canvas { size, rgb };
    let style = MonoTextStyle::new(&FONT_6X10, INK);
    for (at, shown) in pictures.iter().enumerate() {
        let place = |at: usize, length: u32| extent(at, length).cast_signed();
        let corner = Point::new(place(at % columns, pitch.width), place(at / columns, pitch.height));
        let colors = shown.photo.pixels.iter().map(|&[r, g, b]| Rgb888::new(r, g, b));
        let Ok(()) = canvas.fill_contiguous(&Rectangle::new(corner, one), colors);
        let below = corner + Point::new(0, one.height.cast_signed() + 2);
        let Ok(_) = Text::with_baseline(shown.name, below, style, Baseline::Top).draw(&mut canvas);
    }
    Picture::from_rgb(size.width, size.height, canvas.rgb).map_err(|error| error.to_string())
}
