//! Thin lines whose ends carry attributes: depth, light, texture coordinates. Lecture 4.1.1 and 5.6.
//!
//! ```text
//!    depth 9 ●━┓ 8             one pixel for each step along the longer axis, where the
//!              ┗━━┓ 6          line passes the middle of that step
//!                5┗━━● 4       attributes linear along that axis
//! ```
//!
//! For wireframes with hidden lines, and for every other line in space: ends lie on sixteenths of a pixel, so lines of a
//! slowly turning mesh move smoothly.
//!
//! - **Pixels.** On the driving axis (the longer one) all pixels from that of one end to that of the other, both
//!   included. On the minor axis the pixel that holds the exact line at the middle of the step, or at the end where the line
//!   does not reach the middle. So lines that share an end leave no gap there, and no line is without a pixel. Between
//!   centres of pixels these are the pixels of [Bresenham's line](super::bresenham).
//! - **Same both ways, and in every window.** The ends are put in order first. The pixels are walked on the exact edge
//!   stepper that fills are walked on, attributes by one product from the first end: entered anywhere, a line has the
//!   pixels and the attributes of the whole one.
//! - **Attributes** stay between those of the ends. After `k` pixels they are at most `(k + 2)/32768` of a unit nearer
//!   to the first end than the exact line: an eighth across 4000 pixels.

use core::ops::Range;

use crate::{
    edge::{Edge, first_row},
    error::OutOfRange,
    num::{FRACTION_16_15, SUBPIXELS, bits, divide_floor, low_i32, low_u32, to_16_15},
    space::{Point2, Rect},
    span::Sink,
    vary::{LIMIT, Ramp, Vertex},
};

/// A line of single pixels between two places that carry `N` attributes; `N` may be 0.
///
/// ```
/// use aquatint::{Point2, RampLine, Rect, SpanFn, vary::{Ramp, Vertex}};
///
/// let end = |x, y, light| Vertex { position: Point2::from_sixteenths(x, y), attributes: [light] };
/// let line = RampLine::new([end(8, 8, 0), end(4 * 16 + 8, 2 * 16 + 8, 400)])?;
/// let mut picture = [[0; 5]; 3];
/// let mut take = |row: i32, columns: core::ops::Range<i32>, ramp: Ramp<1>| {
///     for (column, [light]) in columns.zip(ramp) {
///         picture[usize::try_from(row).unwrap()][usize::try_from(column).unwrap()] = light;
///     }
/// };
/// line.spans(&mut SpanFn::new(Rect::new(0, 0, 5, 3), &mut take)).unwrap();
/// assert_eq!(picture, [
///     [0,   0,   0,   0,   0],
///     [0, 100, 200,   0,   0],
///     [0,   0,   0, 300, 400],
/// ]);
/// # Ok::<(), aquatint::OutOfRange>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RampLine<const N: usize> {
    /// Driving axis vertical?
    is_steep: bool,
    first: End<N>,
    last: End<N>,
}

/// An end: where it is along the driving axis and across it, in sixteenths, and its attributes as 16.15 numbers.
#[derive(Clone, Copy, Debug)]
struct End<const N: usize> {
    major: i32,
    minor: i32,
    values: [u32; N],
}

impl<const N: usize> RampLine<N> {
    /// A line, its ends in any order.
    ///
    /// # Errors
    /// [`OutOfRange`] when an end is 65,536 pixels or more from the origin.
    pub fn new(ends: [Vertex<N>; 2]) -> Result<Self, OutOfRange> {
        Self::fine(ends.map(|end| (end.position, end.attributes.map(to_16_15))))
    }

    /// The same with attributes as 16.15 numbers, below 2³¹.
    pub(crate) fn fine([a, b]: [(Point2, [u32; N]); 2]) -> Result<Self, OutOfRange> {
        if !a.0.within(LIMIT) || !b.0.within(LIMIT) {
            return Err(OutOfRange);
        }
        let distance = |a: i32, b: i32| a.abs_diff(b);
        let [(ax, ay), (bx, by)] = [a.0, b.0].map(|place| (place.x.to_bits(), place.y.to_bits()));
        let is_steep = distance(ay, by) > distance(ax, bx);
        let end = |x: i32, y: i32, values: [u32; N]| {
            let (major, minor) = if is_steep { (y, x) } else { (x, y) };
            End { major, minor, values }
        };
        let (one, other) = (end(ax, ay, a.1), end(bx, by, b.1));
        // Two ends at one place are told apart by what they carry.
        let order = |end: &End<N>| (end.major, end.values);
        let (first, last) = if order(&one) <= order(&other) { (one, other) } else { (other, one) };
        Ok(Self { is_steep, first, last })
    }

