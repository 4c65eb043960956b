//! Y′CbCr: luma and two differences of colour, as JPEG and television have it. Lecture 7.1.1.
//!
//! ```text
//!   Y′ = Kr R′ + Kg G′ + Kb B′
//!   Cb = 128 + (B′ − Y′) / 2(1 − Kb)          0 … 255: full range, as in JPEG
//!   Cr = 128 + (R′ − Y′) / 2(1 − Kr)
//! ```
//!
//! The eye sees the differences less sharply, so files keep fewer of them.
//!
//! Of the 16,777,216 colours 8-bit Y′CbCr has numbers for a quarter: it cannot be lossless. Each component is
//! within 0.51 of the exact one. There and back a channel is wrong by at most 1, and a quarter of the colours and
//! all greys come back exactly.
//!
//! **Cost**: nine multiplications there, four back; no division. **Flash**: no table.
//! Source: ITU-R BT.601-7, BT.709-6; ITU-T T.871 (JFIF) for the full range.

use super::luma::{Standard, nearest_code, weighed};

/// A colour by luma and two differences.
///
/// ```
/// use aquatint::{YCbCr, tone::luma::Standard};
///
/// let red = YCbCr::from_rgb([255, 0, 0], Standard::Bt601);
/// assert_eq!(red, YCbCr { y: 76, cb: 85, cr: 255 });
/// assert_eq!(red.to_rgb(Standard::Bt601), [254, 0, 0]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct YCbCr {
    /// Luma, 0 to 255.
    pub y: u8,
    /// How much bluer than grey; 128 is grey.
    pub cb: u8,
    /// How much redder than grey; 128 is grey.
    pub cr: u8,
}

impl YCbCr {
    /// From sRGB codes. What would be 256 (pure blue and pure red are 255.5) is 255.
    #[must_use]
    pub fn from_rgb(rgb: [u8; 3], standard: Standard) -> Self {
        let (blue, red) = differences(standard);
        Self { y: standard.luma(rgb), cb: weighed(blue, rgb, 128), cr: weighed(red, rgb, 128) }
    }

    /// The sRGB codes, rounded once and clipped: most combinations are no colour.
    #[must_use]
    pub fn to_rgb(self, standard: Standard) -> [u8; 3] {
        let (y, cb, cr) = (i32::from(self.y) << 16, i32::from(self.cb) - 128, i32::from(self.cr) - 128);
        let [red, green_blue, green_red, blue] = inverse(standard);
        [y + red * cr, y + green_blue * cb + green_red * cr, y + blue * cb].map(nearest_code)
    }
}

/// Rows of Cb and Cr in parts of 65536. Each sums to 0, so greys are 128.
const fn differences(standard: Standard) -> ([i32; 3], [i32; 3]) {
    match standard {
        Standard::Bt601 => ([-11_058, -21_710, 32_768], [32_768, -27_439, -5_329]),
        Standard::Bt709 => ([-7_509, -25_259, 32_768], [32_768, -29_763, -3_005]),
    }
}

/// Cr in red, Cb and Cr in green, Cb in blue, in parts of 65536.
const fn inverse(standard: Standard) -> [i32; 4] {
    match standard {
        Standard::Bt601 => [91_881, -22_553, -46_802, 116_130],
        Standard::Bt709 => [103_206, -12_276, -30_679, 121_609],
    }
}
