//! Stippled lines: a pattern of on and off along a line of single pixels.
//!
//! ```text
//!   pattern 1111_0011_0000_1100, times 1     ●━━━  ━━    ━━  ━━━━  ━━●
//!   pattern 10 …, times 3                    ●━━   ━━━   ━━━   ━━━   ●
//! ```
//!
//! The pattern begins at the start of the line, seen or not: clipping, bands and windows do not move it.
//! The pixels are those of [Bresenham's line](super::bresenham).

use embedded_graphics::{
    draw_target::DrawTarget,
    geometry::Dimensions,
    pixelcolor::PixelColor,
    primitives::{Primitive, Rectangle, StyledDimensions, StyledDrawable},
};

use crate::{
    num::saturate_u32,
    raster::{
        axes::{Axes, emit_runs},
        bresenham::{Line, Walk},
    },
    span::Sink,
    style::StrokeStyle,
    target::Paint,
};

/// Sixteen bits along a line: the highest is for its first pixels.
///
/// ```
/// use aquatint::{Line, Stipple, StrokeStyle};
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
///
/// let line = Line::new(Point::new(0, 0), Point::new(15, 3));
/// let dashes = Stipple::new(0b1100_1100_1100_1100).times(2).along(line);
///
/// let mut display = MockDisplay::new();
/// dashes.into_styled(StrokeStyle::new(BinaryColor::On)).draw(&mut display)?;
/// display.assert_pattern(&[
///     "###             ",
///     "   #            ",
///     "        ####    ",
/// ]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Stipple {
    pattern: u16,
    times: u8,
}

impl Stipple {
    /// A pattern, one pixel a bit.
    #[must_use]
    pub const fn new(pattern: u16) -> Self {
        Self { pattern, times: 1 }
    }

    /// Each bit for this many pixels; 0 counts as 1.
    #[must_use]
    pub const fn times(self, times: u8) -> Self {
        Self { times: if times == 0 { 1 } else { times }, ..self }
    }

    /// The pattern along a line.
    #[must_use]
    pub const fn along(self, line: Line) -> StippledLine {
        StippledLine { line, stipple: self }
    }
}

/// A line of single pixels, of which a pattern says which are drawn. Right for all coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct StippledLine {
    line: Line,
    stipple: Stipple,
}

impl StippledLine {
    /// Emits those pixels inside the bounds of `sink` whose bit is set, neighbours in a row as one span.
    ///
    /// Spans come along the line or against it, so their rows may run upwards. Costs one 32-bit division
    /// more than the line, and some additions a pixel.
    ///
    /// # Errors
    /// What the sink says.
    pub fn spans<S: Sink>(&self, sink: &mut S) -> Result<(), S::Error> {
        let Some((walk, steps)) = Walk::of(&self.line, sink.bounds()) else { return Ok(()) };
        // Steps count from the end that comes first on the driving axis.
        let (axes, first) = (Axes::new(self.line.start, self.line.end), saturate_u32(steps.start));
        let is_reversed = axes.point() != self.line.start;
        let from_start = if is_reversed { axes.along.saturating_sub(first) } else { first };
        let mut phase = Phase::at(self.stipple, from_start);
        let visible = walk.points(steps).filter(|_| {
            let is_on = phase.is_on();
            if is_reversed {
                phase.back();
            } else {
                phase.forth();
            }
            is_on
        });
        emit_runs(visible, sink)
    }
}

impl Primitive for StippledLine {}

impl Dimensions for StippledLine {
    /// That of the whole line.
    fn bounding_box(&self) -> Rectangle {
        self.line.bounding_box()
    }
}

impl<C: PixelColor> StyledDimensions<StrokeStyle<C>> for StippledLine {
    fn styled_bounding_box(&self, _style: &StrokeStyle<C>) -> Rectangle {
        self.bounding_box()
    }
}

impl<C: PixelColor> StyledDrawable<StrokeStyle<C>> for StippledLine {
    type Color = C;
    type Output = ();

    /// One pixel wide, whatever the width of the stroke.
    fn draw_styled<D: DrawTarget<Color = C>>(&self, style: &StrokeStyle<C>, target: &mut D) -> Result<(), D::Error> {
        self.spans(&mut Paint::new(target, style.color))
    }
}

/// A place in a pattern.
struct Phase {
    stipple: Stipple,
    /// The bit, counted from the highest one.
    bit: u8,
    /// How many of its pixels come before.
    pixel: u8,
}

impl Phase {
    /// That of a pixel of a line, counted from its start.
    fn at(stipple: Stipple, pixel: u32) -> Self {
        let times = u32::from(stipple.times).max(1);
        let [bit, _, _, _] = (pixel / times % 16).to_le_bytes();
        let [pixel, _, _, _] = (pixel % times).to_le_bytes();
        Self { stipple, bit, pixel }
    }

    const fn is_on(&self) -> bool {
        self.stipple.pattern.rotate_left(self.bit as u32) >> 15 == 1
    }

    /// To the next pixel.
    const fn forth(&mut self) {
        self.pixel = self.pixel.wrapping_add(1);
        if self.pixel >= self.stipple.times {
            self.pixel = 0;
            self.bit = self.bit.wrapping_add(1) % 16;
        }
    }

    /// To the pixel before.
    const fn back(&mut self) {
        if self.pixel == 0 {
            self.pixel = self.stipple.times;
            self.bit = self.bit.wrapping_sub(1) % 16;
        }
        self.pixel = self.pixel.wrapping_sub(1);
    }
}
