//! The digital differential analyser: a slope, added once a pixel, and rounding. Lecture 4.1.1.
//!
//! ```text
//!   for each x:  plot (x, round(y));  y += slope
//! ```
//!
//! The slope is a fixed-point number of 32 fraction bits, so a step is one addition whose carry says
//! whether the line goes on to the next row or column. It is rounded to the side to which [Bresenham's
//! line](super::bresenham) rounds ties: up to 46,340 pixels of length both draw the same pixels. Beyond,
//! the rounding of the slope can add up to a pixel, which Bresenham's error term never does; that is the
//! difference between the two. A line longer than 2³¹ pixels may miss its farther end by a pixel.
//!
//! **Clipped exactly**: the step at which a boundary is crossed is solved for, and the sum is entered
//! there. The visible pixels are those of the whole line, for any coordinates, at the cost of the visible
//! part.

use core::ops::Range;

use embedded_graphics::{
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    pixelcolor::PixelColor,
    primitives::{Primitive, Rectangle, StyledDimensions, StyledDrawable},
};

use crate::{
    num::{low_u32, saturate_u32},
    raster::{
        axes::{Axes, emit_runs},
        bresenham::Line,
    },
    space::Rect,
    span::Sink,
    style::StrokeStyle,
    target::Paint,
};

/// A line between two pixels, both included. Right for all coordinates.
///
/// ```
/// use aquatint::{DdaLine, Rect, SpanFn};
/// use embedded_graphics::geometry::Point;
///
/// let (mut runs, window) = ([0; 3], Rect::new(0, 0, 9, 3));
/// let mut count = SpanFn::new(window, |row: i32, columns: core::ops::Range<i32>, ()| {
///     runs[usize::try_from(row).unwrap()] = columns.len();
/// });
/// DdaLine::new(Point::new(-1, 0), Point::new(4, 2)).spans(&mut count)?;
/// assert_eq!(runs, [1, 2, 2]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DdaLine {
    /// One end.
    pub start: Point,
    /// The other end.
    pub end: Point,
}

impl DdaLine {
    /// The line between two pixels.
    #[must_use]
    pub const fn new(start: Point, end: Point) -> Self {
        Self { start, end }
    }

    /// Emits the pixels inside the bounds of `sink`, neighbours in a row as one span.
    ///
    /// Spans come along the line, so their rows may run upwards. One 64-bit division for the slope and
    /// one for each boundary that is crossed.
    ///
    /// # Errors
    /// What the sink says.
    pub fn spans<S: Sink>(&self, sink: &mut S) -> Result<(), S::Error> {
        let Some((walk, steps)) = Walk::of(self, sink.bounds()) else { return Ok(()) };
        emit_runs(walk.points(steps), sink)
    }
}

/// The line, standing on a pixel.
struct Walk {
    axes: Axes,
    /// Across for a step along, in parts of 2³²: from 0 to 2³².
    slope: u64,
    /// Distance gone across since the last whole pixel, and the half for rounding.
    part: u32,
}

impl Walk {
    /// The line, entered at its first visible pixel, and the steps from its first pixel that are visible.
    fn of(line: &DdaLine, window: Rect) -> Option<(Self, Range<u64>)> {
        let axes = Axes::new(line.start, line.end);
        let across = u64::from(axes.across) << 32;
        let along = u64::from(axes.along.max(1));
        let rounds_up = axes.direction > 0 && along < 1 << 31;
        let slope = if rounds_up { across.div_ceil(along) } else { across / along };
        let mut walk = Self { axes, slope, part: 0 };
        let steps = axes.visible((line.start, line.end), window, |distance| walk.first_step_with(distance));
        if steps.is_empty() {
            return None;
        }
        walk.enter(steps.start);
        Some((walk, steps))
    }

    /// A half: a tie rounds to the larger coordinate, which is on the way when it rises and not yet when
    /// it falls.
    const fn bias(&self) -> u64 {
        if self.axes.direction > 0 { 1 << 31 } else { (1 << 31) - 1 }
    }

    /// The first step at which the minor axis has gone `distance`: `k·slope + bias ≥ distance·2³²`.
    const fn first_step_with(&self, distance: u64) -> u64 {
        if distance > self.axes.across as u64 || self.slope == 0 {
            return u64::MAX;
        }
        ((distance << 32) - self.bias()).div_ceil(self.slope)
    }

    /// Stands on pixel `step` of the line: below 2³², as the slope is at most 2³², so the sum fits.
    fn enter(&mut self, step: u64) {
        let travelled = step.wrapping_mul(self.slope).wrapping_add(self.bias());
        self.part = low_u32(travelled.cast_signed());
        self.axes.go(saturate_u32(step), saturate_u32(travelled >> 32));
    }

    /// The pixels, one by one.
    fn points(mut self, steps: Range<u64>) -> impl Iterator<Item = Point> {
        steps.map(move |_| {
            let point = self.axes.point();
            self.axes.major = self.axes.major.wrapping_add(1);
            let sum = self.slope.wrapping_add(u64::from(self.part));
            self.part = low_u32(sum.cast_signed());
            if sum >> 32 != 0 {
                self.axes.minor = self.axes.minor.wrapping_add(self.axes.direction);
            }
            point
        })
    }
}

impl Primitive for DdaLine {}

impl Dimensions for DdaLine {
    /// That of the two ends.
    fn bounding_box(&self) -> Rectangle {
        Line::new(self.start, self.end).bounding_box()
    }
}

impl<C: PixelColor> StyledDimensions<StrokeStyle<C>> for DdaLine {
    fn styled_bounding_box(&self, _style: &StrokeStyle<C>) -> Rectangle {
        self.bounding_box()
    }
}

impl<C: PixelColor> StyledDrawable<StrokeStyle<C>> for DdaLine {
    type Color = C;
    type Output = ();

    /// One pixel wide, whatever the width of the stroke.
    fn draw_styled<D: DrawTarget<Color = C>>(&self, style: &StrokeStyle<C>, target: &mut D) -> Result<(), D::Error> {
        self.spans(&mut Paint::new(target, style.color))
    }
}
