//! Dirty lines: what of a frame has changed since it was last sent, and must be sent now.
//!
//! A bus is slower than drawing: a frame of 1 KiB takes 25 ms on I²C at 400 kHz, an e-paper window a
//! second. So for each line of bytes (a row, a page, a column) the range of bytes that changed is
//! remembered, four bytes a line. [`Tracked`] notes it while drawing, or [`Dirty::compare`] finds it
//! afterwards. [`Dirty::windows`] makes windows of the ranges, as the panel can take them.
//!
//! ```text
//!   line 0  ░░░░░░░░░░░░░░░░        nothing
//!   line 1  ░░░▓▓░▓░░░░░░░░░        3 ..= 6    ┐ one window, if both together
//!   line 2  ░░░░▓▓▓▓▓░░░░░░░        4 ..= 8    ┘ cost no more than apart
//!   line 3  ░░░░░░░░░░░░░░░░        nothing
//!   line 4  ░░░░░░░░░░░░░▓▓░       13 ..= 14     another window
//! ```
//!
//! - **Takes** a frame, and memory for the ranges: one for each line, or fewer that stand for
//!   several neighbours each. A short list costs bytes on the bus, never a pixel on the panel.
//! - **Gives** windows of borrowed bytes; two of them never share a line.
//! - **Rule** a byte is marked when its value has changed. Drawing the same again marks nothing.
//! - **Cost** while drawing, each byte is copied before and compared after: some 300 instructions a
//!   run, and 3 to 17 a byte of a rectangle (on the desk). Comparing two frames takes 2 to 5 a byte.
//! - **Source** the damage regions of window systems, such as the X Damage extension (K. Packard, 2003); here
//!   they are one range for each line, so that they need no list that grows.

mod difference;
mod grid;
mod tracked;
mod window;
mod windows;

pub use tracked::Tracked;
pub use window::DirtyWindow;
pub use windows::{Grain, Windows};

use core::ops::{Range, RangeInclusive};

use embedded_graphics::{geometry::OriginDimensions, pixelcolor::PixelColor};

use crate::{
    display::{
        frame::Frame,
        layout::{Layout, Memory},
    },
    space::Rect,
};

use difference::difference;
use grid::{Extent, Grid, Part, Picture};

/// What has changed in a line of bytes: from the first byte that did to the last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Changed {
    /// How far the first byte is from [`u16::MAX`], so that nothing is all zeros: a list in a static takes no flash.
    until_end: u16,
    /// [`u16::MAX`] is the end of the line, wherever that is.
    last: u16,
}

impl Changed {
    /// No byte.
    pub const NOTHING: Self = Self { until_end: 0, last: 0 };
    /// The whole line.
    pub const EVERYTHING: Self = Self { until_end: u16::MAX, last: u16::MAX };

    /// The changed bytes of a line that has so many.
    ///
    /// In lines beyond 65,535 bytes, changes behind count as one that reaches to the end.
    #[must_use]
    pub fn bytes(self, line: usize) -> Range<usize> {
        let end = if self.last == u16::MAX { line } else { line.min(usize::from(self.last) + 1) };
        let first = usize::from(u16::MAX - self.until_end);
        if first < end { first..end } else { 0..0 }
    }

    fn include(&mut self, bytes: &RangeInclusive<usize>) {
        self.until_end = self.until_end.max(u16::MAX - saturated(*bytes.start()));
        self.last = self.last.max(saturated(*bytes.end()));
    }
}

fn saturated(byte: usize) -> u16 {
    u16::try_from(byte).unwrap_or(u16::MAX)
}

