//! Image scaling: a picture of one size becomes one of another, in linear light. Lecture 7.3.
//!
//! - **Takes** rows of light from the top, as a decoder gives them.
//! - **Gives** the rows of the scaled picture as soon as they are known.
//! - **Memory** of the caller, eight bytes for each column of the scaled picture.
//! - **Cost** [`Filter::Area`] some 20 instructions a pixel of the source where sizes are multiples, 40 where not;
//!   [`Filter::Bilinear`] 45 a pixel of the result. Divisions only when a [`Scaler`] is made.
//!
//! ```text
//!   source    │ 0 │ 1 │ 2 │ 3 │ 4 │      area: 5 columns become 2, each the mean of 2½
//!   scaled    │    0    │    1    │
//!
//!   source      •   •   •   •   •        bilinear: between the two nearest pixel centres
//!   scaled         •         •
//! ```
//!
//! Both are exact: a pixel is the true mean, respectively the true interpolation, of 16-bit lights, rounded to
//! the nearest. So a flat picture stays flat, and the mean light of a picture, which the area filter keeps, is right
//! to half a 65535th. Averages of codes instead of light would darken everything that is fine and bright.

use crate::{
    colour::Light,
    error::describe,
    num::{count, divide_floor_i32, low_i32, low_u16},
};

use embedded_graphics::geometry::Size;

/// How the light between and below the pixels of the source is found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Filter {
    /// The mean of the area that a pixel of the result covers: for reduction, where nothing is lost. For
    /// enlargement it repeats pixels.
    #[default]
    Area,
    /// Interpolated between the four nearest pixel centres: for enlargement. In a reduction by more than two it
    /// leaves out pixels.
    Bilinear,
}

/// What cannot be scaled. Nothing was drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum ScaleError {
    /// A picture has no pixels.
    Empty,
    /// A picture is wider or higher than [`Scaler::MOST`].
    TooLarge,
    /// The memory is too short.
    TooShort {
        /// How many elements are needed.
        needed: usize,
    },
}

describe! { ScaleError,
    Self::Empty => "a picture has no pixels";
    Self::TooLarge => "a picture is wider or higher than {} pixels", Scaler::MOST;
    Self::TooShort { needed } => "{needed} elements are needed";
}

/// Scales a picture row by row.
///
/// ```
/// use aquatint::{Light, display::scale::{Filter, Scaler}};
/// use embedded_graphics::geometry::Size;
///
/// // Four by two pixels become two by one.
/// let mut memory = [0; 2];
/// let mut scaler = Scaler::new(&mut memory, Size::new(4, 2), Size::new(2, 1), Filter::Area).unwrap();
/// let mut scaled = Vec::new();
/// for row in [[0, 65_535, 100, 101], [65_535, 0, 102, 101]] {
///     scaler.push(row.iter().copied().map(Light), |_, row| Ok::<_, ()>(scaled.extend(row)))?;
/// }
/// assert_eq!(scaled, [Light(32_768), Light(101)]);
/// # Ok::<(), ()>(())
/// ```
#[derive(Debug)]
pub struct Scaler<'m> {
    /// By area: the light so far in the low 48 bits, the finished one in the high 16. Bilinear: the light of the last
    /// row but one in the high half, that of the last row in the low half, both times the parts of a column.
    cells: &'m mut [u64],
    from: Size,
    to: Size,
    filter: Filter,
    /// The next row of the source, and of the result.
    row: u32,
    finished: u32,
    /// By area: what the row at work has still to get.
    room: u32,
    /// Bilinear: between which rows of the source the row at work is.
    down: Position,
    divider: Divider,
}

impl Scaler<'_> {
    /// Pictures may have as many columns and rows.
    pub const MOST: u32 = 32_767;

    /// Elements of memory for a result of this size: one for each column.
    #[must_use]
    pub const fn memory_needed(to: Size) -> usize {
        count(to.width as u64)
    }
}

impl<'m> Scaler<'m> {
    /// Gets ready to scale from one size to another. What the memory holds does not matter.
    ///
    /// # Errors
    /// [`ScaleError`].
    pub fn new(memory: &'m mut [u64], from: Size, to: Size, filter: Filter) -> Result<Self, ScaleError> {
        let sides = [from.width, from.height, to.width, to.height];
        if sides.contains(&0) {
            return Err(ScaleError::Empty);
        }
        if sides.iter().any(|&side| side > Self::MOST) {
            return Err(ScaleError::TooLarge);
        }
        let needed = Scaler::memory_needed(to);
        let cells = memory.get_mut(..needed).ok_or(ScaleError::TooShort { needed })?;
        // Areas are counted in parts of a pixel, of which a column has as many as the other picture has columns.
        let parts = match filter {
            Filter::Area => from.width * from.height,
            Filter::Bilinear => 4 * to.width * to.height,
        };
        let down = Position::new(from.height, to.height);
        let mut new =
            Self { cells, from, to, filter, row: 0, finished: 0, room: 0, down, divider: Divider::new(parts) };
        new.restart();
        Ok(new)
    }

