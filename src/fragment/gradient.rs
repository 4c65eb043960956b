//! Gradients: colours that change along a line or around a point.
//!
//! ```text
//!   linear                  radial
//!    from ●──────▶ to        ·░▒▓▒░·
//!    ░░▒▒▓▓██                ░▒▓●▓▒░
//!    ░░▒▒▓▓██                ·░▒▓▒░·
//! ```
//!
//! A gradient is a number for each pixel's centre, 0 at its beginning and 65535 at its end, and a ramp
//! that turns the number into a colour. For panels of few shades let it be [`Light`], on a
//! [`Dithered`](crate::Dithered) target; a ramp is linear in light then, as it ought to be.
//!
//! **Cost** of a run: three 64-bit multiplications; of a pixel: an addition and the ramp, for radial
//! gradients a comparison or two and a multiplication more. No division after construction.

use core::ops::Range;

use crate::{
    colour::Light,
    edge::LIMIT,
    num::{SUBPIXELS, divide_round, high_u16, low_u32, saturate_u16},
    space::{Point2, Rect},
    target::{Ink, Target},
};

/// What is beyond the ends of a gradient.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Extend {
    /// The colours of the ends.
    #[default]
    Pad,
    /// The gradient from its beginning, again and again.
    Repeat,
    /// The gradient forth and back.
    Reflect,
}

impl Extend {
    /// The number of a place that is `place / 2³²` of the way.
    #[inline]
    fn number(self, place: i64) -> u16 {
        let (turn, part) = (place >> 32, high_u16(low_u32(place)));
        match self {
            Self::Pad => saturate_u16(place >> 16),
            Self::Reflect if turn & 1 == 1 => u16::MAX - part,
            Self::Repeat | Self::Reflect => part,
        }
    }
}

/// A ramp between two lights, for either gradient.
///
/// ```
/// use aquatint::{Light, fragment::gradient::between};
///
/// let ramp = between(Light(1000), Light::WHITE);
/// assert_eq!([ramp(0), ramp(u16::MAX)], [Light(1000), Light::WHITE]);
/// ```
pub fn between(from: Light, to: Light) -> impl Fn(u16) -> Light + Copy {
    let gap = i64::from(to.0) - i64::from(from.0);
    // 65535 counts as 65536, so that the end is reached.
    move |number| {
        let part = i64::from(number) + i64::from(number >> 15);
        Light(saturate_u16(i64::from(from.0) + ((gap * part + 0x8000) >> 16)))
    }
}

/// A gradient along a line; across it nothing changes.
///
/// ```
/// use aquatint::{Dithered, Frame, Ink, Levels, Light, LinearGradient, Point2, Rows, fragment::gradient::between};
/// use embedded_graphics::pixelcolor::BinaryColor;
///
/// let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 16], 32, 4).unwrap();
/// let ramp = between(Light::BLACK, Light::WHITE);
/// let gradient = LinearGradient::new(Point2::corner(0, 0), Point2::corner(32, 0), ramp);
/// for row in 0..4 {
///     gradient.fill(&mut Dithered::new(&mut frame, Levels::ONE_BIT), row, 0..32)?;
/// }
/// assert_eq!(frame.bytes()[..4], [0b0000_1010, 0b1010_1010, 0b1110_1111, 0b1111_1111]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct LinearGradient<F> {
    from: Point2,
    /// Way in parts of 2³² for a sixteenth of a pixel.
    along: (i64, i64),
    extend: Extend,
    ramp: F,
}

impl<C, F: Fn(u16) -> C> LinearGradient<F> {
    /// From a point to a point. If they are the same, all of the screen is at the beginning.
    ///
    /// Points are moved into ±4,194,304 pixels. Two 64-bit divisions. The number of a pixel is right to one
    /// of its 65,536 steps within 4096 pixels of the beginning.
    pub fn new(from: Point2, to: Point2, ramp: F) -> Self {
        let (from, to) = (from.clamped(LIMIT), to.clamped(LIMIT));
        let between = |from: i32, to: i32| i64::from(to) - i64::from(from);
        let (dx, dy) = (between(from.x.to_bits(), to.x.to_bits()), between(from.y.to_bits(), to.y.to_bits()));
        let square = dx * dx + dy * dy;
        let along = |d: i64| divide_round(d << 32, square);
        Self { from, along: (along(dx), along(dy)), extend: Extend::Pad, ramp }
    }

    /// The same with another continuation beyond its ends.
    #[must_use]
    pub fn with_extend(self, extend: Extend) -> Self {
        Self { extend, ..self }
    }
}

impl<C: Copy, F: Fn(u16) -> C> Ink for LinearGradient<F> {
    type Color = C;

