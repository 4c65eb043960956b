//! Kerning from the table `GPOS`: pair adjustment, of glyphs and of classes of glyphs.
//!
//! ```text
//!   script latn ──▶ feature kern ──▶ lookups ──▶ subtables: ╭ coverage ──▶ pairs of glyphs      (format 1)
//!                                    their sum   the first  ╰ coverage ──▶ classes × classes    (format 2)
//! ```
//!
//! Only how far the second glyph of a pair stands is read, without corrections for devices. Lookups that choose by what
//! stands around are left out.
//!
//! Microsoft, *OpenType specification*, chapters "GPOS" and "OpenType Layout Common Table Formats".

use super::read::{i16_at, range_of, search, table_at, u16_at, usize_at};

/// More lookups than any font has for kerning, and more subtables than any lookup: so that no font takes forever.
const MOST_LOOKUPS: usize = 32;
const MOST_SUBTABLES: usize = 256;

/// Pair adjustment by the feature `kern`.
#[derive(Clone, Copy)]
pub(super) struct Pairs<'a> {
    /// The table of the feature: which lookups.
    feature: &'a [u8],
    /// The list of all lookups.
    lookups: &'a [u8],
}

impl<'a> Pairs<'a> {
    /// The feature of the Latin script, or of the default one, or of the first.
    pub(super) fn parse(gpos: &'a [u8]) -> Option<Self> {
        let (scripts, features, lookups) = (table_at(gpos, 4)?, table_at(gpos, 6)?, table_at(gpos, 8)?);
        let script =
            tagged(scripts, *b"latn").or_else(|| tagged(scripts, *b"DFLT")).or_else(|| table_at(scripts, 6))?;
        let language = table_at(script, 0)?;
        let mut indices = (0..usize_at(language, 4)?).map_while(|place| usize_at(language, 6 + 2 * place));
        let feature = indices.find_map(|index| {
            let record = 2 + 6 * index;
            let is_kern = features.get(record..)?.starts_with(b"kern");
            is_kern.then(|| table_at(features, record + 4)).flatten()
        })?;
        Some(Self { feature, lookups })
    }

    /// How much farther the right one of two glyphs stands.
    pub(super) fn kerning(&self, left: u16, right: u16) -> i32 {
        let count = usize_at(self.feature, 2).unwrap_or(0).min(MOST_LOOKUPS);
        let indices = (0..count).map_while(|place| usize_at(self.feature, 4 + 2 * place));
        let lookups = indices.filter_map(|index| table_at(self.lookups, 2 + 2 * index));
        lookups.filter_map(|lookup| by_lookup(lookup, left, right)).map(i32::from).sum()
    }
}

/// The table of a list of records that has a tag.
fn tagged(list: &[u8], tag: [u8; 4]) -> Option<&[u8]> {
    let mut records = (0..usize_at(list, 0)?).map(|place| 2 + 6 * place);
    let record = records.find(|record| list.get(*record..).is_some_and(|bytes| bytes.starts_with(&tag)))?;
    table_at(list, record + 4)
}

/// By the first subtable that knows the pair.
fn by_lookup(lookup: &[u8], left: u16, right: u16) -> Option<i16> {
    let (kind, count) = (u16_at(lookup, 0)?, usize_at(lookup, 4)?.min(MOST_SUBTABLES));
    let mut subtables = (0..count).filter_map(|place| table_at(lookup, 6 + 2 * place));
    subtables.find_map(|table| match kind {
        2 => by_subtable(table, left, right),
        9 if u16_at(table, 2)? == 2 => by_subtable(extended(table)?, left, right),
        _ => None,
    })
}

/// The table that an extension stands for: its offset has 32 bits.
fn extended(table: &[u8]) -> Option<&[u8]> {
    let offset = u32::from_be_bytes(*table.get(4..)?.first_chunk()?);
    table.get(usize::try_from(offset).ok()?..)
}

fn by_subtable(table: &[u8], left: u16, right: u16) -> Option<i16> {
    let covered = covered(table_at(table, 2)?, left)?;
    let formats = [u16_at(table, 4)?, u16_at(table, 6)?];
    let sizes = formats.map(value_size);
    match u16_at(table, 0)? {
        1 => {
            let pairs = table_at(table, 10 + 2 * covered)?;
            let size = 2 + sizes[0] + sizes[1];
            let record = search(usize_at(pairs, 0)?, |record| Some(u16_at(pairs, 2 + size * record)?.cmp(&right)))?;
            advance(pairs, 2 + size * record + 2, formats[0])
        }
        2 => {
            let [first, second] = [(8, left), (10, right)].map(|(at, glyph)| class(table_at(table, at), glyph));
            let (rows, columns) = (usize_at(table, 12)?, usize_at(table, 14)?);
            let is_inside = first < rows && second < columns;
            let place = first.saturating_mul(columns).saturating_add(second);
            let at = place.saturating_mul(sizes[0] + sizes[1]).saturating_add(16);
            is_inside.then(|| advance(table, at, formats[0])).flatten()
        }
        _ => None,
    }
}

/// How many bytes a value of this format has: two for each bit.
const fn value_size(format: u16) -> usize {
    2 * (format & 0xFF).count_ones() as usize
}

/// The change of the advance, behind those of the place.
fn advance(table: &[u8], value: usize, format: u16) -> Option<i16> {
    if format & 4 == 0 { Some(0) } else { i16_at(table, value.saturating_add(value_size(format & 3))) }
}

/// Which one a glyph is among those that are covered.
fn covered(coverage: &[u8], glyph: u16) -> Option<usize> {
    let count = usize_at(coverage, 2)?;
    match u16_at(coverage, 0)? {
        1 => search(count, |record| Some(u16_at(coverage, 4 + 2 * record)?.cmp(&glyph))),
        2 => {
            let (first, index) = range_of(coverage, (4, count), glyph)?;
            Some(usize::from(index) + usize::from(glyph.saturating_sub(first)))
        }
        _ => None,
    }
}

/// The class of a glyph; those that are not listed have 0.
fn class(classes: Option<&[u8]>, glyph: u16) -> usize {
    let listed = || {
        let classes = classes?;
        match u16_at(classes, 0)? {
            1 => {
                let place = usize::from(glyph.checked_sub(u16_at(classes, 2)?)?);
                if place < usize_at(classes, 4)? { usize_at(classes, 6 + 2 * place) } else { None }
            }
            2 => range_of(classes, (4, usize_at(classes, 2)?), glyph).map(|(_, class)| usize::from(class)),
            _ => None,
        }
    };
    listed().unwrap_or(0)
}
