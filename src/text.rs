//! Text of any size and direction: lines of glyphs, each an [`Outline`].
//!
//! - **Takes** a [`Typeface`], a string, a size, a place; alignment, line height, an affine map.
//! - **Gives** one outline after the other of the glyphs that a window may show: [`Text::glyphs`].
//! - **Memory** none: nothing is laid out beforehand.
//! - **Cost** a line beside the window in its direction, above it say, is searched for its end. In other lines a glyph
//!   before the window is looked up for its advance and kerning; behind it the line is left. No outline is
//!   touched of a glyph that the window does not show.
//!
//! ```text
//!        at                    ┌────────── window
//!         ●The quick brown fox │jumps over│ the lazy dog      advances are summed, ▏then traced, ▏left
//!          and the cat         │
//! ```
//!
//! Advances and kerning are summed in whole font units and put on the screen with one rounding a point. So nothing
//! drifts, glyphs stand between pixels, and where a glyph stands does not depend on the window. The pen never moves
//! back: where kerning is larger than the advance, it stays.
//!
//! There is no shaping: one glyph a character, from left to right, without ligatures or marks that are attached to others.
//! A line end is `\n` or `\r\n`; tabs and other controls are characters, which fonts have not as a rule.

use embedded_graphics::text::Alignment;

use crate::{
    affine::Affine,
    em::{EmMap, Spread, coarse},
    lines::{Line, Lines},
    num::{Subpixel, count_i32},
    outline::{Outline, Pen},
    space::{Point2, Rect},
    typeface::{FontMetrics, Glyph, Typeface},
};

/// Lines of text in a font, below each other where the string has line ends.
///
/// A `Drawable` with a [`FillStyle`](crate::FillStyle), or with a [`StrokeStyle`](crate::StrokeStyle) for the fonts that
/// are made of lines and for the borders of others. As an [`Outline`] it is all of its glyphs: dashed, measured, filled
/// at once.
///
/// ```
/// use aquatint::{Affine, Angle, Frame, Hershey, Pages, Point2, StrokeStyle, Subpixel, Text};
/// use embedded_graphics::{pixelcolor::BinaryColor, prelude::*, text::Alignment};
///
/// let mut frame = Frame::<BinaryColor, Pages, _>::with_array([0; 1024], 128, 64)?;
/// let text = Text::new(&Hershey::SIMPLEX, "Hello,\nworld!", Subpixel::from_num(24), Point2::corner(64, 28));
/// let text = text.with_alignment(Alignment::Center).with_map(Affine::turn(Angle::from_degrees(-10.0)));
/// text.into_styled(StrokeStyle::new(BinaryColor::On).with_width(2)).draw(&mut frame).unwrap();
/// # Ok::<(), aquatint::TooSmall>(())
/// ```
#[derive(Debug)]
pub struct Text<'t, F> {
    face: &'t F,
    words: &'t str,
    size: Subpixel,
    at: Point2,
    alignment: Alignment,
    line_height: Option<Subpixel>,
    map: Affine,
    is_snapped: bool,
}

impl<F> Clone for Text<'_, F> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<F> Copy for Text<'_, F> {}

impl<'t, F: Typeface> Text<'t, F> {
    /// Text whose first line begins at a point on its baseline, with so many pixels an em. A size that is not positive
    /// draws nothing.
    #[must_use]
    pub const fn new(face: &'t F, words: &'t str, size: Subpixel, at: Point2) -> Self {
        let (alignment, map) = (Alignment::Left, Affine::IDENTITY);
        Self { face, words, size, at, alignment, line_height: None, map, is_snapped: false }
    }

    /// The same with its lines ending at the place, or with their middle there.
    #[must_use]
    pub const fn with_alignment(self, alignment: Alignment) -> Self {
        Self { alignment, ..self }
    }

    /// The same with so many pixels from a baseline to the next, instead of what the font says.
    #[must_use]
    pub const fn with_line_height(self, line_height: Subpixel) -> Self {
        Self { line_height: Some(line_height), ..self }
    }

    /// The same, turned, sheared, mirrored … about the place where it is.
    #[must_use]
    pub const fn with_map(self, map: Affine) -> Self {
        Self { map, ..self }
    }

    /// The same with every glyph moved to the nearest whole pixel: on one bit a pixel all that are alike look alike then.
    /// Spaces differ by up to a pixel instead.
    #[must_use]
    pub const fn on_whole_pixels(self) -> Self {
        Self { is_snapped: true, ..self }
    }

    /// The same at another place.
    #[must_use]
    pub const fn with_place(self, at: Point2) -> Self {
        Self { at, ..self }
    }

    /// Where it is: on the baseline of the first line.
    #[must_use]
    pub const fn place(&self) -> Point2 {
        self.at
    }

