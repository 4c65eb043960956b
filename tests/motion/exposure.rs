//! Exposures: the exact sums, by bands, on any picture.

use core::convert::{Infallible, identity};

use aquatint::{
    Dithered, Exposure, Frame, IntoLight, Levels, Light, LsbFirst, OnDrawTarget, Pages, Rows, Target, Window, Words,
};
use embedded_graphics::{
    image::GetPixel,
    pixelcolor::{BinaryColor, Gray4, Gray8},
    prelude::*,
};
use proptest::{collection::vec, prelude::*};

use crate::reference::{drawings::draw_shapes, size_u32};

/// A row of lights, or several of a width.
fn lights(lights: &[u16], width: u32) -> Frame<Light, Words, Vec<u8>> {
    let bytes = lights.iter().flat_map(|light| light.to_be_bytes()).collect();
    Frame::new(bytes, width, size_u32(lights.len()) / width).expect("whole rows")
}

fn sums(frame: &Frame<Light, Words, Vec<u8>>) -> Vec<u16> {
    frame.bytes().chunks(2).map(|two| u16::from_be_bytes([two[0], two[1]])).collect()
}

/// The rule of what sub-frame `i` of `n` adds.
fn share(light: u16, i: u16, n: u16) -> u32 {
    let upto = |k: u32| u32::from(light) * k / u32::from(n);
    upto(u32::from(i) + 1) - upto(u32::from(i))
}

/// Adds rows of the same number of lights.
fn exposed(subframes: &[Vec<u16>]) -> Vec<u16> {
    let width = size_u32(subframes[0].len());
    let mut sum = lights(&vec![0xDEAD; subframes[0].len()], width);
    let mut exposure = Exposure::new(&mut sum, u16::try_from(subframes.len()).expect("few")).expect("1 to 256");
    for subframe in subframes {
        let Ok(()) = exposure.add(&lights(subframe, width), identity);
    }
    sums(&sum)
}

#[test]
fn what_does_not_change_keeps_its_light_after_every_subframe() {
    for n in 1..=256_u16 {
        // Other lights for each number, and the ends.
        let mut row: Vec<u16> = (0..160_u16).map(|at| at.wrapping_mul(409).wrapping_add(n * 31)).collect();
        row.extend([0, 1, 255, 256, 257, 32_767, 32_768, 65_279, 65_280, 65_534, 65_535]);
        let blank = || lights(&vec![0xDEAD; row.len()], size_u32(row.len()));
        let (picture, mut sum, mut shown) = (lights(&row, size_u32(row.len())), blank(), blank());
        let mut exposure = Exposure::new(&mut sum, n).expect("1 to 256");
        for i in 1..=n {
            let Ok(()) = exposure.add(&picture, identity);
            let Ok(()) = exposure.show(&mut shown);
            let upto = |light: &u16| u16::try_from(u32::from(*light) * u32::from(i) / u32::from(n)).expect("a part");
            assert_eq!(sums(&shown), row.iter().map(upto).collect::<Vec<_>>(), "{i} of {n}");
        }
        assert_eq!(sums(&sum), row);
    }
}

#[test]
fn the_number_of_subframes_is_1_to_256() {
    let mut sum = lights(&[1, 2], 2);
    for n in [0, 257, u16::MAX] {
        assert_eq!(Exposure::new(&mut sum, n).unwrap_err().to_string(), "the number of sub-frames is not 1 to 256");
    }
    assert_eq!(sums(&sum), [1, 2]);
}

#[test]
fn more_subframes_than_said_are_not_added() {
    let (mut sum, picture) = (lights(&[0; 3], 3), lights(&[9, 500, 65_535], 3));
    let mut exposure = Exposure::new(&mut sum, 2).expect("1 to 256");
    for taken in [1, 2, 2, 2] {
        let Ok(()) = exposure.add(&picture, identity);
        assert_eq!(exposure.taken(), taken);
    }
    assert_eq!(sums(&sum), [9, 500, 65_535]);
}

