//! A string as lines, and a line as glyphs with the place of the pen.
//!
//! ```text
//!    A          V           e             pen = Σ (advance + kerning), in font units
//!    ●──────────●───────────●────────▶
//!    0   advance  + kerning
//! ```

use core::str::Chars;

use crate::typeface::{GlyphId, Typeface};

/// The lines of a string and their numbers. There is one at least.
#[derive(Debug)]
pub(crate) struct Lines<'t> {
    rest: Option<&'t str>,
    number: usize,
}

impl<'t> Lines<'t> {
    pub(crate) const fn new(text: &'t str) -> Self {
        Self { rest: Some(text), number: 0 }
    }
}

impl<'t> Iterator for Lines<'t> {
    type Item = (usize, &'t str);

    fn next(&mut self) -> Option<Self::Item> {
        let (text, number) = (self.rest?, self.number);
        let (line, rest) = text.split_once('\n').map_or((text, None), |(line, rest)| (line, Some(rest)));
        (self.rest, self.number) = (rest, number.saturating_add(1));
        Some((number, line.strip_suffix('\r').unwrap_or(line)))
    }
}

/// The glyphs of one line, each with the place of the pen in font units.
#[derive(Debug)]
pub(crate) struct Line<'t, F> {
    face: &'t F,
    characters: Chars<'t>,
    pen: i32,
    /// The glyph before, and its advance.
    before: Option<(GlyphId, i32)>,
}

impl<'t, F: Typeface> Line<'t, F> {
    pub(crate) fn new(face: &'t F, line: &'t str) -> Self {
        Self { face, characters: line.chars(), pen: 0, before: None }
    }

    /// How far the pen goes, up to behind the last glyph.
    pub(crate) fn width(mut self) -> i32 {
        while self.next().is_some() {}
        let last = self.before.map_or(0, |(_, advance)| advance.max(0));
        self.pen.saturating_add(last)
    }
}

impl<F: Typeface> Iterator for Line<'_, F> {
    type Item = (i32, GlyphId);

    fn next(&mut self) -> Option<(i32, GlyphId)> {
        let glyph = self.face.glyph(self.characters.next()?);
        if let Some((before, advance)) = self.before {
            let step = advance.saturating_add(self.face.kerning(before, glyph));
            self.pen = self.pen.saturating_add(step.max(0));
        }
        self.before = Some((glyph, self.face.advance(glyph)));
        Some((self.pen, glyph))
    }
}
