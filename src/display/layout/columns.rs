//! Columns of pixels, one after the other.

use core::{marker::PhantomData, ops::Range};

use embedded_graphics::pixelcolor::raw::RawU1;

use super::{BitRun, Layout, Memory, MsbFirst, Order, Shape, merge, phase, spread};
use crate::{num::low_index, target::Code};

/// Columns of pixels from the top, each padded to whole bytes: rows of a panel that is mounted on
/// its side, such as the UC8151 of the Badger 2040.
///
/// Runs along a row touch a byte a pixel here, so they cost what single pixels cost.
///
/// ```text
///            column 0        column 1
///            byte 0  byte 1  byte 2 …
///   row 0    bit 7            bit 7        MsbFirst; LsbFirst has bit 0 on top
///     ⋮        ⋮                ⋮
///   row 8            bit 7
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Columns<O = MsbFirst>(PhantomData<O>);

impl<C: Code<Raw = RawU1>, O: Order> Layout<C> for Columns<O> {
    const SHAPE: Shape = Shape { is_vertical: true, rows_per_line: 1, bits: 1, planes: 1 };

    fn fill(memory: Memory<&mut [u8]>, rows: Range<usize>, columns: Range<usize>, colors: [C; 8]) {
        let codes = colors.map(C::code);
        for (column, line) in columns.clone().zip(memory.lines(columns)) {
            let memory = Memory { stride: line.len(), bytes: line };
            BitRun::new::<O>(rows.clone()).fill_solid(memory, 0..1, spread(phase(codes, column)));
        }
    }

    fn fill_solid(memory: Memory<&mut [u8]>, rows: Range<usize>, columns: Range<usize>, color: C) {
        BitRun::new::<O>(rows).fill_solid(memory, columns, spread(color.code()));
    }

    fn write(memory: Memory<&mut [u8]>, row: usize, column: usize, colors: impl Iterator<Item = Option<C>>) {
        let mask = bit_of::<O>(row);
        let mut lines = memory.lines(column..usize::MAX);
        for color in colors {
            let Some(byte) = lines.next().and_then(|line| line.get_mut(row / 8)) else { return };
            if let Some(color) = color {
                merge(byte, mask, spread(color.code()));
            }
        }
    }

    fn read(memory: Memory<&[u8]>, row: usize, column: usize) -> Option<C> {
        let byte = memory.line(column)?.get(row / 8)?;
        Some(C::from_code(u8::from(byte & bit_of::<O>(row) != 0)))
    }
}

#[inline]
const fn bit_of<O: Order>(row: usize) -> u8 {
    let bit = low_index(row) % 8;
    if O::MSB_FIRST { 0x80 >> bit } else { 1 << bit }
}
