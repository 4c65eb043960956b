//! TrueType and OpenType fonts against `ab_glyph`, `HarfBuzz` and pictures.

use ab_glyph::{Font, FontRef, OutlineCurve, PxScale, point};
use aquatint::{
    Affine, Angle, FontError, FontMetrics, GlyphBox, GlyphId, Outline, Pen, Placed, Point2, Rect, Subpixel, Text,
    TrueType, Typeface,
};
use embedded_graphics::{prelude::*, text::Alignment};
use proptest::prelude::*;

use super::{Counting, FILL, LINE, assert_drawn, dark, is_on, rows};

pub(super) const INTER: &[u8] = include_bytes!("../../examples/assets/inter.ttf");
/// Seven glyphs of it with cubic curves, a table `kern`, and a blank in place of missing characters.
pub(super) const SAMPLE: &[u8] = include_bytes!("sample.otf");

fn inter() -> TrueType<'static> {
    TrueType::parse(INTER).expect("a font")
}

fn sample() -> TrueType<'static> {
    TrueType::parse(SAMPLE).expect("a font")
}

/// What the font has.
fn characters() -> impl Iterator<Item = char> + Clone {
    (' '..='~').chain('\u{A0}'..='\u{FF}').filter(|character| *character != '\u{AD}')
}

#[test]
fn words_at_small_sizes() {
    assert_drawn(WORDS, |frame| {
        let inter = inter();
        for (words, size, y) in [("AVATAR 12px", 12, 10), ("Größe 16", 16, 27), ("Type", 24, 48)] {
            let text = Text::new(&inter, words, Subpixel::from_num(size), Point2::corner(1, y));
            let Ok(()) = text.into_styled(FILL).draw(frame);
        }
    });
}

#[test]
fn two_turned_lines_and_a_border() {
    assert_drawn(TURNED, |frame| {
        let inter = inter();
        let text = Text::new(&inter, "turned\ntext", Subpixel::from_num(16), Point2::corner(32, 12));
        let turned = text.with_map(Affine::turn(Angle::from_degrees(15.0))).with_alignment(Alignment::Center);
        let Ok(()) = turned.into_styled(FILL).draw(frame);
        let border = Text::new(&inter, "&", Subpixel::from_num(48), Point2::corner(66, 46));
        let Ok(()) = border.into_styled(LINE).draw(frame);
    });
}

#[test]
fn cubic_curves_of_an_open_type_font_and_a_box_for_what_it_has_not() {
    assert_drawn(CUBIC, |frame| {
        let sample = sample();
        let text = Text::new(&sample, "Veg.Q", Subpixel::from_num(24), Point2::corner(1, 19));
        let Ok(()) = text.into_styled(FILL).draw(frame);
    });
}

#[test]
fn measures_are_those_of_the_font() {
    let extent = GlyphBox::new(-1513, -660, 5290, 2269);
    let metrics = FontMetrics { units_per_em: 2048, ascent: 1984, descent: 494, line_gap: 0, extent };
    assert_eq!(inter().metrics(), metrics);
    assert_eq!(sample().metrics().extent, GlyphBox::new(52, -442, 1361, 1490));
    let reference = FontRef::try_from_slice(INTER).expect("a font");
    for character in characters().chain(['–', '€', 'œ', 'Ω', '\u{10FFFF}', '\n']) {
        let glyph = inter().glyph(character);
        assert_eq!(glyph.0, reference.glyph_id(character).0, "{character}");
        let exact = f64::from(reference.h_advance_unscaled(ab_glyph::GlyphId(glyph.0)));
        assert!((f64::from(inter().advance(glyph)) - exact).abs() < 0.001, "{character}");
    }
    assert_eq!((inter().glyph('Ω'), inter().glyph('\u{10FFFF}')), (GlyphId(0), GlyphId(0)));
}

#[test]
fn kerning_is_that_of_harfbuzz() {
    let font = inter();
    let kerning = |left, right| font.kerning(font.glyph(left), font.glyph(right));
    for (pair, expected) in [("AV", -140), ("LT", -197), ("P,", -81), ("Te", -160), ("r.", -128), ("\"\"", 0)] {
        let mut pair = pair.chars();
        assert_eq!(kerning(pair.next().expect("two"), pair.next().expect("two")), expected, "{expected}");
    }
    // Of all pairs what hb-shape 11 says: how many are kerned, their sum, and a hash (FNV-1a of 32-bit numbers).
    let all = || characters().flat_map(|left| characters().map(move |right| kerning(left, right)));
    assert_eq!((all().filter(|kerning| *kerning != 0).count(), all().sum::<i32>()), (4141, -257_975));
    let hash = |hash: u64, kerning: i32| (hash ^ u64::from(kerning.cast_unsigned())).wrapping_mul(0x0100_0000_01B3);
    assert_eq!(all().fold(0xCBF2_9CE4_8422_2325, hash), 0xE092_BA91_C56D_7248);
}

