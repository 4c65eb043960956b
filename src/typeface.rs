//! Typefaces: what draws the glyphs of a font, whatever the format of the font is.
//!
//! - **Takes** characters and numbers of glyphs.
//! - **Gives** measures in font units, and a [`GlyphPen`] the lines and curves of a glyph in font units, y upwards. The
//!   pen puts them on the screen.
//! - **Memory** none.
//!
//! ```text
//!         ┌─────────┐ ─── ascent
//!         │   ╱╲    │
//!         │  ╱──╲   │
//!    ─────●─╱────╲──●──── baseline      ● the pen before and after the glyph: the advance lies between
//!         │         │
//!         └─────────┘ ─── descent
//! ```

use crate::{
    curve::Flatten,
    em::{EmMap, Sides, coarse, fine},
    num::Scalar,
    outline::{Outline, Pen},
    space::Point2,
};

/// The number of a glyph in its font.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GlyphId(pub u16);

/// A rectangle about a glyph in font units, y upwards.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GlyphBox {
    /// The least x.
    pub left: i32,
    /// The least y.
    pub bottom: i32,
    /// The greatest x.
    pub right: i32,
    /// The greatest y.
    pub top: i32,
}

impl GlyphBox {
    /// A box from its four borders.
    #[must_use]
    pub const fn new(left: i32, bottom: i32, right: i32, top: i32) -> Self {
        Self { left, bottom, right, top }
    }

    pub(crate) const fn sides(self) -> Sides {
        [self.left, self.bottom, self.right, self.top]
    }
}

/// The measures of a font, in font units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FontMetrics {
    /// How many units are an em, the measure that a size is the size of.
    pub units_per_em: u16,
    /// How far a line reaches above its baseline.
    pub ascent: i32,
    /// How far a line reaches below its baseline: positive where it does.
    pub descent: i32,
    /// What is left free between two lines.
    pub line_gap: i32,
    /// What holds every glyph, with its origin at the origin.
    pub extent: GlyphBox,
}

impl FontMetrics {
    /// From a baseline to the next.
    #[must_use]
    pub const fn line_height(&self) -> i32 {
        self.ascent.saturating_add(self.descent).saturating_add(self.line_gap)
    }
}

/// A scalable font.
///
/// ```
/// use aquatint::{FillStyle, FontMetrics, GlyphBox, GlyphId, GlyphPen, Pen, Point2, Scalar, Subpixel, Text, Typeface};
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
///
/// /// A slanted box for every character.
/// struct Boxes;
///
/// impl Typeface for Boxes {
///     fn metrics(&self) -> FontMetrics {
///         let extent = GlyphBox::new(0, 0, 4, 4);
///         FontMetrics { units_per_em: 4, ascent: 4, descent: 0, line_gap: 1, extent }
///     }
///
///     fn glyph(&self, _character: char) -> GlyphId {
///         GlyphId(0)
///     }
///
///     fn advance(&self, _glyph: GlyphId) -> i32 {
///         4
///     }
///
///     fn trace<P: Pen>(&self, _glyph: GlyphId, pen: &mut GlyphPen<'_, P>) {
///         let [zero, one, three, four] = [0, 1, 3, 4].map(Scalar::from_num);
///         pen.move_to(zero, zero);
///         pen.line_to(three, zero);
///         pen.line_to(four, four);
///         pen.line_to(one, four);
///         pen.close();
///     }
/// }
///
/// let mut display = MockDisplay::new();
/// let text = Text::new(&Boxes, "ab", Subpixel::from_num(4), Point2::corner(0, 4));
/// text.into_styled(FillStyle::new(BinaryColor::On)).draw(&mut display)?;
/// display.assert_pattern(&[
///     " ### ###",
///     " ### ###",
///     "### ### ",
///     "### ### ",
/// ]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
pub trait Typeface {
    /// Whether its contours enclose something. Fonts that are made of lines have a stroke and no inside.
    const HAS_INSIDE: bool = true;

