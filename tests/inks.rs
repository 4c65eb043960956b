//! Inks: patterns, stencils, pictures and gradients, against what they are at each pixel.

use std::{convert::Infallible, ops::Range};

use aquatint::{
    Brush, Dithered, Extend, Frame, Ink, Levels, Light, LinearGradient, Pages, Pattern, PictureInk, Point2,
    RadialGradient, Rect, Rows, Sink, Stencil, Target, Window,
    fragment::{gradient::between, pattern::hatch},
};
use embedded_graphics::{
    geometry::{Dimensions, Point},
    image::{GetPixel, ImageRaw},
    pixelcolor::{BinaryColor, Gray4, Gray8, GrayColor},
    primitives::PointsIter,
};
use proptest::{collection::vec, prelude::*, sample::select};

/// A target that remembers what each pixel was given, and how often.
struct Sheet<C> {
    bounds: Rect,
    pixels: Vec<Vec<C>>,
}

impl<C: Copy> Sheet<C> {
    fn new(bounds: Rect) -> Self {
        Self { bounds, pixels: vec![vec![]; (bounds.width() * bounds.height()) as usize] }
    }

    /// What a pixel was given, if once.
    fn at(&self, x: i32, y: i32) -> Option<C> {
        let index = (y - self.bounds.top).unsigned_abs() * self.bounds.width() + (x - self.bounds.left).unsigned_abs();
        let given = &self.pixels[index as usize];
        assert!(given.len() < 2, "{x}, {y} was filled twice");
        given.first().copied()
    }

    fn put(&mut self, row: i32, column: i32, color: C) {
        let x = (column - self.bounds.left).unsigned_abs();
        let index = (row - self.bounds.top).unsigned_abs() * self.bounds.width() + x;
        self.pixels[index as usize].push(color);
    }
}

impl<C: Copy> Target for Sheet<C> {
    type Color = C;
    type Error = Infallible;

    fn bounds(&self) -> Rect {
        self.bounds
    }

    fn fill_run<const N: usize>(&mut self, row: i32, columns: Range<i32>, colors: [C; N]) -> Result<(), Infallible> {
        for column in self.bounds.clip_run(row, columns).filter(|_| N > 0).unwrap_or_default() {
            self.put(row, column, colors[column.rem_euclid(i32::try_from(N).expect("few")).unsigned_abs() as usize]);
        }
        Ok(())
    }

    fn write_run(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: impl Iterator<Item = Option<C>>,
    ) -> Result<(), Infallible> {
        let bounds = self.bounds;
        let seen = columns.start..columns.end.min(bounds.right);
        for (column, color) in seen.zip(colors).filter(|(column, _)| bounds.contains(Point::new(*column, row))) {
            if let Some(color) = color {
                self.put(row, column, color);
            }
        }
        Ok(())
    }
}

const BOUNDS: Rect = Rect::new(-5, -3, 20, 9);

/// All of a sheet, filled row by row with runs that reach beyond it.
fn filled<I: Ink>(ink: &I) -> Sheet<I::Color> {
    let mut sheet = Sheet::new(BOUNDS);
    for row in -6..12 {
        let Ok(()) = ink.fill(&mut sheet, row, -9..3);
        let Ok(()) = ink.fill(&mut sheet, row, 3..i32::MAX);
    }
    sheet
}

fn places() -> impl Iterator<Item = (i32, i32)> {
    BOUNDS.rows().flat_map(|y| BOUNDS.columns().map(move |x| (x, y)))
}

fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![4 => -40..60_i32, 1 => select(vec![i32::MIN, i32::MIN + 1, i32::MAX - 1, i32::MAX, 1 << 26, -(1 << 26)])]
}

fn anchor() -> impl Strategy<Value = Point> {
    (-40..60_i32, -40..60_i32).prop_map(|(x, y)| Point::new(x, y))
}

