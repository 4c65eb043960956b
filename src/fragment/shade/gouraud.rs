//! The shadings without textures: none at all, one light a face, light from corner to corner.

use core::ops::Range;

use super::{Corner, Facet, Shading};
use crate::{
    colour::Light,
    illumination::{Illumination, unit_normal},
    num::saturate_i16,
    shade::Shade,
    target::Target,
    vary::{Plane, Ramp},
};

/// Full light everywhere: for textures as they are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Unlit;

impl Shading for Unlit {
    type Attributes = [u16; 0];
    type Face = ();
    type Color = Light;
    const IS_CHEAP: bool = true;

    #[inline]
    fn corner(&self, _corner: &Corner) -> [u16; 0] {
        []
    }

    #[inline]
    fn face<I: Illumination>(&self, _light: &I, _facet: &Facet<'_, [u16; 0]>) {}

    #[inline]
    fn colors<I: Illumination>(&self, _light: &I, _face: &(), _at: (i32, i32)) -> impl Iterator<Item = Option<Light>> {
        // Not `repeat`, which would keep the light in memory.
        core::iter::repeat_with(|| Some(Light::WHITE))
    }

    #[inline]
    fn paint<I: Illumination, T: Target<Color = Light>>(
        &self,
        _light: &I,
        _face: &mut (),
        (row, columns): (i32, Range<i32>),
        target: &mut T,
    ) -> Result<(), T::Error> {
        target.fill_run(row, columns, [Light::WHITE])
    }
}

/// One light for each face: that on its middle, by the normal of the face, or by the sum of those of its corners
/// if the mesh has none of faces. A run costs what a run of one colour costs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Flat;

impl Shading for Flat {
    type Attributes = [u16; 0];
    type Face = Shade;
    type Color = Light;
    const IS_CHEAP: bool = true;

    #[inline]
    fn corner(&self, _corner: &Corner) -> [u16; 0] {
        []
    }

    #[inline]
    fn face<I: Illumination>(&self, light: &I, facet: &Facet<'_, [u16; 0]>) -> Shade {
        let [a, b, c] = facet.corners;
        // A third is 21845 / 65536, and the product has 31 bits at the most.
        let middle = |axis: fn(&[i16; 3]) -> i16| {
            let sum = i32::from(axis(&a.position)) + i32::from(axis(&b.position)) + i32::from(axis(&c.position));
            saturate_i16(i64::from((sum * 21_845) >> 16))
        };
        let position = [middle(|p| p[0]), middle(|p| p[1]), middle(|p| p[2])];
        let on_face = match facet.normal {
            Some(normal) => light.on_vertex(position, normal),
            None => light.on(position, normal_of_sum([a.normal, b.normal, c.normal])),
        };
        Shade::new(on_face.reflected(a.color.0))
    }

    #[inline]
    fn colors<I: Illumination>(
        &self,
        _light: &I,
        face: &Shade,
        _at: (i32, i32),
    ) -> impl Iterator<Item = Option<Light>> {
        core::iter::repeat(Some(face.light()))
    }

    #[inline]
    fn paint<I: Illumination, T: Target<Color = Light>>(
        &self,
        _light: &I,
        face: &mut Shade,
        (row, columns): (i32, Range<i32>),
        target: &mut T,
    ) -> Result<(), T::Error> {
        target.fill_shade(row, columns, face)
    }
}

/// Out of the way of meshes that have normals of faces, so that those of their corners are not looked at.
#[inline(never)]
fn normal_of_sum([a, b, c]: [[i8; 3]; 3]) -> [i16; 3] {
    let sum = |axis: fn(&[i8; 3]) -> i8| i32::from(axis(&a)) + i32::from(axis(&b)) + i32::from(axis(&c));
    unit_normal([sum(|n| n[0]), sum(|n| n[1]), sum(|n| n[2])])
}

/// Light from corner to corner, linear on the screen. Lecture 2.2.2.
///
/// H. Gouraud, "Continuous shading of curved surfaces", IEEE Transactions on Computers C-20(6), 1971.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Gouraud;

impl Shading for Gouraud {
    type Attributes = [u16; 1];
    type Face = Plane<1>;
    type Color = Light;
    const IS_CHEAP: bool = true;
    const NEEDS_LIGHT: bool = true;

    #[inline]
    fn corner(&self, corner: &Corner) -> [u16; 1] {
        [corner.light.reflected(corner.color.0).0]
    }

    #[inline]
    fn face<I: Illumination>(&self, _light: &I, facet: &Facet<'_, [u16; 1]>) -> Plane<1> {
        facet.slopes.plane(&facet.placed.map(|corner| corner.attributes))
    }

    #[inline]
    fn colors<I: Illumination>(
        &self,
        _light: &I,
        face: &Plane<1>,
        (row, column): (i32, i32),
    ) -> impl Iterator<Item = Option<Light>> {
        face.at(row, column).map(|[light]| Some(Light(light)))
    }

    #[inline]
    fn paint<I: Illumination, T: Target<Color = Light>>(
        &self,
        _light: &I,
        face: &mut Plane<1>,
        (row, columns): (i32, Range<i32>),
        target: &mut T,
    ) -> Result<(), T::Error> {
        let ramp: Ramp<1> = face.at(row, columns.start);
        target.fill_ramp(row, columns, ramp)
    }
}
