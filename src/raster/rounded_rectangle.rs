//! Rectangles with round corners, each with a radius of its own.
//!
//! ```text
//!      ╭──────────╮      radii in the order of CSS: top left, top right,
//!      │          │      bottom right, bottom left
//!      │          │
//!      └─────────╯       0 is a sharp corner
//! ```
//!
//! Radii that do not fit, because two of them together are longer than the side between, are all made smaller by
//! the same factor, until they do: CSS Backgrounds and Borders, section "Corner overlap".

use crate::{
    angle::Angle,
    arc::Oval,
    edge::LIMIT,
    error::OutOfRange,
    num::{Subpixel, divide_floor, format_fixed, saturate_i32},
    outline::{FINE, Outline, Pen, fine, trace_large},
    space::Point2,
};

/// A rectangle with round corners, to a sixteenth of a pixel.
///
/// ```
/// use aquatint::{FillStyle, Point2, RoundedRectangle, Subpixel};
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
///
/// let mut display = MockDisplay::new();
/// let [one, other] = [(0, 0), (8, 5)].map(|(x, y)| Point2::corner(x, y));
/// let button = RoundedRectangle::new([one, other], Subpixel::from_num(2)).unwrap();
/// button.into_styled(FillStyle::new(BinaryColor::On)).draw(&mut display)?;
/// display.assert_pattern(&[
///     " ###### ",
///     "########",
///     "########",
///     "########",
///     " ###### ",
/// ]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RoundedRectangle {
    top_left: Point2,
    bottom_right: Point2,
    /// They fit.
    radii: [Subpixel; 4],
}

format_fixed! {
    impl[] |it: RoundedRectangle| "RoundedRectangle {{ top_left: {}, bottom_right: {}, radii: {} }}",
    it.top_left, it.bottom_right, Fixed(it.radii)
}

impl RoundedRectangle {
    /// A rectangle between two opposite corners, with the same radius at all of them.
    ///
    /// # Errors
    /// [`OutOfRange`] when a corner is 4,194,304 pixels or more from the origin.
    pub fn new([one, other]: [Point2; 2], radius: Subpixel) -> Result<Self, OutOfRange> {
        if !(one.within(LIMIT) && other.within(LIMIT)) {
            return Err(OutOfRange);
        }
        let top_left = Point2::new(one.x.min(other.x), one.y.min(other.y));
        let bottom_right = Point2::new(one.x.max(other.x), one.y.max(other.y));
        Ok(Self { top_left, bottom_right, radii: [Subpixel::ZERO; 4] }.with_radii([radius; 4]))
    }

    /// The same with other radii: top left, top right, bottom right, bottom left. Negative ones are zero, and
    /// those that do not fit are made smaller together. One 64-bit division each then.
    #[must_use]
    pub fn with_radii(self, radii: [Subpixel; 4]) -> Self {
        let wanted = radii.map(|radius| i64::from(radius.to_bits().max(0)));
        let [top_left, top_right, bottom_right, bottom_left] = wanted;
        let width = i64::from(self.bottom_right.x.to_bits() - self.top_left.x.to_bits());
        let height = i64::from(self.bottom_right.y.to_bits() - self.top_left.y.to_bits());
        let (across, down) = (
            (top_left + top_right).max(bottom_right + bottom_left),
            (top_left + bottom_left).max(top_right + bottom_right),
        );
        // The smaller one of width / across and height / down.
        let (side, sum) = if width * down <= height * across { (width, across) } else { (height, down) };
        let fitted = |radius: i64| if side < sum { divide_floor(radius * side, sum).0 } else { radius };
        Self { radii: wanted.map(|radius| Subpixel::from_bits(saturate_i32(fitted(radius)))), ..self }
    }

    /// The radii that are drawn.
    #[must_use]
    pub const fn radii(&self) -> [Subpixel; 4] {
        self.radii
    }

    /// The same sixteen times as large, if that is in range.
    fn enlarged(&self) -> Option<Self> {
        let (top_left, bottom_right) = (fine(self.top_left)?, fine(self.bottom_right)?);
        // They fit between the corners.
        let radii = self.radii.map(|radius| Subpixel::from_bits(radius.to_bits() * FINE));
        Some(Self { top_left, bottom_right, radii })
    }

    /// The corners: how far into the rectangle its circle has its centre, and where its arc begins.
    fn corners(&self) -> [(Point2, Angle); 4] {
        let (Point2 { x: left, y: top }, Point2 { x: right, y: bottom }) = (self.top_left, self.bottom_right);
        let [a, b, c, d] = self.radii;
        [
            (Point2::new(left + a, top + a), Angle(0x8000)),
            (Point2::new(right - b, top + b), Angle(0xC000)),
            (Point2::new(right - c, bottom - c), Angle(0)),
            (Point2::new(left + d, bottom - d), Angle(0x4000)),
        ]
    }
}

impl Outline for RoundedRectangle {
    /// Clockwise from the left end of the arc at the top left.
    fn trace<P: Pen>(&self, pen: &mut P) {
        let mut last = None;
        for ((center, start), radius) in self.corners().into_iter().zip(self.radii) {
            let Ok(circle) = Oval::circle(center, radius) else { return };
            let arc = circle.arc(start, Angle::QUARTER.0.into());
            match last {
                None => pen.move_to(arc.start_point()),
                Some(last) if last == arc.start_point() => {}
                Some(_) => pen.line_to(arc.start_point()),
            }
            let curve = arc.curve().distinct();
            pen.curve_to(&curve);
            last = Some(curve.vertex(curve.pieces()));
        }
        pen.close();
    }

    /// With vertices on 256ths of a pixel where it is less than 262,144 pixels from the origin.
    fn trace_fine<P: Pen>(&self, pen: &mut P) {
        trace_large(self.enlarged(), self, pen);
    }
}