/// Of a number of things in a circle, the one at a place.
fn around(place: i32, anchor: i32, number: i32) -> usize {
    usize::try_from((i64::from(place) - i64::from(anchor)).rem_euclid(i64::from(number))).expect("small")
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn a_pattern_repeats_from_its_anchor(rows in any::<[[u8; 8]; 3]>(), odd in any::<[[u8; 5]; 4]>(), anchor in anchor()) {
        let (even, odd_sheet) = (filled(&Pattern::new(rows).anchored(anchor)), filled(&Pattern::new(odd).anchored(anchor)));
        for (x, y) in places() {
            prop_assert_eq!(even.at(x, y), Some(rows[around(y, anchor.y, 3)][around(x, anchor.x, 8)]));
            prop_assert_eq!(odd_sheet.at(x, y), Some(odd[around(y, anchor.y, 4)][around(x, anchor.x, 5)]));
        }
    }

    #[test]
    fn a_stencil_leaves_what_is_under_its_gaps(bits in any::<[u8; 6]>(), anchor in anchor()) {
        let sheet = filled(&Stencil::new(bits, 7).anchored(anchor));
        for (x, y) in places() {
            let is_set = bits[around(y, anchor.y, 6)] >> (7 - around(x, anchor.x, 8)) & 1 == 1;
            prop_assert_eq!(sheet.at(x, y), is_set.then_some(7));
        }
    }

    #[test]
    fn a_picture_is_cut_out_or_tiled(bytes in vec(any::<u8>(), 24..25), x0 in coordinate(), y0 in coordinate()) {
        // 6 × 4 pixels.
        let image = ImageRaw::<Gray8>::new(&bytes, 6);
        let anchor = Point::new(x0, y0);
        let (once, tiled) = (filled(&PictureInk::once(&image).anchored(anchor)), filled(&PictureInk::tiled(&image).anchored(anchor)));
        for (x, y) in places() {
            let there = image.pixel(Point::new(x.wrapping_sub(x0), y.wrapping_sub(y0)));
            prop_assert_eq!(once.at(x, y), there);
            // Beyond the ends of i32 the copies may begin anew.
            if x0.unsigned_abs() < 100 && y0.unsigned_abs() < 100 {
                let place = Point::new(around(x, x0, 6).try_into().expect("small"), around(y, y0, 4).try_into().expect("small"));
                prop_assert_eq!(tiled.at(x, y), image.pixel(place));
            } else {
                prop_assert!(tiled.at(x, y).is_some());
            }
        }
    }

    #[test]
    fn linear_gradients_are_exact_to_a_step(
        ax in coordinate(), ay in coordinate(), bx in coordinate(), by in coordinate(),
        extend in select(vec![Extend::Pad, Extend::Repeat, Extend::Reflect]),
    ) {
        let gradient = LinearGradient::new(Point2::from_sixteenths(ax, ay), Point2::from_sixteenths(bx, by), |number| number);
        let sheet = filled(&gradient.with_extend(extend));
        let end = (1 << 26) - 1;
        let [ax, ay, bx, by] = [ax, ay, bx, by].map(|v| i128::from(v.clamp(-end, end)));
        let square = (bx - ax).pow(2) + (by - ay).pow(2);
        for (x, y) in places() {
            let (x, y) = (i128::from(x), i128::from(y));
            let along = (16 * x + 8 - ax) * (bx - ax) + (16 * y + 8 - ay) * (by - ay);
            // In steps, of which there are 65,536.
            let place = if square == 0 { 0 } else { (along << 16).div_euclid(square) };
            let got = i128::from(sheet.at(x.try_into().expect("small"), y.try_into().expect("small")).expect("filled"));
            // Far from its beginning the steps of a gradient add up: 2⁻³³ of the way for each sixteenth.
            let slack = 1 + ((16 * x - ax).abs() + (16 * y - ay).abs()) / (1 << 17);
            let matches = |place: i128| {
                let expected = match extend {
                    Extend::Pad => place.clamp(0, 65_535),
                    Extend::Reflect if place.div_euclid(65_536) % 2 != 0 => 65_535 - place.rem_euclid(65_536),
                    _ => place.rem_euclid(65_536),
                };
                expected == got
            };
            prop_assert!((-slack..=slack).any(|off| matches(place + off)), "{got} at {x}, {y}: {place}");
        }
    }

    #[test]
    fn radial_gradients_follow_the_distance(cx in coordinate(), cy in coordinate(), radius in prop_oneof![0..500_u32, any::<u32>()]) {
        let sheet = filled(&RadialGradient::new(Point2::from_sixteenths(cx, cy), radius, |number| number));
        let end = (1 << 26) - 1;
        for (x, y) in places() {
            let [cx, cy] = [cx, cy].map(|v| u64::try_from(i64::from(v.clamp(-end, end)) + (1 << 40)).expect("positive"));
            let [dx, dy] = [(x, cx), (y, cy)].map(|(v, c)| u64::try_from(16 * i64::from(v) + 8 + (1 << 40)).expect("positive").abs_diff(c));
            let distance = (dx * dx + dy * dy).isqrt();
            let expected = if radius == 0 { u64::from(distance > 0) << 16 } else { (distance << 16) / u64::from(radius) };
            let got = u64::from(sheet.at(x, y).expect("filled"));
            // Far from the centre the steps add up: 2⁻³³ of the way for each sixteenth.
            let slack = 1 + distance / (1 << 17);
            prop_assert!(got.abs_diff(expected.min(65_535)) <= slack, "{got}, not {expected} at {x}, {y}");
        }
    }
}

