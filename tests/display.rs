//! Frames: bytes written by hand, a slow reference, and drawings of embedded-graphics.

#[macro_use]
mod reference;

use core::{convert::Infallible, fmt::Debug, iter};

use aquatint::{
    Code, Columns, Frame, Inverted, LsbFirst, MsbFirst, OnDrawTarget, Pages, Planes, Rows, Spacing, Target, TooSmall,
    Words, display::layout::Layout,
};
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Point, Size},
    image::GetPixel,
    mock_display::MockDisplay,
    pixelcolor::{
        BinaryColor, Gray2, Gray4, Gray8, Rgb565,
        raw::{RawData, RawU16},
    },
    primitives::Rectangle,
};
use proptest::{collection::vec, prelude::*};
use reference::{
    GUARD, Packing, Reference, conform,
    drawings::{draw_in_windows, draw_shapes},
    places, size_i32, size_u32,
    steps::{Step, run_step, step},
};

// Bytes by hand.

const SPIRAL: [&str; 9] = [
    "###########",
    "#..........",
    "#.#####....",
    "#.#...#...#",
    "#.#.#.#..#.",
    "#.#...#.#..",
    "#.#####....",
    "#..........",
    "##.......##",
];

#[test]
fn one_bit_in_rows() {
    let bytes = [
        [0b1111_1111, 0b1110_0000],
        [0b1000_0000, 0b0000_0000],
        [0b1011_1110, 0b0000_0000],
        [0b1010_0010, 0b0010_0000],
        [0b1010_1010, 0b0100_0000],
        [0b1010_0010, 0b1000_0000],
        [0b1011_1110, 0b0000_0000],
        [0b1000_0000, 0b0000_0000],
        [0b1100_0000, 0b0110_0000],
    ];
    pack::<BinaryColor, Rows>(&SPIRAL, bytes.as_flattened());
}

#[test]
#[rustfmt::skip]
fn one_bit_in_pages() {
    let bytes = [
        0b1111_1111, 0b0000_0001, 0b0111_1101, 0b0100_0101, 0b0101_0101, 0b0100_0101,
        0b0111_1101, 0b0000_0001, 0b0010_0001, 0b0001_0001, 0b0000_1001,
        1, 1, 0, 0, 0, 0, 0, 0, 0, 1, 1,
    ];
    pack::<BinaryColor, Pages>(&SPIRAL, &bytes);
}

#[test]
fn two_bits_in_rows() {
    pack::<Gray2, Rows>(&["01233", "30210"], &[0b00_01_10_11, 0b11_00_00_00, 0b11_00_10_01, 0b00_00_00_00]);
}

#[test]
fn four_bits_in_rows() {
    pack::<Gray4, Rows>(&["01abf", "f0e37"], &[0x01, 0xab, 0xf0, 0xf0, 0xe3, 0x70]);
}

#[test]
fn eight_bits_in_rows() {
    pack::<Gray8, Rows>(&["07f", "6e1"], &[0x00, 0x77, 0xff, 0x66, 0xee, 0x11]);
}

/// Draws a picture in every way there is; each must give these bytes, and the picture back.
fn pack<C: Code + Debug, L: Layout<C>>(picture: &[&str], expected: &[u8]) {
    let size = Size::new(size_u32(picture[0].len()), size_u32(picture.len()));
    let colors: Vec<C> = picture.concat().chars().map(color).collect();
    for way in 0..5 {
        let mut memory = vec![0; expected.len()];
        let mut frame = Frame::<C, L, _>::new(&mut memory[..], size.width, size.height).expect("enough");
        draw_in_way(way, &mut frame, &colors);
        assert_eq!(frame.bytes(), expected, "way {way}");
        let read = places(frame.bounds()).map(|(x, y)| frame.pixel(Point::new(x, y)).expect("inside"));
        assert_eq!(read.collect::<Vec<C>>(), colors, "way {way}");
    }
}

