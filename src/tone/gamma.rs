//! Gamma: the power by which a panel or a picture file turns codes into light. Lecture 7.3.3.
//!
//! ```text
//!   light = code^γ        γ = 1: codes are light    2.2: NTSC    2.5: HDTV    2.8: PAL
//! ```
//!
//! Files are mostly sRGB, which is not a power: [`Light::from_srgb`] and [`Light::to_srgb`]. The panel is what
//! has a gamma of its own.
//!
//! **Cost**: decoding is one load, encoding eight comparisons. **Flash**: 1 KiB a gamma, 512 bytes for each
//! direction. **Accuracy**: each entry is the exact value rounded to the nearest; the arithmetic behind it is
//! right to 2⁻²⁰ of the last place, so that only an exact value that close to half-way may be rounded the other way.
//! Source: the lecture's "Gamma Correction in Computer Graphics"; Poynton, *Gamma FAQ*.

use crate::{
    colour::Light,
    num::{divide_floor, multiply_60, saturate_u16},
};

/// A power curve between codes and light.
///
/// ```
/// use aquatint::{Gamma, Light};
///
/// // The table is built by the compiler.
/// static PANEL: Gamma = Gamma::new(18, 10);
/// assert_eq!(PANEL.encode(Light(u16::MAX / 2)), 173);
/// assert_eq!(PANEL.decode(173), Light(32_597));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Gamma {
    /// The light of each code.
    lights: [u16; 256],
    /// The least light of each code.
    first: [u16; 256],
}

/// Gamma 2.2, which the lecture gives for NTSC.
pub static NTSC: Gamma = Gamma::new(22, 10);
/// Gamma 2.5, which the lecture gives for HDTV.
pub static HDTV: Gamma = Gamma::new(25, 10);
/// Gamma 2.8, which the lecture gives for PAL.
pub static PAL: Gamma = Gamma::new(28, 10);

impl Gamma {
    /// The curve `code^(numerator / denominator)`. Gammas beyond ⅛ to 8 are moved there.
    ///
    /// For a `static`: some hundred thousand instructions of the compiler. At run time it works too.
    #[must_use]
    pub const fn new(numerator: u8, denominator: u8) -> Self {
        let exponent = clamped(numerator, denominator);
        let (mut lights, mut first) = ([0; 256], [0; 256]);
        let mut code = u8::MAX;
        // 0 is black for any exponent, and what the tables begin with.
        while code > 0 {
            // A code and the border below it, in halves of a code: 2c and 2c − 1 of 510.
            let halves = 2 * code as u32;
            lights[code as usize] = part_of_white(power(halves, exponent), 1 << 47);
            first[code as usize] = part_of_white(power(halves - 1, exponent), (1 << 48) - 1);
            code -= 1;
        }
        Self { lights, first }
    }

    /// The light of a code, rounded to the nearest.
    ///
    /// The darkest codes of a high gamma have less light than one step of 65,536 and share a light: 0 and 1
    /// of gamma 2.2, 0 to 3 of 2.8.
    #[must_use]
    pub const fn decode(&self, code: u8) -> Light {
        Light(self.lights[code as usize])
    }

    /// The code of a light: the exact one, rounded to the nearest.
    ///
    /// A code comes back from its light unless it shares it with a higher one: from code 2 on for gamma 2.2, from
    /// 3 for 2.5, from 5 for 2.8.
    #[must_use]
    pub const fn encode(&self, light: Light) -> u8 {
        light.code_in(&self.first)
    }
}

/// The exponent as a fraction of ⅛ to 8.
const fn clamped(numerator: u8, denominator: u8) -> (u64, u64) {
    let (numerator, denominator) = (numerator as u64, denominator as u64);
    if numerator >= 8 * denominator {
        (8, 1)
    } else if 8 * numerator <= denominator {
        (1, 8)
    } else {
        (numerator, denominator)
    }
}

/// `(halves / 510)^exponent` with 48 fraction bits, for halves of 1 to 510.
const fn power(halves: u32, (numerator, denominator): (u64, u64)) -> u64 {
    let octaves = (log2(510) - log2(halves)) * numerator;
    let octaves = divide_floor(octaves.cast_signed(), denominator.cast_signed()).0.cast_unsigned();
    // 2^(−whole − part) = e^(−part · ln 2) >> whole
    let (whole, part) = (octaves >> 48, octaves & ((1 << 48) - 1));
    let power = exp_minus(multiply_60(part << 12, LN_2));
    if whole < 48 { power >> (12 + whole) } else { 0 }
}

/// A part of the whole light, of 48 fraction bits and at most 1; `rounding` is a half or almost one.
const fn part_of_white(part: u64, rounding: u64) -> u16 {
    let light = (part * 0xFFFF + rounding) >> 48;
    saturate_u16(light.cast_signed())
}

/// The logarithm to base 2 of 1 to 510 with 48 fraction bits: squaring doubles the logarithm, and each time that
/// the number leaves `[1, 2)` there is one more bit of it.
const fn log2(number: u32) -> u64 {
    let whole = (number | 1).ilog2();
    let (mut number, mut logarithm) = ((number as u64) << (60 - whole), whole as u64);
    let mut bits = 0;
    while bits < 48 {
        number = multiply_60(number, number);
        logarithm = logarithm << 1 | number >> 61;
        number = number >> (number >> 61);
        bits += 1;
    }
    logarithm
}

/// `e^−x` with 60 fraction bits for x below ln 2, by 20 terms of its series, from the last to the first.
const fn exp_minus(x: u64) -> u64 {
    let (mut sum, mut term) = (ONE, 20);
    while term > 0 {
        sum = ONE - multiply_60(x, sum) / term;
        term -= 1;
    }
    sum
}

const ONE: u64 = 1 << 60;
/// The natural logarithm of 2 with 60 fraction bits.
const LN_2: u64 = 799_144_290_325_165_979;
