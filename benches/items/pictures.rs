//! The pictures that are drawn, made while compiling.

use embedded_graphics::geometry::Size;

/// Of the bits.
pub const BITS_SIZE: Size = Size::new(64, 64);

/// Rows of pixels of one bit, about half of them on, without a pattern that some code could like.
pub fn bits() -> &'static [u8] {
    core::hint::black_box(&BITS)
}

/// Width of the photograph.
pub const PHOTO_WIDTH: usize = 128;

/// 128 × 64 sRGB codes: slopes, edges and grain, as in a photograph.
pub fn photo() -> &'static [u8] {
    core::hint::black_box(&PHOTO)
}

static BITS: [u8; 512] = {
    let mut bytes = [0; 512];
    let mut at: u16 = 0;
    while at < 512 {
        bytes[at as usize] = noise(at);
        at += 1;
    }
    bytes
};

static PHOTO: [u8; 8192] = {
    let mut codes = [0; 8192];
    let mut at: u16 = 0;
    while at < 8192 {
        codes[at as usize] = grey(at % 128, at / 128).saturating_add(noise(at) / 32);
        at += 1;
    }
    codes
};

/// A bright ball before a sky that darkens upwards.
const fn grey(x: u16, y: u16) -> u8 {
    let (dx, dy) = (x.abs_diff(76), y.abs_diff(34));
    let squared = dx * dx + dy * dy;
    let [grey, _] = if squared < 625 { 240 - squared / 4 } else { y + x / 2 + 20 }.to_le_bytes();
    grey
}

/// The high byte of a product with an odd constant near 2¹⁶ divided by the golden ratio, twice.
const fn noise(seed: u16) -> u8 {
    let once = seed.wrapping_mul(40_503) ^ (seed >> 3);
    let [_, high] = once.wrapping_mul(40_503).to_le_bytes();
    high
}
