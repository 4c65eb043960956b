//! Frames: a picture in memory of the caller's, in the byte order of the panel.

use core::{convert::Infallible, marker::PhantomData, ops::Range};

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, OriginDimensions, Point, Size},
    image::GetPixel,
    pixelcolor::PixelColor,
    primitives::Rectangle,
};

use crate::{
    display::layout::{Layout, Line, Memory},
    error::describe,
    num::{bits, count, index},
    phase::{eight, repeated},
    space::Rect,
    target::{Target, write_area},
};

/// A picture of colour `C` (which gives the bits a pixel) packed in layout `L` into the bytes `B`.
///
/// It is a `DrawTarget` for everything of embedded-graphics, and a [`Target`] for this crate.
/// [`bytes`](Self::bytes) are what the panel's controller takes, ready to send.
///
/// ```
/// use aquatint::{Frame, Pages};
/// use embedded_graphics::{
///     pixelcolor::BinaryColor,
///     prelude::*,
///     primitives::{PrimitiveStyle, Rectangle},
/// };
///
/// let mut frame = Frame::<BinaryColor, Pages, _>::with_array([0; 1024], 128, 64).unwrap();
/// let area = Rectangle::new(Point::new(2, 6), Size::new(2, 4));
/// area.into_styled(PrimitiveStyle::with_fill(BinaryColor::On)).draw(&mut frame)?;
/// assert_eq!(frame.bytes()[2], 0b1100_0000); // column 2 of page 0: rows 6 and 7
/// assert_eq!(frame.bytes()[130], 0b0000_0011); // and of page 1: rows 8 and 9
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Frame<C, L, B> {
    bytes: B,
    width: u32,
    height: u32,
    spacing: Spacing,
    /// The byte behind the last line.
    end: usize,
    packing: PhantomData<(C, L)>,
}

/// Bytes around the lines of a picture, for buses that want more than pixels in one transfer.
///
/// A Sharp memory LCD takes, for each row, its address, the row, and a byte of padding; an I²C display a
/// byte 40h before all data. Leave room for them here, write them once, and send the whole memory.
///
/// ```
/// use aquatint::{Frame, Pages, Spacing};
/// use embedded_graphics::{pixelcolor::BinaryColor, prelude::*};
///
/// // One byte in front, pages of 128 bytes without a gap.
/// let spacing = Spacing { before: 1, stride: 128 };
/// let mut memory = [0; 1 + 1024];
/// memory[0] = 0x40;
/// let mut frame = Frame::<BinaryColor, Pages, _>::with_spacing(memory, Size::new(128, 64), spacing).unwrap();
/// Pixel(Point::new(0, 0), BinaryColor::On).draw(&mut frame)?;
/// assert_eq!(frame.memory()[..3], [0x40, 0b0000_0001, 0]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Spacing {
    /// Bytes before the first line.
    pub before: usize,
    /// Bytes from the beginning of a line to the beginning of the next.
    pub stride: usize,
}

/// Memory that cannot hold the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TooSmall {
    /// How many bytes are needed; for a stride that is shorter than a line, how long it must be.
    pub needed: usize,
}

describe! { TooSmall, Self { needed } => "{needed} bytes are needed"; }

impl<C: PixelColor, L: Layout<C>> Frame<C, L, ()> {
    /// How many bytes a picture of this size needs; `usize::MAX` where no memory could hold it.
    #[must_use]
    pub const fn bytes_needed(width: u32, height: u32) -> usize {
        Self::end(width, height, Self::packed(width, height))
    }

    /// No byte that is not a pixel's.
    const fn packed(width: u32, height: u32) -> Spacing {
        Spacing { before: 0, stride: L::SHAPE.stride(width, height) }
    }

    /// The byte behind the last line.
    const fn end(width: u32, height: u32, spacing: Spacing) -> usize {
        let lines = L::SHAPE.lines(width, height);
        count((spacing.stride as u64).saturating_mul(lines)).saturating_add(spacing.before)
    }
}

impl<C: PixelColor, L: Layout<C>, const N: usize> Frame<C, L, [u8; N]> {
    /// A frame that owns its bytes; may be a constant or a static.
    ///
    /// # Errors
    /// [`TooSmall`].
    pub const fn with_array(bytes: [u8; N], width: u32, height: u32) -> Result<Self, TooSmall> {
        let spacing = Frame::<C, L, ()>::packed(width, height);
        let needed = Frame::<C, L, ()>::end(width, height, spacing);
        if N < needed {
            return Err(TooSmall { needed });
        }
        Ok(Self { bytes, width, height, spacing, end: needed, packing: PhantomData })
    }
}

impl<'a, C: PixelColor, L: Layout<C>> Frame<C, L, &'a [u8]> {
    /// A picture in flash, to be [blitted](crate::display::blit); may be a constant or a static.
    ///
    /// # Errors
    /// [`TooSmall`].
    pub const fn with_slice(bytes: &'a [u8], width: u32, height: u32) -> Result<Self, TooSmall> {
        let spacing = Frame::<C, L, ()>::packed(width, height);
        let needed = Frame::<C, L, ()>::end(width, height, spacing);
        if bytes.len() < needed {
            return Err(TooSmall { needed });
        }
        Ok(Self { bytes, width, height, spacing, end: needed, packing: PhantomData })
    }
}

