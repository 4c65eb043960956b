//! Affine maps of the screen: outlines moved, turned, scaled and sheared.
//!
//! ```text
//!   x' = xx·x + xy·y + x₀          ┌───┐          ╱╲
//!   y' = yx·x + yy·y + y₀          │ F │   ──▶   ╱F  ╲
//!                                  └───┘         ╲  ╱
//! ```
//!
//! Elements are 16.16, places sixteenths of a pixel. A product is exact in 64 bits and rounded once, so a
//! vertex that two outlines share is shared afterwards. What lands outside of ±134,217,727 pixels saturates.

use embedded_graphics::{geometry::Point, transform::Transform};

use crate::{
    angle::Angle,
    num::{Scalar, Subpixel, format_fixed, saturate_i32},
    outline::{FINE, Outline, Pen},
    pieces::Curve,
    space::Point2,
};

/// A map of the screen onto itself that keeps straight lines straight.
///
/// ```
/// use aquatint::{Affine, Angle, Point2, Scalar};
///
/// // Twice as large, then a quarter turn about the corner of the screen, then 10 pixels to the right.
/// let two = Scalar::from_num(2);
/// let map = Affine::scale(two, two).then(Affine::turn(Angle::QUARTER)).then(Affine::translation(Point2::corner(10, 0)));
/// // y grows downwards, so that turns are clockwise.
/// assert_eq!(map.apply(Point2::corner(3, 1)), Point2::corner(8, 6));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Affine {
    /// What x and y give to the new x …
    x: [Scalar; 2],
    /// … and to the new y.
    y: [Scalar; 2],
    origin: Point2,
}

format_fixed! {
    impl[] |it: Affine| "Affine {{ x: {}, y: {}, origin: {} }}", Fixed(it.x), Fixed(it.y), it.origin
}

impl Affine {
    /// Everything stays where it is.
    pub const IDENTITY: Self =
        Self::new([Scalar::ONE, Scalar::ZERO], [Scalar::ZERO, Scalar::ONE], Point2::corner(0, 0));

    /// The map with `x' = x[0]·x + x[1]·y + origin.x`, `y' = y[0]·x + y[1]·y + origin.y`.
    #[must_use]
    pub const fn new(x: [Scalar; 2], y: [Scalar; 2], origin: Point2) -> Self {
        Self { x, y, origin }
    }

    /// The corner of the screen goes to a point, and all else with it.
    #[must_use]
    pub const fn translation(to: Point2) -> Self {
        Self { origin: to, ..Self::IDENTITY }
    }

    /// Larger or smaller along the axes, mirrored where negative; the corner of the screen stays.
    #[must_use]
    pub const fn scale(x: Scalar, y: Scalar) -> Self {
        Self::new([x, Scalar::ZERO], [Scalar::ZERO, y], Point2::corner(0, 0))
    }

    /// Clockwise about the corner of the screen. Right to 9 · 10⁻⁵ of the distance from there.
    #[must_use]
    pub fn turn(angle: Angle) -> Self {
        let (sin, cos) = (angle.sin(), angle.cos());
        Self::new([cos, -sin], [sin, cos], Point2::corner(0, 0))
    }

    /// The same about another point than the corner of the screen.
    #[must_use]
    pub fn about(self, centre: Point2) -> Self {
        let back = Point2::new(centre.x.saturating_neg(), centre.y.saturating_neg());
        Self::translation(back).then(self).then(Self::translation(centre))
    }

    /// What x and y give to the new x and to the new y, and where the corner of the screen goes.
    pub(crate) const fn parts(self) -> ([Scalar; 2], [Scalar; 2], Point2) {
        (self.x, self.y, self.origin)
    }

    /// First this one, then another. Elements saturate and are rounded to 16.16, each time anew.
    #[must_use]
    pub fn then(self, next: Self) -> Self {
        let element = |row: [Scalar; 2], column: usize| {
            let [a, b] = [self.x, self.y].map(|of| of.get(column).copied().unwrap_or_default());
            Scalar::from_bits(saturate_i32(combined(row, [a.to_bits(), b.to_bits()], 16)))
        };
        Self::new(
            [element(next.x, 0), element(next.x, 1)],
            [element(next.y, 0), element(next.y, 1)],
            next.apply(self.origin),
        )
    }

    /// Where a point goes. Two 64-bit multiplications and one rounding a coordinate.
    #[must_use]
    pub fn apply(self, point: Point2) -> Point2 {
        self.apply_times(1, point)
    }

    /// Where a point goes on a screen so many times as large.
    fn apply_times(self, times: i32, point: Point2) -> Point2 {
        self.place([point.x, point.y].map(Subpixel::to_bits), 16, times)
    }

