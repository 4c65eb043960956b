//! Any number of lamps, near and far, and the highlights that they make.
//!
//! ```text
//!    directional      point              spot            highlight
//!      ╲  ╲  ╲        ╲ │ ╱              ╱▔╲            lamp ╲   │h  ╱ eye
//!       ╲  ╲  ╲      ── ● ──            ╱   ╲                 ╲  │ ╱
//!        ▼  ▼  ▼      ╱ │ ╲          bright  dark              ╲ │╱
//!    ─────────────    ───────────    ──█████▒░────        ──────────────
//! ```
//!
//! - **Diffuse** light falls off with the cosine of the angle at which it strikes (Lambert), and of near lamps with the
//!   square of the distance.
//! - **Highlights** are where the normal points half-way between lamp and eye: the cosine between normal and half-way,
//!   to the power of the surface's shininess (Blinn). Eye and lamps are where they are, not at infinity.
//! - **Memory** 48 bytes a lamp, on the stack.
//! - **Cost** a place, in instructions of a Cortex-M0: a directional lamp 140, a near one 440, a highlight 470 more.
//!   No division, no floating point. An object: some 13,000 a near lamp.
//! - **Error** of two lamps up to 64 of 65535, and in a highlight 8 more times its exponent, where lamps and eye are
//!   outside of the object; more where those stand opposite, over half the length of the sum of both directions. A cosine
//!   is within 4 of 16384: by so much may the border of a cone be elsewhere, and where a lamp grazes the surface by less,
//!   it has its highlight or none.
//!
//! Source: J. F. Blinn, "Models of light reflection for computer synthesized pictures", SIGGRAPH 1977.

use super::light::{Lighting, Lit, Surface};
use crate::{
    angle::Angle,
    colour::Light,
    illumination::{Illumination, Unit},
    matrix::Matrix,
    num::{Scalar, divide_round, saturate_i32, saturate_u16},
    space::{Model, Point3, Vector3, World},
};

/// 1 in 2.14.
const UNIT: i32 = 1 << 14;
/// The most that shininess counts: an exponent of 1024.
const MOST_SHININESS: u8 = 10;

/// One source of light, in the world.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// Far away, as the sun.
    Directional {
        /// From the scene *towards* the light; of any length but zero.
        direction: Vector3<World>,
        /// What it adds to faces that it strikes squarely.
        light: Light,
    },
    /// Near, shining in all directions: a bulb.
    Point {
        /// Where it is.
        position: Point3<World>,
        /// What it adds to faces that it strikes squarely, at the distance `reach`.
        light: Light,
        /// The distance at which it gives that much: half as far four times, twice as far a quarter.
        /// It is no brighter than four times, however near it is.
        reach: Scalar,
    },
    /// Near, shining into a cone: a torch.
    Spot {
        /// Where it is.
        position: Point3<World>,
        /// Where it shines *to*; of any length but zero.
        direction: Vector3<World>,
        /// As of [`Point`](Self::Point).
        light: Light,
        /// As of [`Point`](Self::Point).
        reach: Scalar,
        /// From the middle of the cone to where it begins to fade; less than `outer`.
        inner: Angle,
        /// From the middle of the cone to where it is dark; at most half a turn.
        outer: Angle,
    },
}

#[cfg(feature = "defmt")]
impl defmt::Format for Source {
    fn format(&self, f: defmt::Formatter<'_>) {
        use crate::num::Fixed;
        match self {
            Self::Directional { direction, light } => {
                defmt::write!(f, "Directional {{ direction: {}, light: {} }}", direction, light);
            }
            Self::Point { position, light, reach } => {
                defmt::write!(f, "Point {{ position: {}, light: {}, reach: {} }}", position, light, Fixed(*reach));
            }
            Self::Spot { position, direction, light, reach, inner, outer } => {
                defmt::write!(f, "Spot {{ position: {}, direction: {}, light: {}, ", position, direction, light);
                defmt::write!(f, "reach: {}, inner: {}, outer: {} }}", Fixed(*reach), inner, outer);
            }
        }
    }
}

