//! Pictures in the source, targets of all kinds, and everything that can be wrong with the input.

use aquatint::{
    Connectivity, Flood, Frame, Inside, Pages, Pattern, PerPixel, Rect, Region, Rows, Runs, Turn, Turned, Window,
    raster::flood::{Filled, FloodError, Refused, Run, words_needed},
};
use embedded_graphics::{
    framebuffer::{Framebuffer, buffer_size},
    geometry::{Dimensions, Point, Size},
    image::GetPixel,
    pixelcolor::{
        BinaryColor, Gray8,
        raw::{BigEndian, RawU1},
    },
    prelude::*,
    primitives::Rectangle,
};
use proptest::prelude::*;

use crate::{layouts, places, sheet, text};

const HOUSE: [&str; 7] = [
    "....#....", //
    "...#.#...",
    "..#...#..",
    "#########",
    "#...#...#",
    "#...#...#",
    "#########",
];

/// Fills a copy of a picture with the code 2.
fn filled(rows: &[&str], region: impl Into<Region<Gray8>>, by: Connectivity) -> Vec<String> {
    let mut sheet = sheet(rows);
    let (mut memory, mut queue) = ([0; words_needed(9, 7)], [Run::default(); 4]);
    let mut flood = Flood::new(&mut memory, &mut queue).with_connectivity(by);
    flood.fill(&mut PerPixel::new(&mut sheet), region, Gray8::new(2)).expect("enough memory");
    text(&sheet)
}

#[test]
fn sides_stop_at_a_diagonal_line_and_corners_do_not() {
    let roof = Point::new(4, 2);
    assert_eq!(
        filled(&HOUSE, roof, Connectivity::Four),
        ["....#....", "...#2#...", "..#222#..", "#########", "#...#...#", "#...#...#", "#########"]
    );
    assert_eq!(
        filled(&HOUSE, roof, Connectivity::Eight),
        ["2222#2222", "222#2#222", "22#222#22", "#########", "#...#...#", "#...#...#", "#########"]
    );
}

#[test]
fn a_flood_stops_at_every_other_colour_and_a_boundary_fill_at_one() {
    let picture = ["#########", "#...3...#", "#.3.....#", "#########"];
    let mut colours = sheet(&picture);
    colours.codes[13] = 3;
    colours.codes[20] = 3;
    let (mut memory, mut queue) = ([0; words_needed(9, 4)], [Run::default(); 4]);
    let mut flood = Flood::new(&mut memory, &mut queue);
    let mut fill = |region| {
        let mut sheet = colours.clone();
        flood.fill(&mut PerPixel::new(&mut sheet), region, Gray8::new(2)).expect("enough memory");
        text(&sheet)
    };
    let seed = Point::new(1, 1);
    assert_eq!(fill(Region::Flood(seed)), ["#########", "#2223222#", "#2322222#", "#########"]);
    assert_eq!(fill(Region::Boundary(seed, Gray8::new(1))), ["#########", "#2222222#", "#2222222#", "#########"]);
    assert_eq!(fill(Region::Flood(Point::new(4, 1))), ["#########", "#...2...#", "#.3.....#", "#########"]);
    // A seed on the boundary: nothing is inside.
    assert_eq!(fill(Region::Boundary(Point::zero(), Gray8::new(1))), text(&colours));
}

#[test]
fn a_window_bounds_the_region() {
    let mut sheet = sheet(&["......"; 4]);
    let (mut memory, mut queue) = ([0; words_needed(3, 2)], [Run::default(); 1]);
    let mut flood = Flood::new(&mut memory, &mut queue).with_window(Rect::new(2, 1, 5, 3));
    let filled = flood.fill(&mut PerPixel::new(&mut sheet), Point::new(3, 2), Gray8::new(1));
    assert_eq!(filled, Ok(Filled { pixels: 6, bounds: Rect::new(2, 1, 5, 3) }));
    assert_eq!(text(&sheet), ["......", "..###.", "..###.", "......"]);
    assert_eq!(flood.fill(&mut PerPixel::new(&mut sheet), Point::new(1, 1), Gray8::new(3)), Ok(Filled::default()));
}

/// Walls of a small maze at random.
fn walls() -> impl Strategy<Value = Vec<bool>> {
    prop::collection::vec(prop::bool::weighted(0.3), 50 * 20)
}

const AREA: Rect = Rect::new(0, 0, 50, 20);

/// Draws the walls and fills what is around the middle.
fn draw<T>(target: &mut T, walls: &[bool], by: Connectivity) -> Result<Filled, FloodError<T::Error>>
where
    T: Runs + DrawTarget<Color = BinaryColor> + GetPixel<Color = BinaryColor>,
{
    let pixels = places(AREA).zip(walls).map(|(at, &wall)| Pixel(at, wall.into()));
    target.draw_iter(pixels).map_err(FloodError::Display)?;
    let (mut memory, mut queue) = ([7; words_needed(50, 20)], [Run::default(); 3]);
    let mut flood = Flood::new(&mut memory, &mut queue).with_connectivity(by);
    flood.fill(target, Region::Boundary(Point::new(25, 10), BinaryColor::On), BinaryColor::On)
}

