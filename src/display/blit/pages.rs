//! Pages onto pages: words of eight rows, each joined from two of the source.

use core::ops::Range;

use super::{
    op::{Op, RasterOp},
    part::{Job, Pixels, Source},
    strip::{WORD, change, read, repeated},
};
use crate::{display::layout::Memory, num::low_index};

/// Where pages of the source lie relative to those of the target.
///
/// ```text
///   source        target
///   ┌──────┐
///   │ upper│      ┌──────┐
///   ├──────┤  ──▶ │ page │  the last rows of one page and the first rows of the next
///   │ lower│      └──────┘
///   └──────┘
/// ```
#[derive(Clone, Debug)]
pub(super) struct Pages {
    /// Those of the target.
    pub(super) range: Range<usize>,
    /// What is added to the number of a page of the target for the number of the lower one; it may wrap.
    lower: usize,
    /// How far the upper and the lower one are turned, and which bits are of the former.
    turns: (u32, u32),
    of_upper: usize,
    /// The bits of the first and of the last page that are meant.
    head: usize,
    tail: usize,
}

impl Pages {
    #[inline]
    pub(super) const fn new(job: &Job, msb_first: bool) -> Self {
        let (top, bottom) = (job.to.1, job.to.1 + job.height);
        // The row that falls on the upper edge of the first page, and eight, since it may be above the source.
        let from = job.from.1 + 8 - top % 8;
        let above = low_index(from % 8);
        let (before, behind) = (low_index(top % 8), low_index(bottom.wrapping_neg() % 8));
        let (turns, bits) = if msb_first {
            ((0_u32.wrapping_sub(above), 8 - above), [0xFF_u8 << above, 0xFF >> before, 0xFF << behind])
        } else {
            ((above, above.wrapping_sub(8)), [0xFF_u8 >> above, 0xFF << before, 0xFF >> behind])
        };
        let [of_upper, head, tail] = [repeated(bits[0]), repeated(bits[1]), repeated(bits[2])];
        let lower = (from / 8).wrapping_sub(top / 8);
        Self { range: top / 8..bottom.div_ceil(8), lower, turns, of_upper, head, tail }
    }

    /// The first byte of the page whose first rows fall on the last ones of a page of the target. It may be
    /// one that is not there, for rows that are not meant.
    #[inline]
    const fn lower(&self, page: usize, stride: usize) -> usize {
        page.wrapping_add(self.lower).wrapping_mul(stride)
    }

    /// A word of the target, from those of the two pages.
    #[inline]
    const fn join(&self, upper: usize, lower: usize) -> usize {
        let (upper, lower) = (upper.rotate_right(self.turns.0), lower.rotate_right(self.turns.1));
        lower ^ ((lower ^ upper) & self.of_upper)
    }

    /// What falls on a page of the target.
    #[inline]
    pub(super) fn word(&self, bytes: &[u8], stride: usize, (page, column): (usize, usize)) -> usize {
        let lower = self.lower(page, stride).wrapping_add(column);
        self.join(read(bytes, lower.wrapping_sub(stride)), read(bytes, lower))
    }

    /// The bits of a page that are meant.
    #[inline]
    pub(super) const fn inside(&self, page: usize) -> usize {
        let head = if page == self.range.start { self.head } else { usize::MAX };
        if page + 1 == self.range.end { head & self.tail } else { head }
    }
}

/// Columns whose bytes of a page are merged at once.
#[derive(Clone, Copy, Debug)]
pub(super) struct Columns {
    /// The first of them in the target and in the source.
    pub(super) to: usize,
    pub(super) from: usize,
    /// Those that are meant.
    pub(super) mask: usize,
}

impl Columns {
    /// Those of a rectangle, from the left or from the right.
    #[inline]
    pub(super) fn of(job: &Job) -> impl DoubleEndedIterator<Item = Self> {
        let Job { from: (from, _), to: (to, _), width, .. } = *job;
        (0..width.div_ceil(WORD)).map(move |word| {
            let done = word * WORD;
            let behind = WORD.saturating_sub(width - done);
            Self { to: to + done, from: from + done, mask: (usize::MAX >> (8 * behind)).to_le() }
        })
    }
}

/// Merges rectangles of a picture in pages of the same order.
#[inline]
pub(super) fn merge(
    target: Memory<&mut [u8]>,
    (source, pixels): (&Source, Pixels),
    (jobs, msb_first): (impl Iterator<Item = Job>, bool),
    op: Op<u8>,
) {
    let Memory { bytes, stride } = target;
    match op.plain() {
        // Text, most often.
        Some(RasterOp::Or) if source.mask.is_none() => jobs.for_each(|job| {
            merge_pages((&mut *bytes, stride), source.memory, (&job, msb_first), |old, new, mask| old | (new & mask));
        }),
        _ => {
            let op = op.map(repeated);
            jobs.for_each(|job| merge_some((&mut *bytes, stride), source, (&job, msb_first), (op, pixels.hole)));
        }
    }
}

/// Merges a rectangle.
#[inline]
fn merge_pages(
    (bytes, stride): (&mut [u8], usize),
    source: Memory<&[u8]>,
    (job, msb_first): (&Job, bool),
    merged: impl Fn(usize, usize, usize) -> usize,
) {
    let pages = Pages::new(job, msb_first);
    for columns in Columns::of(job) {
        merge_columns((&mut *bytes, stride), source, (&pages, columns), &merged);
    }
}

/// Merges what is one below the other.
#[inline(never)]
fn merge_columns(
    (bytes, stride): (&mut [u8], usize),
    source: Memory<&[u8]>,
    (pages, columns): (&Pages, Columns),
    merged: impl Fn(usize, usize, usize) -> usize,
) {
    let mut from = pages.lower(pages.range.start, source.stride).wrapping_add(columns.from);
    let mut to = pages.range.start * stride + columns.to;
    let mut upper = read(source.bytes, from.wrapping_sub(source.stride));
    for page in pages.range.clone() {
        let lower = read(source.bytes, from);
        let (new, mask) = (pages.join(upper, lower), pages.inside(page) & columns.mask);
        change(bytes, to, |old| merged(old, new, mask));
        (upper, from, to) = (lower, from.wrapping_add(source.stride), to + stride);
    }
}

/// The same by any operation, and where a mask says which pixels.
#[inline(never)]
fn merge_some(
    (bytes, stride): (&mut [u8], usize),
    source: &Source,
    (job, msb_first): (&Job, bool),
    (op, hole): (Op<usize>, u8),
) {
    let merged = |old, new, mask| op.merged(old, new, mask);
    let Some(mask) = source.mask else {
        return merge_pages((bytes, stride), source.memory, (job, msb_first), merged);
    };
    let pages = Pages::new(job, msb_first);
    for columns in Columns::of(job) {
        for page in pages.range.clone() {
            let word = |memory: Memory<&[u8]>| pages.word(memory.bytes, memory.stride, (page, columns.from));
            let shown = (word(mask) ^ repeated(hole)) & pages.inside(page) & columns.mask;
            let new = word(source.memory);
            change(bytes, page * stride + columns.to, |old| merged(old, new, shown));
        }
    }
}
