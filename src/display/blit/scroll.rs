//! A whole picture moved within its own memory.

use core::iter::from_fn;

use embedded_graphics::{geometry::Point, pixelcolor::raw::RawU1};

use super::{Geometry, Part, pages::Page, rows::Strip};
use crate::{
    display::frame::TooSmall,
    num::{index, low_u8},
    space::Rect,
    target::Code,
};

/// Moves a picture in rows by whole pixels; what comes in at the other side is `color`.
///
/// ```
/// use aquatint::display::blit::{Geometry, scroll_rows};
/// use embedded_graphics::{pixelcolor::BinaryColor, prelude::Point};
///
/// let mut rows = [0b1000_0001, 0b1100_0000];
/// scroll_rows(&mut rows, Geometry::rows::<BinaryColor>(8, 2), Point::new(1, -1), BinaryColor::On)?;
/// assert_eq!(rows, [0b1110_0000, 0b1111_1111]);
/// # Ok::<(), aquatint::TooSmall>(())
/// ```
///
/// # Errors
/// [`TooSmall`], and nothing is moved.
pub fn scroll_rows<C: Code>(bytes: &mut [u8], geometry: Geometry, by: Point, color: C) -> Result<(), TooSmall> {
    geometry.check_rows(bytes.len(), C::BITS)?;
    let mut strips = Lines { bytes, stride: geometry.stride.max(1) };
    let kept = Part::new(Rect::of_size(geometry.size), geometry.size, by);
    if let Some(kept) = &kept {
        for strip in ordered(kept.run(C::BITS).strips((strips.stride, strips.stride)), by.x > 0) {
            strips.shift(strip, kept, by.y > 0);
        }
    }
    let fill = (0..8).step_by(C::BITS as usize).fold(0, |fill, shift| fill | color.code() << shift);
    for part in vacated(geometry, kept) {
        let run = part.run(C::BITS);
        for strip in run.strips((strips.stride, strips.stride)) {
            strips.fill(strip, &part, fill);
        }
    }
    Ok(())
}

/// Moves a picture in pages by whole pixels; what comes in at the other side is `color`.
///
/// ```
/// use aquatint::display::blit::{Geometry, scroll_pages};
/// use embedded_graphics::{pixelcolor::BinaryColor, prelude::Point};
///
/// // Three columns of 16 pixels, two of them down.
/// let mut pages = [0x80, 0, 0, 0x01, 0, 0];
/// scroll_pages(&mut pages, Geometry::pages(3, 16), Point::new(1, 2), BinaryColor::Off)?;
/// assert_eq!(pages, [0, 0, 0, 0, 0b110, 0]);
/// # Ok::<(), aquatint::TooSmall>(())
/// ```
///
/// # Errors
/// [`TooSmall`], and nothing is moved.
pub fn scroll_pages<C>(bytes: &mut [u8], geometry: Geometry, by: Point, color: C) -> Result<(), TooSmall>
where
    C: Code<Raw = RawU1>,
{
    geometry.check_pages(bytes.len())?;
    let kept = Part::new(Rect::of_size(geometry.size), geometry.size, by);
    if let Some(kept) = &kept {
        for page in ordered(kept.pages(), by.y > 0) {
            shift_page(bytes, geometry.stride, &page, by.x > 0);
        }
    }
    let fill = if color.code() & 1 == 0 { 0 } else { 0xFF };
    for part in vacated(geometry, kept) {
        for page in part.pages() {
            let inside = page.inside();
            page.bytes(bytes, geometry.stride).iter_mut().for_each(|byte| *byte ^= (*byte ^ fill) & inside);
        }
    }
    Ok(())
}

/// From the beginning or from the end: in the order in which nothing is overwritten before it was
/// read. What moves to the right begins at the right, what moves down begins below.
fn ordered<I: DoubleEndedIterator>(mut items: I, from_end: bool) -> impl Iterator<Item = I::Item> {
    from_fn(move || if from_end { items.next_back() } else { items.next() })
}

/// The picture around what was kept: above, below, left and right of it.
fn vacated(geometry: Geometry, kept: Option<Part>) -> impl Iterator<Item = Part> {
    let whole = Rect::of_size(geometry.size);
    let kept = kept.map_or(Rect::default(), |kept| kept.area);
    let areas = [
        Rect { bottom: kept.top, ..whole },
        Rect { top: kept.bottom, ..whole },
        Rect { left: whole.left, right: kept.left, ..kept },
        Rect { left: kept.right, right: whole.right, ..kept },
    ];
    let part = |area: Rect| Part { area, column: index(area.left), row: index(area.top) };
    areas.into_iter().filter(|area| !area.is_empty()).map(part)
}

/// Rows in memory.
struct Lines<'b> {
    bytes: &'b mut [u8],
    stride: usize,
}

impl Lines<'_> {
    fn line(&mut self, row: usize) -> &mut [u8] {
        let start = row * self.stride;
        self.bytes.get_mut(start..start + self.stride).unwrap_or_default()
    }

    /// Moves the bits of a strip to where they are kept.
    fn shift(&mut self, strip: Strip, kept: &Part, from_below: bool) {
        let (top, bottom) = (index(kept.area.top), index(kept.area.bottom));
        for row in ordered(0..bottom - top, from_below) {
            let new = strip.word(self.line(kept.row + row));
            strip.change(self.line(top + row), |old| old ^ new);
        }
    }

    fn fill(&mut self, strip: Strip, part: &Part, fill: u8) {
        let fill = usize::from_ne_bytes([fill; size_of::<usize>()]);
        for row in index(part.area.top)..index(part.area.bottom) {
            strip.change(self.line(row), |old| old ^ fill);
        }
    }
}

/// Moves what is kept to one page.
fn shift_page(bytes: &mut [u8], stride: usize, page: &Page, from_right: bool) {
    let (upper, above) = (page.row / 8 * stride + page.column, page.row % 8);
    let target = page.index * stride + page.columns.start;
    let inside = page.inside();
    for column in ordered(0..page.columns.len(), from_right) {
        // Rows of a page that is not there are not meant.
        let byte = |page: usize| bytes.get(page + column).copied().unwrap_or(0);
        let pair = u32::from(u16::from_le_bytes([byte(upper), byte(upper + stride)]));
        let new = low_u8(pair >> above << page.below & 0xFF);
        if let Some(byte) = bytes.get_mut(target + column) {
            *byte ^= (*byte ^ new) & inside;
        }
    }
}
