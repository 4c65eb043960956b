//! Colour systems, gamma, filters, coverage and light.
#![no_std]
#![no_main]

use core::hint::black_box;

use aquatint::{
    Alpha, BlendMode, Chromaticity, ColourMatrix, Coverage, CoverageCurve, Covered, Gamma, Gamut, Hls, Hsv, Light,
    PanelRange, Rgb332, Xyz, YCbCr,
    tone::{gamma, luma},
};
use embedded_graphics::{
    pixelcolor::{Rgb565, Rgb888},
    prelude::*,
};
use nopanic::{any, keep, part};

#[cortex_m_rt::entry]
fn main() -> ! {
    light();
    coverage();
    systems();
    xyz();
    matrices();
    loop {}
}

fn light() {
    let light = any::<Light>();
    keep((Light::from_srgb(any()), Light::from_srgb_colour(any()), light.to_srgb(), light.to_naive_code()));
    keep(Light::naive_from_code(any()));
    for gamma in [&gamma::NTSC, &gamma::HDTV, &gamma::PAL] {
        let gamma = black_box(gamma);
        keep((gamma.decode(any()), gamma.encode(any())));
    }
    keep(Gamma::new(any(), any()).encode(any()));
    if let Ok(range) = PanelRange::new(any(), any()) {
        keep((range.to_panel(any()), range.from_panel(any())));
    }
}

fn coverage() {
    let coverage = Coverage::new(any());
    keep((coverage.parts(), coverage.to_byte(), Coverage::from_byte(any()), coverage.of(any()), coverage.inverted()));
    keep((CoverageCurve::bolder(any()).bend(coverage), CoverageCurve::thinner(any()).bend(coverage)));
    keep(black_box(Covered::Each(part(&[coverage; 8]))).at(any()));
    keep(black_box(BlendMode::Over).mix(any(), any(), coverage));
    keep(Alpha::new(any::<Light>(), coverage));
}

fn systems() {
    let rgb = any::<[u8; 3]>();
    keep((Hls::from_rgb(rgb), Hls { hue: any(), lightness: any(), saturation: any() }.to_rgb()));
    keep((Hsv::from_rgb(rgb), Hsv { hue: any(), saturation: any(), value: any() }.to_rgb()));
    let standard = black_box(luma::Standard::Bt601);
    keep((standard.luma(rgb), luma::naive_grey(rgb), YCbCr::from_rgb(rgb, standard)));
    keep(YCbCr { y: any(), cb: any(), cr: any() }.to_rgb(standard));
    let color = Rgb332::new(any(), any(), any());
    keep((color.r(), color.g(), color.b(), Rgb888::from(color), Rgb565::from(color)));
    keep((Rgb332::from(Rgb565::from(color)), Rgb332::from(Rgb888::from(color))));
}

fn xyz() {
    keep(Xyz::from_linear(any()).chromaticity());
    let xyz = Xyz { x: any(), y: any(), z: any() };
    keep((xyz.to_linear(), xyz.chromaticity()));
    let place = Chromaticity::from_ten_thousandths(any(), any());
    let corner = || Chromaticity { x: any(), y: any() };
    keep((place.with_luminance(any()), Gamut { primaries: [corner(), corner(), corner()] }.contains(place)));
}

fn matrices() {
    let matrix = ColourMatrix::from_parts(any(), any()).with_scale_and_bias(any(), any());
    let matrix = matrix.then(&ColourMatrix::from_rows(any())).then(&ColourMatrix::saturation(any()));
    let matrix = matrix.then(&ColourMatrix::hue_rotation(any())).then(&ColourMatrix::sepia(any()));
    let matrix = matrix.then(&ColourMatrix::brightness(any())).then(&ColourMatrix::contrast(any()));
    keep((*matrix.rows(), matrix.bias(), matrix.apply(any::<[Light; 3]>()), matrix.apply(any::<[u8; 3]>())));
    keep((matrix.apply_rgba(any::<[u16; 4]>()), matrix.apply_rgba(any::<[u8; 4]>())));
}
