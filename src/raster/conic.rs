//! Circles and ellipses of whole pixels, row by row: the machine of [`Circle`](crate::Circle) and
//! [`Ellipse`](crate::Ellipse).
//!
//! A pixel is inside when its centre is: `(2x/w)² + (2y/h)² < 1`, with `x` and `y` counted from the
//! middle of the shape. Multiplied out there is no fraction left, and the difference of both sides is
//! the *error* that Bresenham's circle goes by: positive inside, zero or negative outside. One pixel
//! to the right or one row down it changes by a *step*, and the step by a constant. So nothing is
//! multiplied or divided on the way.
//!
//! ```text
//!   row   ····######····       in the upper half the boundary goes outwards, while the error is positive,
//!         ··##########··
//!         ##############       in the lower half inwards, while it is not
//!         ··##########··
//! offset  65432100123456       an even number of columns: two in the middle have offset 0; one else
//! ```
//!
//! - **Takes** the place of the bounding box and the coefficients of one or two ellipses about its middle.
//! - **Gives** spans, at most two a row, inside the bounds of the sink.
//! - **Memory** none.
//! - **Cost** a few additions for each visible row, and one for each visible column that the boundary passes:
//!   offsets that lie outside of the sink's columns are never walked through.
//!
//! J. E. Bresenham, "A linear algorithm for incremental digital display of circular arcs", CACM 20(2), 1977;
//! J. R. Van Aken, "An efficient ellipse-drawing algorithm", IEEE CG&A 4(9), 1984.

use core::ops::{Add, AddAssign, Mul, Range, Shr, Sub, SubAssign};

use embedded_graphics::{
    geometry::{Point, Size},
    primitives::Rectangle,
};

use crate::{
    num::{low_i32, saturate_i32, saturate_u32},
    space::Rect,
};

/// What errors are counted in: `i64`, or `i128` for ellipses that no screen is large enough for.
pub(crate) trait Whole:
    Copy
    + PartialOrd
    + From<i64>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Shr<u32, Output = Self>
    + AddAssign
    + SubAssign
{
}
impl Whole for i64 {}
impl Whole for i128 {}

/// An ellipse about the middle: inside is `across·(j² + p·j) + down·(i² + q·i) < limit`.
///
/// `j` and `i` count pixels from the middle. `p` is 1 where the number of columns is even, so that the middle
/// lies between two pixels, and 0 else; `q` is the same for rows. The formula is that of the centres,
/// `2j + p` half pixels away, divided by four.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Conic<N> {
    across: N,
    down: N,
    limit: N,
}

impl Conic<i64> {
    /// Of a circle. embedded-graphics makes those of up to four pixels a little rounder, and so does this.
    pub(crate) const fn circle(diameter: u32) -> Self {
        let square = (diameter as u64) * (diameter as u64);
        let threshold = if diameter <= 4 { square - diameter as u64 / 2 } else { square };
        let limit = threshold.saturating_sub(2 * is_even(diameter) as u64).div_ceil(4);
        Self { across: 1, down: 1, limit: limit.cast_signed() }
    }
}

impl<N: Whole> Conic<N> {
    /// Of an ellipse with any sides: exact in `i64` if both are below 2¹⁶, in `i128` always.
    pub(crate) fn ellipse(Size { width, height }: Size) -> Self {
        let square = |side: u32| N::from(i64::from(side)) * N::from(i64::from(side));
        let (w, h) = (square(width), square(height));
        // ⌈(wh − p·h − q·w) / 4⌉, where w alone may fill half of the bits: w is 4·⌊w/4⌋ + 1 − p.
        let rest = if is_even(width) { N::from(0) - h } else { h };
        let rest = if is_even(height) { rest - w } else { rest };
        Self { across: h, down: w, limit: (w >> 2) * h + ((rest + N::from(3)) >> 2) }
    }

    /// How far inside a pixel is; zero or less outside.
    fn error(&self, middle: &Middle, j: i64, i: i64) -> N {
        let square = |offset: i64, is_between: bool| N::from(offset * (offset + i64::from(is_between)));
        self.limit - self.across * square(j, middle.is_between_columns) - self.down * square(i, middle.is_between_rows)
    }
}

const fn is_even(size: u32) -> bool {
    size & 1 == 0
}

/// The place of a bounding box, and the middle of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Middle {
    left: i64,
    top: i64,
    size: Size,
    is_between_columns: bool,
    is_between_rows: bool,
}

impl Middle {
    /// Of the box with these borders.
    pub(crate) fn of(top_left: Point, size: Size) -> Self {
        Self::new(i64::from(top_left.x), i64::from(top_left.y), size)
    }

