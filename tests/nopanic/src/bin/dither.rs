//! From light to codes: dithering, halftones, diffusion, inks, scaling and font sheets.
#![no_std]
#![no_main]

use core::{convert::Infallible, hint::black_box};

use aquatint::{
    AlongCurve, BAYER_2X2, BAYER_4X4, BAYER_8X8, BAYER_16X16, BLUE_NOISE_16, BLUE_NOISE_64, ChannelLevels, Code,
    CodeMask, Diffusion, Dithered, DitheredDrawTarget, DotGain, FourColor, Frame, FrameRateControl, GlyphSheet,
    Hilbert, InkMix, Interleaved, Levels, Light, Pages, Palette, R2Noise, RankMask, Rgb332, Rows, Scaler, SevenColor,
    SixColor, Target, ThreeColor, Window,
    display::{
        diffuse::{
            Atkinson, Burkes, Carry, FloydSteinberg, JarvisJudiceNinke, Kernel, Riemersma, Scan, Sierra, SierraLite,
            Stucki,
        },
        dither::{self, Mask, Method, Quantise},
        halftone,
        layout::Layout,
        palette::{NOMINAL_4, NOMINAL_7, NOMINAL_RED, SPECTRA_6},
        scale::Filter,
    },
};
use embedded_graphics::{
    mono_font::{MonoFont, ascii::FONT_6X10},
    pixelcolor::{BinaryColor, Gray2, Gray4, Gray8, Rgb565, Rgb888},
    prelude::*,
    text::Baseline,
};
use nopanic::{any, keep, lent, part, text};

#[cortex_m_rt::entry]
fn main() -> ! {
    targets::<BinaryColor, Rows>(Levels::ONE_BIT);
    targets::<BinaryColor, Pages>(Levels::ONE_BIT);
    targets::<Gray4, Rows>(Levels::SRGB_16);
    masks();
    more_masks();
    codes();
    colours();
    diffusions();
    curves();
    scale();
    sheets();
    loop {}
}

type Lent<'a, C, L> = Frame<C, L, &'a mut [u8]>;

/// What is in all ways of drawing the same.
#[inline(never)]
fn targets<C: Code, L: Layout<C>>(levels: Levels<'_>) {
    let mut bytes = [0; 512];
    let Ok(mut frame) = Lent::<C, L>::new(lent(&mut bytes), any(), any()) else { return };
    dithered::<C, _>(&mut frame, levels, black_box(Method::Ordered4x4));
    dithered::<C, _>(&mut frame, levels, &BAYER_8X8);
    dithered::<C, _>(&mut frame, levels, R2Noise);
    dithered::<C, _>(&mut Window::band(&mut frame, any()), levels, black_box(Method::Nearest));
    if let Ok(frames) = FrameRateControl::new(any(), any()) {
        dithered::<C, _>(&mut frame, levels, frames);
    }
    let mut fields = Interleaved::new(&mut frame, BAYER_4X4, any(), any());
    dithered::<C, _>(&mut fields, levels, black_box(Method::Ordered4x4));
    let color = C::from_code(any());
    let Ok(()) = fields.draw_iter([Pixel(any(), color)]);
    let Ok(()) = fields.fill_solid(&any(), color);
    let Ok(()) = fields.fill_contiguous(&any(), core::iter::repeat(color));
}