/// Remembers what has changed in a frame since [`clear`](Self::clear), in memory `M` of the caller's.
///
/// One entry for each line of bytes is exact; with fewer, each stands for 2, 4, 8 … lines, and with
/// none everything counts as changed at any time. The planes of a frame share the entries.
///
/// ```
/// use aquatint::{Changed, Dirty, Frame, Grain, Pages};
/// use embedded_graphics::{pixelcolor::BinaryColor, prelude::*};
///
/// let mut frame = Frame::<BinaryColor, Pages, _>::with_array([0; 1024], 128, 64).unwrap();
/// let mut dirty = Dirty::new([Changed::NOTHING; 8]); // EVERYTHING: send the whole frame first
/// Pixel(Point::new(40, 13), BinaryColor::On).draw(&mut dirty.track(&mut frame))?;
///
/// for window in dirty.windows(&frame, Grain::SSD1306) {
///     assert_eq!((window.area().columns(), window.area().rows()), (40..41, 8..16));
///     for bytes in window.slices() {
///         assert_eq!(bytes, [0b0010_0000]); // to the bus
///     }
/// }
/// dirty.clear(); // when all was sent
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Dirty<M> {
    entries: M,
}

impl<M> Dirty<M> {
    /// Starts with what the entries say; may be a constant or a static.
    #[must_use]
    pub const fn new(entries: M) -> Self {
        Self { entries }
    }
}

impl<M: AsRef<[Changed]>> Dirty<M> {
    /// What has changed, the first lines first.
    #[must_use]
    pub fn entries(&self) -> &[Changed] {
        self.entries.as_ref()
    }

    /// Whether nothing has changed.
    #[must_use]
    pub fn is_clean(&self) -> bool {
        !self.entries().is_empty() && self.entries().iter().all(|&entry| entry == Changed::NOTHING)
    }

    /// The windows in which everything that changed lies, from the first line on.
    ///
    /// They lie inside of the picture, begin and end at multiples of the grain or where the picture
    /// ends, and no two of them share a line of bytes. Whether a window joins the one before it is decided
    /// by what they cost; together they never cost more than a window for each row of the grain.
    #[must_use]
    pub fn windows<'f, C, L, B>(&self, frame: &'f Frame<C, L, B>, grain: Grain) -> Windows<'_, 'f>
    where
        C: PixelColor,
        L: Layout<C>,
        B: AsRef<[u8]>,
    {
        Windows::new(frame, self.entries(), grain)
    }

    /// Copies the bytes that count as changed to another frame of the same size; none to one of another
    /// size.
    ///
    /// Of two frames that are drawn on in turn, this brings the other one up to date. Or the other is the
    /// memory of what the panel shows, for [`compare`](Self::compare).
    pub fn copy<C, L, B, S>(&self, frame: &Frame<C, L, B>, other: &mut Frame<C, L, S>)
    where
        C: PixelColor,
        L: Layout<C>,
        B: AsRef<[u8]>,
        S: AsMut<[u8]>,
    {
        if frame.size() != other.size() {
            return;
        }
        let (from, shift) = (Picture::of(frame), lines_log2(Extent::of(frame).lines, self.entries().len()));
        let Memory { bytes: to, stride } = other.memory_mut();
        for (plane, line) in from.lines() {
            let changed = entry(self.entries(), line >> shift).bytes(from.line_bytes);
            let target = to.get_mut((plane * from.lines + line) * stride + changed.start..).unwrap_or_default();
            for (to, from) in target.iter_mut().zip(from.slice(plane, line, &changed)) {
                *to = *from;
            }
        }
    }
}

/// An entry of a list; where it ends, everything has changed.
fn entry(entries: &[Changed], index: usize) -> Changed {
    entries.get(index).copied().unwrap_or(Changed::EVERYTHING)
}

impl<M: AsMut<[Changed]>> Dirty<M> {
    /// Forgets all changes: the panel shows the frame.
    pub fn clear(&mut self) {
        self.entries.as_mut().fill(Changed::NOTHING);
    }

    /// Counts everything as changed: the panel was reset, or shows something else.
    pub fn mark_all(&mut self) {
        self.entries.as_mut().fill(Changed::EVERYTHING);
    }

