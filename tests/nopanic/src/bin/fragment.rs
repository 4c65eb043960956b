//! Inks, gradients, patterns, pictures, textures, blending, bands of light and motion blur.
#![no_std]
#![no_main]

use core::hint::black_box;

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
use nopanic::{any, keep, lent, part};

#[cortex_m_rt::entry]
fn main() -> ! {
    inks();
    blended(black_box(BinaryColor::On));
    blended(Gray4::new(any()));
    blended(Rgb332::new(any(), any(), any()));
    light();
    textures();
    exposure();
    bands();
    loop {}
}

type Lent<'a, C> = Frame<C, Rows, &'a mut [u8]>;
type Lights<'a> = Frame<Light, Words, &'a mut [u8]>;

fn inked<I: Ink<Color = Light>>(ink: I) {
    let mut bytes = [0; 64];
    let Ok(mut frame) = Lights::new(lent(&mut bytes), any(), any()) else { return };
    let Ok(()) = ink.fill(&mut frame, any(), any()..any());
    let Ok(()) = Brush::new(&mut frame, ink).span(any(), any()..any(), ());
}

fn inks() {
    inked(any::<Light>());
    let extend = black_box(Extend::Pad);
    inked(LinearGradient::new(any(), any(), between(any(), any())).with_extend(extend));
    inked(RadialGradient::new(any(), any(), between(any(), any())).with_extend(extend));
    inked(Pattern::new(any::<[[Light; 5]; 3]>()).anchored(any()));
    inked(Pattern::new(any::<[[Light; 8]; 8]>()));
    inked(Pattern::from_bits(black_box(hatch::BRICKS), any(), any()).anchored(any()));
    inked(Stencil::new(black_box(hatch::DOTS), any()).anchored(any()));
    let photo = [0; 64];
    let Ok(photo) = Frame::<Light, Words, _>::with_slice(part(&photo), any(), any()) else { return };
    inked(PictureInk::once(&photo).anchored(any()));
    inked(PictureInk::tiled(&photo).anchored(any()));
}

fn blended<C: Code + Blend>(color: C) {
    let (mut bytes, parts) = ([0; 64], [any::<Coverage>(); 8]);
    let Ok(mut frame) = Lent::<C>::new(lent(&mut bytes), any(), any()) else { return };
    let alpha = || Alpha::new(color, any());
    let mut on = OnBackground::new(&mut frame, color);
    let Ok(()) = on.draw_iter([Pixel(any(), alpha())]);
    let Ok(()) = on.fill_solid(&any(), alpha());
    let Ok(()) = on.fill_contiguous(&any(), core::iter::repeat_with(alpha));
    let mut on = Blended::new(&mut frame).with_mode(black_box(BlendMode::Over));
    let Ok(()) = on.draw_iter([Pixel(any(), alpha())]);
    let Ok(()) = on.fill_solid(&any(), alpha());
    let Ok(()) = on.fill_contiguous(&any(), core::iter::repeat_with(alpha));
    let mut brush = on.brush(color).with_curve(CoverageCurve::bolder(any()));
    let Ok(()) = brush.span(any(), any::<i32>()..any(), Covered::Evenly(any()));
    let Ok(()) = brush.span(any(), any::<i32>()..any(), Covered::Each(part(&parts)));
    keep(color.blend(color, black_box(BlendMode::Over), any()));
}

fn light() {
    let (mut bytes, parts) = ([0; 64], [any::<Coverage>(); 8]);
    let Ok(mut frame) = Lights::new(lent(&mut bytes), any(), any()) else { return };
    let mut on = Blended::new(&mut frame);
    let gradient = LinearGradient::new(any(), any(), between(any(), any()));
    let Ok(()) = on.brush(gradient).span(any(), any::<i32>()..any(), Covered::Each(part(&parts)));
    let Ok(()) = on.fill_solid(&any(), Alpha::from(any::<Light>()));
    keep(any::<Light>().blend(any(), black_box(BlendMode::Over), any()));
    keep(black_box(Rgb565::BLACK).blend(black_box(Rgb565::BLACK), black_box(BlendMode::Screen), any()));
}

fn textures() {
    let (bytes, lights) = ([0; 64], [any::<Light>(); 16]);
    textured(&texture::BLACK_AND_WHITE, &bytes);
    textured(&texture::SRGB_4, &bytes);
    textured(black_box(&texture::SRGB_16), &bytes);
    textured(texture::Srgb, &bytes);
    if let Ok(texture) = LightTexture::new(part(&lights), any(), any()) {
        sampled(Sampler::new(&texture));
        sampled(Sampler::new(texture).with_filter(Bilinear).with_wrap(ClampToEdge));
    }
}

fn textured(lights: impl CodeLights, bytes: &[u8]) {
    let Ok(texture) = Texture::new(part(bytes), any(), any(), lights) else { return };
    sampled(Sampler::new(texture));
    sampled(Sampler::new(texture).with_filter(Bilinear).with_wrap(Mirror));
}

fn sampled<T: Texels, W: Wrap, F: Filter>(sampler: Sampler<T, W, F>) {
    keep((sampler.sample(any(), any()), sampler.uv_shifts(), sampler.sample_uv(any())));
}

fn exposure() {
    let (mut sum, picture, mut bytes) = ([0; 64], [0; 64], [0; 64]);
    let Ok(mut sum) = Lights::new(lent(&mut sum), any(), any()) else { return };
    let Ok(picture) = Frame::<Gray8, Rows, _>::with_slice(part(&picture), any(), any()) else { return };
    let Ok(mut shown) = Lights::new(lent(&mut bytes), any(), any()) else { return };
    let Ok(mut exposure) = Exposure::new(&mut sum, any()) else { return };
    let Ok(()) = exposure.add(&picture, |grey| Light::from_srgb(grey.luma()));
    let Ok(()) = exposure.show(&mut shown);
    keep(exposure.taken());
}

fn bands() {
    if let (Some(even), Some(to_the_eye)) = (Bands::even(any()), Bands::even_to_the_eye(any())) {
        keep((even.of(any()), to_the_eye.of(any())));
    }
}
