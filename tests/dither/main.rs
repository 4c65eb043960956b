//! Ordered dither: what shades the masks give, and that every way of drawing gives the same pixels.

#[macro_use]
#[path = "../reference/mod.rs"]
mod reference;

mod codes;
mod draw;

mod exact;
mod frames;
mod inks;

mod masks;
mod void_and_cluster;

use core::{convert::Infallible, fmt::Debug, ops::Range};

use aquatint::{
    Code, Columns, Dithered, Frame, Inverted, Levels, Light, LsbFirst, MsbFirst, OnDrawTarget, Pages, Planes, Rows,
    Target,
    display::{dither::Method, layout::Layout, level::NotRising},
};
use embedded_graphics::{
    geometry::Point,
    image::GetPixel,
    pixelcolor::{BinaryColor, Gray2, Gray4, Gray8},
};
use proptest::{
    collection::{btree_set, vec},
    option,
    prelude::*,
};
use reference::{Packing, Reference, conform, size_i32, size_u32};

/// Codes of the cell that shows a light all over.
fn cell(levels: &[u16], method: Method, light: u16) -> [[u8; 4]; 4] {
    let mut frame = Frame::<Gray8, Rows, _>::with_array([0; 16], 4, 4).expect("16 bytes");
    let mut dithered = Dithered::new(&mut frame, Levels::new(levels).expect("rising")).with_method(method);
    for row in 0..4 {
        let Ok(()) = dithered.fill_run(row, 0..4, [Light(light)]);
    }
    core::array::from_fn(|y| core::array::from_fn(|x| frame.bytes()[4 * y + x]))
}

/// Places of a cell, row by row, with their ranks: the bits of x XOR y and of y, interleaved from the lowest.
fn ranks() -> [((usize, usize), u32); 16] {
    core::array::from_fn(|place| {
        let (x, y) = (place % 4, place / 4);
        let rank = ((x ^ y) & 1) << 3 | (y & 1) << 2 | (x ^ y) >> 1 << 1 | y >> 1;
        ((x, y), size_u32(rank))
    })
}

const ONE_BIT: [u16; 2] = [0, u16::MAX];
const LINEAR_16: [u16; 16] = [
    0, 4369, 8738, 13_107, 17_476, 21_845, 26_214, 30_583, 34_952, 39_321, 43_690, 48_059, 52_428, 56_797, 61_166,
    65_535,
];

fn srgb_16() -> [u16; 16] {
    core::array::from_fn(|code| Light::from_srgb(u8::try_from(17 * code).expect("at most 255")).0)
}

#[test]
#[rustfmt::skip]
fn shades_grow_pixel_by_pixel() {
    let shades = [1, 2, 4, 5, 8, 12, 15];
    let picture = [
        "#... #... #.#. #.#. #.#. #### ####",
        ".... .... .... .#.. .#.# .#.# ####",
        ".... ..#. #.#. #.#. #.#. #### ####",
        ".... .... .... .... .#.# .#.# .###",
    ];
    assert_eq!(shown::<Rows>(&shades), picture);
    assert_eq!(shown::<Pages>(&shades), picture);
}

/// Sixteenths of white as cells side by side on a panel of one bit.
fn shown<L: Layout<BinaryColor>>(shades: &[u16]) -> Vec<String> {
    let mut frame = Frame::<BinaryColor, L, _>::with_array([0; 64], 4 * size_u32(shades.len()), 4).expect("enough");
    let mut dithered = Dithered::new(&mut frame, Levels::ONE_BIT);
    for (left, shade) in (0..).step_by(4).zip(shades) {
        for row in 0..4 {
            let Ok(()) = dithered.fill_run(row, left..left + 4, [Light(shade * 4095)]);
        }
    }
    let sign = |x, y| if frame.pixel(Point::new(x, y)) == Some(BinaryColor::On) { '#' } else { '.' };
    let cell = |left, y| (left..left + 4).map(|x| sign(x, y)).collect::<String>();
    (0..4)
        .map(|y| (0..).step_by(4).take(shades.len()).map(|left| cell(left, y)).collect::<Vec<_>>().join(" "))
        .collect()
}