    const fn new(left: i64, top: i64, size: Size) -> Self {
        let (is_between_columns, is_between_rows) = (is_even(size.width), is_even(size.height));
        Self { left, top, size, is_between_columns, is_between_rows }
    }

    /// Of the same box with other sides: its pixel in the middle stays, or the upper left one of two.
    pub(crate) fn resized(&self, size: Size) -> Self {
        let left = self.left + half(self.size.width) - half(size.width);
        let top = self.top + half(self.size.height) - half(size.height);
        Self::new(left, top, size)
    }

    /// The box; what lies outside of 32 bits is cut off.
    pub(crate) fn bounding_box(&self) -> Rectangle {
        let (left, top) = (saturate_i32(self.left), saturate_i32(self.top));
        let hidden = |border: i64, at: i32| saturate_u32((i64::from(at) - border).max(0).unsigned_abs());
        let width = self.size.width.saturating_sub(hidden(self.left, left));
        let height = self.size.height.saturating_sub(hidden(self.top, top));
        Rectangle::new(Point::new(left, top), Size::new(width, height))
    }

    /// The column of offset 0 on the left of the middle and on the right, the same one or neighbours.
    pub(crate) fn columns(&self) -> (i64, i64) {
        let left = self.left + half(self.size.width);
        (left, left + i64::from(self.is_between_columns))
    }

    /// How far a row lies below the middle.
    fn row_offset(&self, row: i32) -> i64 {
        i64::from(row) - self.top - half(self.size.height) - i64::from(self.is_between_rows)
    }

    /// Whether a pixel is inside an ellipse that fills the box.
    pub(crate) fn contains<N: Whole>(&self, conic: &Conic<N>, point: Point) -> bool {
        let (x, y) = (i64::from(point.x), i64::from(point.y));
        let is_near = (0..i64::from(self.size.width)).contains(&(x - self.left))
            && (0..i64::from(self.size.height)).contains(&(y - self.top));
        is_near && conic.error(self, x - self.columns().1, self.row_offset(point.y)) > N::from(0)
    }

    /// The rows of the box that are seen, and the offsets of the columns that are seen.
    fn visible(&self, bounds: Rect) -> Option<(Range<i32>, Range<i64>)> {
        let bottom = saturate_i32(self.top + i64::from(self.size.height));
        let rows = saturate_i32(self.top).max(bounds.top)..bottom.min(bounds.bottom);
        let (left, right) = self.columns();
        let (first, last) = (i64::from(bounds.left), i64::from(bounds.right) - 1);
        // Nearest and farthest, on whichever side of the middle.
        let nearest = (left - last).max(first - right).max(0);
        let farthest = (left - first).max(last - right).min(half(self.size.width));
        let is_visible = !bounds.is_empty() && !rows.is_empty() && self.size.width > 0 && nearest <= farthest;
        is_visible.then_some((rows, nearest..farthest + 1))
    }
}

/// The top left pixel of a box about a pixel.
pub(crate) const fn centered(center: Point, Size { width, height }: Size) -> Point {
    let (left, top) = (center.x as i64 - half(width), center.y as i64 - half(height));
    Point::new(saturate_i32(left), saturate_i32(top))
}

/// Half of what is left of a size without the pixel in the middle.
const fn half(size: u32) -> i64 {
    (size.saturating_sub(1) / 2) as i64
}

/// Where an ellipse ends in the present row.
pub(crate) struct Boundary<N> {
    /// The least offset outside, except that it stays within `offsets` and the one behind.
    offset: i64,
    offsets: Range<i64>,
    /// Of the pixel there.
    error: N,
    step: N,
    row_step: N,
    conic: Conic<N>,
}

impl<N: Whole> Boundary<N> {
    /// Stands on a row, at the nearest offset that is seen.
    fn new(conic: Conic<N>, middle: &Middle, row: i32, offsets: Range<i64>) -> Self {
        let (j, i) = (offsets.start, middle.row_offset(row));
        // From j² + p·j to the same with j + 1.
        let step = |offset: i64, is_between: bool| N::from(2 * offset + 1 + i64::from(is_between));
        Self {
            offset: j,
            offsets,
            error: conic.error(middle, j, i),
            step: conic.across * step(j, middle.is_between_columns),
            row_step: conic.down * step(i, middle.is_between_rows),
            conic,
        }
    }

    /// Stands on the first row of a box on a display.
    pub(crate) fn of_first_row(conic: Conic<N>, middle: &Middle) -> Self {
        Self::new(conic, middle, low_i32(middle.top), 0..half(middle.size.width) + 1)
    }

