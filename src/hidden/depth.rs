//! The z-buffer: remember how near the nearest fragment of each pixel is. Lecture 5.6.
//!
//! ```text
//!   span  ────────────────▶   depth test   ──▶ ████    ██████  the parts that are seen, spans again
//!   depth  ╱╱╱╱╱╱╱╱╱╱╱╱╱╱
//! ```
//!
//! Depths are linear in 1/w, so that they are linear along a span and near things get the finer steps.

use core::ops::Range;

pub use super::depth_test::{DepthFunction, DepthTest, Nearer, Unstored};

use crate::{
    error::describe,
    hidden::Hidden,
    num::{FRACTION_16_15, bits, count, from_16_15, low_index, low_u8},
    space::Rect,
    vary::Ramp,
};

/// What a depth is kept in: 8, 16 or 32 bits.
pub trait Depth: Copy {
    /// Behind everything.
    const FARTHEST: Self;

    /// Of a depth as it is carried over a triangle, in 31 bits.
    fn from_fine(fine: u32) -> Self;
}

/// 255 depths: enough for solids that stand apart.
impl Depth for u8 {
    const FARTHEST: Self = 0;

    #[inline]
    fn from_fine(fine: u32) -> Self {
        // 1 to 255, so that the far plane is not behind everything.
        low_u8((fine - (fine >> 8)) >> (FRACTION_16_15 + 8)).saturating_add(1)
    }
}

/// 65,536 depths, the default: at a distance of `d` times the near plane, surfaces are told apart that are `d²`/65,536
/// of the near distance from each other.
impl Depth for u16 {
    const FARTHEST: Self = 0;

    #[inline]
    fn from_fine(fine: u32) -> Self {
        from_16_15(fine)
    }
}

/// All that is computed: 24 bits at the corners, and what lies between.
impl Depth for u32 {
    const FARTHEST: Self = 0;

    #[inline]
    fn from_fine(fine: u32) -> Self {
        fine
    }
}

/// A depth for every pixel of a window, in memory of the caller's; the window is a frame or a band of it.
///
/// ```
/// use aquatint::{Rect, hidden::depth::{DepthBuffer, DepthTest}};
///
/// // Eight bits a pixel, the usual test.
/// let mut bytes = [0_u8; 64 * 8];
/// let buffer = DepthBuffer::new(&mut bytes, Rect::new(0, 0, 64, 8))?;
/// // Only what is already there, and nothing new is remembered.
/// let again = buffer.with_test(DepthTest::Equal).without_writing();
/// # let _ = again;
/// # Ok::<(), aquatint::hidden::depth::TooFewDepths>(())
/// ```
#[derive(Debug)]
pub struct DepthBuffer<'b, D = u16, F = Nearer> {
    depths: &'b mut [D],
    window: Rect,
    width: usize,
    function: F,
}

/// Fewer depths than the window has pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TooFewDepths {
    /// How many are needed.
    pub needed: usize,
}

describe! { TooFewDepths, Self { needed } => "{needed} depths are needed"; }

impl<'b, D: Depth> DepthBuffer<'b, D> {
    /// A buffer for the pixels of `window`, all at the farthest.
    ///
    /// # Errors
    /// [`TooFewDepths`] when there is not one for each pixel.
    pub fn new(depths: &'b mut [D], window: Rect) -> Result<Self, TooFewDepths> {
        let needed = count(u64::from(window.width()) * u64::from(window.height()));
        let depths = depths.get_mut(..needed).ok_or(TooFewDepths { needed })?;
        let mut buffer = Self { depths, window, width: count(window.width().into()), function: Nearer };
        buffer.clear();
        Ok(buffer)
    }
}

