//! Numbers in the tables of a font: big-endian, and perhaps not there.

use core::cmp::Ordering;

/// The number at so many bytes.
pub(super) fn u16_at(table: &[u8], at: usize) -> Option<u16> {
    let bytes = table.get(at..)?.first_chunk()?;
    Some(u16::from_be_bytes(*bytes))
}

/// The same with a sign.
pub(super) fn i16_at(table: &[u8], at: usize) -> Option<i16> {
    u16_at(table, at).map(u16::cast_signed)
}

/// An index or an offset.
pub(super) fn usize_at(table: &[u8], at: usize) -> Option<usize> {
    u16_at(table, at).map(usize::from)
}

/// The table whose offset stands at so many bytes. An offset of zero is no table.
pub(super) fn table_at(table: &[u8], at: usize) -> Option<&[u8]> {
    let offset = usize_at(table, at).filter(|offset| *offset > 0)?;
    table.get(offset..)
}

/// The one of `count` sorted records that is neither before nor behind what is sought.
pub(super) fn search(count: usize, compare: impl Fn(usize) -> Option<Ordering>) -> Option<usize> {
    let (mut first, mut end) = (0, count);
    while first < end {
        let middle = usize::midpoint(first, end);
        match compare(middle)? {
            Ordering::Equal => return Some(middle),
            Ordering::Less => first = middle + 1,
            Ordering::Greater => end = middle,
        }
    }
    None
}

/// The one of sorted ranges, of six bytes each from an offset on, that holds a glyph: its first glyph, and what belongs to it.
pub(super) fn range_of(table: &[u8], (from, count): (usize, usize), glyph: u16) -> Option<(u16, u16)> {
    let place = |record: usize| from + 6 * record;
    let found = search(count, |record| {
        let (first, last) = (u16_at(table, place(record))?, u16_at(table, place(record) + 2)?);
        Some(if last < glyph {
            Ordering::Less
        } else if first > glyph {
            Ordering::Greater
        } else {
            Ordering::Equal
        })
    })?;
    Some((u16_at(table, place(found))?, u16_at(table, place(found) + 4)?))
}
