//! Pictures of 400 × 240 that are hard to fill, with queues of all lengths; and what it costs.

use std::cell::Cell;

use aquatint::{
    Brush, Connectivity, Flood, Frame, Pages, Pattern, Rect, Region, Rows, Runs, Sink, SpanFn,
    raster::flood::{Run, words_needed},
};
use embedded_graphics::{geometry::Point, image::GetPixel, pixelcolor::BinaryColor, prelude::*};

use crate::{
    oracle::{Counted, Sheet, region},
    patterns::{self, HEIGHT, WIDTH},
    places,
};

const AREA: Rect = Rect::new(0, 0, 400, 240);
const SEED: Point = Point::new(1, 1);
const QUEUES: [usize; 7] = [0, 1, 2, 4, 8, 16, 64];
const WAYS: [Connectivity; 2] = [Connectivity::Four, Connectivity::Eight];

type Picture = Frame<BinaryColor, Rows, Vec<u8>>;

/// A pattern on a frame, walls on, and on a sheet for the oracle.
fn pictures(walls: &[bool]) -> (Picture, Sheet) {
    let bytes = walls.chunks(8).map(|eight| eight.iter().fold(0, |byte, &wall| (byte << 1) | u8::from(wall))).collect();
    let frame = Frame::new(bytes, 400, 240).expect("large enough");
    (frame, Sheet::new(AREA, walls.iter().map(|&wall| u8::from(wall)).collect()))
}

/// What a search finds, pixel by pixel, and how often it asks the picture. Checks the order of the spans.
fn found(
    picture: &impl Runs<Color = BinaryColor>,
    queue: usize,
    by: Connectivity,
    region: Region<BinaryColor>,
) -> (Vec<bool>, u32) {
    let (mut memory, mut queue) = (vec![0x5A5A_5A5A; words_needed(400, 240)], vec![Run::default(); queue]);
    let counted = Counted { picture, asked: Cell::new(0) };
    let mut flood = Flood::new(&mut memory, &mut queue).with_connectivity(by);
    let found = flood.search(&counted, region).expect("enough memory");
    let (mut pixels, mut behind) = (vec![false; WIDTH * HEIGHT], 0);
    let mut take = SpanFn::new(AREA, |row: i32, columns: core::ops::Range<i32>, ()| {
        let place = |column: i32| row.unsigned_abs() as usize * WIDTH + column.unsigned_abs() as usize;
        assert!(AREA.clip_run(row, columns.clone()) == Some(columns.clone()), "inside and not empty");
        assert!(place(columns.start) >= behind, "from top to bottom, from left to right");
        behind = place(columns.end);
        pixels[place(columns.start)..behind].fill(true);
    });
    let Ok(filled) = found.spans(&mut take);
    assert_eq!(filled.pixels as usize, pixels.iter().filter(|&&found| found).count());
    assert_eq!(filled.bounds, bounds(&pixels));
    (pixels, counted.asked.get())
}

/// The smallest rectangle around the pixels that are true.
fn bounds(pixels: &[bool]) -> Rect {
    places(AREA).zip(pixels).filter(|(_, found)| **found).fold(Rect::default(), |bounds, (Point { x, y }, _)| {
        let Rect { left, top, right, bottom } = if bounds.is_empty() { Rect::new(x, y, x + 1, y + 1) } else { bounds };
        Rect::new(left.min(x), top.min(y), right.max(x + 1), bottom.max(y + 1))
    })
}

#[test]
fn a_queue_of_any_length_finds_the_whole_region_and_asks_at_most_four_times_a_pixel() {
    for (name, walls) in patterns::all() {
        let (frame, sheet) = pictures(&walls);
        for by in WAYS {
            let expected = region(&sheet, SEED, by, |code| code == 0, AREA);
            let pixels = expected.iter().filter(|&&found| found).count();
            for queue in QUEUES {
                for region in [SEED.into(), Region::Boundary(SEED, BinaryColor::On)] {
                    let (got, asked) = found(&frame, queue, by, region);
                    assert!(got == expected, "{name}, {by:?}, queue of {queue}, {region:?}");
                    // Without a queue whole rows are looked at again and again.
                    let most = if queue == 0 { 16 * pixels } else { 4 * pixels };
                    assert!(asked as usize <= most, "{name}, {by:?}, queue of {queue}: {asked} for {pixels}");
                }
            }
        }
    }
}

#[test]
fn the_patterns_are_what_their_names_say() {
    for (name, pixels, by_corners) in [
        ("open", 96_000, 96_000),
        ("comb", 48_200, 48_200),
        ("comb upside down", 48_200, 48_200),
        ("dots", 72_000, 72_000),
        ("checkerboard", 1, 48_000),
        ("noise 20 %", 76_729, 76_895),
        ("maze, depth first", 47_361, 47_361),
        ("maze, Prim", 47_361, 47_361),
    ] {
        let (_, walls) = patterns::all().into_iter().find(|(other, _)| *other == name).expect("listed");
        let (_, sheet) = pictures(&walls);
        let count = |by| region(&sheet, SEED, by, |code| code == 0, AREA).iter().filter(|&&found| found).count();
        assert_eq!((count(Connectivity::Four), count(Connectivity::Eight)), (pixels, by_corners), "{name}");
    }
}

