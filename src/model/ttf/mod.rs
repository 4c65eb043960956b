//! TrueType and OpenType fonts, straight from the bytes of their files. Feature `ttf`.
//!
//! - **Takes** a font in flash: contours in the table `glyf` or `CFF`, kerning in `kern` or `GPOS`.
//! - **Gives** a [`Typeface`].
//! - **Memory** 300 to 500 bytes for where the tables are; nothing for a glyph.
//! - **Cost** a glyph is read anew each time that it is traced.
//!
//! ```text
//!   character ── cmap ──▶ glyph ──┬── hmtx ────────▶ advance
//!                                 ├── kern or GPOS ▶ kerning with the next one
//!                                 └── glyf or CFF ─▶ lines and curves
//! ```
//!
//! Hints, variations, colours, ligatures and attached marks are not read; of a variable font one sees the default. Most
//! tables are read by `ttf-parser`. It counts in floats, which a core without them does slowly; they are
//! made 16.16 at once, exactly, and all the rest is integers.
//!
//! **Bad fonts** give an error or wrong glyphs, no panic. One built for the purpose can still take long: the programs
//! of `CFF` glyphs may call each other a great many times, and are not counted. Take such fonts only from those
//! whom you trust with your time.

mod outlines;
mod pairs;
mod read;

use core::fmt;

use ttf_parser::{RawFace, Tag, cff, cmap, glyf, head, hhea, hmtx, kern, loca, maxp};

use self::{outlines::Outlines, pairs::Pairs};
use crate::{
    error::describe,
    num::Scalar,
    outline::Pen,
    typeface::{FontMetrics, GlyphBox, GlyphId, GlyphPen, Typeface},
};

/// More tables of kerning than any font has: so that no font takes forever.
const MOST_TABLES: usize = 64;

/// Why bytes are not a font that can be drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum FontError {
    /// They are no TrueType or OpenType file, or it ends too early.
    NotAFont,
    /// A collection has no font of this number.
    NoSuchFont,
    /// The table `head`, `hhea`, `hmtx` or `maxp` is missing or broken.
    NoMetrics,
    /// There is no table `cmap` for Unicode.
    NoCharacters,
    /// There are neither `glyf` nor `CFF` outlines.
    NoOutlines,
}

describe! { FontError,
    Self::NotAFont => "not a TrueType or OpenType font";
    Self::NoSuchFont => "no font of this number in the collection";
    Self::NoMetrics => "a table of measures is missing or broken";
    Self::NoCharacters => "no table of Unicode characters";
    Self::NoOutlines => "no outlines";
}

/// A TrueType or OpenType font.
///
/// ```
/// use aquatint::{FillStyle, Point2, Subpixel, Text, TrueType};
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
///
/// let inter = TrueType::parse(include_bytes!("../../../examples/assets/inter.ttf"))?;
/// let mut display = MockDisplay::new();
/// let text = Text::new(&inter, "Yes", Subpixel::from_num(16), Point2::corner(0, 12));
/// text.into_styled(FillStyle::new(BinaryColor::On)).draw(&mut display).unwrap();
/// display.assert_pattern(&[
///     " #       #                 ",
///     " ##     ##                 ",
///     "  #    ##                  ",
///     "  ##   ##    ###      ###  ",
///     "   ## ##   ### ##   ##  ## ",
///     "    # #    #    ##  ##     ",
///     "    ###    #     #  ##     ",
///     "     #    ########   ####  ",
///     "     #     #            ## ",
///     "     #     #             ##",
///     "     #     ##   ##  ##   # ",
///     "     #      #####    ##### ",
/// ]);
/// # Ok::<(), aquatint::FontError>(())
/// ```
#[derive(Clone, Copy)]
pub struct TrueType<'a> {
    characters: cmap::Subtable<'a>,
    advances: hmtx::Table<'a>,
    outlines: Outlines<'a>,
    kerning: Kerning<'a>,
    metrics: FontMetrics,
    /// Drawn in place of what is not there; `None` where the font has a glyph for that.
    missing: Option<GlyphBox>,
}