    /// Emits the pixels inside the bounds of `sink`, neighbours in a row as one span; those of the ends may be spans by
    /// themselves.
    ///
    /// Spans come along the line, so their rows may run upwards. A division for each attribute and one for each
    /// boundary that is crossed; some additions a pixel.
    ///
    /// # Errors
    /// What the sink says.
    pub fn spans<S: Sink<Ramp<N>>>(&self, sink: &mut S) -> Result<(), S::Error> {
        let window = sink.bounds();
        // The steps whose middle the line passes. The pixel of an end may be one before them, or one behind.
        let passed = first_row(self.first.major)..first_row(self.last.major);
        if pixel(self.first.major) < passed.start {
            self.end(&self.first, window, sink)?;
        }
        let visible = self.visible(&passed, window);
        if !visible.is_empty() {
            let ramp = self.ramp(passed.start).skipped(passed.start.abs_diff(visible.start));
            let walk = Walk { edge: self.edge(visible.start), ramp, steps: visible };
            if self.is_steep { walk.steep(sink)? } else { walk.flat(sink)? }
        }
        if pixel(self.last.major) >= passed.end { self.end(&self.last, window, sink) } else { Ok(()) }
    }

    /// The pixel that holds an end.
    fn end<S: Sink<Ramp<N>>>(&self, end: &End<N>, window: Rect, sink: &mut S) -> Result<(), S::Error> {
        let (major, minor) = (pixel(end.major), pixel(end.minor));
        let (row, column) = if self.is_steep { (major, minor) } else { (minor, major) };
        let Some(columns) = window.clip_run(row, column..column + 1) else { return Ok(()) };
        sink.span(row, columns, Ramp::new(end.values.map(rounding), [0; N]))
    }

    /// The part of the steps at which both coordinates lie in a window.
    fn visible(&self, passed: &Range<i32>, window: Rect) -> Range<i32> {
        let (columns, rows) = (window.columns(), window.rows());
        let (majors, minors) = if self.is_steep { (rows, columns) } else { (columns, rows) };
        let steps = passed.start.max(majors.start)..passed.end.min(majors.end);
        if steps.is_empty() || minors.is_empty() {
            return 0..0;
        }
        let (enters, leaves) = if self.falls() { (minors.end, minors.start) } else { (minors.start, minors.end) };
        steps.start.max(self.first_beyond(enters, passed))..steps.end.min(self.first_beyond(leaves, passed))
    }

    const fn falls(&self) -> bool {
        self.last.minor < self.first.minor
    }

    /// The first step at which the minor pixel is at a border or behind it; before it, where the line falls.
    ///
    /// With `N(k) = y·along + across·(16k + 8 − x)` the minor pixel is `⌊N/(16·along)⌋`: one 64-bit division, of
    /// numbers below 2⁴².
    fn first_beyond(&self, border: i32, passed: &Range<i32>) -> i32 {
        let (first, last) = (&self.first, &self.last);
        let (low, high) = (pixel(first.minor.min(last.minor)), pixel(first.minor.max(last.minor)));
        if border <= low || border > high {
            // The line is all on one side.
            let is_beyond = (border <= low) != self.falls();
            return if is_beyond { passed.start } else { passed.end };
        }
        let [along, across] = [last.major - first.major, last.minor - first.minor].map(i64::from);
        let to_middle = i64::from(SUBPIXELS / 2 - first.major);
        let missing = (i64::from(border * SUBPIXELS) - i64::from(first.minor)) * along - across * to_middle;
        let step = if self.falls() {
            divide_floor(-missing, -across * i64::from(SUBPIXELS)).0 + 1
        } else {
            -divide_floor(-missing, across * i64::from(SUBPIXELS)).0
        };
        low_i32(step).max(passed.start).min(passed.end)
    }

    /// The exact stepper of the minor pixels: of fills, where it gives a centre that is not left of the edge, so `⌈x − ½⌉`.
    /// Mirrored, and half a pixel aside, that is the pixel which holds the line, with its sign turned.
    fn edge(&self, step: i32) -> Edge {
        let mirrored = |end: &End<N>| Point2::from_sixteenths(SUBPIXELS / 2 - end.minor, end.major);
        Edge::new(mirrored(&self.first), mirrored(&self.last), step)
    }

