//! Text: glyphs against the rasteriser of `ab_glyph`, and only what is seen is traced.

use std::cell::Cell;

use ab_glyph::{Font, FontRef, OutlineCurve, point};
use ab_glyph_rasterizer::Rasterizer;
use aquatint::{
    AntialiasedStyle, Blended, Coverage, Covered, FontMetrics, Frame, GlyphBox, GlyphId, GlyphPen, Hershey, Pen,
    Point2, Rect, Rows, Rule, SpanFn, Subpixel, Text, TrueType, Typeface,
    raster::area::{AreaEdge, Scratch, fill},
};
use embedded_graphics::{pixelcolor::Gray4, prelude::*};
use heapless::Vec as List;

const INTER: &[u8] = include_bytes!("../../examples/assets/inter.ttf");
const SIZE: Size = Size::new(64, 64);

fn inter() -> TrueType<'static> {
    TrueType::parse(INTER).expect("a font")
}

/// The covered parts of a character in 255ths, with its origin at a place in sixteenths of a pixel.
fn ours(font: &TrueType<'_>, character: char, size: u16, at: (i32, i32)) -> Vec<f64> {
    let words = character.to_string();
    let text = Text::new(font, &words, Subpixel::from_num(size), Point2::from_sixteenths(at.0, at.1));
    let mut picture = vec![0.0; 64 * 64];
    let mut sink = SpanFn::new(Rect::of_size(SIZE), |row: i32, columns: std::ops::Range<i32>, covered: Covered<'_>| {
        for (offset, column) in columns.enumerate() {
            picture[row as usize * 64 + column as usize] = f64::from(covered.at(offset).parts()) / 32_768.0 * 255.0;
        }
    });
    let (mut edges, mut cells) = (List::<AreaEdge, 512>::new(), [Coverage::NONE; 64]);
    let Ok(()) = fill(&text, Rule::NonZero, Scratch { edges: &mut edges, cells: &mut cells }, &mut sink);
    picture
}

/// The same by `ab_glyph`: its outline, its rasteriser, but curves cut finely, of which it is up to a seventh of a
/// pixel away with its own.
fn theirs(font: &FontRef<'_>, id: GlyphId, scale: f32, at: (i16, i16)) -> Vec<f64> {
    let mut raster = Rasterizer::new(64, 64);
    let outline = font.outline(ab_glyph::GlyphId(id.0));
    let place = |p: ab_glyph::Point| point(f32::from(at.0) / 16.0 + p.x * scale, f32::from(at.1) / 16.0 - p.y * scale);
    for curve in outline.iter().flat_map(|outline| &outline.curves) {
        match *curve {
            OutlineCurve::Line(a, b) => raster.draw_line(place(a), place(b)),
            OutlineCurve::Quad(a, b, c) => {
                let [a, b, c] = [a, b, c].map(place);
                let at = |step: u16| {
                    let t = f32::from(step) / 64.0;
                    let [k, l, m] = [(1.0 - t) * (1.0 - t), 2.0 * t * (1.0 - t), t * t];
                    point(k * a.x + l * b.x + m * c.x, k * a.y + l * b.y + m * c.y)
                };
                (0..64).for_each(|step| raster.draw_line(at(step), at(step + 1)));
            }
            OutlineCurve::Cubic(..) => panic!("a TrueType font has none"),
        }
    }
    let mut picture = vec![0.0; 64 * 64];
    raster.for_each_pixel(|index, covered| picture[index] = f64::from(covered.min(1.0)) * 255.0);
    picture
}

#[test]
fn glyphs_are_those_of_ab_glyph_to_a_255th_and_a_half() {
    let (font, reference) = (inter(), FontRef::try_from_slice(INTER).expect("a font"));
    let units = f32::from(font.metrics().units_per_em);
    let (mut worst, mut sum, mut pixels) = ((0.0_f64, ' ', 0), 0.0, 0_u32);
    for size in [9, 12, 16, 24, 40] {
        let scale = f32::from(size) / units;
        for (step, character) in (0_i16..).zip("Hamburgefonstiv&@8Qäß 0123RWk?%".chars()) {
            // Another place in the pixel for each.
            let at = (16 * 8 + step % 16, 16 * 45 + step * 5 % 16);
            let ours = ours(&font, character, size, (at.0.into(), at.1.into()));
            let theirs = theirs(&reference, font.glyph(character), scale, at);
            for (ours, theirs) in ours.iter().zip(&theirs).filter(|(ours, theirs)| ours != theirs) {
                let off = (ours - theirs).abs();
                (sum, pixels) = (sum + off, pixels + 1);
                if off > worst.0 {
                    worst = (off, character, size);
                }
            }
        }
    }
    let mean = sum / f64::from(pixels);
    assert!(worst.0 <= 1.5 && mean <= 0.02, "{worst:?}, in the mean {mean}");
}

/// Counts how often glyphs are traced.
struct Counting<'f, F> {
    face: &'f F,
    traces: Cell<usize>,
}

impl<F: Typeface> Typeface for Counting<'_, F> {
    fn metrics(&self) -> FontMetrics {
        self.face.metrics()
    }

    fn glyph(&self, character: char) -> GlyphId {
        self.face.glyph(character)
    }

    fn advance(&self, glyph: GlyphId) -> i32 {
        self.face.advance(glyph)
    }

    fn kerning(&self, left: GlyphId, right: GlyphId) -> i32 {
        self.face.kerning(left, right)
    }

    fn bounds(&self, glyph: GlyphId) -> Option<GlyphBox> {
        self.face.bounds(glyph)
    }

    fn trace<P: Pen>(&self, glyph: GlyphId, pen: &mut GlyphPen<'_, P>) {
        self.traces.set(self.traces.get() + 1);
        self.face.trace(glyph, pen);
    }
}

/// How often glyphs are traced for a text on a frame of 128 × 16 pixels, and whether one sees it.
fn traces(face: &impl Typeface, words: &str, at: (i32, i32)) -> (usize, bool) {
    let face = Counting { face, traces: Cell::new(0) };
    let mut frame = Frame::<Gray4, Rows, _>::with_array([0; 1024], 128, 16).expect("memory enough");
    let text = Text::new(&face, words, Subpixel::from_num(12), Point2::corner(at.0, at.1));
    let style = AntialiasedStyle::fill(Gray4::WHITE);
    let Ok(()) = text.into_styled(style).draw(&mut Blended::new(&mut frame));
    (face.traces.get(), frame.bytes().iter().any(|byte| *byte > 0))
}

#[test]
fn what_is_out_of_sight_is_not_traced() {
    let book = vec!["word ".repeat(60); 200].join("\n");
    let font = inter();
    for at in [(0, 100), (0, -4000), (200, 12), (i32::MAX, i32::MIN), (-4_000_000, 12)] {
        assert_eq!(traces(&font, &book, at), (0, false), "{at:?}");
        assert_eq!(traces(&Hershey::SIMPLEX, &book, at), (0, false), "{at:?}");
    }
    // Of 200 lines two are seen, as if there were no others; of each some six words.
    let (count, is_seen) = traces(&font, &book, (-300, 10));
    let lines = vec!["word ".repeat(60); 3].join("\n");
    assert!(is_seen && count > 0);
    assert_eq!(traces(&font, &lines, (-300, 10)).0, count);
    let text = Text::new(&font, &book, Subpixel::from_num(12), Point2::corner(-300, 10));
    let glyphs = text.glyphs(Rect::new(0, 0, 128, 16)).count();
    assert!((20..=64).contains(&glyphs), "{glyphs}");
}
