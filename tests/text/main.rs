//! Text: layout, what is seen of it, stroke fonts, TrueType fonts against other readers of fonts.

mod hershey;
mod hostile;
mod layout;
mod seen;
#[cfg(feature = "ttf")]
mod true_type;
#[cfg(feature = "ttf")]
mod wrong_fonts;

use std::{cell::Cell, fmt::Write};

use aquatint::{FillStyle, FontMetrics, Frame, GlyphBox, GlyphId, GlyphPen, Pen, Rows, StrokeStyle, Typeface};
use embedded_graphics::{image::GetPixel, pixelcolor::BinaryColor, prelude::*};

type Picture = Frame<BinaryColor, Rows, Vec<u8>>;

const FILL: FillStyle<BinaryColor> = FillStyle::new(BinaryColor::On);
const LINE: StrokeStyle<BinaryColor> = StrokeStyle::new(BinaryColor::On);

fn dark(width: u32, height: u32) -> Picture {
    let bytes = Frame::<BinaryColor, Rows, ()>::bytes_needed(width, height);
    Picture::new(vec![0; bytes], width, height).expect("memory enough")
}

/// Rows of `#` and `.`.
fn rows(frame: &Picture) -> String {
    let size = frame.bounding_box().size;
    let mut picture = String::new();
    for y in 0..size.height.cast_signed() {
        for x in 0..size.width.cast_signed() {
            picture.push(if is_on(frame, x, y) { '#' } else { '.' });
        }
        writeln!(picture).expect("a string takes all");
    }
    picture
}

fn is_on(frame: &Picture, x: i32, y: i32) -> bool {
    frame.pixel(Point::new(x, y)) == Some(BinaryColor::On)
}

/// Draws on a dark frame and compares it with rows of `#` and `.`.
fn assert_drawn(expected: &str, draw: impl FnOnce(&mut Picture)) {
    let (width, height) = (expected.lines().next().expect("a row").len(), expected.lines().count());
    let [width, height] = [width, height].map(|side| u32::try_from(side).expect("short"));
    let mut frame = dark(width, height);
    draw(&mut frame);
    let picture = rows(&frame);
    assert_eq!(picture, expected, "\n{picture}");
}

/// Counts what is asked of a typeface.
struct Counting<F> {
    face: F,
    lookups: Cell<usize>,
    traces: Cell<usize>,
}

impl<F> Counting<F> {
    fn new(face: F) -> Self {
        Self { face, lookups: Cell::new(0), traces: Cell::new(0) }
    }

    /// Lookups and traces since the last time.
    fn take(&self) -> (usize, usize) {
        (self.lookups.take(), self.traces.take())
    }
}

impl<F: Typeface> Typeface for Counting<F> {
    fn metrics(&self) -> FontMetrics {
        self.face.metrics()
    }

    fn glyph(&self, character: char) -> GlyphId {
        self.lookups.set(self.lookups.get() + 1);
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