#[test]
fn a_pattern_that_looks_like_the_old_colour_is_filled_in_too() {
    let ink = Pattern::new([[BinaryColor::On, BinaryColor::Off, BinaryColor::Off, BinaryColor::Off]]);
    for (name, walls) in patterns::all() {
        let (mut frame, sheet) = pictures(&walls);
        let expected = region(&sheet, SEED, Connectivity::Four, |code| code == 0, AREA);
        let (mut memory, mut queue) = ([0; words_needed(400, 240)], [Run::default(); 16]);
        Flood::new(&mut memory, &mut queue).fill_with(&mut frame, SEED, ink).expect("enough memory");
        for ((at, found), wall) in places(AREA).zip(expected).zip(walls) {
            let is_on = if found { at.x % 4 == 0 } else { wall };
            assert_eq!(frame.pixel(at), Some(is_on.into()), "{name} at {at}");
        }
    }
}

#[test]
fn one_colour_fills_what_spans_fill() {
    let (mut memory, mut queue) = ([0; words_needed(400, 240)], [Run::default(); 16]);
    let mut flood = Flood::new(&mut memory, &mut queue);
    for (name, walls) in patterns::all() {
        let ((mut by_spans, _), (mut at_once, _)) = (pictures(&walls), pictures(&walls));
        let found = flood.search(&by_spans, SEED).expect("enough memory");
        let Ok(filled) = found.spans(&mut Brush::new(&mut by_spans, BinaryColor::On));
        assert_eq!(flood.fill(&mut at_once, SEED, BinaryColor::On), Ok(filled), "{name}");
        assert!(by_spans.bytes() == at_once.bytes(), "{name}");
    }
}

/// A U of 2061 pixels in a frame of lines: arms of 15 columns, a base of 11 rows.
fn u_shape<C: DrawTarget<Color = BinaryColor>>(target: &mut C) -> Result<(), C::Error> {
    let area = |x, y, width, height| Rect::new(x, y, x + width, y + height).into();
    target.fill_solid(&area(37, 0, 53, 63), BinaryColor::On)?;
    target.fill_solid(&area(38, 1, 51, 61), BinaryColor::Off)?;
    target.fill_solid(&area(53, 0, 21, 51), BinaryColor::On)
}

#[test]
fn neither_reads_nor_memory_depend_on_the_width_of_the_screen() {
    let mut counts = vec![];
    for width in [128, 400, 4000] {
        let mut frame = Picture::new(vec![0; 500 * 64], width, 64).expect("large enough");
        let Ok(()) = u_shape(&mut frame);
        let counted = Counted { picture: &frame, asked: Cell::new(0) };
        let (mut memory, mut queue) = (vec![0xDEAD_BEEF; words_needed(width, 64)], [Run::default(); 16]);
        let pixels = {
            let mut flood = Flood::new(&mut memory, &mut queue);
            let Ok(filled) = flood.search(&counted, Point::new(41, 5)).expect("enough memory").spans(&mut Nowhere);
            filled.pixels
        };
        // Words that were never cleared: one bit a row, and two words of 62 rows are used.
        let untouched = memory.iter().filter(|&&word| word == 0xDEAD_BEEF).count();
        counts.push((pixels, counted.asked.get(), memory.len() - untouched));
    }
    assert_eq!(counts[0].0, 2061);
    assert!(counts[0].1 <= 300 && counts[0].2 <= 2 + 2 * 64, "{counts:?}");
    assert_eq!((counts[0], counts[0]), (counts[1], counts[2]));
}

/// Takes spans and does nothing.
struct Nowhere;

impl Sink for Nowhere {
    type Error = core::convert::Infallible;

    fn bounds(&self) -> Rect {
        Rect::new(0, 0, 4000, 64)
    }

    fn span(&mut self, _row: i32, _columns: core::ops::Range<i32>, (): ()) -> Result<(), Self::Error> {
        Ok(())
    }
}

#[test]
fn pages_are_searched_like_rows() {
    for (name, walls) in patterns::all() {
        let (rows, _) = pictures(&walls);
        let mut pages = Frame::<BinaryColor, Pages, _>::new(vec![0; 12_000], 400, 240).expect("large enough");
        let Ok(()) = pages.draw_iter(places(AREA).zip(walls).map(|(at, wall)| Pixel(at, wall.into())));
        for by in WAYS {
            assert!(found(&rows, 8, by, SEED.into()) == found(&pages, 8, by, SEED.into()), "{name}");
        }
    }
}
