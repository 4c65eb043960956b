//! A photograph in colour, and its light.

use std::{fs::File, io::BufReader, path::Path};

use aquatint::{
    Light,
    display::scale::{Filter, Scaler},
};
use embedded_graphics::geometry::Size;

/// sRGB, row by row.
#[derive(Clone, Debug)]
pub struct Photo {
    pub size: Size,
    pub pixels: Vec<[u8; 3]>,
}

/// Larger pictures are refused rather than held in memory.
const MOST_PIXELS: usize = 1 << 26;
/// No picture on the sheet is longer.
const MOST_ROWS: u32 = 4096;

/// Reads a PNG of any kind; what went wrong is a line that a person can act on.
pub fn load(path: &Path) -> Result<Photo, String> {
    let file = File::open(path).map_err(|error| error.to_string())?;
    let mut decoder = png::Decoder::new(BufReader::new(file));
    decoder.set_transformations(png::Transformations::normalize_to_color8());
    let mut reader = decoder.read_info().map_err(|error| format!("is not a PNG file: {error}"))?;
    let size = Size::new(reader.info().width, reader.info().height);
    if (size.width as usize).saturating_mul(size.height as usize) > MOST_PIXELS {
        return Err(format!("has {} x {} pixels; {MOST_PIXELS} are the limit", size.width, size.height));
    }
    let mut bytes = vec![0; reader.output_buffer_size().ok_or("is too large")?];
    let info = reader.next_frame(&mut bytes).map_err(|error| format!("is a broken PNG file: {error}"))?;
    let pixels = bytes[..info.buffer_size()].chunks_exact(info.color_type.samples()).map(on_black);
    Ok(Photo { size, pixels: pixels.collect() })
}

/// A pixel of one to four samples, where it is transparent on black.
fn on_black(samples: &[u8]) -> [u8; 3] {
    let (color, alpha) = match *samples {
        [grey] => ([grey; 3], 255),
        [grey, alpha] => ([grey; 3], alpha),
        [r, g, b] => ([r, g, b], 255),
        [r, g, b, alpha] => ([r, g, b], alpha),
        _ => ([0; 3], 0),
    };
    let faded = |code| u32::from(Light::from_srgb(code).0) * u32::from(alpha) / 255;
    color.map(|code| Light(u16::try_from(faded(code)).unwrap_or(u16::MAX)).to_srgb())
}

impl Photo {
    /// Light from the top left to the bottom right.
    pub fn lights(&self) -> impl DoubleEndedIterator<Item = Light> + ExactSizeIterator {
        self.pixels.iter().map(|color| Light::from_srgb_colour(*color))
    }

    /// The rows of light from the top.
    pub fn rows(&self) -> impl Iterator<Item = Vec<Light>> {
        self.pixels
            .chunks(self.size.width as usize)
            .map(|row| row.iter().map(|c| Light::from_srgb_colour(*c)).collect())
    }

    /// Scaled in its proportions.
    pub fn scaled_to_width(&self, width: u32) -> Result<Self, String> {
        let height = u64::from(self.size.height) * u64::from(width) / u64::from(self.size.width.max(1));
        let size = Size::new(width, u32::try_from(height).unwrap_or(u32::MAX).max(1));
        if size.height > MOST_ROWS {
            return Err(format!("the photograph is too long: {} rows of {width} pixels", size.height));
        }
        let filter = if width < self.size.width { Filter::Area } else { Filter::Bilinear };
        let mut pixels = vec![[0; 3]; size.width as usize * size.height as usize];
        for channel in 0..3 {
            let mut memory = vec![0; Scaler::memory_needed(size)];
            let mut scaler = Scaler::new(&mut memory, self.size, size, filter).map_err(|error| error.to_string())?;
            let mut places = pixels.iter_mut();
            for row in self.pixels.chunks(self.size.width as usize) {
                let lights = row.iter().map(|color| Light::from_srgb(color[channel]));
                scaler.push(lights, |_, row| {
                    row.zip(places.by_ref()).for_each(|(light, pixel)| pixel[channel] = light.to_srgb());
                    Ok::<(), String>(())
                })?;
            }
        }
        Ok(Self { size, pixels })
    }
}
