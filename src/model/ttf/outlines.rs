//! Contours of glyphs from the tables `glyf` and `CFF`.

use ttf_parser::{GlyphId, OutlineBuilder, cff, glyf, loca};

use super::read::{i16_at, u16_at};
use crate::{
    num::scalar_of_f32,
    outline::Pen,
    typeface::{GlyphBox, GlyphPen},
};

/// Of more parts than this, all told, no glyph is composed, and not deeper: so that no font takes forever.
const MOST_PARTS: u8 = 64;
const DEEPEST: u8 = 8;

/// Where the outlines are.
#[derive(Clone, Copy)]
pub(super) enum Outlines<'a> {
    /// Quadratic curves.
    TrueType { table: glyf::Table<'a>, bytes: &'a [u8], places: loca::Table<'a> },
    /// Cubic curves.
    PostScript(cff::Table<'a>),
}

impl Outlines<'_> {
    /// The box in the font, where it says one; `None` where the glyph is blank.
    pub(super) fn bounds(&self, glyph: GlyphId, extent: GlyphBox) -> Option<GlyphBox> {
        match self {
            Self::TrueType { table, .. } => {
                let bounds = table.bbox(glyph)?;
                let [left, bottom, right, top] =
                    [bounds.x_min, bounds.y_min, bounds.x_max, bounds.y_max].map(i32::from);
                Some(GlyphBox::new(left, bottom, right, top))
            }
            Self::PostScript(_) => Some(extent),
        }
    }

    /// Draws a glyph. What is drawn up to an error stays.
    pub(super) fn trace<P: Pen>(&self, glyph: GlyphId, pen: &mut GlyphPen<'_, P>) {
        self.build(glyph, &mut Builder { pen });
    }

    /// Whether a glyph has no line and no curve.
    pub(super) fn is_blank(&self, glyph: GlyphId) -> bool {
        let mut blank = Blank(true);
        self.build(glyph, &mut blank);
        blank.0
    }

    fn build(&self, glyph: GlyphId, builder: &mut impl OutlineBuilder) {
        match self {
            Self::TrueType { table, .. } if self.is_simple_enough(glyph, 0, &mut { MOST_PARTS }) => {
                table.outline(glyph, builder);
            }
            Self::TrueType { .. } => {}
            Self::PostScript(table) => drop(table.outline(glyph, builder)),
        }
    }

    /// Whether a glyph and what it is composed of are no more parts than are left.
    fn is_simple_enough(&self, glyph: GlyphId, depth: u8, left: &mut u8) -> bool {
        let Some(rest) = left.checked_sub(1).filter(|_| depth <= DEEPEST) else { return false };
        *left = rest;
        let mut at = 10;
        while let Some((part, next)) = self.part(glyph, at) {
            if !self.is_simple_enough(part, depth + 1, left) {
                return false;
            }
            let Some(next) = next else { break };
            at = next;
        }
        true
    }

    /// The part of a composite glyph at an offset, and where the next one is.
    fn part(&self, glyph: GlyphId, at: usize) -> Option<(GlyphId, Option<usize>)> {
        let Self::TrueType { bytes, places, .. } = self else { return None };
        let data = bytes.get(places.glyph_range(glyph)?)?;
        if i16_at(data, 0)? >= 0 {
            return None;
        }
        let flags = u16_at(data, at)?;
        let has = |flag: u16| flags & flag != 0;
        let offsets = if !has(0x2) {
            0
        } else if has(0x1) {
            4
        } else {
            2
        };
        let scales = if has(0x80) {
            8
        } else if has(0x40) {
            4
        } else if has(0x8) {
            2
        } else {
            0
        };
        Some((GlyphId(u16_at(data, at + 2)?), has(0x20).then_some(at + 4 + offsets + scales)))
    }
}

/// Hands on what the parser draws. What is not a number is 0, what is too large the largest.
struct Builder<'b, 'p, P> {
    pen: &'b mut GlyphPen<'p, P>,
}

impl<P: Pen> OutlineBuilder for Builder<'_, '_, P> {
    fn move_to(&mut self, x: f32, y: f32) {
        self.pen.move_to(scalar_of_f32(x), scalar_of_f32(y));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.pen.line_to(scalar_of_f32(x), scalar_of_f32(y));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.pen.quad_to([x1, y1].map(scalar_of_f32), [x, y].map(scalar_of_f32));
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.pen.cubic_to([x1, y1].map(scalar_of_f32), [x2, y2].map(scalar_of_f32), [x, y].map(scalar_of_f32));
    }

    fn close(&mut self) {
        self.pen.close();
    }
}

/// Whether nothing was drawn.
struct Blank(bool);

impl OutlineBuilder for Blank {
    fn move_to(&mut self, _x: f32, _y: f32) {}

    fn line_to(&mut self, _x: f32, _y: f32) {
        self.0 = false;
    }

    fn quad_to(&mut self, _x1: f32, _y1: f32, _x: f32, _y: f32) {
        self.0 = false;
    }

    fn curve_to(&mut self, _x1: f32, _y1: f32, _x2: f32, _y2: f32, _x: f32, _y: f32) {
        self.0 = false;
    }

    fn close(&mut self) {}
}
