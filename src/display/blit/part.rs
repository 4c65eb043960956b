//! What is drawn: a frame, or a part of one, maybe with holes.

use core::marker::PhantomData;

use embedded_graphics::{
    geometry::{OriginDimensions, Point, Size},
    pixelcolor::{BinaryColor, PixelColor},
};

use super::{op::Coded, packing::Packing};
use crate::{
    display::{
        frame::Frame,
        layout::{Layout, Memory},
    },
    space::Rect,
};

/// A picture to be drawn: a frame that is only read, or a part of one.
///
/// Made by [`Frame::part`], or from a reference to a frame.
#[derive(Debug)]
pub struct Part<'a, C, L> {
    source: Source<'a>,
    /// Of the frame, not of the part.
    size: Size,
    area: Rect,
    packing: PhantomData<(C, L)>,
}

// Whatever the colour and the layout are.
impl<C, L> Copy for Part<'_, C, L> {}
impl<C, L> Clone for Part<'_, C, L> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<C: PixelColor, L: Layout<C>, B: AsRef<[u8]>> Frame<C, L, B> {
    /// A part of this frame to be drawn: one sprite of a sheet. What is outside of the frame is cut off.
    ///
    /// ```
    /// use aquatint::{Frame, Rect, Rows, display::blit::{Blit, RasterOp}};
    /// use embedded_graphics::{pixelcolor::BinaryColor, prelude::Point};
    ///
    /// let sheet = Frame::<BinaryColor, Rows, _>::with_array([0b1010_0110], 8, 1)?;
    /// let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0], 8, 1)?;
    /// let right_half = sheet.part(Rect::new(4, 0, 8, 1));
    /// frame.blit(right_half, Point::zero(), RasterOp::Copy);
    /// assert_eq!(frame.bytes(), [0b0110_0000]);
    /// # Ok::<(), aquatint::TooSmall>(())
    /// ```
    #[must_use]
    pub fn part(&self, area: Rect) -> Part<'_, C, L> {
        Part::from(self).part(area)
    }
}

impl<'a, C: PixelColor, L: Layout<C>, B: AsRef<[u8]>> From<&'a Frame<C, L, B>> for Part<'a, C, L> {
    #[inline]
    fn from(frame: &'a Frame<C, L, B>) -> Self {
        let size = frame.size();
        let source = Source { memory: frame.memory_ref(), mask: None };
        Self { source, size, area: Rect::of_size(size), packing: PhantomData }
    }
}

impl<'a, C, L> Part<'a, C, L> {
    /// Only this area of the frame.
    #[must_use]
    #[inline]
    pub fn part(self, area: Rect) -> Self {
        Self { area: self.area.intersection(area), ..self }
    }

    /// The same with holes: only pixels that are `On` in `mask` are drawn.
    ///
    /// The mask is a one-bit frame of the same layout. It lies over the whole frame of which this is a
    /// part, and what is beyond it is cut off.
    ///
    /// ```
    /// use aquatint::{Frame, Rows, display::blit::{Blit, Part, RasterOp}};
    /// use embedded_graphics::{pixelcolor::{BinaryColor, Gray4}, prelude::Point};
    ///
    /// let picture = Frame::<Gray4, Rows, _>::with_array([0xAB, 0xC0], 3, 1)?;
    /// let mask = Frame::<BinaryColor, Rows, _>::with_array([0b1010_0000], 3, 1)?;
    /// let mut frame = Frame::<Gray4, Rows, _>::with_array([0x12, 0x34], 4, 1)?;
    /// frame.blit(Part::from(&picture).with_mask(&mask), Point::new(1, 0), RasterOp::Copy);
    /// assert_eq!(frame.bytes(), [0x1A, 0x3C]);
    /// # Ok::<(), aquatint::TooSmall>(())
    /// ```
    #[must_use]
    pub fn with_mask<B: AsRef<[u8]>>(self, mask: &'a Frame<BinaryColor, L, B>) -> Self
    where
        L: Layout<BinaryColor>,
    {
        let area = self.area.intersection(Rect::of_size(mask.size()));
        Self { source: Source { mask: Some(mask.memory_ref()), ..self.source }, area, ..self }
    }

    /// The pixels of the frame that are in it.
    #[inline]
    pub(in crate::display) const fn area(&self) -> Rect {
        self.area
    }

    #[inline]
    pub(super) const fn source(&self) -> &Source<'a> {
        &self.source
    }

