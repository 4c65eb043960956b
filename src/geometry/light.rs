//! Light at the vertices: ambient and diffuse, for Gouraud shading. Lecture 2.2.2, shading.

use crate::{
    colour::Light,
    matrix::Matrix,
    num::saturate_u16,
    space::{Model, Vector3, World},
};

/// A lamp far away, and the light that is everywhere. Lambert's law: light falls off with the
/// cosine of the angle at which it strikes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lamp {
    /// From the scene *towards* the lamp; of any length but zero.
    pub direction: Vector3<World>,
    /// Light on faces that the lamp does not reach.
    pub ambient: Light,
    /// Light that the lamp adds to faces that it strikes squarely.
    pub diffuse: Light,
}

/// A surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Surface {
    /// Diffuse.
    pub diffuse: u16,
}

impl Surface {
    /// Matte.
    pub const MATTE: Self = Self { diffuse: u16::MAX };
}

/// What is lit.
#[derive(Clone, Copy, Debug)]
pub struct Lit<'a> {
    /// Where.
    pub placement: &'a Matrix<Model, World>,
    /// The eye.
    pub eye: crate::space::Point3<World>,
    /// Surface.
    pub surface: Surface,
}

/// Lighting.
pub trait Lighting {
    /// In model space.
    type Illumination: crate::illumination::Illumination;
    /// For an object.
    fn for_object(&self, object: &Lit<'_>) -> Self::Illumination;
}

impl Lighting for Lamp {
    type Illumination = ModelLamp;
    fn for_object(&self, object: &Lit<'_>) -> ModelLamp {
        self.in_model_space(object.placement)
    }
}

impl crate::illumination::Illumination for ModelLamp {
    fn on(&self, _position: [i16; 3], normal: [i16; 3]) -> Light {
        ModelLamp::on(self, normal.map(|n| i8::try_from(n >> 7).unwrap_or(127)))
    }
    fn on_vertex(&self, _position: [i16; 3], normal: [i8; 3]) -> Light {
        ModelLamp::on(self, normal)
    }
}

/// A lamp as one object sees it: its direction turned into the object's own space once, so that
/// no normal has to be turned.
#[derive(Clone, Copy, Debug)]
pub struct ModelLamp {
    /// Length 1 in 2.14.
    direction: [i32; 3],
    ambient: Light,
    diffuse: Light,
}

impl Lamp {
    /// The lamp in the space of an object that is turned, moved and scaled alike along all axes.
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

impl ModelLamp {
    /// The light on a surface with this normal (length 127). Four 32-bit multiplications.
    #[must_use]
    pub fn on(&self, normal: [i8; 3]) -> Light {
        let [x, y, z] = self.direction;
        let [nx, ny, nz] = normal.map(i32::from);
        // 127 · 129 = 16383: the cosine in 2.14, at most a hair below 1.
        let cosine = ((x * nx + y * ny + z * nz).max(0) * 129) >> 14;
        let diffuse = (cosine.cast_unsigned().min(1 << 14) * u32::from(self.diffuse.0)) >> 14;
        Light(saturate_u16(i64::from(self.ambient.0) + i64::from(diffuse)))
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
        assert!(close(lamp.on([0, 0, 127]), 56_000.0));
        assert!(close(lamp.on([0, 90, 90]), 6_000.0 + 50_000.0 * 90.0 / 127.0));
        assert_eq!(lamp.on([127, 0, 0]), Light(6_000), "grazing");
        assert_eq!(lamp.on([0, 0, -128]), Light(6_000), "away");
    }

    #[test]
    fn a_turned_object_sees_the_lamp_turned_back() {
        let placement = Matrix::<Model, World>::rotation_y(Angle::QUARTER);
        let lamp = lamp(1.0, 0.0, 0.0).in_model_space(&placement);
        // The model's +z has been turned to the world's +x.
        assert!(lamp.on([0, 0, 127]).0 > 55_900);
    }

    #[test]
    fn extreme_lamps_saturate() {
        let bright = Lamp { ambient: Light::WHITE, diffuse: Light::WHITE, ..lamp(-100.0, 3.0, 9.0) };
        let dark = lamp(0.0, 0.0, 0.0).in_model_space(&Matrix::IDENTITY);
        for normal in [[i8::MIN; 3], [i8::MAX; 3], [0; 3]] {
            assert_eq!(bright.in_model_space(&Matrix::IDENTITY).on(normal), Light::WHITE);
            assert_eq!(dark.on(normal), Light(6_000));
        }
    }
}
