//! What a search has found: the visited bitmap, read as spans, or row by row as rectangles.

use core::ops::Range;

use embedded_graphics::draw_target::DrawTarget;

use super::visited::Visited;
use crate::{
    num::{count, low_index, size_i32},
    runs::{FIRST, LAST},
    space::Rect,
    span::Sink,
};

/// What was filled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Filled {
    /// How many pixels.
    pub pixels: u32,
    /// The smallest rectangle that holds them; empty when there are none.
    pub bounds: Rect,
}

impl Filled {
    #[inline]
    pub(super) fn add(&mut self, area: &Rect) {
        let Rect { left, top, right, bottom } = self.bounds;
        self.bounds = if self.pixels == 0 {
            *area
        } else {
            Rect::new(left.min(area.left), top.min(area.top), right.max(area.right), bottom.max(area.bottom))
        };
        self.pixels = self.pixels.saturating_add(area.width().saturating_mul(area.height()));
    }
}

/// A region that was found.
#[derive(Debug)]
pub struct Found<'f> {
    visited: Visited<'f>,
    window: Rect,
}

impl<'f> Found<'f> {
    pub(super) const fn new(visited: Visited<'f>, window: Rect) -> Self {
        Self { visited, window }
    }

    /// Emits the spans inside the bounds of `sink`, from top to bottom and from left to right.
    ///
    /// Some instructions for every 32 pixels of the rectangle around the region, and for each span.
    ///
    /// # Errors
    /// What the sink says.
    pub fn spans<S: Sink>(&self, sink: &mut S) -> Result<Filled, S::Error> {
        let (bounds, mut filled) = (sink.bounds(), Filled::default());
        for line in self.visited.rows() {
            self.runs_of_row(line, |run| {
                let area = self.place(line..line + 1, &run);
                let Some(columns) = bounds.clip_run(area.top, area.columns()) else { return Ok(()) };
                filled.add(&Rect { left: columns.start, right: columns.end, ..area });
                sink.span(area.top, columns, ())
            })?;
        }
        Ok(filled)
    }

    /// Fills the region with one colour. Rows that are alike, one below the other, are filled together.
    pub(super) fn paint<D: DrawTarget>(&self, display: &mut D, color: D::Color) -> Result<Filled, D::Error> {
        let (mut filled, mut rows) = (Filled::default(), self.visited.rows());
        let words = |row| self.visited.line(row, self.visited.columns());
        while let Some(first) = rows.next() {
            let end = rows.clone().find(|&row| words(row) != words(first)).unwrap_or(rows.end);
            self.runs_of_row(first, |run| {
                let area = self.place(first..end, &run);
                filled.add(&area);
                display.fill_solid(&area.into(), color)
            })?;
            rows.start = end;
        }
        Ok(filled)
    }

    /// Lines and columns of the bitmap as pixels.
    fn place(&self, lines: Range<usize>, columns: &Range<usize>) -> Rect {
        let (Rect { left, top, .. }, distance) = (self.window, |at| size_i32(low_index(at)));
        let (x, y) = (|at| left.saturating_add(distance(at)), |at| top.saturating_add(distance(at)));
        Rect::new(x(columns.start), y(lines.start), x(columns.end), y(lines.end))
    }

    /// A bit that differs from the one before it begins a run or ends one.
    #[inline]
    fn runs_of_row<E>(&self, row: usize, mut emit: impl FnMut(Range<usize>) -> Result<(), E>) -> Result<(), E> {
        let (words, mut before, mut start) = (self.visited.columns(), 0, None);
        for word in words.clone() {
            let visited = self.visited.word(row, word);
            let mut edges = visited ^ ((visited >> 1) | (before << 31));
            before = visited & LAST;
            while edges != 0 {
                let bit = edges.leading_zeros();
                edges &= !(FIRST >> bit);
                let column = 32 * word + bit as usize;
                match start.take() {
                    Some(start) => emit(start..column)?,
                    None => start = Some(column),
                }
            }
        }
        let end = (32 * words.end).min(count(self.window.width().into()));
        start.map_or(Ok(()), |start| emit(start..end))
    }
}
