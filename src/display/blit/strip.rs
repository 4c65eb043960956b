//! Strips: the same bits of every line, those of at most a word.

use super::part::Job;
use crate::num::{low_index, low_u8};

/// Bytes that are merged at once.
pub(super) const WORD: usize = size_of::<usize>();

/// A run of bits in a line of the target, and where it is in a line of the source.
#[derive(Clone, Copy, Debug)]
pub(super) struct Run {
    target: usize,
    source: usize,
    bits: usize,
}

impl Run {
    /// The columns of a job, of so many bits each.
    #[inline]
    pub(super) const fn new(job: &Job, bits: u32) -> Self {
        let bits = bits as usize;
        Self { target: job.to.0 * bits, source: job.from.0 * bits, bits: job.width * bits }
    }

    /// The same in parts that each lie in one word of the source.
    #[inline]
    pub(super) const fn strips<const MSB: bool>(self) -> Strips<MSB> {
        Strips(self)
    }

    /// The whole run, where it falls on one word.
    #[inline]
    pub(super) const fn only_strip<const MSB: bool>(self) -> Option<Strip<MSB>> {
        if 0 < self.bits && self.bits <= 8 * WORD - 7 {
            let strip = self.strip(self.bits);
            Some(Strip { over: 0, ..strip })
        } else {
            None
        }
    }

    /// The first bits, which lie in one word.
    #[inline]
    const fn strip<const MSB: bool>(self, bits: usize) -> Strip<MSB> {
        let (start, from, bits) = (low_index(self.target % 8), low_index(self.source % 8), low_index(bits));
        let over = (start + bits).saturating_sub(usize::BITS);
        Strip {
            target: self.target / 8,
            source: self.source / 8,
            start,
            from,
            mask: mask::<MSB>(start, bits),
            over: over_mask::<MSB>(over),
        }
    }
}

/// From the left or from the right.
#[derive(Clone, Debug)]
pub(super) struct Strips<const MSB: bool>(Run);

impl<const MSB: bool> Iterator for Strips<MSB> {
    type Item = Strip<MSB>;

    #[inline]
    fn next(&mut self) -> Option<Strip<MSB>> {
        let run = self.0;
        let bits = run.bits.min(8 * WORD - run.source % 8);
        self.0 = Run { target: run.target + bits, source: run.source + bits, bits: run.bits - bits };
        (bits > 0).then(|| run.strip(bits))
    }
}

impl<const MSB: bool> DoubleEndedIterator for Strips<MSB> {
    fn next_back(&mut self) -> Option<Strip<MSB>> {
        let run = self.0;
        let hidden = run.source % 8;
        let last = run.bits.checked_sub(1)?;
        let done = ((hidden + last) / (8 * WORD) * (8 * WORD)).saturating_sub(hidden);
        self.0.bits = done;
        Some(Run { target: run.target + done, source: run.source + done, ..run }.strip(run.bits - done))
    }
}

/// So many bits of a word, at least one, from one on, in the order of the bytes.
#[inline]
const fn mask<const MSB: bool>(start: u32, bits: u32) -> usize {
    let left = usize::BITS.wrapping_sub(bits) % usize::BITS;
    if MSB { (usize::MAX << left >> start).to_be() } else { (usize::MAX >> left << start).to_le() }
}

/// The first bits of a byte, fewer than eight.
#[inline]
const fn over_mask<const MSB: bool>(bits: u32) -> u8 {
    if MSB { !(0xFF >> bits) } else { !(0xFF << bits) }
}

/// The same bits of every line: a word of the source falls on a word of the target and on the byte
/// behind it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Strip<const MSB: bool> {
    /// First byte of the word in a line of the target, and of the source.
    pub(super) target: usize,
    pub(super) source: usize,
    /// First bit in either word.
    pub(super) start: u32,
    pub(super) from: u32,
    /// The bits that are meant, in the order of the bytes.
    mask: usize,
    /// Those of the byte behind the word.
    over: u8,
}

impl<const MSB: bool> Strip<MSB> {
    /// The bits of a word of the source, where they are in the target.
    #[inline]
    pub(super) fn word(&self, source: &[u8], at: usize) -> usize {
        self.place(read(source, at))
    }

    /// A word of the source, turned.
    #[inline]
    pub(super) const fn place(&self, word: usize) -> usize {
        if MSB {
            usize::from_be(word).rotate_right(self.start.wrapping_sub(self.from)).to_be()
        } else {
            usize::from_le(word).rotate_left(self.start.wrapping_sub(self.from)).to_le()
        }
    }

    /// Merges a placed word into one of the target and the byte behind it, as far as it is `shown`.
    #[inline]
    pub(super) fn merge(
        &self,
        target: &mut [u8],
        at: usize,
        (new, shown): (usize, usize),
        merged: impl Fn(usize, usize, usize) -> usize,
    ) {
        if let Some((word, behind)) = target.get_mut(at..).and_then(<[u8]>::split_first_chunk_mut) {
            self.merge_word((word, behind.first_mut()), (new, shown), merged);
        } else {
            change(target, at, |old| merged(old, new, self.mask & shown));
        }
    }

    /// The same, where they are. What the end of the placed word was is its first byte now.
    #[inline]
    pub(super) fn merge_word(
        &self,
        (word, behind): (&mut [u8; WORD], Option<&mut u8>),
        (new, shown): (usize, usize),
        merged: impl Fn(usize, usize, usize) -> usize,
    ) {
        *word = merged(usize::from_ne_bytes(*word), new, self.mask & shown).to_ne_bytes();
        if let (Some(byte), true) = (behind, self.over != 0) {
            let [new, shown] = [new, shown].map(|word| usize::from(first_byte(word)));
            *byte = low_u8(low_index(merged(usize::from(*byte), new, usize::from(self.over) & shown)));
        }
    }
}

#[inline]
const fn first_byte(word: usize) -> u8 {
    let [first, ..] = word.to_ne_bytes();
    first
}

/// A word of bytes alike.
#[inline]
pub(super) const fn repeated(byte: u8) -> usize {
    usize::from_ne_bytes([byte; WORD])
}

/// One word; what is behind the end is 0.
#[inline]
pub(super) fn read(bytes: &[u8], at: usize) -> usize {
    let bytes = bytes.get(at..).unwrap_or_default();
    bytes.first_chunk().map_or_else(|| read_last(bytes), |word| usize::from_ne_bytes(*word))
}

/// Fewer bytes than a word.
#[inline(never)]
fn read_last(bytes: &[u8]) -> usize {
    let mut word = [0; WORD];
    word.iter_mut().zip(bytes).for_each(|(byte, new)| *byte = *new);
    usize::from_ne_bytes(word)
}

/// Changes one word, as far as it is there.
#[inline]
pub(super) fn change(bytes: &mut [u8], at: usize, new: impl Fn(usize) -> usize) {
    let Some(bytes) = bytes.get_mut(at..) else { return };
    match bytes.first_chunk_mut() {
        Some(word) => *word = new(usize::from_ne_bytes(*word)).to_ne_bytes(),
        None => write_last(bytes, new(read_last(bytes))),
    }
}

#[inline(never)]
fn write_last(bytes: &mut [u8], word: usize) {
    bytes.iter_mut().zip(word.to_ne_bytes()).for_each(|(byte, new)| *byte = new);
}
