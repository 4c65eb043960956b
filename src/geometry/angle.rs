//! Angles, in binary parts of a turn, and their sine.

use micromath::F32Ext;

use crate::num::{Scalar, saturate_i32};

/// An angle: 65536 is a full turn, so that angles add up and wrap as they should.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Angle(pub u16);

impl Angle {
    /// A quarter of a turn.
    pub const QUARTER: Self = Self(1 << 14);

    /// From degrees, to the nearest 1/65536 of a turn.
    ///
    /// The one place that uses floating point: for set-up, at some hundred instructions on a core
    /// without it. Angles beyond ±180,000° lose precision; what is not a number is 0.
    #[must_use]
    pub fn from_degrees(degrees: f32) -> Self {
        let turns = degrees / 360.0;
        #[expect(clippy::cast_possible_truncation, reason = "a float-to-int cast saturates")]
        let parts = F32Ext::round((turns - F32Ext::floor(turns)) * 65_536.0) as i32;
        Self(crate::num::low_u16(parts))
    }

    /// Half of the angle.
    #[must_use]
    pub const fn half(self) -> Self {
        Self(self.0 / 2)
    }

    /// The sine, within 6 units of the 16.16 format (9 · 10⁻⁵), by linear interpolation between
    /// 65 entries of a quarter wave.
    #[must_use]
    pub fn sin(self) -> Scalar {
        let within_quarter = self.0 & 0x3FFF;
        // The wave falls in the second and the fourth quarter: read the table backwards.
        let along = if self.0 & 0x4000 == 0 { within_quarter } else { 0x4000 - within_quarter };
        let (entry, part) = (along >> 8, i32::from(along & 0xFF));
        let at = |entry: u16| QUARTER_WAVE.get(usize::from(entry)).map_or(0x1_0000, |&v| i32::from(v));
        let magnitude = at(entry) + (((at(entry + 1) - at(entry)) * part + 0x80) >> 8);
        Scalar::from_bits(if self.0 & 0x8000 == 0 { magnitude } else { -magnitude })
    }

    /// The cosine: the sine a quarter of a turn on.
    #[must_use]
    pub fn cos(self) -> Scalar {
        Self(self.0.wrapping_add(Self::QUARTER.0)).sin()
    }

    /// The cotangent, saturated; `None` where the sine is zero.
    pub(crate) fn cot(self) -> Option<Scalar> {
        let (sin, cos) = (i64::from(self.sin().to_bits()), i64::from(self.cos().to_bits()));
        let quotient = crate::num::divide_round((cos << 16) * sin.signum(), sin.abs());
        (sin != 0).then(|| Scalar::from_bits(saturate_i32(quotient)))
    }
}

/// `65536 · sin(i/64 · 90°)` for i = 0 … 63, to the nearest; the 65th entry, 65536, does not fit.
#[rustfmt::skip]
static QUARTER_WAVE: [u16; 64] = [
    0, 1608, 3216, 4821, 6424, 8022, 9616, 11_204, 12_785, 14_359, 15_924, 17_479,
    19_024, 20_557, 22_078, 23_586, 25_080, 26_558, 28_020, 29_466, 30_893, 32_303, 33_692, 35_062,
    36_410, 37_736, 39_040, 40_320, 41_576, 42_806, 44_011, 45_190, 46_341, 47_464, 48_559, 49_624,
    50_660, 51_665, 52_639, 53_581, 54_491, 55_368, 56_212, 57_022, 57_798, 58_538, 59_244, 59_914,
    60_547, 61_145, 61_705, 62_228, 62_714, 63_162, 63_572, 63_944, 64_277, 64_571, 64_827, 65_043,
    65_220, 65_358, 65_457, 65_516,
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_angle_is_within_six_units() {
        for turn in 0..=u16::MAX {
            let exact = (f64::from(turn) / 65_536.0 * core::f64::consts::TAU).sin() * 65_536.0;
            let error = f64::from(Angle(turn).sin().to_bits()) - exact;
            assert!(error.abs() <= 6.0, "{turn}: {error}");
        }
    }

    #[test]
    fn symmetries_are_exact() {
        for turn in 0..=u16::MAX {
            let (here, opposite) = (Angle(turn), Angle(turn.wrapping_add(0x8000)));
            assert_eq!(here.sin(), -opposite.sin());
            assert_eq!(here.sin(), -Angle(turn.wrapping_neg()).sin());
        }
        assert_eq!([0, 0x4000, 0x8000, 0xC000].map(|t| Angle(t).sin()), [0, 1, 0, -1].map(Scalar::from_num));
    }

    #[test]
    fn degrees_round_to_the_nearest_part() {
        let cases = [(0.0, 0), (90.0, 0x4000), (-90.0, 0xC000), (360.0, 0), (359.9999, 0), (45.0, 0x2000)];
        for (degrees, parts) in cases {
            assert_eq!(Angle::from_degrees(degrees).0, parts, "{degrees}");
        }
        for strange in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN] {
            let _ = Angle::from_degrees(strange);
        }
    }
}