#[test]
fn on_one_bit_a_pixel_is_on_where_the_light_exceeds_its_threshold() {
    for light in 0..=u16::MAX {
        let cell = cell(&ONE_BIT, Method::Ordered4x4, light);
        for ((x, y), rank) in ranks() {
            let is_on = u32::from(light) * 32 > 65_535 * (2 * rank + 1);
            assert_eq!(cell[y][x], u8::from(is_on), "light {light}, rank {rank}");
        }
    }
}

#[test]
fn pixels_switch_on_at_these_srgb_codes() {
    let expected = [50, 87, 111, 129, 145, 159, 171, 183, 193, 203, 212, 221, 229, 237, 245, 252];
    for ((x, y), rank) in ranks() {
        let is_on = |code: &u8| cell(&ONE_BIT, Method::Ordered4x4, Light::from_srgb(*code).0)[y][x] == 1;
        assert_eq!((0..=255).find(is_on), Some(expected[rank as usize]), "rank {rank}");
    }
}

#[test]
fn black_is_black_and_white_is_white() {
    for method in [Method::Ordered4x4, Method::Nearest] {
        for levels in [&ONE_BIT[..], &LINEAR_16, &srgb_16(), &[300, 400, 65_535], &[0, 9, 60_000]] {
            let brightest = u8::try_from(levels.len() - 1).expect("few");
            assert_eq!(cell(levels, method, 0), [[0; 4]; 4]);
            assert_eq!(cell(levels, method, u16::MAX), [[brightest; 4]; 4]);
        }
    }
}

#[test]
fn a_flat_grey_is_right_to_half_a_shade() {
    for code in 0..=255 {
        let light = Light::from_srgb(code).0;
        let on: u8 = cell(&ONE_BIT, Method::Ordered4x4, light).as_flattened().iter().sum();
        let error = f64::from(on) / 16.0 - f64::from(light) / 65_535.0;
        assert!(error.abs() <= 1.0 / 32.0 + 1.0 / 65_536.0, "code {code}: {error}");
    }
}

#[test]
fn the_named_levels_are_the_tables_of_these_tests() {
    assert_eq!(Levels::ONE_BIT, Levels::new(&ONE_BIT).expect("rising"));
    assert_eq!(Levels::LINEAR_16, Levels::new(&LINEAR_16).expect("rising"));
    assert_eq!(Levels::SRGB_16, Levels::new(&srgb_16()).expect("rising"));
}

#[test]
fn levels_that_do_not_rise_are_refused() {
    for levels in [&[][..], &[7], &[5, 5], &[0, 9, 8], &[0; 257]] {
        assert_eq!(Levels::new(levels), Err(NotRising), "{levels:?}");
    }
    let too_many: Vec<u16> = (0..257).collect();
    assert_eq!(Levels::new(&too_many), Err(NotRising));
    assert!(Levels::new(&too_many[1..]).is_ok());
}

#[test]
fn a_cell_of_grey_levels_has_the_light_that_was_meant() {
    for light in (0..=u16::MAX).step_by(7) {
        assert_mean(&LINEAR_16, light);
        assert_mean(&srgb_16(), light);
        assert_mean(&even_levels::<Gray8>(), light);
    }
}

/// The mean of a cell differs from the light by at most 1/32 of the step; exactly, without rounding.
fn assert_mean(levels: &[u16], light: u16) {
    let brighter = levels.partition_point(|&level| level < light).clamp(1, levels.len() - 1);
    let (dark, bright) = (u32::from(levels[brighter - 1]), u32::from(levels[brighter]));
    let meant = u32::from(light).clamp(u32::from(levels[0]), bright);
    let cell = cell(levels, Method::Ordered4x4, light);
    let sum: u32 = cell.as_flattened().iter().map(|&code| u32::from(levels[usize::from(code)])).sum();
    assert!(2 * sum.abs_diff(16 * meant) <= bright - dark, "light {light} on {levels:?} is {cell:?}");
    let is_neighbour =
        |&code: &u8| [brighter - 1, brighter].contains(&code.into()) || levels[usize::from(code)] == light;
    assert!(cell.as_flattened().iter().all(is_neighbour), "light {light} on {levels:?} is {cell:?}");
}

