//! Error diffusion, along rows and along curves, and scaling.
#![no_std]
#![no_main]

use core::convert::Infallible;

use aquatint::{
    AlongCurve, Diffusion, Frame, Hilbert, Levels, Light, Rows, Scaler,
    display::{
        diffuse::{
            Atkinson, Burkes, Carry, FloydSteinberg, JarvisJudiceNinke, Kernel, Riemersma, Scan, Sierra, SierraLite,
            Stucki,
        },
        scale::Filter,
    },
};
use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Gray8};
use nopanic::{any, keep, lent, one_of, side, some};

/// What a caller lends.
struct Memory {
    bytes: [u8; 2048],
    photo: [u8; 2304],
    lights: [Light; 48],
    errors: [i16; 256],
    sums: [u64; 128],
}

const MEMORY: Memory =
    Memory { bytes: [0; 2048], photo: [0; 2304], lights: [Light::BLACK; 48], errors: [0; 256], sums: [0; 128] };

nopanic::entries! { MEMORY;
    floyd_steinberg = diffused::<FloydSteinberg>,
    floyd_steinberg_packed = packed::<FloydSteinberg>,
    sierra_lite = diffused::<SierraLite>,
    sierra_lite_packed = packed::<SierraLite>,
    sierra = diffused::<Sierra>,
    sierra_packed = packed::<Sierra>,
    burkes = diffused::<Burkes>,
    burkes_packed = packed::<Burkes>,
    jarvis_judice_ninke = diffused::<JarvisJudiceNinke>,
    jarvis_judice_ninke_packed = packed::<JarvisJudiceNinke>,
    stucki = diffused::<Stucki>,
    stucki_packed = packed::<Stucki>,
    atkinson = diffused::<Atkinson>,
    atkinson_packed = packed::<Atkinson>,
    draw_picture,
    draw_scaled,
    riemersma,
    carry,
    hilbert,
    scaler,
}

type Lent<'a, C> = Frame<C, Rows, &'a mut [u8]>;

fn diffusion<'a, K: Kernel>(errors: &'a mut [i16], levels: Levels<'static>) -> Option<Diffusion<'a, 'static, K>> {
    keep(Diffusion::<K>::memory_needed(any()));
    let diffusion = Diffusion::<K>::new(lent(errors), any(), levels).ok()?;
    Some(diffusion.with_scan(one_of(&[Scan::Serpentine, Scan::Raster])))
}

fn diffused<K: Kernel>(memory: &mut Memory) {
    let Ok(mut greys) = Lent::<Gray4>::new(lent(&mut memory.bytes), side(), side()) else { return };
    let Some(mut diffusion) = diffusion::<K>(&mut memory.errors, Levels::SRGB_16) else { return };
    let lights = some(&mut memory.lights).iter().copied();
    let Ok(()) = diffusion.draw_row(&mut greys, any(), lights.clone());
    let Ok(()) = diffusion.draw_row(&mut greys, any(), lights);
    diffusion.restart();
}

fn packed<K: Kernel>(memory: &mut Memory) {
    let Ok(mut bits) = Lent::<BinaryColor>::new(lent(&mut memory.bytes), side(), side()) else { return };
    let Some(mut diffusion) = diffusion::<K>(&mut memory.errors, Levels::ONE_BIT) else { return };
    let lights = some(&mut memory.lights).iter().copied();
    diffusion.draw_packed_row(&mut bits, any(), lights.clone());
    diffusion.draw_packed_row(&mut bits, any(), lights);
}

fn draw_picture(memory: &mut Memory) {
    let Ok(mut greys) = Lent::<Gray4>::new(lent(&mut memory.bytes), side(), side()) else { return };
    let Ok(photo) = Frame::<Gray8, Rows, _>::with_slice(some(&mut memory.photo), side(), side()) else { return };
    let Some(mut diffusion) = diffusion::<FloydSteinberg>(&mut memory.errors, Levels::SRGB_16) else { return };
    let Ok(()) = diffusion.draw_picture(&mut greys, any(), &photo);
}

fn filter() -> Filter {
    one_of(&[Filter::Area, Filter::Bilinear])
}

fn draw_scaled(memory: &mut Memory) {
    let Ok(mut greys) = Lent::<Gray4>::new(lent(&mut memory.bytes), side(), side()) else { return };
    let (width, height) = (side(), side());
    let Ok(photo) = Frame::<Gray8, Rows, _>::with_slice(some(&mut memory.photo), width, height) else { return };
    let Some(mut diffusion) = diffusion::<FloydSteinberg>(&mut memory.errors, Levels::SRGB_16) else { return };
    let from = if any() { embedded_graphics::geometry::Size::new(width, height) } else { any() };
    if let Ok(mut scaler) = Scaler::new(lent(&mut memory.sums), from, any(), filter()) {
        let Ok(()) = diffusion.draw_scaled(&mut greys, any(), (&photo, &mut scaler));
    }
}

fn riemersma(memory: &mut Memory) {
    let Ok(mut greys) = Lent::<Gray4>::new(lent(&mut memory.bytes), side(), side()) else { return };
    let Ok(()) = AlongCurve::<Riemersma>::new(Levels::SRGB_16).draw(&mut greys, any(), |_| any());
}

fn carry(memory: &mut Memory) {
    let Ok(mut greys) = Lent::<Gray4>::new(lent(&mut memory.bytes), side(), side()) else { return };
    let Ok(()) = AlongCurve::<Carry>::new(Levels::SRGB_16).draw(&mut greys, any(), |_| any());
}

/// The beginning of the curve: it visits all pixels, however large the area.
fn hilbert(_: &mut Memory) {
    Hilbert::new(any()).take(any::<usize>() & 0xFFF).for_each(keep);
}

fn scaler(memory: &mut Memory) {
    keep(Scaler::memory_needed(any()));
    let Ok(mut scaler) = Scaler::new(lent(&mut memory.sums), any(), any(), filter()) else { return };
    scaler.restart();
    for _ in 0..4 {
        let Ok(()) = scaler.push(some(&mut memory.lights).iter().copied(), |row, lights| {
            keep((row, lights.len()));
            lights.clone().rev().for_each(keep);
            lights.for_each(keep);
            Ok::<(), Infallible>(())
        });
    }
    keep((scaler.from(), scaler.to()));
}
