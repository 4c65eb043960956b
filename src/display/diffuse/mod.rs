//! Error diffusion: what a pixel shows too much, its neighbours show too little. Lecture 7.4.
//!
//! - **Takes** rows of light, from the top.
//! - **Gives** the panel's codes, a row at a time, on any [`Target`].
//! - **Memory** of the caller: one row of 16-bit errors, two for kernels that reach two rows down;
//!   see [`Diffusion::memory_needed`].
//! - **Cost** instructions a pixel on one bit, 8-bit codes to packed bits: [`SierraLite`] 34, [`FloydSteinberg`] 41,
//!   [`Atkinson`] 44, [`Burkes`] 54, [`Stucki`] 72, [`JarvisJudiceNinke`] 76, by
//!   [`draw_packed_row`](Diffusion::draw_packed_row); some 25 more by [`draw_row`](Diffusion::draw_row).
//!
//! ```text
//!   light + errors ──▶ nearest level ──▶ code
//!      ▲                    │ what is left
//!      └── · X 7 ◀──────────┘
//!          3 5 1   sixteenths (Floyd and Steinberg)
//! ```
//!
//! It keeps detail and tone better than any ordered dither, but is **for whole pictures**: every pixel
//! depends on all before it, so a small change repaints a tenth of the picture. Where only parts are
//! drawn anew, and for everything that moves, use [`Dithered`](crate::display::dither::Dithered).
//!
//! Light is linear and has 16 bits. A pixel shows the level nearest to its light and the errors that it got, so its
//! own error is at most half of the step between two levels: 32767, which 16 bits hold. Of twelve pixels that share
//! with one, those of the rows above come to 36/48 at most, and what is stored fits too. Shares are rounded down, and
//! what that leaves goes straight down; what would leave at the sides is folded onto the outermost pixels. These get
//! more than one whole error then: where theirs would exceed half a step, it is cut. Else no light is lost but what
//! the last row hands on. The mean of a flat grey of 128 × 128 pixels is right to 1/480, by [`SierraLite`] to 1/512.

mod hilbert;
mod kernel;
mod nearest;
mod packed;
mod picture;
mod riemersma;
mod row;
mod window;

use core::{cell::Cell, marker::PhantomData};

use embedded_graphics::{geometry::Point, pixelcolor::raw::RawU1};

use self::{
    nearest::{OneBit, Steps},
    packed::IntoBytes,
    row::{Errors, Row, RunsOn, Words},
    window::MARGIN,
};
use crate::{
    colour::Light,
    display::{dither::PackedRows, frame::Frame, layout::Layout, level::Levels},
    error::describe,
    num::count,
    target::{Code, Target},
};

pub use hilbert::Hilbert;
pub use kernel::{Atkinson, Burkes, FloydSteinberg, JarvisJudiceNinke, Kernel, Sierra, SierraLite, Stucki, Weights};
pub use riemersma::{AlongCurve, Carry, History, Riemersma};

/// In which direction the rows are walked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Scan {
    /// To the right, and back to the left: patterns have no direction.
    #[default]
    Serpentine,
    /// All rows from the left.
    Raster,
}

/// Memory that cannot hold what has to be remembered. Nothing was drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TooShort {
    /// How many elements are needed.
    pub needed: usize,
}

describe! { TooShort, Self { needed } => "{needed} elements are needed"; }

/// Diffuses a picture row by row, by the kernel `K`.
///
/// ```
/// use aquatint::{Frame, Levels, Light, Rows, display::diffuse::{Diffusion, SierraLite}};
/// use embedded_graphics::{pixelcolor::BinaryColor, prelude::*};
///
/// let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 8], 16, 4).unwrap();
/// let mut memory = [0; Diffusion::<SierraLite>::memory_needed(16)];
/// let mut diffusion = Diffusion::<SierraLite>::new(&mut memory, 16, Levels::ONE_BIT).unwrap();
/// for (y, codes) in (0..).zip([[188_u8; 16]; 4]) {
///     diffusion.draw_row(&mut frame, Point::new(0, y), codes.iter().map(|&code| Light::from_srgb(code)))?;
/// }
/// // Code 188 is half of the light.
/// assert_eq!(frame.bytes().iter().map(|byte| byte.count_ones()).sum::<u32>(), 32);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug)]
pub struct Diffusion<'m, 'l, K> {
    errors: &'m mut [i16],
    width: usize,
    levels: Levels<'l>,
    scan: Scan,
    /// Whether the next row is an odd one.
    is_odd: bool,
    kernel: PhantomData<K>,
}