    fn fill<T: Target<Color = C>>(&self, target: &mut T, row: i32, columns: Range<i32>) -> Result<(), T::Error> {
        let Some(columns) = visible(target, row, columns) else { return Ok(()) };
        let (x, y) = from_centre(self.from, (columns.start, row));
        let mut place = x.saturating_mul(self.along.0).saturating_add(y.saturating_mul(self.along.1));
        let step = self.along.0.wrapping_mul(i64::from(SUBPIXELS));
        let colors = core::iter::repeat_with(|| {
            let number = self.extend.number(place);
            place = place.saturating_add(step);
            Some((self.ramp)(number))
        });
        target.write_run(row, columns, colors)
    }
}

/// A gradient around a point: it begins there and ends at a distance.
///
/// ```
/// use aquatint::{Light, Point2, RadialGradient, fragment::gradient::between};
///
/// let lamp = RadialGradient::new(Point2::corner(64, 32), 40 * 16, between(Light::WHITE, Light::BLACK));
/// # let _ = lamp;
/// ```
#[derive(Clone, Copy, Debug)]
pub struct RadialGradient<F> {
    centre: Point2,
    /// Way in parts of 2³² for a sixteenth of a pixel.
    along: i64,
    extend: Extend,
    ramp: F,
}

impl<C, F: Fn(u16) -> C> RadialGradient<F> {
    /// Around a point, with a radius in sixteenths of a pixel; with none, all is beyond the end.
    ///
    /// Points are moved into ±4,194,304 pixels. One 64-bit division. Distances are whole sixteenths, rounded
    /// down; the number of a pixel is right to one of its 65,536 steps within 4096 pixels of the centre.
    pub fn new(centre: Point2, radius: u32, ramp: F) -> Self {
        let along = if radius == 0 { i64::from(u32::MAX) } else { divide_round(1 << 32, i64::from(radius)) };
        Self { centre: centre.clamped(LIMIT), along, extend: Extend::Pad, ramp }
    }

    /// The same with another continuation beyond its end.
    #[must_use]
    pub fn with_extend(self, extend: Extend) -> Self {
        Self { extend, ..self }
    }
}

impl<C: Copy, F: Fn(u16) -> C> Ink for RadialGradient<F> {
    type Color = C;

    fn fill<T: Target<Color = C>>(&self, target: &mut T, row: i32, columns: Range<i32>) -> Result<(), T::Error> {
        let Some(columns) = visible(target, row, columns) else { return Ok(()) };
        let mut distance = Distance::new(from_centre(self.centre, (columns.start, row)));
        let colors = core::iter::repeat_with(|| {
            let number = self.extend.number(distance.root.saturating_mul(self.along));
            distance.advance();
            Some((self.ramp)(number))
        });
        target.write_run(row, columns, colors)
    }
}

/// Where distances can be computed exactly. No display is larger.
const FIELD: Rect = {
    let end = (LIMIT >> 4).cast_signed();
    Rect::new(-end, -end, end, end)
};

/// The part of a run that is on a target, and in the field.
fn visible<T: Target>(target: &T, row: i32, columns: Range<i32>) -> Option<Range<i32>> {
    target.bounds().intersection(FIELD).clip_run(row, columns)
}

/// From a point to the centre of a pixel, in sixteenths.
fn from_centre(point: Point2, (column, row): (i32, i32)) -> (i64, i64) {
    let centre = |pixel: i32| i64::from(pixel) * i64::from(SUBPIXELS) + i64::from(SUBPIXELS / 2);
    (centre(column) - i64::from(point.x.to_bits()), centre(row) - i64::from(point.y.to_bits()))
}

/// The distance of one pixel after the other from a point: `⌊√(x² + y²)⌋`, without a root in each.
///
/// From pixel to pixel it changes about as it did before; what is missing is a step or two.
struct Distance {
    x: i64,
    square: i64,
    root: i64,
    change: i64,
}

impl Distance {
    fn new((x, y): (i64, i64)) -> Self {
        let square = x * x + y * y;
        // Both are below 2²⁸.
        let root = square.unsigned_abs().isqrt().cast_signed();
        Self { x, square, root, change: 0 }
    }

    #[inline]
    fn advance(&mut self) {
        let step = i64::from(SUBPIXELS);
        self.square = self.square.wrapping_add((2 * self.x + step) * step);
        self.x += step;
        let before = self.root;
        self.root = (before + self.change).max(0);
        while self.root * self.root > self.square {
            self.root -= 1;
        }
        while (self.root + 1) * (self.root + 1) <= self.square {
            self.root += 1;
        }
        self.change = self.root - before;
    }
}
