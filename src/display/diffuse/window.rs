//! One row of an error diffusion: a window of sums that slides over two rows of errors.
//!
//! ```text
//!   slots    0 1 │ 2 3 4 …  W+1 │ W+2 W+3     two in front and two behind the picture's columns
//!                  ▲   ▲
//!               done   here                   the error of a pixel is taken out two slots before
//! ```
//!
//! An error is kept in the row that it comes from: where a pixel's own has been taken, its slot is free
//! for what the pixel below will get. So one row is enough where a kernel reaches one row down, and two
//! for two. What was handed beyond the sides is folded onto the outermost pixels when the row is done.

use core::cell::Cell;

use super::{Kernel, nearest::Nearest};
use crate::{
    colour::Light,
    num::{low_u16, saturate_i16},
};

/// Slots before and behind the columns of a picture.
pub(super) const MARGIN: usize = 2;

/// The largest error, half of the greatest step: 65535 / 2, rounded down.
const MOST: i32 = 0x7FFF;

/// What the pixels near the one at work have got so far.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Window {
    ahead: [i32; 2],
    below: [[i32; 5]; 2],
}

/// A column's place in the errors of the row that is walked, and in those of the row below.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slot<'m> {
    pub(super) here: &'m Cell<i16>,
    pub(super) below: &'m Cell<i16>,
}

/// The places that are used together with a pixel's.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slots<'m> {
    /// The pixel's own error.
    pub(super) own: &'m Cell<i16>,
    /// The hindmost column of the window, to which nothing will be added any more.
    pub(super) done: Slot<'m>,
}

impl Window {
    /// Gives the code of the next pixel.
    #[inline]
    pub(super) fn step<K: Kernel>(&mut self, levels: &mut impl Nearest, light: Light, slots: Slots<'_>) -> u32 {
        let [ahead, _] = self.ahead;
        let value = levels.displayable(light) + i32::from(slots.own.get()) + ahead;
        let (code, shown) = levels.nearest(value);
        // At the sides a pixel may get more than one whole error. Elsewhere nothing is cut off.
        self.spread::<K>((value - shown).clamp(-MOST, MOST));
        self.put::<K>(slots.done);
        code
    }

    /// Hands on the error of a pixel.
    #[inline]
    fn spread<K: Kernel>(&mut self, error: i32) {
        let ([_, next], [near, far], weights) = (self.ahead, self.below, &K::WEIGHTS);
        let mut rest = error;
        self.ahead = add::<K, 2>([next, 0], weights.ahead, error, &mut rest);
        let far = add::<K, 5>(far, weights.far(), error, &mut rest);
        let mut near = add::<K, 5>(near, weights.near(), error, &mut rest);
        if weights.conserve() {
            // Straight down goes what is left, roundings and all: no light is lost.
            let [_, _, down, ..] = &mut near;
            *down += rest;
        }
        self.below = [near, far];
    }

    /// Puts away the sums of the hindmost column and slides on.
    #[inline]
    fn put<K: Kernel>(&mut self, done: Slot<'_>) {
        let [[outer, a, b, c, d], [far, e, f, g, h]] = self.below;
        self.below = [[a, b, c, d, 0], [e, f, g, h, 0]];
        let near = if K::WEIGHTS.reach() == 1 { a } else { outer };
        if K::WEIGHTS.reaches_two_rows() {
            done.below.set(low_i16(near + i32::from(done.below.get())));
            done.here.set(low_i16(far));
        } else {
            done.below.set(low_i16(near));
        }
    }

    /// Puts away what is left at the end of a row. Gives what was to go ahead of its last pixel.
    pub(super) fn finish<'m, K: Kernel>(mut self, slots: impl Iterator<Item = Slot<'m>>) -> i32 {
        for done in slots.take(2 * K::WEIGHTS.reach()) {
            self.put::<K>(done);
        }
        let [next, second] = self.ahead;
        next + second
    }
}

/// Adds to each sum its share of an error, and takes it from the rest.
#[inline]
fn add<K: Kernel, const N: usize>(mut sums: [i32; N], weights: [u8; N], error: i32, rest: &mut i32) -> [i32; N] {
    for (sum, weight) in sums.iter_mut().zip(weights) {
        let share = K::WEIGHTS.share(error, weight);
        *sum += share;
        *rest -= share;
    }
    sums
}

/// Adds what lies in the margins, and what was to go ahead of the first or the last column, to these columns.
///
/// Nothing is lost, unless more than half of all light meets in one pixel.
pub(super) fn fold(row: &[Cell<i16>], (ahead_of_first, ahead_of_last): (i32, i32)) {
    let ([a, b, first, ..], [.., last, c, d]) = (row, row) else { return };
    for (edge, ahead, outside) in [(first, ahead_of_first, [a, b]), (last, ahead_of_last, [c, d])] {
        let folded: i32 = outside.into_iter().map(|slot| i32::from(slot.replace(0))).sum();
        edge.set(saturate_i16((i32::from(edge.get()) + folded + ahead).into()));
    }
}

/// The low 16 bits. A sum of shares has no more: of the twelve that meet in a pixel all but those of its own
/// row come to 36/48 of the largest error at most, and 13 roundings.
#[inline]
const fn low_i16(value: i32) -> i16 {
    low_u16(value).cast_signed()
}
