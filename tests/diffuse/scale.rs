//! Scaling: every pixel is the true mean or the true interpolation, rounded once.

use aquatint::{
    Light,
    display::scale::{Filter, ScaleError, Scaler},
};
use embedded_graphics::geometry::Size;
use proptest::{collection::vec, prelude::*};

type Picture = Vec<Vec<u16>>;

fn size(picture: &Picture) -> Size {
    Size::new(u32::try_from(picture[0].len()).expect("small"), u32::try_from(picture.len()).expect("small"))
}

fn scaled(picture: &Picture, to: Size, filter: Filter) -> Picture {
    let mut memory = vec![u64::MAX; Scaler::memory_needed(to) + 1];
    let mut scaler = Scaler::new(&mut memory, size(picture), to, filter).expect("possible");
    let mut rows = vec![];
    // A second time, because nothing of the first may be left.
    for _ in 0..2 {
        scaler.restart();
        rows.clear();
        for row in picture {
            let push = scaler.push(row.iter().copied().map(Light), |number, row| {
                assert_eq!(rows.len(), usize::try_from(number).expect("small"));
                let backwards: Vec<_> = row.clone().rev().map(|light| light.0).collect();
                rows.push(row.map(|light| light.0).collect::<Vec<_>>());
                assert!(rows[rows.len() - 1].iter().rev().eq(&backwards));
                Ok::<(), ()>(())
            });
            assert_eq!(push, Ok(()));
        }
    }
    assert_eq!(memory.last(), Some(&u64::MAX));
    rows
}

/// Columns of the source, each with its weight, in a pixel of the result; the weights have the sum of the second.
fn weights(at: u32, from: u32, to: u32, filter: Filter) -> (Vec<(usize, i64)>, i64) {
    let (at, from, to) = (i64::from(at), i64::from(from), i64::from(to));
    let weight = |column: i64| match filter {
        // Columns of the source are `to` wide, those of the result `from`.
        Filter::Area => ((column + 1) * to).min((at + 1) * from) - (column * to).max(at * from),
        // A tent of the width of two columns around the centre, in halves of these units.
        Filter::Bilinear => 2 * to - ((2 * at + 1) * from - (2 * column + 1) * to).abs(),
    };
    let columns =
        (-1..=from).map(|column| (usize::try_from(column.clamp(0, from - 1)).expect("inside"), weight(column)));
    let columns = columns.filter(|(_, weight)| *weight > 0);
    match filter {
        Filter::Area => (columns.collect(), from),
        Filter::Bilinear => (columns.collect(), 2 * to),
    }
}

fn exact(picture: &Picture, to: Size, filter: Filter) -> Picture {
    let from = size(picture);
    let pixel = |x, y| {
        let ((columns, width), (rows, height)) =
            (weights(x, from.width, to.width, filter), weights(y, from.height, to.height, filter));
        let row = |y: usize| columns.iter().map(move |&(x, weight)| i64::from(picture[y][x]) * weight).sum::<i64>();
        let sum = rows.iter().map(|&(y, weight)| row(y) * weight).sum::<i64>();
        u16::try_from((2 * sum + width * height) / (2 * width * height)).expect("a light")
    };
    (0..to.height).map(|y| (0..to.width).map(|x| pixel(x, y)).collect()).collect()
}

fn picture() -> impl Strategy<Value = Picture> {
    (1..14_usize, 1..12_usize)
        .prop_flat_map(|(width, height)| vec(vec(prop_oneof![any::<u16>(), Just(0), Just(u16::MAX)], width), height))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn every_pixel_is_exact(picture in picture(), (width, height) in (1..30_u32, 1..30_u32)) {
        for filter in [Filter::Area, Filter::Bilinear] {
            let to = Size::new(width, height);
            assert_eq!(scaled(&picture, to, filter), exact(&picture, to, filter), "{filter:?} to {to}");
        }
    }

    #[test]
    fn the_light_of_all_is_kept_to_half_a_step_a_pixel(picture in picture(), (width, height) in (1..30_u32, 1..30_u32)) {
        let mean = |picture: &Picture| {
            let sum: i64 = picture.iter().flatten().map(|&light| i64::from(light)).sum();
            (sum, i64::try_from(picture.len() * picture[0].len()).expect("small"))
        };
        let ((sum, pixels), (scaled, scaled_pixels)) =
            (mean(&picture), mean(&scaled(&picture, Size::new(width, height), Filter::Area)));
        assert!(2 * (sum * scaled_pixels - scaled * pixels).abs() <= pixels * scaled_pixels);
    }
}

