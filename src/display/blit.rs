//! Images onto frames: packed pixels copied, or combined with what is there, at any place.
//!
//! A [`Bitmap`] is a picture in flash or memory, in rows like `ImageRaw` of embedded-graphics. It is
//! drawn on the bytes of a frame, which may be in rows or in pages; what does not fit is clipped.
//!
//! ```text
//!   target  ▒▒▒▒▒▒▒▒│▒▒▒▒▒▒▒▒│▒▒▒▒▒▒▒▒│      a strip of bits that lies in one word of
//!                ╰────── strip ─────╯         the source and in one of the target:
//!   source    ▒▒▒▒▒▒│▒▒▒▒▒▒▒▒│▒▒▒▒▒▒▒▒│      rotate, mask, merge; the same in every row
//! ```
//!
//! - **Method** rows: the area is cut into strips of up to a machine word, and each strip is done
//!   from top to bottom with one rotation and one mask (the `BitBlt` of D. Ingalls, Xerox PARC 1975;
//!   operations by J. D. Foley et al., *Computer Graphics: Principles and Practice*, section 19.6).
//!   Pages: blocks of 8 × 8 pixels are [transposed](super::transpose) from the eight rows that
//!   share a page of the target.
//! - **Cost** a dozen instructions for each strip of a row, and about 50 for each block of a page.
//! - **Memory** none.

mod pages;
mod rows;
mod scroll;

use core::{
    iter::zip,
    marker::PhantomData,
    ops::{BitAnd, BitXor, Not},
};

use embedded_graphics::{
    geometry::{Point, Size},
    pixelcolor::raw::RawU1,
    primitives::Rectangle,
};

use crate::{
    display::frame::TooSmall,
    num::{count, index, low_index},
    space::Rect,
    target::Code,
};

use pages::Page;
use rows::Run;
pub use scroll::{scroll_pages, scroll_rows};

/// What becomes of a pixel of the target where one of the source falls on it, bit by bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RasterOp {
    /// It is the source.
    Copy,
    /// Bits of the source are set.
    Or,
    /// Bits of the source are cleared.
    AndNot,
    /// Bits of the source are inverted. Drawn twice, it is gone.
    Xor,
}

impl RasterOp {
    /// The bits of the target that change.
    #[inline]
    fn change<W>(self, target: W, source: W) -> W
    where
        W: Copy + BitAnd<Output = W> + BitXor<Output = W> + Not<Output = W>,
    {
        match self {
            Self::Copy => target ^ source,
            Self::Or => !target & source,
            Self::AndNot => target & source,
            Self::Xor => source,
        }
    }
}

/// How the pixels of a frame lie in bytes that it has lent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Geometry {
    /// Columns and rows of pixels.
    pub size: Size,
    /// Bytes from one line to the next: from row to row, or from page to page.
    pub stride: usize,
}

impl Geometry {
    /// Rows of a colour, without bytes between them.
    #[must_use]
    pub const fn rows<C: Code>(width: u32, height: u32) -> Self {
        Self { size: Size::new(width, height), stride: row_bytes(width, C::BITS) }
    }

    /// Pages without bytes between them.
    #[must_use]
    pub const fn pages(width: u32, height: u32) -> Self {
        Self { size: Size::new(width, height), stride: count(width as u64) }
    }

    const fn check_pages(self, bytes: usize) -> Result<(), TooSmall> {
        self.check(bytes, count(self.size.width as u64), self.size.height.div_ceil(8))
    }

    const fn check_rows(self, bytes: usize, bits: u32) -> Result<(), TooSmall> {
        self.check(bytes, row_bytes(self.size.width, bits), self.size.height)
    }

    /// Whether there are so many bytes; `line` is what a line has at least.
    const fn check(self, bytes: usize, line: usize, lines: u32) -> Result<(), TooSmall> {
        let needed = count((self.stride as u64).saturating_mul(lines as u64));
        if self.stride < line {
            Err(TooSmall { needed: line })
        } else if bytes < needed {
            Err(TooSmall { needed })
        } else {
            Ok(())
        }
    }
}

const fn row_bytes(width: u32, bits: u32) -> usize {
    count((width as u64 * bits as u64).div_ceil(8))
}

