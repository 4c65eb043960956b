//! Instants by rank: every pixel is drawn once, and what stands still is drawn as it is.

use core::{convert::Infallible, fmt::Debug};

use aquatint::{
    BAYER_2X2, BAYER_4X4, BAYER_8X8, BLUE_NOISE_16, Code, Columns, Dithered, Frame, Interleaved, Inverted, Levels,
    Light, LsbFirst, MsbFirst, OnDrawTarget, Pages, Planes, RankMask, Rect, Rows, Target, Window,
    display::{dither::Mask, layout::Layout},
};
use embedded_graphics::{
    Pixel,
    image::GetPixel,
    pixelcolor::{BinaryColor, Gray2, Gray4, Gray8},
    prelude::*,
    primitives::Rectangle,
};
use proptest::{collection::vec, prelude::*};

use crate::reference::{
    Packing, Reference, conform,
    drawings::{draw_in_windows, draw_shapes},
    places,
    steps::{Step, step},
};

const SIZE: (u32, u32) = (29, 19);

/// Diagonals of a period that no byte has.
const DIAGONALS: RankMask<'static, 3, 5> = match RankMask::new(&[0, 1, 2, 1, 2, 0, 2, 0, 1, 0, 1, 2, 1, 2, 0]) {
    Ok(mask) => mask,
    Err(_) => panic!("even"),
};

type Grey = Frame<Gray8, Rows, [u8; 29 * 19]>;

/// Which pixels are drawn: black and white ground tell even what is drawn in the colour of one.
fn drawn(draw: impl Fn(&mut Grey)) -> Vec<bool> {
    let [black, white] = [0, 255].map(|ground| {
        let mut frame = Grey::with_array([ground; 29 * 19], 29, 19).expect("enough");
        draw(&mut frame);
        frame.bytes().iter().map(|&code| code != ground).collect::<Vec<_>>()
    });
    black.into_iter().zip(white).map(|(black, white)| black || white).collect()
}

/// Draws something at all instants, of which exactly one draws each of its pixels.
fn counted<const W: usize, const H: usize>(step: &Step, mask: RankMask<W, H>, of: u16) {
    let mut often = vec![0; 29 * 19];
    for i in 0..of {
        let instant = drawn(|frame| step.draw(&mut Interleaved::new(frame, mask, i, of)));
        often.iter_mut().zip(instant).for_each(|(often, is_drawn)| *often += u32::from(is_drawn));
    }
    let once: Vec<u32> = drawn(|frame| step.draw(frame)).into_iter().map(u32::from).collect();
    assert!(often == once, "{of} instants: {often:?}");
}

/// What is drawn at all instants is what is drawn once.
fn still<C: Code + Debug, L: Layout<C>>(packing: Packing, steps: &[Step], of: u16) {
    let mut expected = Reference::<C>::new(SIZE.0, SIZE.1);
    for step in steps {
        step.draw_slowly(&mut expected);
    }
    conform::<C, L>(packing, &expected, |frame| {
        for i in 0..of {
            let mut instant = Interleaved::new(frame, BAYER_4X4, i, of);
            for step in steps {
                step.draw(&mut instant);
            }
        }
    });
    conform::<C, L>(packing, &expected, |frame| {
        let mut lent = OnDrawTarget::new(frame);
        for i in (0..of).rev() {
            let mut instant = Interleaved::new(&mut lent, DIAGONALS, i, of);
            for step in steps {
                step.draw(&mut instant);
            }
        }
    });
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn every_pixel_is_drawn_by_exactly_one_instant(step in step(), of in 1..40_u16) {
        counted(&step, BAYER_2X2, of);
        counted(&step, BAYER_4X4, 16);
        counted(&step, BAYER_8X8, of);
        counted(&step, BLUE_NOISE_16, of);
        counted(&step, DIAGONALS, of);
    }

    #[test]
    fn what_stands_still_is_drawn_as_it_is(steps in vec(step(), 1..6), of in prop_oneof![Just(16_u16), 1..20_u16]) {
        on_every_layout!(still(&steps, of));
    }

    #[test]
    fn an_instant_has_the_pixels_of_its_ranks(of in 1..=300_u16, which: u16) {
        // Ranks by their thresholds: (2k + 1) / 2K of 65536.
        let i = which % of;
        let mut seen = Reference::<Gray8>::new(16, 16);
        let mut lent = OnDrawTarget::new(&mut seen);
        let Ok(()) = Interleaved::new(&mut lent, BLUE_NOISE_16, i, of).clear(Gray8::WHITE);
        for ((x, y), pixel) in places(Rect::new(0, 0, 16, 16)).zip(seen.pixels()) {
            let rank = u32::from(BLUE_NOISE_16.threshold(x, y)) * 256 / 65_536;
            prop_assert_eq!(pixel.is_some(), rank * u32::from(of) / 256 == u32::from(i), "rank {} of {}", rank, of);
        }
    }
}

#[test]
fn four_by_four_has_sixteen_instants() {
    let ranks = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];
    for i in 0..18_u16 {
        let mut frame = Frame::<Gray8, Rows, _>::with_array([0; 64], 8, 8).expect("64 bytes");
        let Ok(()) = Interleaved::new(&mut frame, BAYER_4X4, i, 16).clear(Gray8::WHITE);
        for (y, row) in frame.bytes().chunks(8).enumerate() {
            let expected = core::array::from_fn::<_, 8, _>(|x| if ranks[y % 4][x % 4] == i { 255 } else { 0 });
            assert_eq!(row, expected, "instant {i}, row {y}");
        }
    }
}

