//! Bresenham's line: integer additions only, and clipped without moving a pixel. Lecture 4.1.2.
//!
//! On the driving axis (the longer one) every pixel is one step; the other axis steps when the
//! error says that the true line has come nearer to the next pixel.
//!
//! - **Same both ways.** The ends are put in order first, so a line drawn from either end has the
//!   same pixels. Where the line passes exactly between two pixels, the one with the larger
//!   coordinate on the minor axis is taken.
//! - **Clipped exactly.** Outcodes accept or reject the line as in Cohen-Sutherland; where a
//!   boundary is crossed, the *step* at which it happens is solved for and the error term is
//!   entered there, instead of moving the end of the line. So the visible pixels are those of the
//!   whole line, for any coordinates, and the cost is that of the visible part.
//!
//! ```text
//!        ┌───────────┐
//!    ●━━━┿━━━┓       │      minor(k) = ⌊(k·dminor + bias) / dmajor⌋
//!        │   ┗━━━━━━━┿━━●   entered at the first k inside
//!        └───────────┘
//! ```
//!
//! J. E. Bresenham, "Algorithm for computer control of a digital plotter", IBM Systems Journal
//! 4(1), 1965. Y. P. Kuzmin, "An efficient circuit for clipping lines", doi
//! 10.1111/1467-8659.1450275, for the idea of clipping in the error term.

use core::ops::Range;

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point, Size},
    pixelcolor::PixelColor,
    primitives::{Primitive, Rectangle, StyledDimensions, StyledDrawable},
};

use crate::{num::saturate_u32, outcode::Outcode, space::Rect, span::Sink, style::StrokeStyle, target::Paint};

/// A line of single pixels, both ends included. Right for all coordinates.
///
/// ```
/// use aquatint::{Line, StrokeStyle};
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
///
/// let mut display = MockDisplay::new();
/// let line = Line::new(Point::new(0, 0), Point::new(5, 2));
/// line.into_styled(StrokeStyle::new(BinaryColor::On)).draw(&mut display)?;
/// display.assert_pattern(&[
///     "##    ",
///     "  ##  ",
///     "    ##",
/// ]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line {
    /// One end.
    pub start: Point,
    /// The other end.
    pub end: Point,
}

impl Line {
    /// The line between two pixels.
    #[must_use]
    pub const fn new(start: Point, end: Point) -> Self {
        Self { start, end }
    }

    /// Emits the pixels inside the bounds of `sink`, neighbours in a row as one span.
    ///
    /// Spans come along the line, so their rows may run upwards. Two 64-bit divisions at most for
    /// each boundary that is crossed; additions and one span a row or column then.
    ///
    /// # Errors
    /// What the sink says.
    pub fn spans<S: Sink>(&self, sink: &mut S) -> Result<(), S::Error> {
        let window = sink.bounds();
        let Some((walk, steps)) = Walk::of(self, window) else { return Ok(()) };
        if walk.is_steep { walk.steep(steps, sink) } else { walk.flat(steps, sink) }
    }
}

/// The line seen along its driving axis, standing before its first pixel.
struct Walk {
    /// Driving axis vertical?
    is_steep: bool,
    major: i32,
    minor: i32,
    /// +1 or −1: where the minor axis leads as the major one grows.
    direction: i32,
    error: u32,
    /// Lengths along the axes; both fit 32 bits for any two points.
    along: u32,
    across: u32,
}

impl Walk {
    /// The line, entered at its first visible pixel, and the number of visible pixels.
    fn of(line: &Line, window: Rect) -> Option<(Self, u64)> {
        let (start, end) = (Outcode::of(line.start, window), Outcode::of(line.end, window));
        if window.is_empty() || !(start & end).is_inside() {
            return None;
        }
        let (mut walk, columns_and_rows) = Self::whole(line, window);
        let mut steps = 0..u64::from(walk.along) + 1;
        if !(start.is_inside() && end.is_inside()) {
            steps = walk.visible(steps, columns_and_rows);
        }
        if steps.is_empty() {
            return None;
        }
        walk.enter(steps.start);
        Some((walk, steps.end - steps.start))
    }

