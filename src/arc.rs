//! Arcs of circles and ellipses as straight edges, and what is bounded by them: ovals, sectors, chords.
//!
//! ```text
//!            270°                     Angles as everywhere on a screen: 0° points to the right, and they grow
//!          ╭──●──╮                    from there downwards, clockwise.
//!         ╱       ╲
//!   180° ●    ●────● 0°               n chords over an angle θ are at most r·θ²/8n² off, here 0.20 sixteenths
//!         ╲       ╱                   of a pixel; the sine takes 0.05 at most, rounding 0.71. In all 0.96
//!          ╰──●──╯                    sixteenths.
//!            90°
//! ```
//!
//! - **Takes** a centre and two radii in sixteenths of a pixel, a start and a sweep in [`Angle`]s.
//! - **Gives** a [`Pen`] vertices, on sixteenths of a pixel or, for antialiasing, on 256ths. Each is computed for itself, so nothing drifts; whole ovals are symmetric in
//!   both axes to the last bit.
//! - **Memory** none.
//! - **Cost** a vertex is eight multiplications of 64 bits; no division. A whole circle has 128 vertices at a
//!   radius of 30 pixels, twice as many at four times that; never more than 65,536.

use crate::{
    angle::{Angle, sine_and_cosine},
    edge::LIMIT,
    error::OutOfRange,
    num::{Subpixel, low_i32, low_u32},
    outline::{FINE, Outline, Pen, enlarged, trace_large},
    space::Point2,
};

/// A circle or an ellipse with its axes along those of the screen, anywhere between the pixels.
///
/// For circles and ellipses of whole pixels, as embedded-graphics draws them, see [`Circle`](crate::Circle)
/// and [`Ellipse`](crate::Ellipse).
///
/// ```
/// use aquatint::{FillStyle, Oval, Point2, Subpixel};
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
///
/// let mut display = MockDisplay::new();
/// let oval = Oval::new(Point2::corner(4, 2), [64, 32].map(Subpixel::from_bits)).unwrap();
/// oval.into_styled(FillStyle::new(BinaryColor::On)).draw(&mut display)?;
/// display.assert_pattern(&[
///     " ###### ",
///     "########",
///     "########",
///     " ###### ",
/// ]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Oval {
    center: Point2,
    radii: [Subpixel; 2],
}

impl Oval {
    /// An ellipse from its centre and its radii along x and y.
    ///
    /// # Errors
    /// [`OutOfRange`] when a radius is negative, or any point of it 4,194,304 pixels or more from the origin.
    pub const fn new(center: Point2, radii: [Subpixel; 2]) -> Result<Self, OutOfRange> {
        let [x, y] = [radii[0].to_bits(), radii[1].to_bits()];
        let is_within = center.within(LIMIT)
            && x >= 0
            && y >= 0
            && (x.unsigned_abs()) < LIMIT - center.x.to_bits().unsigned_abs()
            && (y.unsigned_abs()) < LIMIT - center.y.to_bits().unsigned_abs();
        if is_within { Ok(Self { center, radii }) } else { Err(OutOfRange) }
    }

    /// A circle from its centre and its radius.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub const fn circle(center: Point2, radius: Subpixel) -> Result<Self, OutOfRange> {
        Self::new(center, [radius; 2])
    }

    /// The arc from `start` over `sweep` parts of a turn.
    #[must_use]
    pub const fn arc(self, start: Angle, sweep: i32) -> Arc {
        Arc::new(self, start, sweep)
    }

    /// The same sixteen times as large, if that is in range.
    fn enlarged(&self) -> Option<Self> {
        let radii = self.radii.map(|radius| Subpixel::from_bits(radius.to_bits() * FINE));
        Self::new(enlarged(self.center), radii).ok()
    }

    /// The vertex at a turn of 2³² parts, to the nearest sixteenth on each axis.
    fn vertex(&self, turn: u32) -> Point2 {
        let (sin, cos) = sine_and_cosine(turn);
        // Rounded without its sign, so that both halves are the same.
        let part = |radius: Subpixel, sine: i64| {
            let magnitude = (i64::from(radius.to_bits()) * sine.abs() + (1 << 30)) >> 31;
            low_i32(if sine < 0 { -magnitude } else { magnitude })
        };
        let [x, y] = self.radii;
        let Point2 { x: center_x, y: center_y } = self.center;
        Point2::from_sixteenths(center_x.to_bits() + part(x, cos), center_y.to_bits() + part(y, sin))
    }
}

impl Outline for Oval {
    /// Clockwise from the right.
    fn trace<P: Pen>(&self, pen: &mut P) {
        let mut vertices = self.arc(Angle(0), Arc::TURN).vertices();
        // The last one is the first again.
        let rest = vertices.len().saturating_sub(2);
        if let Some(first) = vertices.next() {
            pen.move_to(first);
            vertices.take(rest).for_each(|vertex| pen.line_to(vertex));
            pen.close();
        }
    }

