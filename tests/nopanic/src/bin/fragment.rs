//! Inks, gradients, patterns, pictures, textures, blending, bands of light and motion blur.
#![no_std]
#![no_main]

use aquatint::{
    Alpha, Blend, BlendMode, Blended, Brush, Code, Coverage, CoverageCurve, Covered, Exposure, Extend, Frame, Ink,
    Light, LinearGradient, OnBackground, Pattern, PictureInk, RadialGradient, Rgb332, Rows, Sampler, Sink, Stencil,
    Texture, Words,
    fragment::{
        gradient::between,
        pattern::hatch,
        texture::{self, Bilinear, ClampToEdge, CodeLights, Filter, LightTexture, Mirror, Texels, Wrap},
        toon::Bands,
    },
};
use embedded_graphics::{
    pixelcolor::{BinaryColor, Gray4, Gray8, Rgb565},
    prelude::*,
};
use nopanic::{any, endless, keep, lent, near, near_rectangle, one_of, side, some};

/// What a caller lends.
struct Memory {
    bytes: [u8; 4096],
    picture: [u8; 4096],
    lights: [Light; 16],
    texels: [u8; 64],
    coverages: [Coverage; 48],
}

const MEMORY: Memory = Memory {
    bytes: [0; 4096],
    picture: [0; 4096],
    lights: [Light::BLACK; 16],
    texels: [0; 64],
    coverages: [Coverage::NONE; 48],
};

nopanic::entries! { MEMORY;
    plain_ink = |memory: &mut Memory| inked(any::<Light>(), &mut memory.bytes),
    linear_gradient,
    radial_gradient,
    pattern = |memory: &mut Memory| inked(Pattern::new(any::<[[Light; 5]; 3]>()).anchored(any()), &mut memory.bytes),
    pattern_8x8 = |memory: &mut Memory| inked(Pattern::new(any::<[[Light; 8]; 8]>()), &mut memory.bytes),
    pattern_from_bits,
    stencil,
    picture_ink_once,
    picture_ink_tiled,
    on_background_bits = |memory: &mut Memory| on_background(bit(), memory),
    on_background_grey = |memory: &mut Memory| on_background(Gray4::new(any()), memory),
    on_background_rgb332 = |memory: &mut Memory| on_background(rgb(), memory),
    blended_bits = |memory: &mut Memory| blended(bit(), memory),
    blended_grey = |memory: &mut Memory| blended(Gray4::new(any()), memory),
    blended_rgb332 = |memory: &mut Memory| blended(rgb(), memory),
    brush_bits = |memory: &mut Memory| brushed(bit(), memory),
    brush_grey = |memory: &mut Memory| brushed(Gray4::new(any()), memory),
    brush_rgb332 = |memory: &mut Memory| brushed(rgb(), memory),
    brush_light,
    blend,
    texture_of_two_lights = |memory: &mut Memory| textured(&texture::BLACK_AND_WHITE, memory),
    texture_srgb_4 = |memory: &mut Memory| textured(&texture::SRGB_4, memory),
    texture_srgb_16 = |memory: &mut Memory| textured(&texture::SRGB_16, memory),
    texture_srgb = |memory: &mut Memory| textured(texture::Srgb, memory),
    texture_bilinear,
    light_texture,
    light_texture_bilinear,
    exposure_add,
    exposure_show,
    bands,
}

type Lent<'a, C> = Frame<C, Rows, &'a mut [u8]>;
type Lights<'a> = Frame<Light, Words, &'a mut [u8]>;

fn bit() -> BinaryColor {
    BinaryColor::from(any::<bool>())
}

fn rgb() -> Rgb332 {
    Rgb332::new(any(), any(), any())
}

fn inked<I: Ink<Color = Light>>(ink: I, bytes: &mut [u8]) {
    let Ok(mut frame) = Lights::new(lent(bytes), side(), side()) else { return };
    let Ok(()) = ink.fill(&mut frame, any(), near());
    let Ok(()) = Brush::new(&mut frame, ink).span(any(), near(), ());
}

fn extend() -> Extend {
    one_of(&[Extend::Pad, Extend::Repeat, Extend::Reflect])
}

fn linear_gradient(memory: &mut Memory) {
    inked(LinearGradient::new(any(), any(), between(any(), any())).with_extend(extend()), &mut memory.bytes);
}

fn radial_gradient(memory: &mut Memory) {
    inked(RadialGradient::new(any(), any(), between(any(), any())).with_extend(extend()), &mut memory.bytes);
}

fn pattern_from_bits(memory: &mut Memory) {
    inked(Pattern::from_bits(hatch::BRICKS, any(), any()).anchored(any()), &mut memory.bytes);
}

fn stencil(memory: &mut Memory) {
    inked(Stencil::new(hatch::DOTS, any()).anchored(any()), &mut memory.bytes);
}

fn picture_ink_once(memory: &mut Memory) {
    let Ok(photo) = Frame::<Light, Words, _>::with_slice(some(&mut memory.picture), side(), side()) else { return };
    inked(PictureInk::once(&photo).anchored(any()), &mut memory.bytes);
}

fn picture_ink_tiled(memory: &mut Memory) {
    let Ok(photo) = Frame::<Light, Words, _>::with_slice(some(&mut memory.picture), side(), side()) else { return };
    inked(PictureInk::tiled(&photo).anchored(any()), &mut memory.bytes);
}