/// A picture to be drawn: rows, the leftmost pixel in the highest bits, each padded to whole bytes.
///
/// The colour `C` gives the bits a pixel: 1, 2, 4 or 8. This is the data of an `ImageRaw`.
///
/// ```
/// use aquatint::display::blit::{Bitmap, Geometry, RasterOp};
/// use embedded_graphics::{pixelcolor::BinaryColor, prelude::Point};
///
/// static ARROW: Bitmap<BinaryColor> = match Bitmap::new(&[0b0100_0000, 0b1110_0000], 3, 2) {
///     Ok(arrow) => arrow,
///     Err(_) => panic!(),
/// };
///
/// let mut rows = [0b1000_0001; 3];
/// ARROW.draw_on_rows(&mut rows, Geometry::rows::<BinaryColor>(8, 3), Point::new(3, 1), RasterOp::Or)?;
/// assert_eq!(rows, [0b1000_0001, 0b1000_1001, 0b1001_1101]);
///
/// let mut pages = [0; 8];
/// ARROW.draw_on_pages(&mut pages, Geometry::pages(8, 3), Point::new(3, 1), RasterOp::Copy)?;
/// assert_eq!(pages, [0, 0, 0, 0b100, 0b110, 0b100, 0, 0]);
/// # Ok::<(), aquatint::TooSmall>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bitmap<'a, C> {
    bytes: &'a [u8],
    mask: Option<&'a [u8]>,
    width: u32,
    height: u32,
    area: Rect,
    color: PhantomData<C>,
}

impl<'a, C: Code> Bitmap<'a, C> {
    /// The picture in these bytes; there may be more of them.
    ///
    /// # Errors
    /// [`TooSmall`].
    pub const fn new(bytes: &'a [u8], width: u32, height: u32) -> Result<Self, TooSmall> {
        let needed = count((row_bytes(width, C::BITS) as u64).saturating_mul(height as u64));
        if bytes.len() < needed {
            return Err(TooSmall { needed });
        }
        let area = Rect::of_size(Size::new(width, height));
        Ok(Self { bytes, mask: None, width, height, area, color: PhantomData })
    }

    /// The same with holes: only pixels whose bit in `mask` is 1 are drawn. The mask is a one-bit
    /// picture of the same size, in rows.
    ///
    /// # Errors
    /// [`TooSmall`].
    pub const fn with_mask(self, mask: &'a [u8]) -> Result<Self, TooSmall> {
        let needed = count((row_bytes(self.width, 1) as u64).saturating_mul(self.height as u64));
        if mask.len() < needed { Err(TooSmall { needed }) } else { Ok(Self { mask: Some(mask), ..self }) }
    }

    /// Only a part: one sprite of a sheet, one glyph of a font. What is outside of it is cut off.
    ///
    /// ```
    /// # use aquatint::{Rect, display::blit::{Bitmap, Geometry, RasterOp}};
    /// # use embedded_graphics::{pixelcolor::BinaryColor, prelude::Point};
    /// let sheet = Bitmap::<BinaryColor>::new(&[0b1010_0110], 8, 1)?;
    /// let mut rows = [0];
    /// let right_half = sheet.crop(Rect::new(4, 0, 8, 1));
    /// right_half.draw_on_rows(&mut rows, Geometry::rows::<BinaryColor>(8, 1), Point::zero(), RasterOp::Copy)?;
    /// assert_eq!(rows, [0b0110_0000]);
    /// # Ok::<(), aquatint::TooSmall>(())
    /// ```
    #[must_use]
    pub fn crop(self, part: Rect) -> Self {
        let (x, y) = (self.area.left, self.area.top);
        let [left, right] = [part.left, part.right].map(|column| column.saturating_add(x));
        let [top, bottom] = [part.top, part.bottom].map(|row| row.saturating_add(y));
        Self { area: Rect::new(left, top, right, bottom).intersection(self.area), ..self }
    }

    /// Draws with the top left corner at `at` on a frame of the same colour in rows.
    ///
    /// # Errors
    /// [`TooSmall`] for the frame, and nothing is drawn.
    pub fn draw_on_rows(&self, target: &mut [u8], geometry: Geometry, at: Point, op: RasterOp) -> Result<(), TooSmall> {
        geometry.check_rows(target.len(), C::BITS)?;
        let Some(part) = Part::new(self.area, geometry.size, at) else { return Ok(()) };
        let strides = (geometry.stride.max(1), row_bytes(self.width, C::BITS).max(1));
        let target = {
            let rows = index(part.area.top) * strides.0..index(part.area.bottom) * strides.0;
            target.get_mut(rows).unwrap_or_default()
        };
        let source = self.bytes.get(part.row * strides.1..).unwrap_or_default();
        for strip in part.run(C::BITS).strips(strides) {
            let lines = zip(target.chunks_exact_mut(strides.0), source.chunks_exact(strides.1));
            match self.mask {
                None => strip.merge_lines(lines, op),
                Some(mask) => {
                    let stride = row_bytes(self.width, 1).max(1);
                    let holes = strip.holes(C::BITS, stride);
                    let masks = mask.get(part.row * stride..).unwrap_or_default().chunks_exact(stride);
                    zip(lines, masks).for_each(|(lines, mask)| strip.merge(lines, holes.word(mask), op));
                }
            }
        }
        Ok(())
    }
}

