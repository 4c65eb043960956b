//! Only what is seen costs, and what is seen is right.

use aquatint::{Affine, FillStyle, Hershey, Placed, Point2, Rect, Scalar, StrokeStyle, Subpixel, Text};
use embedded_graphics::{pixelcolor::BinaryColor, prelude::*, primitives::Rectangle, text::Alignment};
use proptest::{collection::vec, prelude::*};

use super::{Counting, FILL, LINE, dark, is_on, rows};

/// 1000 lines of 100 words.
fn book() -> String {
    let line = "word ".repeat(100);
    vec![line.trim_end(); 1000].join("\n")
}

#[test]
fn lines_above_and_below_cost_no_lookup_and_glyphs_beside_no_outline() {
    let (face, book) = (Counting::new(Hershey::SIMPLEX), book());
    // 16 pixels an em: lines are 16 apart, and the 500th has its baseline at 12. "word " is 46 pixels wide.
    let text = Text::new(&face, &book, Subpixel::from_num(16), Point2::corner(-460, 12 - 500 * 16));
    let mut frame = dark(128, 16);
    let Ok(()) = text.into_styled(LINE).draw(&mut frame);
    let (lookups, traces) = face.take();
    assert!(rows(&frame).contains('#'));
    // Of three lines the ten words before, and three words and a bit that are seen or nearly so.
    assert!((150..=3 * 75).contains(&lookups), "{lookups} lookups");
    let glyphs = text.glyphs(Rect::new(0, 0, 128, 16)).count();
    assert!((12..=40).contains(&glyphs), "{glyphs} glyphs");
    // For a stroke each is traced to count its edges, and again to draw them.
    let _ = face.take();
    assert!(traces <= 3 * 40, "{traces} traces");
}

#[test]
fn text_out_of_sight_is_not_traced() {
    let (face, book) = (Counting::new(Hershey::SIMPLEX), book());
    let mut frame = dark(128, 64);
    for (x, y, most) in [(0, 100, 0), (0, -16_100, 0), (200, 30, 8), (-60_000, 30, 5 * 500), (i32::MAX, i32::MIN, 8)] {
        let text = Text::new(&face, &book, Subpixel::from_num(16), Point2::corner(x, y));
        let Ok(()) = text.into_styled(FILL).draw(&mut frame);
        let (lookups, traces) = face.take();
        assert!(traces == 0 && lookups <= most, "{x}, {y}: {lookups} lookups, {traces} traces");
    }
    assert!(!rows(&frame).contains('#'));
}

/// A text and where it is.
#[derive(Clone, Debug)]
struct Case {
    words: String,
    size: i32,
    at: (i32, i32),
    map: [i32; 4],
    alignment: Alignment,
    is_snapped: bool,
}

impl Case {
    fn text<'a>(&'a self, font: &'a Hershey<'static>) -> Text<'a, Hershey<'static>> {
        let at = Point2::from_sixteenths(self.at.0, self.at.1);
        let [xx, xy, yx, yy] = self.map.map(Scalar::from_bits);
        let map = Affine::new([xx, xy], [yx, yy], Point2::default());
        let text = Text::new(font, &self.words, Subpixel::from_bits(self.size), at);
        let text = text.with_map(map).with_alignment(self.alignment);
        if self.is_snapped { text.on_whole_pixels() } else { text }
    }
}

fn case() -> impl Strategy<Value = Case> {
    let alignment = prop_oneof![Just(Alignment::Left), Just(Alignment::Center), Just(Alignment::Right)];
    let upright =
        prop_oneof![Just([65_536, 0, 0, 65_536]), Just([-65_536, 0, 0, 65_536]), Just([0, -65_536, 65_536, 0])];
    let map = prop_oneof![3 => upright, 2 => prop::array::uniform4(-90_000..90_000_i32)];
    let words = prop_oneof!["[ -~é\n]{0,40}", "([a-z]{1,6} ){0,60}"];
    (words, 20..800_i32, (-1500..1500_i32, -900..900_i32), map, alignment, any::<bool>())
        .prop_map(|(words, size, at, map, alignment, is_snapped)| Case { words, size, at, map, alignment, is_snapped })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]
    #[test]
    fn glyph_by_glyph_the_pixels_are_those_of_the_whole_outline(case in case(), width in 0..9_u16) {
        for font in [Hershey::SIMPLEX, Hershey::DUPLEX] {
            let text = case.text(&font);
            let whole = Placed::new(text, Affine::IDENTITY);
            let (mut drawn, mut expected) = (dark(48, 32), dark(48, 32));
            let style = LINE.with_width(width);
            let Ok(()) = text.into_styled(style).draw(&mut drawn);
            let Ok(()) = whole.into_styled(style).draw(&mut expected);
            prop_assert_eq!(rows(&drawn), rows(&expected));
        }
    }

    #[test]
    fn boxes_hold_what_is_drawn(case in case(), width in 0..9_u16) {
        let text = case.text(&Hershey::SIMPLEX);
        let stroke = LINE.with_width(width);
        let boxes = [text.into_styled(FILL).bounding_box(), text.into_styled(stroke).bounding_box()];
        for (place, bounds) in boxes.into_iter().enumerate() {
            let mut frame = dark(48, 32);
            let Ok(()) = if place == 0 { fill(&text, FILL, &mut frame) } else { line(&text, stroke, &mut frame) };
            let outside = all(48, 32).find(|at| is_on(&frame, at.x, at.y) && !bounds.contains(*at));
            prop_assert_eq!(outside, None, "{:?}\n{}", bounds, rows(&frame));
        }
        let bounds = text.bounding_box();
        let mut frame = dark(48, 32);
        let Ok(()) = fill(&text, FILL, &mut frame);
        prop_assert!(all(48, 32).all(|at| !is_on(&frame, at.x, at.y) || bounds.contains(at)));
    }

    #[test]
    fn a_pixel_is_contained_when_it_is_filled(case in case(), at in vec((0..48_i32, 0..32_i32), 20)) {
        let text = case.text(&Hershey::SIMPLEX);
        let mut frame = dark(48, 32);
        let Ok(()) = fill(&text, FILL, &mut frame);
        for (x, y) in at {
            prop_assert_eq!(text.contains(Point::new(x, y)), is_on(&frame, x, y), "{}, {}", x, y);
        }
    }
}

type Text16<'a> = Text<'a, Hershey<'static>>;

fn fill(
    text: &Text16,
    style: FillStyle<BinaryColor>,
    frame: &mut super::Picture,
) -> Result<(), core::convert::Infallible> {
    text.into_styled(style).draw(frame)
}

fn line(
    text: &Text16,
    style: StrokeStyle<BinaryColor>,
    frame: &mut super::Picture,
) -> Result<(), core::convert::Infallible> {
    text.into_styled(style).draw(frame)
}

fn all(width: u32, height: u32) -> impl Iterator<Item = Point> {
    Rectangle::new(Point::zero(), Size::new(width, height)).points()
}
