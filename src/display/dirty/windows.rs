//! From dirty lines to windows: rounded to what the panel can address, and joined where that is cheaper.
//!
//! ```text
//!   changed              rounded to 8 × 2 pixels     joined
//!   ░░░▓░░░░░░░░░░░░     ▓▓▓▓▓▓▓▓░░░░░░░░            ┌──────┐
//!   ░░░░░░░░░░░░░░░░     ▓▓▓▓▓▓▓▓░░░░░░░░            │      │
//!   ░░▓▓▓▓░░░░░░░░░░     ▓▓▓▓▓▓▓▓░░░░░░░░            │      │
//!   ░░░▓▓▓▓░░░░░░░░░     ▓▓▓▓▓▓▓▓░░░░░░░░            └──────┘
//! ```
//!
//! - **Takes** the ranges of all lines, and the grain.
//! - **Gives** windows from the first line on. A line is in one window at most.
//! - **Rule** one row of the grain after the other: it joins the window above when one window costs
//!   no more bytes on the bus than two, counting what is sent to open a window. What is between them is then
//!   sent too.
//! - **Cost** a few instructions a line; no memory.

use core::{iter::Peekable, ops::Range};

use embedded_graphics::{geometry::OriginDimensions, pixelcolor::PixelColor};

use crate::{
    display::{
        dirty::{
            Changed, DirtyWindow, entry,
            grid::{Grid, Part, Picture},
            lines_log2,
        },
        frame::Frame,
        layout::Layout,
    },
    num::count,
    space::Rect,
};

/// What a panel can address: windows whose borders are multiples of so many columns and rows, and what
/// each costs.
///
/// Windows are whole bytes of the frame in any case: where the grain is finer, or divides bytes,
/// they are rounded further, to the least common multiple.
///
/// ```
/// use aquatint::Grain;
///
/// // An SSD1327, two columns in a byte; 15h, two columns, 75h and two rows before the data.
/// const SSD1327: Grain = Grain { columns: 2, rows: 1, overhead: 6 };
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Grain {
    /// Columns of pixels; [`u32::MAX`] for whole rows, 0 is 1.
    pub columns: u32,
    /// Rows of pixels; [`u32::MAX`] for whole columns, 0 is 1.
    pub rows: u32,
    /// Bytes that are sent to open a window, or that take as long.
    pub overhead: u32,
}

impl Grain {
    /// Any byte, at no cost.
    pub const BYTES: Self = Self { columns: 1, rows: 1, overhead: 0 };
    /// Pages of eight rows: SSD1306 and the like; 21h and 22h with two arguments each.
    pub const SSD1306: Self = Self { columns: 1, rows: 8, overhead: 6 };
    /// Four columns: SSD1322; 15h and 75h with two arguments each, and 5Ch.
    pub const SSD1322: Self = Self { columns: 4, rows: 1, overhead: 7 };
    /// Eight columns: SSD1680 and most e-paper; 44h, 45h, 4Eh, 4Fh and 24h with their arguments.
    pub const SSD1680: Self = Self { columns: 8, rows: 1, overhead: 14 };
    /// Tiles of 12 × 2: ST7305 and ST7306; 2Ah and 2Bh with two arguments each, and 2Ch.
    pub const ST7306: Self = Self { columns: 12, rows: 2, overhead: 7 };
    /// Words of 16 columns: ST7920. Each row has an address of its own, so joining saves none.
    pub const ST7920: Self = Self { columns: 16, rows: 1, overhead: 0 };
    /// Whole rows: memory LCDs of Sharp, whose every row has an address of its own.
    pub const SHARP: Self = Self { columns: u32::MAX, rows: 1, overhead: 0 };
}

/// The windows of a frame, as [`Dirty::windows`](super::Dirty::windows) gives them.
#[derive(Clone, Debug)]
pub struct Windows<'d, 'f> {
    bands: Peekable<Bands<'d>>,
    picture: Picture<'f>,
    grid: Grid,
    bounds: Rect,
    overhead: usize,
}

impl<'d, 'f> Windows<'d, 'f> {
    pub(super) fn new<C, L, B>(frame: &'f Frame<C, L, B>, entries: &'d [Changed], grain: Grain) -> Self
    where
        C: PixelColor,
        L: Layout<C>,
        B: AsRef<[u8]>,
    {
        let (grid, picture) = (const { Grid::of(L::SHAPE) }, Picture::of(frame));
        let Picture { lines, line_bytes, .. } = picture;
        let shift = lines_log2(lines, entries.len());
        let tile = grid.tile(grain.columns, grain.rows);
        let bands = Bands { entries, shift, tile, line_bytes, left: 0..lines };
        let overhead = count(grain.overhead.into());
        Self { bands: bands.peekable(), picture, grid, bounds: Rect::of_size(frame.size()), overhead }
    }
}

impl<'f> Iterator for Windows<'_, 'f> {
    type Item = DirtyWindow<'f>;

    fn next(&mut self) -> Option<DirtyWindow<'f>> {
        let Self { bands, picture, grid, bounds, overhead } = self;
        let mut part = bands.next()?;
        let is_cheaper = |part: &Part, next: &Part| {
            let apart = picture.planes * (part.byte_len() + next.byte_len());
            picture.planes * part.union(next).byte_len() <= apart.saturating_add(*overhead)
        };
        // Not `next_if`, which can panic.
        while let Some(next) = bands.peek().filter(|next| is_cheaper(&part, next)) {
            part = part.union(next);
            bands.next();
        }
        let area = grid.area(&part).intersection(*bounds);
        Some(DirtyWindow::new(*picture, part, area))
    }
}

/// Rows of tiles in which something has changed.
#[derive(Clone, Debug)]
struct Bands<'d> {
    entries: &'d [Changed],
    shift: u32,
    /// Lines and bytes.
    tile: [usize; 2],
    line_bytes: usize,
    /// Lines to come.
    left: Range<usize>,
}

impl Bands<'_> {
    /// What has changed in any of some lines.
    fn changed(&self, lines: &Range<usize>) -> Range<usize> {
        let entries = lines.start >> self.shift..=(lines.end - 1) >> self.shift;
        let ranges = entries.map(|index| entry(self.entries, index).bytes(self.line_bytes));
        ranges.filter(|bytes| !bytes.is_empty()).reduce(|a, b| union(&a, &b)).unwrap_or(0..0)
    }
}

impl Iterator for Bands<'_> {
    type Item = Part;

    fn next(&mut self) -> Option<Part> {
        let [high, wide] = self.tile;
        while !self.left.is_empty() {
            let lines = self.left.start..self.left.start.saturating_add(high).min(self.left.end);
            self.left.start = lines.end;
            let Range { start, end } = self.changed(&lines);
            if start < end {
                // Up to the end of the last tile that is begun.
                let begin = |byte: usize| byte - byte.checked_rem(wide).unwrap_or(0);
                let end = begin(end - 1).saturating_add(wide).min(self.line_bytes);
                return Some(Part { lines, bytes: begin(start)..end });
            }
        }
        None
    }
}

fn union(a: &Range<usize>, b: &Range<usize>) -> Range<usize> {
    a.start.min(b.start)..a.end.max(b.end)
}

impl Part {
    /// The lines and bytes of both, and what is between them.
    fn union(&self, other: &Self) -> Self {
        Self { lines: union(&self.lines, &other.lines), bytes: union(&self.bytes, &other.bytes) }
    }
}