#[test]
fn kerning_of_the_old_table_is_that_of_ab_glyph() {
    let (font, reference) = (sample(), FontRef::try_from_slice(SAMPLE).expect("a font"));
    let mut kerned = 0;
    for [left, right] in "AVeg.T ".chars().flat_map(|left| "AVeg.T ".chars().map(move |right| [left, right])) {
        let [left, right] = [left, right].map(|character| font.glyph(character));
        let exact = reference.kern_unscaled(ab_glyph::GlyphId(left.0), ab_glyph::GlyphId(right.0));
        let kerning = font.kerning(left, right);
        assert!((f64::from(kerning) - f64::from(exact)).abs() < 0.001);
        kerned += usize::from(kerning != 0);
    }
    assert_eq!(kerned, 3);
}

/// Twice the area that contours enclose, by the shoelace formula, and how many vertices they have.
#[derive(Default)]
struct Area {
    twice: i64,
    vertices: usize,
    first: (i64, i64),
    last: (i64, i64),
}

impl Area {
    fn edge(&mut self, to: (i64, i64)) {
        self.twice += self.last.0 * to.1 - to.0 * self.last.1;
        self.vertices += 1;
        self.last = to;
    }
}

fn units(point: Point2) -> (i64, i64) {
    (point.x.to_bits().into(), point.y.to_bits().into())
}

impl Pen for Area {
    fn move_to(&mut self, point: Point2) {
        self.edge(self.first);
        (self.first, self.last) = (units(point), units(point));
    }

    fn line_to(&mut self, point: Point2) {
        self.edge(units(point));
    }

    fn close(&mut self) {
        self.edge(self.first);
    }
}

/// Twice the area that curves enclose, exactly, and the length of their control polygons; in font units.
fn exact_area(curves: &[OutlineCurve]) -> (f64, f64) {
    let cross = |a: ab_glyph::Point, b: ab_glyph::Point| {
        let [ax, ay, bx, by] = [a.x, a.y, b.x, b.y].map(f64::from);
        ax * by - bx * ay
    };
    let length = |points: &[ab_glyph::Point]| -> f64 {
        points.windows(2).map(|ends| f64::from(ends[1].x - ends[0].x).hypot(f64::from(ends[1].y - ends[0].y))).sum()
    };
    let of = |curve: &OutlineCurve| match *curve {
        OutlineCurve::Line(a, b) => (cross(a, b), length(&[a, b])),
        OutlineCurve::Quad(a, b, c) => {
            ((2.0 * cross(a, b) + cross(a, c) + 2.0 * cross(b, c)) / 3.0, length(&[a, b, c]))
        }
        OutlineCurve::Cubic(a, b, c, d) => {
            let ends = 6.0 * cross(a, b) + 3.0 * cross(a, c) + cross(a, d);
            ((ends + 3.0 * cross(b, c) + 3.0 * cross(b, d) + 6.0 * cross(c, d)) / 10.0, length(&[a, b, c, d]))
        }
    };
    curves.iter().map(of).fold((0.0, 0.0), |(area, length), (a, l)| (area + a, length + l))
}

/// Compares the area of a glyph with the exact one: what is wrong is at most `bound` vertices' distance along the border.
fn assert_area(bytes: &'static [u8], character: char, size: i32) {
    let (font, reference) = (TrueType::parse(bytes).expect("a font"), FontRef::try_from_slice(bytes).expect("a font"));
    let curves = reference.outline(reference.glyph_id(character)).map(|outline| outline.curves).unwrap_or_default();
    let (exact, length) = exact_area(&curves);
    let string = character.to_string();
    let text = Text::new(&font, &string, Subpixel::from_num(size), Point2::corner(3, 5));
    for (fine, steps) in [(false, 16.0), (true, 256.0)] {
        let mut area = Area::default();
        if fine {
            text.trace_fine(&mut area);
        } else {
            text.trace(&mut area);
        }
        area.edge(area.first);
        let scale = f64::from(size) * steps / f64::from(font.metrics().units_per_em);
        #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
        let (twice, vertices) = (area.twice as f64, area.vertices as f64);
        // A point is at most 0.71 steps from its place, a chord ¼ from the curve. y points down here.
        let bound = 2.0 * (length * scale + 4.0 * vertices);
        let error = twice + exact * scale * scale;
        assert!(error.abs() <= bound, "{character} at {size}: {error} of {bound}");
        assert!(curves.is_empty() || twice != 0.0, "{character}");
    }
}