#[test]
fn where_a_picture_has_no_pixel_it_is_black() {
    let mut sum = lights(&[40_000; 6], 3);
    let mut exposure = Exposure::new(&mut sum, 2).expect("1 to 256");
    let Ok(()) = exposure.add(&lights(&[65_535; 2], 2), identity);
    let Ok(()) = exposure.add(&lights(&[65_535; 12], 4), identity);
    assert_eq!(sums(&sum), [65_535, 65_535, 32_768, 32_768, 32_768, 32_768]);
}

/// White at some instants of eight.
#[test]
fn the_light_is_the_part_of_the_time() {
    let instants = ["##......", ".##.....", "..##....", "...##...", "....##..", "....##..", "....##..", "....##.."];
    let mut sum = lights(&[0; 8], 8);
    let mut exposure = Exposure::new(&mut sum, 8).expect("1 to 256");
    for instant in instants {
        let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0], 8, 1).expect("a byte");
        let colors = instant.chars().map(|sign| Some(BinaryColor::from(sign == '#')));
        let Ok(()) = frame.write_run(0, 0..8, colors);
        let Ok(()) = exposure.add(&frame, IntoLight::into_light);
    }
    let eighths: Vec<u16> = sums(&sum).into_iter().map(|light| (light + 1) / 8192).collect();
    assert_eq!(eighths, [1, 2, 2, 2, 5, 4, 0, 0]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn sums_follow_the_rule_and_stay_near_the_mean(
        subframes in (1..=90_usize, 1..=256_usize).prop_flat_map(|(width, n)| {
            let light = prop_oneof![3 => Just(0_u16), 3 => Just(u16::MAX), 2 => any::<u16>(), 1 => 65_500..=u16::MAX];
            vec(vec(light, width), n.min(2000 / width))
        }),
    ) {
        let n = u16::try_from(subframes.len()).unwrap();
        for (column, sum) in exposed(&subframes).into_iter().enumerate() {
            let of: Vec<u16> = subframes.iter().map(|row| row[column]).collect();
            let expected: u32 = (0..n).zip(&of).map(|(i, &light)| share(light, i, n)).sum();
            prop_assert_eq!(u32::from(sum), expected.min(65_535));
            let mean = of.iter().map(|&light| f64::from(light)).sum::<f64>() / f64::from(n);
            let changes = of.windows(2).filter(|two| two[0] != two[1]).count();
            let error = (f64::from(sum) - mean).abs();
            prop_assert!(error < f64::from(size_u32(changes)) || (changes == 0 && error == 0.0), "{error}, {changes}");
        }
    }
}

/// Shapes at an instant of `of`: they move to the right and downwards.
fn scene<D: DrawTarget<Color: From<Gray8>, Error = Infallible>>(display: &mut D, (i, of): (u16, u16)) {
    let part = |pixels: i32| pixels * (2 * i32::from(i) + 1) / (2 * i32::from(of));
    let Ok(()) = display.fill_solid(&display.bounding_box(), Gray8::new(40).into());
    let Ok(()) = draw_shapes(display, Point::new(6 + part(40), 4 + part(9)));
}

const SIZE: (u32, u32) = (77, 37);

/// All of the picture at once.
fn whole(n: u16) -> Frame<BinaryColor, Pages, Vec<u8>> {
    let (width, height) = SIZE;
    let mut screen = Frame::new(vec![0; 77 * 5], width, height).expect("five pages");
    let mut sum = Frame::<Light, Words<LsbFirst>, _>::new(vec![0; 77 * 37 * 2], width, height).expect("enough");
    let mut exposure = Exposure::new(&mut sum, n).expect("1 to 256");
    for i in 0..n {
        let mut instant = Frame::<Gray8, Rows, _>::new(vec![0; 77 * 37], width, height).expect("enough");
        scene(&mut instant, (i, n));
        let Ok(()) = exposure.add(&instant, IntoLight::into_light);
    }
    let Ok(()) = exposure.show(&mut Dithered::new(&mut screen, Levels::ONE_BIT));
    screen
}

