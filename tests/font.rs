//! Text by glyph sheets is the text of embedded-graphics, pixel by pixel.

use core::convert::Infallible;

use aquatint::{
    Columns, Frame, GlyphSheet, Inverted, LsbFirst, MsbFirst, Pages, Planes, Rows, TooSmall, Window, Words,
    display::{
        blit::{Blit, Coded},
        layout::Layout,
    },
};
use embedded_graphics::{
    image::{GetPixel, ImageRaw},
    mono_font::{
        DecorationDimensions, MonoFont, MonoTextStyle, ascii, iso_8859_1, iso_8859_5, jis_x0201,
        mapping::StrGlyphMapping,
    },
    pixelcolor::{BinaryColor, Gray2, Gray4, Gray8, Rgb565},
    prelude::*,
    text::{Baseline, Text, TextStyle},
};
use proptest::{collection::vec, prelude::*};

/// Three glyphs of 3 × 4 pixels with gaps between the characters, the third cut off: a font that is not
/// quite right.
static SPACED: MonoFont = MonoFont {
    image: ImageRaw::new(&[0b1111_1100, 0b1010_1000, 0b1010_1000, 0b1110_1000], 8),
    character_size: Size::new(3, 4),
    character_spacing: 2,
    baseline: 2,
    strikethrough: DecorationDimensions::new(0, 1),
    underline: DecorationDimensions::new(5, 1),
    glyph_mapping: &StrGlyphMapping::new("ab c", 2),
};

static EMPTY: MonoFont = MonoFont {
    image: ImageRaw::new(&[], 0),
    character_size: Size::new(3, 4),
    character_spacing: 0,
    baseline: 0,
    strikethrough: DecorationDimensions::new(0, 0),
    underline: DecorationDimensions::new(0, 0),
    glyph_mapping: &StrGlyphMapping::new("ab", 0),
};

static FONTS: [&MonoFont; 9] = [
    &ascii::FONT_6X10,
    &ascii::FONT_4X6,
    &ascii::FONT_9X15_BOLD,
    &ascii::FONT_10X20,
    &iso_8859_1::FONT_6X13_ITALIC,
    &iso_8859_5::FONT_5X8,
    &jis_x0201::FONT_6X13,
    &SPACED,
    &EMPTY,
];

const BASELINES: [Baseline; 4] = [Baseline::Top, Baseline::Bottom, Baseline::Middle, Baseline::Alphabetic];

/// What is written, where, on which noise.
#[derive(Clone, Debug)]
struct Case {
    font: usize,
    baseline: usize,
    text: String,
    at: Point,
    number: u32,
    noise: Vec<u8>,
}

impl Case {
    fn sheet<M: Layout<BinaryColor>>(&self) -> GlyphSheet<'static, M, Vec<u8>> {
        let font = FONTS[self.font];
        let memory = vec![0xA5; GlyphSheet::<M, ()>::bytes_needed(font)];
        GlyphSheet::load(font, memory).expect("as much as it needs").with_baseline(BASELINES[self.baseline])
    }

    /// The text of embedded-graphics.
    fn write<D: DrawTarget<Error = Infallible>>(&self, target: &mut D, color: D::Color) -> Point {
        let style = MonoTextStyle::new(FONTS[self.font], color);
        let text_style = TextStyle::with_baseline(BASELINES[self.baseline]);
        let Ok(end) = Text::with_text_style(&self.text, self.at, style, text_style).draw(target);
        end
    }

    fn frame<C: Coded, L: Layout<C>>(&self) -> Frame<C, L, Vec<u8>> {
        let bytes = Frame::<C, L, ()>::bytes_needed(61, 43) + 5;
        Frame::new(self.noise.iter().copied().cycle().take(bytes).collect(), 61, 43).expect("as much as it needs")
    }
}

fn same<C, L, M>(case: &Case) -> Result<(), TestCaseError>
where
    C: Coded,
    L: Layout<C>,
    M: Layout<BinaryColor>,
{
    let (mut ours, mut theirs) = (case.frame::<C, L>(), case.frame::<C, L>());
    let color = C::from_number(case.number);
    let end = case.sheet::<M>().draw(&mut ours, &case.text, case.at, color);
    prop_assert_eq!(end, case.write(&mut theirs, color));
    prop_assert_eq!(ours.memory(), theirs.memory());
    Ok(())
}

/// The same in bands of eight rows.
fn same_in_bands<L: Layout<BinaryColor>>(case: &Case) -> Result<(), TestCaseError> {
    let (sheet, color) = (case.sheet::<L>(), BinaryColor::from_number(case.number));
    let mut whole = case.frame::<BinaryColor, L>();
    whole.clear(color.invert()).expect("in memory");
    case.write(&mut whole, color);
    for top in (0..43).step_by(8) {
        let mut band = Frame::<BinaryColor, L, _>::with_array([0; 61 * 8], 61, 8).expect("enough");
        band.clear(color.invert()).expect("in memory");
        sheet.draw(&mut Window::band(&mut band, top), &case.text, case.at, color);
        for (row, column) in (0..8.min(43 - top)).flat_map(|row| (0..61).map(move |column| (row, column))) {
            let there = whole.pixel(Point::new(column, top + row));
            prop_assert_eq!(band.pixel(Point::new(column, row)), there);
        }
    }
    Ok(())
}