    /// With vertices on 256ths of a pixel where all of it is less than 262,144 pixels from the origin.
    fn trace_fine<P: Pen>(&self, pen: &mut P) {
        trace_large(self.enlarged(), self, pen);
    }
}

/// A part of an oval: an open contour. Filled, it is the same as a [`Chord`].
///
/// ```
/// use aquatint::{Angle, Oval, Point2, Subpixel, pixel_bounds};
///
/// let circle = Oval::circle(Point2::corner(0, 0), Subpixel::from_num(10)).unwrap();
/// // A quarter, from the right clockwise to the bottom.
/// let quarter = circle.arc(Angle(0), i32::from(Angle::QUARTER.0));
/// assert_eq!(pixel_bounds(&quarter), aquatint::Rect::new(0, 0, 10, 10));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Arc {
    oval: Oval,
    start: Angle,
    sweep: i32,
}

impl Arc {
    /// The sweep of a whole turn, in the parts in which an [`Angle`] counts.
    pub const TURN: i32 = 1 << 16;

    /// The arc from `start` over `sweep` parts of a turn: clockwise, or counter-clockwise if that is negative. A
    /// sweep of more than a turn is a turn.
    ///
    /// On ellipses that are not circles the angle is the parameter of the ellipse, as it is in SVG: 45° lies on
    /// the diagonal of the box around it.
    #[must_use]
    pub const fn new(oval: Oval, start: Angle, sweep: i32) -> Self {
        let sweep = if sweep > Self::TURN {
            Self::TURN
        } else if sweep < -Self::TURN {
            -Self::TURN
        } else {
            sweep
        };
        Self { oval, start, sweep }
    }

    /// Where it begins.
    #[must_use]
    pub fn start_point(&self) -> Point2 {
        self.oval.vertex(u32::from(self.start.0) << 16)
    }

    /// The same sixteen times as large, if that is in range.
    pub(crate) fn enlarged(&self) -> Option<Self> {
        Some(Self { oval: self.oval.enlarged()?, ..*self })
    }

    /// The vertices, the first and the last included.
    pub(crate) fn vertices(&self) -> Vertices {
        let k = self.halvings();
        // Exact: a sweep is a multiple of 2¹⁶ here, and k at most 16.
        let step = low_u32((i64::from(self.sweep) << 16) >> k);
        Vertices { oval: self.oval, turn: u32::from(self.start.0) << 16, step, left: (1 << k) + 1 }
    }

    /// The least k so that 2^k chords are at most 0.2 sixteenths from the arc: `4ᵏ > 25·r·(sweep/turn)²`, where
    /// 25 is a little more than `(2π)²/8 / 0.2`.
    fn halvings(&self) -> u32 {
        let [x, y] = self.oval.radii.map(|radius| u64::from(radius.to_bits().unsigned_abs()));
        let sweep = u64::from(self.sweep.unsigned_abs());
        let chords = (25 * x.max(y) * sweep * sweep) >> 32;
        (u64::BITS - chords.leading_zeros()).div_ceil(2)
    }
}

impl Outline for Arc {
    fn trace<P: Pen>(&self, pen: &mut P) {
        let mut vertices = self.vertices();
        if let Some(first) = vertices.next() {
            pen.move_to(first);
            vertices.for_each(|vertex| pen.line_to(vertex));
        }
    }

    /// As [`Oval`].
    fn trace_fine<P: Pen>(&self, pen: &mut P) {
        trace_large(self.enlarged(), self, pen);
    }
}

/// The vertices of an arc, one after the other.
pub(crate) struct Vertices {
    oval: Oval,
    turn: u32,
    step: u32,
    left: usize,
}

impl Iterator for Vertices {
    type Item = Point2;

    fn next(&mut self) -> Option<Point2> {
        self.left = self.left.checked_sub(1)?;
        let vertex = self.oval.vertex(self.turn);
        self.turn = self.turn.wrapping_add(self.step);
        Some(vertex)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.left, Some(self.left))
    }
}

impl ExactSizeIterator for Vertices {}

/// What an arc cuts off from its oval: the arc and the straight edge between its ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Chord(pub Arc);

impl Outline for Chord {
    fn trace<P: Pen>(&self, pen: &mut P) {
        self.0.trace(pen);
        pen.close();
    }

    /// As [`Oval`].
    fn trace_fine<P: Pen>(&self, pen: &mut P) {
        trace_large(self.0.enlarged().map(Self), self, pen);
    }
}

/// A piece of a pie: an arc and straight edges from its ends to the centre.
///
/// ```text
///   ╭───╮
///   │   ●──        from 0° over three quarters
///   ╰───┴─
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sector(pub Arc);

impl Outline for Sector {
    fn trace<P: Pen>(&self, pen: &mut P) {
        pen.move_to(self.0.oval.center);
        self.0.vertices().for_each(|vertex| pen.line_to(vertex));
        pen.close();
    }

    /// As [`Oval`].
    fn trace_fine<P: Pen>(&self, pen: &mut P) {
        trace_large(self.0.enlarged().map(Self), self, pen);
    }
}
