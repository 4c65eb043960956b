//! The shadings of lines: what an end carries is light, and what arrives at a pixel becomes a colour.
//!
//! ```text
//!   Gouraud      light of the vertex ●━━━━━━━━━━● light of the vertex
//!   Unlit        white               ●━━━━━━━━━━● white
//!   Plain        one colour          ●━━━━━━━━━━●
//!   Fogged       what the fog leaves ●━━━━━━━━━━● of either
//! ```

use core::ops::Range;

use super::{Corner, Facet, Gouraud, Shading, Unlit};
use crate::{colour::Light, illumination::Illumination, num::Scalar, target::Target, vary::Ramp};

/// How lines get their colours: for [wireframes](crate::pipeline::draw_wireframe).
pub trait LineShading: Shading {
    /// Whether pixels get their light from the ends.
    const CARRIES_LIGHT: bool = true;

    /// The light that an end of a line carries.
    fn end(&self, corner: &Corner) -> Light;

    /// What is seen of that light from a distance, if the shading [needs](Shading::NEEDS_W) it.
    #[inline]
    fn seen(&self, light: Light, _w: Scalar) -> Light {
        light
    }

    /// Draws a run of pixels that are all seen; `run` is its row and its columns, at which the light begins.
    ///
    /// # Errors
    /// What the target says.
    fn paint_line<T: Target<Color = Self::Color>>(
        &self,
        run: (i32, Range<i32>),
        light: Ramp<1>,
        target: &mut T,
    ) -> Result<(), T::Error>;
}

impl LineShading for Gouraud {
    #[inline]
    fn end(&self, corner: &Corner) -> Light {
        let [light] = self.corner(corner);
        Light(light)
    }

    #[inline]
    fn paint_line<T: Target<Color = Light>>(
        &self,
        (row, columns): (i32, Range<i32>),
        light: Ramp<1>,
        target: &mut T,
    ) -> Result<(), T::Error> {
        target.fill_ramp(row, columns, light)
    }
}

/// White, unless there is fog.
impl LineShading for Unlit {
    #[inline]
    fn end(&self, _corner: &Corner) -> Light {
        Light::WHITE
    }

    #[inline]
    fn paint_line<T: Target<Color = Light>>(
        &self,
        (row, columns): (i32, Range<i32>),
        light: Ramp<1>,
        target: &mut T,
    ) -> Result<(), T::Error> {
        target.fill_ramp(row, columns, light)
    }
}

/// One colour for every pixel, of any kind: for lines, for shapes without light, and for faces in the colour of the paper
/// that only hide what is behind them.
///
/// ```
/// use aquatint::fragment::shade::Plain;
/// use embedded_graphics::pixelcolor::BinaryColor;
///
/// let (paper, ink) = (Plain(BinaryColor::Off), Plain(BinaryColor::On));
/// # let _ = (paper, ink);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Plain<C>(pub C);

impl<C: Copy> Shading for Plain<C> {
    type Attributes = [u16; 0];
    type Face = ();
    type Color = C;
    const IS_CHEAP: bool = true;

    #[inline]
    fn corner(&self, _corner: &Corner) -> [u16; 0] {
        []
    }

    #[inline]
    fn face<I: Illumination>(&self, _light: &I, _facet: &Facet<'_, [u16; 0]>) {}

    #[inline]
    fn colors<I: Illumination>(&self, _light: &I, _face: &(), _at: (i32, i32)) -> impl Iterator<Item = Option<C>> {
        core::iter::repeat(Some(self.0))
    }

    #[inline]
    fn paint<I: Illumination, T: Target<Color = C>>(
        &self,
        _light: &I,
        _face: &mut (),
        (row, columns): (i32, Range<i32>),
        target: &mut T,
    ) -> Result<(), T::Error> {
        target.fill_run(row, columns, [self.0])
    }
}

impl<C: Copy> LineShading for Plain<C> {
    const CARRIES_LIGHT: bool = false;

    #[inline]
    fn end(&self, _corner: &Corner) -> Light {
        Light::BLACK
    }

    #[inline]
    fn paint_line<T: Target<Color = C>>(
        &self,
        (row, columns): (i32, Range<i32>),
        _light: Ramp<1>,
        target: &mut T,
    ) -> Result<(), T::Error> {
        target.fill_run(row, columns, [self.0])
    }
}