    /// The attributes from the middle of a step on, the first that the line passes.
    fn ramp(&self, step: i32) -> Ramp<N> {
        let along = bits(self.last.major - self.first.major);
        let part = u64::from(bits(step * SUBPIXELS + SUBPIXELS / 2 - self.first.major));
        let (mut values, mut steps) = (self.first.values.map(rounding), [0; N]);
        for ((value, step), (from, to)) in
            values.iter_mut().zip(&mut steps).zip(self.first.values.iter().zip(self.last.values))
        {
            // Rounded towards the first end, so that the last one is never passed.
            let size = for_a_pixel(from.abs_diff(to), along);
            let (whole, offset) = (low_u32(size.cast_signed()), low_u32(((size * part) >> 4).cast_signed()));
            let is_rising = *from <= to;
            *step = if is_rising { whole } else { whole.wrapping_neg() };
            *value = if is_rising { value.wrapping_add(offset) } else { value.wrapping_sub(offset) };
        }
        Ramp::new(values, steps)
    }
}

/// The pixel that holds a coordinate in sixteenths.
const fn pixel(coordinate: i32) -> i32 {
    coordinate >> 4
}

/// With half a unit more, as a ramp wants it.
const fn rounding(value: u32) -> u32 {
    value.wrapping_add(1 << (FRACTION_16_15 - 1))
}

/// `16 · rise / along`, rounded down: in 32 bits if it fits. Below 2³⁵.
fn for_a_pixel(rise: u32, along: u32) -> u64 {
    let rise = u64::from(rise) << 4;
    let short = u32::try_from(rise).ok().and_then(|rise| rise.checked_div(along)).map(u64::from);
    short.or_else(|| rise.checked_div(along.into())).unwrap_or(0)
}

/// The visible part of a line, standing on its first pixel.
struct Walk<const N: usize> {
    edge: Edge,
    ramp: Ramp<N>,
    steps: Range<i32>,
}

impl<const N: usize> Walk<N> {
    /// The minor pixel, and one step on.
    #[inline]
    fn next_minor(&mut self) -> i32 {
        let minor = self.edge.column().wrapping_neg();
        self.edge.advance();
        minor
    }

    /// Driving axis horizontal: pixels of one row are one span.
    fn flat<S: Sink<Ramp<N>>>(mut self, sink: &mut S) -> Result<(), S::Error> {
        let Range { mut start, end } = self.steps;
        let mut row = self.next_minor();
        for column in start + 1..end {
            let here = self.next_minor();
            if here != row {
                sink.span(row, start..column, self.ramp.clone())?;
                self.ramp = self.ramp.skipped(start.abs_diff(column));
                (row, start) = (here, column);
            }
        }
        sink.span(row, start..end, self.ramp)
    }

    /// Driving axis vertical: one pixel a row.
    fn steep<S: Sink<Ramp<N>>>(mut self, sink: &mut S) -> Result<(), S::Error> {
        for row in self.steps.clone() {
            let column = self.next_minor();
            sink.span(row, column..column.saturating_add(1), self.ramp.clone())?;
            self.ramp = self.ramp.skipped(1);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]
        #[test]
        fn fine_attributes_stay_between_those_of_the_ends(
            x0 in -5000..5000_i32, x1 in -5000..5000_i32, y in -90..90_i32, a in 0..1_u32 << 24, b in 0..1_u32 << 24,
        ) {
            // Depths of 24 bits.
            let end = |x: i32, y: i32, depth: u32| (Point2::from_sixteenths(x, y), [depth << 7]);
            let line = RampLine::fine([end(x0, 0, a), end(x1, y, b)]).expect("in range");
            let window = Rect::new(-400, -10, 400, 10);
            let (mut least, mut most, mut worst) = (u32::MAX, 0, 0.0_f64);
            let mut sink = crate::SpanFn::new(window, |row: i32, columns: Range<i32>, mut ramp: Ramp<1>| {
                for column in columns {
                    let [value] = ramp.next_fine();
                    let value = value - (1 << 14);
                    (least, most) = (least.min(value), most.max(value));
                    let (place, from, to) = if line.is_steep { (row, 0, y) } else { (column, x0, x1) };
                    let place = f64::from((place * 16 + 8).clamp(from.min(to), from.max(to)));
                    let way = if from == to { 0.0 } else { (place - f64::from(from)) / f64::from(to - from) };
                    let exact = (f64::from(a) + (f64::from(b) - f64::from(a)) * way) * 128.0;
                    worst = worst.max((f64::from(value) - exact).abs());
                }
            });
            let Ok(()) = line.spans(&mut sink);
            prop_assume!(least <= most);
            prop_assert!(least >= a.min(b) << 7 && most <= a.max(b) << 7);
            let pixels = f64::from(x0.abs_diff(x1).max(y.unsigned_abs())) / 16.0;
            // Where both ends are one place, either may be drawn.
            prop_assert!(worst <= pixels + 1.0 || (x0 == x1 && y == 0), "{} after {} pixels", worst, pixels);
        }
    }
}
