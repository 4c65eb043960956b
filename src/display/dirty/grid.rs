//! The grid of bytes of a picture: which bytes of which lines hold which pixels.
//!
//! A *cell* is the smallest rectangle of whole pixels that fills whole bytes, whatever the layout; cells
//! side by side are a line, and a line runs across the picture or down.
//!
//! ```text
//!   rows, 1 bit    8 × 1      ┌────────┬────────┐      pages   1 × 8     ┌┬┬┬┐
//!   rows, 4 bits   2 × 1      ├────────┼────────┤      columns 1 × 8     ││││
//!   words          1 × 1      └────────┴────────┘      (lines run down)  └┴┴┴┘
//! ```

use core::ops::Range;

use embedded_graphics::{
    geometry::{OriginDimensions, Point, Size},
    pixelcolor::PixelColor,
};

use crate::{
    display::{
        frame::Frame,
        layout::{Layout, Memory, Shape},
    },
    num::{count, index, saturate_u32, size_i32},
    space::Rect,
};

/// The cells of a picture, and where the next one of a line is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grid {
    is_vertical: bool,
    /// Columns and rows of pixels in a cell, and its bytes, as powers of two.
    columns_log2: u32,
    rows_log2: u32,
    bytes_log2: u32,
}

/// Some bytes of some lines.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Part {
    pub lines: Range<usize>,
    pub bytes: Range<usize>,
}

impl Part {
    /// In one plane.
    pub fn byte_len(&self) -> usize {
        self.lines.len() * self.bytes.len()
    }
}

impl Grid {
    /// Checks, while compiling, that cells are powers of two.
    pub const fn of(Shape { is_vertical, rows_per_line, bits, .. }: Shape) -> Self {
        let bits = bits * rows_per_line;
        let (along, bytes) = if bits < 8 { (8 / bits, 1) } else { (1, bits / 8) };
        assert!(along.is_power_of_two() && rows_per_line.is_power_of_two() && bytes.is_power_of_two());
        let [columns, rows] = if is_vertical { [rows_per_line, along] } else { [along, rows_per_line] };
        let [columns_log2, rows_log2] = [columns.trailing_zeros(), rows.trailing_zeros()];
        Self { is_vertical, columns_log2, rows_log2, bytes_log2: bytes.trailing_zeros() }
    }

    /// Bytes of a cell.
    pub const fn cell_bytes(self) -> usize {
        1 << self.bytes_log2
    }

    /// The bytes of an area that is not empty and lies inside.
    #[inline]
    pub fn part(self, area: Rect) -> Part {
        let cells = |pixels: Range<i32>, log2: u32| {
            index(pixels.start) >> log2..(index(pixels.end.saturating_sub(1)) >> log2) + 1
        };
        let (columns, rows) = (cells(area.columns(), self.columns_log2), cells(area.rows(), self.rows_log2));
        let (lines, cells) = if self.is_vertical { (columns, rows) } else { (rows, columns) };
        Part { lines, bytes: cells.start << self.bytes_log2..cells.end << self.bytes_log2 }
    }

    /// The line of a pixel inside, and the first byte of its cell in there.
    #[inline]
    pub fn byte(self, Point { x, y }: Point) -> (usize, usize) {
        let (column, row) = (index(x) >> self.columns_log2, index(y) >> self.rows_log2);
        let (line, cell) = if self.is_vertical { (column, row) } else { (row, column) };
        (line, cell << self.bytes_log2)
    }

    /// The pixels of whole cells, those of padding included.
    #[inline]
    pub fn area(self, Part { lines, bytes }: &Part) -> Rect {
        let cells = bytes.start >> self.bytes_log2..bytes.end >> self.bytes_log2;
        let (columns, rows) = if self.is_vertical { (lines, &cells) } else { (&cells, lines) };
        let first = |at: usize, log2: u32| size_i32(saturate_u32((at as u64) << log2));
        let [left, right] = [columns.start, columns.end].map(|column| first(column, self.columns_log2));
        let [top, bottom] = [rows.start, rows.end].map(|row| first(row, self.rows_log2));
        Rect::new(left, top, right, bottom)
    }

    /// How many lines, and how many bytes in them, are the fewest that hold whole tiles of
    /// `columns` × `rows` pixels; 0 is 1.
    pub fn tile(self, columns: u32, rows: u32) -> [usize; 2] {
        // The least common multiple of a size and a power of two, counted in that power.
        let cells = |pixels: u32, log2: u32| {
            let pixels = pixels.max(1);
            count((pixels >> pixels.trailing_zeros().min(log2)).into())
        };
        let (columns, rows) = (cells(columns, self.columns_log2), cells(rows, self.rows_log2));
        let [lines, cells] = if self.is_vertical { [columns, rows] } else { [rows, columns] };
        [lines, cells.saturating_mul(self.cell_bytes())]
    }
}

/// How many lines a plane has, and how many bytes a line; none where there are no pixels.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent {
    pub lines: usize,
    pub line_bytes: usize,
}

impl Extent {
    pub fn of<C: PixelColor, L: Layout<C>, B>(frame: &Frame<C, L, B>) -> Self {
        let Size { width, height } = frame.size();
        if width == 0 || height == 0 {
            return Self { lines: 0, line_bytes: 0 };
        }
        let lines = count(L::SHAPE.lines(width, height) / u64::from(L::SHAPE.planes));
        Self { lines, line_bytes: L::SHAPE.stride(width, height) }
    }
}

/// The bytes of a frame, by plane and line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Picture<'f> {
    bytes: &'f [u8],
    stride: usize,
    pub planes: usize,
    /// In each plane.
    pub lines: usize,
    pub line_bytes: usize,
}

impl<'f> Picture<'f> {
    pub fn of<C: PixelColor, L: Layout<C>, B: AsRef<[u8]>>(frame: &'f Frame<C, L, B>) -> Self {
        let Memory { bytes, stride } = frame.memory_ref();
        let Extent { lines, line_bytes } = Extent::of(frame);
        Self { bytes, stride, planes: L::SHAPE.planes as usize, lines, line_bytes }
    }

    /// Every line of every plane: the plane, and the line in there.
    pub fn lines(self) -> impl Iterator<Item = (usize, usize)> {
        (0..self.planes).flat_map(move |plane| (0..self.lines).map(move |line| (plane, line)))
    }

    /// Bytes of a line.
    pub fn slice(self, plane: usize, line: usize, bytes: &Range<usize>) -> &'f [u8] {
        let start = (plane * self.lines + line) * self.stride;
        self.bytes.get(start + bytes.start..start + bytes.end).unwrap_or(&[])
    }

    /// Bytes of some lines of a plane in one piece, if nothing else lies between them.
    pub fn block(self, plane: usize, Part { lines, bytes }: &Part) -> Option<&'f [u8]> {
        let is_whole = bytes.end - bytes.start == self.stride;
        let last = lines.end.checked_sub(1).filter(|&last| is_whole || last == lines.start)?;
        let first = (plane * self.lines + lines.start) * self.stride;
        self.bytes.get(first + bytes.start..(plane * self.lines + last) * self.stride + bytes.end)
    }
}
