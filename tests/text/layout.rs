//! Where glyphs stand: advances, kerning, lines, alignment, maps.

use aquatint::{
    Affine, Angle, FontMetrics, GlyphBox, GlyphId, GlyphPen, Hershey, Pen, Point2, Rect, Scalar, Subpixel, Text,
    Typeface, pixel_bounds,
};
use embedded_graphics::{prelude::*, text::Alignment};
use proptest::prelude::*;

use super::{FILL, assert_drawn};

const EVERYWHERE: Rect = Rect::new(-1 << 20, -1 << 20, 1 << 20, 1 << 20);

/// Squares: `i` is narrow, `A` and `V` stand closer together, the space is blank.
struct Squares;

impl Typeface for Squares {
    fn metrics(&self) -> FontMetrics {
        FontMetrics { units_per_em: 10, ascent: 8, descent: 2, line_gap: 1, extent: GlyphBox::new(0, 0, 5, 8) }
    }

    fn glyph(&self, character: char) -> GlyphId {
        GlyphId(u16::try_from(u32::from(character)).unwrap_or(0))
    }

    fn advance(&self, glyph: GlyphId) -> i32 {
        if glyph == self.glyph('i') { 3 } else { 7 }
    }

    fn kerning(&self, left: GlyphId, right: GlyphId) -> i32 {
        match [left, right].map(|glyph| char::from_u32(glyph.0.into())) {
            [Some('A'), Some('V')] => -2,
            [Some('V'), Some('V')] => -100,
            _ => 0,
        }
    }

    fn bounds(&self, glyph: GlyphId) -> Option<GlyphBox> {
        let width = if glyph == self.glyph('i') { 1 } else { 5 };
        (glyph != self.glyph(' ')).then_some(GlyphBox::new(0, 0, width, 8))
    }

    fn trace<P: Pen>(&self, glyph: GlyphId, pen: &mut GlyphPen<'_, P>) {
        let Some(bounds) = self.bounds(glyph) else { return };
        let [width, height] = [bounds.right, bounds.top].map(Scalar::from_num);
        pen.move_to(Scalar::ZERO, Scalar::ZERO);
        pen.line_to(width, Scalar::ZERO);
        pen.line_to(width, height);
        pen.line_to(Scalar::ZERO, height);
    }
}

fn text(words: &str) -> Text<'_, Squares> {
    Text::new(&Squares, words, Subpixel::from_num(10), Point2::corner(0, 0))
}

/// Where the glyphs of a text begin, in pixels.
fn origins(text: &Text<'_, Squares>) -> Vec<(f64, f64)> {
    text.glyphs(EVERYWHERE).map(|glyph| (glyph.origin().x.to_num(), glyph.origin().y.to_num())).collect()
}

#[test]
fn glyphs_stand_by_advance_and_kerning() {
    assert_eq!(origins(&text("iAVA i")), [(0.0, 0.0), (3.0, 0.0), (8.0, 0.0), (15.0, 0.0), (29.0, 0.0)]);
    assert_eq!(text("iAVA i").end(), Point2::corner(32, 0));
    assert_eq!(text("iAVA i").width(), Subpixel::from_num(32));
}

#[test]
fn the_pen_never_moves_back() {
    assert_eq!(origins(&text("VVVA")), [(0.0, 0.0), (0.0, 0.0), (0.0, 0.0), (7.0, 0.0)]);
}

#[test]
fn lines_are_apart_as_the_font_or_the_user_says() {
    assert_eq!(origins(&text("i\n\r\ni\r\nii")), [(0.0, 0.0), (0.0, 22.0), (0.0, 33.0), (3.0, 33.0)]);
    let high = text("i\n\ni").with_line_height(Subpixel::from_num(12.5));
    assert_eq!(origins(&high), [(0.0, 0.0), (0.0, 25.0)]);
    assert_eq!((high.end(), text("i\n").end()), (Point2::corner(3, 25), Point2::corner(0, 11)));
    // Only a carriage return at the end of a line is a part of the line end.
    assert_eq!(origins(&text("\ri")).len(), 2);
}

#[test]
fn lines_are_aligned_one_by_one() {
    let [centred, right] = [Alignment::Center, Alignment::Right].map(|side| text("AAA\ni").with_alignment(side));
    assert_eq!(origins(&centred), [(-10.0, 0.0), (-3.0, 0.0), (4.0, 0.0), (-1.0, 11.0)]);
    assert_eq!(origins(&right), [(-21.0, 0.0), (-14.0, 0.0), (-7.0, 0.0), (-3.0, 11.0)]);
    assert_eq!((centred.end(), right.end()), (Point2::corner(2, 11), Point2::corner(0, 11)));
    assert_eq!((centred.width(), right.width()), (Subpixel::from_num(21), Subpixel::from_num(21)));
}