fn draw_in_way<C: Code, L: Layout<C>>(way: u8, frame: &mut Frame<C, L, &mut [u8]>, colors: &[C]) {
    let bounds = frame.bounds();
    let pixels = places(bounds).zip(colors).map(|((x, y), &color)| Pixel(Point::new(x, y), color));
    match way {
        0 => fill_runs(frame, colors),
        1 => fill_runs(&mut OnDrawTarget::new(frame), colors),
        2 => write_runs(frame, colors),
        3 => frame.draw_iter(pixels).unwrap_or_else(|never| match never {}),
        _ => frame.fill_contiguous(&bounds.into(), colors.iter().copied()).unwrap_or_else(|never| match never {}),
    }
}

fn fill_runs<T: Target<Color: PartialEq, Error = Infallible>>(target: &mut T, colors: &[T::Color]) {
    let bounds = target.bounds();
    for (row, line) in bounds.rows().zip(colors.chunks(bounds.width() as usize)) {
        let mut columns = bounds.columns();
        for run in line.chunk_by(PartialEq::eq) {
            let end = columns.start + size_i32(run.len());
            let Ok(()) = target.fill_run(row, columns.start..end, [run[0]]);
            columns.start = end;
        }
    }
}

fn write_runs<T: Target<Error = Infallible>>(target: &mut T, colors: &[T::Color]) {
    let bounds = target.bounds();
    for (row, line) in bounds.rows().zip(colors.chunks(bounds.width() as usize)) {
        let Ok(()) = target.write_run(row, bounds.columns(), line.iter().copied().map(Some));
    }
}

/// '.' and '#', or a hexadecimal digit, which stands for its seventeenfold in eight bits.
fn color<C: Code>(sign: char) -> C {
    let digit = match sign {
        '.' => 0,
        '#' => 1,
        digit => u8::try_from(digit.to_digit(16).expect("a digit")).expect("small"),
    };
    C::from_code(if C::BITS == 8 { digit * 17 } else { digit })
}

// Sizes.

#[test]
fn a_frame_needs_what_the_panel_takes() {
    assert_eq!(Frame::<BinaryColor, Pages, ()>::bytes_needed(128, 64), 1024);
    assert_eq!(Frame::<BinaryColor, Pages, ()>::bytes_needed(84, 48), 504);
    assert_eq!(Frame::<BinaryColor, Pages, ()>::bytes_needed(128, 65), 1152);
    assert_eq!(Frame::<BinaryColor, Rows, ()>::bytes_needed(400, 240), 12_000);
    assert_eq!(Frame::<BinaryColor, Rows, ()>::bytes_needed(122, 250), 4000);
    assert_eq!(Frame::<Gray2, Rows, ()>::bytes_needed(5, 3), 6);
    assert_eq!(Frame::<Gray4, Rows, ()>::bytes_needed(256, 64), 8192);
    assert_eq!(Frame::<Gray4, Rows, ()>::bytes_needed(127, 2), 128);
    assert_eq!(Frame::<Gray8, Rows, ()>::bytes_needed(96, 64), 6144);
}

#[test]
fn the_largest_sizes_do_not_wrap_around() {
    const MOST: u32 = u32::MAX;
    assert_eq!(Frame::<BinaryColor, Rows, ()>::bytes_needed(MOST, MOST), (1 << 29) * MOST as usize);
    assert_eq!(Frame::<BinaryColor, Pages, ()>::bytes_needed(MOST, MOST), (1 << 29) * MOST as usize);
    assert_eq!(Frame::<Gray4, Rows, ()>::bytes_needed(MOST, 2), 1 << 32);
    assert_eq!(Frame::<Gray8, Rows, ()>::bytes_needed(MOST, MOST), MOST as usize * MOST as usize);
}

