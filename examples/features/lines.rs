//! Lines of one and of two pixels, and text in a font of embedded-graphics.

use aquatint::{Angle, Line, Scalar, StrokeStyle};
use embedded_graphics::{
    mono_font::{MonoTextStyle, ascii::FONT_6X10},
    prelude::*,
    text::{Baseline, Text},
};

use super::{BYTES, Feature, PANEL, Screen, black, send};
use crate::panel::{HEIGHT, WHITE};

/// A rose of lines that turns, and what it is.
pub struct Lines {
    bytes: [u8; BYTES],
}

impl Feature for Lines {
    const NEW: Self = Self { bytes: [0; BYTES] };

    fn draw(&mut self, number: u16, screen: &mut impl Screen) -> Option<()> {
        let mut picture = black(&mut self.bytes)?;
        for ray in 0..12 {
            let [from, to] = [1, 5].map(|fifths| polar(ray, number, fifths));
            let style = StrokeStyle::new(WHITE).with_width(1 + u16::from(ray % 3 == 0));
            let Ok(()) = Line::new(from, to).into_styled(style).draw(&mut picture);
        }
        let style = MonoTextStyle::new(&FONT_6X10, WHITE);
        let Ok(_) = Text::with_baseline("21.5 C", Point::new(2, 3), style, Baseline::Top).draw(&mut picture);
        send(&picture, screen);
        Some(())
    }
}

/// Where the twelve rays begin.
pub const CENTER: Point = Point::new(PANEL.right - HEIGHT.cast_signed() / 2, HEIGHT.cast_signed() / 2);

/// A point of one of twelve rays, so many fifths of its length from the centre.
pub fn polar(ray: u16, number: u16, fifths: i32) -> Point {
    let angle = Angle(ray * 5461 + number * 700);
    let radius = Scalar::from_num(HEIGHT / 2 - 1) * fifths / 5;
    CENTER + Point::new((angle.cos() * radius).to_num(), (angle.sin() * radius).to_num())
}
