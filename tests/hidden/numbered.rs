//! Faces with numbers in place of light.

use aquatint::{
    Illumination, Light,
    fragment::shade::{Corner, Facet, Shading},
    pipeline::{Instance, Material},
};

use crate::scenes::{Thing, Things};

/// The number of the first face.
pub const FIRST: usize = 2;

/// Gives every pixel the number of its face, from this one on, in meshes of which each face has three vertices of its own.
#[derive(Clone, Copy)]
pub struct Numbered(pub usize);

impl Shading for Numbered {
    type Attributes = [u16; 0];
    type Face = Light;
    type Color = Light;

    fn corner(&self, _corner: &Corner) -> [u16; 0] {
        []
    }

    fn face<I: Illumination>(&self, _light: &I, facet: &Facet<'_, [u16; 0]>) -> Light {
        Light(u16::try_from(self.0 + usize::from(facet.corners[0].index) / 3).expect("few"))
    }

    fn colors<I: Illumination>(
        &self,
        _light: &I,
        face: &Light,
        _at: (i32, i32),
    ) -> impl Iterator<Item = Option<Light>> {
        core::iter::repeat(Some(*face))
    }
}

/// The same faces, each with three vertices of its own.
pub fn apart(things: &Things) -> Things {
    let number = |at: usize| u16::try_from(at).expect("few");
    let apart = |thing: &Thing| {
        let corners: Vec<usize> = thing.triangles.iter().flatten().map(|&corner| usize::from(corner)).collect();
        Thing {
            positions: corners.iter().map(|&corner| thing.positions[corner]).collect(),
            normals: corners.iter().map(|&corner| thing.normals[corner]).collect(),
            triangles: (0..thing.triangles.len()).map(|face| [0, 1, 2].map(|at| number(3 * face + at))).collect(),
            placement: thing.placement,
        }
    };
    Things { things: things.things.each_ref().map(apart), faces: things.faces }
}

/// The instances, each face with a number.
pub fn instances(things: &Things) -> [Instance<'_, Numbered>; 3] {
    let mut base = FIRST;
    things.things.each_ref().map(|thing| {
        let material = Material { faces: things.faces, ..Material::new(Numbered(base)) };
        base += thing.triangles.len();
        Instance::new(thing.mesh(), thing.placement).with_material(material)
    })
}

/// The thing and the face of it that have a number.
pub fn face_of(things: &Things, number: u16) -> (&Thing, usize) {
    let mut face = usize::from(number) - FIRST;
    for thing in &things.things {
        if face < thing.triangles.len() {
            return (thing, face);
        }
        face -= thing.triangles.len();
    }
    panic!("no face has number {number}");
}