#[test]
fn too_small_says_how_many_bytes_are_needed() {
    assert_eq!(Frame::<BinaryColor, Pages, _>::with_array([0; 1023], 128, 64).unwrap_err(), TooSmall { needed: 1024 });
    assert_eq!(Frame::<Gray4, Rows, _>::new(&mut [0; 5][..], 3, 3).unwrap_err(), TooSmall { needed: 6 });
    assert!(Frame::<Gray4, Rows, _>::new(&mut [0; 6][..], 3, 3).is_ok());
    assert!(Frame::<BinaryColor, Rows, _>::new(vec![0; 9], u32::MAX, u32::MAX).is_err());
}

#[test]
fn a_frame_without_pixels_takes_no_bytes_and_everything_drawn() {
    for (width, height) in [(0, 0), (0, 9), (9, 0), (0, u32::MAX), (u32::MAX, 0)] {
        on_every_layout!(draw_on_nothing(width, height));
    }
}

fn draw_on_nothing<C: Code + Debug + From<Gray8>, L: Layout<C>>(_: Packing, width: u32, height: u32) {
    let mut memory = [GUARD; 3];
    let mut frame = Frame::<C, L, _>::new(&mut memory[..], width, height).expect("nothing is needed");
    let Ok(()) = frame.clear(C::from_code(0));
    let Ok(()) = frame.fill_run(0, i32::MIN..i32::MAX, [C::from_code(0)]);
    let Ok(()) = frame.write_run(0, 0..9, iter::repeat(Some(C::from_code(0))));
    let Ok(()) = draw_shapes(&mut frame, Point::zero());
    assert_eq!((frame.pixel(Point::zero()), frame.bytes()), (None, &[][..]));
    assert_eq!(memory, [GUARD; 3]);
}

#[test]
fn a_frame_may_be_a_constant() {
    const ARROW: Result<Frame<BinaryColor, Rows, [u8; 2]>, TooSmall> =
        Frame::with_array([0b0100_0000, 0b1110_0000], 3, 2);
    const REFUSED: Result<Frame<BinaryColor, Rows, [u8; 1]>, TooSmall> = Frame::with_array([0], 3, 2);
    static SHARED: Frame<BinaryColor, Rows, [u8; 2]> = match ARROW {
        Ok(frame) => frame,
        Err(_) => panic!(),
    };
    let row = |y| [0, 1, 2].map(|x| SHARED.pixel(Point::new(x, y)).expect("inside").is_on());
    assert_eq!([row(0), row(1)], [[false, true, false], [true; 3]]);
    assert_eq!(REFUSED.unwrap_err(), TooSmall { needed: 2 });
}

#[test]
fn no_pixel_is_read_outside() {
    on_every_layout!(read_outside());
}

fn read_outside<C: Code + Debug, L: Layout<C>>(_: Packing) {
    let frame = Frame::<C, L, _>::with_array([GUARD; 200], 9, 9).expect("enough");
    for (x, y) in [(9, 0), (0, 9), (-1, 0), (0, -1), (i32::MAX, 0), (0, i32::MAX), (i32::MIN, i32::MIN)] {
        assert_eq!(frame.pixel(Point::new(x, y)), None, "{x}, {y}");
    }
}

// Conformance: whatever is drawn, a frame holds what a display that can only draw pixels shows.

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn a_frame_shows_what_its_pixels_were_given(width in 1..40_u32, height in 1..20_u32, steps in vec(step(), 1..8)) {
        on_every_layout!(draw_steps(width, height, &steps));
    }

    #[test]
    fn pixels_of_two_bytes_too(width in 1..20_u32, height in 1..20_u32, steps in vec(step(), 1..8)) {
        draw_words::<Words>(width, height, &steps, u16::to_be_bytes);
        draw_words::<Words<LsbFirst>>(width, height, &steps, u16::to_le_bytes);
    }

    #[test]
    fn runs_on_a_borrowed_display_are_those_of_a_frame(width in 1..40_u32, height in 1..20_u32, step in run_step()) {
        on_every_layout!(draw_run(width, height, &step));
    }

    #[test]
    fn a_borrowed_display_is_asked_for_no_pixel_twice_and_for_none_outside(step in run_step()) {
        // This one panics where it is.
        step.draw_run(&mut OnDrawTarget::new(&mut MockDisplay::<Gray4>::new()));
    }

    #[test]
    fn drawings_of_embedded_graphics_are_the_same(width in 1..90_u32, height in 1..40_u32, x in -20..60, y in -20..30) {
        on_every_layout!(draw_everything(width, height, Point::new(x, y)));
    }
}

