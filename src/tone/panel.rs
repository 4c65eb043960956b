//! The range of a panel: its black is not dark, and its white is not bright.
//!
//! ```text
//!   light     0 ├────────────────────┤ 65535
//!               ╲                    ╱
//!   panel    0 ├──┼────────────┼────┤ 65535       black + t (white − black)
//!               black        white
//! ```
//!
//! Electronic paper reflects some 0.5 % where it is black and 45 to 57 % where it is white. Where colours are
//! matched with those of such a panel, the picture has to be moved into its range first; else all that is darker
//! or brighter has nowhere to go, and an error diffusion drifts. On one bit the range makes no difference: the
//! share of white pixels stays `t`.
//!
//! **Cost**: a multiplication of 64 bits each way, one division at construction. **Memory**: 16 bytes.

use crate::{colour::Light, error::describe, num::saturate_u16};

/// The lights of a panel's black and white.
///
/// ```
/// use aquatint::{Light, PanelRange};
///
/// const PAPER: PanelRange = match PanelRange::new(Light(413), Light(37_355)) {
///     Ok(range) => range,
///     Err(_) => PanelRange::FULL,
/// };
/// assert_eq!([Light::BLACK, Light::WHITE].map(|light| PAPER.to_panel(light)), [Light(413), Light(37_355)]);
/// assert_eq!(PAPER.from_panel(Light(37_355)), Light::WHITE);
/// assert_eq!(PAPER.from_panel(Light(60_000)), Light::WHITE); // brighter than the panel
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PanelRange {
    black: u16,
    range: u16,
    /// `65535 / range` with 32 fraction bits, to the nearest.
    reciprocal: u64,
}

/// White is not brighter than black.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NotBrighter;

describe! { NotBrighter, Self => "the white of the panel is not brighter than its black"; }

impl PanelRange {
    /// All of the light: nothing changes.
    pub const FULL: Self = Self { black: 0, range: u16::MAX, reciprocal: 1 << 32 };

    /// The range from a panel's black to its white, both measured against the same.
    ///
    /// # Errors
    /// [`NotBrighter`].
    pub const fn new(black: Light, white: Light) -> Result<Self, NotBrighter> {
        if white.0 <= black.0 {
            return Err(NotBrighter);
        }
        let range = white.0 - black.0;
        let reciprocal = ((0xFFFF << 32) + range as u64 / 2) / range as u64;
        Ok(Self { black: black.0, range, reciprocal })
    }

    /// What the panel shows in place of a light, to the nearest. Black becomes its black, white its white.
    #[must_use]
    pub const fn to_panel(self, light: Light) -> Light {
        // Divided by 65535 and rounded: exact for all products of two lights.
        let part = (light.0 as u64 * self.range as u64 * 0x1_0001 + 0x8000_8000) >> 32;
        Light(saturate_u16(self.black as i64 + part.cast_signed()))
    }

    /// The light for which the panel shows this, to the nearest; clipped where it shows no such.
    ///
    /// What [`to_panel`](Self::to_panel) makes of it is the same light of the panel again.
    #[must_use]
    pub const fn from_panel(self, shown: Light) -> Light {
        let above = shown.0.saturating_sub(self.black) as u64;
        Light(saturate_u16(((above * self.reciprocal + (1 << 31)) >> 32).cast_signed()))
    }
}
