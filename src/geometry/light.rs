//! Light at the vertices: ambient and diffuse, for Gouraud shading. Lecture 2.2.2, shading.
//!
//! ```text
//!      normal   lamp
//!         ▲    ╱            Lambert's law: light falls off with the cosine
//!         │  ╱ angle        of the angle at which it strikes
//!    ─────┴──────────
//! ```
//!
//! [`Lamp`] is the cheapest light that shows a shape. Lamps that are near, highlights and any number of lamps are
//! in [`lights`](super::lights). All of them are [`Lighting`]: what the pipeline asks for.

use crate::{
    colour::Light,
    illumination::Illumination,
    matrix::Matrix,
    num::saturate_u16,
    space::{Model, Point3, Vector3, World},
};

/// The light of a scene.
pub trait Lighting {
    /// The same, as one object sees it.
    type Illumination: Illumination;
    /// Whether it depends on where it is seen from, as highlights do.
    const NEEDS_EYE: bool = true;

    /// Turns everything into the object's own space, once for each object of a picture.
    fn for_object(&self, object: &Lit<'_>) -> Self::Illumination;
}

/// An object as light finds it.
#[derive(Clone, Copy, Debug)]
pub struct Lit<'a> {
    /// Where it is: turned, moved, and scaled alike along all axes. With other scales it is lit as if its normals
    /// had been scaled along, so that flattened things look flatter yet.
    pub placement: &'a Matrix<Model, World>,
    /// Where it is seen from: [`Matrix::eye`] of the camera. Only highlights move with it.
    pub eye: Point3<World>,
    /// What it is made of.
    pub surface: Surface,
}

/// What part of the light a surface gives back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Surface {
    /// In all directions alike, out of 65535: how white it is.
    pub diffuse: u16,
    /// In its highlights, out of 65535.
    pub specular: u16,
    /// How small its highlights are: Blinn's exponent is two to this power. 0 to 10; 3 is dull, 6 is polished.
    pub shininess: u8,
}

impl Surface {
    /// White and without highlights.
    pub const MATTE: Self = Self { diffuse: u16::MAX, specular: 0, shininess: 0 };
    /// Light grey, with the highlights of smooth plastic.
    pub const GLOSSY: Self = Self { diffuse: 45_000, specular: 40_000, shininess: 5 };
}

impl Default for Surface {
    fn default() -> Self {
        Self::MATTE
    }
}

/// A lamp far away, and the light that is everywhere. It makes no highlights, whatever the surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Lamp {
    /// From the scene *towards* the lamp; of any length but zero.
    pub direction: Vector3<World>,
    /// Light on faces that the lamp does not reach.
    pub ambient: Light,
    /// Light that the lamp adds to faces that it strikes squarely.
    pub diffuse: Light,
}

/// A lamp as one object sees it: its direction turned into the object's own space once, so that
/// no normal has to be turned.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ModelLamp {
    /// Length 1 in 2.14.
    direction: [i32; 3],
    ambient: Light,
    diffuse: Light,
}

impl Lamp {
    /// The lamp in the space of a white object that is turned, moved and scaled alike along all axes.
    ///
    /// A lamp without a direction gives only its ambient light.
    #[must_use]
    pub fn in_model_space(&self, placement: &Matrix<Model, World>) -> ModelLamp {
        let direction = self.direction.normalized().map(|world| placement.unrotate_vector(world));
        let direction = direction.and_then(Vector3::normalized);
        let direction = direction.map_or([0; 3], |d| [d.x, d.y, d.z].map(|v| v.to_bits() >> 2));
        ModelLamp { direction, ambient: self.ambient, diffuse: self.diffuse }
    }
}

impl Lighting for Lamp {
    type Illumination = ModelLamp;
    const NEEDS_EYE: bool = false;

    fn for_object(&self, object: &Lit<'_>) -> ModelLamp {
        let reflectance = object.surface.diffuse;
        let (ambient, diffuse) = (self.ambient.reflected(reflectance), self.diffuse.reflected(reflectance));
        ModelLamp { ambient, diffuse, ..self.in_model_space(object.placement) }
    }
}

impl ModelLamp {
    /// What the cosine of an angle, in 2.14, makes of the lamp.
    #[inline]
    fn at(&self, cosine: i32) -> Light {
        let diffuse = (cosine.cast_unsigned().min(1 << 14) * u32::from(self.diffuse.0)) >> 14;
        Light(saturate_u16(i64::from(self.ambient.0) + i64::from(diffuse)))
    }
}