fn assert_nearest(levels: &[u16], light: u16) {
    let [[code, ..], ..] = cell(levels, Method::Nearest, light);
    assert_eq!(cell(levels, Method::Nearest, light), [[code; 4]; 4]);
    let least = levels.iter().map(|level| level.abs_diff(light)).min();
    assert_eq!(Some(levels[usize::from(code)].abs_diff(light)), least, "light {light} on {levels:?} is {code}");
}

/// Levels that a measured panel may have; the darkest may be brighter than black.
fn levels() -> impl Strategy<Value = Vec<u16>> {
    let lights = || prop_oneof![any::<u16>(), 500..900_u16];
    let levels = prop_oneof![btree_set(lights(), 2..20), btree_set(lights(), 100..=256)];
    levels.prop_map(|levels| levels.into_iter().collect())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn any_levels_are_mixed_to_the_light_that_was_meant(levels in levels(), light: u16, near in 0..256_usize) {
        for light in [light, levels[near % levels.len()], levels[0].saturating_add(1)] {
            assert_mean(&levels, light);
            assert_nearest(&levels, light);
        }
    }

    #[test]
    fn pieces_of_a_picture_are_dithered_as_the_whole(
        lights in vec(vec(option::weighted(0.9, any::<u16>()), 37), 9),
        (column, row) in (0..37_usize, 0..9_usize),
        nearest: bool,
    ) {
        let method = if nearest { Method::Nearest } else { Method::Ordered4x4 };
        on_every_layout!(dither_in_pieces(method, &lights, (column, row)));
    }

    #[test]
    fn a_run_of_changing_light_has_in_each_pixel_the_shade_of_its_light(lights in vec(any::<u16>(), 16), row in 0..4_usize) {
        on_every_layout!(dither_one_by_one(&lights, row));
    }
}

/// In whole rows, and in four tiles, the last one first.
fn dither_in_pieces<C: Code + Debug, L: Layout<C>>(
    packing: Packing,
    method: Method,
    lights: &[Vec<Option<u16>>],
    (column, row): (usize, usize),
) {
    let (width, height) = (lights[0].len(), lights.len());
    let mut whole = Reference::<C>::new(size_u32(width), size_u32(height));
    write_lights(&mut OnDrawTarget::new(&mut whole), method, lights, (0..width, 0..height));
    conform::<C, L>(packing, &whole, |frame| {
        for rows in [row..height, 0..row] {
            for columns in [column..width, 0..column] {
                write_lights(frame, method, lights, (columns, rows.clone()));
            }
        }
    });
}

fn dither_one_by_one<C: Code + Debug, L: Layout<C>>(packing: Packing, lights: &[u16], row: usize) {
    let mut expected = Reference::<C>::new(size_u32(lights.len()), size_u32(row + 1));
    expected.draw(|x, y| {
        let (x, y) = (usize::try_from(x).ok()?, usize::try_from(y).ok()?);
        let cell = cell(&even_levels::<C>(), Method::Ordered4x4, lights[x]);
        (y == row).then(|| C::from_code(cell[y % 4][x % 4]))
    });
    let ramp: Vec<Option<u16>> = lights.iter().copied().map(Some).collect();
    conform::<C, L>(packing, &expected, |frame| {
        write_lights(frame, Method::Ordered4x4, &vec![ramp.clone(); row + 1], (0..lights.len(), row..row + 1));
    });
}

fn write_lights<C: Code>(
    target: &mut impl Target<Color = C, Error = Infallible>,
    method: Method,
    lights: &[Vec<Option<u16>>],
    (columns, rows): (Range<usize>, Range<usize>),
) {
    let levels = even_levels::<C>();
    let mut dithered = Dithered::new(target, Levels::new(&levels).expect("rising")).with_method(method);
    for row in rows {
        let run = lights[row][columns.clone()].iter().map(|light| light.map(Light));
        let Ok(()) = dithered.write_run(size_i32(row), size_i32(columns.start)..size_i32(columns.end), run);
    }
}

/// A level for each code of a colour, in equal steps.
fn even_levels<C: Code>() -> Vec<u16> {
    let last = (1 << C::BITS) - 1;
    (0..=last).map(|code: u32| u16::try_from(code * 65_535 / last).expect("at most white")).collect()
}
