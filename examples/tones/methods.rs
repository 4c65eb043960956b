//! The methods: a line each.

use core::marker::PhantomData;

use aquatint::{
    AlongCurve, BAYER_2X2, BAYER_4X4, BAYER_8X8, BAYER_16X16, BLUE_NOISE_16, BLUE_NOISE_64, Code, Diffusion, Dithered,
    DitheredDrawTarget, Frame, InkMix, Levels, Light, Palette, R2Noise, Rows, SixColor, Target, ThreeColor,
    display::{
        diffuse::{
            Atkinson, Burkes, Carry, FloydSteinberg, History, JarvisJudiceNinke, Kernel, Riemersma, Scan, Sierra,
            SierraLite, Stucki,
        },
        dither::{Mask, Method},
        halftone::{DOTS_4X4, DOTS_45_6X6, DOTS_45_8X8, LINES_45_4X4},
    },
};
use embedded_graphics::{
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    image::GetPixel,
    pixelcolor::{BinaryColor, Gray2, Gray4, Rgb888},
    primitives::{PointsIter, Rectangle},
};

use crate::photo::Photo;

/// A photograph by one method, in the colours that the eye sees.
pub struct Shown {
    pub name: &'static str,
    pub photo: Photo,
}

/// Inks, and what they look like on paper.
const RED: [(ThreeColor, [u8; 3]); 3] =
    [(ThreeColor::Black, [10, 7, 14]), (ThreeColor::White, [173, 178, 174]), (ThreeColor::Chromatic, [150, 20, 15])];

/// As `aquatint::display::palette::SPECTRA_6`.
const SPECTRA: [(SixColor, [u8; 3]); 6] = [
    (SixColor::Black, [26, 13, 35]),
    (SixColor::White, [185, 202, 205]),
    (SixColor::Yellow, [202, 184, 0]),
    (SixColor::Red, [121, 9, 0]),
    (SixColor::Blue, [0, 69, 139]),
    (SixColor::Green, [40, 82, 57]),
];

/// What a method draws on.
type Screen<C> = Frame<C, Rows, Vec<u8>>;

/// The photograph by all methods.
#[rustfmt::skip]
pub fn all(photo: &Photo) -> Result<Vec<Shown>, String> {
    let grey = Shown { name: "256 greys", photo: Photo { pixels: photo.lights().map(|l| [l.to_srgb(); 3]).collect(), ..photo.clone() } };
    Ok(vec![
        Shown { name: "photograph", photo: photo.clone() },
        grey,
        one_bit(photo, "no dither", &ordered(Method::Nearest))?,
        one_bit(photo, "Bayer 2 x 2", &ordered(BAYER_2X2))?,
        one_bit(photo, "Bayer 4 x 4", &ordered(BAYER_4X4))?,
        one_bit(photo, "Bayer 8 x 8", &ordered(BAYER_8X8))?,
        one_bit(photo, "Bayer 16 x 16", &ordered(BAYER_16X16))?,
        one_bit(photo, "blue noise 16", &ordered(BLUE_NOISE_16))?,
        one_bit(photo, "blue noise 64", &ordered(BLUE_NOISE_64))?,
        one_bit(photo, "R2 noise", &ordered(R2Noise))?,
        one_bit(photo, "dots 4 x 4", &ordered(DOTS_4X4))?,
        one_bit(photo, "dots 6 x 6, 45 degrees", &ordered(DOTS_45_6X6))?,
        one_bit(photo, "dots 8 x 8, 45 degrees", &ordered(DOTS_45_8X8))?,
        one_bit(photo, "lines 4 x 4, 45 degrees", &ordered(LINES_45_4X4))?,
        one_bit(photo, "Sierra Lite", &diffused::<SierraLite>(Scan::Serpentine))?,
        one_bit(photo, "Sierra Lite, raster", &diffused::<SierraLite>(Scan::Raster))?,
        one_bit(photo, "Floyd-Steinberg", &diffused::<FloydSteinberg>(Scan::Serpentine))?,
        one_bit(photo, "Floyd-Steinberg, raster", &diffused::<FloydSteinberg>(Scan::Raster))?,
        one_bit(photo, "Atkinson", &diffused::<Atkinson>(Scan::Serpentine))?,
        one_bit(photo, "Burkes", &diffused::<Burkes>(Scan::Serpentine))?,
        one_bit(photo, "Sierra", &diffused::<Sierra>(Scan::Serpentine))?,
        one_bit(photo, "Jarvis, Judice, Ninke", &diffused::<JarvisJudiceNinke>(Scan::Serpentine))?,
        one_bit(photo, "Stucki", &diffused::<Stucki>(Scan::Serpentine))?,
        one_bit(photo, "Riemersma", &along_curve::<Riemersma>())?,
        one_bit(photo, "Hilbert, carry", &along_curve::<Carry>())?,
        four_levels(photo, "4 levels, no dither", &ordered(Method::Nearest))?,
        four_levels(photo, "4 levels, Bayer 4 x 4", &ordered(BAYER_4X4))?,
        four_levels(photo, "4 levels, Sierra Lite", &diffused::<SierraLite>(Scan::Serpentine))?,
        sixteen_levels(photo, "16 levels, no dither", &ordered(Method::Nearest))?,
        sixteen_levels(photo, "16 levels, Sierra Lite", &diffused::<SierraLite>(Scan::Serpentine))?,
        inks(photo, "black, white, red", RED)?,
        inks(photo, "6 inks of Spectra 6", SPECTRA)?,
    ])
}

