//! Convex solids, and whatever is drawn from the back to the front: nothing to decide. Lecture 5.5.
//!
//! The front faces of one convex solid hide nothing of each other: when the back faces are gone, what is left is seen. So
//! there is no depth, no memory, and no test.

use core::ops::Range;

use crate::{hidden::Hidden, space::Rect, vary::Ramp};

/// Lets every front face be seen, later ones over earlier ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Convex;

impl Hidden for Convex {
    const USES_DEPTH: bool = false;

    fn bounds(&self) -> Rect {
        Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX)
    }

    #[inline]
    fn sees(&mut self, _row: i32, _column: i32, _depth: Ramp<1>) -> bool {
        true
    }

    #[inline]
    fn split<E>(
        &mut self,
        _row: i32,
        columns: Range<i32>,
        _depth: Ramp<1>,
        mut seen: impl FnMut(Range<i32>) -> Result<(), E>,
    ) -> Result<(), E> {
        seen(columns)
    }

    #[inline]
    fn filter<C>(
        &mut self,
        _row: i32,
        _columns: Range<i32>,
        _depth: Ramp<1>,
        colors: impl Iterator<Item = Option<C>>,
    ) -> impl Iterator<Item = Option<C>> {
        colors
    }
}
