//! Pixels of two bytes.

use core::{marker::PhantomData, ops::Range};

use embedded_graphics::pixelcolor::{
    PixelColor,
    raw::{RawData, RawU16},
};

use super::{Layout, Memory, MsbFirst, Order, Shape};

/// Rows of pixels of two bytes each: `Rgb565` and `Bgr565`.
///
/// `MsbFirst` has the high byte first, as colour panels take it; `LsbFirst` the low byte.
///
/// ```
/// use aquatint::{Frame, Words};
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
///
/// let mut tile = Frame::<Rgb565, Words, _>::with_array([0; 2 * 8 * 8], 8, 8).unwrap();
/// tile.clear(Rgb565::RED)?;
/// assert_eq!(tile.bytes()[..4], [0b1111_1000, 0, 0b1111_1000, 0]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Words<O = MsbFirst>(PhantomData<O>);

impl<C, O: Order> Layout<C> for Words<O>
where
    C: PixelColor<Raw = RawU16> + From<RawU16> + Into<RawU16>,
{
    const SHAPE: Shape = Shape { is_vertical: false, rows_per_line: 1, bits: 16, planes: 1 };

    fn fill(memory: Memory<&mut [u8]>, rows: Range<usize>, columns: Range<usize>, colors: [C; 8]) {
        // The eight of the run's first column and of those behind it.
        let mut eight = colors.map(bytes_of::<C, O>);
        eight.rotate_left(columns.start & 7);
        let (start, end) = (columns.start.wrapping_mul(2), columns.end.wrapping_mul(2));
        for line in memory.lines(rows) {
            let pixels = line.get_mut(start..end).unwrap_or_default().chunks_exact_mut(2);
            pixels.zip(eight.iter().cycle()).for_each(|(pixel, &color)| put(pixel, color));
        }
    }

    fn write(memory: Memory<&mut [u8]>, row: usize, column: usize, colors: impl Iterator<Item = Option<C>>) {
        let window = memory.line(row).and_then(|line| line.get_mut(column.wrapping_mul(2)..));
        let pixels = window.unwrap_or_default().chunks_exact_mut(2);
        for (pixel, color) in pixels.zip(colors) {
            if let Some(color) = color {
                put(pixel, bytes_of::<C, O>(color));
            }
        }
    }

    fn read(memory: Memory<&[u8]>, row: usize, column: usize) -> Option<C> {
        let bytes = *memory.line(row)?.get(column.wrapping_mul(2)..)?.first_chunk()?;
        let code = if O::MSB_FIRST { u16::from_be_bytes(bytes) } else { u16::from_le_bytes(bytes) };
        Some(RawU16::new(code).into())
    }
}

/// Writes the two bytes of a pixel. `copy_from_slice` would keep a panic.
#[inline]
fn put(pixel: &mut [u8], bytes: [u8; 2]) {
    if let [first, second] = pixel {
        [*first, *second] = bytes;
    }
}

/// The bytes of a colour in the order in which they are stored.
#[inline]
fn bytes_of<C: Into<RawU16>, O: Order>(color: C) -> [u8; 2] {
    let code = color.into().into_inner();
    if O::MSB_FIRST { code.to_be_bytes() } else { code.to_le_bytes() }
}
