//! Pictures of one size, on their way into a PNG file.

use std::io::{self, Write};

use png::{BitDepth, ColorType, DeflateCompression, Encoder, EncodingError, Filter};

use crate::palette::{Palette, pack};
use crate::picture::Picture;

/// One picture or more, kept as palette indices as long as there are few enough colours.
#[derive(Debug)]
pub(crate) struct Frames {
    width: u32,
    height: u32,
    pixels: Pixels,
}

#[derive(Debug)]
enum Pixels {
    Indexed(Palette, Vec<Vec<u8>>),
    Rgb(Vec<Vec<u8>>),
}

impl Frames {
    pub(crate) fn new((width, height): (u32, u32)) -> Self {
        let pixels = Pixels::Indexed(Palette::default(), Vec::new());
        Self { width, height, pixels }
    }

    pub(crate) fn size(&self) -> (u32, u32) {
        (self.width, self.height)
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.all().is_empty()
    }

    /// Adds a picture, which must be of this size.
    pub(crate) fn push(&mut self, picture: &Picture) {
        match &mut self.pixels {
            Pixels::Rgb(frames) => frames.push(picture.rgb().to_vec()),
            Pixels::Indexed(palette, frames) => {
                if let Some(indices) = palette.indices(picture) {
                    frames.push(indices);
                } else {
                    let earlier = frames.iter().map(|indices| palette.rgb(indices));
                    let this = picture.rgb().to_vec();
                    self.pixels = Pixels::Rgb(earlier.chain([this]).collect());
                }
            }
        }
    }

    /// Writes a still picture of the first frame.
    pub(crate) fn write_still(&self, file: impl Write) -> io::Result<()> {
        self.write(self.encoder(file)).map_err(plain)
    }

    /// Writes all frames, to be shown for ever at this rate.
    pub(crate) fn write_animated(&self, file: impl Write, per_second: u16) -> io::Result<()> {
        let mut encoder = self.encoder(file);
        let count = u32::try_from(self.all().len()).unwrap_or(u32::MAX);
        encoder
            .set_animated(count, 0)
            .and_then(|()| encoder.set_frame_delay(1, per_second.max(1)))
            .and_then(|()| self.write(encoder))
            .map_err(plain)
    }

    fn all(&self) -> &[Vec<u8>] {
        match &self.pixels {
            Pixels::Indexed(_, frames) | Pixels::Rgb(frames) => frames,
        }
    }

    fn encoder<W: Write>(&self, file: W) -> Encoder<'_, W> {
        let mut encoder = Encoder::new(file, self.width, self.height);
        encoder.set_deflate_compression(DeflateCompression::Level(9));
        match &self.pixels {
            Pixels::Indexed(palette, _) => {
                encoder.set_color(ColorType::Indexed);
                encoder.set_depth(palette.depth());
                encoder.set_palette(palette.bytes());
                // Differences of palette indices mean nothing: filters would only add noise.
                encoder.set_filter(Filter::NoFilter);
            }
            Pixels::Rgb(_) => {
                encoder.set_color(ColorType::Rgb);
                encoder.set_depth(BitDepth::Eight);
                encoder.set_filter(Filter::Adaptive);
            }
        }
        encoder
    }

    fn write<W: Write>(&self, encoder: Encoder<'_, W>) -> Result<(), EncodingError> {
        let mut writer = encoder.write_header()?;
        for frame in self.all() {
            match &self.pixels {
                Pixels::Indexed(palette, _) => {
                    writer.write_image_data(&pack(frame, self.width, palette.depth()))?;
                }
                Pixels::Rgb(_) => writer.write_image_data(frame)?,
            }
        }
        writer.finish()
    }
}

/// The crate's own conversion turns every error into text, a full disk as well.
fn plain(error: EncodingError) -> io::Error {
    match error {
        EncodingError::IoError(error) => error,
        other => io::Error::other(other),
    }
}
