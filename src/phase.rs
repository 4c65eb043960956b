//! What repeats along a row: colours and bits by the phase of their column, counted on the screen.

use crate::num::{count_i32, index};

/// The one of `N` repeating colours that a column has.
#[inline]
pub(crate) fn phase<C: Copy, const N: usize>(colors: &[C; N], column: i32) -> Option<C> {
    colors.get(index(column.checked_rem_euclid(count_i32(N))?)).copied()
}

/// Colours that repeat from column `origin` on, as the given ones do from column 0 on.
#[inline]
pub(crate) fn turned<C: Copy, const N: usize>(colors: &[C; N], origin: i32) -> [C; N] {
    let (mut turned, mut column) = (*colors, 0_i32);
    for place in &mut turned {
        *place = phase(colors, column.wrapping_sub(origin)).unwrap_or(*place);
        column = column.wrapping_add(1);
    }
    turned
}

/// Repeating colours from a column on to the right.
#[inline]
pub(crate) fn repeated<C: Copy, const N: usize>(colors: &[C; N], column: i32) -> impl Iterator<Item = C> {
    let first = index(column.checked_rem_euclid(count_i32(N)).unwrap_or(0));
    colors.iter().copied().cycle().skip(first)
}

/// The colours of the columns 0 to 7, if eight columns hold the colours once or several times.
#[inline]
pub(crate) fn eight<C: Copy, const N: usize>(colors: &[C; N]) -> Option<[C; 8]> {
    if 8_usize.checked_rem(N) != Some(0) {
        return None;
    }
    let mut eight = [*colors.first()?; 8];
    for (place, color) in eight.iter_mut().zip(colors.iter().cycle()) {
        *place = *color;
    }
    Some(eight)
}

/// The bits of bytes without end, from the highest one on.
pub(crate) fn bits_of_bytes(next: impl FnMut() -> u8) -> impl Iterator<Item = bool> {
    core::iter::repeat_with(next).flat_map(bits_of)
}

/// The bits of a byte, from the highest one on.
#[inline]
pub(crate) fn bits_of(byte: u8) -> [bool; 8] {
    [7, 6, 5, 4, 3, 2, 1, 0].map(|bit| byte >> bit & 1 == 1)
}