    /// The glyphs that may touch a window of pixels, line by line from their beginning, placed on the screen.
    ///
    /// Fill or stroke each of them; where strokes are drawn, the window must be as much larger as they reach.
    ///
    /// ```
    /// use aquatint::{Hershey, Outline, Point2, Rect, Subpixel, Text};
    ///
    /// let text = Text::new(&Hershey::SIMPLEX, "a b\nc", Subpixel::from_num(16), Point2::corner(0, 20));
    /// // A space has nothing to draw, and the second line is below.
    /// assert_eq!(text.glyphs(Rect::new(0, 0, 100, 20)).count(), 2);
    /// ```
    #[must_use]
    pub fn glyphs(&self, window: Rect) -> Glyphs<'t, F> {
        let metrics = self.face.metrics();
        let map = EmMap::new((self.size, metrics.units_per_em), self.map, self.at);
        let is_seen = self.size > Subpixel::ZERO && !window.is_empty();
        Glyphs {
            text: *self,
            window,
            metrics,
            spread: map.spread(metrics.extent.sides()),
            map,
            lines: Lines::new(if is_seen { self.words } else { "" }),
            line: Line::new(self.face, ""),
            start: map,
        }
    }

    /// How wide the widest line is, before the map.
    #[must_use]
    pub fn width(&self) -> Subpixel {
        let widest = Lines::new(self.words).map(|(_, line)| Line::new(self.face, line).width()).max().unwrap_or(0);
        let (at, units) = (Point2::default(), self.face.metrics().units_per_em);
        coarse(EmMap::new((self.size, units), Affine::IDENTITY, at).moved([widest, 0]).origin()).x
    }

    /// Where the last line ends: where on its baseline another glyph would begin.
    #[must_use]
    pub fn end(&self) -> Point2 {
        let metrics = self.face.metrics();
        let map = EmMap::new((self.size, metrics.units_per_em), self.map, self.at);
        let last = Lines::new(self.words).last().unwrap_or((0, ""));
        let baseline = self.baseline(&metrics, map, last.0);
        let width = Line::new(self.face, last.1).width();
        coarse(baseline.moved([self.indent(width), 0]).moved([width, 0]).origin())
    }

    /// The map of a line that begins at the place.
    fn baseline(&self, metrics: &FontMetrics, map: EmMap, line: usize) -> EmMap {
        let line = count_i32(line);
        let Some(height) = self.line_height else {
            return map.moved([0, metrics.line_height().saturating_mul(line).saturating_neg()]);
        };
        let ([_, xy], [_, yy], _) = self.map.parts();
        let down = i64::from(height.to_bits().saturating_mul(line));
        // 2⁻¹⁶ of sixteenths, as 2⁻¹⁶ of 256ths.
        map.farther([xy, yy].map(|factor| (i64::from(factor.to_bits()) * down).saturating_mul(16)))
    }

    /// How far right of the place a line begins, in font units.
    const fn indent(&self, width: i32) -> i32 {
        match self.alignment {
            Alignment::Left => 0,
            Alignment::Center => -(width / 2),
            Alignment::Right => -width,
        }
    }
}

/// The window that shows everything.
const EVERYWHERE: Rect = Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX);

impl<F: Typeface> Outline for Text<'_, F> {
    fn trace<P: Pen>(&self, pen: &mut P) {
        self.glyphs(EVERYWHERE).for_each(|glyph| glyph.trace(pen));
    }

    fn trace_fine<P: Pen>(&self, pen: &mut P) {
        self.glyphs(EVERYWHERE).for_each(|glyph| glyph.trace_fine(pen));
    }
}

/// The glyphs of a text in a window: what [`Text::glyphs`] gives.
#[derive(Debug)]
pub struct Glyphs<'t, F> {
    text: Text<'t, F>,
    window: Rect,
    metrics: FontMetrics,
    /// How far glyphs reach.
    spread: Spread,
    /// Of the first baseline.
    map: EmMap,
    /// Those to come, and what is left of the present one.
    lines: Lines<'t>,
    line: Line<'t, F>,
    /// Where the present line begins.
    start: EmMap,
}

impl<'t, F: Typeface> Glyphs<'t, F> {
    /// Goes to the next line that may be seen.
    fn next_line(&mut self) -> Option<()> {
        loop {
            let (number, line) = self.lines.next()?;
            let baseline = self.text.baseline(&self.metrics, self.map, number);
            if self.misses(self.all_along(self.spread.pixels_at(baseline.origin()))) {
                continue;
            }
            self.line = Line::new(self.text.face, line);
            self.start = match self.text.alignment {
                Alignment::Left => baseline,
                _ => baseline.moved([self.text.indent(Line::new(self.text.face, line).width()), 0]),
            };
            return Some(());
        }
    }

    /// The next glyph of this line that may be seen.
    fn next_in_line(&mut self) -> Option<Glyph<'t, F>> {
        let face = self.text.face;
        loop {
            let (pen, id) = self.line.next()?;
            let moved = self.start.moved([pen, 0]);
            let map = if self.text.is_snapped { moved.snapped() } else { moved };
            let pixels = self.spread.pixels_at(map.origin());
            if self.is_behind(pixels) {
                self.line = Line::new(face, "");
                return None;
            }
            if self.misses(pixels) {
                continue;
            }
            if let Some(bounds) = face.bounds(id) {
                if !self.misses(map.spread(bounds.sides()).pixels_at(map.origin())) {
                    return Some(Glyph { face, id, map });
                }
            }
        }
    }

    fn misses(&self, pixels: Rect) -> bool {
        pixels.intersection(self.window).is_empty()
    }

    /// A rectangle drawn out both ways along the line.
    const fn all_along(&self, pixels: Rect) -> Rect {
        let [x, y] = self.map.direction();
        let (left, right) = if x == 0 { (pixels.left, pixels.right) } else { (i32::MIN, i32::MAX) };
        let (top, bottom) = if y == 0 { (pixels.top, pixels.bottom) } else { (i32::MIN, i32::MAX) };
        Rect::new(left, top, right, bottom)
    }

    /// Whether what follows in this line is farther from the window still.
    const fn is_behind(&self, pixels: Rect) -> bool {
        let ([x, y], window) = (self.map.direction(), self.window);
        x > 0 && pixels.left >= window.right
            || x < 0 && pixels.right <= window.left
            || y > 0 && pixels.top >= window.bottom
            || y < 0 && pixels.bottom <= window.top
    }
}

impl<'t, F: Typeface> Iterator for Glyphs<'t, F> {
    type Item = Glyph<'t, F>;

    fn next(&mut self) -> Option<Glyph<'t, F>> {
        loop {
            if let Some(glyph) = self.next_in_line() {
                return Some(glyph);
            }
            self.next_line()?;
        }
    }
}