#[test]
fn bands_make_the_picture() {
    for (n, high) in [(1, 8), (4, 1), (5, 8), (8, 13), (13, 37), (2, 40)] {
        let (whole, width) = (whole(n), SIZE.0);
        let mut screen = Frame::<BinaryColor, Pages, _>::new(vec![0; 77 * 5], SIZE.0, SIZE.1).expect("five pages");
        let mut sum = Frame::<Light, Words, _>::new(vec![0xAA; 77 * 80], width, high).expect("enough");
        let mut instant = Frame::<Gray8, Rows, _>::new(vec![0xAA; 77 * 40], width, high).expect("enough");
        for top in (0..37).step_by(high as usize) {
            let (mut sum, mut instant) = (Window::band(&mut sum, top), Window::band(&mut instant, top));
            let mut exposure = Exposure::new(&mut sum, n).expect("1 to 256");
            for i in 0..n {
                scene(&mut instant, (i, n));
                let Ok(()) = exposure.add(&instant, IntoLight::into_light);
            }
            let Ok(()) = exposure.show(&mut Dithered::new(&mut screen, Levels::ONE_BIT));
        }
        assert_eq!(screen.bytes(), whole.bytes(), "{n} sub-frames, bands of {high}");
    }
}

#[test]
fn a_still_picture_is_shown_as_if_there_were_no_shutter() {
    let mut still = Frame::<Gray4, Rows, _>::new(vec![0; 39 * 37], SIZE.0, SIZE.1).expect("enough");
    let Ok(()) = draw_shapes(&mut still, Point::new(20, 9));
    let mut expected = Frame::<BinaryColor, Pages, _>::new(vec![0; 77 * 5], SIZE.0, SIZE.1).expect("five pages");
    let mut dithered = Dithered::new(&mut expected, Levels::ONE_BIT).into_draw_target::<Gray4>();
    let colors = still.bounding_box().points().map(|at| still.pixel(at).expect("inside"));
    let Ok(()) = dithered.fill_contiguous(&still.bounding_box(), colors);
    for n in [1, 3, 7, 16, 255, 256] {
        let mut sum = Frame::<Light, Words, _>::new(vec![0; 77 * 37 * 2], SIZE.0, SIZE.1).expect("enough");
        let mut exposure = Exposure::new(&mut sum, n).expect("1 to 256");
        (0..n).for_each(|_| exposure.add(&still, IntoLight::into_light).unwrap());
        let mut screen = Frame::<BinaryColor, Pages, _>::new(vec![0; 77 * 5], SIZE.0, SIZE.1).expect("five pages");
        let mut lent = OnDrawTarget::new(&mut screen);
        let Ok(()) = exposure.show(&mut Dithered::new(&mut lent, Levels::ONE_BIT));
        assert_eq!(screen.bytes(), expected.bytes(), "{n} sub-frames");
    }
}

/// Pictures without pixels, and buffers at the ends of the plane.
#[test]
fn empty_and_far_away_buffers_are_no_trouble() {
    let nothing = Frame::<Gray8, Rows, _>::new(vec![], 0, 9).expect("no bytes");
    let mut empty = Frame::<Light, Words, _>::new(vec![], 9, 0).expect("no bytes");
    let mut exposure = Exposure::new(&mut empty, 3).expect("1 to 256");
    let Ok(()) = exposure.add(&nothing, IntoLight::into_light);
    let mut sum = lights(&[5; 4], 2);
    for top in [i32::MIN, -1, i32::MAX - 1, i32::MAX] {
        let mut band = Window::band(&mut sum, top);
        let mut exposure = Exposure::new(&mut band, 3).expect("1 to 256");
        let Ok(()) = exposure.add(&nothing, IntoLight::into_light);
        let mut screen = Frame::<BinaryColor, Pages, _>::new(vec![0; 2], 2, 2).expect("two bytes");
        let Ok(()) = exposure.show(&mut Dithered::new(&mut screen, Levels::ONE_BIT));
        assert_eq!(band.bounding_box().size.width, 2);
    }
}
