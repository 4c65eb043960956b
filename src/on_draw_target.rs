//! Any embedded-graphics display as a target.
//!
//! A display driver that sets a window on its bus for each call is called seldom: once for a run of one colour, for a
//! run of a pattern, for an area of a tile.
//!
//! ```text
//!   fill_run ──▶ fill_solid or fill_contiguous     write_run ──▶ fill_contiguous, 64 pixels at a time
//! ```

use core::ops::Range;

use embedded_graphics::{Pixel, draw_target::DrawTarget, geometry::Dimensions, primitives::Rectangle};
use heapless::Vec;

use crate::{
    num::{count_i32, index},
    phase::{phase, repeated},
    space::Rect,
    target::{Target, run_area},
};

/// Any embedded-graphics display as a [`Target`].
///
/// A run of one colour is one `fill_solid`, a run of a pattern one `fill_contiguous`. Written colours
/// are one `fill_contiguous` for each stretch without an absent one, up to 64 pixels long: so a
/// display that sets a window on its bus for each call does so seldom.
#[derive(Debug)]
pub struct OnDrawTarget<'d, D> {
    display: &'d mut D,
    bounds: Rect,
}

impl<'d, D: DrawTarget> OnDrawTarget<'d, D> {
    /// Lends a display.
    pub fn new(display: &'d mut D) -> Self {
        let bounds = display.bounding_box().into();
        Self { display, bounds }
    }
}

impl<D: DrawTarget> Target for OnDrawTarget<'_, D> {
    type Color = D::Color;
    type Error = D::Error;

    fn bounds(&self) -> Rect {
        self.bounds
    }

    fn fill_run<const N: usize>(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: [D::Color; N],
    ) -> Result<(), D::Error> {
        let Some(columns) = self.bounds.clip_run(row, columns) else { return Ok(()) };
        let area = run_area(row, &columns);
        if let [color] = *colors.as_slice() {
            self.display.fill_solid(&area, color)
        } else {
            self.display.fill_contiguous(&area, repeated(&colors, columns.start))
        }
    }

    fn write_run(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: impl Iterator<Item = Option<D::Color>>,
    ) -> Result<(), D::Error> {
        let Some(visible) = self.bounds.clip_run(row, columns.clone()) else { return Ok(()) };
        let hidden = index(visible.start.saturating_sub(columns.start));
        let mut stretch = Vec::<D::Color, 64>::new();
        let mut end = visible.start;
        for color in colors.skip(hidden).take(visible.len()) {
            if color.is_none() || stretch.is_full() {
                self.write_stretch(row, end, &mut stretch)?;
            }
            // There is room: a full stretch has just been written.
            let _ = color.map(|color| stretch.push(color));
            end = end.saturating_add(1);
        }
        self.write_stretch(row, end, &mut stretch)
    }

    /// One `fill_solid` or one `fill_contiguous`.
    fn fill_tile(&mut self, area: Rect, tile: &[[D::Color; 8]; 8]) -> Result<(), D::Error> {
        let visible = area.intersection(self.bounds);
        let [[first, ..], ..] = *tile;
        if visible.is_empty() {
            Ok(())
        } else if *tile == [[first; 8]; 8] {
            self.display.fill_solid(&visible.into(), first)
        } else {
            let row = |row| phase(tile, row).unwrap_or([first; 8]);
            let colors = visible
                .rows()
                .flat_map(move |y| Eight { colors: row(y), column: visible.left }.take(visible.columns().len()));
            self.display.fill_contiguous(&visible.into(), colors)
        }
    }
}

/// Eight colours that repeat, from a column of the screen on.
struct Eight<C> {
    colors: [C; 8],
    column: i32,
}

impl<C: Copy> Iterator for Eight<C> {
    type Item = C;

    #[inline]
    fn next(&mut self) -> Option<C> {
        let color = phase(&self.colors, self.column);
        self.column = self.column.wrapping_add(1);
        color
    }
}

/// Drawings pass through as they are.
impl<D: DrawTarget> DrawTarget for OnDrawTarget<'_, D> {
    type Color = D::Color;
    type Error = D::Error;

    fn draw_iter<I: IntoIterator<Item = Pixel<D::Color>>>(&mut self, pixels: I) -> Result<(), D::Error> {
        self.display.draw_iter(pixels)
    }

    fn fill_contiguous<I: IntoIterator<Item = D::Color>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), D::Error> {
        self.display.fill_contiguous(area, colors)
    }

    fn fill_solid(&mut self, area: &Rectangle, color: D::Color) -> Result<(), D::Error> {
        self.display.fill_solid(area, color)
    }

    fn clear(&mut self, color: D::Color) -> Result<(), D::Error> {
        self.display.clear(color)
    }
}

impl<D> Dimensions for OnDrawTarget<'_, D> {
    fn bounding_box(&self) -> Rectangle {
        self.bounds.into()
    }
}

impl<D: DrawTarget> OnDrawTarget<'_, D> {
    /// Writes colours that end before a column, and forgets them.
    fn write_stretch(&mut self, row: i32, end: i32, colors: &mut Vec<D::Color, 64>) -> Result<(), D::Error> {
        let width = count_i32(colors.len());
        if width > 0 {
            let area = run_area(row, &(end.saturating_sub(width)..end));
            self.display.fill_contiguous(&area, colors.iter().copied())?;
            colors.clear();
        }
        Ok(())
    }
}