impl<'b, D: Depth, F> DepthBuffer<'b, D, F> {
    /// The same with another test.
    #[must_use]
    pub fn with_test<G: DepthFunction>(self, function: G) -> DepthBuffer<'b, D, G> {
        DepthBuffer { depths: self.depths, window: self.window, width: self.width, function }
    }

    /// The same, but what passes is not remembered: for what is translucent, and for second passes.
    #[must_use]
    pub fn without_writing(self) -> DepthBuffer<'b, D, Unstored<F>> {
        let Self { depths, window, width, function } = self;
        DepthBuffer { depths, window, width, function: Unstored(function) }
    }

    /// The pixels that have a depth.
    #[must_use]
    pub const fn window(&self) -> Rect {
        self.window
    }

    /// Puts all pixels at the farthest again.
    pub fn clear(&mut self) {
        // In blocks: of long ones, the desk's block fill makes a string instruction that counts for each byte.
        for block in self.depths.chunks_mut(256) {
            block.fill(D::FARTHEST);
        }
    }

    /// The depths of a run of pixels; `None` when some of them lie outside of the window.
    #[inline]
    pub fn run(&mut self, row: i32, columns: Range<i32>) -> Option<&mut [D]> {
        let Rect { left, top, right, bottom } = self.window;
        if row < top || row >= bottom || columns.start < left || columns.end > right {
            return None;
        }
        self.run_inside(row, columns)
    }

    /// The same for a run inside of the window; of others some depths, or none.
    #[inline]
    fn run_inside(&mut self, row: i32, columns: Range<i32>) -> Option<&mut [D]> {
        let (start, length) = (self.place(row, columns.start), distance(columns.start, columns.end));
        self.depths.get_mut(start..start.wrapping_add(length))
    }

    /// Where the depth of a pixel of the window is.
    #[inline]
    fn place(&self, row: i32, column: i32) -> usize {
        let line = distance(self.window.top, row).wrapping_mul(self.width);
        line.wrapping_add(distance(self.window.left, column))
    }
}

impl<D: Depth + Ord, F: DepthFunction> Hidden for DepthBuffer<'_, D, F> {
    const USES_DEPTH: bool = true;

    fn bounds(&self) -> Rect {
        self.window
    }

    #[inline]
    fn sees(&mut self, row: i32, column: i32, mut depth: Ramp<1>) -> bool {
        let [fine] = depth.next_fine();
        let (depth, function) = (D::from_fine(fine), self.function);
        let place = self.place(row, column);
        let Some(stored) = self.depths.get_mut(place) else { return false };
        let passes = function.passes(*stored, depth);
        if passes && F::STORES {
            *stored = depth;
        }
        passes
    }

    #[inline]
    fn split<E>(
        &mut self,
        row: i32,
        columns: Range<i32>,
        mut depth: Ramp<1>,
        mut seen: impl FnMut(Range<i32>) -> Result<(), E>,
    ) -> Result<(), E> {
        let function = self.function;
        let Some(mut left) = self.run_inside(row, columns.clone()) else { return Ok(()) };
        let mut start = columns.start;
        while !left.is_empty() {
            let passed = pass(left, &mut depth, function);
            let end = start.wrapping_add(low_index(passed).cast_signed());
            if passed > 0 {
                seen(start..end)?;
            }
            left = left.get_mut(passed..).unwrap_or_default();
            let hidden = hide(left, &mut depth, function);
            left = left.get_mut(hidden..).unwrap_or_default();
            start = end.wrapping_add(low_index(hidden).cast_signed());
        }
        Ok(())
    }

    #[inline]
    fn filter<C>(
        &mut self,
        row: i32,
        columns: Range<i32>,
        mut depth: Ramp<1>,
        colors: impl Iterator<Item = Option<C>>,
    ) -> impl Iterator<Item = Option<C>> {
        let function = self.function;
        let stored = self.run_inside(row, columns).unwrap_or_default();
        stored.iter_mut().zip(colors).map(move |(stored, color)| {
            let [fine] = depth.next_fine();
            let (depth, color) = (D::from_fine(fine), color?);
            if !function.passes(*stored, depth) {
                return None;
            }
            if F::STORES {
                *stored = depth;
            }
            Some(color)
        })
    }
}

/// From a place to one that is not before it; else beyond all memory.
#[inline]
const fn distance(from: i32, to: i32) -> usize {
    count(bits(to.wrapping_sub(from)) as u64)
}

/// Tests and stores the depths of the first pixels that pass. Gives their number.
#[inline]
fn pass<D: Depth + Ord, F: DepthFunction>(stored: &mut [D], depth: &mut Ramp<1>, function: F) -> usize {
    let (mut passed, mut next) = (0, depth.clone());
    for stored in stored {
        let [fine] = next.next_fine();
        let nearer = D::from_fine(fine);
        if !function.passes(*stored, nearer) {
            break;
        }
        if F::STORES {
            *stored = nearer;
        }
        *depth = next.clone();
        passed += 1;
    }
    passed
}

