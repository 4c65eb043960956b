//! How near a dithered photograph comes to the photograph, for the eye.

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

use crate::{
    eye::hpsnr,
    photo::{self, SIDE},
};

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