    /// The first offset outside, in the present row; goes on to the next row.
    #[inline]
    pub(crate) fn advance(&mut self) -> i64 {
        let zero = N::from(0);
        if self.error > zero {
            while self.offset < self.offsets.end && self.error > zero {
                self.error -= self.step;
                self.step += self.conic.across + self.conic.across;
                self.offset += 1;
            }
        } else {
            while self.offset > self.offsets.start {
                let step = self.step - self.conic.across - self.conic.across;
                if self.error + step > zero {
                    break;
                }
                self.error += step;
                self.step = step;
                self.offset -= 1;
            }
        }
        self.error -= self.row_step;
        self.row_step += self.conic.down + self.conic.down;
        self.offset
    }
}

/// From offsets to columns of the sink.
struct Columns {
    left: i64,
    right: i64,
    first: i64,
    end: i64,
}

impl Columns {
    fn new(middle: &Middle, bounds: Rect) -> Self {
        let (left, right) = middle.columns();
        Self { left, right, first: i64::from(bounds.left), end: i64::from(bounds.right) }
    }

    /// The columns with offsets below `offset`, cut off at the bounds.
    #[inline]
    fn within(&self, offset: i64) -> Range<i32> {
        let cut = |column: i64| low_i32(column.max(self.first).min(self.end));
        cut(self.left + 1 - offset)..cut(self.right + offset)
    }

    /// The columns inside the first boundary and outside of the second, if there is one: left and right of it.
    #[inline]
    fn between<const COUNT: usize>(&self, offsets: [i64; COUNT]) -> [Range<i32>; 2] {
        let (outer, inner) = match *offsets.as_slice() {
            [outer, inner] => (outer, inner),
            [outer, ..] => (outer, 0),
            [] => (0, 0),
        };
        let whole = self.within(outer);
        let hole = if inner == 0 { whole.end..whole.end } else { self.within(inner) };
        [whole.start..hole.start, hole.end..whole.end]
    }
}

/// Takes rows in which a shape has the same columns.
pub(crate) trait Blocks {
    /// Whether rows must come from top to bottom. Else each row comes with the one that mirrors it.
    const IN_ORDER: bool;
    type Error;

    /// The pixels that are wanted.
    fn bounds(&self) -> Rect;

    /// Some rows, and their columns left and right of a hole. Either may be nothing.
    fn block(&mut self, rows: Range<i32>, columns: [Range<i32>; 2]) -> Result<(), Self::Error>;
}

/// Gives what is inside an ellipse that fills its box, and not inside the second one about the same middle.
pub(crate) fn draw<N: Whole, B: Blocks, const COUNT: usize>(
    middle: &Middle,
    conics: [Conic<N>; COUNT],
    blocks: &mut B,
) -> Result<(), B::Error> {
    let bounds = blocks.bounds();
    let Some((rows, offsets)) = middle.visible(bounds) else { return Ok(()) };
    let columns = Columns::new(middle, bounds);
    let boundaries = conics.map(|conic| Boundary::new(conic, middle, rows.start, offsets.clone()));
    let half = saturate_i32(middle.top + half(middle.size.height)).saturating_add(1);
    if B::IN_ORDER || rows.start.abs_diff(rows.end) < middle.size.height {
        each_block(rows, boundaries, |rows, offsets| blocks.block(rows, columns.between(offsets)))
    } else {
        each_block(rows.start..half, boundaries, |upper, offsets| {
            let columns = columns.between(offsets);
            let lower = mirrored(&rows, &upper);
            // In the middle they meet.
            if upper.end >= lower.start {
                return blocks.block(upper.start..lower.end, columns);
            }
            blocks.block(upper, columns.clone())?;
            blocks.block(lower, columns)
        })
    }
}

/// The rows that lie as far from the bottom of `all` as `rows` from the top.
fn mirrored(all: &Range<i32>, rows: &Range<i32>) -> Range<i32> {
    let mirror = |row: i32| all.end.wrapping_sub(row.wrapping_sub(all.start));
    mirror(rows.end)..mirror(rows.start)
}

/// Gives the rows in which boundaries have the same offsets, and the offsets.
#[inline]
fn each_block<N: Whole, E, const COUNT: usize>(
    rows: Range<i32>,
    mut boundaries: [Boundary<N>; COUNT],
    mut take: impl FnMut(Range<i32>, [i64; COUNT]) -> Result<(), E>,
) -> Result<(), E> {
    let mut first = rows.start;
    let mut present = boundaries.each_mut().map(Boundary::advance);
    for row in first + 1..rows.end {
        let next = boundaries.each_mut().map(Boundary::advance);
        if next != present {
            take(first..row, present)?;
            (first, present) = (row, next);
        }
    }
    take(first..rows.end, present)
}