/// Tests the depths of the first pixels that do not pass. Gives their number.
#[inline]
fn hide<D: Depth + Ord, F: DepthFunction>(stored: &[D], depth: &mut Ramp<1>, function: F) -> usize {
    let (mut hidden, mut next) = (0, depth.clone());
    for &stored in stored {
        let [fine] = next.next_fine();
        if function.passes(stored, D::from_fine(fine)) {
            break;
        }
        *depth = next.clone();
        hidden += 1;
    }
    hidden
}

#[cfg(test)]
mod tests {
    use super::*;
    use heapless::Vec;

    #[test]
    fn runs_address_the_window() {
        let mut memory = [9; 7];
        let mut buffer = DepthBuffer::<u16>::new(&mut memory, Rect::new(10, 5, 13, 7)).unwrap();
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
        assert_eq!(
            DepthBuffer::<u16>::new(&mut [0; 5], Rect::new(0, 0, 2, 3)).unwrap_err(),
            TooFewDepths { needed: 6 }
        );
        let endless = Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX);
        assert!(DepthBuffer::<u8>::new(&mut [0; 5], endless).is_err());
    }

    /// A row of six depths.
    fn stored<F: DepthFunction>(memory: &mut [u16; 6], function: F) -> DepthBuffer<'_, u16, F> {
        let mut buffer = DepthBuffer::new(memory, Rect::new(0, 0, 6, 1)).unwrap().with_test(function);
        buffer.run(0, 0..6).unwrap().copy_from_slice(&[4, 5, 6, 6, 4, 4]);
        buffer
    }

    /// The parts of a row of stored depths that are seen at a constant depth of 5, and what is stored then.
    fn seen<F: DepthFunction>(function: F) -> (Vec<(i32, i32), 6>, [u16; 6]) {
        let mut memory = [0; 6];
        let mut buffer = stored(&mut memory, function);
        let mut parts = Vec::new();
        let level = Ramp::new([5 << FRACTION_16_15], [0]);
        let take = |part: Range<i32>| {
            parts.push((part.start, part.end)).unwrap();
            Ok::<(), ()>(())
        };
        buffer.split(0, 0..6, level.clone(), take).unwrap();
        let by_parts = memory;
        memory = [0; 6];
        let mut buffer = stored(&mut memory, function);
        let passed: Vec<_, 6> = buffer.filter(0, 0..6, level, (0..6).map(Some)).flatten().collect();
        assert_eq!(passed, parts.iter().flat_map(|&(start, end)| start..end).collect::<Vec<_, 6>>(), "both ways agree");
        assert_eq!(memory, by_parts);
        (parts, memory)
    }

    #[test]
    fn every_test_lets_pass_what_it_says() {
        assert_eq!(seen(Nearer), (Vec::from_iter([(0, 1), (4, 6)]), [5, 5, 6, 6, 5, 5]));
        assert_eq!(seen(DepthTest::Nearer), seen(Nearer));
        assert_eq!(seen(DepthTest::Never), (Vec::from_iter([]), [4, 5, 6, 6, 4, 4]));
        assert_eq!(seen(DepthTest::NotFarther), (Vec::from_iter([(0, 2), (4, 6)]), [5, 5, 6, 6, 5, 5]));
        assert_eq!(seen(DepthTest::Equal), (Vec::from_iter([(1, 2)]), [4, 5, 6, 6, 4, 4]));
        assert_eq!(seen(DepthTest::NotEqual), (Vec::from_iter([(0, 1), (2, 6)]), [5; 6]));
        assert_eq!(seen(DepthTest::Farther), (Vec::from_iter([(2, 4)]), [4, 5, 5, 5, 4, 4]));
        assert_eq!(seen(DepthTest::NotNearer), (Vec::from_iter([(1, 4)]), [4, 5, 5, 5, 4, 4]));
        assert_eq!(seen(DepthTest::Always), (Vec::from_iter([(0, 6)]), [5; 6]));
    }

    #[test]
    fn depths_are_the_upper_bits() {
        let fine = (0x1234 << FRACTION_16_15) + 77;
        assert_eq!((u8::from_fine(fine), u16::from_fine(fine), u32::from_fine(fine)), (0x13, 0x1234, fine));
        assert_eq!([0, (1 << 31) - 1].map(u8::from_fine), [1, 255]);
    }
}