#[test]
fn the_area_of_every_glyph_is_that_of_its_curves() {
    for character in characters().chain(['Ω']) {
        for size in [9, 32, 150] {
            assert_area(INTER, character, size);
        }
    }
    for character in "AVeg.T ".chars() {
        assert_area(SAMPLE, character, 40);
    }
}

/// Compares a word with what `ab_glyph` says of each pixel: covered wholly, or not at all.
fn assert_coverage(words: &str, size: f32, at: (i32, i32)) -> usize {
    let (font, reference) = (inter(), FontRef::try_from_slice(INTER).expect("a font"));
    let (width, height) = (160_u16, 40_u16);
    let mut coverage = vec![0.0_f32; usize::from(width) * usize::from(height)];
    let units = f32::from(font.metrics().units_per_em);
    let scale = PxScale::from(size * reference.height_unscaled() / units);
    let (mut pen, mut before) = (0, None);
    for character in words.chars() {
        let glyph = font.glyph(character);
        pen += before.map_or(0, |before| font.advance(before) + font.kerning(before, glyph));
        before = Some(glyph);
        #[expect(clippy::cast_precision_loss, reason = "small")]
        let [x, y, along] = [at.0, at.1, pen].map(|v| v as f32);
        let place = point(x / 16.0 + along * size / units, y / 16.0);
        let Some(outline) = reference.outline_glyph(ab_glyph::GlyphId(glyph.0).with_scale_and_position(scale, place))
        else {
            continue;
        };
        let corner = outline.px_bounds().min;
        outline.draw(|x, y, covered| {
            #[expect(clippy::cast_possible_truncation, reason = "whole and small")]
            let [x, y] = [(corner.x as i32).saturating_add_unsigned(x), (corner.y as i32).saturating_add_unsigned(y)];
            if let (Ok(x @ 0..160), Ok(y @ 0..40)) = (usize::try_from(x), usize::try_from(y)) {
                coverage[y * 160 + x] += covered;
            }
        });
    }
    let mut frame = dark(width.into(), height.into());
    let text = Text::new(&font, words, Subpixel::from_num(size), Point2::from_sixteenths(at.0, at.1));
    let Ok(()) = text.into_styled(FILL).draw(&mut frame);
    let mut decided = 0;
    for (place, covered) in (0..).zip(coverage) {
        let on = is_on(&frame, place % 160, place / 160);
        assert!(covered < 0.98 || on, "{words} {size} {at:?}: {place} is covered, {covered}\n{}", rows(&frame));
        assert!(covered > 0.02 || !on, "{words} {size} {at:?}: {place} is not covered, {covered}\n{}", rows(&frame));
        decided += usize::from(covered >= 0.98);
    }
    decided
}

#[test]
fn pixels_wholly_covered_are_on_and_others_off() {
    assert!(assert_coverage("AVATAR Te", 31.25, (37, 480)) > 500);
    assert!(assert_coverage("Größe, Øre & Ñandú", 17.0, (8, 500)) > 100);
    assert!(assert_coverage("gjpqy@%{}", 28.0, (0, 419)) > 300);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]
    #[test]
    fn pixels_of_any_word_agree(words in "[ -~¡-¬®-ÿ]{1,12}", size in 6..40_u8, x in 0..400_i32, y in 100..600_i32) {
        assert_coverage(&words, size.into(), (x, y));
    }

    #[test]
    fn glyph_by_glyph_the_pixels_are_those_of_the_whole_outline(
        words in "[ -~\n]{0,20}", size in 20..600_i32, at in (-900..900_i32, -100..700_i32), turn: u16,
    ) {
        let inter = inter();
        let text = Text::new(&inter, &words, Subpixel::from_bits(size), Point2::from_sixteenths(at.0, at.1));
        let text = text.with_map(Affine::turn(Angle(turn)));
        let (mut drawn, mut expected) = (dark(48, 32), dark(48, 32));
        let Ok(()) = text.into_styled(FILL).draw(&mut drawn);
        let Ok(()) = Placed::new(text, Affine::IDENTITY).into_styled(FILL).draw(&mut expected);
        prop_assert_eq!(rows(&drawn), rows(&expected));
    }
}

