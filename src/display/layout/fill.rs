//! Runs of bits in lines of bytes: what every layout fills with.

use core::ops::Range;

use super::{Memory, Order};
use crate::num::low_index;

/// Replaces the bits of `byte` that `mask` selects.
#[inline]
pub(super) const fn merge(byte: &mut u8, mask: u8, value: u8) {
    *byte ^= (*byte ^ value) & mask;
}

/// The one of eight that a column has.
#[inline]
pub(super) fn phase(eight: [u8; 8], index: usize) -> u8 {
    eight.get(index & 7).copied().unwrap_or_default()
}

/// A run of bits that is filled in one line or in several: which bytes of a line it touches, and how.
#[derive(Clone, Copy, Debug)]
pub(super) struct BitRun {
    first: usize,
    last: usize,
    /// The bits of the first and of the last byte that are in the run.
    head: u8,
    tail: u8,
}

impl BitRun {
    /// The bits from `bits.start` up to, not including, `bits.end` of a line, counted in order `O` from its
    /// first byte.
    #[inline]
    pub(super) fn new<O: Order>(bits: Range<usize>) -> Self {
        let (first, last) = (bits.start / 8, bits.end.wrapping_sub(1) / 8);
        let (before, after) = (low_index(bits.start) % 8, low_index(0_usize.wrapping_sub(bits.end)) % 8);
        let (head, tail) =
            if O::MSB_FIRST { (0xFF_u8 >> before, 0xFF_u8 << after) } else { (0xFF_u8 << before, 0xFF_u8 >> after) };
        Self { first, last, head, tail }
    }

    /// Writes the bytes that the run touches in one line.
    #[inline]
    pub(super) fn write(&self, memory: Memory<&mut [u8]>, line: usize, mut next: impl FnMut() -> u8) {
        match memory.run(line, self.first..=self.last) {
            Some([only]) => merge(only, self.head & self.tail, next()),
            Some([first, middle @ .., last]) => {
                merge(first, self.head, next());
                middle.fill_with(&mut next);
                merge(last, self.tail, next());
            }
            _ => {}
        }
    }

    /// Fills the run in some lines with one byte over and over.
    #[inline]
    pub(super) fn fill_solid(&self, memory: Memory<&mut [u8]>, lines: Range<usize>, value: u8) {
        let Some((bytes, stride)) = memory.from(lines.start, self.first) else { return };
        let lines = lines.end.wrapping_sub(lines.start);
        if self.first == self.last {
            fill_column((bytes, stride), lines, (self.head & self.tail, value));
        } else {
            bytes.chunks_mut(stride).take(lines).for_each(|line| {
                if let Some(bytes) = line.get_mut(..=self.last.wrapping_sub(self.first)) {
                    self.fill_bytes(bytes, value);
                }
            });
        }
    }

    /// The same in one line.
    #[inline]
    pub(super) fn fill_one(&self, memory: Memory<&mut [u8]>, line: usize, value: u8) {
        if let Some(bytes) = memory.run(line, self.first..=self.last) {
            self.fill_bytes(bytes, value);
        }
    }

    /// The bytes of the run in one line.
    #[inline]
    fn fill_bytes(&self, bytes: &mut [u8], value: u8) {
        match bytes {
            [only] => merge(only, self.head & self.tail, value),
            [first, middle @ .., last] => {
                merge(first, self.head, value);
                merge(last, self.tail, value);
                fill_bytes(middle, value);
            }
            [] => {}
        }
    }

    /// Fills the run in some lines with eight bytes that repeat over each; the big end of `pattern` is for
    /// bytes 0, 8, 16 … of a line.
    #[inline]
    pub(super) fn fill(&self, memory: Memory<&mut [u8]>, lines: Range<usize>, pattern: u64) {
        let Some((bytes, stride)) = memory.from(lines.start, self.first) else { return };
        let lines = lines.end.wrapping_sub(lines.start);
        let from = |byte: usize| pattern.rotate_left(8 * (low_index(byte) & 7)).to_be_bytes();
        let ([head, ..], second) = (from(self.first), from(self.first.wrapping_add(1)));
        // The eight bytes before the last one have the phases of those from it on.
        let before_last @ [tail, ..] = from(self.last);
        let width = self.last.wrapping_sub(self.first).wrapping_add(1);
        for line in bytes.chunks_mut(stride).take(lines) {
            match line.get_mut(..width) {
                Some([only]) => merge(only, self.head & self.tail, head),
                Some([first, middle @ .., last]) => {
                    merge(first, self.head, head);
                    merge(last, self.tail, tail);
                    fill_pattern(middle, second, before_last);
                }
                _ => return,
            }
        }
    }
}

/// Gives some bits of the first byte of each line those of `value`.
#[inline]
fn fill_column((bytes, stride): (&mut [u8], usize), lines: usize, (mask, value): (u8, u8)) {
    match value {
        0 => each_line((bytes, stride), lines, |byte| *byte &= !mask),
        0xFF => each_line((bytes, stride), lines, |byte| *byte |= mask),
        _ => each_line((bytes, stride), lines, |byte| merge(byte, mask, value)),
    }
}

#[inline]
fn each_line((bytes, stride): (&mut [u8], usize), lines: usize, change: impl Fn(&mut u8)) {
    let mut at = 0_usize;
    for _ in 0..lines {
        if let Some(byte) = bytes.get_mut(at) {
            change(byte);
        }
        at = at.wrapping_add(stride);
    }
}

/// Bytes that are written at once.
const WORD: usize = size_of::<usize>();

/// Fills whole bytes with one value.
#[inline]
fn fill_bytes(bytes: &mut [u8], value: u8) {
    // The last word first: it holds what is left over behind whole ones.
    let Some(last) = bytes.last_chunk_mut() else {
        fill_few(bytes, value);
        return;
    };
    *last = [value; WORD];
    // The call of a block fill pays from some words on.
    if bytes.len() >= 32 {
        bytes.fill(value);
        return;
    }
    for word in bytes.chunks_exact_mut(WORD) {
        word.copy_from_slice(&[value; WORD]);
    }
}

/// Fills less than a word, with no call of a block fill: two halves that may overlap, or single bytes.
#[inline]
fn fill_few(bytes: &mut [u8], value: u8) {
    if let Some(first) = bytes.first_chunk_mut() {
        *first = [value; WORD / 2];
        if let Some(last) = bytes.last_chunk_mut() {
            *last = [value; WORD / 2];
        }
        return;
    }
    match bytes {
        [] => {}
        [one] => *one = value,
        [one, .., last] => {
            (*one, *last) = (value, value);
            if let [_, middle, _] = bytes {
                *middle = value;
            }
        }
    }
}

/// Fills whole bytes with eight that repeat; `last` are those of the last eight bytes.
#[inline]
fn fill_pattern(bytes: &mut [u8], eight: [u8; 8], last: [u8; 8]) {
    // The last word first: it holds what is left over behind whole ones.
    let Some(word) = bytes.last_chunk_mut() else {
        bytes.iter_mut().zip(eight).for_each(|(byte, value)| *byte = value);
        return;
    };
    *word = last;
    for word in bytes.chunks_exact_mut(8) {
        word.copy_from_slice(&eight);
    }
}

/// All eight bits of a byte as the lowest bit of a code.
#[inline]
pub(super) const fn spread(code: u8) -> u8 {
    if code & 1 == 0 { 0 } else { 0xFF }
}