fn case() -> impl Strategy<Value = Case> {
    let place = (-70..70_i32, -30..60_i32).prop_map(|(x, y)| Point::new(x, y));
    let text = prop_oneof![
        3 => "[ -~]{0,15}",
        2 => "([ -~]{0,5}\r?\n){0,3}[ -~¥ÿЖ‾…😀]{0,4}",
        1 => "[abc ]{0,9}",
        1 => any::<String>().prop_map(|text| text.chars().take(9).collect()),
    ];
    (0..FONTS.len(), 0..BASELINES.len(), text, place, any::<u32>(), vec(any::<u8>(), 40..60))
        .prop_map(|(font, baseline, text, at, number, noise)| Case { font, baseline, text, at, number, noise })
}

type Check = fn(&Case) -> Result<(), TestCaseError>;

const CHECKS: [Check; 16] = [
    same::<BinaryColor, Rows, Rows>,
    same::<BinaryColor, Pages, Pages>,
    same::<BinaryColor, Pages, Rows>,
    same::<BinaryColor, Rows<LsbFirst>, Rows<LsbFirst>>,
    same::<BinaryColor, Pages<MsbFirst>, Pages<MsbFirst>>,
    same::<BinaryColor, Columns, Columns>,
    same::<BinaryColor, Rows, Columns>,
    same::<BinaryColor, Inverted<Pages>, Pages>,
    same::<BinaryColor, Inverted<Rows>, Inverted<Rows>>,
    same::<Gray2, Rows, Rows>,
    same::<Gray2, Planes, Rows>,
    same::<Gray4, Rows, Rows>,
    same::<Gray8, Rows, Rows>,
    same::<Rgb565, Words, Rows>,
    same_in_bands::<Rows>,
    same_in_bands::<Pages>,
];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn any_text_is_that_of_embedded_graphics(case in case(), which: prop::sample::Index) {
        which.get(&CHECKS)(&case)?;
    }
}

#[test]
fn all_printable_characters_are_those_of_embedded_graphics() {
    for (font, row) in (0..FONTS.len()).flat_map(|font| (0..8).map(move |row| (font, row))) {
        let text = (32..127_u8).chain(160..=255).chain([7]).map(char::from).skip(row * 24).take(24).collect();
        let case = Case { font, baseline: 3, text, at: Point::new(2, 25), number: u32::MAX, noise: vec![0; 9] };
        for check in CHECKS {
            assert!(check(&case).is_ok(), "{case:?}");
        }
    }
}

#[test]
fn a_word_by_hand() {
    let sheet = GlyphSheet::<Rows, _>::load(&SPACED, [0; 5]).expect("five bytes");
    let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 8], 8, 8).expect("eight bytes");
    let end = sheet.draw(&mut frame, "ab\n a", Point::new(0, 2), BinaryColor::On);
    // There is no third glyph: it is cut off.
    assert_eq!(
        frame.bytes(),
        [
            0b1110_0111,
            0b1010_0010,
            0b1010_0010,
            0b1110_0010, //
            0b0000_0111,
            0b0000_0101,
            0b0000_0101,
            0b0000_0111,
        ]
    );
    assert_eq!(end, Point::new(8, 6));
}

#[test]
fn text_far_away_is_not_drawn() {
    let sheet = GlyphSheet::<Pages, _>::load(&ascii::FONT_6X10, vec![0; 768]).expect("as much as it needs");
    let mut frame = Frame::<BinaryColor, Pages, _>::with_array([0; 64], 64, 8).expect("64 bytes");
    for at in [i32::MIN, i32::MAX, i32::MAX - 9, -1000, 1000] {
        for at in [Point::new(at, 5), Point::new(5, at), Point::new(at, at)] {
            sheet.draw(&mut frame, "far\naway\n\r\n…", at, BinaryColor::On);
            let Ok(()) = Window::band(&mut frame, at.y).clear(BinaryColor::Off);
        }
    }
    assert_eq!(frame.bytes(), [0; 64]);
}

#[test]
fn too_small_a_memory_is_told() {
    let needed = GlyphSheet::<Rows, ()>::bytes_needed(&ascii::FONT_6X10);
    assert_eq!(needed, 12 * 61);
    let sheet = GlyphSheet::<Rows, _>::load(&ascii::FONT_6X10, [0; 12 * 61 - 1]);
    assert_eq!(sheet.map(drop), Err(TooSmall { needed }));
}

#[test]
fn glyphs_are_shapes() {
    let sheet = GlyphSheet::<Rows, _>::load(&SPACED, [0; 5]).expect("five bytes");
    let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0xFF; 4], 8, 4).expect("four bytes");
    let letter = sheet.glyph('b').expect("it has one");
    frame.paint(letter, Point::new(2, -1), BinaryColor::Off);
    assert_eq!(frame.bytes(), [0b1110_1111, 0b1110_1111, 0b1110_1111, 0xFF]);
    assert!(sheet.glyph('z').is_none());
}
