//! Oversampling: 16 samples a pixel, of whatever emits spans. Lecture 6.4, 6.5.
//!
//! ```text
//!   spans four times as large        ┌─·─·─·─·─┐
//!   by any rasteriser          ──▶   │ · · # # │  ──▶  coverage 7/16
//!                                    │ · # # # │
//!                                    │ · · # # │ …
//! ```
//!
//! A rasteriser that knows nothing of antialiasing draws four times as large, and its spans are counted. So it has
//! the shapes, the rules and the mistakes of that rasteriser. The [exact area](super) is faster and better where
//! there is an outline.

use core::ops::Range;

use super::cells::{Cells, Side};
use crate::{
    coverage::{Coverage, Covered},
    num::{count_i32, index},
    space::Rect,
    span::Sink,
};

/// Takes the spans of an area that is drawn four times as large, gives coverage in steps of a sixteenth.
///
/// The spans come row by row from above, none upon another: as rasterisers of areas emit them. At the end
/// [`finish`](Self::finish) gives the last row. Lines of one pixel are a quarter of a pixel wide here.
///
/// Memory: two bytes a pixel of one row; what is wider than that is cut off. Cost: some 40 instructions a span.
///
/// ```
/// use aquatint::{
///     Covered, Coverage, Point2, Polygon, Rect, Rule, SpanFn,
///     raster::{area::Oversampled, scan::ActiveEdge},
/// };
///
/// let mut first_row = [0; 4];
/// let mut sink = SpanFn::new(Rect::new(0, 0, 4, 4), |row, columns: core::ops::Range<i32>, covered: Covered<'_>| {
///     for (offset, column) in columns.enumerate().filter(|_| row == 0) {
///         first_row[column as usize] = covered.at(offset).parts() / 2048;
///     }
/// });
/// let mut row = [Coverage::NONE; 4];
/// let mut fine = Oversampled::new(&mut row, &mut sink);
///
/// // A triangle with legs of three pixels, four times as large.
/// let corners = [(0, 0), (12, 0), (0, 12)].map(|(x, y)| Point2::corner(x, y));
/// let contours = [&corners[..]];
/// let triangle = Polygon::new(&contours).unwrap();
/// triangle.spans(Rule::NonZero, &mut heapless::Vec::<ActiveEdge, 16>::new(), &mut fine)?;
/// fine.finish()?;
/// assert_eq!(first_row, [16, 16, 6, 0]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug)]
pub struct Oversampled<'m, 's, S> {
    cells: &'m mut [Coverage],
    sink: &'s mut S,
    bounds: Rect,
    row: i32,
    is_empty: bool,
}

/// Samples along an axis.
const SAMPLES: i32 = 4;

impl<'m, 's, S, E> Oversampled<'m, 's, S>
where
    S: for<'c> Sink<Covered<'c>, Error = E>,
{
    /// Counts in `cells`, gives to `sink`.
    pub fn new(cells: &'m mut [Coverage], sink: &'s mut S) -> Self {
        let mut bounds = sink.bounds();
        let width = index(bounds.width().min(1 << 14).cast_signed()).min(cells.len());
        bounds.right = bounds.right.min(bounds.left.saturating_add(count_i32(width)));
        let cells = cells.get_mut(..width).unwrap_or_default();
        cells.fill(Coverage::NONE);
        Self { cells, sink, bounds, row: bounds.top, is_empty: true }
    }

    /// Gives the last row.
    ///
    /// # Errors
    /// What the sink says.
    pub fn finish(mut self) -> Result<(), E> {
        self.end_row()
    }

    fn end_row(&mut self) -> Result<(), E> {
        if self.is_empty {
            return Ok(());
        }
        self.is_empty = true;
        Cells::new(self.cells, self.bounds.left).emit_all(self.row, self.sink)
    }
}

impl<S, E> Sink for Oversampled<'_, '_, S>
where
    S: for<'c> Sink<Covered<'c>, Error = E>,
{
    type Error = E;

    fn bounds(&self) -> Rect {
        let Rect { left, top, right, bottom } = self.bounds;
        let [left, top, right, bottom] = [left, top, right, bottom].map(|border| border.saturating_mul(SAMPLES));
        Rect::new(left, top, right, bottom)
    }

    fn span(&mut self, row: i32, columns: Range<i32>, (): ()) -> Result<(), E> {
        let row = row.div_euclid(SAMPLES);
        if row != self.row {
            self.end_row()?;
            self.row = row;
        }
        self.is_empty = false;
        let mut cells = Cells::new(self.cells, self.bounds.left);
        for (border, side) in [(columns.start, Side::Left), (columns.end, Side::Right)] {
            let x = i64::from(border) << 14;
            cells.add_edge((x, x), i32::from(Coverage::FULL.parts()) / SAMPLES, side);
        }
        Ok(())
    }
}