    /// Those of the whole frame.
    pub(super) const fn size(&self) -> Size {
        self.size
    }
}

/// The bytes of a picture, and of its mask.
#[derive(Clone, Copy, Debug)]
pub(super) struct Source<'a> {
    pub(super) memory: Memory<&'a [u8]>,
    pub(super) mask: Option<Memory<&'a [u8]>>,
}

/// What is known of the pixels of a target and of a source while compiling.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pixels {
    /// Of a pixel of the target.
    pub(super) bits: u32,
    /// Whether the source has one bit for each pixel of more.
    pub(super) is_shape: bool,
    /// A byte of a mask where nothing is drawn: all bits are 0, or 1 in an inverted layout.
    pub(super) hole: u8,
}

impl Pixels {
    /// Of colours `C` of a target, and of colours `S` in the layout `L`.
    pub(super) const fn new<C: Coded, S: Coded, L: Packing>() -> Self {
        Self { bits: C::BITS, is_shape: C::BITS != S::BITS, hole: if L::FACTS.is_inverted { 0xFF } else { 0 } }
    }
}

/// What is seen of an area of a frame between some bounds when its corner is at `at`, and where that
/// is, if anything is.
#[inline]
pub(in crate::display) fn clip(area: Rect, at: Point, bounds: Rect) -> Option<(Rect, Point)> {
    // The area lies in a frame, so its sides are not longer than `i32` can say.
    let [width, height] = [area.right.wrapping_sub(area.left), area.bottom.wrapping_sub(area.top)];
    let is_inside = width > 0
        && height > 0
        && (bounds.left <= at.x && at.x < bounds.right && width <= bounds.right.wrapping_sub(at.x))
        && (bounds.top <= at.y && at.y < bounds.bottom && height <= bounds.bottom.wrapping_sub(at.y));
    if is_inside { Some((area, at)) } else { clip_edges(area, at, bounds) }
}

#[inline]
fn clip_edges(area: Rect, at: Point, bounds: Rect) -> Option<(Rect, Point)> {
    let [width, height] = [area.right.wrapping_sub(area.left), area.bottom.wrapping_sub(area.top)];
    let seen = Rect::new(at.x, at.y, at.x.saturating_add(width), at.y.saturating_add(height)).intersection(bounds);
    if area.is_empty() || seen.is_empty() {
        return None;
    }
    let [x, y] = [area.left.wrapping_sub(at.x), area.top.wrapping_sub(at.y)];
    let Rect { left, top, right, bottom } = seen;
    let from = Rect::new(left.wrapping_add(x), top.wrapping_add(y), right.wrapping_add(x), bottom.wrapping_add(y));
    Some((from, Point::new(left, top)))
}

/// A rectangle of pixels that is not empty: from which column and row, and to which.
#[derive(Clone, Copy, Debug)]
pub(super) struct Job {
    pub(super) from: (usize, usize),
    pub(super) to: (usize, usize),
    pub(super) width: usize,
    pub(super) height: usize,
}

impl Job {
    /// The pixels of a clipped area.
    #[inline]
    pub(super) const fn new(area: Rect, at: Point) -> Self {
        let Rect { left, top, right, bottom } = area;
        Self {
            from: (left.cast_unsigned() as usize, top.cast_unsigned() as usize),
            to: (at.x.cast_unsigned() as usize, at.y.cast_unsigned() as usize),
            width: right.wrapping_sub(left).cast_unsigned() as usize,
            height: bottom.wrapping_sub(top).cast_unsigned() as usize,
        }
    }

    /// Columns and rows exchanged.
    pub(super) const fn turned(self) -> Self {
        let (from, to) = ((self.from.1, self.from.0), (self.to.1, self.to.0));
        Self { from, to, width: self.height, height: self.width }
    }
}
