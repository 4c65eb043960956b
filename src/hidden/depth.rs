//! The z-buffer: remember how near the nearest fragment of each pixel is. Lecture 5.6.

use core::ops::Range;

use crate::{
    error::describe,
    num::{count, index},
    space::Rect,
};

/// A depth for every pixel of a window, in memory of the caller's: 0 is the farthest.
///
/// Depths are those of [`Viewport::project`](crate::geometry::viewport::Viewport::project): linear
/// in 1/w, so that they are linear along a span and near things get the finer steps.
#[derive(Debug)]
pub struct DepthBuffer<'b> {
    depths: &'b mut [u16],
    window: Rect,
}

/// Fewer depths than the window has pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooFewDepths {
    /// How many are needed.
    pub needed: usize,
}

describe! { TooFewDepths, Self { needed } => "{needed} depths are needed"; }

impl<'b> DepthBuffer<'b> {
    /// A buffer for the pixels of `window`, all at the farthest.
    ///
    /// # Errors
    /// [`TooFewDepths`] when there is not one for each pixel.
    pub fn new(depths: &'b mut [u16], window: Rect) -> Result<Self, TooFewDepths> {
        let needed = count(u64::from(window.width()) * u64::from(window.height()));
        let depths = depths.get_mut(..needed).ok_or(TooFewDepths { needed })?;
        depths.fill(0);
        Ok(Self { depths, window })
    }

    /// The pixels that have a depth.
    #[must_use]
    pub const fn window(&self) -> Rect {
        self.window
    }

    /// Puts all pixels at the farthest again.
    pub fn clear(&mut self) {
        self.depths.fill(0);
    }

    /// The depths of a run of pixels; `None` when some of them lie outside of the window.
    pub fn run(&mut self, row: i32, columns: Range<i32>) -> Option<&mut [u16]> {
        let inside = self.window.clip_run(row, columns.clone())? == columns;
        let width = usize::try_from(self.window.width()).ok()?;
        let first = index(row.wrapping_sub(self.window.top)).checked_mul(width)?;
        let from = |column: i32| first.checked_add(index(column.wrapping_sub(self.window.left)));
        self.depths.get_mut(from(columns.start)?..from(columns.end)?).filter(|_| inside)
    }
}

/// The depth test: whether a fragment is nearer than what is stored, and if so stores it.
///
/// Strict, so that of two surfaces at the same depth the one drawn first stays.
#[inline]
pub fn is_nearer(stored: &mut u16, depth: u16) -> bool {
    let nearer = depth > *stored;
    if nearer {
        *stored = depth;
    }
    nearer
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_address_the_window() {
        let mut memory = [9; 7];
        let mut buffer = DepthBuffer::new(&mut memory, Rect::new(10, 5, 13, 7)).unwrap();
        buffer.run(6, 11..13).unwrap().fill(1);
        assert_eq!(buffer.run(5, 10..13).unwrap(), [0, 0, 0]);
        assert_eq!(buffer.run(6, 10..13).unwrap(), [0, 1, 1]);
        for (row, columns) in [(4, 10..13), (7, 10..13), (5, 9..13), (5, 10..14), (5, i32::MIN..i32::MAX)] {
            assert!(buffer.run(row, columns).is_none());
        }
        assert_eq!(memory, [0, 0, 0, 0, 1, 1, 9], "the seventh is not ours");
    }

    #[test]
    fn a_buffer_too_small_says_what_it_needs() {
        assert_eq!(DepthBuffer::new(&mut [0; 5], Rect::new(0, 0, 2, 3)).unwrap_err(), TooFewDepths { needed: 6 });
        let endless = Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX);
        assert!(DepthBuffer::new(&mut [0; 5], endless).is_err());
    }

    #[test]
    fn the_first_of_two_equals_stays() {
        let mut stored = 5;
        assert!(!is_nearer(&mut stored, 5) && !is_nearer(&mut stored, 4) && is_nearer(&mut stored, 6));
        assert_eq!(stored, 6);
    }
}
