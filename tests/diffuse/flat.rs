//! Flat greys: the mean of what is shown is the light that was meant.

use aquatint::{
    Frame, Levels, Light, Rows,
    display::diffuse::{Diffusion, FloydSteinberg, Kernel, Scan, SierraLite},
};
use embedded_graphics::{geometry::Point, pixelcolor::BinaryColor};

/// Share of white pixels in a square of each of the 256 greys.
fn means<K: Kernel>(side: u32, scan: Scan) -> Vec<f64> {
    let bytes = usize::try_from(side * side / 8).expect("small");
    let mut memory = vec![0; Diffusion::<K>::memory_needed(side)];
    let mut diffusion = Diffusion::<K>::new(&mut memory, side, Levels::ONE_BIT).expect("enough").with_scan(scan);
    let mut frame = Frame::<BinaryColor, Rows, _>::new(vec![0; bytes], side, side).expect("enough");
    let mut mean = |code: u8| {
        diffusion.restart();
        let row = vec![Light::from_srgb(code); usize::try_from(side).expect("small")];
        for y in 0..side.cast_signed() {
            diffusion.draw_packed_row(&mut frame, Point::new(0, y), row.iter().copied());
        }
        let white: u32 = frame.bytes().iter().map(|byte| byte.count_ones()).sum();
        f64::from(white) / f64::from(side * side)
    };
    (0..=255).map(&mut mean).collect()
}

fn worst(means: &[f64]) -> f64 {
    let light = |code: u8| f64::from(Light::from_srgb(code).0) / 65_535.0;
    (0..=255).zip(means).map(|(code, mean)| (mean - light(code)).abs()).fold(0.0, f64::max)
}

/// How far the mean falls at most where the grey rises.
fn largest_drop(means: &[f64]) -> f64 {
    means.windows(2).map(|two| two[0] - two[1]).fold(0.0, f64::max)
}

#[test]
fn floyd_and_steinberg_keep_tone() {
    for scan in [Scan::Serpentine, Scan::Raster] {
        let (small, large) = (means::<FloydSteinberg>(64, scan), means::<FloydSteinberg>(128, scan));
        println!("FS {scan:?}: {} {} drop {}", worst(&small), worst(&large), largest_drop(&small));
        assert!(worst(&small) <= 1.0 / 240.0, "{scan:?} {}", worst(&small));
        assert!(worst(&large) <= 1.0 / 480.0, "{scan:?} {}", worst(&large));
        assert!(largest_drop(&small) <= 0.001, "{scan:?} {}", largest_drop(&small));
    }
}

#[test]
fn sierra_lite_keeps_tone() {
    let (small, large) = (means::<SierraLite>(64, Scan::Serpentine), means::<SierraLite>(128, Scan::Serpentine));
    println!("SL: {} {} drop {}", worst(&small), worst(&large), largest_drop(&small));
    assert!(worst(&small) <= 1.0 / 280.0, "{}", worst(&small));
    assert!(worst(&large) <= 1.0 / 512.0, "{}", worst(&large));
    assert!(largest_drop(&small) <= 0.001, "{}", largest_drop(&small));
}
