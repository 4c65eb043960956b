//! Pixels that are not packed: what a packed frame is compared with.

use std::{convert::Infallible, ops::Range};

use aquatint::{Rect, Runs, Target};
use embedded_graphics::{image::GetPixel, pixelcolor::PixelColor, prelude::*};

/// What can be drawn on in every way there is: by its runs, by its areas, and where it was drawn on before.
pub trait Screen<C: PixelColor>:
    Target<Color = C, Error = Infallible> + DrawTarget<Color = C, Error = Infallible> + GetPixel<Color = C> + Runs
{
}

impl<C: PixelColor, S> Screen<C> for S where
    S: Target<Color = C, Error = Infallible> + DrawTarget<Color = C, Error = Infallible> + GetPixel<Color = C> + Runs
{
}

/// A colour for each pixel, row by row. It leaves to the traits all that they can do without it.
pub struct Unpacked<C> {
    size: Size,
    pixels: Vec<C>,
}

impl<C: PixelColor> Unpacked<C> {
    pub fn new(size: Size, color: C) -> Self {
        Self { size, pixels: vec![color; size.width as usize * size.height as usize] }
    }

    fn place(&self, point: Point) -> Option<usize> {
        let (x, y) = (u32::try_from(point.x).ok()?, u32::try_from(point.y).ok()?);
        (x < self.size.width && y < self.size.height).then_some((y * self.size.width + x) as usize)
    }

    fn put(&mut self, point: Point, color: C) {
        if let Some(place) = self.place(point) {
            self.pixels[place] = color;
        }
    }
}

impl<C> OriginDimensions for Unpacked<C> {
    fn size(&self) -> Size {
        self.size
    }
}

impl<C: PixelColor> GetPixel for Unpacked<C> {
    type Color = C;

    fn pixel(&self, point: Point) -> Option<C> {
        self.place(point).map(|place| self.pixels[place])
    }
}

impl<C: PixelColor> Runs for Unpacked<C> {}

impl<C: PixelColor> DrawTarget for Unpacked<C> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        pixels.into_iter().for_each(|Pixel(point, color)| self.put(point, color));
        Ok(())
    }
}

impl<C: PixelColor> Target for Unpacked<C> {
    type Color = C;
    type Error = Infallible;

    fn bounds(&self) -> Rect {
        Rect::of_size(self.size)
    }

    fn fill_run<const N: usize>(&mut self, row: i32, columns: Range<i32>, colors: [C; N]) -> Result<(), Infallible> {
        // The first colour is for column 0, wherever the run begins.
        let columns = columns.start.max(0)..columns.end.min(self.bounds().right);
        columns.for_each(|x| self.put(Point::new(x, row), colors[x.unsigned_abs() as usize % N]));
        Ok(())
    }

    fn write_run(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: impl Iterator<Item = Option<C>>,
    ) -> Result<(), Infallible> {
        for (x, color) in columns.zip(colors) {
            if let Some(color) = color {
                self.put(Point::new(x, row), color);
            }
        }
        Ok(())
    }
}