    /// The whole line in canonical direction, and the window's ranges along its two axes.
    fn whole(line: &Line, window: Rect) -> (Self, (Range<i32>, Range<i32>)) {
        let (width, height) = (line.start.x.abs_diff(line.end.x), line.start.y.abs_diff(line.end.y));
        let is_steep = height > width;
        let axes = |p: Point| if is_steep { (p.y, p.x) } else { (p.x, p.y) };
        let (a, b) = (axes(line.start), axes(line.end));
        let (first, last) = if a.0 <= b.0 { (a, b) } else { (b, a) };
        let direction = if first.1 <= last.1 { 1 } else { -1 };
        let (along, across) = (width.max(height), width.min(height));
        let ranges = if is_steep { (window.rows(), window.columns()) } else { (window.columns(), window.rows()) };
        let walk = Self { is_steep, major: first.0, minor: first.1, direction, error: 0, along, across };
        (walk, ranges)
    }

    /// Half the driving length: a tie rounds to the larger minor coordinate, which is on the way
    /// when it rises and not yet when it falls.
    fn bias(&self) -> u32 {
        if self.direction > 0 { self.along / 2 } else { self.along.saturating_sub(1) / 2 }
    }

    /// The steps at which both coordinates lie in their ranges.
    fn visible(&self, steps: Range<u64>, (major, minor): (Range<i32>, Range<i32>)) -> Range<u64> {
        let ahead = |from: i32, to: i32| (i64::from(to) - i64::from(from)).max(0).unsigned_abs();
        // One more than the distance to a coordinate that is still inside.
        let past = |from: i32, to: i32| (i64::from(to) - i64::from(from) + 1).max(0).unsigned_abs();
        let on_major = ahead(self.major, major.start)..ahead(self.major, major.end);
        // How far the minor axis has to go to come in, and to leave.
        let (enter, leave) = if self.direction > 0 {
            (ahead(self.minor, minor.start), ahead(self.minor, minor.end))
        } else {
            (past(minor.end, self.minor), past(minor.start, self.minor))
        };
        let on_minor = self.first_step_with(enter)..self.first_step_with(leave);
        let start = steps.start.max(on_major.start).max(on_minor.start);
        start..steps.end.min(on_major.end).min(on_minor.end)
    }

    /// The first step at which the minor axis has gone `distance`: `k·across + bias ≥ distance·along`.
    ///
    /// The products stay below 2⁶⁴ because `distance ≤ across ≤ along < 2³²` where it matters.
    fn first_step_with(&self, distance: u64) -> u64 {
        if distance == 0 {
            return 0;
        }
        let (along, across) = (u64::from(self.along), u64::from(self.across));
        if distance > across || across == 0 {
            return u64::MAX;
        }
        (distance * along - u64::from(self.bias())).div_ceil(across)
    }

    /// Stands on pixel `step` of the line.
    fn enter(&mut self, step: u64) {
        let bias = u64::from(self.bias());
        let travelled = step * u64::from(self.across) + bias;
        if step == 0 || self.along == 0 {
            self.error = saturate_u32(bias);
            return;
        }
        let along = u64::from(self.along);
        let minor = saturate_u32(travelled / along);
        self.error = saturate_u32(travelled % along);
        self.major = self.major.saturating_add_unsigned(saturate_u32(step));
        self.minor = if self.direction > 0 {
            self.minor.saturating_add_unsigned(minor)
        } else {
            self.minor.saturating_sub_unsigned(minor)
        };
    }

    /// One pixel on.
    #[inline]
    fn advance(&mut self) {
        self.major = self.major.wrapping_add(1);
        // `error + across ≥ along`, written so that it cannot overflow.
        if self.error >= self.along - self.across {
            self.error = self.error.wrapping_sub(self.along - self.across);
            self.minor = self.minor.wrapping_add(self.direction);
        } else {
            self.error = self.error.wrapping_add(self.across);
        }
    }

