//! Clustered-dot screens: black dots of different sizes, and the gain of dots.

use aquatint::{
    Dithered, DotGain, Frame, Levels, Light, RankMask, Rect, Rows,
    display::{
        dither::{Mask, UnevenRanks},
        halftone::{
            DOTS_4X4, DOTS_8X8, DOTS_45_4X4, DOTS_45_8X8, LINES_4X4, LINES_8X8, LINES_45_8X8, dots, dots_45, lines,
            lines_45,
        },
        level::NotRising,
    },
};
use embedded_graphics::{geometry::Point, image::GetPixel, pixelcolor::BinaryColor};

/// An area of 16 × 8 pixels with a share of its light; `#` is black.
fn picture(mask: &impl Mask, share: u32) -> [String; 8] {
    let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 16], 16, 8).unwrap();
    let light = Light(u16::try_from(share * 65_535 / 64).unwrap());
    let Ok(()) = Dithered::new(&mut frame, Levels::ONE_BIT).with_method(mask).fill_area(Rect::new(0, 0, 16, 8), light);
    let sign = |x, y| if frame.pixel(Point::new(x, y)) == Some(BinaryColor::On) { '.' } else { '#' };
    core::array::from_fn(|y| (0..16).map(|x| sign(x, i32::try_from(y).unwrap())).collect())
}

#[test]
fn dots_grow_where_they_are() {
    let light = [
        "................",
        "................",
        "...##......##...",
        "..####....####..",
        "..####....####..",
        "...##......##...",
        "................",
        "................",
    ];
    assert_eq!(picture(&DOTS_8X8, 52), light);
    let middle = [
        "................",
        "..####....####..",
        ".######..######.",
        ".######..######.",
        ".######..######.",
        ".######..######.",
        "..####....####..",
        "................",
    ];
    assert_eq!(picture(&DOTS_8X8, 32), middle);
    let dark = [
        ".######..######.",
        "################",
        "################",
        "################",
        "################",
        "################",
        "################",
        ".######..######.",
    ];
    assert_eq!(picture(&DOTS_8X8, 4), dark);
}

#[test]
fn two_dots_at_45_degrees() {
    // One in the middle of the tile, one on its corners; eight of 64 cells are black.
    let light = [
        "#......##......#",
        "................",
        "................",
        "...##......##...",
        "...##......##...",
        "................",
        "................",
        "#......##......#",
    ];
    assert_eq!(picture(&DOTS_45_8X8, 56), light);
}

#[test]
fn lines_grow_from_their_middle() {
    let white = "................".to_owned();
    let black = "################".to_owned();
    let quarter = picture(&LINES_8X8, 48);
    assert_eq!(quarter, core::array::from_fn(|y| if [3, 4].contains(&y) { black.clone() } else { white.clone() }));
    let diagonal = picture(&LINES_45_8X8, 48);
    for (y, row) in diagonal.iter().enumerate() {
        let expected: String = (0..16).map(|x| if [3, 4].contains(&((x + y) % 8)) { '#' } else { '.' }).collect();
        assert_eq!(*row, expected);
    }
}

/// For every light, the black cells are those that are nearer to the middle of a dot than the white ones.
fn assert_clustered<const S: usize>(ranks: &[[u8; S]; S], distance: impl Fn(i32, i32, i32) -> i32) {
    let size = i32::try_from(S).unwrap();
    let cell = |x: i32, y: i32| ranks[usize::try_from(y).unwrap()][usize::try_from(x).unwrap()];
    let all = || (0..size).flat_map(|y| (0..size).map(move |x| (x, y)));
    for (a, b) in all().flat_map(|a| all().map(move |b| (a, b))) {
        let nearer = distance(a.0, a.1, size) < distance(b.0, b.1, size);
        assert!(!nearer || cell(a.0, a.1) > cell(b.0, b.1), "{a:?} and {b:?} of {size}");
    }
    assert!(RankMask::<S, S>::new(ranks.as_flattened()).is_ok(), "each rank once: {ranks:?}");
}

/// Squares of distances between centres, in half pixels, over the nearest of the tiles around.
fn to_dots(middles: &[(i32, i32)], x: i32, y: i32, size: i32) -> i32 {
    let near = |&(column, row): &(i32, i32)| {
        let shifts = [-1, 0, 1].map(|shift| 2 * size * shift);
        let across = shifts.map(|shift| (2 * x + 1 - column + shift).pow(2)).into_iter().min().unwrap();
        across + shifts.map(|shift| (2 * y + 1 - row + shift).pow(2)).into_iter().min().unwrap()
    };
    middles.iter().map(near).min().unwrap()
}

