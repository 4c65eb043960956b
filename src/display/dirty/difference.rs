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
fn first_difference(old: &[u8], new: &[u8]) -> Option<usize> {
    let mut words = zip(old.chunks_exact(WORD), new.chunks_exact(WORD)).map(change);
    if let Some((word, change)) = (0..).zip(&mut words).find(|&(_, change)| change != 0) {
        // In little-endian words the first byte is in the lowest bits.
        return Some(WORD * word + change.trailing_zeros() as usize / 8);
    }
    let behind = old.len() - old.len() % WORD;
    let mut rest = zip(old.get(behind..)?, new.get(behind..)?);
    rest.position(|(old, new)| old != new).map(|at| behind + at)
}

#[inline]
fn last_difference(old: &[u8], new: &[u8]) -> Option<usize> {
    let behind = old.len() - old.len() % WORD;
    if let Some(at) = zip(old.get(behind..)?, new.get(behind..)?).rposition(|(old, new)| old != new) {
        return Some(behind + at);
    }
    let mut words = zip(old.chunks_exact(WORD), new.chunks_exact(WORD)).map(change).enumerate();
    let (word, change) = words.rfind(|&(_, change)| change != 0)?;
    Some(WORD * word + (WORD - 1) - change.leading_zeros() as usize / 8)
}

/// The bits that are different in a word of bytes, the first byte in the lowest.
#[inline]
fn change((old, new): (&[u8], &[u8])) -> usize {
    let word = |bytes: &[u8]| bytes.try_into().map_or(0, usize::from_le_bytes);
    word(old) ^ word(new)
}
