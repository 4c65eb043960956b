//! One dirty window: where it is, and its bytes, borrowed from the frame or copied into one piece.

use core::iter::zip;

use crate::{
    display::{
        dirty::grid::{Part, Picture},
        frame::TooSmall,
    },
    space::Rect,
};

/// A window of a frame that is to be sent, in whole bytes.
///
/// ```text
///   area, in pixels          slices: one for each line of each plane
///   ┌───────────┐
///   │           │            ░░░▓▓▓▓▓▓░░░░░
///   │           │            ░░░▓▓▓▓▓▓░░░░░
///   └───────────┘            ░░░▓▓▓▓▓▓░░░░░
/// ```
#[derive(Clone, Debug)]
pub struct DirtyWindow<'f> {
    picture: Picture<'f>,
    /// The planes that are left of it: the number of the first, and how many.
    planes: (usize, usize),
    part: Part,
    area: Rect,
}

impl<'f> DirtyWindow<'f> {
    pub(super) const fn new(picture: Picture<'f>, part: Part, area: Rect) -> Self {
        Self { planes: (0, picture.planes), picture, part, area }
    }

    /// The pixels, none of them outside of the picture.
    #[must_use]
    pub const fn area(&self) -> Rect {
        self.area
    }

    /// Only one plane, counted from 0; without bytes where the layout has fewer.
    #[must_use]
    pub fn plane(self, index: usize) -> Self {
        let (first, count) = self.planes;
        Self { planes: (first.saturating_add(index), usize::from(index < count)), ..self }
    }

    /// The bytes line by line, plane after plane: rows, pages or columns, as they lie in the frame.
    pub fn slices(&self) -> impl Iterator<Item = &'f [u8]> + use<'f> {
        let Self { picture, planes: (first, count), part, .. } = self.clone();
        let lines = (0..count).flat_map(move |plane| part.lines.clone().map(move |line| (plane, line)));
        lines.map(move |(plane, line)| picture.slice(first + plane, line, &part.bytes))
    }

    /// How many bytes the slices have together.
    #[must_use]
    pub fn byte_len(&self) -> usize {
        self.planes.1 * self.part.byte_len()
    }

    /// The bytes as they lie in the frame, where they lie in one piece: in one line, or in whole lines
    /// without a gap. Planes lie apart: ask for one.
    #[must_use]
    pub fn contiguous(&self) -> Option<&'f [u8]> {
        match self.planes {
            (plane, 1) => self.picture.block(plane, &self.part),
            _ => None,
        }
    }

    /// Copies the bytes into one piece, for controllers and drivers that take no other. Gives what was
    /// written.
    ///
    /// ```
    /// # use aquatint::{Changed, Dirty, Frame, Grain, Rect, Rows};
    /// # use embedded_graphics::pixelcolor::BinaryColor;
    /// let frame = Frame::<BinaryColor, Rows, _>::with_array([1, 2, 3, 4, 5, 6], 24, 2).unwrap();
    /// let mut dirty = Dirty::new([Changed::NOTHING; 2]);
    /// dirty.mark(&frame, Rect::new(4, 0, 12, 2));
    /// let mut buffer = [0; 100];
    /// for window in dirty.windows(&frame, Grain::SSD1680) {
    ///     let bytes = window.copy_to(&mut buffer)?; // to the driver, with `window.area()`
    ///     assert_eq!(bytes, [1, 2, 4, 5]);
    /// }
    /// # Ok::<(), aquatint::TooSmall>(())
    /// ```
    ///
    /// # Errors
    /// [`TooSmall`], and nothing is written.
    pub fn copy_to<'m>(&self, memory: &'m mut [u8]) -> Result<&'m [u8], TooSmall> {
        let needed = self.byte_len();
        let copy = memory.get_mut(..needed).ok_or(TooSmall { needed })?;
        // A window is wider than nothing, so lines have bytes.
        let lines = copy.chunks_exact_mut(self.part.bytes.len().max(1));
        for (to, from) in zip(lines, self.slices()) {
            zip(to, from).for_each(|(to, from)| *to = *from);
        }
        Ok(copy)
    }
}
