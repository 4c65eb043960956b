//! Whole pictures: every row of one, scaled on its way if asked for.

use embedded_graphics::{
    geometry::{OriginDimensions, Point},
    image::GetPixel,
};

use super::{Diffusion, Kernel};
use crate::{
    colour::Light,
    display::{
        dither::IntoLight,
        scale::{ScaledRow, Scaler},
    },
    num::size_i32,
    target::{Code, Target},
};

impl<K: Kernel> Diffusion<'_, '_, K> {
    /// Draws a whole picture with its top left corner at `at`.
    ///
    /// The picture is anything that can be read: a frame, an image of 8-bit greys in flash
    /// ([`Frame::with_slice`](crate::Frame::with_slice) with `Gray8`), colours. It is one picture: errors
    /// of others are forgotten. Rows below the target are not computed.
    ///
    /// ```
    /// use aquatint::{Diffusion, Frame, Levels, Rows, display::diffuse::SierraLite};
    /// use embedded_graphics::{pixelcolor::{BinaryColor, Gray8}, prelude::*};
    ///
    /// const PHOTO: Frame<Gray8, Rows, &[u8]> = match Frame::with_slice(&[188; 16 * 8], 16, 8) {
    ///     Ok(photo) => photo,
    ///     Err(_) => panic!("too small"),
    /// };
    /// let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 16], 16, 8).unwrap();
    /// let mut memory = [0; Diffusion::<SierraLite>::memory_needed(16)];
    /// let mut diffusion = Diffusion::<SierraLite>::new(&mut memory, 16, Levels::ONE_BIT).unwrap();
    /// diffusion.draw_picture(&mut frame, Point::zero(), &PHOTO)?;
    /// assert_eq!(frame.bytes().iter().map(|byte| byte.count_ones()).sum::<u32>(), 64);
    /// # Ok::<(), core::convert::Infallible>(())
    /// ```
    ///
    /// # Errors
    /// What the display behind says.
    pub fn draw_picture<T, P>(&mut self, target: &mut T, at: Point, picture: &P) -> Result<(), T::Error>
    where
        T: Target,
        T::Color: Code,
        P: GetPixel + OriginDimensions,
        P::Color: IntoLight,
    {
        self.restart();
        let bottom = target.bounds().bottom;
        for y in 0..size_i32(picture.size().height) {
            let place = Point::new(at.x, at.y.saturating_add(y));
            if place.y >= bottom {
                break;
            }
            self.draw_row(target, place, row_of(picture, y))?;
        }
        Ok(())
    }

    /// Draws a picture scaled by a [`Scaler`], which knows from which size to which. The diffusion is to be as wide as
    /// the result.
    ///
    /// Rows of the source below the target are not read.
    ///
    /// # Errors
    /// What the display behind says.
    pub fn draw_scaled<T, P>(
        &mut self,
        target: &mut T,
        at: Point,
        (picture, scaler): (&P, &mut Scaler<'_>),
    ) -> Result<(), T::Error>
    where
        T: Target,
        T::Color: Code,
        P: GetPixel + OriginDimensions,
        P::Color: IntoLight,
    {
        self.restart();
        scaler.restart();
        let (bottom, mut next) = (target.bounds().bottom, at.y);
        for y in 0..size_i32(scaler.from().height) {
            if next >= bottom {
                break;
            }
            scaler.push(row_of(picture, y), |_, row: ScaledRow<'_>| {
                self.draw_row(target, Point::new(at.x, next), row)?;
                next = next.saturating_add(1);
                Ok(())
            })?;
        }
        Ok(())
    }
}

/// The lights of a row; black where the picture has no pixel.
fn row_of<P>(picture: &P, y: i32) -> impl DoubleEndedIterator<Item = Light> + ExactSizeIterator + Clone
where
    P: GetPixel + OriginDimensions,
    P::Color: IntoLight,
{
    let columns = 0..size_i32(picture.size().width);
    columns.map(move |x| picture.pixel(Point::new(x, y)).map_or(Light::BLACK, IntoLight::into_light))
}