impl<C: Code<Raw = RawU1>> Bitmap<'_, C> {
    /// Draws with the top left corner at `at` on a frame in pages.
    ///
    /// # Errors
    /// [`TooSmall`] for the frame, and nothing is drawn.
    pub fn draw_on_pages(
        &self,
        target: &mut [u8],
        geometry: Geometry,
        at: Point,
        op: RasterOp,
    ) -> Result<(), TooSmall> {
        geometry.check_pages(target.len())?;
        let Some(part) = Part::new(self.area, geometry.size, at) else { return Ok(()) };
        let stride = row_bytes(self.width, 1).max(1);
        for page in part.pages() {
            let bytes = page.bytes(target, geometry.stride);
            page.merge_rows(bytes, (self.bytes, self.mask), stride, op);
        }
        Ok(())
    }
}

/// A one-bit picture in pages, which is drawn on pages without being transposed: fonts of columns,
/// or another frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PageBitmap<'a> {
    bytes: &'a [u8],
    geometry: Geometry,
}

impl<'a> PageBitmap<'a> {
    /// The picture in these bytes; there may be more of them.
    ///
    /// # Errors
    /// [`TooSmall`].
    pub const fn new(bytes: &'a [u8], geometry: Geometry) -> Result<Self, TooSmall> {
        match geometry.check_pages(bytes.len()) {
            Ok(()) => Ok(Self { bytes, geometry }),
            Err(error) => Err(error),
        }
    }

    /// Draws with the top left corner at `at` on a frame in pages.
    ///
    /// ```
    /// use aquatint::display::blit::{Geometry, PageBitmap, RasterOp};
    /// use embedded_graphics::prelude::Point;
    ///
    /// let mut pages = [0; 4];
    /// let letter_l = PageBitmap::new(&[0b11111, 0b10000], Geometry::pages(2, 5))?;
    /// letter_l.draw_on_pages(&mut pages, Geometry::pages(2, 16), Point::new(0, 5), RasterOp::Or)?;
    /// assert_eq!(pages, [0b1110_0000, 0, 0b11, 0b10]);
    /// # Ok::<(), aquatint::TooSmall>(())
    /// ```
    ///
    /// # Errors
    /// [`TooSmall`] for the frame, and nothing is drawn.
    pub fn draw_on_pages(
        &self,
        target: &mut [u8],
        geometry: Geometry,
        at: Point,
        op: RasterOp,
    ) -> Result<(), TooSmall> {
        geometry.check_pages(target.len())?;
        let Some(part) = Part::new(Rect::of_size(self.geometry.size), geometry.size, at) else { return Ok(()) };
        for page in part.pages() {
            let bytes = page.bytes(target, geometry.stride);
            page.merge_pages(bytes, self.bytes, self.geometry.stride, op);
        }
        Ok(())
    }
}

/// What of a picture is seen: where on the target, and from which pixel of the source.
#[derive(Clone, Debug)]
struct Part {
    area: Rect,
    column: usize,
    row: usize,
}

impl Part {
    fn new(source: Rect, target: Size, at: Point) -> Option<Self> {
        let placed = Rectangle::new(at, Size::new(source.width(), source.height()));
        let area = Rect::from(placed).intersection(Rect::of_size(target));
        let from = |seen: i32, at: i32, first: i32| index(seen.saturating_sub(at).saturating_add(first));
        let (column, row) = (from(area.left, at.x, source.left), from(area.top, at.y, source.top));
        (!area.is_empty()).then_some(Self { area, column, row })
    }

    const fn run(&self, bits: u32) -> Run {
        let bits = bits as usize;
        let width = index(self.area.right) - index(self.area.left);
        Run { target: index(self.area.left) * bits, source: self.column * bits, bits: width * bits }
    }

    fn pages(&self) -> impl DoubleEndedIterator<Item = Page> {
        let (top, bottom) = (index(self.area.top), index(self.area.bottom));
        (top / 8..bottom.div_ceil(8)).map(move |page| {
            let (first, end) = (top.max(page * 8), bottom.min(page * 8 + 8));
            let columns = index(self.area.left)..index(self.area.right);
            let (column, row) = (self.column, self.row + (first - top));
            Page { index: page, columns, column, row, rows: end - first, below: low_index(first % 8) }
        })
    }
}
