//! Pages of eight rows.

use core::{marker::PhantomData, ops::Range};

use embedded_graphics::pixelcolor::raw::RawU1;

use super::{Layout, LsbFirst, Memory, Order, Shape, merge, spread};
use crate::{num::low_index, target::Code};

/// Pages of eight rows: a byte is eight pixels one above the other; bytes run along x.
///
/// ```text
///           byte 0  byte 1  byte 2
///   bit 0     ·       ·       ·      row 0     LsbFirst: the usual order;
///     ⋮       ⋮       ⋮       ⋮        ⋮       MsbFirst has bit 7 on top
///   bit 7     ·       ·       ·      row 7
///           x = 0     1       2
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pages<O = LsbFirst>(PhantomData<O>);

impl<C: Code<Raw = RawU1>, O: Order> Layout<C> for Pages<O> {
    const SHAPE: Shape = Shape { is_vertical: false, rows_per_line: 8, bits: 1, planes: 1 };

    #[inline]
    fn fill(memory: Memory<&mut [u8]>, rows: Range<usize>, columns: Range<usize>, colors: [C; 8]) {
        let mut values = colors.map(|color| spread(color.code()));
        if values == [values[0]; 8] {
            fill_area::<O>(memory, rows, columns, values[0]);
            return;
        }
        values.rotate_left(columns.start & 7);
        each_page::<O>(memory, rows, columns, |bytes, mask| fill_pattern(bytes, mask, values));
    }

    #[inline]
    fn fill_solid(memory: Memory<&mut [u8]>, rows: Range<usize>, columns: Range<usize>, color: C) {
        if rows.end.wrapping_sub(rows.start) == 1 {
            fill_row::<O>(memory, rows.start, columns, spread(color.code()));
        } else {
            fill_area::<O>(memory, rows, columns, spread(color.code()));
        }
    }

    fn fill_tile(memory: Memory<&mut [u8]>, rows: Range<usize>, columns: Range<usize>, tile: &[[C; 8]; 8]) {
        // The eight rows of the tile are one page.
        let mut values = [0; 8];
        for (row, colors) in tile.iter().enumerate() {
            for (value, color) in values.iter_mut().zip(colors) {
                *value |= spread(color.code()) & bit_of::<O>(row);
            }
        }
        values.rotate_left(columns.start & 7);
        each_page::<O>(memory, rows, columns, |bytes, mask| fill_pattern(bytes, mask, values));
    }

    #[inline]
    fn write(memory: Memory<&mut [u8]>, row: usize, column: usize, colors: impl Iterator<Item = Option<C>>) {
        let Some(window) = memory.line(row / 8).and_then(|line| line.get_mut(column..)) else { return };
        let mask = bit_of::<O>(row);
        let mut bytes = window.iter_mut();
        for color in colors {
            let Some(byte) = bytes.next() else { return };
            if let Some(color) = color {
                merge(byte, mask, spread(color.code()));
            }
        }
    }

    #[inline]
    fn set(memory: Memory<&mut [u8]>, row: usize, column: usize, color: C) {
        if let Some(byte) = memory.byte(row / 8, column) {
            merge(byte, bit_of::<O>(row), spread(color.code()));
        }
    }

    #[inline]
    fn read(memory: Memory<&[u8]>, row: usize, column: usize) -> Option<C> {
        let byte = memory.line(row / 8)?.get(column)?;
        Some(C::from_code(u8::from(byte & bit_of::<O>(row) != 0)))
    }
}

/// Fills a run of one row with ones or zeros.
#[inline]
fn fill_row<O: Order>(memory: Memory<&mut [u8]>, row: usize, columns: Range<usize>, value: u8) {
    if let Some((bytes, _)) = memory.from(row / 8, columns.start) {
        let run = bytes.get_mut(..columns.end.wrapping_sub(columns.start));
        fill_page(run.unwrap_or_default(), bit_of::<O>(row), value);
    }
}

/// Fills several rows; out of the way of spans, which are one row each.
#[inline(never)]
fn fill_area<O: Order>(memory: Memory<&mut [u8]>, rows: Range<usize>, columns: Range<usize>, value: u8) {
    let is_whole = rows.start.is_multiple_of(8) && rows.end.is_multiple_of(8) && columns == (0..memory.stride);
    if is_whole {
        // Whole pages without gaps: one block.
        let block = rows.start / 8 * memory.stride..rows.end / 8 * memory.stride;
        memory.bytes.get_mut(block).unwrap_or_default().fill(value);
    } else if columns.end.wrapping_sub(columns.start) == 1 {
        each_page::<O>(memory, rows, columns, |bytes, mask| {
            if let [byte, ..] = bytes {
                merge(byte, mask, value);
            }
        });
    } else {
        each_page::<O>(memory, rows, columns, |bytes, mask| fill_page(bytes, mask, value));
    }
}

/// Calls `fill` with the bytes of an area in each page that it touches, and with the bits of its rows there.
#[inline]
fn each_page<O: Order>(
    memory: Memory<&mut [u8]>,
    rows: Range<usize>,
    columns: Range<usize>,
    mut fill: impl FnMut(&mut [u8], u8),
) {
    let (first, last) = (rows.start / 8, rows.end.wrapping_sub(1) / 8);
    let Some((bytes, stride)) = memory.from(first, columns.start) else { return };
    let (above, below) = (bits_of::<O>(rows.start % 8..8), bits_of::<O>(0..rows.end.wrapping_sub(1) % 8 + 1));
    let width = columns.end.wrapping_sub(columns.start);
    for (page, line) in (first..last.wrapping_add(1)).zip(bytes.chunks_mut(stride)) {
        let mut mask = if page == first { above } else { 0xFF };
        if page == last {
            mask &= below;
        }
        fill(line.get_mut(..width).unwrap_or_default(), mask);
    }
}

/// A run of bytes of a page: in each the selected bits become those of eight that repeat.
#[inline]
fn fill_pattern(bytes: &mut [u8], mask: u8, eight: [u8; 8]) {
    let keep = u64::from_ne_bytes([!mask; 8]);
    let value = u64::from_ne_bytes(eight) & !keep;
    let mut words = bytes.chunks_exact_mut(8);
    for word in &mut words {
        let old = word.first_chunk().map_or(0, |bytes| u64::from_ne_bytes(*bytes));
        word.copy_from_slice(&(old & keep | value).to_ne_bytes());
    }
    for (byte, value) in words.into_remainder().iter_mut().zip(eight) {
        merge(byte, mask, value);
    }
}

/// The bits of some rows of a page, counted from its top.
#[inline]
const fn bits_of<O: Order>(rows: Range<usize>) -> u8 {
    let (above, below) = (low_index(rows.start) % 8, low_index(8_usize.wrapping_sub(rows.end)) % 8);
    if O::MSB_FIRST { (0xFF >> above) & (0xFF << below) } else { (0xFF << above) & (0xFF >> below) }
}

/// The bit of a row in its page.
#[inline]
const fn bit_of<O: Order>(row: usize) -> u8 {
    if O::MSB_FIRST { 0x80 >> (low_index(row) % 8) } else { 1 << (low_index(row) % 8) }
}

/// A run of bytes of a page: in each the selected bits become those of `value`, all ones or zeros.
#[inline]
fn fill_page(bytes: &mut [u8], mask: u8, value: u8) {
    match (mask, value) {
        (0xFF, _) => bytes.fill(value),
        (_, 0) => {
            for byte in bytes {
                *byte &= !mask;
            }
        }
        _ => {
            for byte in bytes {
                *byte |= mask;
            }
        }
    }
}
