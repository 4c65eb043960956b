//! Text by blits: a font of embedded-graphics as a sheet of packed glyphs.
//!
//! embedded-graphics' own `Text` walks over every pixel of every character. A [`GlyphSheet`] takes the
//! pixels of a font once, packed like the frame that is written on; each character is then a [blit](super::blit)
//! of some words. Glyphs that are not seen are skipped.
//!
//! ```text
//!   sheet                             frame
//!   !"#$%&'()*+,-./
//!   0123456789:;<=>?      ──▶         at ▶ Tea   baseline
//!   @ABCDEFGHIJKLMNO
//! ```
//!
//! - **Takes** any `MonoFont`; text, a place and a colour.
//! - **Cost** about 350 instructions for a character of 6 × 10 pixels of one bit, on a desk; 10 for one
//!   that is not seen. Loading a font costs what drawing its picture once costs.
//! - **Memory** the caller's, about as many bytes as the font has in flash; for deeper colours too, since
//!   the sheet has one bit a pixel.

use core::{iter::from_fn, ops::Range};

use embedded_graphics::{
    geometry::{OriginDimensions, Point, Size},
    image::ImageDrawable,
    mono_font::{MonoFont, mapping::GlyphMapping},
    pixelcolor::BinaryColor,
    text::Baseline,
};

use super::{
    blit::{Blit, Part},
    frame::{Frame, TooSmall},
    layout::Layout,
};
use crate::{
    lines::Lines,
    num::{low_index, size_i32},
    space::Rect,
};

/// A font, ready to be drawn fast.
///
/// The layout `L` is that of the frames to be written on, for speed; any other works too.
///
/// ```
/// use aquatint::{Frame, GlyphSheet, Pages};
/// use embedded_graphics::{mono_font::ascii::FONT_6X10, pixelcolor::BinaryColor, prelude::Point};
///
/// // This font is a picture of 96 × 60 pixels, and a sheet has a row to spare.
/// const BYTES: usize = Frame::<BinaryColor, Pages, ()>::bytes_needed(96, 60 + 1);
/// let sheet = GlyphSheet::<Pages, _>::load(&FONT_6X10, [0; BYTES])?;
///
/// let mut frame = Frame::<BinaryColor, Pages, _>::with_array([0; 1024], 128, 64)?;
/// let end = sheet.draw(&mut frame, "Hello,\nworld!", Point::new(2, 20), BinaryColor::On);
/// assert_eq!(end, Point::new(2 + 6 * 6, 20 + 10));
/// # Ok::<(), aquatint::TooSmall>(())
/// ```
#[derive(Debug)]
pub struct GlyphSheet<'f, L, B> {
    font: &'f MonoFont<'f>,
    sheet: Frame<BinaryColor, L, B>,
    /// Size of a glyph.
    width: i32,
    height: i32,
    /// Glyphs side by side, and one below the other.
    columns: u32,
    rows: u32,
    /// How many characters from the space on have the glyphs 0, 1, 2 …
    direct: u32,
    baseline: Baseline,
}

impl<L: Layout<BinaryColor>> GlyphSheet<'_, L, ()> {
    /// How many bytes the sheet of a font needs. [`GlyphSheet::load`] says it too.
    #[must_use]
    pub fn bytes_needed(font: &MonoFont) -> usize {
        let Size { width, height } = font.image.size();
        Frame::<BinaryColor, L, ()>::bytes_needed(width, with_spare(height))
    }
}

impl<'f, L, B> GlyphSheet<'f, L, B>
where
    L: Layout<BinaryColor>,
    B: AsRef<[u8]> + AsMut<[u8]>,
{
    /// Draws the whole font on `memory`, once.
    ///
    /// # Errors
    /// [`TooSmall`].
    pub fn load(font: &'f MonoFont<'f>, memory: B) -> Result<Self, TooSmall> {
        let size = font.image.size();
        let mut sheet = Frame::new(memory, size.width, with_spare(size.height))?;
        let Ok(()) = font.image.draw(&mut sheet);
        let Size { width, height } = font.character_size;
        let columns = size.width.checked_div(width).unwrap_or(0);
        // Where there is no column, or nothing in it, there is no glyph.
        let rows = if columns == 0 { 0 } else { size.height.checked_div(height).unwrap_or(0) };
        let (direct, baseline) = (direct(font.glyph_mapping), Baseline::Alphabetic);
        Ok(Self { font, sheet, width: size_i32(width), height: size_i32(height), columns, rows, direct, baseline })
    }
}

