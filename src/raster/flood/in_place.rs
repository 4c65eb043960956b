//! Flood fill in place: without a bitmap, and with an honest end when the queue is full.
//!
//! ```text
//!   row y       ····████████···    painted, and taken from the queue
//!   row y + 1   ··oooo··oooo···    each run that touches it is painted and put into the queue
//! ```
//!
//! What has been filled is known by its colour, so the colour must be a new one, and nothing but one colour
//! can be filled. How long a queue a region takes depends on its shape. At 400 × 240 it is 1 entry for a spiral,
//! 2 for a blank picture, 21 or 185 for mazes, 126 for noise, 200 for a comb of 200 teeth, 400 for a grid of
//! dots, and thousands for shapes that are made for it.

use core::{fmt, ops::Range};

use embedded_graphics::{draw_target::DrawTarget, geometry::Point, image::GetPixel};

use super::{
    Connectivity, Filled, Region, part,
    queue::{Queue, Run},
    visited::LIMIT,
};
use crate::{
    num::{count, index, low_index},
    runs::Inside,
    space::Rect,
    span::Sink,
    target::Paint,
};

/// Flood fill with a queue alone: on everything that can be drawn on and read, pixel by pixel.
///
/// ```
/// use aquatint::{Frame, InPlace, InPlaceError, Rows, raster::flood::Run};
/// use embedded_graphics::{pixelcolor::Gray4, prelude::*};
///
/// let mut frame = Frame::<Gray4, Rows, _>::with_array([0; 64], 16, 8).unwrap();
/// let mut queue = [Run::default(); 4];
/// let filled = InPlace::new(&mut queue).fill(&mut frame, Point::new(3, 3), Gray4::new(7)).unwrap();
/// assert_eq!(filled.pixels, 16 * 8);
///
/// let again = InPlace::new(&mut queue).fill(&mut frame, Point::new(3, 3), Gray4::new(7));
/// assert_eq!(again, Err(InPlaceError::SameColor));
/// ```
#[derive(Debug)]
pub struct InPlace<'q> {
    queue: &'q mut [Run],
    connectivity: Connectivity,
    window: Option<Rect>,
}

/// Why a fill in place was not done, or not to its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InPlaceError<E> {
    /// The seed already has the colour. Nothing was drawn.
    SameColor,
    /// The window has more than 65,535 columns or rows. Nothing was drawn.
    TooLarge,
    /// The queue is too short for the shape of the region, **which stays filled in part**. With a queue of no
    /// entries nothing was drawn.
    Full,
    /// The target does not show what is drawn on it, so that the fill would never end.
    NotShown,
    /// What the display said, perhaps after a part was drawn.
    Display(E),
}

impl<E: fmt::Display> fmt::Display for InPlaceError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::SameColor => f.write_str("the seed already has the colour"),
            Self::TooLarge => f.write_str("more than 65535 columns or rows"),
            Self::Full => f.write_str("the queue is full; a part was filled"),
            Self::NotShown => f.write_str("the target does not show what is drawn on it"),
            Self::Display(error) => error.fmt(f),
        }
    }
}

impl<E: fmt::Debug + fmt::Display> core::error::Error for InPlaceError<E> {}

impl<'q> InPlace<'q> {
    /// Lends the queue. What it holds does not matter.
    #[must_use]
    pub const fn new(queue: &'q mut [Run]) -> Self {
        Self { queue, connectivity: Connectivity::Four, window: None }
    }

    /// Which pixels are neighbours; those that share a side by default.
    #[must_use]
    pub const fn with_connectivity(self, connectivity: Connectivity) -> Self {
        Self { connectivity, ..self }
    }

    /// Keeps to a part of the picture.
    #[must_use]
    pub const fn with_window(self, window: Rect) -> Self {
        Self { window: Some(window), ..self }
    }

