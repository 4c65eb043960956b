//! What fog leaves of another shading: the farther, the less.
//!
//! ```text
//!   w   2 ●────────────────● 9          at the corners by their distance, also at those that clipping has made;
//!   fog 0 ░░░░▒▒▒▒▓▓▓▓█████▇ ⅞          between them linear on the screen
//! ```

use core::ops::Range;

use super::{Corner, Facet, LineShading, Shading};
use crate::{
    colour::Light,
    fog::Fog,
    illumination::Illumination,
    num::Scalar,
    target::Target,
    vary::{Plane, Ramp},
};

/// The light of a shading behind fog. With fog towards black this is *depth cueing*: what is far is dark.
///
/// A pixel costs two products more than without. A floor that reaches from the eye to the horizon is better cut into
/// some tiles, because fog is linear between the corners.
///
/// ```
/// use aquatint::{Fog, Light, Scalar, fragment::shade::{Fogged, Gouraud}};
///
/// let dusk = Fog::linear(Scalar::from_num(2), Scalar::from_num(10), Light(20_000))?;
/// let shading = Fogged::new(Gouraud, dusk);
/// # let _ = shading;
/// # Ok::<(), aquatint::geometry::fog::BadFog>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Fogged<S> {
    shading: S,
    fog: Fog,
}

impl<S: Shading<Color = Light>> Fogged<S> {
    /// Puts fog before what `shading` gives.
    #[must_use]
    pub const fn new(shading: S, fog: Fog) -> Self {
        Self { shading, fog }
    }
}

impl<S: Shading<Color = Light>> Shading for Fogged<S> {
    type Attributes = S::Attributes;
    /// What part is hidden.
    type Face = (Plane<1>, S::Face);
    type Color = Light;
    const NEEDS_LIGHT: bool = S::NEEDS_LIGHT;
    const NEEDS_W: bool = true;
    const DROPS: bool = S::DROPS;

    #[inline]
    fn corner(&self, corner: &Corner) -> S::Attributes {
        self.shading.corner(corner)
    }

    #[inline]
    fn face<I: Illumination>(&self, light: &I, facet: &Facet<'_, S::Attributes>) -> Self::Face {
        let parts = facet.placed.each_ref().map(|corner| [self.fog.part(corner.w)]);
        (facet.slopes.plane(&parts), self.shading.face(light, facet))
    }

    #[inline]
    fn colors<I: Illumination>(
        &self,
        light: &I,
        (parts, face): &Self::Face,
        at @ (row, column): (i32, i32),
    ) -> impl Iterator<Item = Option<Light>> {
        let lights = self.shading.colors(light, face, at).zip(parts.at(row, column));
        lights.map(|(light, [part])| Some(self.fog.hiding(light?, part)))
    }
}

/// The light of the ends behind the fog, linear between them. Does not compile for one [`Plain`](super::Plain) light, which
/// no end carries: [`Unlit`](super::Unlit) lines are white.
impl<S: LineShading<Color = Light>> LineShading for Fogged<S> {
    #[inline]
    fn end(&self, corner: &Corner) -> Light {
        self.shading.end(corner)
    }

    #[inline]
    fn seen(&self, light: Light, w: Scalar) -> Light {
        const { assert!(S::CARRIES_LIGHT, "lines of one colour carry no light for the fog") }
        self.fog.over(self.shading.seen(light, w), w)
    }

    #[inline]
    fn paint_line<T: Target<Color = Light>>(
        &self,
        run: (i32, Range<i32>),
        light: Ramp<1>,
        target: &mut T,
    ) -> Result<(), T::Error> {
        self.shading.paint_line(run, light, target)
    }
}
