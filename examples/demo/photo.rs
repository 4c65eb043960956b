//! A photograph as light, scaled to the place where it goes.

use std::{fs::File, io::BufReader, path::Path};

use aquatint::Light;

/// Rows of light.
#[derive(Clone, Debug)]
pub struct Photo {
    width: usize,
    height: usize,
    lights: Vec<Light>,
}

/// Larger pictures are refused rather than held in memory.
const MOST_PIXELS: usize = 1 << 26;

/// Reads a PNG of any kind; what went wrong is a line that a person can act on.
pub fn load(path: &Path) -> Result<Photo, String> {
    let file = File::open(path).map_err(|e| e.to_string())?;
    decode(BufReader::new(file))
}

/// Decodes a PNG into light: colours become luminance, transparent pixels black.
pub fn decode(png: impl std::io::BufRead + std::io::Seek) -> Result<Photo, String> {
    let mut decoder = png::Decoder::new(png);
    decoder.set_transformations(png::Transformations::normalize_to_color8());
    let mut reader = decoder.read_info().map_err(|e| format!("is not a PNG file: {e}"))?;
    let (width, height) = (reader.info().width as usize, reader.info().height as usize);
    if width.saturating_mul(height) > MOST_PIXELS {
        return Err(format!("has {width} x {height} pixels; {MOST_PIXELS} are the limit"));
    }
    let mut bytes = vec![0; reader.output_buffer_size().ok_or("is too large")?];
    let info = reader.next_frame(&mut bytes).map_err(|e| format!("is a broken PNG file: {e}"))?;
    let samples = info.color_type.samples();
    let light = |pixel: &[u8]| match *pixel {
        [grey] => Light::from_srgb(grey),
        [grey, alpha] => faded(Light::from_srgb(grey), alpha),
        [r, g, b] => Light::from_srgb_colour([r, g, b]),
        [r, g, b, alpha] => faded(Light::from_srgb_colour([r, g, b]), alpha),
        _ => Light::BLACK,
    };
    Ok(Photo { width, height, lights: bytes[..info.buffer_size()].chunks_exact(samples).map(light).collect() })
}

#[expect(clippy::cast_possible_truncation, reason = "a part of 16 bits has 16 bits")]
fn faded(light: Light, alpha: u8) -> Light {
    Light((u32::from(light.0) * u32::from(alpha) / 255) as u16)
}

impl Photo {
    /// The photograph cut to the proportions of a place and scaled to it, by averaging light.
    pub fn fitted(&self, width: usize, height: usize) -> Self {
        // The largest part from the middle that has the right proportions.
        let part_width = self.width.min(self.height * width / height.max(1)).max(1);
        let part_height = self.height.min(self.width * height / width.max(1)).max(1);
        let (left, top) = ((self.width - part_width) / 2, (self.height - part_height) / 2);
        let source = |at: usize, size: usize, part: usize| {
            let from = at * part / size;
            from..((at + 1) * part).div_ceil(size).max(from + 1)
        };
        let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        let lights = pixels.map(|(x, y)| {
            let (columns, rows) = (source(x, width, part_width), source(y, height, part_height));
            let row = |y: usize| &self.lights[(top + y) * self.width + left..][columns.clone()];
            let sum: u64 = rows.clone().flat_map(row).map(|light| u64::from(light.0)).sum();
            Light(u16::try_from(sum / (columns.len() * rows.len()) as u64).unwrap_or(u16::MAX))
        });
        Self { width, height, lights: lights.collect() }
    }

    /// The rows from the top.
    pub fn rows(&self) -> impl Iterator<Item = &[Light]> {
        self.lights.chunks(self.width.max(1))
    }
}