impl Illumination for ModelLamp {
    /// Four 32-bit multiplications.
    #[inline]
    fn on(&self, _: [i16; 3], normal: [i16; 3]) -> Light {
        let [x, y, z] = self.direction;
        let [nx, ny, nz] = normal.map(i32::from);
        self.at((x * nx + y * ny + z * nz).max(0) >> 14)
    }

    /// Five 32-bit multiplications, but of bytes.
    #[inline]
    fn on_vertex(&self, _: [i16; 3], normal: [i8; 3]) -> Light {
        let [x, y, z] = self.direction;
        let [nx, ny, nz] = normal.map(i32::from);
        // 127 · 129 = 16383: the cosine in 2.14, at most a hair below 1.
        self.at(((x * nx + y * ny + z * nz).max(0) * 129) >> 14)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{angle::Angle, num::Scalar};

    fn lamp(x: f32, y: f32, z: f32) -> Lamp {
        let [x, y, z] = [x, y, z].map(Scalar::from_num);
        Lamp { direction: Vector3::new(x, y, z), ambient: Light(6_000), diffuse: Light(50_000) }
    }

    #[test]
    fn the_cosine_law() {
        let lamp = lamp(0.0, 0.0, 5.0).in_model_space(&Matrix::IDENTITY);
        let close = |got: Light, want: f64| (f64::from(got.0) - want).abs() < 40.0;
        let on = |normal| lamp.on_vertex([0; 3], normal);
        assert!(close(on([0, 0, 127]), 56_000.0));
        assert!(close(on([0, 90, 90]), 6_000.0 + 50_000.0 * 90.0 / 127.0));
        assert_eq!(on([127, 0, 0]), Light(6_000), "grazing");
        assert_eq!(on([0, 0, -128]), Light(6_000), "away");
        assert_eq!(lamp.on([0; 3], [0, 0, 1 << 14]), Light(56_000));
    }

    #[test]
    fn a_turned_object_sees_the_lamp_turned_back() {
        let placement = Matrix::<Model, World>::rotation_y(Angle::QUARTER);
        let lamp = lamp(1.0, 0.0, 0.0).in_model_space(&placement);
        // The model's +z has been turned to the world's +x.
        assert!(lamp.on_vertex([0; 3], [0, 0, 127]).0 > 55_900);
    }

    #[test]
    fn a_grey_surface_gives_back_its_part() {
        let eye = Point3::new(Scalar::ZERO, Scalar::ZERO, Scalar::ONE);
        let on = |diffuse| {
            let surface = Surface { diffuse, ..Surface::MATTE };
            let lamp = lamp(0.0, 0.0, 1.0).for_object(&Lit { placement: &Matrix::IDENTITY, eye, surface });
            [[0, 0, 127], [127, 0, 0], [0, -90, 90]].map(|normal| lamp.on_vertex([0; 3], normal).0)
        };
        assert_eq!(on(u16::MAX), [55_996, 6_000, 41_430]);
        assert_eq!(on(u16::MAX / 2), [27_998, 3_000, 20_715]);
        assert_eq!(on(0), [0; 3]);
    }

    #[test]
    fn extreme_lamps_saturate() {
        let bright = Lamp { ambient: Light::WHITE, diffuse: Light::WHITE, ..lamp(-100.0, 3.0, 9.0) };
        let dark = lamp(0.0, 0.0, 0.0).in_model_space(&Matrix::IDENTITY);
        for normal in [[i8::MIN; 3], [i8::MAX; 3], [0; 3]] {
            assert_eq!(bright.in_model_space(&Matrix::IDENTITY).on_vertex([0; 3], normal), Light::WHITE);
            assert_eq!(dark.on_vertex([0; 3], normal), Light(6_000));
        }
        for normal in [[i16::MIN; 3], [i16::MAX; 3], [0; 3]] {
            assert_eq!(bright.in_model_space(&Matrix::IDENTITY).on([0; 3], normal), Light::WHITE);
        }
    }

    #[test]
    fn bytes_give_the_light_of_long_normals() {
        let lamp = lamp(0.3, -0.7, 0.2).in_model_space(&Matrix::rotation_x(Angle(12_345)));
        for i in 0..2_097_152_u32 {
            let [x, y, z, _] = (i.wrapping_mul(2_654_435_769)).to_le_bytes().map(u8::cast_signed);
            assert_eq!(lamp.on_vertex([0; 3], [x, y, z]), lamp.on([0; 3], [x, y, z].map(|v| i16::from(v) * 129)));
        }
    }
}
