//! Dither along a curve: each pixel answers for those that the walk came from.
//!
//! ```text
//!   errors of the last 16 pixels   1 1 1 2 2 3 3 4 4 5 6 8 9 11 13 16     sixteenths of each
//!                                  oldest ─────────────────▶ last
//! ```
//!
//! A space-filling curve goes in all directions, so there is no grain in any, and an error is felt nearby only.
//! T. Riemersma, "A balanced dithering technique", C/C++ Users Journal 16(12), 1998, with a history of 16; I. H. Witten
//! and R. M. Neal, "Using Peano curves for bilevel display of continuous-tone images", IEEE CG&A 2(3), 1982,
//! with the carry alone.

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Point, Size},
    primitives::Rectangle,
};

use super::{
    hilbert::Hilbert,
    nearest::{Nearest, Steps},
};
use crate::{colour::Light, display::level::Levels, num::low_u8, space::Rect, target::Code};

/// What a pixel is told of the errors before it.
pub trait History: Default + sealed::Sealed {
    /// What the next pixel has to make up for.
    fn correction(&self) -> i32;

    /// Remembers a pixel: its light, what it was with the correction, and what is shown.
    fn remember(&mut self, light: i32, value: i32, shown: i32);
}

/// The whole error of the last pixel, and nothing else: keeps tone exactly.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Carry {
    /// At most half a step.
    error: i32,
}

/// Riemersma's: parts of the errors of the last 16 pixels. Softer, and high in contrast: what is darker than a
/// thirteenth of a step becomes black, what is as near to white white.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Riemersma {
    /// The oldest first.
    errors: [i32; 16],
}

/// Sixteenths, from the oldest error to the last: each greater by the fifteenth root of 16, rounded.
const WEIGHTS: [i32; 16] = [1, 1, 1, 2, 2, 3, 3, 4, 4, 5, 6, 8, 9, 11, 13, 16];

impl History for Carry {
    #[inline]
    fn correction(&self) -> i32 {
        self.error
    }

    #[inline]
    fn remember(&mut self, _: i32, value: i32, shown: i32) {
        self.error = value - shown;
    }
}

impl History for Riemersma {
    #[inline]
    fn correction(&self) -> i32 {
        // 89 sixteenths of all light at most.
        let sum: i32 = self.errors.iter().zip(WEIGHTS).map(|(error, weight)| error * weight).sum();
        (sum + 8) >> 4
    }

    #[inline]
    fn remember(&mut self, light: i32, _: i32, shown: i32) {
        self.errors.copy_within(1.., 0);
        let [.., last] = &mut self.errors;
        *last = light - shown;
    }
}

/// Dithers a picture along [Hilbert's curve](Hilbert), remembering errors by `H`.
///
/// Light is asked for pixel by pixel, in the order of the curve, so the picture must be at hand as a whole. The
/// memory is that of the history, 4 or 64 bytes; a pixel costs 230 instructions with [`Carry`], 280 with [`Riemersma`].
///
/// ```
/// use aquatint::{Frame, Levels, Light, Pages, display::diffuse::{AlongCurve, Carry}};
/// use embedded_graphics::{geometry::{Point, Size}, pixelcolor::BinaryColor, primitives::Rectangle};
///
/// let mut frame = Frame::<BinaryColor, Pages, _>::with_array([0; 16], 16, 8).unwrap();
/// let area = Rectangle::new(Point::zero(), Size::new(16, 8));
/// AlongCurve::<Carry>::new(Levels::ONE_BIT).draw(&mut frame, area, |_| Light::from_srgb(188))?;
/// assert_eq!(frame.bytes().iter().map(|byte| byte.count_ones()).sum::<u32>(), 64);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct AlongCurve<'l, H> {
    levels: Steps<'l>,
    history: H,
}

impl<'l, H: History> AlongCurve<'l, H> {
    /// For a panel whose codes give `levels` of light.
    #[must_use]
    pub fn new(levels: Levels<'l>) -> Self {
        Self { levels: Steps::new(levels), history: H::default() }
    }

    /// Draws the visible part of an area; `light` is asked for points of the display.
    ///
    /// # Errors
    /// What the display says.
    pub fn draw<D>(
        mut self,
        display: &mut D,
        area: Rectangle,
        mut light: impl FnMut(Point) -> Light,
    ) -> Result<(), D::Error>
    where
        D: DrawTarget,
        D::Color: Code,
    {
        let visible = Rect::from(area).intersection(display.bounding_box().into());
        let curve = Hilbert::new(Size::new(visible.width(), visible.height()));
        display.draw_iter(curve.map(|Point { x, y }| {
            // Inside of a rectangle of the screen.
            let point = Point::new(visible.left.saturating_add(x), visible.top.saturating_add(y));
            Pixel(point, D::Color::from_code(self.code(light(point))))
        }))
    }

    #[inline]
    fn code(&mut self, light: Light) -> u8 {
        let light = self.levels.displayable(light);
        let value = light + self.history.correction();
        let (code, shown) = self.levels.nearest(value);
        self.history.remember(light, value, shown);
        low_u8(code)
    }
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::Carry {}
    impl Sealed for super::Riemersma {}
}