fn picture(target: &impl GetPixel<Color = BinaryColor>, area: Rect) -> Vec<Option<BinaryColor>> {
    places(area).map(|at| target.pixel(at)).collect()
}

type OneBit = Framebuffer<BinaryColor, RawU1, BigEndian, 50, 20, { buffer_size::<BinaryColor>(50, 20) }>;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn every_kind_of_target_gives_the_same_picture(walls in walls(), by_corners in any::<bool>()) {
        let by = if by_corners { Connectivity::Eight } else { Connectivity::Four };
        let mut frame = Frame::<BinaryColor, Rows, _>::new([0; 140], 50, 20).expect("large enough");
        let filled = draw(&mut frame, &walls, by);
        let expected = picture(&frame, AREA);

        let mut buffer = OneBit::new();
        prop_assert_eq!(draw(&mut buffer, &walls, by), filled);
        prop_assert_eq!(picture(&buffer, AREA), expected.clone());

        let mut buffer = OneBit::new();
        prop_assert_eq!(draw(&mut PerPixel::new(&mut buffer), &walls, by), filled);
        prop_assert_eq!(picture(&buffer, AREA), expected.clone());

        let mut large = Frame::<BinaryColor, Pages, _>::new([0; 800], 100, 60).expect("large enough");
        let mut part = Window::part(&mut large, Rect::new(13, 21, 63, 41));
        prop_assert_eq!(draw(&mut part, &walls, by), filled);
        prop_assert_eq!(picture(&part, AREA), expected.clone());
        prop_assert_eq!(picture(&large, Rect::new(13, 21, 63, 41)), expected.clone());

        for turn in [Turn::Clockwise, Turn::CounterClockwise] {
            let mut lying = Frame::<BinaryColor, Pages, _>::new([0; 140], 20, 50).expect("large enough");
            let mut turned = Turned::new(&mut lying, turn);
            prop_assert_eq!(draw(&mut turned, &walls, by), filled);
            prop_assert_eq!(picture(&turned, AREA), expected.clone());
        }
    }

    #[test]
    fn a_display_anywhere_is_filled_with_any_ink(
        case in layouts::cases(), left in prop::sample::select(vec![i32::MIN, -40, i32::MAX - 140]),
        top in prop::sample::select(vec![i32::MIN, -3, i32::MAX - 40]),
    ) {
        let case = case.moved(left, top);
        let (codes, expected) = case.expected();
        let seen = case.seen();
        let mut memory = vec![case.litter; words_needed(seen.width(), seen.height())];
        let (mut sheet, mut queue) = (case.sheet.clone(), vec![Run::default(); case.queue]);
        let mut flood = Flood::new(&mut memory, &mut queue).with_connectivity(case.by).with_window(seen);
        let region = case.border.map_or(case.seed.into(), |border| Region::Boundary(case.seed, Gray8::new(border)));
        let ink = Pattern::new([case.ink.map(Gray8::new)]);
        prop_assert_eq!(flood.fill_with(&mut PerPixel::new(&mut sheet), region, ink), Ok(expected));
        prop_assert_eq!(sheet.codes, codes);
    }
}

#[test]
fn too_little_memory_leaves_everything_untouched_and_says_what_it_takes() {
    let mut frame = Frame::<BinaryColor, Rows, _>::new([0b0101_0000; 12], 33, 2).expect("large enough");
    for length in 0..5 {
        let (mut memory, mut queue) = (vec![77; length], [Run::default(); 2]);
        let refused = Refused::TooFewWords { needed: 5 };
        let mut flood = Flood::new(&mut memory, &mut queue);
        assert_eq!(flood.search(&frame, Point::zero()).err(), Some(refused));
        let filled = flood.fill(&mut frame, Point::zero(), BinaryColor::On);
        assert_eq!(filled, Err(FloodError::Refused(refused)));
        assert_eq!(filled.unwrap_err().to_string(), "5 words are needed");
        assert!(flood.fill_with(&mut frame, Point::zero(), BinaryColor::On).is_err());
        assert!(frame.bytes().iter().all(|&byte| byte == 0b0101_0000) && memory.iter().all(|&word| word == 77));
    }
    let (mut memory, mut queue) = ([0; 5], [Run::default(); 2]);
    assert!(Flood::new(&mut memory, &mut queue).fill(&mut frame, Point::zero(), BinaryColor::On).is_ok());
}

/// Blank, and as large as it says.
struct Vast(Rect);

impl Dimensions for Vast {
    fn bounding_box(&self) -> Rectangle {
        self.0.into()
    }
}

impl GetPixel for Vast {
    type Color = BinaryColor;

    fn pixel(&self, _at: Point) -> Option<BinaryColor> {
        Some(BinaryColor::Off)
    }
}

impl Runs for Vast {}