    /// Whether filling runs costs less than setting pixels: three or more to a row, on average. A run on a
    /// packed frame costs about what three pixels cost.
    const fn runs_are_long(&self) -> bool {
        !self.is_steep && self.along / 3 >= self.across
    }

    /// The pixels, one by one.
    fn points(mut self, steps: u64) -> impl Iterator<Item = Point> {
        let is_steep = self.is_steep;
        (0..steps).map(move |_| {
            let (major, minor) = (self.major, self.minor);
            self.advance();
            if is_steep { Point::new(minor, major) } else { Point::new(major, minor) }
        })
    }

    /// Driving axis horizontal: pixels of one row are one span.
    ///
    /// From row to row the error says how long the run is: `⌊along / across⌋` pixels or one more. So there is
    /// work for each run and none for each pixel ("run-slice": M. Abrash, *Graphics Programming Black Book*,
    /// chapter 36).
    fn flat<S: Sink>(mut self, steps: u64, sink: &mut S) -> Result<(), S::Error> {
        // A visible line is no longer than a picture is wide.
        let mut left = saturate_u32(steps);
        let across = self.across.max(1);
        let (shortest, rest) = (self.along / across, self.along % across);
        // The first run may begin anywhere in its row.
        let mut run = if self.across == 0 { left } else { (self.along - self.error).div_ceil(across) };
        self.error = self.error.wrapping_add(run.wrapping_mul(across)).wrapping_sub(self.along);
        while run < left {
            let end = self.major.wrapping_add_unsigned(run);
            sink.span(self.minor, self.major..end, ())?;
            (self.major, self.minor) = (end, self.minor.wrapping_add(self.direction));
            left -= run;
            let is_longer = self.error < rest;
            run = shortest + u32::from(is_longer);
            if is_longer {
                self.error = self.error.wrapping_add(across);
            }
            self.error = self.error.wrapping_sub(rest);
        }
        if left == 0 { Ok(()) } else { sink.span(self.minor, self.major..self.major.saturating_add_unsigned(left), ()) }
    }

    /// Driving axis vertical: one pixel a row.
    fn steep<S: Sink>(mut self, steps: u64, sink: &mut S) -> Result<(), S::Error> {
        for _ in 1..steps {
            sink.span(self.major, self.minor..self.minor.saturating_add(1), ())?;
            self.advance();
        }
        sink.span(self.major, self.minor..self.minor.saturating_add(1), ())
    }
}

impl Primitive for Line {}

impl Dimensions for Line {
    fn bounding_box(&self) -> Rectangle {
        let (a, b) = (self.start, self.end);
        let size = |a: i32, b: i32| a.abs_diff(b).saturating_add(1);
        Rectangle::new(a.component_min(b), Size::new(size(a.x, b.x), size(a.y, b.y)))
    }
}

impl<C: PixelColor> StyledDimensions<StrokeStyle<C>> for Line {
    fn styled_bounding_box(&self, _style: &StrokeStyle<C>) -> Rectangle {
        self.bounding_box()
    }
}

impl<C: PixelColor> StyledDrawable<StrokeStyle<C>> for Line {
    type Color = C;
    type Output = ();

    fn draw_styled<D: DrawTarget<Color = C>>(&self, style: &StrokeStyle<C>, target: &mut D) -> Result<(), D::Error> {
        let bounds = Rect::from(target.bounding_box());
        if self.start.x == self.end.x || self.start.y == self.end.y {
            let visible = bounds.intersection(self.bounding_box().into());
            return if visible.is_empty() { Ok(()) } else { target.fill_solid(&visible.into(), style.color) };
        }
        let Some((walk, steps)) = Walk::of(self, bounds) else { return Ok(()) };
        if walk.runs_are_long() {
            walk.flat(steps, &mut Paint::new(target, style.color))
        } else {
            target.draw_iter(walk.points(steps).map(|point| Pixel(point, style.color)))
        }
    }
}
