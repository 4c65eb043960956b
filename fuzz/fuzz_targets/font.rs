//! Fonts of any bytes and text of any kind: no panic, no hang, and glyph by glyph the pixels of the whole outline.
#![no_main]

use std::hint::black_box;

use aquatint::{
    Affine, FillStyle, Frame, Hershey, Placed, Point2, Rows, Scalar, StrokeStyle, Subpixel, Text, TrueType, Typeface,
};
use arbitrary::{Arbitrary, Unstructured};
use embedded_graphics::{pixelcolor::BinaryColor, prelude::*, text::Alignment};
use libfuzzer_sys::fuzz_target;

#[derive(Arbitrary, Debug)]
struct Layout {
    words: String,
    size: u16,
    at: (i16, i16),
    height: Option<i16>,
    map: Option<[i32; 4]>,
    alignment: u8,
    is_snapped: bool,
    /// Bytes to be changed in a font that is right, with quadratic or with cubic curves; or only bytes.
    changes: Vec<(u16, u8)>,
    is_cubic: Option<bool>,
}

impl Layout {
    fn text<'a, F: Typeface>(&'a self, face: &'a F) -> Text<'a, F> {
        let at = Point2::from_sixteenths(self.at.0.into(), self.at.1.into());
        let alignment = [Alignment::Left, Alignment::Center, Alignment::Right][usize::from(self.alignment) % 3];
        let text = Text::new(face, &self.words, Subpixel::from_bits(self.size.into()), at).with_alignment(alignment);
        let text = self.height.map_or(text, |height| text.with_line_height(Subpixel::from_bits(height.into())));
        let text = self.map.map_or(text, |map| {
            let [xx, xy, yx, yy] = map.map(Scalar::from_bits);
            text.with_map(Affine::new([xx, xy], [yx, yy], Point2::default()))
        });
        if self.is_snapped { text.on_whole_pixels() } else { text }
    }
}

/// Draws on a frame of 32 × 24 pixels.
fn drawn(drawable: impl Drawable<Color = BinaryColor>) -> [u8; 96] {
    let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 96], 32, 24).expect("memory enough");
    let Ok(_) = drawable.draw(&mut frame);
    frame.bytes().try_into().expect("96 bytes")
}

/// Asks a text for all that it can do.
fn use_all<F: Typeface>(text: &Text<'_, F>) {
    let stroke = StrokeStyle::new(BinaryColor::On).with_width(2);
    let pictures = [drawn(text.into_styled(stroke)), drawn(text.into_styled(FillStyle::new(BinaryColor::On)))];
    black_box((pictures, text.end(), text.width(), text.bounding_box()));
}

fuzz_target!(|data: &[u8]| {
    let mut data = Unstructured::new(data);
    let Ok(layout) = Layout::arbitrary(&mut data) else { return };
    let mut bytes = match layout.is_cubic {
        Some(false) => include_bytes!("../../examples/assets/inter.ttf").to_vec(),
        Some(true) => include_bytes!("../../tests/text/sample.otf").to_vec(),
        None => data.take_rest().to_vec(),
    };
    for (place, value) in &layout.changes {
        if let Some(place) = usize::from(*place).checked_rem(bytes.len()) {
            bytes[place] = *value;
        }
    }
    if let Ok(font) = TrueType::parse(&bytes) {
        use_all(&layout.text(&font));
    }
    let text = layout.text(&Hershey::SIMPLEX);
    use_all(&text);
    let stroke = StrokeStyle::new(BinaryColor::On);
    let (by_glyph, whole) = (text.into_styled(stroke), Placed::new(text, Affine::IDENTITY).into_styled(stroke));
    assert_eq!(drawn(by_glyph), drawn(whole));
});
