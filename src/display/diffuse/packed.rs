//! The short way into frames of one bit a pixel: codes that were gathered to words are not taken apart again.

use embedded_graphics::{geometry::Point, pixelcolor::raw::RawU1};

use super::row::Words;
use crate::{
    display::{
        dither::PackedRows,
        frame::Frame,
        layout::{Layout, Memory},
    },
    num::{count_i32, index, low_index},
    target::{Code, Target},
};

/// Words that are merged into the bytes of a frame.
#[derive(Debug)]
pub(super) struct IntoBytes<'f, C, L, B> {
    pub(super) frame: &'f mut Frame<C, L, B>,
    pub(super) at: Point,
}

impl<C, L, B> Words for IntoBytes<'_, C, L, B>
where
    C: Code<Raw = RawU1>,
    L: PackedRows + Layout<C>,
    B: AsMut<[u8]>,
{
    const BITS: u32 = 1;
    type Error = core::convert::Infallible;

    fn write(&mut self, start: usize, word: u64, length: u32) -> Result<(), Self::Error> {
        let left = self.at.x.saturating_add(count_i32(start));
        let columns = left..left.saturating_add_unsigned(length);
        let Some(visible) = self.frame.bounds().clip_run(self.at.y, columns) else { return Ok(()) };
        let word = word << (visible.start.abs_diff(left) & 63);
        let mask = u64::MAX << (64_u32.saturating_sub(visible.start.abs_diff(visible.end)) & 63);
        let (column, Memory { bytes, stride }) = (index(visible.start), self.frame.memory_mut());
        let bytes = bytes.get_mut(index(self.at.y).wrapping_mul(stride).wrapping_add(column / 8)..);
        let word = if L::IS_INVERTED { !word } else { word };
        merge::<L>(bytes.unwrap_or_default(), word, mask, low_index(column) % 8);
        Ok(())
    }
}

/// Puts the masked bits of a word into bytes, the highest of them behind some bits that stay.
fn merge<L: PackedRows>(bytes: &mut [u8], word: u64, mask: u64, before: u32) {
    let mut bytes = bytes.iter_mut();
    let put = |byte: &mut u8, value: u8, mask: u8| {
        let (value, mask) = if L::MSB_FIRST { (value, mask) } else { (value.reverse_bits(), mask.reverse_bits()) };
        *byte ^= (*byte ^ value) & mask;
    };
    let eight = (word >> before).to_be_bytes().into_iter().zip((mask >> before).to_be_bytes());
    for ((value, mask), byte) in eight.zip(bytes.by_ref()) {
        put(byte, value, mask);
    }
    // What was shifted out.
    if let (1.., Some(byte)) = (before, bytes.next()) {
        let [value, ..] = (word << (64 - before)).to_be_bytes();
        let [mask, ..] = (mask << (64 - before)).to_be_bytes();
        put(byte, value, mask);
    }
}
