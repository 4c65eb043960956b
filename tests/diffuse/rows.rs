//! Pixel by pixel the codes of the textbook.

use core::{convert::Infallible, fmt::Debug};

use aquatint::{
    Frame, Inverted, Levels, Light, LsbFirst, Rows,
    display::{
        diffuse::{
            Atkinson, Burkes, Diffusion, FloydSteinberg, JarvisJudiceNinke, Kernel, Scan, Sierra, SierraLite, Stucki,
            TooShort,
        },
        dither::PackedRows,
        layout::Layout,
    },
};
use embedded_graphics::{
    geometry::Point,
    pixelcolor::{BinaryColor, Gray2, Gray8},
};
use proptest::{collection::vec, prelude::*};

use crate::oracle::{self, Drawn};

/// Runs a generic function for each kernel, with its drawing.
macro_rules! each_kernel {
    ($run:ident($($argument:expr),*)) => {
        $run::<SierraLite>($crate::oracle::SIERRA_LITE, $($argument),*);
        $run::<FloydSteinberg>($crate::oracle::FLOYD_STEINBERG, $($argument),*);
        $run::<Atkinson>($crate::oracle::ATKINSON, $($argument),*);
        $run::<Burkes>($crate::oracle::BURKES, $($argument),*);
        $run::<Sierra>($crate::oracle::SIERRA, $($argument),*);
        $run::<JarvisJudiceNinke>($crate::oracle::JARVIS, $($argument),*);
        $run::<Stucki>($crate::oracle::STUCKI, $($argument),*);
    };
}

fn size(value: usize) -> u32 {
    u32::try_from(value).expect("small")
}

fn lights(row: &[u16]) -> impl DoubleEndedIterator<Item = Light> + ExactSizeIterator {
    row.iter().copied().map(Light)
}

/// The codes that the crate gives.
fn codes<K: Kernel>(picture: &[Vec<u16>], levels: &[u16], scan: Scan) -> Vec<Vec<u8>> {
    let (width, height) = (picture[0].len(), picture.len());
    let mut frame = Frame::<Gray8, Rows, _>::new(vec![0; width * height], size(width), size(height)).expect("enough");
    // What the memory held does not matter, nor what is behind.
    let mut memory = vec![12_345; Diffusion::<K>::memory_needed(size(width)) + 1];
    let levels = Levels::new(levels).expect("rising");
    let mut diffusion = Diffusion::<K>::new(&mut memory, size(width), levels).expect("enough").with_scan(scan);
    for (y, row) in (0..).zip(picture) {
        let Ok(()) = diffusion.draw_row(&mut frame, Point::new(0, y), lights(row));
    }
    assert_eq!(memory.last(), Some(&12_345));
    frame.bytes().chunks(width).map(<[u8]>::to_vec).collect()
}

fn check<K: Kernel>(drawn: Drawn, picture: &[Vec<u16>], levels: &[u16], scan: Scan) {
    assert_eq!(codes::<K>(picture, levels, scan), oracle::diffuse(picture, levels, drawn, scan), "{drawn:?} {scan:?}");
}

type Check = fn(&[Vec<u16>], &[u16], Scan);

const CHECKS: [Check; 7] = [
    |picture, levels, scan| check::<SierraLite>(oracle::SIERRA_LITE, picture, levels, scan),
    |picture, levels, scan| check::<FloydSteinberg>(oracle::FLOYD_STEINBERG, picture, levels, scan),
    |picture, levels, scan| check::<Atkinson>(oracle::ATKINSON, picture, levels, scan),
    |picture, levels, scan| check::<Burkes>(oracle::BURKES, picture, levels, scan),
    |picture, levels, scan| check::<Sierra>(oracle::SIERRA, picture, levels, scan),
    |picture, levels, scan| check::<JarvisJudiceNinke>(oracle::JARVIS, picture, levels, scan),
    |picture, levels, scan| check::<Stucki>(oracle::STUCKI, picture, levels, scan),
];

/// Light as it is and as it hurts: flat black and white, and what lies between.
fn hostile() -> impl Strategy<Value = u16> {
    prop_oneof![3 => any::<u16>(), 1 => Just(0), 1 => Just(u16::MAX), 1 => 32_760..32_775_u16, 1 => 65_000..=u16::MAX]
}

