//! Frames: a picture in memory of the caller's, in the byte order of the panel.

use core::{convert::Infallible, marker::PhantomData, ops::Range};

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Point, Size},
    image::GetPixel,
    primitives::Rectangle,
};

use crate::{
    display::layout::Layout,
    error::describe,
    num::{count, index, low_u8},
    space::Rect,
    target::{Code, Ink, Target},
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
    packing: PhantomData<(C, L)>,
}

/// Fewer bytes than the picture needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooSmall {
    /// How many are needed.
    pub needed: usize,
}

describe! { TooSmall, Self { needed } => "{needed} bytes are needed"; }

impl<C: Code, L: Layout<C>> Frame<C, L, ()> {
    /// How many bytes a picture of this size needs; `usize::MAX` where no memory could hold it.
    #[must_use]
    pub const fn bytes_needed(width: u32, height: u32) -> usize {
        let lines = height.div_ceil(L::ROWS_PER_LINE) as u64;
        count((Self::stride(width) as u64).saturating_mul(lines))
    }

    /// Bytes in a line.
    const fn stride(width: u32) -> usize {
        count((width as u64 * (C::BITS * L::ROWS_PER_LINE) as u64).div_ceil(8))
    }
}

impl<C: Code, L: Layout<C>, const N: usize> Frame<C, L, [u8; N]> {
    /// A frame that owns its bytes; may be a constant or a static.
    ///
    /// # Errors
    /// [`TooSmall`].
    pub const fn with_array(bytes: [u8; N], width: u32, height: u32) -> Result<Self, TooSmall> {
        let needed = Frame::<C, L, ()>::bytes_needed(width, height);
        if N < needed { Err(TooSmall { needed }) } else { Ok(Self { bytes, width, height, packing: PhantomData }) }
    }
}

impl<C: Code, L: Layout<C>, B: AsRef<[u8]>> Frame<C, L, B> {
    /// A frame in any memory: a `&mut [u8]`, an array, a vector on the desk.
    ///
    /// The bytes keep what they hold; bytes behind the picture are never touched.
    ///
    /// # Errors
    /// [`TooSmall`].
    pub fn new(bytes: B, width: u32, height: u32) -> Result<Self, TooSmall> {
        let needed = Frame::<C, L, ()>::bytes_needed(width, height);
        if bytes.as_ref().len() < needed {
            return Err(TooSmall { needed });
        }
        Ok(Self { bytes, width, height, packing: PhantomData })
    }

    /// The bytes of the picture in the order in which the panel takes them.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        let needed = Frame::<C, L, ()>::bytes_needed(self.width, self.height);
        self.bytes.as_ref().get(..needed).unwrap_or(&[])
    }
}

impl<C: Code, L: Layout<C>, B: AsMut<[u8]>> Frame<C, L, B> {
    /// Fills a rectangle, line of bytes by line of bytes.
    fn fill_rect(&mut self, area: Rect, codes: [u8; 4]) {
        let area = area.intersection(self.rect());
        if area.is_empty() {
            return;
        }
        let columns = index(area.left)..index(area.right);
        let mut row = area.top;
        while row < area.bottom {
            // All the rows that share a line of bytes with this one.
            let line_end = (row | low_i32(L::ROWS_PER_LINE - 1)).saturating_add(1);
            let mask = Self::row_mask(row, line_end.min(area.bottom));
            let Some(line) = self.line(row) else { return };
            L::fill(line, columns.clone(), mask, codes);
            row = line_end;
        }
    }

    fn rect(&self) -> Rect {
        Rect::of_size(Size::new(self.width, self.height))
    }

    /// Bits of the rows from `first` up to, not including, `end` within their line of bytes.
    const fn row_mask(first: i32, end: i32) -> u8 {
        let in_line = first.cast_unsigned() % L::ROWS_PER_LINE;
        let rows = end.wrapping_sub(first).cast_unsigned() % 9;
        low_u8(((1 << rows) - 1) << in_line)
    }

    /// The line of bytes that holds a row inside.
    fn line(&mut self, row: i32) -> Option<&mut [u8]> {
        let stride = Frame::<C, L, ()>::stride(self.width);
        let start = index(row) / L::ROWS_PER_LINE as usize * stride;
        self.bytes.as_mut().get_mut(start..start + stride)
    }
}