impl<K: Kernel> Diffusion<'_, '_, K> {
    /// Elements of memory for a picture of this width: four more than it has columns, twice where the
    /// kernel reaches two rows down. `usize::MAX` where no memory could hold it.
    #[must_use]
    pub const fn memory_needed(width: u32) -> usize {
        let rows = if K::WEIGHTS.reaches_two_rows() { 2 } else { 1 };
        count((width as u64 + 2 * MARGIN as u64) * rows)
    }
}

impl<'m, 'l, K: Kernel> Diffusion<'m, 'l, K> {
    /// Gets ready for a picture of this width, for a panel whose codes give `levels` of light, in serpentines.
    ///
    /// What the memory holds does not matter.
    ///
    /// # Errors
    /// [`TooShort`] if `memory` has less than [`memory_needed`](Self::memory_needed) elements.
    pub fn new(memory: &'m mut [i16], width: u32, levels: Levels<'l>) -> Result<Self, TooShort> {
        let needed = Self::memory_needed(width);
        let errors = memory.get_mut(..needed).ok_or(TooShort { needed })?;
        let width = count(width.into());
        let mut new = Self { errors, width, levels, scan: Scan::Serpentine, is_odd: false, kernel: PhantomData };
        new.restart();
        Ok(new)
    }

    /// The same in another order.
    #[must_use]
    pub fn with_scan(self, scan: Scan) -> Self {
        Self { scan, ..self }
    }

    /// Forgets all errors: the next row is the first of another picture.
    pub fn restart(&mut self) {
        self.errors.fill(0);
        self.is_odd = false;
    }

    /// Draws the next row of the picture from `at` to the right.
    ///
    /// Lights beyond the picture's width are not looked at; a shorter row is diffused as one of a narrower picture.
    /// All pixels are computed, also those that the target does not have.
    ///
    /// # Errors
    /// What the display behind says. The rest of the row is not drawn then.
    pub fn draw_row<T, I>(&mut self, target: &mut T, at: Point, lights: I) -> Result<(), T::Error>
    where
        T: Target,
        T::Color: Code,
        I: IntoIterator<Item = Light>,
        I::IntoIter: DoubleEndedIterator + ExactSizeIterator,
    {
        self.walk(RunsOn { target, at }, lights.into_iter())
    }

    /// The same for frames of rows of one bit a pixel, in little more than half of the time.
    pub fn draw_packed_row<C, L, B, I>(&mut self, frame: &mut Frame<C, L, B>, at: Point, lights: I)
    where
        C: Code<Raw = RawU1>,
        L: PackedRows + Layout<C>,
        B: AsMut<[u8]>,
        I: IntoIterator<Item = Light>,
        I::IntoIter: DoubleEndedIterator + ExactSizeIterator,
    {
        let Ok(()) = self.walk(IntoBytes { frame, at }, lights.into_iter());
    }

    fn walk<W: Words>(
        &mut self,
        words: W,
        mut lights: impl DoubleEndedIterator<Item = Light> + ExactSizeIterator,
    ) -> Result<(), W::Error> {
        if let Some(last) = lights.len().saturating_sub(self.width).checked_sub(1) {
            lights.nth_back(last);
        }
        let leftwards = self.is_odd && self.scan == Scan::Serpentine;
        let mut row = Row { words, width: lights.len(), leftwards, kernel: PhantomData::<K> };
        let (levels, errors) = (self.levels, self.next_errors());
        if levels == Levels::ONE_BIT {
            row.draw(errors, OneBit, lights)
        } else {
            row.draw(errors, Steps::new(levels), lights)
        }
    }

    /// The errors for the next row, and those for the one below it.
    fn next_errors(&mut self) -> Errors<'_> {
        let is_odd = self.is_odd;
        self.is_odd = !is_odd;
        let cells = Cell::from_mut(&mut *self.errors).as_slice_of_cells();
        if !K::WEIGHTS.reaches_two_rows() {
            return Errors { here: cells, below: cells };
        }
        let (one, other) = cells.split_at(cells.len() / 2);
        if is_odd { Errors { here: other, below: one } } else { Errors { here: one, below: other } }
    }
}
