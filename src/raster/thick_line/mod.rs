//! Thick lines between pixels: exactly the pixels whose centres are in the strip, by one square root.
//!
//! ```text
//!               ╱╲                 c = (p − a) × d      across, d = b − a
//!         side ╱  ╲                dot = (p − a) · d    along
//!             ╱  b ╲
//!            ╱   ╱  ╱ end          strip  −w·|d| ≤ 2c < w·|d|
//!           ╱   ╱  ╱               butt       0 ≤ dot ≤ |d|²
//!      end ╱   ╱  ╱ side           square  −w·|d| ≤ 2·dot < 2·|d|² + w·|d|
//!          ╲  a  ╱                 round   butt, and a disc about a and about b
//!           ╲   ╱
//! ```
//!
//! All terms but `w·|d|` are whole numbers. So `⌊√(w²·|d|²)⌋` decides each comparison, and the four borders are walked
//! down from row to row, without a division. The rule is that of [`raster`](super), centres on a left or
//! top border are inside, on a right or bottom border outside, except that butt ends include the pixels at both ends.
//!
//! - **Exact** for all coordinates while width × length is less than 2²⁸ square pixels (400 × 600,000); beyond, the
//!   borders are right to 2⁻¹⁸ pixels. The same pixels from both ends.
//! - **Cost** one 64-bit square root, 3 divisions a border; then additions, one span for each visible row.
//! - **Memory** 1.4 kB of the stack.

mod border;
mod end;

use core::ops::Range;

use embedded_graphics::{
    geometry::{Point, Size},
    primitives::Rectangle,
};

use self::{
    border::{Border, PARTS},
    end::{Disc, End},
};
use crate::{
    num::saturate_i32,
    raster::bresenham::Line,
    space::Rect,
    span::Sink,
    style::{Cap, Stroke},
};

/// Draws the pixels of a thick line that are inside the bounds of `sink`, from top to bottom, one span a row.
pub(super) fn spans<S: Sink>(line: &Line, stroke: Stroke, sink: &mut S) -> Result<(), S::Error> {
    let bounds = sink.bounds();
    let Some(strip) = Strip::new(line, stroke) else { return Ok(()) };
    let rows = strip.rows(bounds);
    if rows.is_empty() { Ok(()) } else { Walk::new(strip, rows.start).rows(rows, sink) }
}

/// A rectangle that holds all pixels of a thick line.
pub(super) fn bounding_box(line: &Line, stroke: Stroke) -> Rectangle {
    let Some(strip) = Strip::new(line, stroke) else { return Rectangle::new(line.start, Size::zero()) };
    let reach = Point::new_equal(saturate_i32(strip.reach()));
    let (least, most) = (line.start.component_min(line.end), line.start.component_max(line.end));
    let [left, right] = [least.x.saturating_sub(reach.x), most.x.saturating_add(reach.x)];
    let [top, bottom] = [least.y.saturating_sub(reach.y), most.y.saturating_add(reach.y)];
    let size = |from: i32, to: i32| from.abs_diff(to).saturating_add(1);
    Rectangle::new(Point::new(left, top), Size::new(size(left, right), size(top, bottom)))
}

/// The numbers of a thick line, from its upper end.
#[derive(Clone, Copy, Debug)]
struct Strip {
    a: Point,
    b: Point,
    /// From a to b; y is not negative, and both are not zero.
    x: i64,
    y: i64,
    /// In sixteenths of a pixel.
    width: u16,
    cap: Cap,
    /// 32 times half the width times the length, rounded down: what is at most that far from the middle …
    within: i64,
    /// … and what is less far.
    below: i64,
}

