//! Pages of eight rows.

use core::{marker::PhantomData, ops::Range};

use embedded_graphics::pixelcolor::raw::RawU1;

use super::{Layout, LsbFirst, Memory, Order, Shape, merge, phase, spread};
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
    fn fill(memory: Memory<&mut [u8]>, rows: Range<usize>, columns: Range<usize>, codes: [u8; 4]) {
        let pages = rows.start / 8..rows.end.div_ceil(8);
        let values = codes.map(spread);
        let is_whole = rows.start.is_multiple_of(8) && rows.end.is_multiple_of(8) && columns == (0..memory.stride);
        // Whole pages without gaps, all bytes alike: one block.
        if is_whole && values == [values[0]; 4] {
            let block = memory.bytes.get_mut(pages.start * memory.stride..pages.end * memory.stride);
            block.unwrap_or_default().fill(values[0]);
            return;
        }
        for (page, line) in pages.clone().zip(memory.lines(pages)) {
            let top = 8 * page;
            let mask = bits_of::<O>(rows.start.max(top) - top..rows.end.min(top + 8) - top);
            if let Some(window) = line.get_mut(columns.clone()) {
                fill_page(window, columns.start, (mask, codes));
            }
        }
    }

    #[inline]
    fn write(memory: Memory<&mut [u8]>, row: usize, column: usize, codes: impl Iterator<Item = Option<u8>>) {
        let Some(window) = memory.line(row / 8).and_then(|line| line.get_mut(column..)) else { return };
        let mask = bits_of::<O>(row % 8..row % 8 + 1);
        let mut bytes = window.iter_mut();
        for code in codes {
            let Some(byte) = bytes.next() else { return };
            if let Some(code) = code {
                merge(byte, mask, spread(code));
            }
        }
    }

    #[inline]
    fn set(memory: Memory<&mut [u8]>, row: usize, column: usize, code: u8) {
        if let Some(byte) = memory.byte(row / 8, column) {
            merge(byte, bits_of::<O>(row % 8..row % 8 + 1), spread(code));
        }
    }

    fn read(memory: Memory<&[u8]>, row: usize, column: usize) -> Option<u8> {
        let mask = bits_of::<O>(row % 8..row % 8 + 1);
        memory.line(row / 8)?.get(column).map(|byte| u8::from(byte & mask != 0))
    }
}

/// The bits of some rows of a page, counted from its top.
#[inline]
const fn bits_of<O: Order>(rows: Range<usize>) -> u8 {
    let (above, below) = (low_index(rows.start) % 8, low_index(8_usize.wrapping_sub(rows.end)) % 8);
    if O::MSB_FIRST { (0xFF >> above) & (0xFF << below) } else { (0xFF << above) & (0xFF >> below) }
}

/// A run of bytes of a page: in each the selected bits become those of its column.
#[inline]
fn fill_page(window: &mut [u8], first: usize, (mask, codes): (u8, [u8; 4])) {
    match codes.map(spread) {
        values @ ([0, 0, 0, 0] | [0xFF, 0xFF, 0xFF, 0xFF]) if mask == 0xFF => window.fill(values[0]),
        [0, 0, 0, 0] => window.iter_mut().for_each(|byte| *byte &= !mask),
        [0xFF, 0xFF, 0xFF, 0xFF] => window.iter_mut().for_each(|byte| *byte |= mask),
        values => {
            for (column, byte) in (first..).zip(window) {
                merge(byte, mask, phase(values, column));
            }
        }
    }
}
