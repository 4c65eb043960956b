//! From light to codes: dithering, halftones, inks and font sheets.
#![no_std]
#![no_main]

use core::convert::Infallible;

use aquatint::{
    BAYER_2X2, BAYER_4X4, BAYER_8X8, BAYER_16X16, BLUE_NOISE_16, BLUE_NOISE_64, ChannelLevels, Code, CodeMask,
    Dithered, DitheredDrawTarget, DotGain, FourColor, Frame, FrameRateControl, GlyphSheet, InkMix, Interleaved, Levels,
    Light, Pages, Palette, R2Noise, RankMask, Rgb332, Rows, SevenColor, SixColor, Target, ThreeColor, Window,
    display::{
        dither::{self, Mask, Method, Quantise},
        halftone,
        layout::Layout,
        palette::{NOMINAL_4, NOMINAL_7, NOMINAL_RED, SPECTRA_6},
    },
};
use embedded_graphics::{
    mono_font::{MonoFont, ascii::FONT_6X10},
    pixelcolor::{BinaryColor, Gray2, Gray4, Gray8, Rgb565, Rgb888},
    prelude::*,
    text::Baseline,
};
use nopanic::{any, endless, keep, lent, near, near_rectangle, one_of, part, side, some, text};

/// What a caller lends.
struct Memory {
    bytes: [u8; 2048],
    codes: [u8; 64],
    steps: [u16; 16],
    switches: [u16; 256],
    sheet: [u8; 1024],
    mask: CodeMask<8, 8>,
}

const MEMORY: Memory = Memory {
    bytes: [0; 2048],
    codes: [0; 64],
    steps: [0; 16],
    switches: [0; 256],
    sheet: [0; 1024],
    mask: CodeMask::srgb(&BAYER_8X8),
};

nopanic::entries! { MEMORY;
    fill_area_rows = |memory: &mut Memory| on_rows(memory, fill_area),
    fill_area_pages = |memory: &mut Memory| on_pages(memory, fill_area),
    fill_area_grey = |memory: &mut Memory| on_grey(memory, fill_area),
    fill_run_rows = |memory: &mut Memory| on_rows(memory, fill_run),
    fill_run_pages = |memory: &mut Memory| on_pages(memory, fill_run),
    fill_run_grey = |memory: &mut Memory| on_grey(memory, fill_run),
    write_run_rows = |memory: &mut Memory| on_rows(memory, write_run),
    write_run_pages = |memory: &mut Memory| on_pages(memory, write_run),
    write_run_grey = |memory: &mut Memory| on_grey(memory, write_run),
    set_rows = |memory: &mut Memory| on_rows(memory, set),
    bits_rows = |memory: &mut Memory| on_rows(memory, bits),
    bits_pages = |memory: &mut Memory| on_pages(memory, bits),
    bits_grey = |memory: &mut Memory| on_grey(memory, bits),
    fill_tile_rows = |memory: &mut Memory| on_rows(memory, fill_tile),
    fill_tile_pages = |memory: &mut Memory| on_pages(memory, fill_tile),
    fill_tile_grey = |memory: &mut Memory| on_grey(memory, fill_tile),
    draw_target_rows = |memory: &mut Memory| on_rows(memory, draw_target),
    draw_target_pages = |memory: &mut Memory| on_pages(memory, draw_target),
    draw_target_grey = |memory: &mut Memory| on_grey(memory, draw_target),
    band,
    levels,
    blue_noise,
    r2_noise,
    frame_rate_control,
    interleaved,
    interleaved_draw_target,
    mask_bayer = |_: &mut Memory| asked(&BAYER_16X16),
    mask_blue_noise = |_: &mut Memory| asked(one_of(&[&BLUE_NOISE_64])),
    mask_hatch = |_: &mut Memory| asked(one_of(&[&dither::HATCH_8X8, &halftone::LINES_45_8X8])),
    mask_dots = |_: &mut Memory| asked(one_of(&[&halftone::DOTS_45_6X6, &halftone::DOTS_6X6])),
    mask_method = |_: &mut Memory| asked(&one_of(&[Method::Nearest, Method::Ordered4x4])),
    mask_r2_noise = |_: &mut Memory| asked(&R2Noise),
    mask_dot_gain,
    rank_mask,
    code_mask_write_rows,
    code_mask_write_run,
    code_mask_of_mask,
    code_mask_with_curve,
    rgb332 = |memory: &mut Memory| quantised::<Rgb332, _, Rgb888>(ChannelLevels::srgb::<Rgb332>(), rgb, memory),
    ink_mix_red = |memory: &mut Memory| quantised::<ThreeColor, _, _>(InkMix::new(&NOMINAL_RED), rgb, memory),
    ink_mix_4 = |memory: &mut Memory| quantised::<FourColor, _, _>(InkMix::new(&NOMINAL_4), rgb, memory),
    ink_mix_6 = |memory: &mut Memory| quantised::<SixColor, _, _>(InkMix::new(&SPECTRA_6), rgb, memory),
    ink_mix_7 = |memory: &mut Memory| {
        quantised::<SevenColor, _, Rgb565>(InkMix::new(&NOMINAL_7), || rgb().into(), memory);
    },
    ink_mix_of_palette,
    glyph_sheet_load,
    glyph_sheet_draw,
}