/// Where the kerning is.
#[derive(Clone, Copy)]
enum Kerning<'a> {
    None,
    Kern(kern::Subtables<'a>),
    Gpos(Pairs<'a>),
}

impl fmt::Debug for TrueType<'_> {
    /// Without the bytes of its tables.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("TrueType").field("metrics", &self.metrics).finish_non_exhaustive()
    }
}

impl<'a> TrueType<'a> {
    /// Borrows and looks through the bytes of a font file.
    ///
    /// # Errors
    /// [`FontError`].
    pub fn parse(bytes: &'a [u8]) -> Result<Self, FontError> {
        Self::of_collection(bytes, 0)
    }

    /// The same for one of the fonts of a collection, counted from 0.
    ///
    /// # Errors
    /// [`FontError`].
    pub fn of_collection(bytes: &'a [u8], number: u32) -> Result<Self, FontError> {
        use ttf_parser::FaceParsingError::FaceIndexOutOfBounds;
        let face = RawFace::parse(bytes, number).map_err(|error| match error {
            FaceIndexOutOfBounds => FontError::NoSuchFont,
            _ => FontError::NotAFont,
        })?;
        let measures = Measures::parse(&face).ok_or(FontError::NoMetrics)?;
        let mut font = Self {
            characters: characters(&face).ok_or(FontError::NoCharacters)?,
            advances: measures.advances(&face).ok_or(FontError::NoMetrics)?,
            outlines: measures.outlines(&face).ok_or(FontError::NoOutlines)?,
            kerning: kerning(&face),
            metrics: measures.metrics(),
            missing: None,
        };
        font.missing = font.frame_for_missing();
        Ok(font)
    }

    /// A frame, if there is nothing to see of the glyph that stands for missing ones.
    fn frame_for_missing(&self) -> Option<GlyphBox> {
        let is_blank = self.outlines.is_blank(ttf_parser::GlyphId(0));
        let (em, advance) = (i32::from(self.metrics.units_per_em), self.advance(GlyphId(0)));
        is_blank.then(|| GlyphBox::new(em / 16, 0, advance.max(em / 2) - em / 16, em * 11 / 16))
    }
}

impl Typeface for TrueType<'_> {
    fn metrics(&self) -> FontMetrics {
        self.metrics
    }

    /// Glyph 0 for what is not in the font.
    fn glyph(&self, character: char) -> GlyphId {
        GlyphId(self.characters.glyph_index(character.into()).map_or(0, |glyph| glyph.0))
    }

    fn advance(&self, glyph: GlyphId) -> i32 {
        self.advances.advance(ttf_parser::GlyphId(glyph.0)).map_or(0, i32::from)
    }

    fn kerning(&self, left: GlyphId, right: GlyphId) -> i32 {
        match self.kerning {
            Kerning::None => 0,
            Kerning::Gpos(pairs) => pairs.kerning(left.0, right.0),
            Kerning::Kern(tables) => {
                let [left, right] = [left, right].map(|glyph| ttf_parser::GlyphId(glyph.0));
                let mut horizontal =
                    tables.into_iter().take(MOST_TABLES).filter(|table| table.horizontal && !table.has_cross_stream);
                horizontal.find_map(|table| table.glyphs_kerning(left, right)).map_or(0, i32::from)
            }
        }
    }

    fn bounds(&self, glyph: GlyphId) -> Option<GlyphBox> {
        let missing = self.missing.filter(|_| glyph == GlyphId(0));
        missing.or_else(|| self.outlines.bounds(ttf_parser::GlyphId(glyph.0), self.metrics.extent))
    }

    fn trace<P: Pen>(&self, glyph: GlyphId, pen: &mut GlyphPen<'_, P>) {
        match self.missing {
            Some(missing) if glyph == GlyphId(0) => trace_frame(missing, pen),
            _ => self.outlines.trace(ttf_parser::GlyphId(glyph.0), pen),
        }
    }
}