/// A way to show light on a panel whose codes give some levels of light.
trait Draw {
    fn draw<C: Code>(&self, photo: &Photo, screen: &mut Screen<C>, levels: Levels<'_>) -> Result<(), String>;
}

struct Ordered<M>(M);

fn ordered<M: Mask + Copy>(mask: M) -> Ordered<M> {
    Ordered(mask)
}

impl<M: Mask + Copy> Draw for Ordered<M> {
    fn draw<C: Code>(&self, photo: &Photo, screen: &mut Screen<C>, levels: Levels<'_>) -> Result<(), String> {
        let mut dithered = Dithered::new(screen, levels).with_method(self.0);
        for (y, row) in (0..).zip(photo.rows()) {
            let Ok(()) = dithered.write_run(y, 0..photo.size.width.cast_signed(), row.into_iter().map(Some));
        }
        Ok(())
    }
}

struct Diffused<K>(Scan, PhantomData<K>);

fn diffused<K: Kernel>(scan: Scan) -> Diffused<K> {
    Diffused(scan, PhantomData)
}

impl<K: Kernel> Draw for Diffused<K> {
    fn draw<C: Code>(&self, photo: &Photo, screen: &mut Screen<C>, levels: Levels<'_>) -> Result<(), String> {
        let mut memory = vec![0; Diffusion::<K>::memory_needed(photo.size.width)];
        let diffusion = Diffusion::<K>::new(&mut memory, photo.size.width, levels).map_err(|e| e.to_string())?;
        let mut diffusion = diffusion.with_scan(self.0);
        for (y, row) in (0..).zip(photo.rows()) {
            let Ok(()) = diffusion.draw_row(screen, Point::new(0, y), row);
        }
        Ok(())
    }
}

struct Walked<H>(PhantomData<H>);

fn along_curve<H: History>() -> Walked<H> {
    Walked(PhantomData)
}

impl<H: History> Draw for Walked<H> {
    fn draw<C: Code>(&self, photo: &Photo, screen: &mut Screen<C>, levels: Levels<'_>) -> Result<(), String> {
        let lights: Vec<Vec<Light>> = photo.rows().collect();
        let light = |Point { x, y }| lights[y.unsigned_abs() as usize][x.unsigned_abs() as usize];
        let area = screen.bounding_box();
        let Ok(()) = AlongCurve::<H>::new(levels).draw(screen, area, light);
        Ok(())
    }
}

fn one_bit(photo: &Photo, name: &'static str, method: &impl Draw) -> Result<Shown, String> {
    shown::<BinaryColor>(photo, name, Levels::ONE_BIT, method)
}

fn four_levels(photo: &Photo, name: &'static str, method: &impl Draw) -> Result<Shown, String> {
    let levels = [0, 85, 170, 255].map(|code| Light::from_srgb(code).0);
    shown::<Gray2>(photo, name, Levels::new(&levels).map_err(|e| e.to_string())?, method)
}

fn sixteen_levels(photo: &Photo, name: &'static str, method: &impl Draw) -> Result<Shown, String> {
    shown::<Gray4>(photo, name, Levels::SRGB_16, method)
}

/// What a panel of grey levels spaced like sRGB codes shows.
fn shown<C: Code>(photo: &Photo, name: &'static str, levels: Levels<'_>, method: &impl Draw) -> Result<Shown, String> {
    let mut screen = screen::<C>(photo)?;
    method.draw(photo, &mut screen, levels)?;
    let step = 255 / ((1_u16 << C::BITS) - 1);
    let eye = |color: C| [u8::try_from(u16::from(color.code()) * step).unwrap_or(u8::MAX); 3];
    Ok(seen(photo, name, &screen, eye))
}

/// Colours that a few inks make, mixed by a 4 x 4 dither.
fn inks<C: Code, const N: usize>(photo: &Photo, name: &'static str, inks: [(C, [u8; 3]); N]) -> Result<Shown, String> {
    let mut screen = screen::<C>(photo)?;
    let palette = Palette::new(inks);
    let mut display = DitheredDrawTarget::new(&mut screen, InkMix::<Rgb888, _, N>::new(&palette), BAYER_4X4);
    let colors = photo.pixels.iter().map(|&[r, g, b]| Rgb888::new(r, g, b));
    let Ok(()) = display.fill_contiguous(&Rectangle::new(Point::zero(), photo.size), colors);
    let eye = |color: C| inks.iter().find(|ink| ink.0.code() == color.code()).map_or([0; 3], |ink| ink.1);
    Ok(seen(photo, name, &screen, eye))
}

fn screen<C: Code>(photo: &Photo) -> Result<Screen<C>, String> {
    let (width, height) = (photo.size.width, photo.size.height);
    let bytes = vec![0; Frame::<C, Rows, ()>::bytes_needed(width, height)];
    Screen::new(bytes, width, height).map_err(|e| e.to_string())
}

/// The screen as the eye sees it.
fn seen<C: Code>(photo: &Photo, name: &'static str, screen: &Screen<C>, eye: impl Fn(C) -> [u8; 3]) -> Shown {
    let pixels = screen.bounding_box().points().map(|point| screen.pixel(point).map_or([0; 3], &eye));
    Shown { name, photo: Photo { size: photo.size, pixels: pixels.collect() } }
}
