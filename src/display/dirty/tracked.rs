//! A frame that is drawn on while what changes is noted.
//!
//! Each call is cut into blocks of a few bytes, of one line or of some. A block is copied, drawn on by
//! the layout, and compared with its copy, so the layouts need to know nothing of it.
//!
//! ```text
//!   line   ░░░░░░░░░░░│▒▒▒▒▒▒▒▒│▒▒▒▒▒▒▒▒│▒▒▒░░░░░░     the area's bytes in blocks
//!                      ╰─ 64 ─╯
//!                   copy, draw, compare: the first and the last difference
//! ```

use core::{convert::Infallible, ops::Range};

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Point, Size},
    image::GetPixel,
    pixelcolor::PixelColor,
    primitives::Rectangle,
};

use crate::{
    display::{
        dirty::{
            Slots,
            difference::difference,
            grid::{Grid, Part},
        },
        frame::Frame,
        layout::{Layout, Memory},
    },
    num::index,
    phase::{eight, repeated},
    space::Rect,
    target::{Target, write_area},
};

/// Bytes that are copied before they are drawn on, of all planes together.
const COPIED: usize = 128;

/// A [`Frame`] whose changes are noted in a [`Dirty`](super::Dirty) while it is drawn on.
///
/// The bytes become those that drawing on the frame itself gives. A byte is marked when one call has
/// changed its value, even if a later one turns it back; a pixel that is given two colours by one
/// call counts for two calls.
///
/// ```
/// use aquatint::{Changed, Dirty, Frame, Rows};
/// use embedded_graphics::{mono_font::{MonoTextStyle, ascii::FONT_6X10}, pixelcolor::BinaryColor, prelude::*, text::Text};
///
/// let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 512], 64, 64).unwrap();
/// let mut dirty = Dirty::new([Changed::NOTHING; 64]);
/// let style = MonoTextStyle::new(&FONT_6X10, BinaryColor::On);
/// let text = Text::new("21.5", Point::new(8, 20), style);
/// text.draw(&mut dirty.track(&mut frame))?;
/// assert!(!dirty.is_clean());
///
/// dirty.clear();
/// text.draw(&mut dirty.track(&mut frame))?; // the same again
/// assert!(dirty.is_clean());
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug)]
pub struct Tracked<'t, C, L, B> {
    frame: &'t mut Frame<C, L, B>,
    slots: Slots<'t>,
    copy: [u8; COPIED],
}

impl<'t, C: PixelColor, L: Layout<C>, B> Tracked<'t, C, L, B> {
    const GRID: Grid = Grid::of(L::SHAPE);
    const PLANES: usize = L::SHAPE.planes as usize;
    /// Bytes of a block in each plane.
    const BLOCK: usize = COPIED / Self::PLANES;

    pub(super) const fn new(frame: &'t mut Frame<C, L, B>, slots: Slots<'t>) -> Self {
        Self { frame, slots, copy: [0; COPIED] }
    }
}

impl<C: PixelColor, L: Layout<C>, B: AsMut<[u8]>> Tracked<'_, C, L, B> {
    /// Draws on an area inside, block by block, and marks what that changes. The blocks of one row come
    /// from left to right.
    #[inline]
    fn watch(&mut self, area: Rect, mut draw: impl FnMut(Memory<&mut [u8]>, Rect)) {
        if area.is_empty() {
            return;
        }
        let Part { lines, bytes } = Self::GRID.part(area);
        // A run is one line: nothing to divide.
        let high = if lines.len() == 1 { 1 } else { (Self::BLOCK / bytes.len().max(1)).max(1) };
        let is_one = lines.len() <= high && bytes.len() <= Self::BLOCK;
        let memory = self.frame.memory_mut();
        let mut top = lines.start;
        while top < lines.end {
            let lines = top..lines.end.min(top + high);
            top = lines.end;
            for start in bytes.clone().step_by(Self::BLOCK) {
                let block = Part { lines: lines.clone(), bytes: start..bytes.end.min(start + Self::BLOCK) };
                let part = if is_one { area } else { Self::GRID.area(&block).intersection(area) };
                save::<C, L>(&memory, &block, &mut self.copy);
                draw(Memory { bytes: &mut *memory.bytes, stride: memory.stride }, part);
                mark::<C, L>(&memory, &block, &self.copy, &mut self.slots);
            }
        }
    }

    /// Gives one pixel inside a colour.
    #[inline]
    fn set(&mut self, point: Point, color: C) {
        if Self::GRID.cell_bytes() > 1 {
            let Point { x, y } = point;
            self.fill(Rect::new(x, y, x.saturating_add(1), y.saturating_add(1)), color);
            return;
        }
        let (line, byte) = Self::GRID.byte(point);
        let Memory { bytes: memory, stride } = self.frame.memory_mut();
        let at = line * stride + byte;
        let before = Self::byte_of_planes(memory, at);
        L::set(Memory { bytes: &mut *memory, stride }, index(point.y), index(point.x), color);
        if Self::byte_of_planes(memory, at) != before {
            self.slots.mark(line, &(byte..=byte));
        }
    }

    /// One byte of each plane.
    #[inline]
    fn byte_of_planes(memory: &[u8], at: usize) -> u32 {
        let byte = |plane| memory.get(plane * (memory.len() / Self::PLANES) + at).copied().unwrap_or_default();
        (0..Self::PLANES).fold(0, |bytes, plane| bytes << 8 | u32::from(byte(plane)))
    }

    /// What is seen of a run.
    fn run(&self, row: i32, columns: Range<i32>) -> Option<Rect> {
        let visible = self.bounds().clip_run(row, columns)?;
        Some(Rect::new(visible.start, row, visible.end, row.saturating_add(1)))
    }

    fn fill(&mut self, area: Rect, color: C) {
        self.watch(area.intersection(self.bounds()), |memory, part| {
            L::fill_solid(memory, indices(part.rows()), indices(part.columns()), color);
        });
    }
}

