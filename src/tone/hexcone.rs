//! The hue of a colour, and colours of a hue: what HLS and HSV have in common.
//!
//! Looked at along its grey axis the RGB cube is a hexagon. The hue runs around it in six sectors of 256 steps;
//! in each sector one channel is highest, one lowest, and the third rises or falls between the two.
//!
//! ```text
//!        512 green ___ yellow 256
//!                 /   \
//!      768 cyan  <     >  red 0
//!                 \___/
//!       1024 blue      magenta 1280
//! ```
//!
//! 256 steps are enough for 255 differences between the lowest and the highest: no colour is lost.
//! Source: Smith, *Color Gamut Transform Pairs*, SIGGRAPH 1978.

use crate::num::{low_u8, low_u16};

/// Hues around the hexagon.
pub(super) const TURN: u16 = 6 << 8;

/// The lowest and the highest of three channels.
pub(super) fn extent([red, green, blue]: [u8; 3]) -> (u8, u8) {
    (red.min(green).min(blue), red.max(green).max(blue))
}

/// `dividend / divisor` to the nearest, halves up; 0 for a divisor of 0. Both below 2¹⁶.
pub(super) fn quotient(dividend: u32, divisor: u32) -> u32 {
    if divisor == 0 { 0 } else { (2 * dividend + divisor) / (2 * divisor) }
}

/// `dividend / 255` rounded down for dividends below 65535, without a division.
pub(super) fn divided_by_255(dividend: u32) -> u32 {
    (dividend * 257 + 257) >> 16
}

/// The hue of a colour, 0 to 1535; 0 for greys. One division.
pub(super) fn hue([red, green, blue]: [u8; 3]) -> u16 {
    let (low, high) = extent([red, green, blue]);
    // The corner of the hexagon of the highest channel, and how the other two differ.
    let (corner, ahead, behind) = match high {
        _ if red == high => (0, green, blue),
        _ if green == high => (2, blue, red),
        _ => (4, red, green),
    };
    let steps = quotient(u32::from(ahead.abs_diff(behind)) << 8, u32::from(high - low)).cast_signed();
    let hue = (corner << 8) + if ahead < behind { -steps } else { steps };
    low_u16(if hue < 0 { hue + i32::from(TURN) } else { hue })
}

/// The colour of a hue (modulo 1536) between a lowest and a highest channel. No division.
pub(super) fn colour(hue: u16, low: u8, high: u8) -> [u8; 3] {
    let hue = if hue < TURN { hue } else { hue % TURN };
    let (sector, step) = (hue >> 8, u32::from(hue & 0xFF));
    let way = low_u8((u32::from(high.saturating_sub(low)) * step + 0x80) >> 8);
    let (rising, falling) = (low.saturating_add(way), high.saturating_sub(way));
    match sector {
        0 => [high, rising, low],
        1 => [falling, high, low],
        2 => [low, high, rising],
        3 => [low, falling, high],
        4 => [rising, low, high],
        _ => [high, low, falling],
    }
}
