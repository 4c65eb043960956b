//! A picture moved within its own memory.

use core::iter::from_fn;

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Point},
    image::GetPixel,
    pixelcolor::PixelColor,
};

use super::{
    op::Coded,
    packing::Way,
    pages::{Columns, Pages},
    part::{Job, clip},
    strip::{Run, change},
};
use crate::{
    display::{
        frame::Frame,
        layout::{Layout, Memory},
    },
    num::{low_index, size_i32},
    space::Rect,
};

impl<C, L, B> Frame<C, L, B>
where
    C: Coded,
    L: Layout<C>,
    B: AsRef<[u8]> + AsMut<[u8]>,
{
    /// Copies an area of the frame to another place in it, where its top left corner is `to`. They may
    /// overlap. What of the area is outside of the frame is cut off.
    ///
    /// ```
    /// use aquatint::{Frame, Rect, Rows};
    /// use embedded_graphics::{pixelcolor::BinaryColor, prelude::Point};
    ///
    /// let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0b1100_0000, 0], 8, 2)?;
    /// frame.copy_within(Rect::new(0, 0, 3, 1), Point::new(1, 1));
    /// assert_eq!(frame.bytes(), [0b1100_0000, 0b0110_0000]);
    /// # Ok::<(), aquatint::TooSmall>(())
    /// ```
    pub fn copy_within(&mut self, area: Rect, to: Point) {
        let bounds = Rect::of_size(self.size());
        let Some((area, to)) = clip(area.intersection(bounds), to, bounds) else { return };
        let (job, from) = (Job::new(area, to), Point::new(area.left, area.top));
        let (right, down) = (to.x > from.x, to.y > from.y);
        let memory = self.memory_mut();
        match const { Way::new(L::FACTS, L::FACTS) } {
            Way::Rows { msb_first: true } => move_lines::<true>(memory, &job, C::BITS, (right, down)),
            Way::Rows { msb_first: false } => move_lines::<false>(memory, &job, C::BITS, (right, down)),
            Way::Columns { msb_first: true } => move_lines::<true>(memory, &job.turned(), C::BITS, (down, right)),
            Way::Columns { msb_first: false } => move_lines::<false>(memory, &job.turned(), C::BITS, (down, right)),
            Way::Pages { msb_first } => move_pages(memory, (&job, msb_first), (right, down)),
            Way::Transposed { .. } | Way::Pixels => move_pixels(self, (from, to), &job, (right, down)),
        }
    }

    /// Moves what is in an area by so many pixels to the right and down, and gives what came in a colour.
    /// What leaves the area is lost; what is around it stays.
    ///
    /// ```
    /// use aquatint::{Frame, Rect, Rows};
    /// use embedded_graphics::{pixelcolor::BinaryColor, prelude::*};
    ///
    /// let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0b1000_0001, 0b1100_0000], 8, 2)?;
    /// frame.scroll(frame.bounding_box().into(), Point::new(1, -1), BinaryColor::On);
    /// assert_eq!(frame.bytes(), [0b1110_0000, 0b1111_1111]);
    /// frame.scroll(Rect::new(0, 0, 4, 2), Point::new(2, 0), BinaryColor::Off);
    /// assert_eq!(frame.bytes(), [0b0011_0000, 0b0011_1111]);
    /// # Ok::<(), aquatint::TooSmall>(())
    /// ```
    pub fn scroll(&mut self, area: Rect, by: Point, fill: C) {
        let area = area.intersection(Rect::of_size(self.size()));
        let moved = Rect {
            left: area.left.saturating_add(by.x),
            top: area.top.saturating_add(by.y),
            right: area.right.saturating_add(by.x),
            bottom: area.bottom.saturating_add(by.y),
        };
        let kept = moved.intersection(area);
        if !kept.is_empty() {
            let from = |kept: i32, by: i32| kept.saturating_sub(by);
            let source =
                Rect::new(from(kept.left, by.x), from(kept.top, by.y), from(kept.right, by.x), from(kept.bottom, by.y));
            self.copy_within(source, Point::new(kept.left, kept.top));
        }
        for vacated in around(area, kept) {
            let Ok(()) = self.fill_solid(&vacated.into(), fill);
        }
    }
}

/// The rest of an area around what was kept of it: above, below, left and right.
fn around(area: Rect, kept: Rect) -> [Rect; 4] {
    let kept = if kept.is_empty() { Rect { bottom: area.top, ..area } } else { kept };
    [
        Rect { bottom: kept.top, ..area },
        Rect { top: kept.bottom, ..area },
        Rect { left: area.left, right: kept.left, ..kept },
        Rect { left: kept.right, right: area.right, ..kept },
    ]
}

/// From the beginning or from the end: in the order in which nothing is overwritten before it was
/// read. What moves to the right begins at the right, what moves down begins below.
fn ordered<I: DoubleEndedIterator>(mut items: I, from_end: bool) -> impl Iterator<Item = I::Item> {
    from_fn(move || if from_end { items.next_back() } else { items.next() })
}

/// Moves runs of lines.
fn move_lines<const MSB: bool>(memory: Memory<&mut [u8]>, job: &Job, bits: u32, (right, down): (bool, bool)) {
    let Memory { bytes, stride } = memory;
    for strip in ordered(Run::new(job, bits).strips::<MSB>(), right) {
        for row in ordered(0..job.height, down) {
            let new = strip.word(bytes, (job.from.1 + row) * stride + strip.source);
            strip.merge(bytes, (job.to.1 + row) * stride + strip.target, (new, usize::MAX), copied);
        }
    }
}

/// Moves rows of pages.
fn move_pages(memory: Memory<&mut [u8]>, (job, msb_first): (&Job, bool), (right, down): (bool, bool)) {
    let Memory { bytes, stride } = memory;
    let pages = Pages::new(job, msb_first);
    for columns in ordered(Columns::of(job), right) {
        for page in ordered(pages.range.clone(), down) {
            let new = pages.word(bytes, stride, (page, columns.from));
            let mask = pages.inside(page) & columns.mask;
            change(bytes, page * stride + columns.to, |old| copied(old, new, mask));
        }
    }
}

/// Moves pixels from one corner to another.
fn move_pixels<C, T>(target: &mut T, (from, to): (Point, Point), job: &Job, (right, down): (bool, bool))
where
    C: PixelColor,
    T: DrawTarget<Color = C> + GetPixel<Color = C>,
{
    let (width, height) = (size_i32(low_index(job.width)), size_i32(low_index(job.height)));
    for row in ordered(0..height, down) {
        for column in ordered(0..width, right) {
            let place = Point::new(column, row);
            if let Some(color) = target.pixel(from + place) {
                // In memory nothing goes wrong.
                drop(target.draw_iter([Pixel(to + place, color)]));
            }
        }
    }
}

/// A copy of the bits that are meant.
#[inline]
const fn copied(old: usize, new: usize, mask: usize) -> usize {
    old ^ ((old ^ new) & mask)
}
