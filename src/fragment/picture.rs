//! Pictures as inks: a shape cut out of an image, or filled with copies of it.

use core::ops::Range;

use embedded_graphics::{
    geometry::{OriginDimensions, Point},
    image::GetPixel,
};

use crate::{
    num::size_i32,
    space::Rect,
    target::{Ink, Target},
};

/// An image whose pixels fill a shape: a [`Frame`](crate::Frame) in flash, an `ImageRaw` of
/// embedded-graphics, anything that can be read. A read a pixel.
///
/// ```
/// use aquatint::{Frame, Ink, PictureInk, Rows};
/// use embedded_graphics::{
///     image::ImageRaw,
///     pixelcolor::BinaryColor,
///     prelude::*,
/// };
///
/// let arrow = ImageRaw::<BinaryColor>::new(&[0b0100_0000, 0b1110_0000], 4);
/// let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 2], 8, 2).unwrap();
/// for row in 0..2 {
///     PictureInk::tiled(&arrow).anchored(Point::new(1, 0)).fill(&mut frame, row, 0..8)?;
/// }
/// assert_eq!(frame.bytes(), [0b0010_0010, 0b0111_0111]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug)]
pub struct PictureInk<'p, P> {
    picture: &'p P,
    anchor: Point,
    is_tiled: bool,
}

impl<'p, P: GetPixel + OriginDimensions> PictureInk<'p, P> {
    /// The picture once, its corner in the corner of the screen. Pixels beside it stay as they are.
    pub const fn once(picture: &'p P) -> Self {
        Self { picture, anchor: Point::zero(), is_tiled: false }
    }

    /// The picture again and again in both directions.
    pub const fn tiled(picture: &'p P) -> Self {
        Self { picture, anchor: Point::zero(), is_tiled: true }
    }

    /// The same with the picture's corner at another place.
    #[must_use]
    pub const fn anchored(self, anchor: Point) -> Self {
        Self { anchor, ..self }
    }
}

impl<P: GetPixel + OriginDimensions> Ink for PictureInk<'_, P> {
    type Color = P::Color;

    fn fill<T: Target<Color = P::Color>>(&self, target: &mut T, row: i32, columns: Range<i32>) -> Result<(), T::Error> {
        let Some(columns) = target.bounds().clip_run(row, columns) else { return Ok(()) };
        let (width, height) = (size_i32(self.picture.size().width), size_i32(self.picture.size().height));
        let (mut x, mut y) = (columns.start.wrapping_sub(self.anchor.x), row.wrapping_sub(self.anchor.y));
        if self.is_tiled {
            let (Some(column), Some(line)) = (x.checked_rem_euclid(width), y.checked_rem_euclid(height)) else {
                return Ok(());
            };
            (x, y) = (column, line);
        }
        let columns_of_picture = core::iter::repeat_with(|| {
            let here = x;
            x = x.wrapping_add(1);
            if self.is_tiled && x == width {
                x = 0;
            }
            here
        });
        let inside = Rect::new(0, 0, width, height);
        let read =
            |x| Some(Point::new(x, y)).filter(|&place| inside.contains(place)).and_then(|p| self.picture.pixel(p));
        target.write_run(row, columns, columns_of_picture.map(read))
    }
}
