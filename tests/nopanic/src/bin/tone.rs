//! Colour systems, gamma, filters, coverage and light.
#![no_std]
#![no_main]

use aquatint::{
    Alpha, BlendMode, Chromaticity, ColourMatrix, Coverage, CoverageCurve, Covered, Gamma, Gamut, Hls, Hsv, Light,
    PanelRange, Rgb332, Xyz, YCbCr,
    tone::{gamma, luma},
};
use embedded_graphics::{
    pixelcolor::{Rgb565, Rgb888},
    prelude::*,
};
use nopanic::{any, keep, one_of, some};

/// What a caller lends.
struct Memory {
    coverages: [Coverage; 8],
    gamma: Option<Gamma>,
}

const MEMORY: Memory = Memory { coverages: [Coverage::NONE; 8], gamma: None };

nopanic::entries! { MEMORY;
    light,
    gamma,
    gamma_new,
    panel_range,
    coverage,
    covered,
    blend_mode,
    hls,
    hsv,
    luma,
    y_cb_cr,
    rgb332,
    xyz,
    chromaticity,
    gamut,
    colour_matrix,
    colour_matrix_then,
    colour_matrix_saturation,
    colour_matrix_hue_rotation,
    colour_matrix_sepia,
    colour_matrix_contrast,
    colour_matrix_apply,
}

fn light(_: &mut Memory) {
    let light = any::<Light>();
    keep((Light::from_srgb(any()), Light::from_srgb_colour(any()), light.to_srgb(), light.to_naive_code()));
    keep(Light::naive_from_code(any()));
}

fn gamma(_: &mut Memory) {
    let gamma = one_of(&[&gamma::NTSC, &gamma::HDTV, &gamma::PAL]);
    keep((gamma.decode(any()), gamma.encode(any())));
}

fn gamma_new(memory: &mut Memory) {
    let gamma = memory.gamma.insert(Gamma::new(any(), any()));
    keep(gamma.encode(any()));
}

fn panel_range(_: &mut Memory) {
    if let Ok(range) = PanelRange::new(any(), any()) {
        keep((range.to_panel(any()), range.from_panel(any())));
    }
}

fn coverage(_: &mut Memory) {
    let coverage = any::<Coverage>();
    keep((coverage.parts(), coverage.to_byte(), Coverage::from_byte(any()), coverage.of(any()), coverage.inverted()));
    keep((CoverageCurve::bolder(any()).bend(coverage), CoverageCurve::thinner(any()).bend(coverage)));
}

fn covered(memory: &mut Memory) {
    let covered = if any() { Covered::Each(some(&mut memory.coverages)) } else { Covered::Evenly(any()) };
    keep(covered.at(any()));
}

fn blend_mode(_: &mut Memory) {
    let mode = one_of(&[BlendMode::Over, BlendMode::Add, BlendMode::Multiply, BlendMode::Lighten]);
    keep((mode.mix(any(), any(), any()), Alpha::new(any::<Light>(), any())));
}

fn hls(_: &mut Memory) {
    keep((Hls::from_rgb(any()), Hls { hue: any(), lightness: any(), saturation: any() }.to_rgb()));
}

fn hsv(_: &mut Memory) {
    keep((Hsv::from_rgb(any()), Hsv { hue: any(), saturation: any(), value: any() }.to_rgb()));
}

fn standard() -> luma::Standard {
    one_of(&[luma::Standard::Bt601, luma::Standard::Bt709])
}

fn luma(_: &mut Memory) {
    keep((standard().luma(any()), luma::naive_grey(any())));
}

fn y_cb_cr(_: &mut Memory) {
    keep(YCbCr::from_rgb(any(), standard()));
    keep(YCbCr { y: any(), cb: any(), cr: any() }.to_rgb(standard()));
}

fn rgb332(_: &mut Memory) {
    let color = Rgb332::new(any(), any(), any());
    keep((color.r(), color.g(), color.b(), Rgb888::from(color), Rgb565::from(color)));
    keep((Rgb332::from(Rgb565::from(color)), Rgb332::from(Rgb888::from(color))));
}

fn xyz(_: &mut Memory) {
    keep(Xyz::from_linear(any()).chromaticity());
    let xyz = Xyz { x: any(), y: any(), z: any() };
    keep((xyz.to_linear(), xyz.chromaticity()));
}

fn chromaticity(_: &mut Memory) {
    keep(Chromaticity::from_ten_thousandths(any(), any()).with_luminance(any()));
}

fn gamut(_: &mut Memory) {
    let corner = || Chromaticity { x: any(), y: any() };
    keep(Gamut { primaries: [corner(), corner(), corner()] }.contains(corner()));
}

fn matrix() -> ColourMatrix {
    ColourMatrix::from_parts(any(), any())
}

fn colour_matrix(_: &mut Memory) {
    let matrix = matrix().with_scale_and_bias(any(), any());
    keep((*matrix.rows(), matrix.bias(), ColourMatrix::from_rows(any())));
}

fn colour_matrix_then(_: &mut Memory) {
    keep(matrix().then(&matrix()));
}

fn colour_matrix_saturation(_: &mut Memory) {
    keep(ColourMatrix::saturation(any()));
}

fn colour_matrix_hue_rotation(_: &mut Memory) {
    keep(ColourMatrix::hue_rotation(any()));
}

fn colour_matrix_sepia(_: &mut Memory) {
    keep(ColourMatrix::sepia(any()));
}

fn colour_matrix_contrast(_: &mut Memory) {
    keep(ColourMatrix::brightness(any()));
    keep(ColourMatrix::contrast(any()));
}

fn colour_matrix_apply(_: &mut Memory) {
    let matrix = matrix();
    keep((matrix.apply(any::<[Light; 3]>()), matrix.apply(any::<[u8; 3]>())));
    keep((matrix.apply_rgba(any::<[u16; 4]>()), matrix.apply_rgba(any::<[u8; 4]>())));
}
