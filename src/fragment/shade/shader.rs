//! Shading by a user's own closures.

use super::{Corner, Facet, Shading};
use crate::{illumination::Illumination, vary::Plane};

/// Your own: one closure says what a corner carries, the other makes a colour of what arrives at a pixel.
///
/// The `N` numbers are linear on the screen. `None` leaves a pixel out, and it hides nothing then. Both closures are
/// compiled into the loop.
///
/// ```
/// use aquatint::{Light, fragment::shade::{Corner, Shader}};
///
/// // Rings around the upright axis.
/// let rings = Shader::new(
///     |corner: &Corner| [corner.light.0, (corner.position[1].cast_unsigned()) ^ 0x8000],
///     |[light, height]: [u16; 2]| (height & 0x1000 != 0).then_some(Light(light)),
/// );
/// # let _ = rings;
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Shader<const N: usize, V, F> {
    corner: V,
    fragment: F,
}

impl<const N: usize, C: Copy, V: Fn(&Corner) -> [u16; N], F: Fn([u16; N]) -> Option<C>> Shader<N, V, F> {
    /// From the two closures.
    pub const fn new(corner: V, fragment: F) -> Self {
        Self { corner, fragment }
    }
}

impl<const N: usize, C: Copy, V: Fn(&Corner) -> [u16; N], F: Fn([u16; N]) -> Option<C>> Shading for Shader<N, V, F> {
    type Attributes = [u16; N];
    type Face = Plane<N>;
    type Color = C;
    const NEEDS_LIGHT: bool = true;
    const DROPS: bool = true;

    #[inline]
    fn corner(&self, corner: &Corner) -> [u16; N] {
        (self.corner)(corner)
    }

    #[inline]
    fn face<I: Illumination>(&self, _light: &I, facet: &Facet<'_, [u16; N]>) -> Plane<N> {
        facet.slopes.plane(&facet.placed.map(|corner| corner.attributes))
    }

    #[inline]
    fn colors<I: Illumination>(
        &self,
        _light: &I,
        face: &Plane<N>,
        (row, column): (i32, i32),
    ) -> impl Iterator<Item = Option<C>> {
        face.at(row, column).map(&self.fragment)
    }
}