fn draw_steps<C: Code + Debug, L: Layout<C>>(packing: Packing, width: u32, height: u32, steps: &[Step]) {
    let mut expected = Reference::<C>::new(width, height);
    for step in steps {
        step.draw_slowly(&mut expected);
    }
    conform::<C, L>(packing, &expected, |frame| steps.iter().for_each(|step| step.draw(frame)));
}

/// On lines with a byte between them.
fn draw_words<L: Layout<Rgb565>>(width: u32, height: u32, steps: &[Step], order: fn(u16) -> [u8; 2]) {
    let color = |code: u8| Rgb565::from(RawU16::new(u16::from_be_bytes([code, !code])));
    let (stride, mut expected) = (2 * width as usize + 1, Reference::new(width, height));
    let mut frame = Frame::<Rgb565, L, _>::with_spacing(
        vec![GUARD; stride * height as usize],
        Size::new(width, height),
        Spacing { before: 0, stride },
    )
    .expect("large enough");
    for step in steps {
        step.draw_in(&mut frame, color);
        step.draw_slowly_in(&mut expected, color);
    }
    for (y, row) in expected.pixels().chunks(width as usize).enumerate() {
        let bytes = |pixel: &Option<Rgb565>| pixel.map_or([GUARD; 2], |color| order(RawU16::from(color).into_inner()));
        let line: Vec<u8> = row.iter().flat_map(bytes).chain([GUARD]).collect();
        assert_eq!(frame.bytes()[y * stride..][..stride], line, "row {y}");
        for (x, color) in row.iter().enumerate().filter_map(|(x, &color)| Some((x, color?))) {
            assert_eq!(frame.pixel(Point::new(size_i32(x), size_i32(y))), Some(color));
        }
    }
}

fn draw_run<C: Code + Debug, L: Layout<C>>(packing: Packing, width: u32, height: u32, step: &Step) {
    let mut expected = Reference::<C>::new(width, height);
    step.draw_run(&mut OnDrawTarget::new(&mut expected));
    conform::<C, L>(packing, &expected, |frame| step.draw_run(frame));
    conform::<C, L>(packing, &expected, |frame| step.draw_run(&mut OnDrawTarget::new(frame)));
}

fn draw_everything<C: Code + Debug + From<Gray8>, L: Layout<C>>(packing: Packing, width: u32, height: u32, at: Point) {
    let mut expected = Reference::<C>::new(width, height);
    let Ok(()) = draw_shapes(&mut expected, at);
    let Ok(()) = draw_in_windows(&mut expected, at);
    conform::<C, L>(packing, &expected, |frame| {
        let Ok(()) = draw_shapes(frame, at);
        let Ok(()) = draw_in_windows(frame, at);
    });
}

#[test]
fn an_area_without_end_takes_no_more_colours_than_are_seen() {
    on_every_layout!(fill_without_end());
}

fn fill_without_end<C: Code + Debug, L: Layout<C>>(packing: Packing) {
    let mut expected = Reference::<C>::new(13, 9);
    expected.draw(|_, _| Some(C::from_code(0x5A)));
    let everything = Rectangle::new(Point::new(i32::MIN, i32::MIN), Size::new(u32::MAX, u32::MAX));
    conform::<C, L>(packing, &expected, |frame| {
        let Ok(()) = frame.fill_contiguous(&everything, iter::repeat(C::from_code(0x5A)));
    });
}
