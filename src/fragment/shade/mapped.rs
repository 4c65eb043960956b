//! What changes the colours of another shading, or leaves out pixels of it.

use super::{Corner, Facet, Shading};
use crate::{illumination::Illumination, num::index, phase::phase};

/// The colours of a shading, each changed by a closure: bands of a cartoon, a tint, a colour of the panel, or
/// [`Alpha`](crate::Alpha) for a [`Blended`](crate::Blended) display, which [`OnDrawTarget`](crate::OnDrawTarget) lends.
///
/// ```
/// use aquatint::{Alpha, Coverage, Light, fragment::shade::{Gouraud, Mapped}};
///
/// let glass = Mapped::new(Gouraud, |light: Light| Alpha::new(light, Coverage::from_byte(96)));
/// # let _ = glass;
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Mapped<S, F> {
    shading: S,
    map: F,
}

impl<S: Shading, C: Copy, F: Fn(S::Color) -> C> Mapped<S, F> {
    /// Gives the colours of `shading` to `map`.
    pub const fn new(shading: S, map: F) -> Self {
        Self { shading, map }
    }
}

impl<S: Shading, C: Copy, F: Fn(S::Color) -> C> Shading for Mapped<S, F> {
    type Attributes = S::Attributes;
    type Face = S::Face;
    type Color = C;
    const NEEDS_LIGHT: bool = S::NEEDS_LIGHT;
    const NEEDS_W: bool = S::NEEDS_W;
    const DROPS: bool = S::DROPS;

    #[inline]
    fn corner(&self, corner: &Corner) -> S::Attributes {
        self.shading.corner(corner)
    }

    #[inline]
    fn face<I: Illumination>(&self, light: &I, facet: &Facet<'_, S::Attributes>) -> S::Face {
        self.shading.face(light, facet)
    }

    #[inline]
    fn colors<I: Illumination>(&self, light: &I, face: &S::Face, at: (i32, i32)) -> impl Iterator<Item = Option<C>> {
        self.shading.colors(light, face, at).map(|color| color.map(&self.map))
    }
}

/// The pixels of a shading where the bits of a tile are set: see-through without blending, for one bit a pixel.
///
/// The tile is fixed to the screen: a byte a row, the highest bit on the left. What is left out hides nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Stippled<S, const H: usize> {
    shading: S,
    bits: [u8; H],
}

impl<S: Shading, const H: usize> Stippled<S, H> {
    /// Leaves out the pixels where a bit is not set.
    pub const fn new(shading: S, bits: [u8; H]) -> Self {
        Self { shading, bits }
    }
}

impl<S: Shading, const H: usize> Shading for Stippled<S, H> {
    type Attributes = S::Attributes;
    type Face = S::Face;
    type Color = S::Color;
    const NEEDS_LIGHT: bool = S::NEEDS_LIGHT;
    const NEEDS_W: bool = S::NEEDS_W;
    const DROPS: bool = true;

    #[inline]
    fn corner(&self, corner: &Corner) -> S::Attributes {
        self.shading.corner(corner)
    }

    #[inline]
    fn face<I: Illumination>(&self, light: &I, facet: &Facet<'_, S::Attributes>) -> S::Face {
        self.shading.face(light, facet)
    }

    #[inline]
    fn colors<I: Illumination>(
        &self,
        light: &I,
        face: &S::Face,
        (row, column): (i32, i32),
    ) -> impl Iterator<Item = Option<S::Color>> {
        let mut bits = phase(&self.bits, row).unwrap_or_default().rotate_left(crate::num::low_index(index(column & 7)));
        self.shading.colors(light, face, (row, column)).map(move |color| {
            bits = bits.rotate_left(1);
            color.filter(|_| bits & 1 == 1)
        })
    }
}
