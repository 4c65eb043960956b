//! 4 × 4 ordered dither: 17 shades from 16 pixels. Lecture 7.4.3.
//!
//! Every pixel has a rank by its place in a 4 × 4 cell. A light between two levels of the panel,
//! `t` of the way from the darker to the brighter, shows the brighter one where
//! `t > (rank + ½) / 16`: on average over a cell that is the light that was meant, to 1/32 of the
//! step.
//!
//! ```text
//!    0  8  2 10
//!   12  4 14  6        ranks (B. E. Bayer, "An optimum method for two-level
//!    3 11  1  9        rendition of continuous-tone pictures", IEEE ICC 1973)
//!   15  7 13  5
//! ```
//!
//! The cell is fixed to the screen. So bands, tiles and partial redraws agree to the pixel, and
//! a change repaints nothing outside of itself.

use core::ops::Range;

use crate::{
    colour::Light,
    display::level::Levels,
    num::high_u16,
    space::Rect,
    target::{Code, Target, phase, repeated},
};

/// How light between two levels is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// 4 × 4 ordered dither: the default.
    #[default]
    Ordered4x4,
    /// No dither: the nearer of the two levels.
    Nearest,
}

/// Rank of each pixel of a cell, rows from the top.
pub const BAYER_4X4: [[u8; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];

/// Takes light and gives the panel's codes, dithered: a [`Target`] of light on a target of colours.
///
/// ```
/// use aquatint::{Dithered, Frame, Levels, Light, Rows, Target};
/// use embedded_graphics::pixelcolor::BinaryColor;
///
/// let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 4], 8, 4).unwrap();
/// let mut dithered = Dithered::new(&mut frame, Levels::ONE_BIT);
/// for row in 0..4 {
///     dithered.fill_run(row, 0..8, [Light(32_768)]).unwrap();
/// }
/// assert_eq!(frame.bytes(), [0b1010_1010, 0b0101_0101, 0b1010_1010, 0b0101_0101]);
/// ```
#[derive(Debug)]
pub struct Dithered<'t, 'l, T> {
    target: &'t mut T,
    levels: Levels<'l>,
    method: Method,
}

impl<'t, 'l, T: Target> Dithered<'t, 'l, T>
where
    T::Color: Code,
{
    /// Dithers onto `target`, whose codes give `levels` of light.
    ///
    /// With fewer levels than the target has codes, the codes above are not used; codes that the
    /// target does not have lose their upper bits.
    pub const fn new(target: &'t mut T, levels: Levels<'l>) -> Self {
        Self { target, levels, method: Method::Ordered4x4 }
    }

    /// The same by another method.
    #[must_use]
    pub fn with_method(self, method: Method) -> Self {
        Self { method, ..self }
    }
}

impl<T: Target> Target for Dithered<'_, '_, T>
where
    T::Color: Code,
{
    type Color = Light;
    type Error = T::Error;

    fn bounds(&self) -> Rect {
        self.target.bounds()
    }

    fn fill_run<const N: usize>(&mut self, row: i32, columns: Range<i32>, colors: [Light; N]) -> Result<(), T::Error> {
        let mut quantiser = Quantiser::new(self.levels, self.method.thresholds(row));
        let mut code = |(column, light)| T::Color::from_code(quantiser.code(column, light));
        if let [light] = *colors.as_slice() {
            // Four thresholds make four colours of one light.
            self.target.fill_run(row, columns, [0, 1, 2, 3].map(|column| code((column, light))))
        } else if N.is_multiple_of(4) {
            let mut column = 0;
            let codes = colors.map(|light| {
                column += 1;
                code((column - 1, light))
            });
            self.target.fill_run(row, columns, codes)
        } else {
            self.write_run(row, columns.clone(), repeated(&colors, columns.start).map(Some))
        }
    }

    fn write_run(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: impl Iterator<Item = Option<Light>>,
    ) -> Result<(), T::Error> {
        let mut quantiser = Quantiser::new(self.levels, self.method.thresholds(row));
        let codes = columns
            .clone()
            .zip(colors)
            .map(|(column, light)| light.map(|light| T::Color::from_code(quantiser.code(column, light))));
        self.target.write_run(row, columns, codes)
    }
}

impl Method {
    /// The thresholds of the columns of a row, in 32nds of the step between two levels.
    fn thresholds(self, row: i32) -> [u8; 4] {
        match self {
            // (rank + ½) / 16
            Self::Ordered4x4 => phase(&BAYER_4X4, row).unwrap_or_default().map(|rank| 2 * rank + 1),
            Self::Nearest => [16; 4],
        }
    }
}

/// Turns light into codes along one row.
///
/// Remembers between which two levels the last pixel was: light changes little along a run, so that most pixels
/// cost two comparisons and no search.
#[derive(Clone, Copy, Debug)]
struct Quantiser<'l> {
    levels: Levels<'l>,
    /// Of the four columns, in 32nds of a step.
    thresholds: [u8; 4],
    /// The step that holds from … to, both included.
    from: u16,
    to: u16,
    code: u8,
    /// For each of the four columns, the light above which the brighter code is shown.
    switch: [u16; 4],
}

impl<'l> Quantiser<'l> {
    fn new(levels: Levels<'l>, thresholds: [u8; 4]) -> Self {
        // An empty step, which no light is in.
        Self { levels, thresholds, from: 1, to: 0, code: 0, switch: [0; 4] }
    }

    #[inline]
    fn code(&mut self, column: i32, light: Light) -> u8 {
        if light.0 < self.from || light.0 > self.to {
            self.find(light);
        }
        self.code + u8::from(phase(&self.switch, column).is_some_and(|switch| light.0 > switch))
    }

    fn find(&mut self, light: Light) {
        let step = self.levels.around(light);
        // Lights beyond the first and the last level belong to the outer steps.
        (self.from, self.to) = (step.dark.min(light.0), step.bright.max(light.0));
        self.code = step.code;
        // t > threshold/32, multiplied out; the floor is exact because lights are whole numbers.
        let gap = u32::from(step.bright.saturating_sub(step.dark));
        self.switch = self.thresholds.map(|threshold| {
            let above = gap * u32::from(threshold) / 32;
            step.dark.saturating_add(high_u16(above << 16))
        });
    }
}