/// Runs of one pixel, of a few, and of many, drawn with the scene moved by two columns an instant.
#[test]
fn each_pixel_shows_the_scene_at_its_instant() {
    let ranks = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];
    for width in [1, 3, 7, 20] {
        let mut frame = Frame::<BinaryColor, Pages, _>::with_array([0; 128], 64, 16).expect("two pages");
        for i in 0..16 {
            let bar = Rectangle::new(Point::new(5 + 2 * i, 1), Size::new(width, 13));
            let mut instant = Interleaved::new(&mut frame, BAYER_4X4, u16::try_from(i).unwrap(), 16);
            let Ok(()) = instant.clear(BinaryColor::Off);
            let Ok(()) = instant.fill_solid(&bar, BinaryColor::On);
        }
        let mut expected = Reference::<BinaryColor>::new(64, 16);
        expected.draw(|x, y| {
            let rank: i32 = ranks[usize::try_from(y % 4).unwrap()][usize::try_from(x % 4).unwrap()];
            let left = 5 + 2 * rank;
            Some(BinaryColor::from((1..14).contains(&y) && (left..left + width.cast_signed()).contains(&x)))
        });
        conform::<BinaryColor, Pages>(Packing::Pages, &expected, |copy| {
            let Ok(()) = copy.draw_iter(
                places(Rect::new(0, 0, 64, 16))
                    .map(|(x, y)| Pixel(Point::new(x, y), frame.pixel(Point::new(x, y)).expect("inside"))),
            );
        });
    }
}

/// The scene of an instant.
fn scene<D: DrawTarget<Color: From<Gray8>, Error = Infallible>>(display: &mut D, i: u16) {
    let Ok(()) = display.fill_solid(&display.bounding_box(), Gray8::new(0).into());
    let Ok(()) = draw_shapes(display, Point::new(2 + i32::from(i), 4));
    let Ok(()) = draw_shapes(display, Point::new(60, 20 - i32::from(i)));
}

#[test]
fn bands_make_the_picture() {
    let mut whole = Frame::<Gray4, Rows, _>::with_array([0; 64 * 37], 128, 37).expect("enough");
    (0..16).for_each(|i| scene(&mut Interleaved::new(&mut whole, BAYER_4X4, i, 16), i));
    for high in [1, 8, 13] {
        let mut band = Frame::<Gray4, Rows, _>::new(vec![0; 64 * 13], 128, high).expect("enough");
        let mut rows = vec![];
        for top in (0..37).step_by(high as usize) {
            let mut band = Window::band(&mut band, top);
            (0..16).for_each(|i| scene(&mut Interleaved::new(&mut band, BAYER_4X4, i, 16), i));
            rows.extend(
                places(Rect::new(0, top, 128, 37.min(top + high.cast_signed())))
                    .map(|(x, y)| band.pixel(Point::new(x, y)).expect("inside").luma()),
            );
        }
        let expected: Vec<u8> = whole.bytes().iter().flat_map(|byte| [byte >> 4, byte & 15]).collect();
        assert!(rows == expected, "bands of {high}");
    }
}

/// Light that is dithered on its way, with colours that are areas.
#[test]
fn drawings_are_dithered_on_an_instant() {
    let direct = {
        let mut frame = Frame::<BinaryColor, Pages, _>::with_array([0; 1024], 128, 64).expect("eight pages");
        let mut display = Dithered::new(&mut frame, Levels::ONE_BIT).into_draw_target::<Gray8>();
        let Ok(()) = draw_in_windows(&mut display, Point::new(30, 20));
        let Ok(()) = Dithered::new(&mut frame, Levels::ONE_BIT).fill_area(Rect::new(3, 40, 90, 61), Light(20_000));
        frame
    };
    let mut frame = Frame::<BinaryColor, Pages, _>::with_array([0; 1024], 128, 64).expect("eight pages");
    for i in 0..16 {
        let mut instant = Interleaved::new(&mut frame, BAYER_4X4, i, 16);
        let mut display = Dithered::new(&mut instant, Levels::ONE_BIT).into_draw_target::<Gray8>();
        let Ok(()) = draw_in_windows(&mut display, Point::new(30, 20));
        let Ok(()) = Dithered::new(&mut instant, Levels::ONE_BIT).fill_area(Rect::new(3, 40, 90, 61), Light(20_000));
    }
    assert_eq!(frame.bytes(), direct.bytes());
}

#[test]
fn no_instants_draw_nothing() {
    for (i, of) in [(0, 0), (16, 16), (u16::MAX, 16), (u16::MAX, 0)] {
        let mut frame = Frame::<BinaryColor, Pages, _>::with_array([0; 16], 16, 8).expect("a page");
        let Ok(()) = Interleaved::new(&mut frame, BAYER_4X4, i, of).clear(BinaryColor::On);
        let Ok(()) = Interleaved::new(&mut frame, BAYER_4X4, i, of).fill_run(0, i32::MIN..i32::MAX, [BinaryColor::On]);
        assert_eq!(frame.bytes(), [0; 16], "{i} of {of}");
    }
}