fn mode() -> BlendMode {
    one_of(&[BlendMode::Over, BlendMode::Add, BlendMode::Multiply, BlendMode::Screen, BlendMode::Darken])
}

fn on_background<C: Code + Blend>(color: C, memory: &mut Memory) {
    let Ok(mut frame) = Lent::<C>::new(lent(&mut memory.bytes), side(), side()) else { return };
    let alpha = || Alpha::new(color, any());
    let mut on = OnBackground::new(&mut frame, color);
    let Ok(()) = on.draw_iter([Pixel(any(), alpha())]);
    let Ok(()) = on.fill_solid(&any(), alpha());
    let Ok(()) = on.fill_contiguous(&near_rectangle(), endless(alpha));
}

fn blended<C: Code + Blend>(color: C, memory: &mut Memory) {
    let Ok(mut frame) = Lent::<C>::new(lent(&mut memory.bytes), side(), side()) else { return };
    let alpha = || Alpha::new(color, any());
    let mut on = Blended::new(&mut frame).with_mode(mode());
    let Ok(()) = on.draw_iter([Pixel(any(), alpha())]);
    let Ok(()) = on.fill_solid(&any(), alpha());
    let Ok(()) = on.fill_contiguous(&near_rectangle(), endless(alpha));
}

fn covered(coverages: &mut [Coverage]) -> Covered<'_> {
    if any() { Covered::Each(some(coverages)) } else { Covered::Evenly(any()) }
}

fn brushed<C: Code + Blend>(color: C, memory: &mut Memory) {
    let Ok(mut frame) = Lent::<C>::new(lent(&mut memory.bytes), side(), side()) else { return };
    let mut on = Blended::new(&mut frame).with_mode(mode());
    let mut brush = on.brush(color).with_curve(CoverageCurve::bolder(any()));
    let Ok(()) = brush.span(any(), near(), covered(&mut memory.coverages));
}

fn brush_light(memory: &mut Memory) {
    let Ok(mut frame) = Lights::new(lent(&mut memory.bytes), side(), side()) else { return };
    let mut on = Blended::new(&mut frame);
    let gradient = LinearGradient::new(any(), any(), between(any(), any()));
    let Ok(()) = on.brush(gradient).span(any(), near(), covered(&mut memory.coverages));
    let Ok(()) = on.fill_solid(&any(), Alpha::from(any::<Light>()));
}

fn blend(_: &mut Memory) {
    let color = Rgb565::new(any(), any(), any());
    keep((any::<Light>().blend(any(), mode(), any()), color.blend(Rgb565::new(any(), any(), any()), mode(), any())));
    keep((bit().blend(bit(), mode(), any()), rgb().blend(rgb(), mode(), any())));
}

/// A power of two, or not.
fn texels() -> u32 {
    if any() { 4 } else { any() }
}

fn textured(lights: impl CodeLights, memory: &mut Memory) {
    let Ok(texture) = Texture::new(some(&mut memory.texels), texels(), texels(), lights) else { return };
    sampled(Sampler::new(texture));
}

fn texture_bilinear(memory: &mut Memory) {
    let Ok(texture) = Texture::new(some(&mut memory.texels), texels(), texels(), texture::Srgb) else { return };
    sampled(Sampler::new(texture).with_filter(Bilinear).with_wrap(Mirror));
}

fn light_texture(memory: &mut Memory) {
    let Ok(texture) = LightTexture::new(some(&mut memory.lights), texels(), texels()) else { return };
    sampled(Sampler::new(&texture));
}

fn light_texture_bilinear(memory: &mut Memory) {
    let Ok(texture) = LightTexture::new(some(&mut memory.lights), texels(), texels()) else { return };
    sampled(Sampler::new(texture).with_filter(Bilinear).with_wrap(ClampToEdge));
}

fn sampled<T: Texels, W: Wrap, F: Filter>(sampler: Sampler<T, W, F>) {
    keep((sampler.sample(any(), any()), sampler.uv_shifts(), sampler.sample_uv(any())));
}

fn exposure_add(memory: &mut Memory) {
    let Ok(mut sum) = Lights::new(lent(&mut memory.bytes), side(), side()) else { return };
    let Ok(picture) = Frame::<Gray8, Rows, _>::with_slice(some(&mut memory.picture), side(), side()) else { return };
    let Ok(mut exposure) = Exposure::new(&mut sum, any()) else { return };
    let Ok(()) = exposure.add(&picture, |grey| Light::from_srgb(grey.luma()));
    keep(exposure.taken());
}

fn exposure_show(memory: &mut Memory) {
    let Ok(mut sum) = Lights::new(lent(&mut memory.bytes), side(), side()) else { return };
    let Ok(mut shown) = Lights::new(lent(&mut memory.picture), side(), side()) else { return };
    let Ok(exposure) = Exposure::new(&mut sum, any()) else { return };
    let Ok(()) = exposure.show(&mut shown);
}

fn bands(_: &mut Memory) {
    if let (Some(even), Some(to_the_eye)) = (Bands::even(any()), Bands::even_to_the_eye(any())) {
        keep((even.of(any()), to_the_eye.of(any())));
    }
}
