//! Four ways to take a frame of something that moves.

use aquatint::{
    BAYER_4X4, Dithered, Exposure, Frame, Interleaved, IntoLight, Levels, Light, Rows, Words, display::dither::Method,
};
use embedded_graphics::{
    image::GetPixel,
    pixelcolor::{BinaryColor, Gray4},
    prelude::*,
};

use crate::scenes::{Moment, Scene};

/// Sub-frames, and instants of a 4 × 4 mask.
const COUNT: u16 = 16;

type Bits = Frame<BinaryColor, Rows, Vec<u8>>;
/// A picture of 16 greys that are equal steps of light.
pub type Film = Frame<Gray4, Rows, Vec<u8>>;

#[derive(Clone, Copy)]
pub enum Shutter {
    /// Open for no time.
    Instant,
    /// The mean of sub-frames.
    Greys,
    /// The same on one bit.
    OneBit,
    /// Every pixel at an instant of its own.
    Interleaved,
}

impl Shutter {
    pub const ALL: [Self; 4] = [Self::Instant, Self::Greys, Self::OneBit, Self::Interleaved];

    pub const fn name(self) -> &'static str {
        match self {
            Self::Instant => "one instant",
            Self::Greys => "16 sub-frames\nin 16 greys",
            Self::OneBit => "16 sub-frames\non one bit",
            Self::Interleaved => "one bit, each\npixel at its\nown instant",
        }
    }

    /// Takes a frame.
    pub fn expose(self, scene: &Scene, frame: u16) -> Result<Film, String> {
        let Size { width, height } = scene.size();
        let bits = || Bits::new(vec![0; Frame::<BinaryColor, Rows, ()>::bytes_needed(width, height)], width, height);
        let mut picture = bits().map_err(|error| error.to_string())?;
        let Ok(()) = match self {
            Self::Instant => scene.draw(&mut picture, &Moment { frame, part: 0.5, shift: [0.0; 2] }),
            Self::Interleaved => (0..COUNT).try_for_each(|i| {
                scene.draw(&mut Interleaved::new(&mut picture, BAYER_4X4, i, COUNT), &moment(frame, i))
            }),
            Self::Greys | Self::OneBit => return self.accumulated(scene, frame, picture),
        };
        film(&picture, |color| if color.is_on() { Gray4::WHITE } else { Gray4::BLACK })
    }

    /// The mean of sub-frames.
    fn accumulated(self, scene: &Scene, frame: u16, mut picture: Bits) -> Result<Film, String> {
        let Size { width, height } = scene.size();
        let bytes = vec![0; Frame::<Light, Words, ()>::bytes_needed(width, height)];
        let mut sum = Frame::<Light, Words, _>::new(bytes, width, height).map_err(|error| error.to_string())?;
        let mut exposure = Exposure::new(&mut sum, COUNT).map_err(|error| error.to_string())?;
        for i in 0..COUNT {
            let Ok(()) = scene.draw(&mut picture, &moment(frame, i));
            let Ok(()) = exposure.add(&picture, IntoLight::into_light);
        }
        let mut film = film(&picture, |_| Gray4::BLACK)?;
        if matches!(self, Self::OneBit) {
            let Ok(()) = exposure.show(&mut Dithered::new(&mut film, Levels::ONE_BIT));
            return self::film(&film, |code| Gray4::new(15 * code.luma()));
        }
        let Ok(()) = exposure.show(&mut Dithered::new(&mut film, Levels::LINEAR_16).with_method(Method::Nearest));
        Ok(film)
    }
}

/// The middle of one of the parts of a frame; moved to the middle of one of 16 parts of a pixel.
fn moment(frame: u16, i: u16) -> Moment {
    let part = |of: u16, number: u16| (f32::from(number) + 0.5) / f32::from(of);
    Moment { frame, part: part(COUNT, i), shift: [part(4, i % 4) - 0.5, part(4, i / 4) - 0.5] }
}

/// A picture in greys.
fn film<P: GetPixel + OriginDimensions>(picture: &P, grey: impl Fn(P::Color) -> Gray4) -> Result<Film, String> {
    let (size, area) = (picture.size(), Dimensions::bounding_box(picture));
    let bytes = vec![0; Frame::<Gray4, Rows, ()>::bytes_needed(size.width, size.height)];
    let mut film = Film::new(bytes, size.width, size.height).map_err(|error| error.to_string())?;
    let Ok(()) = film.fill_contiguous(&area, area.points().filter_map(|at| picture.pixel(at)).map(grey));
    Ok(film)
}