/// Copies a block.
#[inline]
fn save<C: PixelColor, L: Layout<C>>(memory: &Memory<&mut [u8]>, block: &Part, copy: &mut [u8; COPIED]) {
    let mut free = &mut copy[..];
    each_line::<C, L>(memory, block, |_, bytes| {
        if let Some((to, behind)) = core::mem::take(&mut free).split_at_mut_checked(bytes.len()) {
            to.copy_from_slice(bytes);
            free = behind;
        }
    });
}

/// Marks where a block is not its copy.
#[inline]
fn mark<C: PixelColor, L: Layout<C>>(
    memory: &Memory<&mut [u8]>,
    block: &Part,
    copy: &[u8; COPIED],
    slots: &mut Slots<'_>,
) {
    let mut copy = &copy[..];
    each_line::<C, L>(memory, block, |line, bytes| {
        let (old, behind) = copy.split_at_checked(bytes.len()).unwrap_or_default();
        copy = behind;
        if let Some(changed) = difference(old, bytes) {
            let [first, last] = [changed.start(), changed.end()].map(|byte| block.bytes.start + byte);
            slots.mark(line, &(first..=last));
        }
    });
}

/// Shows the bytes of each line of a block, in each plane.
#[inline]
fn each_line<C: PixelColor, L: Layout<C>>(
    memory: &Memory<&mut [u8]>,
    Part { lines, bytes }: &Part,
    mut show: impl FnMut(usize, &[u8]),
) {
    let planes = L::SHAPE.planes as usize;
    for plane in 0..planes {
        for line in lines.clone() {
            let start = plane * (memory.bytes.len() / planes) + line * memory.stride;
            show(line, memory.bytes.get(start + bytes.start..start + bytes.end).unwrap_or(&[]));
        }
    }
}

impl<C: PixelColor, L: Layout<C>, B: AsMut<[u8]>> Target for Tracked<'_, C, L, B> {
    type Color = C;
    type Error = Infallible;

    fn bounds(&self) -> Rect {
        self.frame.bounds()
    }

    fn fill_run<const N: usize>(&mut self, row: i32, columns: Range<i32>, colors: [C; N]) -> Result<(), Infallible> {
        let Some(run) = self.run(row, columns) else { return Ok(()) };
        if let Some(colors) = eight(&colors) {
            self.watch(run, |memory, part| L::fill(memory, indices(part.rows()), indices(part.columns()), colors));
            Ok(())
        } else {
            self.write_run(row, run.columns(), repeated(&colors, run.left).map(Some))
        }
    }

    fn write_run(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: impl Iterator<Item = Option<C>>,
    ) -> Result<(), Infallible> {
        if let Some(run) = self.run(row, columns.clone()) {
            let hidden = index(run.left.saturating_sub(columns.start));
            let mut colors = colors.skip(hidden).fuse();
            self.watch(run, |memory, part| {
                let columns = indices(part.columns());
                L::write(memory, index(row), columns.start, colors.by_ref().take(columns.len()));
            });
        }
        Ok(())
    }
}

impl<C: PixelColor, L: Layout<C>, B> OriginDimensions for Tracked<'_, C, L, B> {
    fn size(&self) -> Size {
        self.frame.size()
    }
}

impl<C: PixelColor, L: Layout<C>, B: AsMut<[u8]>> DrawTarget for Tracked<'_, C, L, B> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        let bounds = self.bounds();
        for Pixel(point, color) in pixels {
            if bounds.contains(point) {
                self.set(point, color);
            }
        }
        Ok(())
    }

    fn fill_contiguous<I: IntoIterator<Item = C>>(&mut self, area: &Rectangle, colors: I) -> Result<(), Infallible> {
        write_area(self, (*area).into(), colors.into_iter())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), Infallible> {
        self.fill((*area).into(), color);
        Ok(())
    }

    fn clear(&mut self, color: C) -> Result<(), Infallible> {
        self.fill(self.bounds(), color);
        Ok(())
    }
}

impl<C: PixelColor, L: Layout<C>, B: AsRef<[u8]>> GetPixel for Tracked<'_, C, L, B> {
    type Color = C;

    fn pixel(&self, point: Point) -> Option<C> {
        self.frame.pixel(point)
    }
}

fn indices(pixels: Range<i32>) -> Range<usize> {
    index(pixels.start)..index(pixels.end)
}