/// A frame: the inner contour the other way round.
fn trace_frame<P: Pen>(GlyphBox { left, bottom, right, top }: GlyphBox, pen: &mut GlyphPen<'_, P>) {
    // As wide as it is away from the side.
    let width = left;
    let outer = [[left, bottom], [left, top], [right, top], [right, bottom]];
    let ([x0, x1], [y0, y1]) = ([left + width, right - width], [bottom + width, top - width]);
    let inner = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
    for contour in [outer, inner] {
        let [first, rest @ ..] = contour.map(|corner| corner.map(Scalar::saturating_from_num));
        pen.move_to(first[0], first[1]);
        for [x, y] in rest {
            pen.line_to(x, y);
        }
        pen.close();
    }
}

/// The tables that the others are measured by.
struct Measures {
    head: head::Table,
    hhea: hhea::Table,
    maxp: maxp::Table,
}

impl Measures {
    fn parse(face: &RawFace) -> Option<Self> {
        Some(Self {
            head: head::Table::parse(table(face, *b"head")?)?,
            hhea: hhea::Table::parse(table(face, *b"hhea")?)?,
            maxp: maxp::Table::parse(table(face, *b"maxp")?)?,
        })
    }

    fn advances<'a>(&self, face: &RawFace<'a>) -> Option<hmtx::Table<'a>> {
        hmtx::Table::parse(self.hhea.number_of_metrics, self.maxp.number_of_glyphs, table(face, *b"hmtx")?)
    }

    fn outlines<'a>(&self, face: &RawFace<'a>) -> Option<Outlines<'a>> {
        let true_type = || {
            let (glyphs, format) = (self.maxp.number_of_glyphs, self.head.index_to_location_format);
            let places = loca::Table::parse(glyphs, format, table(face, *b"loca")?)?;
            let bytes = table(face, *b"glyf").filter(|bytes| !bytes.is_empty() && !places.is_empty())?;
            Some(Outlines::TrueType { table: glyf::Table::parse(places, bytes)?, bytes, places })
        };
        let post_script = || Some(Outlines::PostScript(cff::Table::parse(table(face, *b"CFF ")?)?));
        true_type().or_else(post_script)
    }

    fn metrics(&self) -> FontMetrics {
        let bounds = self.head.global_bbox;
        let [left, bottom, right, top] = [bounds.x_min, bounds.y_min, bounds.x_max, bounds.y_max].map(i32::from);
        let is_said = left < right && bottom < top;
        let everything = GlyphBox::new(i16::MIN.into(), i16::MIN.into(), i16::MAX.into(), i16::MAX.into());
        FontMetrics {
            units_per_em: self.head.units_per_em,
            ascent: self.hhea.ascender.into(),
            descent: -i32::from(self.hhea.descender),
            line_gap: self.hhea.line_gap.into(),
            extent: if is_said { GlyphBox::new(left, bottom, right, top) } else { everything },
        }
    }
}

fn table<'a>(face: &RawFace<'a>, tag: [u8; 4]) -> Option<&'a [u8]> {
    face.table(Tag::from_bytes(&tag))
}

/// The map from all of Unicode if there is one, else from its first 65,536 characters.
fn characters<'a>(face: &RawFace<'a>) -> Option<cmap::Subtable<'a>> {
    use cmap::Format::{ManyToOneRangeMappings, SegmentedCoverage, UnicodeVariationSequences};
    let maps = cmap::Table::parse(table(face, *b"cmap")?)?.subtables;
    let is_unicode = |map: &cmap::Subtable| map.is_unicode() && !matches!(map.format, UnicodeVariationSequences(_));
    let unicode = || maps.into_iter().filter(is_unicode);
    let is_full = |map: &cmap::Subtable| matches!(map.format, SegmentedCoverage(_) | ManyToOneRangeMappings(_));
    unicode().find(is_full).or_else(|| unicode().next())
}

/// That of `kern`, else that of `GPOS`.
fn kerning<'a>(face: &RawFace<'a>) -> Kerning<'a> {
    let kern = table(face, *b"kern").and_then(kern::Table::parse).map(|table| table.subtables);
    if let Some(tables) = kern.filter(|tables| !tables.is_empty()) {
        return Kerning::Kern(tables);
    }
    table(face, *b"GPOS").and_then(Pairs::parse).map_or(Kerning::None, Kerning::Gpos)
}