    /// The size of the source.
    #[must_use]
    pub const fn from(&self) -> Size {
        self.from
    }

    /// The size of the result.
    #[must_use]
    pub const fn to(&self) -> Size {
        self.to
    }

    /// Forgets all rows: the next is the first of another picture of the same size.
    pub fn restart(&mut self) {
        self.cells.fill(0);
        (self.row, self.finished, self.room) = (0, 0, self.from.height);
        self.down = Position::new(self.from.height, self.to.height);
    }

    /// Takes the next row of the source, and calls `finished` for each row of the result that is known now, with its
    /// number. These may be none, or many.
    ///
    /// A row that is too short goes on with its last light; what is too much, also rows, is left out.
    ///
    /// # Errors
    /// The first one of `finished`. Go on with [`restart`](Self::restart).
    pub fn push<E>(
        &mut self,
        lights: impl Iterator<Item = Light> + Clone,
        finished: impl FnMut(u32, ScaledRow<'_>) -> Result<(), E>,
    ) -> Result<(), E> {
        if self.row >= self.from.height {
            return Ok(());
        }
        self.row += 1;
        match self.filter {
            Filter::Area => self.push_area(&lights, finished),
            Filter::Bilinear => self.push_bilinear(lights, finished),
        }
    }

    fn push_area<E>(
        &mut self,
        lights: &(impl Iterator<Item = Light> + Clone),
        mut finished: impl FnMut(u32, ScaledRow<'_>) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut left = self.to.height;
        while left > 0 {
            let part = left.min(self.room);
            (left, self.room) = (left - part, self.room - part);
            self.add_area(lights, part);
            if self.room == 0 {
                finished(self.finished, ScaledRow { cells: self.cells.iter(), mix: None })?;
                self.finished += 1;
                self.room = self.from.height;
            }
        }
        Ok(())
    }

    /// Adds a row, or a part of it, to the sums, and finishes them if that was all.
    fn add_area(&mut self, lights: &(impl Iterator<Item = Light> + Clone), part: u32) {
        let (mut lights, mut light, mut rest) = (lights.clone(), Light::BLACK, 0);
        for cell in self.cells.iter_mut() {
            let (mut room, mut whole) = (self.from.width, 0);
            let begun = rest.min(room);
            (rest, room) = (rest - begun, room - begun);
            let mut sum = u32::from(light.0) * begun;
            while room >= self.to.width {
                light = lights.next().unwrap_or(light);
                whole += u32::from(light.0);
                room -= self.to.width;
            }
            sum += whole * self.to.width;
            if room > 0 {
                light = lights.next().unwrap_or(light);
                sum += u32::from(light.0) * room;
                rest = self.to.width - room;
            }
            let sum = (*cell & LOW_48) + u64::from(sum) * u64::from(part);
            *cell = if self.room == 0 { u64::from(self.divider.mean(sum).0) << 48 } else { sum };
        }
    }

    fn push_bilinear<E>(
        &mut self,
        lights: impl Iterator<Item = Light>,
        mut finished: impl FnMut(u32, ScaledRow<'_>) -> Result<(), E>,
    ) -> Result<(), E> {
        self.interpolate(lights);
        let (below, is_last) = (self.row.cast_signed(), self.row == self.from.height);
        while self.finished < self.to.height && (self.down.whole + 2 <= below || is_last) {
            // Beyond the last centre there is nothing to be mixed with.
            let lower = if self.down.whole + 2 > below { self.down.parts } else { self.down.part };
            let mix = Mix { upper: self.down.parts - lower, lower, divider: self.divider };
            finished(self.finished, ScaledRow { cells: self.cells.iter(), mix: Some(mix) })?;
            self.finished += 1;
            self.down.advance();
        }
        Ok(())
    }

    /// Makes a row of the source the lower one of two.
    fn interpolate(&mut self, mut lights: impl Iterator<Item = Light>) {
        let mut across = Position::new(self.from.width, self.to.width);
        let first = lights.next().unwrap_or_default();
        let (mut left, mut right, mut column) = (first, first, 0);
        for cell in self.cells.iter_mut() {
            while column <= across.whole {
                (left, right, column) = (right, lights.next().unwrap_or(right), column + 1);
            }
            let sum = u32::from(left.0) * (across.parts - across.part) + u32::from(right.0) * across.part;
            let upper = if self.row == 1 { sum.into() } else { *cell & u64::from(u32::MAX) };
            *cell = upper << 32 | u64::from(sum);
            across.advance();
        }
    }
}

const LOW_48: u64 = (1 << 48) - 1;

/// A row of a scaled picture.
#[derive(Clone, Debug)]
pub struct ScaledRow<'s> {
    cells: core::slice::Iter<'s, u64>,
    mix: Option<Mix>,
}

/// How two rows are mixed.
#[derive(Clone, Copy, Debug)]
struct Mix {
    upper: u32,
    lower: u32,
    divider: Divider,
}

impl ScaledRow<'_> {
    fn light(mix: Option<Mix>, cell: u64) -> Light {
        let Some(Mix { upper, lower, divider }) = mix else { return Light(low_u16_of(cell >> 48)) };
        divider.mean((cell >> 32) * u64::from(upper) + (cell & u64::from(u32::MAX)) * u64::from(lower))
    }
}

impl Iterator for ScaledRow<'_> {
    type Item = Light;

