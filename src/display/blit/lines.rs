//! Lines onto lines of the same order: strips of bits, a machine word at a time.

use core::mem::take;

use super::{
    op::{Op, RasterOp},
    part::{Job, Pixels, Source},
    stencil::Stencil,
    strip::{Run, Strip, WORD, repeated},
};
use crate::display::layout::Memory;

/// Merges rectangles of a picture whose lines lie like those of the target.
#[inline]
pub(super) fn merge<const MSB: bool>(
    target: Memory<&mut [u8]>,
    (source, pixels): (&Source, Pixels),
    jobs: impl Iterator<Item = Job>,
    op: Op<u8>,
) {
    if pixels.is_shape || source.mask.is_some() {
        return jobs.for_each(|job| merge_some::<MSB>(&mut *target.bytes, target.stride, (source, pixels), (&job, op)));
    }
    // Each of the usual operations has a loop of its own.
    let mut lines = Lines::<MSB> { target, source: source.memory, bits: pixels.bits };
    match op.plain() {
        Some(RasterOp::Copy) => lines.merge_all(jobs, |old, new, mask| old ^ ((old ^ new) & mask)),
        Some(RasterOp::Or) => lines.merge_all(jobs, |old, new, mask| old | (new & mask)),
        Some(RasterOp::AndNot) => lines.merge_all(jobs, |old, new, mask| old & !(new & mask)),
        Some(RasterOp::Xor) => lines.merge_all(jobs, |old, new, mask| old ^ (new & mask)),
        None => {
            let op = op.map(repeated);
            lines.merge_all(jobs, |old, new, mask| op.merged(old, new, mask));
        }
    }
}

/// The same where a mask says which pixels, or where the source has one bit for each pixel of more.
#[inline(never)]
fn merge_some<const MSB: bool>(
    target: &mut [u8],
    target_stride: usize,
    (source, Pixels { bits, is_shape, hole }): (&Source, Pixels),
    (job, op): (&Job, Op<u8>),
) {
    let op = op.map(repeated);
    let Source { memory: Memory { bytes, stride }, mask } = *source;
    let (hole, merged) = (repeated(hole), |old, new, mask| op.merged(old, new, mask));
    for strip in Run::new(job, bits).strips::<MSB>() {
        let stencil = Stencil::new(&strip, bits);
        for row in 0..job.height {
            let from = job.from.1 + row;
            let new = if is_shape {
                stencil.word(bytes, from * stride)
            } else {
                strip.word(bytes, from * stride + strip.source)
            };
            let shown = mask.map_or(usize::MAX, |mask| stencil.word(mask.bytes, from * mask.stride) ^ hole);
            strip.merge(target, (job.to.1 + row) * target_stride + strip.target, (new, shown), merged);
        }
    }
}

/// Lines of two pictures that are merged.
struct Lines<'l, const MSB: bool> {
    target: Memory<&'l mut [u8]>,
    source: Memory<&'l [u8]>,
    bits: u32,
}

impl<const MSB: bool> Lines<'_, MSB> {
    /// With what becomes of a word of the target by one of the source, under a mask.
    #[inline]
    fn merge_all(&mut self, jobs: impl Iterator<Item = Job>, merged: impl Fn(usize, usize, usize) -> usize) {
        jobs.for_each(|job| {
            let run = Run::new(&job, self.bits);
            match run.only_strip() {
                Some(strip) => self.merge_strip(&strip, &job, &merged),
                None => run.strips().for_each(|strip| self.merge_wide(&strip, &job, &merged)),
            }
        });
    }

    #[inline(never)]
    fn merge_wide(&mut self, strip: &Strip<MSB>, job: &Job, merged: impl Fn(usize, usize, usize) -> usize) {
        self.merge_strip(strip, job, merged);
    }

    #[inline]
    fn merge_strip(&mut self, strip: &Strip<MSB>, job: &Job, merged: impl Fn(usize, usize, usize) -> usize) {
        let strides = (self.target.stride, self.source.stride);
        let start = job.to.1 * strides.0 + strip.target;
        let Some(mut target) = self.target.bytes.get_mut(start..) else { return };
        let Some(mut source) = self.source.bytes.get(job.from.1 * strides.1 + strip.source..) else { return };
        // Where a word and the byte behind it lie within a line, they take no tests of their own. What
        // begins within the last line of the memory is shorter than a line.
        let height = job.height;
        let is_cut = target.len() < height * strides.0 || source.len() < height * strides.1;
        let is_short = strides.0 <= WORD || strides.1 < WORD;
        let whole = if is_short { 0 } else { height - usize::from(is_cut) };
        for _ in 0..whole {
            let Some((from, rest)) = source.split_at_checked(strides.1) else { return };
            let Some((line, below)) = take(&mut target).split_at_mut_checked(strides.0) else { return };
            let (Some((word, behind)), Some(from)) = (line.split_first_chunk_mut(), from.first_chunk()) else { return };
            let new = strip.place(usize::from_ne_bytes(*from));
            strip.merge_word((word, behind.first_mut()), (new, usize::MAX), &merged);
            (target, source) = (below, rest);
        }
        if whole < height {
            merge_last(strip, (target, source), strides, (height - whole, merged));
        }
    }
}

/// The same for short lines, and near the end of the memory.
#[inline(never)]
fn merge_last<const MSB: bool>(
    strip: &Strip<MSB>,
    (target, source): (&mut [u8], &[u8]),
    strides: (usize, usize),
    (height, merged): (usize, impl Fn(usize, usize, usize) -> usize),
) {
    for row in 0..height {
        let new = strip.word(source, row * strides.1);
        strip.merge(target, row * strides.0, (new, usize::MAX), &merged);
    }
}
