//! Runs of a region in a row of pixels, 32 pixels at a time: what a search through a picture asks for.
//!
//! - **Takes** 32 pixels side by side as the bits of a word, the leftmost in the highest bit: the
//!   *seeds*, and the pixels that are *free*, where the region may grow.
//! - **Gives** the free pixels inside of the region that are joined with a seed along the row.
//! - **Memory** none. **Cost** two reads more than a run has pixels; on frames of one bit a pixel one
//!   comparison of 32 pixels and some thirty additions and shifts, however many runs there are.
//!
//! ```text
//!   inside   ··####··##·####·      leftwards   inside + seeds: the carries walk to the left ends
//!   seeds    ···#·······#··#·      rightwards  twice as far with each of five shifts
//!   given    ··####·····####·
//! ```
//!
//! Leftwards it is the carry chain of an adder, rightwards the parallel prefix of P. M. Kogge and
//! H. S. Stone, "A parallel algorithm for the efficient solution of a general class of recurrence
//! equations", IEEE Transactions on Computers C-22(8), 1973.

use core::ops::Range;

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    framebuffer::Framebuffer,
    geometry::{Dimensions, Point},
    image::GetPixel,
    primitives::Rectangle,
};

use crate::{on_draw_target::OnDrawTarget, space::Rect, target::Target};

/// The leftmost of 32 pixels.
pub(crate) const FIRST: u32 = 1 << 31;
/// The rightmost of 32 pixels.
pub(crate) const LAST: u32 = 1;

/// Which colours are inside of a region.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Inside<C> {
    /// This one only.
    Like(C),
    /// All but this one.
    Unlike(C),
}

impl<C: Copy + PartialEq> Inside<C> {
    /// Whether a pixel of this colour is inside.
    ///
    /// ```
    /// use aquatint::Inside;
    /// assert!(Inside::Like(3).holds(3) && Inside::Unlike(3).holds(4));
    /// ```
    #[must_use]
    pub fn holds(&self, color: C) -> bool {
        match self {
            Self::Like(inside) => color == *inside,
            Self::Unlike(border) => color != *border,
        }
    }
}

/// A picture in which regions can be searched.
///
/// One empty line makes it so for everything whose pixels can be read; frames of one bit a pixel answer for
/// 32 pixels at once. For somebody else's type, where that line is not allowed, there is [`PerPixel`].
///
/// ```
/// use aquatint::{Inside, Runs};
/// use embedded_graphics::{image::GetPixel, pixelcolor::BinaryColor, prelude::*};
///
/// /// Eight pixels, two of them dark.
/// struct Fence;
///
/// impl GetPixel for Fence {
///     type Color = BinaryColor;
///     fn pixel(&self, p: Point) -> Option<BinaryColor> {
///         self.bounding_box().contains(p).then(|| BinaryColor::from(p.x != 2 && p.x != 5))
///     }
/// }
/// # impl OriginDimensions for Fence {
/// #     fn size(&self) -> Size { Size::new(8, 1) }
/// # }
///
/// impl Runs for Fence {}
///
/// // From column 3 on, pixels 3 and 4 lie between the fences.
/// let found = Fence.runs(Point::zero(), Inside::Like(BinaryColor::On), 0b0001_0000 << 24, 0xFF << 24);
/// assert_eq!(found, 0b0001_1000 << 24);
/// ```
pub trait Runs: GetPixel + Dimensions {
    /// Of the 32 pixels from `place` on to the right, those of `free` that are `inside` and joined with
    /// one of `seeds` by such pixels.
    ///
    /// The highest bit is the pixel at `place`. All that is free lies inside of the bounding box.
    fn runs(&self, place: Point, inside: Inside<Self::Color>, seeds: u32, free: u32) -> u32 {
        by_pixels(self, place, &inside, (seeds, free))
    }
}

/// [`Runs::runs`] by single reads, from the seeds to both sides until the run ends.
#[inline(never)]
pub(crate) fn by_pixels<P: GetPixel + ?Sized>(
    picture: &P,
    place: Point,
    inside: &Inside<P::Color>,
    (seeds, free): (u32, u32),
) -> u32 {
    let is_inside = |bit: u32| {
        let point = Point::new(place.x.wrapping_add_unsigned(bit), place.y);
        free & bit_of(bit) != 0 && picture.pixel(point).is_some_and(|color| inside.holds(color))
    };
    let (mut found, mut left) = (0, seeds & free);
    while left != 0 {
        let seed = left.leading_zeros();
        left &= !bit_of(seed);
        if is_inside(seed) {
            let before = (0..seed).rev().take_while(|&bit| is_inside(bit));
            let behind = (seed + 1..32).take_while(|&bit| is_inside(bit));
            found |= before.chain(behind).fold(bit_of(seed), |run, bit| run | bit_of(bit));
            left &= !found;
        }
    }
    found
}

/// One of 32 pixels, counted from the left; none beyond.
#[inline]
const fn bit_of(bit: u32) -> u32 {
    if bit < 32 { FIRST >> bit } else { 0 }
}