/// Lamps of all kinds, and the light that is everywhere.
///
/// ```
/// use aquatint::{
///     Illumination, Light, Matrix, Point3, Scalar, Vector3,
///     geometry::{light::{Lighting, Lit, Surface}, lights::{Lights, Source}},
/// };
///
/// let [nil, one, four] = [0, 1, 4].map(Scalar::from_num);
/// let sun = Source::Directional { direction: Vector3::new(nil, one, one), light: Light(40_000) };
/// let bulb = Source::Point { position: Point3::new(nil, nil, four), light: Light(30_000), reach: one };
/// let lights = Lights { ambient: Light(4_000), sources: [sun, bulb] };
///
/// let eye = Point3::new(nil, nil, four);
/// let on_cube = lights.for_object(&Lit { placement: &Matrix::IDENTITY, eye, surface: Surface::GLOSSY });
/// assert!(on_cube.on([0, 0, 16384], [0, 0, 16384]) > Light(25_000));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Lights<const N: usize> {
    /// Light on faces that no source reaches.
    pub ambient: Light,
    /// What shines.
    pub sources: [Source; N],
}

/// Lamps as one object sees them.
#[derive(Clone, Copy, Debug)]
pub struct ModelLights<const N: usize> {
    /// What the surface gives back of it.
    ambient: Light,
    surface: Surface,
    /// 2.14, as places of a mesh.
    eye: [i32; 3],
    sources: [ModelSource; N],
}

/// A source in the space of an object. What has no direction or place there is dark.
#[derive(Clone, Copy, Debug)]
enum ModelSource {
    Dark,
    /// Towards it, of length 1 in 2.14.
    Directional([i32; 3], Light),
    Near(Near, Light),
}

/// A source at a place of an object's space, all in 2.14.
#[derive(Clone, Copy, Debug)]
struct Near {
    position: [i32; 3],
    reach: u32,
    cone: Option<Cone>,
}

#[derive(Clone, Copy, Debug)]
struct Cone {
    /// Back along it, of length 1 in 2.14.
    axis: [i32; 3],
    /// The cosine at its border, and what it gains to where it is bright.
    outer: i32,
    gain: i32,
    /// 2²⁸ over the gain.
    over_gain: i32,
}

impl<const N: usize> Lighting for Lights<N> {
    type Illumination = ModelLights<N>;

    fn for_object(&self, object: &Lit<'_>) -> ModelLights<N> {
        ModelLights {
            ambient: self.ambient.reflected(object.surface.diffuse),
            surface: object.surface,
            eye: place(object.placement, object.eye).unwrap_or_default(),
            sources: self.sources.map(|source| ModelSource::new(source, object.placement).unwrap_or(ModelSource::Dark)),
        }
    }
}

impl ModelSource {
    fn new(source: Source, placement: &Matrix<Model, World>) -> Option<Self> {
        let near = |position, reach, cone| {
            Some(Near { position: place(placement, position)?, reach: distance(placement, reach)?, cone })
        };
        Some(match source {
            Source::Directional { direction, light } => Self::Directional(turned(placement, direction)?, light),
            Source::Point { position, light, reach } => Self::Near(near(position, reach, None)?, light),
            Source::Spot { position, direction, light, reach, inner, outer } => {
                let axis = turned(placement, direction)?.map(|v| -v);
                Self::Near(near(position, reach, Some(Cone::new(axis, inner, outer)))?, light)
            }
        })
    }

    /// The direction from a place towards the source, and the light that arrives there, up to four times white.
    #[inline]
    fn at(&self, place: [i32; 3]) -> Option<([i32; 3], u32)> {
        match self {
            Self::Dark => None,
            Self::Directional(direction, light) => Some((*direction, light.0.into())),
            Self::Near(near, light) => {
                let way = Unit::of(between(place, near.position))?;
                let lit = (u32::from(light.0) * near.falloff(&way)) >> 14;
                let lit = near.cone.map_or(lit, |cone| ((lit >> 2) * cone.at(way.direction)) >> 12);
                Some((way.direction, lit))
            }
        }
    }
}

impl Near {
    /// The square of the reach over the distance in 2.14, at most a hair below 4.
    #[inline]
    fn falloff(&self, way: &Unit) -> u32 {
        // In 1.15, and `shift` is at least 16.
        let ratio = (u64::from(self.reach) * u64::from(way.reciprocal)) >> (way.shift - 15);
        let ratio = u32::from(saturate_u16(ratio.min(0xFFFF).cast_signed()));
        (ratio * ratio) >> 16
    }
}

impl Cone {
    fn new(axis: [i32; 3], inner: Angle, outer: Angle) -> Self {
        let cosine = |angle: Angle| Angle(angle.0.min(0x8000)).cos().to_bits() >> 2;
        let outer = cosine(outer);
        let gain = (cosine(inner) - outer).max(1);
        Self { axis, outer, gain, over_gain: (1 << 28) / gain }
    }

