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
    angle::Angle,
    edge::LIMIT,
    error::OutOfRange,
    num::{Subpixel, format_fixed},
    outline::{FINE, Outline, Pen, enlarged, trace_large},
    pieces::Curve,
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

format_fixed! {
    impl[] |it: Oval| "Oval {{ center: {}, radii: {} }}", it.center, Fixed(it.radii)
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
}

impl Outline for Oval {
    /// Clockwise from the right.
    fn trace<P: Pen>(&self, pen: &mut P) {
        let turn = self.arc(Angle(0), Arc::TURN);
        pen.move_to(turn.start_point());
        // The last vertex is the first again.
        pen.curve_to(&turn.curve().without_last());
        pen.close();
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
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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
        self.curve().vertex_at(0)
    }

    /// The same sixteen times as large, if that is in range.
    pub(crate) fn enlarged(&self) -> Option<Self> {
        Some(Self { oval: self.oval.enlarged()?, ..*self })
    }

    /// The arc as a curve from its start point on.
    pub(crate) fn curve(&self) -> Curve {
        let Oval { center, radii: [x, y] } = self.oval;
        let radii = [Point2::new(x, Subpixel::ZERO), Point2::new(Subpixel::ZERO, y)];
        Curve::arc(center, radii, u32::from(self.start.0) << 16, self.sweep)
    }
}

impl Outline for Arc {
    fn trace<P: Pen>(&self, pen: &mut P) {
        pen.move_to(self.start_point());
        pen.curve_to(&self.curve());
    }

    /// As [`Oval`].
    fn trace_fine<P: Pen>(&self, pen: &mut P) {
        trace_large(self.enlarged(), self, pen);
    }
}

/// What an arc cuts off from its oval: the arc and the straight edge between its ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Sector(pub Arc);

impl Outline for Sector {
    fn trace<P: Pen>(&self, pen: &mut P) {
        pen.move_to(self.0.oval.center);
        pen.line_to(self.0.start_point());
        pen.curve_to(&self.0.curve());
        pen.close();
    }

    /// As [`Oval`].
    fn trace_fine<P: Pen>(&self, pen: &mut P) {
        trace_large(self.0.enlarged().map(Self), self, pen);
    }
}