#[test]
fn a_box_in_the_font_holds_its_glyph() {
    let inter = inter();
    for number in 0..223 {
        let (glyph, id) = (inter.bounds(GlyphId(number)), ab_glyph::GlyphId(number));
        let reference = FontRef::try_from_slice(INTER).expect("a font").outline(id).map(|outline| outline.bounds);
        let Some(exact) = reference else {
            assert_eq!(glyph, None, "{number}");
            continue;
        };
        let bounds = glyph.expect("drawn");
        let [left, bottom, right, top] = [bounds.left, bounds.bottom, bounds.right, bounds.top].map(f64::from);
        let [x, y] = [[exact.min.x, exact.max.x], [exact.min.y, exact.max.y]].map(|ends| ends.map(f64::from));
        let [least_y, most_y] = [y[0].min(y[1]), y[0].max(y[1])];
        // What is composed may be rounded by a unit.
        assert!(left <= x[0] + 1.0 && x[1] <= right + 1.0, "{number}: {bounds:?} {exact:?}");
        assert!(bottom <= least_y + 1.0 && most_y <= top + 1.0, "{number}: {bounds:?} {exact:?}");
    }
}

#[test]
fn a_glyph_is_traced_for_what_is_seen_and_not_often() {
    let face = Counting::new(inter());
    let words = "The quick brown fox jumps over the lazy dog. ".repeat(20);
    let text = Text::new(&face, &words, Subpixel::from_num(16), Point2::corner(-2000, 14));
    let window = Rect::new(0, 0, 128, 20);
    let glyphs = text.glyphs(window).count();
    let (_, traces) = face.take();
    assert!((12..=24).contains(&glyphs) && traces == 0, "{glyphs}");
    let mut frame = dark(128, 20);
    let Ok(()) = text.into_styled(FILL).draw(&mut frame);
    let (lookups, traces) = face.take();
    println!("{glyphs} glyphs, {lookups} lookups, {traces} traces");
    assert!(traces <= 3 * glyphs, "{traces} traces of {glyphs} glyphs");
}

#[test]
fn errors_say_what_is_missing() {
    assert_eq!(TrueType::parse(&[]).unwrap_err(), FontError::NotAFont);
    assert_eq!(TrueType::parse(b"GIF89a, not a font at all").unwrap_err(), FontError::NotAFont);
    assert_eq!(TrueType::of_collection(INTER, 1).unwrap_err(), FontError::NoSuchFont);
    for (tag, error) in [
        (b"head", FontError::NoMetrics),
        (b"hhea", FontError::NoMetrics),
        (b"maxp", FontError::NoMetrics),
        (b"hmtx", FontError::NoMetrics),
        (b"cmap", FontError::NoCharacters),
        (b"glyf", FontError::NoOutlines),
        (b"loca", FontError::NoOutlines),
    ] {
        let mut bytes = INTER.to_vec();
        let record = bytes.windows(4).position(|tag_there| tag_there == tag).expect("a table");
        // It becomes a table of no length.
        bytes[record + 12..record + 16].fill(0);
        assert_eq!(TrueType::parse(&bytes).unwrap_err(), error, "{error}");
    }
}

const WORDS: &str = "\
................................................................................................
....##...#.....#...##...######...##....#####.......##...###.....................................
....##...#.....#...##.....##.....##....#...##.....###..##..#....................................
....#.#...#...##...###....##.....###...#....#.......#..#...#..#..#...#...##.....................
...#..#...#...#...#..#....##....#..#...#....#.......#......#..##..##..#..#......................
...#..#...#...#...#..#....##....#..#...#...##.......#.....##..##...#..###.......................
...#...#...#.##..##..##...##...##..##..#####........#.....#...#....#...##.......................
..######...#.#...######...##...######..#...#........#....#....##...#...##.......................
..#....#...#.#...#....#...##...#....#..#...##.......#...#.....##...#..#..#......................
.##.....#...#...##.....#..##..##.....#.#....#.......#..######.#.###..#...#......................
..............................................................#.................................
..............................................................#.................................
................................................................................................
................................................................................................
................................................................................................
.....####............##.##.....####....................##.....###...............................
....#######..........##.##....######..................###....######.............................
...##....##...................#....#.................##.#...##....#.............................
..##......##..##.##...###.....#....##....####...........#...#...................................
..##..........###.#..##.##....#....#....##.###..........#...#..##...............................
..#...........##....#.....#...#..##....##....#..........#..#######..............................
..#....#####..##....#.....#...#..###...#.....##.........#..###...##.............................
..#.......##..##....#.....#...#....##..########.........#..##.....#.............................
..##......##..##....#.....#...#.....#..#................#...#.....#.............................
...#......##..##....#.....#...#.....#..##...............#...#.....#.............................
...###...##...##....##...##...#....##...##...#..........#...##...##.............................
.....#####....##.....#####....#..###.....####...........#....#####..............................
................................................................................................
................................................................................................
................................................................................................
................................................................................................
..#############.................................................................................
........##......................................................................................
........##......................................................................................
........##......................................................................................
........##......##.......###..##..#####........######...........................................
........##......###......##...##.#######......########..........................................
........##.......##......##...####....###....###.....##.........................................
........##.......##.....##....###......##....##......###........................................
........##.......###....##....###.......##...##.......##........................................
........##........##....##....##........##..############........................................
........##........##...##.....##........##..############........................................
........##.........##..##.....##........##..###.................................................
........##.........##.###.....###.......##...##.................................................
........##.........##.##......###......##....##.................................................
........##..........####......####....###....###.....###........................................
........##..........###.......##.#######......#########.........................................
........##..........###.......##..#####........#######..........................................
....................###.......##................................................................
....................##........##................................................................
....................##........##................................................................
.................####.........##................................................................
.................###..........##................................................................
................................................................................................
................................................................................................
................................................................................................
";