impl Strip {
    /// `None` when nothing is to be drawn.
    fn new(line: &Line, stroke: Stroke) -> Option<Self> {
        let (width, cap) = (stroke.sixteenths(), stroke.cap);
        let is_point = line.start == line.end;
        if width == 0 || is_point && cap == Cap::Butt {
            return None;
        }
        let (a, b) = if line.start.y <= line.end.y { (line.start, line.end) } else { (line.end, line.start) };
        let [x, y] = [(a.x, b.x), (a.y, b.y)].map(|(a, b)| i64::from(b) - i64::from(a));
        // A point has no direction: its cap lies as if it were horizontal.
        let x = if is_point { 1 } else { x };
        let (within, below) = half_width((x.unsigned_abs(), y.unsigned_abs()), width);
        Some(Self { a, b, x, y, width, cap, within, below })
    }

    /// How many rows and columns beyond the ends there may be pixels.
    fn reach(&self) -> i64 {
        // The corner of a square cap is √½ of the width from the end, less than ¾.
        let width = i64::from(self.width);
        if self.cap == Cap::Square { width * 3 / (2 * PARTS) } else { width / PARTS }
    }

    /// All rows that may have pixels, as far as they are visible.
    fn rows(&self, bounds: Rect) -> Range<i32> {
        let rows = self.rows_near(self.a.y, self.b.y);
        if bounds.is_empty() { 0..0 } else { rows.start.max(bounds.top)..rows.end.min(bounds.bottom) }
    }

    fn rows_near(&self, top: i32, bottom: i32) -> Range<i32> {
        let reach = self.reach();
        saturate_i32(i64::from(top) - reach)..saturate_i32(i64::from(bottom) + reach + 1)
    }

    /// The rows of the strip without discs, where its borders do not say it.
    fn strip_rows(&self) -> Range<i64> {
        let (a, b) = (i64::from(self.a.y), i64::from(self.b.y));
        let width = i64::from(self.width);
        let (up, down) = (width / PARTS, (width - 1) / PARTS + 1);
        match (self.x, self.y) {
            (_, 0) => a - up..b + down,
            (0, _) if self.cap == Cap::Square => a - up..b + down,
            (0, _) => a..b + 1,
            _ => i64::MIN..i64::MAX,
        }
    }

    /// The left and the right side, standing on a row.
    fn sides(&self, row: i32) -> [Border; 2] {
        if self.y == 0 {
            return [i64::MIN, i64::MAX].map(Border::upright);
        }
        let (slope, row) = ((self.x, self.y), i64::from(row) - i64::from(self.a.y));
        let side = |shift: i64| Border::new(i64::from(self.a.x), slope, shift, row);
        // ⌈n/d⌉ = ⌊(n + d − 1)/d⌋, and behind the last column is one more.
        [side(PARTS * self.y - 1 - self.within), side(PARTS * self.y + self.below)]
    }

    /// Where the strip ends, walked down from a row.
    fn ends(&self, from: i32) -> [End; 2] {
        [(self.a, self.x > 0), (self.b, self.x < 0)].map(|(at, is_left)| {
            let near = self.rows_near(at.y, at.y);
            let rows = near.start.max(from)..near.end;
            // A vertical strip ends at a row.
            if rows.is_empty() || self.x == 0 {
                return End { rows: 0..0, border: Border::upright(0), is_left };
            }
            let border = self.end(at, is_left, i64::from(rows.start) - i64::from(at.y));
            End { rows, border, is_left }
        })
    }

    fn end(&self, at: Point, is_left: bool, row: i64) -> Border {
        let run = self.x.abs();
        let rise = if self.x > 0 { -self.y } else { self.y };
        let shift = match (self.cap, is_left) {
            (Cap::Square, true) => PARTS * run - 1 - self.within,
            (Cap::Square, false) => PARTS * run + self.below,
            (_, true) => PARTS * run - 1,
            (_, false) => PARTS * run,
        };
        Border::new(i64::from(at.x), (rise, run), shift, row)
    }

    fn discs(&self) -> Option<[Disc; 2]> {
        (self.cap == Cap::Round).then(|| [self.a, self.b].map(|at| Disc::new((at.x, at.y), self.width)))
    }
}