impl<L, B> GlyphSheet<'_, L, B>
where
    L: Layout<BinaryColor>,
    B: AsRef<[u8]>,
{
    /// The same, written with another line of the characters at the place that is said. Without, it is
    /// `Alphabetic`, as in embedded-graphics.
    #[must_use]
    pub fn with_baseline(self, baseline: Baseline) -> Self {
        Self { baseline, ..self }
    }

    /// Writes lines of text below each other, the first with its baseline beginning at `at`. Says where
    /// the last one ends.
    ///
    /// The pixels are those of embedded-graphics' `Text` without a background.
    pub fn draw<T: Blit>(&self, target: &mut T, text: &str, at: Point, color: T::Color) -> Point {
        let bounds = Rect::from(target.bounding_box());
        let mut corner = Point::new(at.x, at.y.saturating_sub(self.ascent()));
        let mut lines = Lines::new(text).peekable();
        while let Some((_, line)) = lines.next() {
            if corner.y < bounds.bottom && corner.y.saturating_add(self.height) > bounds.top {
                self.draw_line(target, line, (corner, bounds.columns()), color);
            }
            if lines.peek().is_none() {
                return Point::new(self.end(line, at.x), corner.y.saturating_add(self.ascent()));
            }
            corner.y = corner.y.saturating_add(self.height);
        }
        at
    }

    /// The shape of a character, to be [drawn](Blit) in any way; `None` where the font has none.
    ///
    /// ```
    /// use aquatint::{Frame, GlyphSheet, Rows, display::blit::{Blit, RasterOp}};
    /// use embedded_graphics::{mono_font::ascii::FONT_4X6, pixelcolor::BinaryColor, prelude::Point};
    ///
    /// let sheet = GlyphSheet::<Rows, _>::load(&FONT_4X6, vec![0; GlyphSheet::<Rows, ()>::bytes_needed(&FONT_4X6)])?;
    /// let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 6], 4, 6)?;
    /// if let Some(glyph) = sheet.glyph('T') {
    ///     frame.blit(glyph, Point::zero(), RasterOp::Xor);
    /// }
    /// assert_eq!(frame.bytes(), [0xE0, 0x40, 0x40, 0x40, 0x40, 0]);
    /// # Ok::<(), aquatint::TooSmall>(())
    /// ```
    #[must_use]
    pub fn glyph(&self, character: char) -> Option<Part<'_, BinaryColor, L>> {
        Some(self.sheet.part(self.place(character)?))
    }

    /// Where a character is on the sheet, if it is.
    #[inline]
    fn place(&self, character: char) -> Option<Rect> {
        let from_space = u32::from(character).wrapping_sub(u32::from(' '));
        let index =
            if from_space < self.direct { from_space } else { low_index(self.font.glyph_mapping.index(character)) };
        let row = index.checked_div(self.columns).filter(|row| *row < self.rows)?;
        // Inside of the sheet nothing wraps.
        let left = (index - row * self.columns).cast_signed().wrapping_mul(self.width);
        let top = row.cast_signed().wrapping_mul(self.height);
        Some(Rect::new(left, top, left.wrapping_add(self.width), top.wrapping_add(self.height)))
    }

    /// Draws the characters that are seen between some columns.
    fn draw_line<T: Blit>(
        &self,
        target: &mut T,
        line: &str,
        (mut corner, columns): (Point, Range<i32>),
        color: T::Color,
    ) {
        let advance = self.advance();
        let mut characters = line.chars();
        let places = from_fn(move || {
            while corner.x < columns.end {
                let (character, at) = (characters.next()?, corner);
                corner.x = at.x.saturating_add(advance);
                if at.x.saturating_add(self.width) > columns.start {
                    if let Some(place) = self.place(character) {
                        return Some((place, at));
                    }
                }
            }
            None
        });
        target.paint_all(&Part::from(&self.sheet), places, color);
    }

    /// From a character to the next.
    fn advance(&self) -> i32 {
        size_i32(self.font.character_size.width.saturating_add(self.font.character_spacing))
    }

    /// The column behind the last character of a line.
    fn end(&self, line: &str, start: i32) -> i32 {
        let characters = size_i32(low_index(line.chars().count()));
        let spacing = if characters == 0 { 0 } else { size_i32(self.font.character_spacing) };
        start.saturating_add(characters.saturating_mul(self.advance()).saturating_sub(spacing))
    }

    /// From the upper border of a line to the row that is its place.
    fn ascent(&self) -> i32 {
        let last = self.font.character_size.height.saturating_sub(1);
        size_i32(match self.baseline {
            Baseline::Top => 0,
            Baseline::Bottom => last,
            Baseline::Middle => last / 2,
            Baseline::Alphabetic => self.font.baseline,
        })
    }
}

/// With one row more, so that words of the last one do not end with the memory.
const fn with_spare(height: u32) -> u32 {
    height.saturating_add(1)
}

/// How many characters from the space on are mapped to 0, 1, 2 …: all of ASCII in most fonts. A mapping
/// may search its whole list for a character.
fn direct(mapping: &dyn GlyphMapping) -> u32 {
    let in_order = (0..).zip(' '..='~').take_while(|(index, character)| mapping.index(*character) == *index);
    low_index(in_order.count())
}