const fn low_i32(value: u32) -> i32 {
    value.cast_signed()
}

impl<C: Code, L: Layout<C>, B: AsMut<[u8]>> Target for Frame<C, L, B> {
    type Color = C;
    type Error = Infallible;

    fn bounds(&self) -> Rect {
        self.rect()
    }

    fn fill_run(&mut self, row: i32, columns: Range<i32>, ink: &impl Ink<Color = C>) -> Result<(), Infallible> {
        if let Some(columns) = self.rect().clip_run(row, columns) {
            let codes = ink.four(row).map(Code::code);
            let mask = Self::row_mask(row, row.saturating_add(1));
            if let Some(line) = self.line(row) {
                L::fill(line, index(columns.start)..index(columns.end), mask, codes);
            }
        }
        Ok(())
    }

    fn write_run(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: impl Iterator<Item = Option<C>>,
    ) -> Result<(), Infallible> {
        if let Some(visible) = self.rect().clip_run(row, columns.clone()) {
            let hidden = index(visible.start.saturating_sub(columns.start));
            let (start, end) = (index(visible.start), index(visible.end));
            let mask = Self::row_mask(row, row.saturating_add(1));
            if let Some(line) = self.line(row) {
                let codes = colors.skip(hidden).take(end - start).map(|color| color.map(Code::code));
                L::write(line, start, mask, codes);
            }
        }
        Ok(())
    }
}

impl<C: Code, L: Layout<C>, B> OriginDimensions for Frame<C, L, B> {
    fn size(&self) -> Size {
        Size::new(self.width, self.height)
    }
}

impl<C: Code, L: Layout<C>, B: AsMut<[u8]>> DrawTarget for Frame<C, L, B> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        let bounds = self.rect();
        for Pixel(Point { x, y }, color) in pixels {
            if bounds.columns().contains(&x) && bounds.rows().contains(&y) {
                let mask = Self::row_mask(y, y.saturating_add(1));
                if let Some(line) = self.line(y) {
                    L::write(line, index(x), mask, core::iter::once(Some(color.code())));
                }
            }
        }
        Ok(())
    }

    fn fill_contiguous<I: IntoIterator<Item = C>>(&mut self, area: &Rectangle, colors: I) -> Result<(), Infallible> {
        let (mut colors, area) = (colors.into_iter(), Rect::from(*area));
        let visible = area.intersection(self.rect());
        if visible.is_empty() {
            return Ok(());
        }
        // Colours of hidden pixels are taken and dropped, in one go where they lie together.
        let hidden = |from: i32, to: i32| u64::from(to.abs_diff(from));
        skip(&mut colors, hidden(area.top, visible.top) * u64::from(area.width()));
        for row in visible.rows() {
            skip(&mut colors, hidden(area.left, visible.left));
            let run = colors.by_ref().take(index(visible.right - visible.left));
            self.write_run(row, visible.columns(), run.map(Some))?;
            skip(&mut colors, hidden(visible.right, area.right));
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), Infallible> {
        self.fill_rect((*area).into(), [color.code(); 4]);
        Ok(())
    }

    fn clear(&mut self, color: C) -> Result<(), Infallible> {
        self.fill_rect(self.rect(), [color.code(); 4]);
        Ok(())
    }
}

/// Takes `number` items, or all there are.
fn skip(items: &mut impl Iterator, number: u64) {
    if let Some(last) = count(number).checked_sub(1) {
        items.nth(last);
    }
}

impl<C: Code, L: Layout<C>, B: AsRef<[u8]>> GetPixel for Frame<C, L, B> {
    type Color = C;

    fn pixel(&self, point: Point) -> Option<C> {
        let bounds = Rect::of_size(self.size());
        if !(bounds.columns().contains(&point.x) && bounds.rows().contains(&point.y)) {
            return None;
        }
        let stride = Frame::<C, L, ()>::stride(self.width);
        let start = index(point.y) / L::ROWS_PER_LINE as usize * stride;
        let line = self.bytes.as_ref().get(start..start + stride)?;
        let mask = 1 << (point.y.cast_unsigned() % L::ROWS_PER_LINE);
        L::read(line, index(point.x), mask).map(C::from_code)
    }
}
