//! Runs of bits in lines of bytes, a machine word at a time.

use core::iter::zip;

use super::RasterOp;
use crate::num::low_index;

/// Bytes that are merged at once.
const WORD: usize = size_of::<usize>();

/// A run of bits in a line of the target, and where it is in a line of the source.
#[derive(Clone, Copy, Debug)]
pub(super) struct Run {
    pub(super) target: usize,
    pub(super) source: usize,
    pub(super) bits: usize,
}

impl Run {
    /// The same from the left in parts, each of which lies in one word of either line.
    pub(super) fn strips(self, strides: (usize, usize)) -> impl DoubleEndedIterator<Item = Strip> {
        let aligned = (self.target | self.source).is_multiple_of(8);
        let longest = if aligned { 8 * WORD } else { 8 * WORD - 8 };
        (0..self.bits.div_ceil(longest)).map(move |part| {
            let done = part * longest;
            let bits = low_index(longest.min(self.bits - done));
            let first = self.source + done;
            let (target, start) = word_with(self.target + done, strides.0);
            let (source, from) = word_with(first, strides.1);
            let mask = (usize::MAX << (usize::BITS - bits)) >> start;
            Strip { target, source, first, start, turn: start.wrapping_sub(from) % usize::BITS, mask: mask.to_be() }
        })
    }
}

/// The first byte of a word in the line that holds a bit, and the place of the bit in it.
fn word_with(bit: usize, stride: usize) -> (usize, u32) {
    let byte = (bit / 8).min(stride.saturating_sub(WORD));
    (byte, low_index(bit - 8 * byte))
}

/// The same bits of every line, at most a word.
#[derive(Clone, Copy, Debug)]
pub(super) struct Strip {
    /// First byte of the word in the target and in the source.
    target: usize,
    source: usize,
    /// First bit in the line of the source, and in the word of the target.
    first: usize,
    start: u32,
    /// How far to the right the word of the source is turned.
    turn: u32,
    /// The bits that are meant, in the order of the bytes.
    mask: usize,
}

impl Strip {
    /// Merges line by line. Each operation has a loop of its own.
    pub(super) fn merge_lines<'l>(self, lines: impl Iterator<Item = (&'l mut [u8], &'l [u8])>, op: RasterOp) {
        match op {
            RasterOp::Copy => lines.for_each(|lines| self.merge(lines, usize::MAX, RasterOp::Copy)),
            RasterOp::Or => lines.for_each(|lines| self.merge(lines, usize::MAX, RasterOp::Or)),
            RasterOp::AndNot => lines.for_each(|lines| self.merge(lines, usize::MAX, RasterOp::AndNot)),
            RasterOp::Xor => lines.for_each(|lines| self.merge(lines, usize::MAX, RasterOp::Xor)),
        }
    }

    /// Merges what `mask` lets through.
    #[inline]
    pub(super) fn merge(&self, (target, source): (&mut [u8], &[u8]), mask: usize, op: RasterOp) {
        let new = self.word(source);
        self.change(target, |old| op.change(old, new) & mask);
    }

    /// The bits of a line of the source, where they are in the target.
    #[inline]
    pub(super) fn word(&self, source: &[u8]) -> usize {
        usize::from_be(read(source, self.source)).rotate_right(self.turn).to_be()
    }

    /// Inverts the bits of a line that `change` gives for what is there, as far as they are meant.
    #[inline]
    pub(super) fn change(&self, target: &mut [u8], change: impl FnOnce(usize) -> usize) {
        let old = read(target, self.target);
        write(target, self.target, old ^ (change(old) & self.mask));
    }

    /// The bits of a mask for pixels of `bits`.
    pub(super) fn holes(&self, bits: u32, stride: usize) -> Holes {
        let (byte, left) = word_with(self.first / bits.max(1) as usize, stride);
        Holes { byte, left, bits, start: self.start }
    }
}

/// A mask of one bit a pixel for a strip of pixels of more.
#[derive(Clone, Copy, Debug)]
pub(super) struct Holes {
    byte: usize,
    left: u32,
    bits: u32,
    start: u32,
}

impl Holes {
    /// The bits of a line of the mask, each as often as a pixel has bits.
    #[inline]
    pub(super) fn word(&self, mask: &[u8]) -> usize {
        let holes = usize::from_be(read(mask, self.byte)) << self.left;
        let holes = if self.bits == 1 { holes } else { widened(holes, self.bits) };
        (holes >> self.start).to_be()
    }
}

/// The highest bits of a word, each `times` over.
fn widened(mut bits: usize, times: u32) -> usize {
    let mut pixel = !(usize::MAX >> times);
    let mut word = 0;
    while pixel > 0 {
        if bits.leading_ones() > 0 {
            word |= pixel;
        }
        (bits, pixel) = (bits << 1, pixel >> times);
    }
    word
}

/// One word of a line; what a short line has not is 0.
#[inline]
fn read(line: &[u8], start: usize) -> usize {
    if let Some(bytes) = line.get(start..).and_then(<[u8]>::first_chunk) {
        return usize::from_ne_bytes(*bytes);
    }
    let mut word = [0; WORD];
    zip(&mut word, line).for_each(|(byte, new)| *byte = *new);
    usize::from_ne_bytes(word)
}

/// The reverse of [`read`].
#[inline]
fn write(line: &mut [u8], start: usize, word: usize) {
    match line.get_mut(start..).and_then(<[u8]>::first_chunk_mut) {
        Some(bytes) => *bytes = word.to_ne_bytes(),
        None => zip(line, word.to_ne_bytes()).for_each(|(byte, new)| *byte = new),
    }
}
