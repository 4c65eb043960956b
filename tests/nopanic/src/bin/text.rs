//! Stroke fonts, text and its glyphs.
#![no_std]
#![no_main]

use aquatint::{
    AntialiasedStyle, Blended, FillStyle, Frame, GlyphId, Hershey, Outline, Rows, StrokeStyle, Text,
    Typeface,
};
use embedded_graphics::{pixelcolor::Gray4, prelude::*, text::Alignment, transform::Transform};
use nopanic::{any, keep, lent, one_of, part, shapes::Kept, side, text};

/// What a caller lends.
struct Memory {
    bytes: [u8; 1024],
    glyphs: [&'static str; 4],
}

const MEMORY: Memory = Memory { bytes: [0; 1024], glyphs: [""; 4] };

nopanic::entries! { MEMORY;
    glyph_of_face,
    text_measured,
    text_bounding_box,
    text_contains,
    glyphs,
    glyph_trace,
    glyph_trace_fine,
    text_filled,
    text_stroked,
    text_antialiased,
    styled_bounding_boxes,
}

fn face<'a>(glyphs: &'a mut [&'static str; 4]) -> Hershey<'a> {
    glyphs.fill_with(text);
    if any() { one_of(&[Hershey::SIMPLEX, Hershey::DUPLEX]) } else { Hershey::new(part(glyphs), any()) }
}

fn words<'a>(face: &'a Hershey<'a>) -> Text<'a, Hershey<'a>> {
    let alignment = one_of(&[Alignment::Left, Alignment::Center, Alignment::Right]);
    let words = Text::new(face, text(), any(), any()).with_alignment(alignment);
    if any() { words.with_line_height(any()).on_whole_pixels() } else { words.with_map(any()) }
}

fn glyph_of_face(memory: &mut Memory) {
    let face = face(&mut memory.glyphs);
    let glyph = face.glyph(any());
    keep((face.metrics(), face.metrics().line_height(), face.advance(glyph), face.bounds(GlyphId(any()))));
    keep(face.kerning(glyph, GlyphId(any())));
}

fn text_measured(memory: &mut Memory) {
    let face = face(&mut memory.glyphs);
    let words = words(&face);
    keep((words.place(), words.width(), words.end()));
}

fn text_bounding_box(memory: &mut Memory) {
    keep(words(&face(&mut memory.glyphs)).translate(any()).bounding_box());
}

fn text_contains(memory: &mut Memory) {
    keep(words(&face(&mut memory.glyphs)).contains(any()));
}

fn glyphs(memory: &mut Memory) {
    for glyph in words(&face(&mut memory.glyphs)).with_place(any()).glyphs(any()) {
        keep((glyph.id(), glyph.origin()));
    }
}

fn glyph_trace(memory: &mut Memory) {
    for glyph in words(&face(&mut memory.glyphs)).glyphs(any()) {
        glyph.trace(&mut Kept);
    }
}

fn glyph_trace_fine(memory: &mut Memory) {
    for glyph in words(&face(&mut memory.glyphs)).glyphs(any()) {
        glyph.trace_fine(&mut Kept);
    }
}

fn frame(bytes: &mut [u8]) -> Option<Frame<Gray4, Rows, &mut [u8]>> {
    Frame::new(lent(bytes), side(), side()).ok()
}

fn text_filled(memory: &mut Memory) {
    let Some(mut frame) = frame(&mut memory.bytes) else { return };
    let style = FillStyle::new(Gray4::new(any()));
    keep(words(&face(&mut memory.glyphs)).into_styled(style).draw(&mut frame).is_ok());
}

fn text_stroked(memory: &mut Memory) {
    let Some(mut frame) = frame(&mut memory.bytes) else { return };
    let style = StrokeStyle::new(Gray4::new(any())).with_width(any());
    keep(words(&face(&mut memory.glyphs)).into_styled(style).draw(&mut frame).is_ok());
}

fn text_antialiased(memory: &mut Memory) {
    let Some(mut frame) = frame(&mut memory.bytes) else { return };
    let style = AntialiasedStyle::stroke(Gray4::new(any()), any());
    keep(words(&face(&mut memory.glyphs)).into_styled(style).draw(&mut Blended::new(&mut frame)).is_ok());
}

fn styled_bounding_boxes(memory: &mut Memory) {
    let (face, color) = (face(&mut memory.glyphs), Gray4::new(any()));
    let words = words(&face);
    keep(words.into_styled(FillStyle::new(color)).bounding_box());
    keep(words.into_styled(StrokeStyle::new(color).with_width(any())).bounding_box());
    keep(words.into_styled(AntialiasedStyle::stroke(color, any())).bounding_box());
}