/// 32 times half the width times the length: the greatest whole numbers not above it, and below it.
fn half_width((x, y): (u64, u64), width: u16) -> (i64, i64) {
    let width = u64::from(width);
    let square = |v: u64| v.checked_mul(width).and_then(|v| v.checked_mul(v));
    if let Some(square) = square(x).zip(square(y)).and_then(|(x, y)| x.checked_add(y)) {
        let root = square.isqrt();
        let below = if root * root == square { root.saturating_sub(1) } else { root };
        return (root.cast_signed(), below.cast_signed());
    }
    // Scaled so that the longer is at least 2³⁰ and less than 2³¹, the length is right to one part in 2³⁰.
    let zeros = (x | y).leading_zeros();
    let (up, down) = (zeros.saturating_sub(33), 33_u32.saturating_sub(zeros));
    let [x, y] = [x, y].map(|v| v << up >> down);
    let length = (x.pow(2) + y.pow(2)).isqrt();
    let root = ((length * width) << down >> up).cast_signed();
    (root, root)
}

/// The walk down a thick line.
struct Walk {
    strip_rows: Range<i64>,
    /// The rows that no end reaches.
    middle: Range<i64>,
    sides: [Border; 2],
    ends: [End; 2],
    discs: Option<[Disc; 2]>,
}

impl Walk {
    fn new(strip: Strip, row: i32) -> Self {
        Self {
            strip_rows: strip.strip_rows(),
            middle: i64::from(strip.a.y) + strip.reach() + 1..i64::from(strip.b.y) - strip.reach(),
            sides: strip.sides(row),
            ends: strip.ends(row),
            discs: strip.discs(),
        }
    }

    fn rows<S: Sink>(mut self, rows: Range<i32>, sink: &mut S) -> Result<(), S::Error> {
        let begins = saturate_i32(self.middle.start).clamp(rows.start, rows.end);
        let ends = saturate_i32(self.middle.end).clamp(begins, rows.end);
        self.with_ends(rows.start..begins, sink)?;
        for row in begins..ends {
            let columns = self.sides();
            emit(row, columns, sink)?;
        }
        self.with_ends(ends..rows.end, sink)
    }

    fn with_ends<S: Sink>(&mut self, rows: Range<i32>, sink: &mut S) -> Result<(), S::Error> {
        for row in rows {
            let mut columns = self.strip(row);
            // What is seen of a line with its caps is convex, so in a row it is one run.
            for disc in self.discs.iter_mut().flatten() {
                columns = union(columns, disc.chord(row));
            }
            emit(row, columns, sink)?;
        }
        Ok(())
    }

    /// The columns between the sides.
    #[inline]
    fn sides(&mut self) -> Range<i64> {
        let [left, right] = &mut self.sides;
        let columns = left.column()..right.column();
        left.advance();
        right.advance();
        columns
    }

    /// The columns of the strip without discs.
    #[inline]
    fn strip(&mut self, row: i32) -> Range<i64> {
        let mut columns = self.sides();
        for end in &mut self.ends {
            columns = end.cut(row, columns);
        }
        if self.strip_rows.contains(&i64::from(row)) { columns } else { 0..0 }
    }
}

/// The visible part of a run.
#[inline]
fn emit<S: Sink>(row: i32, columns: Range<i64>, sink: &mut S) -> Result<(), S::Error> {
    let bounds = sink.bounds();
    let columns = saturate_i32(columns.start).max(bounds.left)..saturate_i32(columns.end).min(bounds.right);
    if columns.is_empty() { Ok(()) } else { sink.span(row, columns, ()) }
}

/// The run that holds two, of which one may be empty.
fn union(a: Range<i64>, b: Range<i64>) -> Range<i64> {
    match (a.is_empty(), b.is_empty()) {
        (true, _) => b,
        (_, true) => a,
        _ => a.start.min(b.start)..a.end.max(b.end),
    }
}
