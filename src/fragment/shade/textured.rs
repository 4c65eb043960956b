//! Textures on triangles.

use super::{Corner, Facet, Perspective, Placed, Shading, offset};
use crate::{
    colour::Light,
    fragment::texture::{Filter, Sampler, Texels, Wrap},
    illumination::Illumination,
    num::bits,
    vary::{Plane, Varying},
};

/// A texture in the light of another shading, right in perspective: one reciprocal every eight pixels.
///
/// The places are those of the mesh; without them, all of it has the colour of one place of the texture.
///
/// ```
/// use aquatint::fragment::{
///     shade::{Gouraud, Textured},
///     texture::{BLACK_AND_WHITE, Bilinear, Sampler, Texture},
/// };
///
/// let checks = Texture::new(&[0b1000_0000, 0b0100_0000], 2, 2, &BLACK_AND_WHITE).unwrap();
/// let shading = Textured::new(Sampler::new(checks).with_filter(Bilinear), Gouraud);
/// # let _ = shading;
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Textured<X, S> {
    sampler: X,
    shading: S,
}

impl<T: Texels, W: Wrap, F: Filter, S: Shading<Color = Light>> Textured<Sampler<T, W, F>, S> {
    /// What `sampler` gives, in the light of `shading`; [`Unlit`](super::Unlit) shows it as it is.
    pub const fn new(sampler: Sampler<T, W, F>, shading: S) -> Self {
        Self { sampler, shading }
    }

    /// The same without perspective: for what is small or seen from the front, and cheaper.
    pub fn affine(self) -> Affine<Sampler<T, W, F>, S> {
        Affine { sampler: self.sampler, shading: self.shading }
    }
}

impl<T: Texels, W: Wrap, F: Filter, S: Shading<Color = Light>> Shading for Textured<Sampler<T, W, F>, S> {
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
        let (places, rest) = split(facet.placed);
        let face = self.shading.face(light, &facet.with_placed(&rest));
        (Perspective::new(facet.slopes, &places), face)
    }

    #[inline]
    fn colors<I: Illumination>(
        &self,
        light: &I,
        (places, face): &Self::Face,
        at @ (row, column): (i32, i32),
    ) -> impl Iterator<Item = Option<Light>> {
        let places = places.scaled_at(row, column, Some(self.sampler.fine_shifts()));
        lit(&self.sampler, places, self.shading.colors(light, face, at))
    }
}

/// A texture whose places are linear on the screen: no division, and bent where it is seen at a slant.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Affine<X, S> {
    sampler: X,
    shading: S,
}

impl<T: Texels, W: Wrap, F: Filter, S: Shading<Color = Light>> Shading for Affine<Sampler<T, W, F>, S> {
    type Attributes = ([u16; 2], S::Attributes);
    type Face = (Plane<2>, S::Face);
    type Color = Light;
    const NEEDS_LIGHT: bool = S::NEEDS_LIGHT;
    const NEEDS_W: bool = S::NEEDS_W;
    const DROPS: bool = S::DROPS;

    #[inline]
    fn corner(&self, corner: &Corner) -> Self::Attributes {
        (corner.uv.map(offset), self.shading.corner(corner))
    }

    #[inline]
    fn face<I: Illumination>(&self, light: &I, facet: &Facet<'_, Self::Attributes>) -> Self::Face {
        let (places, rest) = split(facet.placed);
        let face = self.shading.face(light, &facet.with_placed(&rest));
        (facet.slopes.plane(&places.map(|corner| corner.attributes)), face)
    }

    #[inline]
    fn colors<I: Illumination>(
        &self,
        light: &I,
        (places, face): &Self::Face,
        at @ (row, column): (i32, i32),
    ) -> impl Iterator<Item = Option<Light>> {
        let (mut places, right) = (places.at(row, column), self.sampler.fine_shifts());
        let places = core::iter::repeat_with(move || {
            let [u, v] = places.next_fine();
            // Attributes are unsigned, with the zero of texture coordinates in the middle.
            let place = |fine: u32, right: u32| bits((fine.cast_signed().wrapping_sub(1 << 30) << 1) >> right);
            [place(u, right[0]), place(v, right[1])]
        });
        lit(&self.sampler, places, self.shading.colors(light, face, at))
    }
}

/// The texels at some places, each in its light.
#[inline]
fn lit<T: Texels, W: Wrap, F: Filter>(
    sampler: &Sampler<T, W, F>,
    places: impl Iterator<Item = [u32; 2]>,
    lights: impl Iterator<Item = Option<Light>>,
) -> impl Iterator<Item = Option<Light>> {
    places.zip(lights).map(|([u, v], light)| Some(sampler.sample(u.cast_signed(), v.cast_signed()).reflected(light?.0)))
}

/// Corners with only the first, and with only the second of what they carry.
#[inline]
fn split<A: Varying, B: Varying>(placed: &[Placed<(A, B)>; 3]) -> ([Placed<A>; 3], [Placed<B>; 3]) {
    let first = placed.map(|Placed { position, w, attributes: (a, _) }| Placed { position, w, attributes: a });
    (first, placed.map(|Placed { position, w, attributes: (_, b) }| Placed { position, w, attributes: b }))
}
