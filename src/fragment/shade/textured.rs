//! Textures on triangles.

use super::{Corner, Facet, Perspective, Shading, offset, reflected};
use crate::{
    colour::Light,
    fragment::texture::Sample,
    illumination::Illumination,
    num::to_16_15,
    vary::Plane,
};

/// A texture on another shading, right in perspective: one division every eight pixels.
///
/// The coordinates are those of the mesh; without them, all of it has the colour of one corner of the texture.
#[derive(Clone, Copy, Debug)]
pub struct Textured<X, S> {
    sampler: X,
    shading: S,
}

impl<X: Sample, S: Shading<Color = Light>> Textured<X, S> {
    /// What `sampler` gives, in the light of `shading`; [`Unlit`](super::Unlit) shows it as it is.
    pub const fn new(sampler: X, shading: S) -> Self {
        Self { sampler, shading }
    }
}

impl<X: Sample, S: Shading<Color = Light>> Shading for Textured<X, S> {
    type Attributes = ([u16; 2], S::Attributes);
    type Face = (Perspective<2>, S::Face);
    type Color = Light;
    const NEEDS_LIGHT: bool = S::NEEDS_LIGHT;
    const NEEDS_W: bool = true;
    const DROPS: bool = S::DROPS;

    #[inline]
    fn corner(&self, corner: &Corner) -> Self::Attributes {
        (corner.uv.map(offset), self.shading.corner(corner))
    }

    #[inline]
    fn face<I: Illumination>(&self, light: &I, facet: &Facet<'_, Self::Attributes>) -> Self::Face {
        (Perspective::new(facet.slopes, &facet.coordinates()), self.shading.face(light, &facet.rest()))
    }

    #[inline]
    fn colors<I: Illumination>(
        &self,
        light: &I,
        (plane, face): &Self::Face,
        at @ (row, column): (i32, i32),
    ) -> impl Iterator<Item = Option<Light>> {
        let texels = plane.at(row, column).map(|[u, v]| self.sampler.sample_fine(u, v));
        texels.zip(self.shading.colors(light, face, at)).map(|(texel, light)| Some(reflected(texel, light?)))
    }
}