#[test]
fn a_map_turns_lines_about_the_place() {
    let turned = text("ii\ni").with_map(Affine::turn(Angle::QUARTER)).with_place(Point2::corner(100, 50));
    assert_eq!(origins(&turned), [(100.0, 50.0), (100.0, 53.0), (89.0, 50.0)]);
    assert_eq!(turned.end(), Point2::corner(89, 53));
    // Up from the baseline is to the right now.
    assert_eq!(pixel_bounds(&turned), Rect::new(89, 50, 108, 54));
    let moved = text("i").with_map(Affine::translation(Point2::corner(5, 6)));
    assert_eq!(origins(&moved), [(5.0, 6.0)]);
    let high = turned.with_line_height(Subpixel::from_num(20));
    assert_eq!(origins(&high)[2], (80.0, 50.0));
}

#[test]
fn text_of_no_size_and_no_text_is_nothing() {
    for (words, size) in [("", 10), ("\n\n\r\n", 10), ("  ", 10), ("abc", 0), ("abc", -10)] {
        let text = Text::new(&Squares, words, Subpixel::from_num(size), Point2::corner(3, 4));
        assert_eq!((text.glyphs(EVERYWHERE).count(), pixel_bounds(&text)), (0, Rect::default()), "{words}");
        assert_eq!(text.bounding_box().size, Size::zero());
    }
    assert_eq!(text("").end(), Point2::corner(0, 0));
    assert_eq!(text("abc").glyphs(Rect::default()).count(), 0);
}

#[test]
fn a_line_of_a_thousand_glyphs_does_not_drift() {
    let words = "i".repeat(1000);
    // 3 units of 10 an em at 7 pixels and 5 sixteenths are 2.19375 pixels.
    let text = Text::new(&Squares, &words, Subpixel::from_bits(117), Point2::from_sixteenths(5, 0));
    for (place, (x, _)) in (0..).zip(origins(&text)) {
        let exact = 5.0 + 117.0 * 0.3 * f64::from(place);
        assert!((x * 16.0 - exact).abs() <= 0.501, "{place}: {x}");
    }
}

#[test]
fn on_whole_pixels_every_letter_looks_the_same() {
    assert_drawn(SNAPPED, |frame| {
        let text = Text::new(&Squares, "AAAAA", Subpixel::from_num(5), Point2::corner(1, 5));
        let Ok(()) = text.on_whole_pixels().into_styled(FILL).draw(frame);
    });
}

const SNAPPED: &str = "\
....................
.##..##.##..##.##...
.##..##.##..##.##...
.##..##.##..##.##...
.##..##.##..##.##...
....................
";

#[test]
fn translated_text_is_the_text_elsewhere() {
    let mut moved = text("Ai").translate(Point::new(3, -4));
    assert_eq!(origins(&moved), [(3.0, -4.0), (10.0, -4.0)]);
    moved.translate_mut(Point::new(i32::MAX, i32::MIN));
    assert!(moved.contains(Point::zero()) || moved.glyphs(EVERYWHERE).count() == 0);
    assert!(text("Ai").contains(Point::new(4, -8)) && !text("Ai").contains(Point::new(5, -8)));
    assert!(!text("Ai").contains(Point::new(i32::MAX, i32::MAX)));
}

proptest! {
    #[test]
    fn the_end_is_where_the_next_glyph_begins(
        words in "[iAV \n]{0,20}", size in 1..2000_i32, turn: u16, height in prop::option::of(-500..500_i32),
    ) {
        let longer = format!("{words}i");
        let [short, long] = [&words, &longer].map(|words| {
            let text = Text::new(&Squares, words, Subpixel::from_bits(size), Point2::corner(9, 8));
            let text = text.with_map(Affine::turn(Angle(turn)));
            height.map_or(text, |height| text.with_line_height(Subpixel::from_bits(height)))
        });
        let last = long.glyphs(EVERYWHERE).last().expect("an i").origin();
        prop_assert_eq!(short.end(), last);
    }

    #[test]
    fn widths_are_those_of_the_widest_line(words in "[ -~\n]{0,60}") {
        let text = Text::new(&Hershey::SIMPLEX, &words, Subpixel::from_num(32), Point2::corner(0, 0));
        let line = |line: &str| line.chars().map(|c| Hershey::SIMPLEX.advance(Hershey::SIMPLEX.glyph(c))).sum::<i32>();
        let widest = words.split('\n').map(line).max().expect("a line");
        prop_assert_eq!(text.width(), Subpixel::from_num(widest));
    }
}