const TURNED: &str = "\
...........#....##....#.................................................................................
...........#....#.....#...#.............................................................................
..........##....#....##..#####..........................................................................
..........##...##....##..##..#..#.......................................................................
..........#....##....#...#.....######...................................................................
..........##...#.....#...#.....##...##..................................................................
...........##..##...##..##.....#....##...####...........................................................
................#####...##.....#....##..##..##..........##..............................................
....................#...#.....##....##..#....##....##...#...............................................
.......................##.....#.....#..###....#...#####.#...............................................
..............................#....##..########..##...###....................#####......................
..............................#....##..##....##.##.....##..................###....###...................
...................................#...##.......##.....#.................##..........#..................
........................................##..##..##....##................##............#.................
.........................................####...##....##................#....#####.....#................
.................................................#...##................#....##....##...#................
.................................................####.#................#...##......#....#...............
.................##..................................##................#...#.......##...#...............
.................##....................................................#...#........#...#...............
................###....................................................#...#.......#....#...............
.................###...................................................#...#.......#...##...............
................##....####.............................................#....#.....#....#................
................##...##..##.............................................#...##...#....##................
................#...##....##..##........#...............................#....#.##.....#.................
................#...###...##...#...##..##................................#....##.....#..................
...............##...#..#####...#..##..###................................##........##...................
...............##...#.....##...#.#.....###................................#.......##....................
................##..##.........##......#..................................##.....#......................
.....................##..##...###.....##.................................#.......#......................
......................####...##.##....##................................#.........#.....................
............................##...#....#................................#.....##....#......#####.........
.................................#....#...............................#....##.##....#.....#...#.........
..................................#...#..............................#....##...#....##...#....#.........
......................................##.............................#...##.....#....##..#...#..........
....................................................................#....#.......#....#..#...#..........
....................................................................#...##........#....#.#...#..........
....................................................................#...#..........#....#....#..........
....................................................................#...#..........##.......#...........
....................................................................#...#...........#.......#...........
....................................................................#....#...........#.....#............
.....................................................................#...##..........#.....#............
.....................................................................#....##.......##.......#...........
......................................................................#.....#######..........#..........
.......................................................................#...............###...##.........
........................................................................#.............##.#....##........
.........................................................................###.......###....######........
...........................................................................########.....................
........................................................................................................
........................................................................................................
........................................................................................................
";

const CUBIC: &str = "\
............................................................................
............................................................................
..##..........###......................................#########............
..###.........##.......................................#########............
...##.........##.......................................#......##............
...##........###.......................................#......##............
...###.......##.......######........#####.##...........#......##............
....##.......##......########.....##########...........#......##............
....##......##......##.....###....##.....###...........#......##............
.....##.....##.....##.......##...###......##...........#......##............
.....##....###.....##.......##...##.......##...........#......##............
.....##....##......###########...##.......##...........#......##............
......##...##......###########...##.......##...........#......##............
......##..###......##............##.......##...........#......##............
......###.##.......##............##.......##...........#......##............
.......##.##.......###......#....###......##...........#......##............
.......##.##........##.....###....###...####.....##....#......##............
........###.........#########......######.##....###....#########............
........###...........######........####..##....###....#########............
..........................................##................................
..........................................##................................
.................................###.....###................................
..................................#########.................................
...................................#######..................................
............................................................................
............................................................................
";