type Lent<'a, C, L> = Frame<C, L, &'a mut [u8]>;

/// On a frame that is dithered by the default method.
fn on<'m, C, L>(bytes: &'m mut [u8], levels: Levels<'static>, call: impl FnOnce(Dithered<'_, 'static, Lent<'m, C, L>>))
where
    C: Code,
    L: Layout<C>,
{
    if let Ok(mut frame) = Lent::<C, L>::new(lent(bytes), side(), side()) {
        call(Dithered::new(&mut frame, levels));
    }
}

fn on_rows<'m>(memory: &'m mut Memory, call: impl FnOnce(Dithered<'_, 'static, Lent<'m, BinaryColor, Rows>>)) {
    on(&mut memory.bytes, Levels::ONE_BIT, call);
}

fn on_pages<'m>(memory: &'m mut Memory, call: impl FnOnce(Dithered<'_, 'static, Lent<'m, BinaryColor, Pages>>)) {
    on(&mut memory.bytes, Levels::ONE_BIT, call);
}

fn on_grey<'m>(memory: &'m mut Memory, call: impl FnOnce(Dithered<'_, 'static, Lent<'m, Gray4, Rows>>)) {
    on(&mut memory.bytes, Levels::SRGB_16, call);
}

fn fill_area<T: Target<Color: Code>, M: Mask>(mut light: Dithered<'_, '_, T, M>) {
    keep(light.fill_area(any(), any()).is_ok());
}

fn fill_run<T: Target<Color: Code>, M: Mask>(mut light: Dithered<'_, '_, T, M>) {
    keep(light.fill_run(any(), any()..any(), [any::<Light>()]).is_ok());
    keep(light.fill_run(any(), any()..any(), any::<[Light; 8]>()).is_ok());
}

fn write_run<T: Target<Color: Code>, M: Mask>(mut light: Dithered<'_, '_, T, M>) {
    keep(light.write_run(any(), near(), endless(|| Some(any()))).is_ok());
    keep(light.write_all(any(), near(), endless(any::<Light>)).is_ok());
}

fn set<T: Target<Color: Code>, M: Mask>(mut light: Dithered<'_, '_, T, M>) {
    keep(light.set(any(), any(), any()).is_ok());
}

fn bits<T: Target<Color: Code>, M: Mask>(mut light: Dithered<'_, '_, T, M>) {
    keep(light.fill_bits(any(), any()..any(), any(), any()).is_ok());
    keep(light.write_bits(any(), near(), any(), any::<u8>).is_ok());
}

fn fill_tile<T: Target<Color: Code>, M: Mask>(mut light: Dithered<'_, '_, T, M>) {
    keep(light.fill_tile(any(), &any()).is_ok());
}

fn grey() -> Gray8 {
    Gray8::new(any())
}

fn draw_target<C: Code, T, M: Mask>(light: Dithered<'_, '_, T, M>)
where
    T: Target<Color = C, Error = Infallible> + DrawTarget<Color = C, Error = Infallible>,
{
    let mut display = light.into_draw_target::<Gray8>();
    let Ok(()) = display.draw_iter([Pixel(any(), grey())]);
    let Ok(()) = display.fill_solid(&any(), grey());
    let Ok(()) = display.fill_contiguous(&near_rectangle(), endless(grey));
}

/// All that is done with light, by another mask.
fn drawn<C: Code, T>(target: &mut T, levels: Levels<'_>, mask: impl Mask)
where
    T: Target<Color = C, Error = Infallible> + DrawTarget<Color = C, Error = Infallible>,
{
    let mut light = Dithered::new(target, levels).with_method(mask);
    let Ok(()) = light.fill_area(any(), any());
    let Ok(()) = light.fill_run(any(), any()..any(), [any::<Light>()]);
    let Ok(()) = light.write_all(any(), near(), endless(any::<Light>));
    draw_target(light);
}

fn frame(bytes: &mut [u8]) -> Option<Lent<'_, Gray4, Rows>> {
    Lent::new(lent(bytes), side(), side()).ok()
}

fn band(memory: &mut Memory) {
    let Some(mut frame) = frame(&mut memory.bytes) else { return };
    drawn(&mut Window::band(&mut frame, any()), Levels::SRGB_16, Method::Nearest);
}

fn levels(memory: &mut Memory) {
    let Ok(mut frame) = Lent::<Gray2, Rows>::new(lent(&mut memory.bytes), side(), side()) else { return };
    // They must rise.
    some(&mut memory.steps);
    memory.steps.iter_mut().zip(0..).for_each(|(light, n)| *light = *light % 4096 + 4096 * n);
    if let Ok(levels) = Levels::new(part(&memory.steps)) {
        keep(levels.light(any()));
        drawn(&mut frame, levels, Method::Ordered4x4);
    }
}

