//! A flood fill fills what a breadth-first search finds, with any queue; without a bitmap it may say that it cannot.
#![no_main]

#[path = "../../tests/flood/oracle.rs"]
#[allow(dead_code, reason = "the tests count what is asked")]
mod oracle;

use aquatint::{
    Connectivity, Flood, Frame, InPlace, InPlaceError, Pages, Rect, Rows,
    display::layout::Layout,
    raster::flood::{Run, words_needed},
};
use arbitrary::Arbitrary;
use embedded_graphics::{Pixel, draw_target::DrawTarget, geometry::Point, image::GetPixel, pixelcolor::BinaryColor};
use libfuzzer_sys::fuzz_target;
use oracle::Sheet;

#[derive(Arbitrary, Debug)]
struct Input {
    size: (u8, u8),
    /// Walls, a bit a pixel.
    walls: Vec<u8>,
    seed: (u8, u8),
    by_corners: bool,
    queue: u8,
    window: Option<(i32, i32, i32, i32)>,
}

impl Input {
    fn area(&self) -> Rect {
        Rect::new(0, 0, i32::from(self.size.0 % 80), i32::from(self.size.1 % 24))
    }

    fn seed(&self) -> Point {
        Point::new(i32::from(self.seed.0 % 82) - 1, i32::from(self.seed.1 % 26) - 1)
    }

    fn window(&self) -> Rect {
        self.window.map_or(self.area(), |(a, b, c, d)| Rect::new(a, b, c, d).intersection(self.area()))
    }

    fn connectivity(&self) -> Connectivity {
        if self.by_corners { Connectivity::Eight } else { Connectivity::Four }
    }

    fn sheet(&self) -> Sheet {
        let area = self.area();
        let walls = self.walls.iter().flat_map(|byte| (0..8).map(move |bit| byte >> bit & 1));
        Sheet::new(area, walls.chain(core::iter::repeat(0)).take((area.width() * area.height()) as usize).collect())
    }
}

fn places(area: Rect) -> impl Iterator<Item = Point> {
    area.rows().flat_map(move |y| area.columns().map(move |x| Point::new(x, y)))
}

type Picture<L> = Frame<BinaryColor, L, Vec<u8>>;

fn frame<L: Layout<BinaryColor>>(sheet: &Sheet) -> Picture<L>
where
    Picture<L>: DrawTarget<Color = BinaryColor, Error = core::convert::Infallible>,
{
    let area = sheet.area;
    let mut frame = Picture::<L>::new(vec![0; 80 * 24], area.width(), area.height()).expect("large enough");
    let Ok(()) = frame.draw_iter(places(area).zip(&sheet.codes).map(|(at, &wall)| Pixel(at, (wall != 0).into())));
    frame
}

fuzz_target!(|input: Input| {
    let sheet = input.sheet();
    let (seed, by, window) = (input.seed(), input.connectivity(), input.window());
    let old = sheet.code(seed);
    let expected = oracle::region(&sheet, seed, by, |code| Some(code) == old, window);
    let color = BinaryColor::from(old == Some(0));
    let is_right = |pixel: &dyn Fn(Point) -> Option<BinaryColor>| {
        places(sheet.area)
            .zip(&sheet.codes)
            .zip(&expected)
            .all(|((at, &code), &found)| pixel(at) == Some(if found { color } else { (code != 0).into() }))
    };

    let (width, height) = (window.width(), window.height());
    let mut memory = vec![0xA5A5_A5A5; words_needed(width, height)];
    let mut queue = vec![Run::default(); usize::from(input.queue % 20)];
    let mut rows = frame::<Rows>(&sheet);
    let mut flood = Flood::new(&mut memory, &mut queue).with_connectivity(by).with_window(input.window());
    let filled = flood.fill(&mut rows, seed, color).expect("enough memory");
    assert_eq!(filled.pixels as usize, expected.iter().filter(|&&found| found).count());
    assert!(is_right(&|at| rows.pixel(at)), "by rows");
    let mut pages = frame::<Pages>(&sheet);
    flood.fill(&mut pages, seed, color).expect("enough memory");
    assert!(is_right(&|at| pages.pixel(at)), "by pages");

    let mut rows = frame::<Rows>(&sheet);
    let mut in_place = InPlace::new(&mut queue).with_connectivity(by).with_window(window);
    match in_place.fill(&mut rows, seed, color) {
        Ok(_) => assert!(is_right(&|at| rows.pixel(at)), "in place"),
        Err(error) => assert_eq!(error, InPlaceError::Full),
    }
});