impl<C: PixelColor, L: Layout<C>, B: AsRef<[u8]>> Frame<C, L, B> {
    /// A frame in any memory: a `&mut [u8]`, an array, a vector on the desk.
    ///
    /// The bytes keep what they hold; bytes behind the picture are never touched.
    ///
    /// # Errors
    /// [`TooSmall`].
    pub fn new(bytes: B, width: u32, height: u32) -> Result<Self, TooSmall> {
        let spacing = Frame::<C, L, ()>::packed(width, height);
        Self::with_spacing(bytes, Size::new(width, height), spacing)
    }

    /// A frame with bytes around its lines, which drawing never touches.
    ///
    /// # Errors
    /// [`TooSmall`]: the memory, or the stride.
    pub fn with_spacing(bytes: B, Size { width, height }: Size, spacing: Spacing) -> Result<Self, TooSmall> {
        let shortest = L::SHAPE.stride(width, height);
        if spacing.stride < shortest {
            return Err(TooSmall { needed: shortest });
        }
        let needed = Frame::<C, L, ()>::end(width, height, spacing);
        if bytes.as_ref().len() < needed {
            return Err(TooSmall { needed });
        }
        Ok(Self { bytes, width, height, spacing, end: needed, packing: PhantomData })
    }

    /// The bytes of the picture in the order in which the panel takes them, gaps included, from the first line on.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        self.memory().get(self.spacing.before..).unwrap_or(&[])
    }

    /// All bytes, those before the first line too.
    #[must_use]
    pub fn memory(&self) -> &[u8] {
        self.bytes.as_ref().get(..self.end).unwrap_or(&[])
    }

    /// The bytes of one plane, counted from 0; empty where the layout has fewer.
    #[must_use]
    pub fn plane(&self, index: usize) -> &[u8] {
        let bytes = self.bytes();
        let length = bytes.len() / L::SHAPE.planes.max(1) as usize;
        bytes.chunks_exact(length.max(1)).nth(index).unwrap_or(&[])
    }

    /// Bytes from the beginning of a line to the beginning of the next.
    #[must_use]
    pub const fn stride(&self) -> usize {
        self.spacing.stride
    }

    /// The picture's bytes from the first line on, for a layout to read.
    #[inline]
    pub(super) fn memory_ref(&self) -> Memory<&[u8]> {
        Memory { bytes: self.bytes(), stride: self.spacing.stride }
    }

    /// The lines of bytes, without the gaps between them: rows of pixels, pages or columns.
    pub fn lines(&self) -> impl Iterator<Item = &[u8]> {
        let data = L::SHAPE.stride(self.width, self.height);
        self.bytes().chunks(self.spacing.stride.max(1)).map(move |line| line.get(..data).unwrap_or(line))
    }
}

impl<C: PixelColor, L: Layout<C>, B: AsMut<[u8]>> Frame<C, L, B> {
    /// The row and the columns of the part of a run that is inside, if any is.
    #[inline]
    fn visible(&mut self, row: i32, columns: &Range<i32>) -> Option<(Line<'_>, Range<usize>)> {
        let start = columns.start.max(0);
        // A negative row is beyond any height as an unsigned one.
        if bits(row) >= self.height || start >= columns.end {
            return None;
        }
        let (start, end) = (bits(start), bits(columns.end).min(self.width));
        if start >= end {
            return None;
        }
        Some(((self.lines_mut()?, position(bits(row))), position(start)..position(end)))
    }

    /// The picture's bytes from the first line on, for a layout to write.
    #[inline]
    pub(super) fn memory_mut(&mut self) -> Memory<&mut [u8]> {
        self.lines_mut().unwrap_or(Memory { bytes: &mut [], stride: 0 })
    }

    /// The same; never `None`, but the compiler does not know.
    #[inline]
    fn lines_mut(&mut self) -> Option<Memory<&mut [u8]>> {
        let memory = self.bytes.as_mut();
        // Only planes need to know where the picture ends; the others save the look.
        let end = if L::SHAPE.planes > 1 { self.end } else { memory.len() };
        let bytes = memory.get_mut(self.spacing.before..end)?;
        Some(Memory { bytes, stride: self.spacing.stride })
    }

    /// Fills the visible part of an area that is not all inside.
    #[cold]
    fn fill_clipped(&mut self, area: &Rectangle, color: C) {
        let visible = Rect::from(*area).intersection(self.bounds());
        if !visible.is_empty() {
            let rows = index(visible.top)..index(visible.bottom);
            L::fill_solid(self.memory_mut(), rows, index(visible.left)..index(visible.right), color);
        }
    }
}

impl<C: PixelColor, L: Layout<C>, B: AsMut<[u8]>> Target for Frame<C, L, B> {
    type Color = C;
    type Error = Infallible;