#[test]
fn windows_of_more_than_65_535_columns_or_rows_are_refused() {
    let everything = Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX);
    let (mut memory, mut queue) = (vec![0; 4100], [Run::default(); 2]);
    let mut pixels = |bounds: Rect, window: Option<Rect>, seed| {
        let mut flood = Flood::new(&mut memory, &mut queue);
        if let Some(window) = window {
            flood = flood.with_window(window);
        }
        let found = flood.search(&Vast(bounds), seed)?;
        let Ok(filled) = found.spans(&mut aquatint::SpanFn::new(everything, |_, _: core::ops::Range<i32>, ()| ()));
        Ok(filled.pixels)
    };
    let seed = Point::zero();
    assert_eq!(pixels(everything, None, seed), Err(Refused::TooLarge));
    assert_eq!(pixels(Rect::new(0, 0, 65_536, 1), None, seed), Err(Refused::TooLarge));
    assert_eq!(pixels(Rect::new(0, 0, 1, 65_536), None, seed), Err(Refused::TooLarge));
    assert_eq!(pixels(Rect::new(0, 0, 65_535, 1), None, seed), Ok(65_535));
    assert_eq!(
        pixels(Rect::new(0, 0, 65_535, 2), None, Point::new(65_534, 1)),
        Err(Refused::TooFewWords { needed: 4097 }).or(Ok(131_070))
    );
    assert_eq!(pixels(everything, Some(Rect::new(-3, -3, 4, 4)), seed), Ok(49));
    let corner = Rect::new(i32::MAX - 40, i32::MAX - 2, i32::MAX, i32::MAX);
    assert_eq!(pixels(everything, Some(corner), Point::new(i32::MAX - 1, i32::MAX - 1)), Ok(80));
    let corner = Rect::new(i32::MIN, i32::MIN, i32::MIN + 40, i32::MIN + 2);
    assert_eq!(pixels(everything, Some(corner), Point::new(i32::MIN, i32::MIN)), Ok(80));
    assert_eq!(pixels(everything, Some(Rect::new(5, 5, 2, 9)), Point::new(3, 6)), Ok(0));
    assert_eq!(Refused::TooLarge.to_string(), "more than 65535 columns or rows");
    assert_eq!(
        words_needed(u32::MAX, u32::MAX),
        usize::try_from((1_u64 << 27) * u64::from(u32::MAX) + (1 << 27)).unwrap_or(usize::MAX)
    );
}

#[test]
fn a_seed_outside_and_a_picture_without_pixels_fill_nothing() {
    for (width, height) in [(0, 0), (0, 5), (5, 0), (5, 5)] {
        let mut frame = Frame::<BinaryColor, Pages, _>::new([0; 5], width, height).expect("large enough");
        let (mut memory, mut queue) = ([0; words_needed(5, 5)], [Run::default(); 1]);
        let mut flood = Flood::new(&mut memory, &mut queue);
        let ends = [i32::MIN, -1, i32::MAX, 5];
        for at in ends.iter().flat_map(|&x| ends.map(|y| Point::new(x, y))) {
            assert_eq!(flood.fill(&mut frame, at, BinaryColor::On), Ok(Filled::default()));
        }
        let filled = flood.fill(&mut frame, Point::zero(), BinaryColor::On).expect("enough memory");
        assert_eq!(filled.pixels, width * height);
    }
}

#[test]
fn after_a_display_has_failed_the_same_flood_fills_again() {
    let mut sheet = sheet(&HOUSE);
    let (mut memory, mut queue) = ([0; words_needed(9, 7)], [Run::default(); 1]);
    let mut flood = Flood::new(&mut memory, &mut queue);
    sheet.patience = 1;
    let filled = flood.fill(&mut PerPixel::new(&mut sheet), Point::new(4, 2), Gray8::new(2));
    assert_eq!(filled, Err(FloodError::Display("the bus is gone")));
    assert_eq!(filled.unwrap_err().to_string(), "the bus is gone");
    sheet.patience = u32::MAX;
    let filled = flood.fill(&mut PerPixel::new(&mut sheet), Point::new(1, 4), Gray8::new(3)).expect("enough memory");
    assert_eq!(filled, Filled { pixels: 6, bounds: Rect::new(1, 4, 4, 6) });
    assert_eq!(
        text(&sheet),
        ["....#....", "...#2#...", "..#...#..", "#########", "#333#...#", "#333#...#", "#########"]
    );
}

#[test]
fn a_frame_that_is_asked_for_what_it_has_not_answers_nonsense_but_does_not_panic() {
    let rows = Frame::<BinaryColor, Rows, _>::new([0xFF; 8], 32, 2).expect("large enough");
    let pages = Frame::<BinaryColor, Pages, _>::new([0xFF; 32], 32, 2).expect("large enough");
    let ends = [i32::MIN, -33, -1, 0, 5, 31, 32, 1000, i32::MAX];
    for at in ends.iter().flat_map(|&x| ends.map(|y| Point::new(x, y))) {
        for inside in [Inside::Like(BinaryColor::On), Inside::Unlike(BinaryColor::On)] {
            let (seeds, free) = (0x0101_0101, 0x7FFF_FFFE);
            assert_eq!(rows.runs(at, inside, seeds, free) & !free, 0);
            assert_eq!(pages.runs(at, inside, seeds, free) & !free, 0);
        }
    }
    assert_eq!(rows.size(), Size::new(32, 2));
}
