//! Two pictures of one bit each, one behind the other.

use core::{marker::PhantomData, ops::Range};

use embedded_graphics::pixelcolor::raw::RawU2;

use super::{BitRun, Layout, Memory, MsbFirst, Order, Shape, merge, spread};
use crate::{num::low_index, target::Code};

/// Rows of the low bits of all codes, then rows of the high bits: e-paper of four greys or of three
/// colours, whose controllers keep two memories of one bit a pixel.
///
/// [`Frame::plane`](crate::Frame::plane) gives the bytes of either: plane 0 the low bits, plane 1 the high
/// ones. The colours are [`ThreeColor`](crate::ThreeColor) and `Gray2`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Planes<O = MsbFirst>(PhantomData<O>);

impl<C: Code<Raw = RawU2>, O: Order> Layout<C> for Planes<O> {
    const SHAPE: Shape = Shape { is_vertical: false, rows_per_line: 1, bits: 1, planes: 2 };

    fn fill(memory: Memory<&mut [u8]>, rows: Range<usize>, columns: Range<usize>, colors: [C; 8]) {
        let (low, high) = halves(memory);
        for (plane, shift) in [(low, 0), (high, 1)] {
            let value = join::<O>(colors.map(|color| color.code() >> shift));
            BitRun::new::<O>(columns.clone()).fill_solid(plane, rows.clone(), value);
        }
    }

    fn write(memory: Memory<&mut [u8]>, row: usize, column: usize, colors: impl Iterator<Item = Option<C>>) {
        let (low, high) = halves(memory);
        let (Some(low), Some(high)) = (low.line(row), high.line(row)) else { return };
        for (column, color) in (column..).zip(colors) {
            let (Some(low), Some(high)) = (low.get_mut(column / 8), high.get_mut(column / 8)) else { return };
            if let Some(color) = color {
                merge(low, bit_of::<O>(column), spread(color.code()));
                merge(high, bit_of::<O>(column), spread(color.code() >> 1));
            }
        }
    }

    fn read(memory: Memory<&[u8]>, row: usize, column: usize) -> Option<C> {
        let Memory { bytes, stride } = memory;
        let (low, high) = bytes.split_at_checked(bytes.len() / 2)?;
        let bit = |bytes| read_bit::<O>(Memory { bytes, stride }, row, column);
        Some(C::from_code(bit(low)? | (bit(high)? << 1)))
    }
}

/// A pixel's bit of one plane.
fn read_bit<O: Order>(plane: Memory<&[u8]>, row: usize, column: usize) -> Option<u8> {
    plane.line(row)?.get(column / 8).map(|byte| u8::from(byte & bit_of::<O>(column) != 0))
}

/// The two planes.
fn halves(memory: Memory<&mut [u8]>) -> (Memory<&mut [u8]>, Memory<&mut [u8]>) {
    let Memory { bytes, stride } = memory;
    let middle = bytes.len() / 2;
    let (low, high) = bytes.split_at_mut_checked(middle).unwrap_or_default();
    (Memory { bytes: low, stride }, Memory { bytes: high, stride })
}

/// The low bits of eight codes, in a byte.
fn join<O: Order>(codes: [u8; 8]) -> u8 {
    let push = |byte: u8, code: u8| (byte << 1) | (code & 1);
    if O::MSB_FIRST { codes.into_iter().fold(0, push) } else { codes.into_iter().rev().fold(0, push) }
}

#[inline]
const fn bit_of<O: Order>(column: usize) -> u8 {
    let bit = low_index(column) % 8;
    if O::MSB_FIRST { 0x80 >> bit } else { 1 << bit }
}
