//! Where two lines of bytes differ: the first and the last place, by words from either end.

use core::{iter::zip, ops::RangeInclusive};

/// Bytes that are compared at once.
const WORD: usize = size_of::<usize>();

/// From the first byte that is different in two slices of one length to the last.
///
/// ```text
///   old   0 1 2 3 4 5 6 7
///   new   0 1 9 3 9 5 6 7     2 ..= 4
/// ```
#[inline]
pub(super) fn difference(old: &[u8], new: &[u8]) -> Option<RangeInclusive<usize>> {
    let first = first_difference(old, new)?;
    Some(first..=last_difference(old, new).unwrap_or(first))
}

#[inline]
fn first_difference(mut old: &[u8], mut new: &[u8]) -> Option<usize> {
    let mut before = 0;
    while let (Some((a, rest)), Some((b, new_rest))) = (old.split_first_chunk(), new.split_first_chunk()) {
        let change = change(*a, *b);
        if change != 0 {
            // In little-endian words the first byte is in the lowest bits.
            return Some(before + change.trailing_zeros() as usize / 8);
        }
        (old, new, before) = (rest, new_rest, before + WORD);
    }
    zip(old, new).position(|(old, new)| old != new).map(|at| before + at)
}

#[inline]
fn last_difference(mut old: &[u8], mut new: &[u8]) -> Option<usize> {
    while let (Some((rest, a)), Some((new_rest, b))) = (old.split_last_chunk(), new.split_last_chunk()) {
        let change = change(*a, *b);
        if change != 0 {
            return Some(rest.len() + (WORD - 1) - change.leading_zeros() as usize / 8);
        }
        (old, new) = (rest, new_rest);
    }
    zip(old, new).rposition(|(old, new)| old != new)
}

/// The bits that are different in a word of bytes, the first byte in the lowest.
#[inline]
fn change(old: [u8; WORD], new: [u8; WORD]) -> usize {
    usize::from_le_bytes(old) ^ usize::from_le_bytes(new)
}
