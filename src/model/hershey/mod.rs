//! Hershey's stroke fonts: letters as lines, to be drawn with a [stroke](crate::StrokeStyle) of any width.
//!
//! - **Takes** glyphs in the JHF encoding, in flash: two fonts are here, and you may bring your own.
//! - **Gives** a [`Typeface`] of open contours.
//! - **Memory** 3.4 kB of flash for Simplex, 6 kB for Duplex; what is not used is not linked.
//! - **Cost** two additions and a map a point.
//!
//! ```text
//!   MWRFRT RRYQZR[SZRY                a character is a number, counted from R
//!   ││╰┬╯   │                         M W   left and right side: −5, 5
//!   ││ │    ╰── pen up                R F   a point, x 0, y −12, then lines to the next ones
//!   ││ ╰─────── to x 0, y 2
//!   ╰┴───────── the sides             y grows downwards; the baseline is at 9, capitals reach to −12
//! ```
//!
//! The Hershey Fonts were originally created by Dr. A. V. Hershey while working at the U. S. National Bureau of
//! Standards. The format of the font data was originally created by James Hurt, Cognition, Inc., 900 Technology Park
//! Drive, Billerica, MA 01821 (mit-eddie!ci-dandelion!hurt). The data may be used by anyone for any purpose,
//! commercial or otherwise, as long as these acknowledgements are distributed with them, and may be converted into any
//! other format except that of the U.S. NTIS. Source: A. V. Hershey, *Calligraphy for Computers*, 1967.

mod duplex;
mod simplex;

use crate::{
    num::Scalar,
    outline::Pen,
    typeface::{FontMetrics, GlyphBox, GlyphId, GlyphPen, Typeface},
};

/// The y of the baseline in the data.
const BASELINE: i32 = 9;
/// The box for characters that are not in the font.
const MISSING: GlyphBox = GlyphBox::new(2, 0, 14, 21);
/// Of no point.
const EMPTY: GlyphBox = GlyphBox::new(i32::MAX, i32::MAX, i32::MIN, i32::MIN);

/// A font of strokes in the JHF encoding.
///
/// An em is 32 units, from the top of the highest to the bottom of the lowest glyph; capitals are 21 units high.
///
/// ```
/// use aquatint::{Hershey, Point2, StrokeStyle, Subpixel, Text};
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
///
/// let mut display = MockDisplay::new();
/// let text = Text::new(&Hershey::SIMPLEX, "Tea", Subpixel::from_num(14), Point2::corner(0, 10));
/// text.into_styled(StrokeStyle::new(BinaryColor::On)).draw(&mut display)?;
/// display.assert_pattern(&[
///     "#######               ",
///     "   #                  ",
///     "   #                  ",
///     "   #      ##      ##  ",
///     "   #     #  ##   #  ##",
///     "   #    #    #  #    #",
///     "   #    ######  #    #",
///     "   #    #       #    #",
///     "   #    #       #    #",
///     "   #     ####    #####",
/// ]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Hershey<'a> {
    glyphs: &'a [&'a str],
    first: char,
    extent: GlyphBox,
}

impl Hershey<'static> {
    /// Roman Simplex, the font of plotters: ASCII, one line a stroke.
    pub const SIMPLEX: Self = Self::new(&simplex::GLYPHS, ' ');

    /// Roman Duplex, of two lines a stroke: ASCII, bolder where it is large enough.
    pub const DUPLEX: Self = Self::new(&duplex::GLYPHS, ' ');
}

impl<'a> Hershey<'a> {
    /// A font from the lines of a JHF file, each without its first eight columns, which are a number and a length; for
    /// the characters from `first` on.
    ///
    /// Anything is taken: what is no pair of characters ends the glyph.
    #[must_use]
    pub const fn new(glyphs: &'a [&'a str], first: char) -> Self {
        let mut extent = MISSING;
        let mut rest = glyphs;
        while let [glyph, others @ ..] = rest {
            if let [left, _, points @ ..] = glyph.as_bytes() {
                extent = joined(extent, extent_of(points, number(*left)));
            }
            rest = others;
        }
        Self { glyphs, first, extent }
    }

    /// The glyph as its sides and its points.
    fn data(&self, glyph: GlyphId) -> Option<(i32, i32, &'a [u8])> {
        match self.glyphs.get(usize::from(glyph.0))?.as_bytes() {
            [left, right, points @ ..] => Some((number(*left), number(*right), points)),
            _ => None,
        }
    }
}