    /// Fills a region with a new colour. Nothing when the seed lies outside of the picture or the window.
    ///
    /// Pixels of that colour bound the region too, since they cannot be told from what has been filled.
    ///
    /// # Errors
    /// [`InPlaceError`].
    pub fn fill<T>(
        &mut self,
        target: &mut T,
        region: impl Into<Region<<T as GetPixel>::Color>>,
        color: <T as GetPixel>::Color,
    ) -> Result<Filled, InPlaceError<T::Error>>
    where
        T: GetPixel + DrawTarget<Color = <T as GetPixel>::Color>,
    {
        let window = part(target.bounding_box().into(), self.window);
        if window.width().max(window.height()) > LIMIT {
            return Err(InPlaceError::TooLarge);
        }
        let Some((seed, old, inside)) = region.into().begin(target, window) else { return Ok(Filled::default()) };
        match () {
            () if old == color => Err(InPlaceError::SameColor),
            () if self.queue.is_empty() => Err(InPlaceError::Full),
            () => {
                let (queue, filled) = (Queue::new(self.queue), Filled::default());
                Walk { target, inside, color, window, queue, filled }.from(seed, self.connectivity)
            }
        }
    }
}

/// The state of a fill.
struct Walk<'w, T: DrawTarget> {
    target: &'w mut T,
    inside: Inside<T::Color>,
    color: T::Color,
    window: Rect,
    queue: Queue<'w>,
    filled: Filled,
}

impl<T: GetPixel + DrawTarget<Color = <T as GetPixel>::Color>> Walk<'_, T> {
    fn from(mut self, seed: Point, connectivity: Connectivity) -> Result<Filled, InPlaceError<T::Error>> {
        let by_corners = i32::from(connectivity == Connectivity::Eight);
        self.scan(seed.y, seed.x..seed.x.saturating_add(1))?;
        while let Some((row, columns)) = self.next() {
            let touched = columns.start.saturating_sub(by_corners)..columns.end.saturating_add(by_corners);
            for row in [row.saturating_sub(1), row.saturating_add(1)] {
                if let Some(columns) = self.window.clip_run(row, touched.clone()) {
                    self.scan(row, columns)?;
                }
            }
        }
        Ok(self.filled)
    }

    /// Takes a run from the queue.
    fn next(&mut self) -> Option<(i32, Range<i32>)> {
        let run = self.queue.pop()?;
        let column = |at| self.window.left.saturating_add_unsigned(low_index(at));
        let row = self.window.top.saturating_add_unsigned(low_index(run.row()));
        Some((row, column(run.columns().start)..column(run.columns().end)))
    }

    /// Paints the runs of a row that reach into some columns.
    fn scan(&mut self, row: i32, columns: Range<i32>) -> Result<(), InPlaceError<T::Error>> {
        let mut column = columns.start;
        while column < columns.end {
            if self.is_inside(column, row) {
                let left = |&column: &i32| column > self.window.left && self.is_inside(column - 1, row);
                let right = |&column: &i32| column < self.window.right && self.is_inside(column, row);
                let start = (self.window.left..=column).rev().find(|column| !left(column)).unwrap_or(column);
                let end = (column + 1..self.window.right).find(|column| !right(column)).unwrap_or(self.window.right);
                self.paint(row, start..end)?;
                column = end;
            }
            column = column.saturating_add(1);
        }
        Ok(())
    }

    fn is_inside(&self, column: i32, row: i32) -> bool {
        let color = self.target.pixel(Point::new(column, row));
        color.is_some_and(|color| self.inside.holds(color) && color != self.color)
    }

    fn paint(&mut self, row: i32, columns: Range<i32>) -> Result<(), InPlaceError<T::Error>> {
        // Each pixel is painted once, unless painting does not show.
        let area = u64::from(self.window.width()) * u64::from(self.window.height());
        let length = columns.start.abs_diff(columns.end);
        if u64::from(self.filled.pixels) + u64::from(length) > area {
            return Err(InPlaceError::NotShown);
        }
        Paint::new(self.target, self.color).span(row, columns.clone(), ()).map_err(InPlaceError::Display)?;
        self.filled.add(&Rect::new(columns.start, row, columns.end, row.saturating_add(1)));
        let place = |from: i32, to: i32| count(u64::from(from.abs_diff(to)));
        let columns = place(self.window.left, columns.start)..place(self.window.left, columns.end);
        let run = Run::new(index(row.wrapping_sub(self.window.top)), &columns);
        if self.queue.push(run) { Ok(()) } else { Err(InPlaceError::Full) }
    }
}