fn blue_noise(memory: &mut Memory) {
    let Some(mut frame) = frame(&mut memory.bytes) else { return };
    drawn(&mut frame, Levels::SRGB_16, BLUE_NOISE_16);
}

fn r2_noise(memory: &mut Memory) {
    let Some(mut frame) = frame(&mut memory.bytes) else { return };
    drawn(&mut frame, Levels::SRGB_16, R2Noise);
}

fn frame_rate_control(memory: &mut Memory) {
    let Some(mut frame) = frame(&mut memory.bytes) else { return };
    if let Ok(frames) = FrameRateControl::new(1 << (any::<u8>() & 3), any()) {
        drawn(&mut frame, Levels::SRGB_16, frames);
    }
}

fn interleaved(memory: &mut Memory) {
    let Some(mut frame) = frame(&mut memory.bytes) else { return };
    drawn(&mut Interleaved::new(&mut frame, BAYER_4X4, any(), any()), Levels::SRGB_16, &BAYER_8X8);
}

fn interleaved_draw_target(memory: &mut Memory) {
    let Some(mut frame) = frame(&mut memory.bytes) else { return };
    let mut fields = Interleaved::new(&mut frame, BAYER_4X4, any(), any());
    let Ok(()) = fields.draw_iter([Pixel(any(), Gray4::new(any()))]);
    let Ok(()) = fields.fill_solid(&any(), Gray4::new(any()));
    let Ok(()) = fields.fill_contiguous(&near_rectangle(), endless(|| Gray4::new(any())));
}

/// Of any mask: one cell, one row, eight cells.
fn asked(mask: &impl Mask) {
    keep((mask.threshold(any(), any()), mask.eight(any()), mask.row(any(), any()).next()));
    keep(mask.row(any(), any()).nth(any::<usize>() & 0xFFFF));
}

fn mask_dot_gain(_: &mut Memory) {
    if let Ok(mask) = DotGain::new(BAYER_4X4, any()) {
        asked(&mask);
    }
}

fn rank_mask(memory: &mut Memory) {
    if let Ok(mask) = RankMask::<5, 3>::new(some(&mut memory.codes)) {
        asked(&mask);
    }
    // A constant's ranks are even.
    asked(one_of(&[&BAYER_2X2]));
}

fn code_mask_write_rows(memory: &mut Memory) {
    let Ok(mut frame) = Lent::<BinaryColor, Rows>::new(lent(&mut memory.bytes), side(), side()) else { return };
    memory.mask.write_rows(&mut frame, any(), some(&mut memory.codes));
}

fn code_mask_write_run(memory: &mut Memory) {
    let Ok(mut frame) = Lent::<BinaryColor, Rows>::new(lent(&mut memory.bytes), side(), side()) else { return };
    keep(memory.mask.write_run(&mut frame, any(), some(&mut memory.codes)));
}

fn code_mask_of_mask(memory: &mut Memory) {
    some(&mut memory.switches);
    memory.mask = CodeMask::of_mask(&R2Noise, &memory.switches);
    keep(memory.mask.switch_codes());
}

fn code_mask_with_curve(memory: &mut Memory) {
    some(&mut memory.switches);
    memory.mask = CodeMask::with_curve(&BAYER_8X8, &memory.switches);
}

fn rgb() -> Rgb888 {
    Rgb888::new(any(), any(), any())
}

fn quantised<C: Code, Q: Quantise<C, From = S>, S: PixelColor>(quantiser: Q, color: impl Fn() -> S, memory: &mut Memory)
where
    Rows: Layout<C>,
{
    let Ok(mut frame) = Lent::<C, Rows>::new(lent(&mut memory.bytes), side(), side()) else { return };
    let mut display = DitheredDrawTarget::new(&mut frame, quantiser, BLUE_NOISE_16);
    let Ok(()) = display.draw_iter([Pixel(any(), color())]);
    let Ok(()) = display.fill_solid(&any(), color());
    let Ok(()) = display.fill_contiguous(&near_rectangle(), endless(color));
}

fn ink_mix_of_palette(memory: &mut Memory) {
    let palette = Palette::new([(SixColor::Black, any()), (SixColor::White, any()), (SixColor::Red, any())]);
    quantised::<SixColor, _, Rgb888>(InkMix::new(&palette), rgb, memory);
}

const FONT: &MonoFont = &FONT_6X10;

fn glyph_sheet_load(memory: &mut Memory) {
    keep(GlyphSheet::<Rows, _>::load(FONT, lent(&mut memory.sheet)).is_ok());
    keep(GlyphSheet::<Pages, ()>::bytes_needed(FONT));
}

fn glyph_sheet_draw(memory: &mut Memory) {
    let Ok(sheet) = GlyphSheet::<Rows, _>::load(FONT, lent(&mut memory.sheet)) else { return };
    let sheet = sheet.with_baseline(one_of(&[Baseline::Top, Baseline::Alphabetic, Baseline::Bottom]));
    let Some(mut frame) = frame(&mut memory.bytes) else { return };
    keep((sheet.draw(&mut frame, text(), any(), Gray4::new(any())), sheet.glyph(any()).is_some()));
}