fn picture() -> impl Strategy<Value = Vec<Vec<u16>>> {
    let sizes = prop_oneof![4 => (1..12_usize, 1..9_usize), 1 => (60..140_usize, 1..5_usize)];
    sizes.prop_flat_map(|(width, height)| {
        let noise = vec(vec(hostile(), width), height);
        let bands = vec(hostile(), height).prop_map(move |rows| rows.into_iter().map(|row| vec![row; width]).collect());
        prop_oneof![2 => noise, 1 => bands]
    })
}

fn levels() -> impl Strategy<Value = Vec<u16>> {
    let any = proptest::collection::btree_set(any::<u16>(), 2..9).prop_map(|levels| levels.into_iter().collect());
    prop_oneof![Just(vec![0, u16::MAX]), any, Just(vec![300, 301]), Just((0..256).map(|code| code * 257).collect())]
}

fn scan() -> impl Strategy<Value = Scan> {
    prop_oneof![Just(Scan::Serpentine), Just(Scan::Raster)]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn every_pixel_is_that_of_the_textbook(
        picture in picture(),
        levels in levels(),
        scan in scan(),
        kernel in 0..7_usize,
    ) {
        CHECKS[kernel](&picture, &levels, scan);
    }

    #[test]
    fn packed_rows_are_the_same_pixels(
        row in vec(hostile(), 1..200),
        (left, top) in (-150..100, -1..3),
        width in 1..140_u32,
        before: u8,
    ) {
        packed_like_runs::<Rows>(&row, Point::new(left, top), width, before);
        packed_like_runs::<Rows<LsbFirst>>(&row, Point::new(left, top), width, before);
        packed_like_runs::<Inverted<Rows>>(&row, Point::new(left, top), width, before);
        packed_like_runs::<Inverted<Rows<LsbFirst>>>(&row, Point::new(left, top), width, before);
    }
}

fn packed_like_runs<L: PackedRows + Layout<BinaryColor> + Debug>(row: &[u16], at: Point, width: u32, before: u8) {
    let new = || Frame::<BinaryColor, L, _>::new(vec![before; 200], width, 4).expect("enough");
    let draw = |frame: &mut Frame<BinaryColor, L, Vec<u8>>, is_packed: bool| {
        let mut memory = vec![0; Diffusion::<SierraLite>::memory_needed(size(row.len()))];
        let mut diffusion =
            Diffusion::<SierraLite>::new(&mut memory, size(row.len()), Levels::ONE_BIT).expect("enough");
        for y in 0..3 {
            let at = at + Point::new(0, y);
            if is_packed {
                diffusion.draw_packed_row(frame, at, lights(row));
            } else {
                let Ok::<(), Infallible>(()) = diffusion.draw_row(frame, at, lights(row));
            }
        }
    };
    let (mut by_runs, mut packed) = (new(), new());
    draw(&mut by_runs, false);
    draw(&mut packed, true);
    assert_eq!(by_runs.memory(), packed.memory());
}

#[test]
#[rustfmt::skip]
fn a_ramp_looks_like_this() {
    let ramp: Vec<u16> = (0..32).map(|column| column * 2114).collect();
    let signs = codes::<SierraLite>(&vec![ramp; 8], &[0, u16::MAX], Scan::Serpentine)
        .iter()
        .map(|row| row.iter().map(|&code| if code == 1 { '#' } else { '.' }).collect::<String>())
        .collect::<Vec<_>>();
    assert_eq!(signs, [
        ".........#..#.#.#.#.############",
        ".......#...#..#.#.##.#.#.#.#####",
        "....#....#..#.#.#.#.############",
        ".....#..#..#..#.#.##.#.#.##.####",
        ".......#..#..#.#.#.##.##########",
        "...........#.#.#.#.#.##.##.#####",
        "...#..#.#.#..#.#.##.##.##.######",
        "............#..#.#.##.######.###",
    ]);
}

#[test]
fn black_and_white_are_pure() {
    each_kernel!(pure());
}

fn pure<K: Kernel>(_: Drawn) {
    for scan in [Scan::Serpentine, Scan::Raster] {
        for levels in [&[0, u16::MAX][..], &[300, 40_000, 50_000], &[0, 9, 8000]] {
            let brightest = u8::try_from(levels.len() - 1).expect("few");
            assert_eq!(codes::<K>(&vec![vec![0; 70]; 20], levels, scan), vec![vec![0; 70]; 20]);
            assert_eq!(codes::<K>(&vec![vec![u16::MAX; 70]; 20], levels, scan), vec![vec![brightest; 70]; 20]);
        }
    }
}

#[test]
fn light_is_conserved_to_what_the_last_row_holds() {
    each_kernel!(conserved());
}