    fn next(&mut self) -> Option<Light> {
        self.cells.next().map(|cell| Self::light(self.mix, *cell))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.cells.size_hint()
    }
}

impl DoubleEndedIterator for ScaledRow<'_> {
    fn next_back(&mut self) -> Option<Light> {
        self.cells.next_back().map(|cell| Self::light(self.mix, *cell))
    }
}

impl ExactSizeIterator for ScaledRow<'_> {}

/// Where the centre of a pixel of the result lies between centres of the source.
#[derive(Clone, Copy, Debug)]
struct Position {
    /// The centre before it; -1 before the first.
    whole: i32,
    /// How far behind it, in `parts` of a pixel.
    part: u32,
    parts: u32,
    step: (i32, u32),
}

impl Position {
    /// Of the first pixel. The sizes are at most [`Scaler::MOST`].
    const fn new(from: u32, to: u32) -> Self {
        // (2i + 1) from / (2 to) - ½
        let parts = 2 * to;
        let (whole, part) = divide_floor_i32(from.cast_signed() - to.cast_signed(), parts.cast_signed());
        let (step, rest) = divide_floor_i32(from.cast_signed(), to.cast_signed());
        Self { whole, part: part.cast_unsigned(), parts, step: (step, 2 * rest.cast_unsigned()) }
    }

    fn advance(&mut self) {
        let (whole, part) = self.step;
        (self.whole, self.part) = (self.whole.saturating_add(whole), self.part + part);
        if self.part >= self.parts {
            (self.whole, self.part) = (self.whole.saturating_add(1), self.part - self.parts);
        }
    }
}

/// Divides sums of lights by the sum of their weights.
#[derive(Clone, Copy, Debug)]
struct Divider {
    weights: u64,
    /// Leading zeros of the weights in 32 bits.
    shift: u32,
    /// 2⁶³ by the weights without these, rounded down; 32 bits.
    inverse: u64,
}

impl Divider {
    const fn new(weights: u32) -> Self {
        let shift = weights.leading_zeros() & 31;
        let (weights, normal) = (weights as u64, (weights << shift) as u64);
        let inverse = match i64::MAX.cast_unsigned().checked_div(normal) {
            Some(inverse) => inverse,
            None => 0,
        };
        Self { weights, shift, inverse }
    }

    /// The quotient, rounded to the nearest; the sum is that of 16-bit lights times the weights.
    #[inline]
    fn mean(&self, sum: u64) -> Light {
        let sum = sum + self.weights / 2;
        // The product is too small by 2⁻¹⁴ at most: rounded down it is the quotient, or one less.
        let below = (((sum << self.shift) >> 16) * self.inverse) >> 47;
        let is_less = (below + 1) * self.weights <= sum;
        Light(low_u16_of(below + u64::from(is_less)))
    }
}

/// A light that fits by its meaning.
#[inline]
fn low_u16_of(light: u64) -> u16 {
    low_u16(low_i32(light.cast_signed()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn means_are_exact() {
        let mut random = 1_u64;
        for weights in [1, 2, 3, 7, 255, 256, 65_535, 65_537, 0x7FFF_FFFF, 0x8000_0001, u32::MAX, 640 * 480] {
            let (divider, weights) = (Divider::new(weights), u64::from(weights));
            for _ in 0..10_000 {
                random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                let sum = (random >> 16) % (65_535 * weights + 1);
                for sum in [sum, sum / weights * weights, 65_535 * weights, sum / weights * weights + weights / 2] {
                    let sum = sum.min(65_535 * weights);
                    assert_eq!(u64::from(divider.mean(sum).0), (sum + weights / 2) / weights, "{sum} / {weights}");
                }
            }
        }
    }
}
