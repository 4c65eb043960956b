//! Nothing panics or hangs, whatever is asked for.

use aquatint::{
    Affine, FontMetrics, GlyphBox, GlyphId, GlyphPen, Hershey, Outline, Pen, Point2, Rect, Scalar, Subpixel, Text,
    Typeface,
};
use embedded_graphics::{prelude::*, text::Alignment};
use proptest::prelude::*;

use super::{FILL, LINE, dark};

/// A font whose numbers are anything.
#[derive(Clone, Debug)]
struct Wild {
    metrics: FontMetrics,
    advances: [i32; 3],
    kerning: i32,
    bounds: Option<GlyphBox>,
    points: Vec<(i32, i32)>,
}

impl Typeface for Wild {
    fn metrics(&self) -> FontMetrics {
        self.metrics
    }

    fn glyph(&self, character: char) -> GlyphId {
        GlyphId(u16::try_from(u32::from(character) % 7).expect("small"))
    }

    fn advance(&self, glyph: GlyphId) -> i32 {
        self.advances[usize::from(glyph.0) % 3]
    }

    fn kerning(&self, left: GlyphId, right: GlyphId) -> i32 {
        if left < right { self.kerning } else { 0 }
    }

    fn bounds(&self, _glyph: GlyphId) -> Option<GlyphBox> {
        self.bounds
    }

    fn trace<P: Pen>(&self, glyph: GlyphId, pen: &mut GlyphPen<'_, P>) {
        let points = || self.points.iter().map(|(x, y)| [*x, *y].map(Scalar::from_bits));
        for (place, [x, y]) in (glyph.0..).zip(points()) {
            match place % 5 {
                0 => pen.move_to(x, y),
                1 => pen.line_to(x, y),
                2 => pen.quad_to([y, x], [x, y]),
                3 => pen.cubic_to([y, x], [x, x], [x, y]),
                _ => pen.close(),
            }
        }
    }
}

fn number() -> impl Strategy<Value = i32> {
    prop_oneof![any::<i32>(), -2000..2000_i32, Just(i32::MIN), Just(i32::MAX), Just(0)]
}

fn glyph_box() -> impl Strategy<Value = GlyphBox> {
    prop::array::uniform4(number()).prop_map(|[left, bottom, right, top]| GlyphBox::new(left, bottom, right, top))
}

prop_compose! {
    fn wild()(
        units_per_em: u16, heights in prop::array::uniform3(number()), extent in glyph_box(),
        advances in prop::array::uniform3(number()), kerning in number(), bounds in prop::option::of(glyph_box()),
        points in prop::collection::vec((number(), number()), 0..8),
    ) -> Wild {
        let [ascent, descent, line_gap] = heights;
        let metrics = FontMetrics { units_per_em, ascent, descent, line_gap, extent };
        Wild { metrics, advances, kerning, bounds, points }
    }
}

/// Size, place, line height, map.
type Layout = (i32, (i32, i32), Option<i32>, [i32; 4], Alignment);

fn layout() -> impl Strategy<Value = Layout> {
    let alignment = prop_oneof![Just(Alignment::Left), Just(Alignment::Center), Just(Alignment::Right)];
    (number(), (number(), number()), prop::option::of(number()), prop::array::uniform4(number()), alignment)
}

fn text<'t, F: Typeface>(face: &'t F, words: &'t str, (size, at, height, map, alignment): Layout) -> Text<'t, F> {
    let [xx, xy, yx, yy] = map.map(Scalar::from_bits);
    let at = Point2::from_sixteenths(at.0, at.1);
    let text = Text::new(face, words, Subpixel::from_bits(size), at).with_alignment(alignment);
    let text = text.with_map(Affine::new([xx, xy], [yx, yy], at));
    height.map_or(text, |height| text.with_line_height(Subpixel::from_bits(height)))
}

/// Counts vertices.
struct Count(usize);

impl Pen for Count {
    fn move_to(&mut self, _point: Point2) {
        self.0 += 1;
    }

    fn line_to(&mut self, _point: Point2) {
        self.0 += 1;
    }

    fn close(&mut self) {}
}

fn use_all<F: Typeface>(text: &Text<'_, F>) {
    let mut frame = dark(24, 16);
    let Ok(()) = text.into_styled(FILL).draw(&mut frame);
    let Ok(()) = text.on_whole_pixels().into_styled(LINE.with_width(3)).draw(&mut frame);
    let _ = (text.end(), text.width(), text.bounding_box(), text.contains(Point::new(3, 4)));
    let mut count = Count(0);
    text.trace_fine(&mut count);
    assert!(count.0 < 1 << 20);
    let _ = text.glyphs(Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX)).count();
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]
    #[test]
    fn wild_fonts(wild in wild(), words in "[a-g\n\r]{0,6}", layout in layout()) {
        use_all(&text(&wild, &words, layout));
    }

    #[test]
    fn wild_strings_and_layouts(words: String, layout in layout()) {
        use_all(&text(&Hershey::SIMPLEX, &words, layout));
    }
}
