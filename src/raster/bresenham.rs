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
    transform::Transform,
};

use crate::{
    num::{Subpixel, saturate_u32},
    raster::{axes::Axes, thick_line},
    space::Rect,
    span::Sink,
    style::{Stroke, StrokeStyle},
    target::Paint,
};

/// A line of single pixels, both ends included, or a [thick](super::thick_line) one between their centres. Right for all
/// coordinates.
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
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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
        if walk.axes.is_steep { walk.steep(steps, sink) } else { walk.flat(steps, sink) }
    }

    /// Emits the pixels of a [thick line](super::thick_line) between the centres of the two pixels, from top to bottom, one
    /// span a row. One pixel wide it is [`spans`](Self::spans), and has no caps.
    ///
    /// # Errors
    /// What the sink says.
    pub fn stroke_spans<S: Sink>(&self, stroke: Stroke, sink: &mut S) -> Result<(), S::Error> {
        if is_thin(stroke) { self.spans(sink) } else { thick_line::spans(self, stroke, sink) }
    }
}

/// One pixel wide.
fn is_thin(stroke: Stroke) -> bool {
    stroke.width == Subpixel::ONE
}

/// The line, standing on a pixel, and the error there.
pub(super) struct Walk {
    axes: Axes,
    error: u32,
}

impl Walk {
    /// The line, entered at its first visible pixel, and the steps from its first pixel that are visible.
    pub(super) fn of(line: &Line, window: Rect) -> Option<(Self, Range<u64>)> {
        let mut walk = Self { axes: Axes::new(line.start, line.end), error: 0 };
        let steps = walk.axes.visible((line.start, line.end), window, |distance| walk.first_step_with(distance));
        if steps.is_empty() {
            return None;
        }
        walk.enter(steps.start);
        Some((walk, steps))
    }

    /// Half the driving length: a tie rounds to the larger minor coordinate, which is on the way
    /// when it rises and not yet when it falls.
    fn bias(&self) -> u32 {
        let along = self.axes.along;
        if self.axes.direction > 0 { along / 2 } else { along.saturating_sub(1) / 2 }
    }

    /// The first step at which the minor axis has gone `distance`: `k·across + bias ≥ distance·along`.
    ///
    /// The products stay below 2⁶⁴ because `distance ≤ across ≤ along < 2³²` where it matters.
    fn first_step_with(&self, distance: u64) -> u64 {
        let (along, across) = (u64::from(self.axes.along), u64::from(self.axes.across));
        if distance > across || across == 0 {
            return u64::MAX;
        }
        (distance * along - u64::from(self.bias())).div_ceil(across)
    }

    /// Stands on pixel `step` of the line.
    fn enter(&mut self, step: u64) {
        let bias = u64::from(self.bias());
        let (along, travelled) = (u64::from(self.axes.along), step * u64::from(self.axes.across) + bias);
        if step == 0 || along == 0 {
            self.error = saturate_u32(bias);
            return;
        }
        self.error = saturate_u32(travelled % along);
        self.axes.go(saturate_u32(step), saturate_u32(travelled / along));
    }

    /// One pixel on.
    #[inline]
    fn advance(&mut self) {
        self.axes.major = self.axes.major.wrapping_add(1);
        // `error + across ≥ along`, written so that it cannot overflow.
        if self.error >= self.axes.along - self.axes.across {
            self.error = self.error.wrapping_sub(self.axes.along - self.axes.across);
            self.axes.minor = self.axes.minor.wrapping_add(self.axes.direction);
        } else {
            self.error = self.error.wrapping_add(self.axes.across);
        }
    }

    /// Whether filling runs costs less than setting pixels: three or more to a row, on average. A run on a
    /// packed frame costs about what three pixels cost.
    const fn runs_are_long(&self) -> bool {
        !self.axes.is_steep && self.axes.along / 3 >= self.axes.across
    }

    /// The pixels, one by one.
    pub(super) fn points(mut self, steps: Range<u64>) -> impl Iterator<Item = Point> {
        steps.map(move |_| {
            let point = self.axes.point();
            self.advance();
            point
        })
    }

    /// Driving axis horizontal: pixels of one row are one span.
    ///
    /// From row to row the error says how long the run is: `⌊along / across⌋` pixels or one more. So there is
    /// work for each run and none for each pixel ("run-slice": M. Abrash, *Graphics Programming Black Book*,
    /// chapter 36).
    fn flat<S: Sink>(mut self, steps: Range<u64>, sink: &mut S) -> Result<(), S::Error> {
        // A visible line is no longer than a picture is wide.
        let mut left = saturate_u32(steps.end - steps.start);
        let across = self.axes.across.max(1);
        let (shortest, rest) = (self.axes.along / across, self.axes.along % across);
        // The first run may begin anywhere in its row.
        let mut run = if self.axes.across == 0 { left } else { (self.axes.along - self.error).div_ceil(across) };
        self.error = self.error.wrapping_add(run.wrapping_mul(across)).wrapping_sub(self.axes.along);
        while run < left {
            let end = self.axes.major.wrapping_add_unsigned(run);
            sink.span(self.axes.minor, self.axes.major..end, ())?;
            (self.axes.major, self.axes.minor) = (end, self.axes.minor.wrapping_add(self.axes.direction));
            left -= run;
            let is_longer = self.error < rest;
            run = shortest + u32::from(is_longer);
            if is_longer {
                self.error = self.error.wrapping_add(across);
            }
            self.error = self.error.wrapping_sub(rest);
        }
        if left == 0 {
            Ok(())
        } else {
            sink.span(self.axes.minor, self.axes.major..self.axes.major.saturating_add_unsigned(left), ())
        }
    }

    /// Driving axis vertical: one pixel a row.
    fn steep<S: Sink>(mut self, steps: Range<u64>, sink: &mut S) -> Result<(), S::Error> {
        for _ in steps.start + 1..steps.end {
            sink.span(self.axes.major, self.axes.minor..self.axes.minor.saturating_add(1), ())?;
            self.advance();
        }
        sink.span(self.axes.major, self.axes.minor..self.axes.minor.saturating_add(1), ())
    }
}

impl Primitive for Line {}

impl Transform for Line {
    /// The same line elsewhere. Positions saturate.
    fn translate(&self, by: Point) -> Self {
        let moved = |end: Point| Point::new(end.x.saturating_add(by.x), end.y.saturating_add(by.y));
        Self::new(moved(self.start), moved(self.end))
    }

    fn translate_mut(&mut self, by: Point) -> &mut Self {
        *self = self.translate(by);
        self
    }
}

impl Dimensions for Line {
    fn bounding_box(&self) -> Rectangle {
        let (a, b) = (self.start, self.end);
        let size = |a: i32, b: i32| a.abs_diff(b).saturating_add(1);
        Rectangle::new(a.component_min(b), Size::new(size(a.x, b.x), size(a.y, b.y)))
    }
}

impl<C: PixelColor> StyledDimensions<StrokeStyle<C>> for Line {
    fn styled_bounding_box(&self, style: &StrokeStyle<C>) -> Rectangle {
        if is_thin(style.stroke) { self.bounding_box() } else { thick_line::bounding_box(self, style.stroke) }
    }
}

impl<C: PixelColor> StyledDrawable<StrokeStyle<C>> for Line {
    type Color = C;
    type Output = ();

    fn draw_styled<D: DrawTarget<Color = C>>(&self, style: &StrokeStyle<C>, target: &mut D) -> Result<(), D::Error> {
        if !is_thin(style.stroke) {
            return thick_line::spans(self, style.stroke, &mut Paint::new(target, style.color));
        }
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
