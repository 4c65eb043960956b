//! Angles, in binary parts of a turn, and their sine.

use micromath::F32Ext;

use crate::num::{Scalar, index, low_i32, saturate_i32};

/// An angle: 65536 is a full turn, so that angles add up and wrap as they should.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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
        let at = |entry: u16| low_i32((quarter_wave(entry.into()) + 0x4000) >> 15);
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

/// Sine and cosine of `turn / 2³²` turns, in parts of 2³¹, each within 1.1 of these parts (5.2 · 10⁻¹⁰).
///
/// From the nearest entry of the table it is at most 1/512 of a turn to the angle; that rest is added by
/// `sin(a + b) = sin a · cos b + cos a · sin b`, with `sin b` and `cos b` from their series. Six multiplications.
pub(crate) const fn sine_and_cosine(turn: u32) -> (i64, i64) {
    let within_quarter = turn & 0x3FFF_FFFF;
    // Half-way between two entries it is the one nearer to the diagonal, so that both sides are the same.
    let entry = (within_quarter + (1 << 23) - (within_quarter >> 29)) >> 24;
    // The angle b without its sign, in parts of 2³⁶: 2³⁰ units of the turn are a quarter, π/2.
    let units = within_quarter as i64 - (entry << 24) as i64;
    let b = (units.abs() * HALF_PI) >> 24;
    let square = (b * b) >> 36;
    // 1 − b²/2 + b⁴/24, without the 1, and b − b³/6: what follows is below 2⁻³⁸. 1/24 and 1/6 in parts of 2¹⁶.
    let cos_b = ((((square * square) >> 36) * 2731) >> 16) - (square >> 1);
    let sin_b = (b - ((((square * b) >> 36) * 10_923) >> 16)) * units.signum();
    let (sin_a, cos_a) = (quarter_wave(entry), quarter_wave(64 - entry));
    let sin = sin_a + nearest_36(sin_a * cos_b + cos_a * sin_b);
    let cos = cos_a + nearest_36(cos_a * cos_b - sin_a * sin_b);
    match turn >> 30 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

/// A number without its lowest 36 bits, to the nearest.
const fn nearest_36(value: i64) -> i64 {
    (value + (1 << 35)) >> 36
}

/// π/2 in parts of 2³⁰.
const HALF_PI: i64 = 1_686_629_713;

/// `2³¹ · sin(i/64 · 90°)` for i = 0 … 64, to the nearest.
const fn quarter_wave(entry: u32) -> i64 {
    let entry = index(entry.cast_signed());
    if entry < QUARTER_WAVE.len() { QUARTER_WAVE[entry] as i64 } else { 1 << 31 }
}

#[rustfmt::skip]
static QUARTER_WAVE: [u32; 65] = [
    0, 52_701_887, 105_372_028, 157_978_697, 210_490_206, 262_874_923, 315_101_295, 367_137_861,
    418_953_276, 470_516_330, 521_795_963, 572_761_285, 623_381_598, 673_626_408, 723_465_451, 772_868_706,
    821_806_413, 870_249_095, 918_167_572, 965_532_978, 1_012_316_784, 1_058_490_808, 1_104_027_237, 1_148_898_640,
    1_193_077_991, 1_236_538_675, 1_279_254_516, 1_321_199_781, 1_362_349_204, 1_402_678_000, 1_442_161_874, 1_480_777_044,
    1_518_500_250, 1_555_308_768, 1_591_180_426, 1_626_093_616, 1_660_027_308, 1_692_961_062, 1_724_875_040, 1_755_750_017,
    1_785_567_396, 1_814_309_216, 1_841_958_164, 1_868_497_586, 1_893_911_494, 1_918_184_581, 1_941_302_225, 1_963_250_501,
    1_984_016_189, 2_003_586_779, 2_021_950_484, 2_039_096_241, 2_055_013_723, 2_069_693_342, 2_083_126_254, 2_095_304_370,
    2_106_220_352, 2_115_867_626, 2_124_240_380, 2_131_333_572, 2_137_142_927, 2_141_664_948, 2_144_896_910, 2_146_836_866,
    2_147_483_648,
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
    fn fine_sines_and_cosines_are_within_a_part_of_all_angles() {
        let check = |turn: u32| {
            let exact = f64::from(turn) / 4_294_967_296.0 * core::f64::consts::TAU;
            let (sin, cos) = sine_and_cosine(turn);
            for (got, exact) in [(sin, exact.sin()), (cos, exact.cos())] {
                #[expect(clippy::cast_precision_loss, reason = "32 bits fit")]
                let error = got as f64 - exact * 2_147_483_648.0;
                assert!(error.abs() <= 1.1, "{turn}: {error}");
            }
            // The quarters are the same, and so are both sides of the diagonal.
            assert_eq!(sine_and_cosine(turn.wrapping_add(1 << 30)), (cos, -sin), "{turn}");
            assert_eq!(sine_and_cosine((1_u32 << 30).wrapping_sub(turn)), (cos, sin), "{turn}");
        };
        // All angles of 16 bits, others between them, and both sides of each place where the entry changes.
        (0..=u16::MAX).for_each(|turn| check(u32::from(turn) << 16));
        (0..1_000_000_u32).for_each(|step| check(step.wrapping_mul(2_654_435_769)));
        (0..512_u32)
            .for_each(|entry| [0, 1, 2].iter().for_each(|end| check((entry << 23).wrapping_sub(1).wrapping_add(*end))));
        assert_eq!(sine_and_cosine(0), (0, 1 << 31));
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