/// All bits of the runs of `inside` in which there is a seed. Seeds are inside.
#[inline]
pub(crate) const fn join(seeds: u32, inside: u32) -> u32 {
    // A carry comes into every bit between the lowest seed of a run and its upper end.
    let carries = inside.wrapping_add(seeds) ^ inside ^ seeds;
    let found = inside & (carries | seeds);
    // Most seeds are a whole run of the row before.
    if (found >> 1) & inside & !found == 0 { found } else { to_the_right(found, inside) }
}

/// `found`, and all bits of `inside` that are joined with it from the left.
#[inline(never)]
const fn to_the_right(mut found: u32, inside: u32) -> u32 {
    // `open`: this bit and the next 2 · shift − 1 above it are inside.
    let (mut open, mut shift) = (inside, 1);
    while shift < 32 {
        found |= open & (found >> shift);
        open &= open >> shift;
        shift *= 2;
    }
    found
}

impl<C, R, BO, const WIDTH: usize, const HEIGHT: usize, const N: usize> Runs for Framebuffer<C, R, BO, WIDTH, HEIGHT, N> where
    Self: GetPixel
{
}

/// Somebody else's display, searched pixel by pixel: whatever can be drawn on and read.
///
/// ```
/// use aquatint::{Flood, PerPixel, raster::flood::{Run, words_needed}};
/// use embedded_graphics::{image::GetPixel, prelude::*};
///
/// fn pour<D>(display: &mut D, at: Point, color: <D as GetPixel>::Color)
/// where
///     D: GetPixel + DrawTarget<Color = <D as GetPixel>::Color>,
/// {
///     let (mut memory, mut queue) = ([0; words_needed(128, 64)], [Run::default(); 16]);
///     let _ = Flood::new(&mut memory, &mut queue).fill(&mut PerPixel::new(display), at, color);
/// }
/// ```
#[derive(Debug)]
pub struct PerPixel<'d, D>(&'d mut D);

impl<'d, D> PerPixel<'d, D> {
    /// Lends a display.
    pub const fn new(display: &'d mut D) -> Self {
        Self(display)
    }
}

impl<D: GetPixel> GetPixel for PerPixel<'_, D> {
    type Color = D::Color;

    fn pixel(&self, point: Point) -> Option<D::Color> {
        self.0.pixel(point)
    }
}

impl<D: Dimensions> Dimensions for PerPixel<'_, D> {
    fn bounding_box(&self) -> Rectangle {
        self.0.bounding_box()
    }
}

impl<D: GetPixel + Dimensions> Runs for PerPixel<'_, D> {}

impl<D: DrawTarget> DrawTarget for PerPixel<'_, D> {
    type Color = D::Color;
    type Error = D::Error;

    fn draw_iter<I: IntoIterator<Item = Pixel<D::Color>>>(&mut self, pixels: I) -> Result<(), D::Error> {
        self.0.draw_iter(pixels)
    }

    fn fill_contiguous<I: IntoIterator<Item = D::Color>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), D::Error> {
        self.0.fill_contiguous(area, colors)
    }

    fn fill_solid(&mut self, area: &Rectangle, color: D::Color) -> Result<(), D::Error> {
        self.0.fill_solid(area, color)
    }

    fn clear(&mut self, color: D::Color) -> Result<(), D::Error> {
        self.0.clear(color)
    }
}

impl<D: DrawTarget> Target for PerPixel<'_, D> {
    type Color = D::Color;
    type Error = D::Error;

    fn bounds(&self) -> Rect {
        self.0.bounding_box().into()
    }

    fn fill_run<const N: usize>(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: [D::Color; N],
    ) -> Result<(), D::Error> {
        OnDrawTarget::new(self.0).fill_run(row, columns, colors)
    }

    fn write_run(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: impl Iterator<Item = Option<D::Color>>,
    ) -> Result<(), D::Error> {
        OnDrawTarget::new(self.0).write_run(row, columns, colors)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Grows by a bit to both sides until nothing changes.
    fn slow(seeds: u32, inside: u32) -> u32 {
        let mut found = seeds;
        loop {
            let grown = (found | (found << 1) | (found >> 1)) & inside;
            if grown == found {
                return found;
            }
            found = grown;
        }
    }

    #[test]
    fn runs_with_a_seed_are_given_and_no_others() {
        // All seeds in all runs of eight bits, at both ends of the word.
        for inside in 0..=0xFF_u32 {
            for seeds in 0..=0xFF_u32 {
                for shift in [0, 13, 24] {
                    let (inside, seeds) = (inside << shift, (seeds & inside) << shift);
                    assert_eq!(join(seeds, inside), slow(seeds, inside), "{seeds:b} in {inside:b}");
                }
            }
        }
        let mut random = 1_u64;
        let mut next = || {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            crate::num::low_u32((random >> 32).cast_signed())
        };
        for _ in 0..20_000 {
            let (dense, seeds) = (next() | next() | next(), next() & next());
            assert_eq!(join(seeds & dense, dense), slow(seeds & dense, dense), "{seeds:b} in {dense:b}");
        }
        assert_eq!((join(LAST, u32::MAX), join(FIRST, u32::MAX), join(0, u32::MAX)), (u32::MAX, u32::MAX, 0));
    }
}