/// Runs of a number of colours that repeat, on a frame, dithered and not, and on a window of it.
fn runs_of<const N: usize>() {
    let colors: [Gray4; N] = std::array::from_fn(|index| Gray4::new(u8::try_from(index * 7 % 16).expect("small")));
    let mut frame = Frame::<Gray4, Rows, _>::with_array([0; 64], 32, 4).expect("enough");
    let Ok(()) = frame.fill_run(0, 3..29, colors);
    let Ok(()) = Window::part(&mut frame, Rect::new(5, 1, 32, 2)).fill_run(0, i32::MIN..i32::MAX, colors);
    let lights = colors.map(|color| Light(u16::from(color.luma()) * 4369));
    let Ok(()) = Dithered::new(&mut frame, Levels::LINEAR_16).fill_run(2, 3..29, lights);
    for x in 0..32_u8 {
        let expected =
            |column: i32| colors.get(column.rem_euclid(i32::try_from(N).expect("few").max(1)).unsigned_abs() as usize);
        let at = |y| frame.pixel(Point::new(x.into(), y)).expect("inside");
        let inside = Some(()).filter(|()| (3..29).contains(&x)).and_then(|()| expected(x.into()));
        assert_eq!(at(0), *inside.unwrap_or(&Gray4::BLACK), "{N} colours at {x}");
        let in_window = Some(()).filter(|()| x >= 5).and_then(|()| expected(i32::from(x) - 5));
        assert_eq!(at(1), *in_window.unwrap_or(&Gray4::BLACK), "{N} colours at {x} in a window");
        // These lights are levels of the panel, which no dither changes.
        assert_eq!(at(2), *inside.unwrap_or(&Gray4::BLACK), "{N} lights at {x}");
    }
}

#[test]
fn runs_repeat_any_number_of_colours() {
    runs_of::<0>();
    runs_of::<1>();
    runs_of::<2>();
    runs_of::<3>();
    runs_of::<4>();
    runs_of::<5>();
    runs_of::<6>();
    runs_of::<8>();
    runs_of::<12>();
    runs_of::<16>();
    runs_of::<33>();
}

#[test]
fn a_ramp_reaches_both_ends_and_rises() {
    for (from, to) in [(0, 65_535), (65_535, 0), (1000, 1001), (7, 7)] {
        let ramp = between(Light(from), Light(to));
        assert_eq!((ramp(0), ramp(65_535)), (Light(from), Light(to)));
        let lights: Vec<_> =
            (0..=u16::MAX).map(|number| if from < to { ramp(number).0 } else { 65_535 - ramp(number).0 }).collect();
        assert!(lights.is_sorted());
    }
}

#[test]
fn nothing_is_drawn_with_an_empty_tile_or_picture() {
    let mut sheet = Sheet::new(BOUNDS);
    let empty = ImageRaw::<Gray8>::new(&[], 0);
    for row in 0..5 {
        let Ok(()) = Pattern::<Gray8, 0, 2>::new([[], []]).fill(&mut sheet, row, 0..9);
        let Ok(()) = Pattern::<Gray8, 2, 0>::new([]).fill(&mut sheet, row, 0..9);
        let Ok(()) = PictureInk::tiled(&empty).fill(&mut sheet, row, 0..9);
        let Ok(()) = PictureInk::once(&empty).fill(&mut sheet, row, i32::MIN..i32::MAX);
    }
    assert!(places().all(|(x, y)| sheet.at(x, y).is_none()));
}