/// What is shown differs from what was meant by the errors that are left.
fn conserved<K: Kernel>(drawn: Drawn) {
    if drawn.divisor == 8 {
        return;
    }
    let picture: Vec<Vec<u16>> = (0..50_u16).map(|y| (0..40_u16).map(|x| (x * 1600) ^ (y * 321)).collect()).collect();
    let mut memory = vec![0; Diffusion::<K>::memory_needed(40)];
    let mut diffusion = Diffusion::<K>::new(&mut memory, 40, Levels::SRGB_16).expect("enough");
    let mut frame = Frame::<Gray8, Rows, _>::new(vec![0; 2000], 40, 50).expect("enough");
    for (y, row) in (0..).zip(&picture) {
        let Ok(()) = diffusion.draw_row(&mut frame, Point::new(0, y), lights(row));
    }
    let meant: i64 = picture.iter().flatten().map(|&light| i64::from(light)).sum();
    let shown: i64 = frame.bytes().iter().map(|code| i64::from(Light::from_srgb(code * 17).0)).sum();
    assert_eq!(meant - shown, memory.iter().map(|&error| i64::from(error)).sum::<i64>(), "{drawn:?}");
}

#[test]
fn a_picture_in_bands_is_the_same_picture() {
    let picture: Vec<Vec<u16>> = (0..40_u16).map(|y| (0..90_u16).map(|x| x * 700 + y * 50).collect()).collect();
    let whole = codes::<FloydSteinberg>(&picture, &[0, 20_000, u16::MAX], Scan::Serpentine);
    let mut memory = [0; Diffusion::<FloydSteinberg>::memory_needed(90)];
    let levels = [0, 20_000, u16::MAX];
    let mut diffusion =
        Diffusion::<FloydSteinberg>::new(&mut memory, 90, Levels::new(&levels).expect("rising")).expect("enough");
    for band in 0..5_i32 {
        let mut frame = Frame::<Gray2, Rows, _>::with_array([0; 23 * 8], 90, 8).expect("enough");
        let rows = 8 * usize::try_from(band).expect("positive")..;
        for (y, row) in (0..8).zip(&picture[rows.clone()]) {
            let Ok(()) = diffusion.draw_row(&mut frame, Point::new(0, y), lights(row));
        }
        for (y, row) in (0..8).zip(&whole[rows]) {
            for (x, &code) in (0..90).zip(row) {
                use embedded_graphics::image::GetPixel;
                assert_eq!(frame.pixel(Point::new(x, y)), Some(Gray2::new(code)), "{x} {y} of band {band}");
            }
        }
    }
}

#[test]
fn too_little_memory_is_refused() {
    each_kernel!(refused());
}

fn refused<K: Kernel>(_: Drawn) {
    for width in [0, 1, 64, 1000] {
        let needed = Diffusion::<K>::memory_needed(width);
        let error = Diffusion::<K>::new(&mut vec![0; needed - 1], width, Levels::ONE_BIT).map(|_| ()).unwrap_err();
        assert_eq!(error, TooShort { needed });
        assert_eq!(error.to_string(), format!("{needed} elements are needed"));
        assert!(Diffusion::<K>::new(&mut vec![0; needed], width, Levels::ONE_BIT).is_ok());
    }
    assert!(Diffusion::<K>::new(&mut [], u32::MAX, Levels::ONE_BIT).is_err());
}

#[test]
fn rows_of_other_lengths_do_no_harm() {
    each_kernel!(odd_lengths());
}

fn odd_lengths<K: Kernel>(_: Drawn) {
    let mut memory = vec![0; Diffusion::<K>::memory_needed(10)];
    let mut diffusion = Diffusion::<K>::new(&mut memory, 10, Levels::ONE_BIT).expect("enough");
    let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 32], 16, 16).expect("enough");
    for length in [0, 1, 2, 3, 9, 10, 11, 100, 5, 0, 7] {
        let at = Point::new(i32::MAX - 3, i32::MIN);
        let Ok(()) = diffusion.draw_row(&mut frame, at, lights(&vec![40_000; length]));
        let Ok(()) = diffusion.draw_row(&mut frame, Point::new(-3, 2), lights(&vec![u16::MAX; length]));
    }
    // Beyond ten columns nothing was drawn.
    assert!(frame.bytes().chunks(2).all(|row| row[0] & 1 == 0 && row[1] == 0));
    diffusion.restart();
    let Ok(()) = diffusion.draw_row(&mut frame, Point::zero(), lights(&[0; 10]));
    assert_eq!(memory.iter().filter(|&&error| error != 0).count(), 0);
}