    /// The measures of the font.
    fn metrics(&self) -> FontMetrics;

    /// The glyph of a character; for characters that the font has not, one that shows that.
    fn glyph(&self, character: char) -> GlyphId;

    /// From the origin of a glyph to that of the next one, in font units.
    fn advance(&self, glyph: GlyphId) -> i32;

    /// How much farther the second one of two glyphs stands, in font units: mostly negative.
    fn kerning(&self, _left: GlyphId, _right: GlyphId) -> i32 {
        0
    }

    /// A box that holds a glyph; `None` where nothing is to be drawn. Drawing skips by it what is not seen.
    fn bounds(&self, _glyph: GlyphId) -> Option<GlyphBox> {
        Some(self.metrics().extent)
    }

    /// Draws the contours of a glyph, the same ones each time.
    fn trace<P: Pen>(&self, glyph: GlyphId, pen: &mut GlyphPen<'_, P>);
}

/// Draws in font units, y upwards, what another pen gets on the screen.
///
/// A point is put on the screen with one rounding, and curves are cut there: [`Flatten`].
#[derive(Debug)]
pub struct GlyphPen<'p, P> {
    pen: Flatten<'p, P>,
    map: EmMap,
    is_fine: bool,
}

impl<P: Pen> GlyphPen<'_, P> {
    /// Begins a contour.
    pub fn move_to(&mut self, x: Scalar, y: Scalar) {
        let point = self.place(x, y);
        self.pen.move_to(point);
    }

    /// A straight edge.
    pub fn line_to(&mut self, x: Scalar, y: Scalar) {
        let point = self.place(x, y);
        self.pen.line_to(point);
    }

    /// A quadratic Bézier curve: control point, end.
    pub fn quad_to(&mut self, control: [Scalar; 2], to: [Scalar; 2]) {
        let [control, to] = [control, to].map(|[x, y]| self.place(x, y));
        self.pen.quad_to(control, to);
    }

    /// A cubic Bézier curve: two control points, end.
    pub fn cubic_to(&mut self, one: [Scalar; 2], other: [Scalar; 2], to: [Scalar; 2]) {
        let [one, other, to] = [one, other, to].map(|[x, y]| self.place(x, y));
        self.pen.cubic_to(one, other, to);
    }

    /// A straight edge back to where the contour began.
    pub fn close(&mut self) {
        self.pen.close();
    }

    fn place(&self, x: Scalar, y: Scalar) -> Point2 {
        let place = self.map.apply(x, y);
        if self.is_fine { fine(place) } else { coarse(place) }
    }
}

/// A glyph on the screen: an outline, of which every point and every curve is computed for the size it is traced in.
#[derive(Debug)]
pub struct Glyph<'t, F> {
    pub(crate) face: &'t F,
    pub(crate) id: GlyphId,
    pub(crate) map: EmMap,
}

impl<F> Glyph<'_, F> {
    /// Which one it is in its font.
    #[must_use]
    pub const fn id(&self) -> GlyphId {
        self.id
    }

    /// Where its origin is, on the baseline.
    #[must_use]
    pub fn origin(&self) -> Point2 {
        coarse(self.map.origin())
    }
}

impl<F> Clone for Glyph<'_, F> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<F> Copy for Glyph<'_, F> {}

impl<F: Typeface> Outline for Glyph<'_, F> {
    fn trace<P: Pen>(&self, pen: &mut P) {
        let mut pen = GlyphPen { pen: Flatten::new(pen), map: self.map, is_fine: false };
        self.face.trace(self.id, &mut pen);
    }

    fn trace_fine<P: Pen>(&self, pen: &mut P) {
        let mut pen = GlyphPen { pen: Flatten::new(pen), map: self.map, is_fine: true };
        self.face.trace(self.id, &mut pen);
    }
}