/// All rows of 32 × 16 pixels, as text.
fn picture(draw: impl FnOnce(&mut Frame<BinaryColor, Rows, [u8; 64]>)) -> String {
    let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 64], 32, 16).expect("enough");
    draw(&mut frame);
    let sign = |at| if frame.pixel(at) == Some(BinaryColor::On) { '#' } else { '.' };
    let row = |y| (0..32).map(|x| sign(Point::new(x, y))).chain(['\n']).collect::<String>();
    (0..16).map(row).collect()
}

fn light(ink: impl Ink<Color = Light>) -> String {
    picture(|frame| {
        let mut brush = Dithered::new(frame, Levels::ONE_BIT);
        let mut brush = Brush::new(&mut brush, ink);
        for row in 0..16 {
            let Ok(()) = brush.span(row, 0..32, ());
        }
    })
}

#[test]
fn a_linear_gradient_in_light() {
    let ramp = between(Light::BLACK, Light::WHITE);
    let text = light(LinearGradient::new(Point2::corner(0, 0), Point2::corner(32, 16), ramp));
    assert_eq!(text, include_str!("pictures/linear_gradient.txt"), "\n{text}");
}

#[test]
fn a_lamp() {
    let ramp = between(Light::WHITE, Light::BLACK);
    let text = light(RadialGradient::new(Point2::corner(16, 8), 15 * 16, ramp));
    assert_eq!(text, include_str!("pictures/radial_gradient.txt"), "\n{text}");
}

#[test]
fn hatches() {
    let tiles: [&[u8]; 8] = [
        &hatch::DIAGONAL,
        &hatch::BACK_DIAGONAL,
        &hatch::DIAGONAL_CROSS,
        &hatch::HORIZONTAL,
        &hatch::VERTICAL,
        &hatch::CROSS,
        &hatch::BRICKS,
        &hatch::DOTS,
    ];
    let text = picture(|frame| {
        for (tile, place) in tiles.iter().zip((0..2).flat_map(|y| (0..4).map(move |x| (x * 8, y * 8)))) {
            for row in 0..8_u8 {
                let byte = [tile[usize::from(row) % tile.len()]];
                let Ok(()) = Pattern::from_bits(byte, BinaryColor::On, BinaryColor::Off).fill(
                    frame,
                    place.1 + i32::from(row),
                    place.0..place.0 + 7,
                );
            }
        }
    });
    assert_eq!(text, include_str!("pictures/hatches.txt"), "\n{text}");
}

#[test]
fn a_pattern_is_the_same_in_rows_and_pages() {
    let tile = Pattern::from_bits(hatch::BRICKS, BinaryColor::On, BinaryColor::Off).anchored(Point::new(3, 2));
    let mut rows = Frame::<BinaryColor, Rows, _>::with_array([0; 64], 32, 16).expect("enough");
    let mut pages = Frame::<BinaryColor, Pages, _>::with_array([0; 64], 32, 16).expect("enough");
    for row in 0..16 {
        let Ok(()) = tile.fill(&mut rows, row, 1..30);
        let Ok(()) = tile.fill(&mut pages, row, 1..30);
    }
    assert!(rows.bounding_box().points().all(|at| rows.pixel(at) == pages.pixel(at)));
}

/// A walk over all of its columns would take minutes, and the number of its last one has no successor.
#[test]
fn a_stencil_of_the_longest_run_is_what_is_seen_of_it() {
    for anchor in [0, 3, i32::MIN, i32::MAX] {
        let stencil = Stencil::new([0b0110_0101], BinaryColor::On).anchored(Point::new(anchor, 0));
        let mut frames = [0; 2].map(|byte| Frame::<BinaryColor, Rows, _>::with_array([byte; 3], 24, 1).expect("room"));
        let Ok(()) = stencil.fill(&mut frames[0], 0, i32::MIN..i32::MAX);
        let Ok(()) = stencil.fill(&mut frames[1], 0, 0..24);
        assert_eq!(frames[0].bytes(), frames[1].bytes());
        assert_ne!(frames[0].bytes(), [0; 3]);
    }
}
