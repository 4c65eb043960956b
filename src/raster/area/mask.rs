//! Coverage that is kept: a byte a pixel.

use core::{convert::Infallible, ops::Range};

use embedded_graphics::geometry::{Point, Size};

use crate::{
    coverage::{Coverage, Covered},
    num::{bits, count, index},
    space::Rect,
    span::Sink,
};

/// A picture of coverage, 255 being all of the pixel: drawn once, shown often, on any place and in any colour.
///
/// It takes the spans of antialiased shapes, where they overlap the greater coverage; and it gives them again. In
/// flash, as `CoverageMask<&[u8]>`, it is a picture of a shape with soft borders.
///
/// ```
/// use aquatint::{Coverage, Oval, Point2, Rule, Subpixel, raster::area::{CoverageMask, Scratch, fill}};
/// use embedded_graphics::geometry::Size;
///
/// let mut mask = CoverageMask::new([0; 64], Size::new(8, 8)).unwrap();
/// let dot = Oval::circle(Point2::corner(4, 4), Subpixel::from_num(3)).unwrap();
/// let (mut edges, mut cells) = (heapless::Vec::<_, 16>::new(), [Coverage::NONE; 8]);
/// fill(&dot, Rule::NonZero, Scratch { edges: &mut edges, cells: &mut cells }, &mut mask)?;
/// // 9π pixels.
/// let area = mask.bytes().iter().map(|&byte| u32::from(byte)).sum::<u32>() as f32 / 255.0;
/// assert!((area - 28.27).abs() < 0.05);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CoverageMask<B> {
    bytes: B,
    size: Size,
}

impl<B: AsRef<[u8]>> CoverageMask<B> {
    /// Bytes of a picture of this size, row by row.
    ///
    /// `None` if there are fewer than pixels.
    pub fn new(bytes: B, size: Size) -> Option<Self> {
        let needed = count(u64::from(size.width).saturating_mul(u64::from(size.height)));
        (bytes.as_ref().len() >= needed).then_some(Self { bytes, size })
    }

    /// Row by row, 255 being all of a pixel.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        self.bytes.as_ref()
    }

    /// Emits what is covered, with the upper left pixel at `at`, pixel by pixel in pieces of up to 32.
    ///
    /// # Errors
    /// What the sink says.
    pub fn spans<S, E>(&self, at: Point, sink: &mut S) -> Result<(), E>
    where
        S: for<'c> Sink<Covered<'c>, Error = E>,
    {
        let bounds = sink.bounds();
        let area = Rect::of_size(self.size);
        let (right, bottom) = (at.x.saturating_add(area.right), at.y.saturating_add(area.bottom));
        let visible = Rect::new(at.x, at.y, right, bottom).intersection(bounds);
        for row in visible.rows() {
            let mut column = visible.left;
            let first = index(column.saturating_sub(at.x));
            let line = self.line(row.saturating_sub(at.y)).get(first..).unwrap_or_default();
            for piece in line.get(..index(visible.width().cast_signed())).unwrap_or(line).chunks(PIECE) {
                column = emit_piece(piece, (row, column), sink)?;
            }
        }
        Ok(())
    }

    fn line(&self, row: i32) -> &[u8] {
        self.bytes().get(self.place(row)..).and_then(|rest| rest.get(..self.width())).unwrap_or_default()
    }
}

/// Pixels that are turned from bytes to coverage at once.
const PIECE: usize = 32;

fn emit_piece<S, E>(piece: &[u8], (row, column): (i32, i32), sink: &mut S) -> Result<i32, E>
where
    S: for<'c> Sink<Covered<'c>, Error = E>,
{
    let mut cells = [Coverage::NONE; PIECE];
    let end = column.saturating_add(crate::num::count_i32(piece.len()));
    for (cell, byte) in cells.iter_mut().zip(piece) {
        *cell = Coverage::from_byte(*byte);
    }
    if let (Some(cells), true) = (cells.get(..piece.len()), piece.iter().any(|byte| *byte > 0)) {
        sink.span(row, column..end, Covered::Each(cells))?;
    }
    Ok(end)
}

impl<B: AsMut<[u8]>> CoverageMask<B> {
    /// Uncovers everything.
    pub fn clear(&mut self) {
        self.bytes.as_mut().fill(0);
    }
}

impl<B> CoverageMask<B> {
    fn width(&self) -> usize {
        count(self.size.width.into())
    }

    /// The index of the first byte of a row.
    fn place(&self, row: i32) -> usize {
        position(row).wrapping_mul(self.width())
    }
}

/// A column or row inside; what is negative is beyond any size.
#[inline]
const fn position(value: i32) -> usize {
    count(bits(value) as u64)
}

impl<B: AsMut<[u8]>> Sink<Covered<'_>> for CoverageMask<B> {
    type Error = Infallible;

    fn bounds(&self) -> Rect {
        Rect::of_size(self.size)
    }

    #[inline]
    fn span(&mut self, row: i32, columns: Range<i32>, covered: Covered<'_>) -> Result<(), Infallible> {
        let line = self.place(row);
        let place = line.wrapping_add(position(columns.start))..line.wrapping_add(position(columns.end));
        let run = self.bytes.as_mut().get_mut(place).unwrap_or_default();
        match covered {
            Covered::Evenly(Coverage::FULL) => run.fill(255),
            Covered::Evenly(coverage) => {
                let new = coverage.to_byte();
                for byte in run {
                    *byte = (*byte).max(new);
                }
            }
            Covered::Each(cells) => {
                for (byte, cell) in run.iter_mut().zip(cells) {
                    let new = cell.to_byte();
                    if new > *byte {
                        *byte = new;
                    }
                }
            }
        }
        Ok(())
    }
}
