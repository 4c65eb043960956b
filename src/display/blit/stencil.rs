//! One bit for each pixel of more: masks and shapes on grey frames.

use super::strip::{Strip, read};
use crate::num::low_index;

/// A line of one bit a pixel, for a strip of pixels of 1, 2, 4 or 8.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stencil<const MSB: bool> {
    /// First byte of the word that has the bits, and the place of the first of them in it.
    byte: usize,
    left: u32,
    bits: u32,
    /// First bit in the word of the target.
    start: u32,
}

impl<const MSB: bool> Stencil<MSB> {
    pub(super) fn new(strip: &Strip<MSB>, bits: u32) -> Self {
        let pixel = (8 * strip.source + strip.from as usize) / bits.max(1) as usize;
        Self { byte: pixel / 8, left: low_index(pixel % 8), bits, start: strip.start }
    }

    /// The bits of a line that begins with a byte, each as often as a pixel has bits, where the pixels
    /// are in the target.
    #[inline]
    pub(super) fn word(&self, bytes: &[u8], line: usize) -> usize {
        let word = read(bytes, line + self.byte);
        let leftmost_high = if MSB { usize::from_be(word) } else { usize::from_le(word).reverse_bits() };
        let wide = match self.bits {
            1 => leftmost_high << self.left,
            2 => widened::<2>(leftmost_high << self.left),
            4 => widened::<4>(leftmost_high << self.left),
            _ => widened::<8>(leftmost_high << self.left),
        };
        let placed = wide.rotate_right(self.start);
        if MSB { placed.to_be() } else { placed.reverse_bits().to_le() }
    }
}

/// The highest bits of a word, each `TIMES` over.
///
/// Halves are moved apart, then quarters, and so on: H. S. Warren, *Hacker's Delight*, 2nd edition,
/// section 7-2.
#[inline]
fn widened<const TIMES: u32>(word: usize) -> usize {
    let mut bits = word >> (usize::BITS - usize::BITS / TIMES);
    let mut half = usize::BITS / TIMES / 2;
    while half > 0 {
        let one_of_each = usize::MAX / ((1 << (half * TIMES)) - 1);
        bits = (bits | bits << (half * (TIMES - 1))) & (one_of_each * ((1 << half) - 1));
        half /= 2;
    }
    (bits << (TIMES - 1) << 1).wrapping_sub(bits)
}
