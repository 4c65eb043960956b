//! Stroke fonts, text and its glyphs.
#![no_std]
#![no_main]

use core::hint::black_box;

use aquatint::{
    AntialiasedStyle, Blended, FillStyle, Frame, GlyphId, Hershey, Outline, Pen, Point2, Rows, StrokeStyle, Text,
    Typeface,
};
use embedded_graphics::{pixelcolor::Gray4, prelude::*, text::Alignment, transform::Transform};
use nopanic::{any, keep, lent, part, text};

#[cortex_m_rt::entry]
fn main() -> ! {
    face(&Hershey::SIMPLEX);
    face(&Hershey::DUPLEX);
    let glyphs = [text(), text()];
    face(&Hershey::new(part(&glyphs), any()));
    loop {}
}

struct Kept;

impl Pen for Kept {
    fn move_to(&mut self, point: Point2) {
        keep(point);
    }

    fn line_to(&mut self, point: Point2) {
        keep(point);
    }

    fn close(&mut self) {
        keep(());
    }
}

fn face(face: &Hershey<'_>) {
    let face = black_box(face);
    let glyph = face.glyph(any());
    keep((face.metrics(), face.metrics().line_height(), face.advance(glyph), face.bounds(GlyphId(any()))));
    keep(face.kerning(glyph, GlyphId(any())));
    let words = Text::new(face, text(), any(), any()).with_alignment(black_box(Alignment::Center));
    let words = if any() { words.with_line_height(any()).on_whole_pixels() } else { words.with_map(any()) };
    keep((words.place(), words.width(), words.end(), words.bounding_box(), words.contains(any())));
    for glyph in words.with_place(any()).glyphs(any()) {
        keep((glyph.id(), glyph.origin()));
        glyph.trace(&mut Kept);
        glyph.trace_fine(&mut Kept);
    }
    drawn(&words.translate(any()));
}

fn drawn(words: &Text<'_, Hershey<'_>>) {
    let (mut bytes, color) = ([0; 64], Gray4::new(any()));
    let Ok(mut frame) = Frame::<Gray4, Rows, _>::new(lent(&mut bytes), any(), any()) else { return };
    let (fill, stroke) = (FillStyle::new(color), StrokeStyle::new(color).with_width(any()));
    keep((words.into_styled(fill).draw(&mut frame).is_ok(), words.into_styled(fill).bounding_box()));
    keep((words.into_styled(stroke).draw(&mut frame).is_ok(), words.into_styled(stroke).bounding_box()));
    let soft = AntialiasedStyle::stroke(color, any());
    keep((words.into_styled(soft).draw(&mut Blended::new(&mut frame)).is_ok(), words.into_styled(soft).bounding_box()));
}