    /// Counts the bytes of an area as changed, for code that writes them itself.
    ///
    /// ```
    /// # use aquatint::{Changed, Dirty, Frame, Rect, Rows};
    /// # use embedded_graphics::pixelcolor::BinaryColor;
    /// let frame = Frame::<BinaryColor, Rows, _>::with_array([0; 8], 32, 2).unwrap();
    /// let mut dirty = Dirty::new([Changed::NOTHING; 2]);
    /// dirty.mark(&frame, Rect::new(10, 1, 17, 9));
    /// assert_eq!(dirty.entries()[0], Changed::NOTHING);
    /// assert_eq!(dirty.entries()[1].bytes(4), 1..3);
    /// ```
    pub fn mark<C: PixelColor, L: Layout<C>, B>(&mut self, frame: &Frame<C, L, B>, area: Rect) {
        let seen = area.intersection(Rect::of_size(frame.size()));
        if seen.is_empty() {
            return;
        }
        let mut slots = self.slots(frame);
        let Part { lines, bytes } = const { Grid::of(L::SHAPE) }.part(seen);
        for line in lines {
            slots.mark(line, &(bytes.start..=bytes.end.saturating_sub(1)));
        }
    }

    /// Draws on a frame and remembers what changes.
    #[must_use]
    pub fn track<'t, C: PixelColor, L: Layout<C>, B>(
        &'t mut self,
        frame: &'t mut Frame<C, L, B>,
    ) -> Tracked<'t, C, L, B> {
        let slots = self.slots(frame);
        Tracked::new(frame, slots)
    }

    /// Counts as changed where a frame differs from the one that the panel shows.
    ///
    /// This is for pictures that are cleared and drawn anew each time, so that nearly every byte changes
    /// while drawing, and few have changed in the end. Frames of different sizes differ everywhere.
    ///
    /// ```
    /// # use aquatint::{Changed, Dirty, Frame, Grain, Rows};
    /// # use embedded_graphics::pixelcolor::BinaryColor;
    /// let mut shown = Frame::<BinaryColor, Rows, _>::with_array([0; 4], 16, 2).unwrap();
    /// let frame = Frame::<BinaryColor, Rows, _>::with_array([0, 0, 0, 7], 16, 2).unwrap();
    /// let mut dirty = Dirty::new([Changed::NOTHING; 2]);
    /// dirty.compare(&frame, &shown);
    /// for window in dirty.windows(&frame, Grain::BYTES) {
    ///     assert_eq!(window.contiguous(), Some(&[7][..])); // to the bus
    /// }
    /// dirty.copy(&frame, &mut shown);
    /// dirty.clear();
    /// assert_eq!(shown.bytes(), frame.bytes());
    /// ```
    pub fn compare<C, L, B, S>(&mut self, frame: &Frame<C, L, B>, shown: &Frame<C, L, S>)
    where
        C: PixelColor,
        L: Layout<C>,
        B: AsRef<[u8]>,
        S: AsRef<[u8]>,
    {
        if frame.size() != shown.size() {
            self.mark_all();
            return;
        }
        let mut slots = self.slots(frame);
        let (old, new) = (Picture::of(shown), Picture::of(frame));
        for (plane, line) in new.lines() {
            let whole = 0..new.line_bytes;
            if let Some(changed) = difference(old.slice(plane, line, &whole), new.slice(plane, line, &whole)) {
                slots.mark(line, &changed);
            }
        }
    }

    /// The entries as those of a frame's lines.
    fn slots<C: PixelColor, L: Layout<C>, B>(&mut self, frame: &Frame<C, L, B>) -> Slots<'_> {
        let entries = self.entries.as_mut();
        let Extent { lines, .. } = Extent::of(frame);
        Slots { shift: lines_log2(lines, entries.len()), entries }
    }
}

/// Entries of the lines of a frame.
#[derive(Debug)]
struct Slots<'d> {
    entries: &'d mut [Changed],
    /// How many lines an entry stands for, as a power of two.
    shift: u32,
}

impl Slots<'_> {
    #[inline]
    fn mark(&mut self, line: usize, bytes: &RangeInclusive<usize>) {
        if let Some(entry) = self.entries.get_mut(line >> self.shift) {
            entry.include(bytes);
        }
    }
}

/// How many neighbouring lines share an entry, so that the entries are enough, as a power of two.
fn lines_log2(lines: usize, entries: usize) -> u32 {
    let shared = lines.div_ceil(entries.max(1));
    shared.checked_next_power_of_two().map_or(usize::BITS - 1, usize::trailing_zeros)
}