    /// Where a place in pixels of 16.16 goes on a screen so many times, 1 or 16, as large: rounded only there.
    pub(crate) fn apply_units(self, times: i32, units: [i32; 2]) -> Point2 {
        self.place(units, if times == 1 { 28 } else { 24 }, times)
    }

    /// Drops so many bits of the products.
    fn place(self, of: [i32; 2], bits: u32, times: i32) -> Point2 {
        let coordinate = |row, origin: Subpixel| {
            saturate_i32(combined(row, of, bits).saturating_add(i64::from(origin.to_bits()) * i64::from(times)))
        };
        Point2::from_sixteenths(coordinate(self.x, self.origin.x), coordinate(self.y, self.origin.y))
    }
}

/// `row[0]·of[0] + row[1]·of[1]`, without so many fraction bits, to the nearest.
fn combined([a, b]: [Scalar; 2], of: [i32; 2], bits: u32) -> i64 {
    let product = |factor: Scalar, of: i32| i64::from(factor.to_bits()) * i64::from(of);
    // Each product is at most 2⁶²; two of these at the negative end are one too many.
    product(a, of[0]).saturating_add(product(b, of[1])).saturating_add(1 << (bits - 1)) >> bits
}

/// An outline that is mapped as it is traced.
///
/// Edges and curves are mapped, and curves are cut behind the map, so that they stay smooth where they are scaled up. A curve
/// that would reach 1,048,576 pixels from the origin is cut before.
///
/// ```
/// use aquatint::{Affine, FillStyle, Placed, Point2, Polygon, Scalar};
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
///
/// let corners = [(0, 0), (3, 0), (0, 3)].map(|(x, y)| Point2::corner(x, y));
/// let contours = [&corners[..]];
/// let mirrored = Affine::scale(-Scalar::ONE, Scalar::ONE).then(Affine::translation(Point2::corner(4, 0)));
///
/// let mut display = MockDisplay::new();
/// let flag = Placed::new(Polygon::new(&contours).unwrap(), mirrored);
/// flag.into_styled(FillStyle::new(BinaryColor::On)).draw(&mut display)?;
/// display.assert_pattern(&[
///     " ###",
///     "  ##",
///     "   #",
/// ]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Placed<O> {
    outline: O,
    map: Affine,
}

impl<O: Outline> Placed<O> {
    /// An outline and where it goes.
    pub const fn new(outline: O, map: Affine) -> Self {
        Self { outline, map }
    }

    /// The same outline, mapped once more.
    #[must_use]
    pub fn then(self, next: Affine) -> Self {
        Self { map: self.map.then(next), ..self }
    }
}

impl<O: Outline> Outline for Placed<O> {
    const WINDS_ONE_WAY: bool = O::WINDS_ONE_WAY;

    fn trace<P: Pen>(&self, pen: &mut P) {
        self.outline.trace(&mut Mapped { pen, map: self.map, times: 1 });
    }

    /// The edges that the outline itself is traced by for antialiasing, mapped: sixteen times as near to its curves.
    /// Points of it that are out of range, 4,194,304 pixels or more from the origin, are moved to the border of the
    /// range before.
    fn trace_fine<P: Pen>(&self, pen: &mut P) {
        self.outline.trace_fine(&mut Mapped { pen, map: self.map, times: FINE });
    }
}

impl<O: Outline + Clone> Transform for Placed<O> {
    /// The same outline so many pixels to the right and down.
    fn translate(&self, by: Point) -> Self {
        self.clone().then(Affine::translation(Point2::corner(by.x, by.y)))
    }

    fn translate_mut(&mut self, by: Point) -> &mut Self {
        self.map = self.map.then(Affine::translation(Point2::corner(by.x, by.y)));
        self
    }
}

/// Hands mapped points on, of a screen so many times as large.
struct Mapped<'p, P> {
    pen: &'p mut P,
    map: Affine,
    times: i32,
}

impl<P: Pen> Pen for Mapped<'_, P> {
    fn move_to(&mut self, point: Point2) {
        self.pen.move_to(self.map.apply_times(self.times, point));
    }

    fn line_to(&mut self, point: Point2) {
        self.pen.line_to(self.map.apply_times(self.times, point));
    }

    fn curve_to(&mut self, curve: &Curve) {
        let directions = Affine { origin: Point2::corner(0, 0), ..self.map };
        match curve.mapped(|point| self.map.apply_times(self.times, point), |radius| directions.apply(radius)) {
            Some(mapped) => self.pen.curve_to(&mapped),
            None => curve.each(|vertex| self.line_to(vertex)),
        }
    }

    fn close(&mut self) {
        self.pen.close();
    }
}
