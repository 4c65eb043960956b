//! How near a blurred picture comes to the true one, for the eye.
//!
//! The scene is slanted bars and discs that move to the right. How long a pixel's centre is covered is computed in
//! floating point from the shapes, not from sub-frames.

use aquatint::{
    BAYER_4X4, Dithered, Exposure, FillStyle, Frame, Interleaved, IntoLight, Levels, Light, Oval, Point2, Polygon,
    Rows, Subpixel, Words,
};
use embedded_graphics::{image::GetPixel, pixelcolor::BinaryColor, prelude::*};

use crate::eye::hpsnr;

type Picture = Frame<BinaryColor, Rows, Vec<u8>>;
type Sum = Frame<Light, Words, Vec<u8>>;

/// In sixteenths of a pixel: left end of the lower border, upper border, width, height, and how far the upper border
/// lies to the right of the lower one.
const BARS: [[i32; 5]; 6] = [
    [203, 117, 371, 900, 207],
    [1003, 211, 67, 1203, 603],
    [2009, 305, 611, 507, -93],
    [307, 1501, 19, 1407, 111],
    [3203, 105, 33, 1301, 301],
    [2203, 3101, 1313, 203, 51],
];
/// Centre and radius.
const DISCS: [[i32; 3]; 5] =
    [[1301, 2307, 402], [2501, 1703, 207], [3301, 2209, 113], [2311, 2403, 61], [1009, 3507, 307]];

fn empty() -> Picture {
    Frame::new(vec![0; 32 * 256], 256, 256).expect("enough")
}

/// Draws the scene moved by some sixteenths of a pixel.
fn draw<D: DrawTarget<Color = BinaryColor>>(display: &mut D, moved: i32) -> Result<(), D::Error> {
    display.clear(BinaryColor::Off)?;
    let style = FillStyle::new(BinaryColor::On);
    for [x, y, width, height, slant] in BARS.map(|[x, rest @ ..]| [x + moved, rest[0], rest[1], rest[2], rest[3]]) {
        let corners = [(x + slant, y), (x + slant + width, y), (x + width, y + height), (x, y + height)];
        let corners = corners.map(|(x, y)| Point2::from_sixteenths(x, y));
        Polygon::new(&[&corners]).expect("in range").into_styled(style).draw(display)?;
    }
    for [x, y, radius] in DISCS {
        let disc = Oval::circle(Point2::from_sixteenths(x + moved, y), Subpixel::from_bits(radius));
        disc.expect("in range").into_styled(style).draw(display)?;
    }
    Ok(())
}

/// From where to where a shape reaches at this height, if it does, before it moves.
fn reaches(y: f64) -> impl Iterator<Item = (f64, f64)> {
    let bars = BARS.into_iter().filter_map(move |bar| {
        let [left, top, width, height, slant] = bar.map(|sixteenths| f64::from(sixteenths) / 16.0);
        let down = (y - top) / height;
        let left = left + slant * (1.0 - down);
        (0.0..1.0).contains(&down).then_some((left, left + width))
    });
    let discs = DISCS.into_iter().filter_map(move |disc| {
        let [x, middle, radius] = disc.map(|sixteenths| f64::from(sixteenths) / 16.0);
        let half = (radius.powi(2) - (y - middle).powi(2)).sqrt();
        (half > 0.0).then_some((x - half, x + half))
    });
    bars.chain(discs)
}

/// A sub-frame with smooth edges: how much of each pixel's width is covered, of the scene moved by some pixels.
struct Smooth(Vec<f64>);

impl Smooth {
    fn new(moved: f64) -> Self {
        let mut covered = vec![0.0; 256 * 256];
        for (y, row) in (0_u16..).zip(covered.chunks_mut(256)) {
            let spans: Vec<_> =
                reaches(f64::from(y) + 0.5).map(|(left, right)| (left + moved, right + moved)).collect();
            for (x, covered) in (0_u16..).map(f64::from).zip(row) {
                *covered = spans.iter().map(|(left, right)| (right.min(x + 1.0) - left.max(x)).max(0.0)).sum();
            }
        }
        Self(covered)
    }
}

impl GetPixel for Smooth {
    type Color = Light;

    fn pixel(&self, Point { x, y }: Point) -> Option<Light> {
        let covered = self.0.get(usize::try_from(256 * y + x).expect("inside"))?;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 65535")]
        Some(Light((covered * 65_535.0).round() as u16))
    }
}

/// The mean of 256 sub-frames.
fn ideal_of_smooth(pixels: f64) -> Vec<f64> {
    let mut mean = vec![0.0; 256 * 256];
    for i in 0..256 {
        let Smooth(covered) = Smooth::new(pixels * (f64::from(i) + 0.5) / 256.0);
        mean.iter_mut().zip(covered).for_each(|(mean, covered)| *mean += covered / 256.0);
    }
    mean
}

fn exposed_smooth(pixels: f64, n: u16) -> Sum {
    let mut sum = Frame::new(vec![0; 256 * 512], 256, 256).expect("enough");
    let mut exposure = Exposure::new(&mut sum, n).expect("1 to 256");
    for i in 0..n {
        let instant = Smooth::new(pixels * (f64::from(i) + 0.5) / f64::from(n));
        let Ok(()) = exposure.add(&instant, core::convert::identity);
    }
    sum
}