fn assert_screens<const S: usize>() {
    assert_clustered(&dots::<S>(), |x, y, size| to_dots(&[(size, size)], x, y, size));
    assert_clustered(&dots_45::<S>(), |x, y, size| to_dots(&[(0, 0), (size, size)], x, y, size));
    assert_clustered(&lines::<S>(), |_, y, size| (2 * y + 1 - size).abs());
    assert_clustered(&lines_45::<S>(), |x, y, size| (2 * ((x + y) % size) + 1 - size).abs());
}

#[test]
fn the_middles_of_the_dots_are_black_last() {
    assert_screens::<1>();
    assert_screens::<4>();
    assert_screens::<5>();
    assert_screens::<6>();
    assert_screens::<7>();
    assert_screens::<8>();
    assert_screens::<16>();
}

/// Sides between a black and a white cell, over all lights: how much of an area can blur.
fn borders(mask: &impl Mask) -> u32 {
    let black = |x: i32, y: i32, share: u32| u32::from(mask.threshold(x, y)) >= share * 1024;
    let places = || (0..16).flat_map(|y| (0..16).map(move |x| (x, y)));
    let side = |(x, y): (i32, i32), share| {
        u32::from(black(x, y, share) != black(x + 1, y, share))
            + u32::from(black(x, y, share) != black(x, y + 1, share))
    };
    (0..64).map(|share| places().map(|at| side(at, share)).sum::<u32>()).sum()
}

#[test]
fn dots_have_less_border_than_scattered_pixels() {
    let scattered = borders(&aquatint::BAYER_4X4);
    for dots in [borders(&DOTS_4X4), borders(&DOTS_45_4X4), borders(&LINES_4X4)] {
        assert!(dots * 5 < scattered * 4, "{dots}, {scattered}");
    }
    for dots in [borders(&DOTS_8X8), borders(&DOTS_45_8X8), borders(&LINES_8X8), borders(&LINES_45_8X8)] {
        assert!(dots * 2 < scattered, "{dots}, {scattered}");
    }
}

/// White pixels of 16 by a mask.
fn white(mask: &impl Mask, light: u32) -> u32 {
    let places = (0..4).flat_map(|y| (0..4).map(move |x| (x, y)));
    places.map(|(x, y)| u32::from(light > (65_535 * u32::from(mask.threshold(x, y))) >> 16)).sum()
}

#[test]
fn a_bent_mask_shows_the_light_that_was_meant() {
    // Sixteenths of white pixels give less light, as where black grows into white.
    let curve: [u16; 17] = core::array::from_fn(|at| u16::try_from((at * at * 3 + at * 16) * 65_535 / 1024).unwrap());
    let mask = DotGain::new(DOTS_45_4X4, curve).unwrap();
    for light in 0..=65_535_u32 {
        let shown = u32::from(curve[white(&mask, light) as usize]);
        let nearest = curve.iter().map(|&shade| u32::from(shade).abs_diff(light)).min().unwrap();
        // Between two shades the switch is where the curve is half-way: on straight pieces, the middle.
        assert!(shown.abs_diff(light) <= nearest + 2, "{light}: {shown}");
    }
    assert_eq!([white(&mask, 0), white(&mask, 65_535)], [0, 16]);
    let even = core::array::from_fn(|at| u16::try_from(at * 65_535 / 16).unwrap());
    let even = DotGain::new(DOTS_45_4X4, even).unwrap();
    for light in 0..=65_535 {
        assert!(
            white(&even, light).abs_diff(white(&DOTS_45_4X4, light))
                <= u32::from(light % 4096 / 2048 == 0 || light % 4096 > 2040)
        );
    }
}

#[test]
fn curves_that_do_not_rise_from_black_to_white_are_refused() {
    let even: [u16; 17] = core::array::from_fn(|at| u16::try_from(at * 65_535 / 16).unwrap());
    assert!(DotGain::new(DOTS_4X4, even).is_ok());
    let changed = |at: usize, light: u16| {
        let mut curve = even;
        curve[at] = light;
        DotGain::new(DOTS_4X4, curve).map(drop)
    };
    assert_eq!(changed(0, 1), Err(NotRising));
    assert_eq!(changed(16, 65_534), Err(NotRising));
    assert_eq!(changed(7, even[8]), Err(NotRising));
    assert_eq!(changed(7, 0), Err(NotRising));
    assert_eq!(changed(7, even[7] + 1), Ok(()));
}

#[test]
fn screens_of_other_sizes_are_masks() {
    let ranks = dots_45::<5>();
    let mask: Result<RankMask<'_, 5, 5>, UnevenRanks> = RankMask::new(ranks.as_flattened());
    assert!(mask.is_ok());
}
