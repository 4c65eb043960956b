//! One row: its pixels walked over in either direction, and gathered to words of codes, each of which is a run.

use core::{cell::Cell, marker::PhantomData};

use embedded_graphics::geometry::Point;

use super::{
    Kernel,
    nearest::Nearest,
    window::{MARGIN, Slot, Slots, Window, fold},
};
use crate::{
    colour::Light,
    num::{count_i32, index, low_index, low_u8, low_u32},
    target::{Code, Target},
};

/// The errors of the row that is walked, and of the one below. They are one for a kernel of one row.
#[derive(Clone, Copy, Debug)]
pub(super) struct Errors<'m> {
    pub(super) here: &'m [Cell<i16>],
    pub(super) below: &'m [Cell<i16>],
}

impl<'m> Errors<'m> {
    /// The slots from one on, this many.
    fn part(self, start: usize, length: usize) -> Self {
        let part = |row: &'m [Cell<i16>]| row.get(start..).and_then(|row| row.get(..length)).unwrap_or_default();
        Self { here: part(self.here), below: part(self.below) }
    }

    /// All slots from the left.
    fn slots(self) -> impl DoubleEndedIterator<Item = Slot<'m>> {
        self.here.iter().zip(self.below).map(|(here, below)| Slot { here, below })
    }
}

/// A column's slots and those of its neighbours.
type Near<'m> = (&'m [Cell<i16>], &'m [Cell<i16>]);

/// The slots of a pixel: the rightmost is its own.
#[inline]
fn rightwards((here, below): Near<'_>) -> Option<Slots<'_>> {
    let ([done, .., own], [below, ..]) = (here, below) else { return None };
    Some(Slots { own, done: Slot { here: done, below } })
}

/// The slots of a pixel: the leftmost is its own.
#[inline]
fn leftwards((here, below): Near<'_>) -> Option<Slots<'_>> {
    let ([own, .., done], [.., below]) = (here, below) else { return None };
    Some(Slots { own, done: Slot { here: done, below } })
}

/// Takes codes of so many bits in words, which are full from the highest bit on.
pub(super) trait Words {
    const BITS: u32;
    type Error;

    /// Writes the first pixels of a word from a column of the picture on.
    fn write(&mut self, start: usize, word: u64, length: u32) -> Result<(), Self::Error>;
}

/// Words that become runs of colours.
#[derive(Debug)]
pub(super) struct RunsOn<'t, T> {
    pub(super) target: &'t mut T,
    pub(super) at: Point,
}

impl<T: Target> Words for RunsOn<'_, T>
where
    T::Color: Code,
{
    const BITS: u32 = T::Color::BITS;
    type Error = T::Error;

    fn write(&mut self, start: usize, word: u64, length: u32) -> Result<(), T::Error> {
        let left = self.at.x.saturating_add(count_i32(start));
        let right = left.saturating_add_unsigned(length);
        let colors = (0..length).map(|pixel| {
            let code = word << (pixel * Self::BITS) >> (64 - Self::BITS);
            Some(T::Color::from_code(low_u8(low_u32(code.cast_signed()))))
        });
        self.target.write_run(self.at.y, left..right, colors)
    }
}

/// A row on its way.
#[derive(Debug)]
pub(super) struct Row<W, K> {
    pub(super) words: W,
    pub(super) width: usize,
    pub(super) leftwards: bool,
    pub(super) kernel: PhantomData<K>,
}

impl<W: Words, K: Kernel> Row<W, K> {
    /// Walks over the whole row, and leaves the errors ready for the next.
    pub(super) fn draw(
        &mut self,
        errors: Errors<'_>,
        levels: impl Nearest,
        lights: impl DoubleEndedIterator<Item = Light> + ExactSizeIterator,
    ) -> Result<(), W::Error> {
        let errors = errors.part(0, self.width + 2 * MARGIN);
        let (reach, right) = (K::WEIGHTS.reach(), self.width + MARGIN);
        let ahead = if self.leftwards {
            let part = errors.part(MARGIN, self.width + reach);
            let window = if K::WEIGHTS.reaches_two_rows() {
                let slots = part.here.windows(1 + reach).zip(part.below.windows(1 + reach)).map(leftwards);
                self.walk::<true>(levels, lights.rev().zip(slots.rev()))?
            } else {
                let slots = part.here.windows(1 + reach).map(|row| leftwards((row, row)));
                self.walk::<true>(levels, lights.rev().zip(slots.rev()))?
            };
            (window.finish::<K>(errors.part(MARGIN - reach, 2 * reach).slots().rev()), 0)
        } else {
            let part = errors.part(MARGIN - reach, self.width + reach);
            let window = if K::WEIGHTS.reaches_two_rows() {
                let slots = part.here.windows(1 + reach).zip(part.below.windows(1 + reach)).map(rightwards);
                self.walk::<false>(levels, lights.zip(slots))?
            } else {
                let slots = part.here.windows(1 + reach).map(|row| rightwards((row, row)));
                self.walk::<false>(levels, lights.zip(slots))?
            };
            (0, window.finish::<K>(errors.part(right - reach, 2 * reach).slots()))
        };
        fold(errors.below, ahead);
        if K::WEIGHTS.reaches_two_rows() {
            fold(errors.here, (0, 0));
        }
        Ok(())
    }

    /// Walks over pixels in their order, and writes their codes.
    #[inline]
    fn walk<'m, const LEFTWARDS: bool>(
        &mut self,
        mut levels: impl Nearest,
        mut pixels: impl Iterator<Item = (Light, Option<Slots<'m>>)>,
    ) -> Result<Window, W::Error> {
        let (mut window, most) = (Window::default(), index(64 / W::BITS.cast_signed()));
        let words = self.width.div_ceil(most);
        for done in 0..words {
            let start = if LEFTWARDS { words - 1 - done } else { done } * most;
            let (length, mut word) = (most.min(self.width - start), 0);
            for (light, slots) in pixels.by_ref().take(length) {
                let Some(slots) = slots else { break };
                let code = u64::from(window.step::<K>(&mut levels, light, slots));
                word = if LEFTWARDS { word >> W::BITS | code << (64 - W::BITS) } else { word << W::BITS | code };
            }
            let length = low_index(length);
            let word = if LEFTWARDS { word } else { word << ((64 - W::BITS * length) & 63) };
            self.words.write(start, word, length)?;
        }
        Ok(window)
    }
}