/// How much of the time each pixel's centre is covered.
fn ideal(pixels: i32) -> Vec<f64> {
    let covered = |at: Point| {
        let (x, y) = (f64::from(at.x) + 0.5, f64::from(at.y) + 0.5);
        let time = |edge: f64| ((x - edge) / f64::from(pixels)).clamp(0.0, 1.0);
        reaches(y).map(|(left, right)| time(left) - time(right)).sum()
    };
    empty().bounding_box().points().map(covered).collect()
}

/// Sixteenths of a pixel that the scene has moved at (i + ½) / n of the frame.
fn moved(pixels: i32, (i, n): (u16, u16)) -> i32 {
    16 * pixels * (2 * i32::from(i) + 1) / (2 * i32::from(n))
}

fn exposed(pixels: i32, n: u16) -> Sum {
    let mut sum = Frame::new(vec![0; 256 * 512], 256, 256).expect("enough");
    let mut exposure = Exposure::new(&mut sum, n).expect("1 to 256");
    let mut instant = empty();
    for i in 0..n {
        let Ok(()) = draw(&mut instant, moved(pixels, (i, n)));
        let Ok(()) = exposure.add(&instant, IntoLight::into_light);
    }
    sum
}

/// An exposure on one bit, by 4 × 4.
fn dithered(pixels: i32, n: u16) -> Picture {
    let (mut screen, mut sum) = (empty(), exposed(pixels, n));
    // An exposure of one sub-frame is that sub-frame.
    let copy = sum.clone();
    let mut exposure = Exposure::new(&mut sum, 1).expect("1 to 256");
    let Ok(()) = exposure.add(&copy, core::convert::identity);
    let Ok(()) = exposure.show(&mut Dithered::new(&mut screen, Levels::ONE_BIT));
    screen
}

/// The same by the ranks.
fn interleaved(pixels: i32) -> Picture {
    let mut screen = empty();
    for i in 0..16 {
        let Ok(()) = draw(&mut Interleaved::new(&mut screen, BAYER_4X4, i, 16), moved(pixels, (i, 16)));
    }
    screen
}

/// Decibels below white of what the eye sees of the error.
fn score<P: GetPixel + OriginDimensions>(ideal: &[f64], shown: &P, light: impl Fn(P::Color) -> Light) -> f64 {
    let lights = shown.bounding_box().points().map(|at| light(shown.pixel(at).expect("inside")));
    let errors = ideal.iter().zip(lights).map(|(ideal, light)| f64::from(light.0) / 65_535.0 - ideal);
    hpsnr(&errors.collect::<Vec<_>>())
}

#[test]
fn subframes_by_the_pixels_moved_are_enough() {
    // Of 1, 2, 4, 8 sub-frames.
    for (pixels, least) in
        [(4, [40.0, 54.5, 66.5, 78.0]), (8, [31.3, 44.8, 59.9, 71.9]), (16, [24.8, 34.6, 49.1, 65.7])]
    {
        let ideal = ideal_of_smooth(pixels.into());
        let scores = [1, 2, 4, 8].map(|n| score(&ideal, &exposed_smooth(pixels.into(), n), core::convert::identity));
        println!("{pixels} pixels a frame: {scores:.1?}");
        for (score, least) in scores.into_iter().zip(least) {
            assert!((least..least + 1.0).contains(&score), "{pixels} pixels a frame: {score:.2} of {least}");
        }
    }
}

#[test]
fn the_mean_of_codes_is_not_that_of_light() {
    let ideal = ideal_of_smooth(8.0);
    let mut codes = vec![0_u32; 256 * 256];
    for i in 0..8 {
        let smooth = Smooth::new(f64::from(i) + 0.5);
        let points = empty().bounding_box().points();
        codes
            .iter_mut()
            .zip(points)
            .for_each(|(sum, at)| *sum += u32::from(smooth.pixel(at).expect("inside").to_srgb()));
    }
    let errors = ideal.iter().zip(codes).map(|(ideal, sum)| {
        let shown = Light::from_srgb(u8::try_from(sum / 8).expect("a mean of codes"));
        f64::from(shown.0) / 65_535.0 - ideal
    });
    let score = hpsnr(&errors.collect::<Vec<_>>());
    assert!((26.0..32.0).contains(&score), "{score:.2}");
}

#[test]
fn sharp_subframes_end_at_fifty_decibels() {
    let ideal = ideal(8);
    for (n, least) in [(4, 48.8), (8, 49.5), (16, 50.2)] {
        let score = score(&ideal, &exposed(8, n), core::convert::identity);
        assert!((least..least + 1.0).contains(&score), "{n} sub-frames: {score:.2} of {least}");
    }
}

#[test]
fn on_one_bit_instants_come_near_to_eight_subframes() {
    for (pixels, least, behind) in [(4, 41.3, 1.3), (8, 40.4, 2.1), (16, 36.2, 3.1)] {
        let ideal = ideal(pixels);
        let of = |picture: &Picture| score(&ideal, picture, IntoLight::into_light);
        let [sharp, four, eight, many] = [1, 4, 8, 64].map(|n| of(&dithered(pixels, n)));
        let instants = of(&interleaved(pixels));
        println!(
            "{pixels} pixels a frame, one bit: sharp {sharp:.1}, 4 sub-frames {four:.1}, 8 {eight:.1}, 64 {many:.1}, \
             16 instants {instants:.1}"
        );
        assert!(instants >= least && instants >= eight - behind && instants > sharp + 2.0, "{pixels}: {instants:.2}");
        // More sub-frames than eight are lost in the noise of the dither.
        assert!((38.5..43.5).contains(&eight) && (many - eight).abs() < 1.0, "{eight:.2}, {many:.2}");
    }
}
