//! How near a dithered photograph comes to the photograph, for the eye.
//!
//! The error is filtered as the eye filters (R. Näsänen, "Visibility of halftone dot textures", IEEE
//! Trans. SMC 14(6), 1984) at 45 pixels a degree, that is 160 dpi at 40 cm, and told as a ratio to white.

use core::f64::consts::TAU;

use aquatint::{
    Dithered, Frame, Levels, Light, Rows, Target,
    display::diffuse::{
        AlongCurve, Atkinson, Burkes, Carry, Diffusion, FloydSteinberg, History, JarvisJudiceNinke, Kernel, Riemersma,
        Scan, SierraLite,
    },
};
use embedded_graphics::{
    geometry::{Dimensions, Point},
    image::GetPixel,
    pixelcolor::BinaryColor,
};

use crate::photo::{self, SIDE};

type Complex = (f64, f64);

/// In place; the length is a power of two.
fn fourier(values: &mut [Complex]) {
    if values.len() < 2 {
        return;
    }
    let (mut even, mut odd): (Vec<_>, Vec<_>) = values.chunks(2).map(|two| (two[0], two[1])).unzip();
    fourier(&mut even);
    fourier(&mut odd);
    let half = values.len() / 2;
    for (at, ((a, b), (c, d))) in even.into_iter().zip(odd).enumerate() {
        #[expect(clippy::cast_precision_loss, reason = "small")]
        let (sin, cos) = (-TAU * at as f64 / (2 * half) as f64).sin_cos();
        let (re, im) = (c * cos - d * sin, c * sin + d * cos);
        (values[at], values[at + half]) = ((a + re, b + im), (a - re, b - im));
    }
}

/// Decibels below white of the error that is seen.
fn hpsnr(errors: &[f64]) -> f64 {
    let mut rows: Vec<Vec<Complex>> =
        errors.chunks(SIDE).map(|row| row.iter().map(|&error| (error, 0.0)).collect()).collect();
    for row in &mut rows {
        fourier(row);
    }
    let frequency = |at: usize| f64::from(u16::try_from(at.min(SIDE - at)).expect("small")) / 256.0 * 45.0;
    let mut sum = 0.0;
    for x in 0..SIDE {
        let mut column: Vec<Complex> = rows.iter().map(|row| row[x]).collect();
        fourier(&mut column);
        for (y, (re, im)) in column.into_iter().enumerate() {
            let seen = (-frequency(x).hypot(frequency(y)) / (0.525 * 11_f64.ln() + 3.91)).exp();
            sum += (re * re + im * im) * seen * seen;
        }
    }
    let pixels = 65_536.0;
    -10.0 * (sum / pixels / pixels).log10()
}

/// Mean over the photographs of what a method makes of their codes.
fn mean_hpsnr(method: impl Fn(&[u8], &mut Frame<BinaryColor, Rows, Vec<u8>>)) -> f64 {
    let photos = photo::all();
    let score = |codes: &Vec<u8>| {
        let mut frame = Frame::<BinaryColor, Rows, _>::new(vec![0; SIDE * SIDE / 8], 256, 256).expect("enough");
        method(codes, &mut frame);
        let points = (0..256).flat_map(|y| (0..256).map(move |x| Point::new(x, y)));
        let errors = points.zip(codes).map(|(point, &code)| {
            let shown = f64::from(u8::from(frame.pixel(point) == Some(BinaryColor::On)));
            shown - f64::from(Light::from_srgb(code).0) / 65_535.0
        });
        hpsnr(&errors.collect::<Vec<_>>())
    };
    photos.iter().map(score).sum::<f64>() / 4.0
}

fn diffused<K: Kernel>(scan: Scan) -> f64 {
    mean_hpsnr(|codes, frame| {
        let mut memory = vec![0; Diffusion::<K>::memory_needed(256)];
        let mut diffusion = Diffusion::<K>::new(&mut memory, 256, Levels::ONE_BIT).expect("enough").with_scan(scan);
        for (y, row) in (0..).zip(codes.chunks(SIDE)) {
            diffusion.draw_packed_row(frame, Point::new(0, y), row.iter().map(|&code| Light::from_srgb(code)));
        }
    })
}

fn along<H: History>(codes: &[u8], frame: &mut Frame<BinaryColor, Rows, Vec<u8>>) {
    let area = frame.bounding_box();
    let light = |point: Point| {
        Light::from_srgb(
            codes[SIDE * usize::try_from(point.y).expect("inside") + usize::try_from(point.x).expect("inside")],
        )
    };
    let Ok(()) = AlongCurve::<H>::new(Levels::ONE_BIT).draw(frame, area, light);
}

fn ordered(codes: &[u8], frame: &mut Frame<BinaryColor, Rows, Vec<u8>>) {
    let mut dithered = Dithered::new(frame, Levels::ONE_BIT);
    for (y, row) in (0..).zip(codes.chunks(SIDE)) {
        let Ok(()) = dithered.write_run(y, 0..256, row.iter().map(|&code| Some(Light::from_srgb(code))));
    }
}

#[test]
fn diffusion_comes_near_to_the_photograph() {
    let scores = [
        ("Sierra Lite", diffused::<SierraLite>(Scan::Serpentine), 35.8),
        ("Sierra Lite, raster", diffused::<SierraLite>(Scan::Raster), 35.8),
        ("Floyd-Steinberg", diffused::<FloydSteinberg>(Scan::Serpentine), 35.8),
        ("Floyd-Steinberg, raster", diffused::<FloydSteinberg>(Scan::Raster), 35.8),
        ("Burkes", diffused::<Burkes>(Scan::Raster), 34.5),
        ("Jarvis, Judice, Ninke", diffused::<JarvisJudiceNinke>(Scan::Raster), 32.3),
        ("Atkinson", diffused::<Atkinson>(Scan::Raster), 25.0),
        ("Riemersma", mean_hpsnr(along::<Riemersma>), 31.0),
        ("carry along the curve", mean_hpsnr(along::<Carry>), 32.3),
        ("Bayer 4 x 4", mean_hpsnr(ordered), 33.5),
    ];
    println!("{scores:#?}");
    for (name, score, least) in scores {
        assert!(score >= least, "{name}: {score:.2} dB of {least}");
    }
}

#[test]
fn the_measure_tells_good_from_bad() {
    let threshold = mean_hpsnr(|codes, frame| {
        for (y, row) in (0..).zip(codes.chunks(SIDE)) {
            let colors = row.iter().map(|&code| Some(BinaryColor::from(code >= 188)));
            let Ok(()) = frame.write_run(y, 0..256, colors);
        }
    });
    assert!((threshold - 13.7).abs() < 0.2, "{threshold}");
}
