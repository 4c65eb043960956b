//! Light in real numbers, by the formula of sRGB.

use aquatint::{BlendMode, Light};

/// All modes.
pub const MODES: [BlendMode; 6] =
    [BlendMode::Over, BlendMode::Add, BlendMode::Multiply, BlendMode::Screen, BlendMode::Darken, BlendMode::Lighten];

/// The light of a code of 0 to 1.
pub fn of_srgb(code: f64) -> f64 {
    if code <= 0.040_45 { code / 12.92 } else { ((code + 0.055) / 1.055).powf(2.4) }
}

pub fn of_light(light: Light) -> f64 {
    f64::from(light.0) / 65_535.0
}

/// A mode.
pub fn mixed(mode: BlendMode, drawn: f64, under: f64, coverage: f64) -> f64 {
    let combined = match mode {
        BlendMode::Over => drawn,
        BlendMode::Add => return (under + drawn * coverage).min(1.0),
        BlendMode::Multiply => drawn * under,
        BlendMode::Screen => 1.0 - (1.0 - drawn) * (1.0 - under),
        BlendMode::Darken => drawn.min(under),
        BlendMode::Lighten => drawn.max(under),
    };
    under + (combined - under) * coverage
}
