//! Fog: what is far takes the light of the air. Lecture 2.2.2, shading.
//!
//! ```text
//!   fog  1 ┤         ╱───        fog  1 ┤        ___---
//!          │       ╱                    │    _-‾
//!          │     ╱                      │  ╱
//!        0 ┼───╱──────── w            0 ┼╱──────────── w
//!            near   far                 0     exponential
//! ```
//!
//! Fog towards black is *depth cueing*: it tells near lines from far ones in a picture that has no faces.
//!
//! - **Takes** the light of a vertex or a fragment, and how far in front of the eye it is: `w`.
//! - **Gives** the light that arrives.
//! - **Cost** one product of 64 bits and two of 32; exponential five more. No division.

use crate::{
    colour::Light,
    error::describe,
    num::{Scalar, divide_round, high_u16, low_u32, saturate_u16},
};

/// The light of the air, and how it grows with the distance.
///
/// ```
/// use aquatint::{Light, Scalar, geometry::fog::Fog};
///
/// let dusk = Fog::linear(Scalar::from_num(2), Scalar::from_num(10), Light(20_000))?;
/// assert_eq!(dusk.over(Light(60_000), Scalar::from_num(1)), Light(60_000));
/// assert_eq!(dusk.over(Light(60_000), Scalar::from_num(4)), Light(50_000));
/// assert_eq!(dusk.over(Light(60_000), Scalar::from_num(11)), Light(20_000));
/// # Ok::<(), aquatint::geometry::fog::BadFog>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Fog {
    light: Light,
    /// Where it begins and how far it grows, in units of 2⁻¹⁶.
    near: i64,
    depth: i64,
    /// What it grows by in such a unit: of the whole, or of the halvings; 48 fraction bits.
    slope: i64,
    halves: bool,
}

/// The fog does not grow: `near` is not before `far`, or a distance is not positive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BadFog;

describe! { BadFog, Self => "the fog does not begin before it ends, or has no depth"; }

/// Coefficients of the cubic in [`halved`], in 65536ths; they make ½ together.
const C1: u32 = 45_331;
const C2: u32 = 15_165;
const C3: u32 = 2_602;

/// Nothing is left after sixteen.
const MOST_HALVINGS: i64 = 16;

impl Fog {
    /// Fog that begins at the distance `near` and hides everything from `far` on.
    ///
    /// # Errors
    /// [`BadFog`]: `near` is not less than `far`.
    pub fn linear(near: Scalar, far: Scalar, light: Light) -> Result<Self, BadFog> {
        let way = i64::from(far.to_bits()) - i64::from(near.to_bits());
        if way <= 0 {
            return Err(BadFog);
        }
        Ok(Self { light, near: near.to_bits().into(), depth: way, slope: divide_round(1 << 48, way), halves: false })
    }

    /// Fog as thick everywhere: at the distance `half` it hides half, at twice the distance three quarters.
    ///
    /// # Errors
    /// [`BadFog`]: `half` is not positive.
    pub fn exponential(half: Scalar, light: Light) -> Result<Self, BadFog> {
        if half <= 0 {
            return Err(BadFog);
        }
        let half = i64::from(half.to_bits());
        Ok(Self { light, near: 0, depth: MOST_HALVINGS * half, slope: divide_round(1 << 48, half), halves: true })
    }

    /// What part of 65536 is hidden at a distance; all of it is 65535.
    ///
    /// Linear within 2 of the exact part where the fog is at least ½ deep, exponential within 12.
    #[must_use]
    pub fn part(&self, w: Scalar) -> u16 {
        // Below 2⁵², because the way is no longer than what the slope is over.
        let grown = (i64::from(w.to_bits()) - self.near).max(0).min(self.depth) * self.slope;
        if self.halves { u16::MAX - halved(grown >> 32) } else { saturate_u16(grown >> 32) }
    }

    /// The light that arrives from a distance. With perspective, `w` of clip space is that distance.
    #[must_use]
    pub fn over(&self, light: Light, w: Scalar) -> Light {
        self.hiding(light, self.part(w))
    }