    fn bounds(&self) -> Rect {
        Rect::of_size(self.size())
    }

    fn fill_run<const N: usize>(&mut self, row: i32, columns: Range<i32>, colors: [C; N]) -> Result<(), Infallible> {
        if let Some(((memory, row), visible)) = self.visible(row, &columns) {
            if let [color] = *colors.as_slice() {
                L::fill_solid(memory, row..row + 1, visible, color);
            } else if let Some(colors) = eight(&colors) {
                L::fill(memory, row..row + 1, visible, colors);
            } else {
                let colors = repeated(&colors, columns.start.max(0)).take(visible.len()).map(Some);
                L::write(memory, row, visible.start, colors);
            }
        }
        Ok(())
    }

    fn write_run(
        &mut self,
        row: i32,
        columns: Range<i32>,
        mut colors: impl Iterator<Item = Option<C>>,
    ) -> Result<(), Infallible> {
        if let Some(((memory, row), visible)) = self.visible(row, &columns) {
            if let Some(last) = index(columns.start.saturating_neg()).checked_sub(1) {
                colors.nth(last);
            }
            L::write(memory, row, visible.start, colors.take(visible.len()));
        }
        Ok(())
    }

    #[inline]
    fn set(&mut self, row: i32, column: i32, color: C) -> Result<(), Infallible> {
        // Negative numbers are beyond any size as unsigned ones.
        let (row, column) = (bits(row), bits(column));
        if row < self.height && column < self.width {
            if let Some(memory) = self.lines_mut() {
                L::set(memory, position(row), position(column), color);
            }
        }
        Ok(())
    }

    #[inline]
    fn fill_bits(&mut self, row: i32, columns: Range<i32>, colors: [C; 2], byte: u8) -> Result<(), Infallible> {
        if let Some((line, visible)) = self.visible(row, &columns) {
            L::fill_bits(line, visible, colors, byte);
        }
        Ok(())
    }

    #[inline]
    fn write_bits(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: [C; 2],
        mut next: impl FnMut() -> u8,
    ) -> Result<(), Infallible> {
        if let Some((line, visible)) = self.visible(row, &columns) {
            // Whole bytes before the frame.
            for _ in columns.start >> 3..columns.start.max(0) >> 3 {
                next();
            }
            L::write_bits(line, visible, colors, next);
        }
        Ok(())
    }

    fn fill_tile(&mut self, area: Rect, tile: &[[C; 8]; 8]) -> Result<(), Infallible> {
        let visible = area.intersection(self.bounds());
        if !visible.is_empty() {
            let rows = index(visible.top)..index(visible.bottom);
            L::fill_tile(self.memory_mut(), rows, index(visible.left)..index(visible.right), tile);
        }
        Ok(())
    }
}

impl<C: PixelColor, L: Layout<C>, B> OriginDimensions for Frame<C, L, B> {
    fn size(&self) -> Size {
        Size::new(self.width, self.height)
    }
}

impl<C: PixelColor, L: Layout<C>, B: AsMut<[u8]>> DrawTarget for Frame<C, L, B> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        let (width, height) = (self.width, self.height);
        let Memory { bytes, stride } = self.memory_mut();
        for Pixel(Point { x, y }, color) in pixels {
            // Negative numbers are beyond any size as unsigned ones.
            let (x, y) = (x.cast_unsigned(), y.cast_unsigned());
            if x < width && y < height {
                L::set(Memory { bytes: &mut *bytes, stride }, position(y), position(x), color);
            }
        }
        Ok(())
    }

    fn fill_contiguous<I: IntoIterator<Item = C>>(&mut self, area: &Rectangle, colors: I) -> Result<(), Infallible> {
        write_area(self, (*area).into(), colors.into_iter())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), Infallible> {
        let (Point { x, y }, Size { width, height }) = (area.top_left, area.size);
        let (x, y) = (x.cast_unsigned(), y.cast_unsigned());
        // Negative numbers are beyond any size as unsigned ones, and so is the end of nothing.
        let is_inside = x < self.width
            && y < self.height
            && width.wrapping_sub(1) < self.width - x
            && height.wrapping_sub(1) < self.height - y;
        if is_inside {
            let (rows, columns) = (position(y)..position(y + height), position(x)..position(x + width));
            L::fill_solid(self.memory_mut(), rows, columns, color);
        } else {
            self.fill_clipped(area, color);
        }
        Ok(())
    }

    fn clear(&mut self, color: C) -> Result<(), Infallible> {
        self.fill_solid(&self.bounding_box(), color)
    }
}

/// A column or row inside of a frame.
#[inline]
const fn position(value: u32) -> usize {
    count(value as u64)
}

impl<C: PixelColor, L: Layout<C>, B: AsRef<[u8]>> GetPixel for Frame<C, L, B> {
    type Color = C;

    fn pixel(&self, point: Point) -> Option<C> {
        let bounds = Rect::of_size(self.size());
        if !bounds.contains(point) {
            return None;
        }
        L::read(self.memory_ref(), index(point.y), index(point.x))
    }
}
