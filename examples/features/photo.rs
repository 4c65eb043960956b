//! A photograph from flash, dithered.

use aquatint::{Dithered, Light, Target};

use super::{BYTES, Feature, PANEL, Screen, frame, send};
use crate::panel::LEVELS;

/// 128 × 64 sRGB codes.
static CODES: [u8; WIDTH * 64] = *include_bytes!("../assets/photo.gray");
const WIDTH: usize = 128;

/// A photograph that passes by.
pub struct Photo {
    bytes: [u8; BYTES],
}

impl Feature for Photo {
    const NEW: Self = Self { bytes: [0; BYTES] };

    fn draw(&mut self, number: u16, screen: &mut impl Screen) -> Option<()> {
        let mut picture = frame(&mut self.bytes)?;
        let mut light = Dithered::new(&mut picture, LEVELS);
        // Panels that are lower than the photograph show the face.
        let above = usize::try_from((64 - PANEL.bottom) / 3).ok()?;
        for (row, codes) in PANEL.rows().zip(CODES.chunks_exact(WIDTH).skip(above)) {
            let codes = codes.iter().cycle().skip(usize::from(number) * 8);
            let Ok(()) = light.write_run(row, PANEL.columns(), codes.map(|&code| Some(Light::from_srgb(code))));
        }
        send(&picture, screen);
        Some(())
    }
}