    /// What part of the light is left in a direction, in 2.14: from 0 to 1 by t² · (3 − 2t).
    #[inline]
    fn at(&self, direction: [i32; 3]) -> u32 {
        let inside = (dot(self.axis, direction) - self.outer).max(0).min(self.gain);
        let t = (inside * self.over_gain) >> 14;
        ((((t * t) >> 14) * (3 * UNIT - 2 * t)) >> 14).cast_unsigned()
    }
}

impl<const N: usize> Illumination for ModelLights<N> {
    fn on(&self, position: [i16; 3], normal: [i16; 3]) -> Light {
        let (position, normal) = (position.map(i32::from), normal.map(i32::from));
        let eye = if self.surface.specular > 0 { Unit::of(between(position, self.eye)) } else { None };
        let (mut diffuse, mut specular) = (0_u32, 0_u32);
        for source in &self.sources {
            let Some((direction, light)) = source.at(position) else { continue };
            let cosine = cosine(normal, direction).cast_unsigned();
            // Neither light nor a highlight where the lamp is behind the surface.
            if cosine > 0 {
                diffuse = diffuse.saturating_add((light * cosine) >> 14);
                let highlight = eye.as_ref().map_or(0, |eye| self.highlight(normal, direction, eye.direction));
                specular = specular.saturating_add(((light >> 2) * highlight) >> 14);
            }
        }
        let diffuse = saturated(diffuse).reflected(self.surface.diffuse);
        let specular = saturated(specular).reflected(self.surface.specular);
        Light(self.ambient.0.saturating_add(diffuse.0).saturating_add(specular.0))
    }
}

impl<const N: usize> ModelLights<N> {
    /// How much a highlight gives back in the direction of the eye: 16 bits.
    #[inline]
    fn highlight(&self, normal: [i32; 3], to_lamp: [i32; 3], to_eye: [i32; 3]) -> u32 {
        let [(a, b), (c, d), (e, f)] = pairs(to_lamp, to_eye);
        let Some(half_way) = Unit::of([a + b, c + d, e + f]) else { return 0 };
        let mut power = (cosine(normal, half_way.direction).cast_unsigned() << 2).min(0xFFFF);
        for _ in 0..self.surface.shininess.min(MOST_SHININESS) {
            power = (power * power + power) >> 16;
        }
        power
    }
}

fn saturated(light: u32) -> Light {
    Light(saturate_u16(light.into()))
}

fn pairs([a, b, c]: [i32; 3], [d, e, f]: [i32; 3]) -> [(i32, i32); 3] {
    [(a, d), (b, e), (c, f)]
}

/// The product of two vectors in 2.14, of which one may be up to three times as long as 1.
#[inline]
fn dot(a: [i32; 3], b: [i32; 3]) -> i32 {
    pairs(a, b).iter().map(|(a, b)| a * b).sum::<i32>() >> 14
}

/// The cosine of the angle between a normal and a direction, from 0 to 1 in 2.14.
#[inline]
fn cosine(normal: [i32; 3], direction: [i32; 3]) -> i32 {
    dot(normal, direction).clamp(0, UNIT)
}

/// The way from one place to another, both in 2.14.
#[inline]
fn between(from: [i32; 3], to: [i32; 3]) -> [i32; 3] {
    pairs(from, to).map(|(from, to)| to.saturating_sub(from))
}

/// A point of the world in the space of an object, in 2.14.
fn place(placement: &Matrix<Model, World>, point: Point3<World>) -> Option<[i32; 3]> {
    placement.untransform_point(point).map(|p| [p.x, p.y, p.z].map(|v| v.to_bits().saturating_add(2) >> 2))
}

/// A direction of the world in the space of an object, of length 1 in 2.14.
fn turned(placement: &Matrix<Model, World>, direction: Vector3<World>) -> Option<[i32; 3]> {
    let turned = placement.unrotate_vector(direction.normalized()?).normalized()?;
    Some([turned.x, turned.y, turned.z].map(|v| (v.to_bits() + 2) >> 2))
}

/// A distance of the world in the space of an object, in 2.14.
fn distance(placement: &Matrix<Model, World>, distance: Scalar) -> Option<u32> {
    let scale = placement.mean_scale();
    let quotient = divide_round(i64::from(distance.max(Scalar::ZERO).to_bits()) << 14, i64::from(scale));
    (scale > 0).then(|| saturate_i32(quotient).cast_unsigned())
}