fn dithered<C: Code, T>(target: &mut T, levels: Levels<'_>, mask: impl Mask)
where
    T: Target<Color = C, Error = Infallible> + DrawTarget<Color = C, Error = Infallible>,
{
    let mut light = Dithered::new(target, levels).with_method(mask);
    let Ok(()) = light.fill_area(any(), any());
    let Ok(()) = light.fill_run(any(), any()..any(), [any::<Light>()]);
    let Ok(()) = light.fill_run(any(), any()..any(), any::<[Light; 8]>());
    let Ok(()) = light.write_run(any(), any()..any(), core::iter::repeat_with(|| Some(any())));
    let Ok(()) = light.write_all(any(), any()..any(), core::iter::repeat_with(any::<Light>));
    let Ok(()) = light.set(any(), any(), any());
    let Ok(()) = light.fill_bits(any(), any()..any(), any(), any());
    let Ok(()) = light.write_bits(any(), any()..any(), any(), any::<u8>);
    let Ok(()) = light.fill_tile(any(), &any());
    let mut grey = light.into_draw_target::<Gray8>();
    let Ok(()) = grey.draw_iter([Pixel(any(), Gray8::new(any()))]);
    let Ok(()) = grey.fill_solid(&any(), Gray8::new(any()));
    let Ok(()) = grey.fill_contiguous(&any(), core::iter::repeat_with(|| Gray8::new(any())));
}

/// Of any mask: one cell, one row, eight cells.
fn asked(mask: &impl Mask) {
    keep((mask.threshold(any(), any()), mask.eight(any()), mask.row(any(), any()).next()));
    keep(mask.row(any(), any()).nth(any()));
}

fn masks() {
    asked(black_box(&BAYER_2X2));
    asked(black_box(&BAYER_4X4));
    asked(black_box(&BAYER_16X16));
    asked(black_box(&BLUE_NOISE_16));
    asked(black_box(&BLUE_NOISE_64));
    asked(black_box(&dither::HATCH_8X8));
    asked(black_box(&dither::CROSS_HATCH_16X16));
    asked(black_box(&halftone::DOTS_45_6X6));
    asked(black_box(&halftone::LINES_45_8X8));
    asked(&black_box(Method::Ordered4x4));
    asked(&R2Noise);
}

fn more_masks() {
    let ranks = [0; 64];
    if let Ok(mask) = RankMask::<5, 3>::new(part(&ranks)) {
        asked(&mask);
    }
    if let Ok(mask) = DotGain::new(BAYER_4X4, any()) {
        asked(&mask);
    }
    let lights = [0; 32];
    if let Ok(levels) = Levels::new(part(&lights)) {
        keep(levels.light(any()));
        targets::<Gray2, Rows>(levels);
    }
}

fn codes() {
    static MASK: CodeMask<8, 8> = CodeMask::srgb(&BAYER_8X8);
    let (codes, mut bytes) = ([0; 64], [0; 64]);
    let Ok(mut frame) = Lent::<BinaryColor, Rows>::new(lent(&mut bytes), any(), any()) else { return };
    for mask in [MASK, CodeMask::naive(&BAYER_8X8), CodeMask::of_mask(&R2Noise, &any())] {
        mask.write_rows(&mut frame, any(), part(&codes));
        keep((mask.write_run(&mut frame, any(), part(&codes)), mask.switch_codes()[0]));
    }
    CodeMask::with_curve(&DOTS, &any()).write_rows(&mut frame, any(), part(&codes));
}

const DOTS: RankMask<'static, 6, 6> = halftone::DOTS_6X6;

fn colours() {
    quantised::<Rgb332, _, Rgb888>(ChannelLevels::<Rgb888>::srgb::<Rgb332>(), rgb);
    quantised::<ThreeColor, _, Rgb888>(InkMix::new(&NOMINAL_RED), rgb);
    quantised::<FourColor, _, Rgb888>(InkMix::new(&NOMINAL_4), rgb);
    quantised::<SixColor, _, Rgb888>(InkMix::new(&SPECTRA_6), rgb);
    quantised::<SevenColor, _, Rgb565>(InkMix::new(&NOMINAL_7), || rgb().into());
    let palette = Palette::new([(SixColor::Black, any()), (SixColor::White, any()), (SixColor::Red, any())]);
    quantised::<SixColor, _, Rgb888>(InkMix::new(&palette), rgb);
}

fn rgb() -> Rgb888 {
    Rgb888::new(any(), any(), any())
}

fn quantised<C: Code, Q: Quantise<C, From = S>, S: PixelColor>(quantiser: Q, color: fn() -> S)
where
    Rows: Layout<C>,
{
    let mut bytes = [0; 64];
    let Ok(mut frame) = Lent::<C, Rows>::new(lent(&mut bytes), any(), any()) else { return };
    let mut display = DitheredDrawTarget::new(&mut frame, quantiser, BLUE_NOISE_16);
    let Ok(()) = display.draw_iter([Pixel(any(), color())]);
    let Ok(()) = display.fill_solid(&any(), color());
    let Ok(()) = display.fill_contiguous(&any(), core::iter::repeat_with(color));
}

fn diffusions() {
    diffused::<FloydSteinberg>();
    diffused::<SierraLite>();
    diffused::<Sierra>();
    diffused::<Burkes>();
    diffused::<JarvisJudiceNinke>();
    diffused::<Stucki>();
    diffused::<Atkinson>();
}

fn diffused<K: Kernel>() {
    let (mut bits, mut greys, photo, mut memory) = ([0; 64], [0; 64], [0; 64], [0; 64]);
    let Ok(mut bits) = Lent::<BinaryColor, Rows>::new(lent(&mut bits), any(), any()) else { return };
    let Ok(mut greys) = Lent::<Gray4, Rows>::new(lent(&mut greys), any(), any()) else { return };
    let Ok(photo) = Frame::<Gray8, Rows, _>::with_slice(part(&photo), any(), any()) else { return };
    keep(Diffusion::<K>::memory_needed(any()));
    let Ok(diffusion) = Diffusion::<K>::new(lent(&mut memory), any(), Levels::SRGB_16) else { return };
    let mut diffusion = diffusion.with_scan(black_box(Scan::Serpentine));
    let lights = [any::<Light>(); 16];
    let Ok(()) = diffusion.draw_row(&mut bits, any(), part(&lights).iter().copied());
    let Ok(()) = diffusion.draw_row(&mut greys, any(), part(&lights).iter().copied());
    diffusion.draw_packed_row(&mut bits, any(), part(&lights).iter().copied());
    diffusion.restart();
    let Ok(()) = diffusion.draw_picture(&mut greys, any(), &photo);
    let mut cells = [0; 64];
    if let Ok(mut scaler) = Scaler::new(lent(&mut cells), any(), any(), black_box(Filter::Area)) {
        let Ok(()) = diffusion.draw_scaled(&mut greys, any(), (&photo, &mut scaler));
    }
}

fn curves() {
    let mut bytes = [0; 64];
    let Ok(mut frame) = Lent::<Gray4, Rows>::new(lent(&mut bytes), any(), any()) else { return };
    let Ok(()) = AlongCurve::<Riemersma>::new(Levels::SRGB_16).draw(&mut frame, any(), |_| any());
    let Ok(()) = AlongCurve::<Carry>::new(Levels::SRGB_16).draw(&mut frame, any(), |_| any());
    Hilbert::new(any()).for_each(keep);
}

fn scale() {
    let (mut cells, lights) = ([0; 64], [any::<Light>(); 16]);
    keep(Scaler::memory_needed(any()));
    let Ok(mut scaler) = Scaler::new(lent(&mut cells), any(), any(), black_box(Filter::Area)) else { return };
    scaler.restart();
    let Ok(()) = scaler.push(part(&lights).iter().copied(), |row, lights| {
        keep((row, lights.len()));
        lights.clone().rev().for_each(keep);
        lights.for_each(keep);
        Ok::<(), Infallible>(())
    });
    keep((scaler.from(), scaler.to()));
}

fn sheets() {
    let (mut memory, mut bytes) = ([0; 1024], [0; 64]);
    let font: &MonoFont = &FONT_6X10;
    let Ok(sheet) = GlyphSheet::<Rows, _>::load(font, lent(&mut memory)) else { return };
    let sheet = sheet.with_baseline(black_box(Baseline::Top));
    let Ok(mut frame) = Lent::<Gray4, Rows>::new(lent(&mut bytes), any(), any()) else { return };
    keep((sheet.draw(&mut frame, text(), any(), Gray4::new(any())), sheet.glyph(any()).is_some()));
    keep(GlyphSheet::<Pages, ()>::bytes_needed(black_box(font)));
}
