//! The pattern of dashes and gaps, and places in it.

use crate::{
    num::{SUBPIXELS, Subpixel},
    outline::FINE,
    raster::stroke::direction::LENGTH_FRACTION,
};

/// Lengths, in the unit of lengths: 2⁻¹⁶ sixteenths of a pixel.
pub(super) const fn unit(sixteenths: i32) -> i64 {
    (sixteenths as i64) << LENGTH_FRACTION
}

/// Lengths that repeat.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pattern<'a> {
    lengths: &'a [Subpixel],
    /// What repeats, dashes and gaps together.
    period: i64,
    /// Less than the period.
    offset: i64,
    /// How many times as long as they say the lengths are.
    times: i32,
}

/// A place in the pattern.
#[derive(Clone, Copy, Debug)]
pub(super) struct Phase {
    index: usize,
    pub(super) is_dash: bool,
    /// To the end of this dash or gap.
    pub(super) left: i64,
}

impl<'a> Pattern<'a> {
    pub(super) fn new(lengths: &'a [Subpixel], offset: Subpixel) -> Self {
        let sum = lengths.iter().map(|length| unit(length.to_bits().max(0))).fold(0, i64::saturating_add);
        let period = if lengths.len().is_multiple_of(2) { sum } else { sum.saturating_mul(2) };
        Self { lengths, period, offset: unit(offset.to_bits()).checked_rem_euclid(period).unwrap_or(0), times: 1 }
    }

    /// The same sixteen times as long.
    pub(super) fn enlarged(self) -> Self {
        let [period, offset] = [self.period, self.offset].map(|length| length.saturating_mul(FINE.into()));
        Self { period, offset, times: FINE, ..self }
    }

    /// Shorter than a pixel: its gaps could not be seen.
    pub(super) fn is_too_fine(&self) -> bool {
        self.period < unit(SUBPIXELS)
    }

    /// Where a contour begins.
    pub(super) fn start(&self) -> Phase {
        self.at(self.offset)
    }

    /// How often it fits into a length.
    pub(super) fn repeats(&self, length: i64) -> i64 {
        length.checked_div(self.period).unwrap_or(0)
    }

    fn length(&self, index: usize) -> i64 {
        self.lengths.get(index).map_or(0, |length| unit(length.to_bits().max(0)) * i64::from(self.times))
    }

    /// The place some distance behind the beginning, less than the period.
    fn at(&self, mut distance: i64) -> Phase {
        let mut phase = Phase { index: 0, is_dash: true, left: self.length(0) };
        // A dot belongs to where it is; else a length ends before its end.
        for _ in 0..self.lengths.len().saturating_mul(2) {
            if distance < phase.left || distance == 0 && phase.left == 0 {
                break;
            }
            distance -= phase.left;
            phase = self.next(phase);
        }
        Phase { left: phase.left.saturating_sub(distance), ..phase }
    }

    /// The next dash or gap.
    pub(super) fn next(&self, phase: Phase) -> Phase {
        let index = phase.index.wrapping_add(1);
        let index = if index < self.lengths.len() { index } else { 0 };
        Phase { index, is_dash: !phase.is_dash, left: self.length(index) }
    }

    /// How far back the present dash or gap began.
    pub(super) fn behind(&self, phase: Phase) -> i64 {
        self.length(phase.index).saturating_sub(phase.left)
    }

    /// The place that is some distance farther on.
    pub(super) fn skip(&self, phase: Phase, distance: i64) -> Phase {
        if distance < phase.left {
            return Phase { left: phase.left - distance, ..phase };
        }
        // Where in the period the present dash or gap ends.
        let rest = distance - phase.left;
        let next = self.next(phase);
        let is_second = next.is_dash != next.index.is_multiple_of(2);
        let behind = (0..next.index).map(|index| self.length(index)).fold(0, i64::saturating_add);
        let behind = if is_second { behind.saturating_add(self.period / 2) } else { behind };
        let period = self.period.max(1);
        self.at((rest % period).saturating_add(behind) % period)
    }
}
