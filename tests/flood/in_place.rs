//! Filling with a queue alone: right when it says so, and honest when it cannot.

use aquatint::{
    Connectivity, Frame, InPlace, InPlaceError, Rect, Region, Rows,
    raster::flood::{Filled, Run},
};
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    image::GetPixel,
    pixelcolor::{BinaryColor, Gray8},
    primitives::Rectangle,
};
use proptest::prelude::*;

use crate::{layouts, oracle::region, patterns, places, sheet, text};

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn what_is_filled_belongs_to_the_region_and_all_of_it_is_filled_unless_the_queue_was_full(
        case in layouts::cases(), queue in prop_oneof![0..6_usize, Just(5000)],
    ) {
        let (color, mut sheet) = (case.ink[0], case.sheet.clone());
        let old = sheet.code(case.seed).filter(|_| case.seen().contains(case.seed));
        let inside = |code| code != color && case.border.map_or(Some(code) == old, |border| code != border);
        let expected = region(&sheet, case.seed, case.by, inside, case.seen());
        let region = case.border.map_or(case.seed.into(), |border| Region::Boundary(case.seed, Gray8::new(border)));

        let mut queue = vec![Run::default(); queue];
        let mut fill = InPlace::new(&mut queue).with_connectivity(case.by).with_window(case.seen());
        let filled = fill.fill(&mut sheet, region, Gray8::new(color));

        let all = expected.iter().filter(|&&found| found).count();
        let is_there = old.is_some_and(|old| Some(old) != case.border);
        let painted = sheet.codes.iter().zip(&case.sheet.codes).filter(|(new, old)| new != old).count();
        match filled {
            Ok(Filled { pixels, .. }) => prop_assert_eq!((pixels as usize, painted), (all, all)),
            Err(InPlaceError::SameColor) => prop_assert!(is_there && old == Some(color) && painted == 0),
            Err(InPlaceError::Full) => prop_assert!(all > 0 && queue.len() < 6 && (painted == 0) == queue.is_empty()),
            Err(other) => prop_assert!(false, "{}", other),
        }
        for ((new, old), expected) in sheet.codes.iter().zip(&case.sheet.codes).zip(expected) {
            prop_assert!(new == old || expected && *new == color);
        }
    }
}

#[test]
fn the_lengths_that_the_documentation_names_are_those_that_it_takes() {
    let area = Rect::new(0, 0, 400, 240);
    let shortest = |name: &str| {
        let (_, walls) = patterns::all().into_iter().find(|(other, _)| *other == name).expect("listed");
        (0..1000).find(|&length| {
            let mut frame = Frame::<BinaryColor, Rows, _>::new(vec![0; 12_000], 400, 240).expect("large enough");
            let Ok(()) = frame.draw_iter(places(area).zip(&walls).map(|(at, &wall)| Pixel(at, wall.into())));
            let mut queue = vec![Run::default(); length];
            InPlace::new(&mut queue).fill(&mut frame, Point::new(1, 1), BinaryColor::On).is_ok()
        })
    };
    let names = ["open", "spiral", "maze, depth first", "noise 20 %", "maze, Prim", "comb", "dots"];
    assert_eq!(names.map(|name| shortest(name).expect("enough")), [2, 1, 21, 126, 185, 200, 400]);
}

#[test]
fn a_queue_that_is_too_short_says_so_and_leaves_a_part_filled() {
    let rows = ["#.#.#.#.#", "#.#.#.#.#", ".........", "#.#.#.#.#"];
    let mut comb = sheet(&rows);
    let filled = InPlace::new(&mut [Run::default(); 3]).fill(&mut comb, Point::new(4, 2), Gray8::new(2));
    assert_eq!(filled, Err(InPlaceError::Full));
    assert_eq!(filled.unwrap_err().to_string(), "the queue is full; a part was filled");
    assert_eq!(text(&comb), ["#.#.#.#.#", "#2#2#2#2#", "222222222", "#.#.#.#.#"]);

    let filled = InPlace::new(&mut []).fill(&mut comb, Point::zero(), Gray8::new(3));
    assert_eq!(filled, Err(InPlaceError::Full));
    assert_eq!(text(&comb)[0], rows[0], "with no queue nothing is drawn");

    let mut comb = sheet(&rows);
    let filled = InPlace::new(&mut [Run::default(); 9]).fill(&mut comb, Point::new(4, 2), Gray8::new(2));
    assert_eq!(filled, Ok(Filled { pixels: 21, bounds: Rect::new(0, 0, 9, 4) }));
}

#[test]
fn the_old_colour_is_refused() {
    let mut blank = sheet(&["...", "..."]);
    let mut queue = [Run::default(); 2];
    let same = InPlace::new(&mut queue).fill(&mut blank, Point::zero(), Gray8::new(0));
    assert_eq!(same, Err(InPlaceError::SameColor));
    assert_eq!(same.unwrap_err().to_string(), "the seed already has the colour");
    let outside = InPlace::new(&mut queue).fill(&mut blank, Point::new(3, 0), Gray8::new(0));
    assert_eq!(outside, Ok(Filled::default()));
}

/// Takes everything and shows nothing.
struct Liar(Rect);

impl Dimensions for Liar {
    fn bounding_box(&self) -> Rectangle {
        self.0.into()
    }
}

impl GetPixel for Liar {
    type Color = Gray8;

    fn pixel(&self, _at: Point) -> Option<Gray8> {
        Some(Gray8::new(0))
    }
}

impl DrawTarget for Liar {
    type Color = Gray8;
    type Error = &'static str;

    fn draw_iter<I: IntoIterator<Item = Pixel<Gray8>>>(&mut self, _pixels: I) -> Result<(), &'static str> {
        Ok(())
    }
}

#[test]
fn a_target_that_shows_nothing_ends_the_fill() {
    let mut queue = [Run::default(); 8];
    for area in [Rect::new(0, 0, 30, 20), Rect::new(i32::MAX - 9, i32::MIN, i32::MAX, i32::MIN + 4)] {
        let seed = Point::new(area.left + 3, area.top + 2);
        for by in [Connectivity::Four, Connectivity::Eight] {
            let mut fill = InPlace::new(&mut queue).with_connectivity(by);
            let filled = fill.fill(&mut Liar(area), seed, Gray8::new(1));
            assert!(matches!(filled, Err(InPlaceError::NotShown | InPlaceError::Full)), "{filled:?}");
        }
    }
    let endless = Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX);
    let filled = InPlace::new(&mut queue).fill(&mut Liar(endless), Point::zero(), Gray8::new(1));
    assert_eq!(filled, Err(InPlaceError::TooLarge));
    assert_eq!(filled.unwrap_err().to_string(), "more than 65535 columns or rows");
}

#[test]
fn what_the_display_says_is_passed_on() {
    let mut blank = sheet(&["...", "..."]);
    blank.patience = 1;
    let filled = InPlace::new(&mut [Run::default(); 2]).fill(&mut blank, Point::zero(), Gray8::new(1));
    assert_eq!(filled, Err(InPlaceError::Display("the bus is gone")));
    assert_eq!(text(&blank), ["###", "..."]);
}