impl Typeface for Hershey<'_> {
    const HAS_INSIDE: bool = false;

    fn metrics(&self) -> FontMetrics {
        FontMetrics {
            units_per_em: 32,
            ascent: 16 + BASELINE,
            descent: 16 - BASELINE,
            line_gap: 0,
            extent: self.extent,
        }
    }

    /// The number of the character; what is not in the font gets a number behind, and a box.
    fn glyph(&self, character: char) -> GlyphId {
        let number = u32::from(character).checked_sub(u32::from(self.first));
        let id = number.and_then(|number| u16::try_from(number).ok()).map(GlyphId);
        id.filter(|id| self.data(*id).is_some()).unwrap_or(GlyphId(u16::MAX))
    }

    fn advance(&self, glyph: GlyphId) -> i32 {
        self.data(glyph).map_or(MISSING.right + MISSING.left, |(left, right, _)| right - left)
    }

    fn bounds(&self, glyph: GlyphId) -> Option<GlyphBox> {
        let Some((left, _, points)) = self.data(glyph) else { return Some(MISSING) };
        let extent = extent_of(points, left);
        (extent.left <= extent.right).then_some(extent)
    }

    fn trace<P: Pen>(&self, glyph: GlyphId, pen: &mut GlyphPen<'_, P>) {
        let Some((left, _, points)) = self.data(glyph) else { return trace_box(pen) };
        let mut is_down = false;
        for pair in points.chunks_exact(2) {
            let Some([x, y]) = point(pair, left).map(|point| point.map(Scalar::saturating_from_num)) else {
                is_down = false;
                continue;
            };
            if is_down {
                pen.line_to(x, y);
            } else {
                pen.move_to(x, y);
            }
            is_down = true;
        }
    }
}

/// What a character counts.
const fn number(byte: u8) -> i32 {
    byte as i32 - b'R' as i32
}

/// A point of a glyph whose left side is known, y upwards from the baseline; `None` where the pen is lifted.
const fn point(pair: &[u8], left: i32) -> Option<[i32; 2]> {
    match pair {
        b" R" => None,
        [x, y, ..] => Some([number(*x) - left, BASELINE - number(*y)]),
        _ => None,
    }
}

const fn extent_of(points: &[u8], left: i32) -> GlyphBox {
    let (mut extent, mut rest) = (EMPTY, points);
    while let Some((pair, others)) = rest.split_at_checked(2) {
        if let Some([x, y]) = point(pair, left) {
            extent = joined(extent, GlyphBox::new(x, y, x, y));
        }
        rest = others;
    }
    extent
}

/// The smallest box that holds both.
const fn joined(one: GlyphBox, other: GlyphBox) -> GlyphBox {
    const fn least(a: i32, b: i32) -> i32 {
        if a < b { a } else { b }
    }
    const fn most(a: i32, b: i32) -> i32 {
        if a > b { a } else { b }
    }
    GlyphBox::new(
        least(one.left, other.left),
        least(one.bottom, other.bottom),
        most(one.right, other.right),
        most(one.top, other.top),
    )
}

fn trace_box<P: Pen>(pen: &mut GlyphPen<'_, P>) {
    let GlyphBox { left, bottom, right, top } = MISSING;
    let [left, bottom, right, top] = [left, bottom, right, top].map(Scalar::saturating_from_num);
    pen.move_to(left, bottom);
    pen.line_to(right, bottom);
    pen.line_to(right, top);
    pen.line_to(left, top);
    pen.close();
}
