//! Patterns that repeat in both directions: tiles of colours, hatches, stencils. Lecture 4.2.4.
//!
//! ```text
//!   DIAGONAL    CROSS       BRICKS
//!   #.......    #.#.#.#.    ########
//!   .#......    ........    #.......
//!   ..#.....    #.#.#.#.    #.......
//! ```

use core::ops::Range;

use embedded_graphics::geometry::Point;

use crate::{
    phase::{phase, turned},
    target::{Ink, Target},
};

/// A tile of `W` × `H` colours, again and again.
///
/// Widths of 1, 2, 4 and 8 fill packed frames a word at a time; others pixel by pixel.
///
/// ```
/// use aquatint::{Brush, Frame, Pattern, Point2, Polygon, Rows, Rule, raster::scan::ActiveEdge};
/// use embedded_graphics::{pixelcolor::BinaryColor, prelude::*};
/// use heapless::Vec;
///
/// let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 4], 8, 4).unwrap();
/// let square = [(0, 0), (8, 0), (8, 3), (0, 3)].map(|(x, y)| Point2::corner(x, y));
/// let shape = [&square[..]];
/// // Every second pixel, shifted from row to row.
/// let checks = Pattern::from_bits([0b1010_1010, 0b0101_0101], BinaryColor::On, BinaryColor::Off);
/// let mut edges = Vec::<ActiveEdge, 4>::new();
/// Polygon::new(&shape).unwrap().spans(Rule::NonZero, &mut edges, &mut Brush::new(&mut frame, checks))?;
/// assert_eq!(frame.bytes(), [0b1010_1010, 0b0101_0101, 0b1010_1010, 0]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Pattern<C, const W: usize, const H: usize> {
    rows: [[C; W]; H],
    anchor: Point,
}

impl<C: Copy, const W: usize, const H: usize> Pattern<C, W, H> {
    /// The colours of a tile, row by row. A tile without a pixel draws nothing.
    pub const fn new(rows: [[C; W]; H]) -> Self {
        Self { rows, anchor: Point::zero() }
    }

    /// The same with the corner of a tile at another place than the corner of the screen.
    #[must_use]
    pub const fn anchored(self, anchor: Point) -> Self {
        Self { anchor, ..self }
    }
}

impl<C: Copy, const H: usize> Pattern<C, 8, H> {
    /// A tile of two colours, eight wide: a byte a row, the highest bit on the left.
    #[must_use]
    pub fn from_bits(bits: [u8; H], on: C, off: C) -> Self {
        let row = |byte: u8| [7, 6, 5, 4, 3, 2, 1, 0].map(|bit| if byte >> bit & 1 == 1 { on } else { off });
        Self::new(bits.map(row))
    }
}

impl<C: Copy, const W: usize, const H: usize> Ink for Pattern<C, W, H> {
    type Color = C;

    fn fill<T: Target<Color = C>>(&self, target: &mut T, row: i32, columns: Range<i32>) -> Result<(), T::Error> {
        let Some(colors) = line_of(&self.rows, row, self.anchor) else { return Ok(()) };
        target.fill_run(row, columns, turned(&colors, self.anchor.x))
    }
}

/// One colour where the bits of a tile are set; what lies under the others stays.
///
/// ```
/// use aquatint::{Frame, Ink, Rows, Stencil};
/// use embedded_graphics::pixelcolor::BinaryColor;
///
/// let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0b1111_0000], 8, 1).unwrap();
/// Stencil::new([0b0101_0101], BinaryColor::On).fill(&mut frame, 0, 0..8)?;
/// assert_eq!(frame.bytes(), [0b1111_0101]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Stencil<C, const H: usize> {
    bits: [u8; H],
    color: C,
    anchor: Point,
}

impl<C: Copy, const H: usize> Stencil<C, H> {
    /// A tile eight wide: a byte a row, the highest bit on the left.
    pub const fn new(bits: [u8; H], color: C) -> Self {
        Self { bits, color, anchor: Point::zero() }
    }

    /// The same with the corner of a tile at another place than the corner of the screen.
    #[must_use]
    pub const fn anchored(self, anchor: Point) -> Self {
        Self { anchor, ..self }
    }
}

impl<C: Copy, const H: usize> Ink for Stencil<C, H> {
    type Color = C;

    fn fill<T: Target<Color = C>>(&self, target: &mut T, row: i32, columns: Range<i32>) -> Result<(), T::Error> {
        let Some(byte) = line_of(&self.bits, row, self.anchor) else { return Ok(()) };
        // What lies beside the target is not passed over bit by bit.
        let Some(columns) = target.bounds().clip_run(row, columns) else { return Ok(()) };
        // From the first column of the run on, the highest bit first.
        let mut bits = byte.rotate_left(columns.start.wrapping_sub(self.anchor.x).cast_unsigned() & 7);
        let colors = core::iter::repeat_with(|| {
            bits = bits.rotate_left(1);
            (bits & 1 == 1).then_some(self.color)
        });
        target.write_run(row, columns, colors)
    }
}

/// The tile's row on a row of the screen.
fn line_of<L: Copy, const H: usize>(rows: &[L; H], row: i32, anchor: Point) -> Option<L> {
    phase(rows, row.wrapping_sub(anchor.y))
}

/// Tiles of eight by eight for [`Pattern::from_bits`] and [`Stencil`].
pub mod hatch {
    /// Lines that fall to the right.
    pub const DIAGONAL: [u8; 8] = [0x80, 0x40, 0x20, 0x10, 0x08, 0x04, 0x02, 0x01];
    /// Lines that rise to the right.
    pub const BACK_DIAGONAL: [u8; 8] = [0x01, 0x02, 0x04, 0x08, 0x10, 0x20, 0x40, 0x80];
    /// Both diagonals.
    pub const DIAGONAL_CROSS: [u8; 8] = [0x81, 0x42, 0x24, 0x18, 0x18, 0x24, 0x42, 0x81];
    /// A line in every fourth row.
    pub const HORIZONTAL: [u8; 4] = [0xFF, 0, 0, 0];
    /// A line in every fourth column.
    pub const VERTICAL: [u8; 1] = [0x88];
    /// Horizontal and vertical lines.
    pub const CROSS: [u8; 4] = [0xFF, 0x88, 0x88, 0x88];
    /// A wall.
    pub const BRICKS: [u8; 8] = [0xFF, 0x80, 0x80, 0x80, 0xFF, 0x08, 0x08, 0x08];
    /// Every fourth pixel of every second row, shifted from one to the next: the lightest shade that
    /// still looks even.
    pub const DOTS: [u8; 4] = [0x88, 0, 0x22, 0];
    /// Every second pixel.
    pub const CHECKS: [u8; 2] = [0xAA, 0x55];
}