#[test]
fn flat_pictures_stay_flat() {
    for light in [0, 1, 2, 255, 32_767, 32_768, 65_534, 65_535] {
        for (from, to) in [((97, 31), (10, 17)), ((3, 5), (41, 2)), ((1, 1), (60, 60)), ((500, 1), (1, 300))] {
            let (picture, flat) = (vec![vec![light; from.0]; from.1], vec![vec![light; to.0]; to.1]);
            for filter in [Filter::Area, Filter::Bilinear] {
                assert_eq!(scaled(&picture, size(&flat), filter), flat);
            }
        }
    }
}

#[test]
fn the_largest_pictures_are_exact_too() {
    let row: Vec<u16> = (0..32_767_u16).map(|x| x.wrapping_mul(40_503)).collect();
    for filter in [Filter::Area, Filter::Bilinear] {
        let mean = |to: u32| {
            let (weights, sum) = weights(0, 32_767, to, filter);
            let light: i64 = weights.iter().map(|&(x, weight)| i64::from(row[x]) * weight).sum();
            (2 * light + sum) / (2 * sum)
        };
        let (wide, tall) = (vec![row.clone()], row.iter().map(|&light| vec![light]).collect());
        for (across, down) in [(1, 1), (3, 2), (32_767, 1)] {
            assert_eq!(i64::from(scaled(&wide, Size::new(across, down), filter)[0][0]), mean(across));
            assert_eq!(i64::from(scaled(&tall, Size::new(down, across), filter)[0][0]), mean(across));
        }
    }
    let white = vec![vec![u16::MAX; 32_767]; 3];
    assert_eq!(scaled(&white, Size::new(5, 7), Filter::Area), vec![vec![u16::MAX; 5]; 7]);
    assert_eq!(scaled(&white, Size::new(32_767, 2), Filter::Bilinear), vec![vec![u16::MAX; 32_767]; 2]);
}

#[test]
fn what_cannot_be_scaled_is_refused() {
    let new = |from: (u32, u32), to: (u32, u32), memory: usize| {
        Scaler::new(&mut vec![0; memory], from.into(), to.into(), Filter::Area).map(|_| ()).unwrap_err()
    };
    for empty in [(0, 4), (4, 0), (0, 0)] {
        assert_eq!((new(empty, (4, 4), 9), new((4, 4), empty, 9)), (ScaleError::Empty, ScaleError::Empty));
    }
    for large in [(32_768, 1), (1, u32::MAX)] {
        assert_eq!((new(large, (4, 4), 9), new((4, 4), large, 9)), (ScaleError::TooLarge, ScaleError::TooLarge));
    }
    assert_eq!(new((9, 9), (4, 4), 3), ScaleError::TooShort { needed: 4 });
    let texts = [ScaleError::Empty, ScaleError::TooLarge, ScaleError::TooShort { needed: 4 }].map(|e| e.to_string());
    let expected =
        ["a picture has no pixels", "a picture is wider or higher than 32767 pixels", "4 elements are needed"];
    assert_eq!(texts, expected);
}

#[test]
fn rows_that_are_short_long_or_too_many_do_no_harm() {
    for filter in [Filter::Area, Filter::Bilinear] {
        let mut memory = [0; 2];
        let mut scaler = Scaler::new(&mut memory, Size::new(4, 4), Size::new(2, 2), filter).expect("possible");
        let mut rows = vec![];
        for length in [1, 9, 4, 2, 4, 4, 4] {
            let push = scaler.push(core::iter::repeat_n(Light(500), length), |_, row| {
                rows.push(row.collect::<Vec<_>>());
                Ok::<(), ()>(())
            });
            assert_eq!(push, Ok(()));
        }
        assert_eq!(rows, [[Light(500); 2]; 2]);
    }
}