    /// The light that arrives where a [part](Self::part) of it is hidden.
    #[inline]
    #[must_use]
    pub fn hiding(&self, light: Light, part: u16) -> Light {
        let part = u32::from(part);
        // The whole of 65536 where all is hidden.
        let part = part + u32::from(part == 0xFFFF);
        let mixed = u32::from(light.0) * (65_536 - part);
        // Both at most 65535 · 65536 together.
        Light(high_u16((mixed + u32::from(self.light.0) * part).saturating_add(1 << 15)))
    }
}

/// 65535 halved as often as a number from 0 to [`MOST_HALVINGS`] with 16 fraction bits says.
fn halved(times: i64) -> u16 {
    let (whole, f) = (low_u32(times) >> 16, low_u32(times) & 0xFFFF);
    // 2⁻ᶠ = 1 − 0.6917 f + 0.2314 f² − 0.0397 f³ within 10⁻⁴, and exact at both ends.
    let (square, cube) = ((f * f) >> 16, (((f * f) >> 16) * f) >> 16);
    let rest = (C1 * f - C2 * square + C3 * cube) >> 16;
    saturate_u16(i64::from((u32::from(u16::MAX) - rest) >> whole))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(value: f64) -> Scalar {
        Scalar::saturating_from_num(value)
    }

    #[test]
    fn linear_fog_is_linear() {
        for (near, far) in [(0.0, 0.5), (0.125, 8.0), (-3.0, 4000.0), (100.0, 100.5)] {
            let fog = Fog::linear(number(near), number(far), Light::BLACK).unwrap();
            for i in -100..1100 {
                let w = number(near + (far - near) * f64::from(i) / 1000.0);
                let exact = ((w.to_num::<f64>() - near) / (far - near)).clamp(0.0, 1.0) * 65_536.0;
                let error = f64::from(fog.part(w)) - exact;
                assert!(error.abs() <= 2.0, "{near} to {far} at {w}: {error}");
            }
        }
    }

    #[test]
    fn exponential_fog_halves_what_is_left() {
        for half in [0.25, 1.0, 7.5, 300.0] {
            let fog = Fog::exponential(number(half), Light::BLACK).unwrap();
            for i in 0..1000 {
                let w = number(half * f64::from(i) / 50.0);
                let exact = (1.0 - (-w.to_num::<f64>() / half).exp2()) * 65_536.0;
                let error = f64::from(fog.part(w)) - exact;
                assert!(error.abs() <= 12.0, "{half} at {w}: {error}");
            }
        }
    }

    #[test]
    fn the_ends_are_the_two_lights() {
        for fog in [Fog::linear(number(1.0), number(2.0), Light(777)), Fog::exponential(Scalar::DELTA, Light(777))] {
            let fog = fog.unwrap();
            assert_eq!(fog.over(Light(50_000), number(0.0)), Light(50_000));
            assert_eq!(fog.over(Light(50_000), number(2.0)), Light(777));
            assert_eq!(fog.over(Light::WHITE, Scalar::MIN), Light::WHITE);
            assert_eq!(fog.over(Light::WHITE, Scalar::MAX), Light(777));
        }
    }

    #[test]
    fn extreme_fogs() {
        assert_eq!(Fog::linear(Scalar::ONE, Scalar::ONE, Light::WHITE), Err(BadFog));
        assert_eq!(Fog::exponential(Scalar::ZERO, Light::WHITE), Err(BadFog));
        let ends = [Scalar::MIN, -Scalar::DELTA, Scalar::ZERO, Scalar::DELTA, Scalar::MAX];
        for i in 0..125 {
            let [near, far, w] = [i % 5, i / 5 % 5, i / 25].map(|i| ends[i]);
            for fog in [Fog::linear(near, far, Light::WHITE), Fog::exponential(far, Light::WHITE)].into_iter().flatten()
            {
                assert_eq!(fog.over(Light::WHITE, w), Light::WHITE);
            }
        }
    }
}
