//! Fonts that are cut off or have wrong bytes: errors and wrong glyphs, but no panic.

use std::time::{Duration, Instant};

use aquatint::{Outline, Pen, Point2, Subpixel, Text, TrueType, Typeface};
use embedded_graphics::prelude::*;
use proptest::{collection::vec, prelude::*, sample::Index};

use super::{
    FILL, LINE, dark,
    true_type::{INTER, SAMPLE},
};

/// Reads a font and draws with it, if it is one.
fn use_all(bytes: &[u8], words: &str) {
    let Ok(font) = TrueType::parse(bytes) else { return };
    let text = Text::new(&font, words, Subpixel::from_num(14), Point2::corner(0, 12));
    let mut frame = dark(64, 16);
    let Ok(()) = text.into_styled(FILL).draw(&mut frame);
    let Ok(()) = text.into_styled(LINE).draw(&mut frame);
    let _ = (text.end(), text.bounding_box(), font.metrics());
}

const WORDS: &str = "AV Täß&.\nQ€é";

#[test]
fn fonts_cut_off_anywhere() {
    for font in [INTER, SAMPLE] {
        let step = font.len() / 800 + 1;
        (0..font.len()).step_by(step).chain(0..600).for_each(|end| use_all(&font[..end], WORDS));
    }
}

#[test]
fn fonts_with_any_one_byte_of_their_directories_wrong() {
    for font in [INTER, SAMPLE] {
        for place in 0..400 {
            for value in [0, 1, 0x7F, 0x80, 0xFF] {
                let mut bytes = font.to_vec();
                bytes[place] = value;
                use_all(&bytes, "AVé");
            }
        }
    }
}

/// Where a table begins and how long it is.
fn table(font: &[u8], tag: [u8; 4]) -> (usize, usize) {
    let record = font.windows(4).position(|there| there == tag).expect("a table");
    let number = |at: usize| u32::from_be_bytes(*font[at..].first_chunk().expect("a directory"));
    (number(record + 8).try_into().expect("short"), number(record + 12).try_into().expect("short"))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]
    #[test]
    fn fonts_with_wrong_bytes_anywhere(places in vec((any::<Index>(), any::<u8>()), 1..40), cubic: bool) {
        let mut bytes = if cubic { SAMPLE } else { INTER }.to_vec();
        for (place, value) in places {
            let place = place.index(bytes.len());
            bytes[place] = value;
        }
        use_all(&bytes, WORDS);
    }

    #[test]
    fn fonts_with_wrong_bytes_in_one_table(
        tag in prop::sample::select(vec![*b"GPOS", *b"cmap", *b"glyf", *b"head", *b"hhea", *b"hmtx", *b"loca", *b"maxp"]),
        places in vec((0..3000_usize, prop_oneof![any::<u8>(), Just(0), Just(0xFF)]), 1..30),
    ) {
        let (start, length) = table(INTER, tag);
        let mut bytes = INTER.to_vec();
        for (place, value) in places {
            bytes[start + place % length] = value;
        }
        use_all(&bytes, WORDS);
    }

    #[test]
    fn cubic_fonts_with_wrong_bytes_in_one_table(
        tag in prop::sample::select(vec![*b"CFF ", *b"kern", *b"cmap"]), places in vec((any::<Index>(), any::<u8>()), 1..12),
    ) {
        let (start, length) = table(SAMPLE, tag);
        let mut bytes = SAMPLE.to_vec();
        for (place, value) in places {
            bytes[start + place.index(length)] = value;
        }
        use_all(&bytes, "AVeg.T Q");
    }
}

/// Notes whether anything is drawn.
struct Any(bool);

impl Pen for Any {
    fn move_to(&mut self, _point: Point2) {
        self.0 = true;
    }

    fn line_to(&mut self, _point: Point2) {}

    fn close(&mut self) {}
}

/// The font with glyph `number` composed of two of the next one, that of two of its next, and so on 40 times.
fn avalanche() -> Vec<u8> {
    let mut bytes = INTER.to_vec();
    let (glyphs, _) = table(INTER, *b"glyf");
    let (places, _) = table(INTER, *b"loca");
    for number in 0..40_u16 {
        let at = 22 * usize::from(number);
        // −1 contours, no box; x and y as bytes, another part follows; the same without another part.
        let mut glyph = vec![0xFF, 0xFF, 0, 0, 0, 0, 8, 0, 8, 0];
        for more in [0x20, 0] {
            glyph.extend([0, 0x02 | more]);
            glyph.extend((number + 1).to_be_bytes());
            glyph.extend([1, 1]);
        }
        bytes[glyphs + at..][..22].copy_from_slice(&glyph);
        let short = u16::try_from(at / 2).expect("short");
        bytes[places + 2 * usize::from(number)..][..4]
            .copy_from_slice(&[short.to_be_bytes(), (short + 11).to_be_bytes()].concat());
    }
    bytes
}

#[test]
fn glyphs_composed_of_too_many_parts_take_no_time() {
    let bytes = avalanche();
    let font = TrueType::parse(&bytes).expect("a font");
    let begin = Instant::now();
    for number in 0..60 {
        let _ = font.bounds(aquatint::GlyphId(number));
    }
    let text = Text::new(&font, "\u{1} !\"#$%&'()*+ABC", Subpixel::from_num(14), Point2::corner(0, 12));
    let mut any = Any(false);
    text.trace(&mut any);
    assert!(begin.elapsed() < Duration::from_secs(5));
    assert!(any.0, "other glyphs are drawn, and a box for the first");
}
