//! Windows: a target seen through a window. Bands of a picture, tiles, sub-frames.
//!
//! A picture that is too large for the memory is drawn band by band: the same drawing, once for each
//! band, on a small frame that stands for some rows of the picture. Everything in this crate
//! restricts itself to the bounds of its target and takes its dither's phase from the coordinates of the
//! picture, so the bands together are the picture, byte for byte.
//!
//! ```text
//!   picture          band
//!   row  0 ┌──────┐
//!          │      │
//!   row 16 ├──────┤ ◀─ Window::band(frame of 8 rows, 16): the frame's row 0 is row 16
//!   row 24 ├──────┤
//!          └──────┘
//! ```

use core::ops::Range;

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    image::GetPixel,
    pixelcolor::BinaryColor,
    primitives::Rectangle,
};

use crate::{
    display::{
        blit::{Blit, Part, RasterOp, clip},
        layout::Layout,
    },
    num::index,
    phase::turned,
    space::Rect,
    target::{Target, VisibleColors},
};

/// A target seen through a window, with coordinates of its own.
///
/// ```
/// use aquatint::{Frame, Pages, Window};
/// use embedded_graphics::{pixelcolor::BinaryColor, prelude::*, primitives::{Circle, PrimitiveStyle}};
///
/// // A picture of 128 × 64 through one page of 128 bytes.
/// let mut page = Frame::<BinaryColor, Pages, _>::with_array([0; 128], 128, 8).unwrap();
/// for top in (0..64).step_by(8) {
///     let mut band = Window::band(&mut page, top);
///     band.clear(BinaryColor::Off)?;
///     let circle = Circle::new(Point::new(40, 8), 48);
///     circle.into_styled(PrimitiveStyle::with_fill(BinaryColor::On)).draw(&mut band)?;
///     let bytes: &[u8] = page.bytes(); // to page `top / 8` of the panel
/// }
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug)]
pub struct Window<'t, T> {
    target: &'t mut T,
    /// From coordinates of the window to those of the target.
    offset: Point,
    /// What is seen, in coordinates of the window.
    seen: Rect,
}

impl<'t, T: Dimensions> Window<'t, T> {
    /// The target as the band of a picture that begins with row `top`.
    pub fn band(target: &'t mut T, top: i32) -> Self {
        let rows = Rect::from(target.bounding_box());
        // The offset has no number for 2³¹.
        let top = top.max(-i32::MAX);
        let seen = Rect { top: rows.top.saturating_add(top), bottom: rows.bottom.saturating_add(top), ..rows };
        Self { target, offset: Point::new(0, top.saturating_neg()), seen }
    }

    /// A part of the target as a target of its own, whose origin is the upper left corner of `area`.
    ///
    /// What of the area lies outside of the target is not drawn on. Dithers take their phase from the
    /// part's own corner, so a part looks the same wherever it is.
    pub fn part(target: &'t mut T, area: Rect) -> Self {
        let part = area.intersection(target.bounding_box().into());
        let (left, top) = (area.left, area.top);
        let seen = Rect::new(
            part.left.saturating_sub(left),
            part.top.saturating_sub(top),
            part.right.saturating_sub(left),
            part.bottom.saturating_sub(top),
        );
        Self { target, offset: Point::new(left, top), seen }
    }
}

impl<T> Window<'_, T> {
    /// A visible rectangle in coordinates of the target.
    fn there(&self, visible: Rect) -> Rectangle {
        let area = Rectangle::from(visible);
        Rectangle::new(area.top_left + self.offset, area.size)
    }
}

impl<T: Target> Target for Window<'_, T> {
    type Color = T::Color;
    type Error = T::Error;

    fn bounds(&self) -> Rect {
        self.seen
    }

    fn fill_run<const N: usize>(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: [T::Color; N],
    ) -> Result<(), T::Error> {
        let Some(columns) = self.seen.clip_run(row, columns) else { return Ok(()) };
        // Columns count from the window's left side: turn the colours to where the target counts from.
        let (colors, shift) = (turned(&colors, self.offset.x), self.offset.x);
        self.target.fill_run(row.saturating_add(self.offset.y), shifted(&columns, shift), colors)
    }

    fn write_run(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: impl Iterator<Item = Option<T::Color>>,
    ) -> Result<(), T::Error> {
        let Some(visible) = self.seen.clip_run(row, columns.clone()) else { return Ok(()) };
        let hidden = index(visible.start.saturating_sub(columns.start));
        let columns = shifted(&visible, self.offset.x);
        self.target.write_run(row.saturating_add(self.offset.y), columns, colors.skip(hidden))
    }

    fn fill_tile(&mut self, area: Rect, tile: &[[T::Color; 8]; 8]) -> Result<(), T::Error> {
        let visible = area.intersection(self.seen);
        if visible.is_empty() {
            return Ok(());
        }
        let tile = turned(tile, self.offset.y).map(|colors| turned(&colors, self.offset.x));
        self.target.fill_tile(self.there(visible).into(), &tile)
    }
}

fn shifted(columns: &Range<i32>, by: i32) -> Range<i32> {
    columns.start.saturating_add(by)..columns.end.saturating_add(by)
}

impl<T> Dimensions for Window<'_, T> {
    fn bounding_box(&self) -> Rectangle {
        self.seen.into()
    }
}

impl<T: DrawTarget> DrawTarget for Window<'_, T> {
    type Color = T::Color;
    type Error = T::Error;

    fn draw_iter<I: IntoIterator<Item = Pixel<T::Color>>>(&mut self, pixels: I) -> Result<(), T::Error> {
        let (seen, offset) = (self.seen, self.offset);
        let visible = pixels.into_iter().filter(|Pixel(point, _)| seen.contains(*point));
        self.target.draw_iter(visible.map(|Pixel(point, color)| Pixel(point + offset, color)))
    }

    fn fill_contiguous<I: IntoIterator<Item = T::Color>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), T::Error> {
        let area = Rect::from(*area);
        let visible = area.intersection(self.seen);
        let mut colors = VisibleColors::new(colors.into_iter(), area, visible);
        for row in visible.rows() {
            let run = Rect { top: row, bottom: row.saturating_add(1), ..visible };
            self.target.fill_contiguous(&self.there(run), colors.row())?;
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: T::Color) -> Result<(), T::Error> {
        let visible = Rect::from(*area).intersection(self.seen);
        if visible.is_empty() { Ok(()) } else { self.target.fill_solid(&self.there(visible), color) }
    }
}

impl<T: GetPixel> GetPixel for Window<'_, T> {
    type Color = T::Color;

    fn pixel(&self, point: Point) -> Option<T::Color> {
        if self.seen.contains(point) { self.target.pixel(point + self.offset) } else { None }
    }
}

impl<T: Blit> Blit for Window<'_, T> {
    type Color = T::Color;

    fn blit<'s, L>(&mut self, source: impl Into<Part<'s, T::Color, L>>, at: Point, op: RasterOp)
    where
        L: Layout<T::Color>,
    {
        let part = source.into();
        if let Some((area, at)) = clip(part.area(), at, self.seen) {
            self.target.blit(part.part(area), at + self.offset, op);
        }
    }

    fn paint_all<L>(
        &mut self,
        shape: &Part<BinaryColor, L>,
        places: impl Iterator<Item = (Rect, Point)>,
        color: T::Color,
    ) where
        L: Layout<BinaryColor>,
    {
        let (seen, offset) = (self.seen, self.offset);
        let seen = places.filter_map(|(area, at)| clip(area, at, seen));
        self.target.paint_all(shape, seen.map(|(area, at)| (area, at + offset)), color);
    }
}
