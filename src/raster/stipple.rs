//! Stippled lines: a pattern of on and off along a line of single pixels.
//!
//! ```text
//!   pattern 1111_0011_0000_1100, times 1     ●━━━  ━━    ━━  ━━━━  ━━●
//!   pattern 10 …, times 3                    ●━━   ━━━   ━━━   ━━━   ●
//! ```
//!
//! The pattern begins at the start of the line, seen or not: clipping, bands and windows do not move it.
//! The pixels are those of [Bresenham's line](super::bresenham).

use crate::{
    num::saturate_u32,
    raster::{
        axes::{Axes, emit_runs},
        bresenham::{Line, Walk},
    },
    span::Sink,
};

/// Sixteen bits along a line: the highest is for its first pixels.
///
/// ```
/// use aquatint::{Brush, Frame, Line, Rows, Stipple};
/// use embedded_graphics::{geometry::Point, pixelcolor::BinaryColor};
///
/// let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 2], 16, 1).unwrap();
/// let line = Line::new(Point::new(0, 0), Point::new(15, 0));
/// Stipple::new(0b1100_1100_1100_1100).times(2).spans(&line, &mut Brush::new(&mut frame, BinaryColor::On))?;
/// assert_eq!(frame.bytes(), [0b1111_0000, 0b1111_0000]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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

    /// Emits those pixels of a line that lie inside the bounds of `sink` and whose bit is set, neighbours in
    /// a row as one span.
    ///
    /// Spans come along the line or against it, so their rows may run upwards. Costs one 32-bit division
    /// more than the line, and some additions a pixel.
    ///
    /// # Errors
    /// What the sink says.
    pub fn spans<S: Sink>(&self, line: &Line, sink: &mut S) -> Result<(), S::Error> {
        let Some((walk, steps)) = Walk::of(line, sink.bounds()) else { return Ok(()) };
        // Steps count from the end that comes first on the driving axis.
        let (axes, first) = (Axes::new(line.start, line.end), saturate_u32(steps.start));
        let is_reversed = axes.point() != line.start;
        let from_start = if is_reversed { axes.along.saturating_sub(first) } else { first };
        let mut phase = Phase::at(*self, from_start);
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
