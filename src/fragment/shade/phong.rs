//! Phong shading: the light of each pixel, by a normal that turns from corner to corner.

use super::{Corner, Facet, Shading, offset};
use crate::{
    colour::Light,
    illumination::{Illumination, unit_normal},
    vary::Plane,
};

/// Normals and places from corner to corner, linear on the screen, and the light at each pixel.
///
/// Shows highlights in the middle of a face. A pixel costs a square root's worth of instructions more than
/// [`Gouraud`](super::Gouraud), and what its light costs at a vertex.
///
/// B. T. Phong, "Illumination for computer generated pictures", Communications of the ACM 18(6), 1975.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Phong;

impl Shading for Phong {
    /// Normal, place and colour.
    type Attributes = [u16; 7];
    type Face = Plane<7>;
    type Color = Light;

    #[inline]
    fn corner(&self, corner: &Corner) -> [u16; 7] {
        let [nx, ny, nz] = corner.normal.map(|n| offset(i16::from(n) << 8));
        let [x, y, z] = corner.position.map(offset);
        [nx, ny, nz, x, y, z, corner.color.0]
    }

    #[inline]
    fn face<I: Illumination>(&self, _light: &I, facet: &Facet<'_, [u16; 7]>) -> Plane<7> {
        facet.slopes.plane(&facet.placed.map(|corner| corner.attributes))
    }

    #[inline]
    fn colors<I: Illumination>(
        &self,
        light: &I,
        face: &Plane<7>,
        (row, column): (i32, i32),
    ) -> impl Iterator<Item = Option<Light>> {
        face.at(row, column).map(|[nx, ny, nz, x, y, z, color]| {
            let signed = |value: u16| (value ^ 0x8000).cast_signed();
            let normal = unit_normal([nx, ny, nz].map(|n| i32::from(signed(n))));
            Some(light.on([x, y, z].map(signed), normal).reflected(color))
        })
    }
}
