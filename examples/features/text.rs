//! Text of any size with soft borders, in a font of strokes from flash.

use aquatint::{Affine, Angle, AntialiasedStyle, Blended, Dithered, Hershey, Light, Point2, Stroke, Subpixel, Text};
use embedded_graphics::prelude::*;

use super::{BYTES, Feature, PANEL, Screen, black, send};
use crate::panel::{HEIGHT, LEVELS};

/// Words that turn and grow.
pub struct Texts {
    bytes: [u8; BYTES],
}

impl Feature for Texts {
    const NEW: Self = Self { bytes: [0; BYTES] };

    fn draw(&mut self, number: u16, screen: &mut impl Screen) -> Option<()> {
        let mut picture = black(&mut self.bytes)?;
        let mut light = Dithered::new(&mut picture, LEVELS);
        let mut soft = Blended::new(&mut light);
        let style = AntialiasedStyle::stroke(Light::WHITE, 1).with_shape(Stroke::of_width(Subpixel::from_num(1.5)));
        let size = Subpixel::from_num(HEIGHT / 4 + 6 + u32::from(number) * 2);
        let at = Point2::corner(3, PANEL.bottom * 3 / 4);
        let text = Text::new(&Hershey::SIMPLEX, "Aqua 21", size, at).with_map(Affine::turn(Angle(number * 300)));
        let Ok(()) = text.into_styled(style).draw(&mut soft);
        send(&picture, screen);
        Some(())
    }
}
