//! Rings, and the space between them flooded with patterns.

use aquatint::{
    Circle, Flood, Line, Pattern, StrokeStyle,
    fragment::pattern::hatch,
    raster::flood::{Run, words_needed},
};
use embedded_graphics::prelude::*;

use super::{
    BYTES, Feature, Screen, black,
    lines::{CENTER, polar},
    send,
};
use crate::panel::{BLACK, HEIGHT, WHITE, WIDTH};

/// Rings with a wall that turns; what it parts is flooded.
pub struct Floods {
    bytes: [u8; BYTES],
    visited: [u32; words_needed(WIDTH, HEIGHT)],
    queue: [Run; 8],
}

impl Feature for Floods {
    const NEW: Self = Self { bytes: [0; BYTES], visited: [0; words_needed(WIDTH, HEIGHT)], queue: [Run::EMPTY; 8] };

    fn draw(&mut self, number: u16, screen: &mut impl Screen) -> Option<()> {
        let Self { bytes, visited, queue } = self;
        let mut picture = black(bytes)?;
        let style = StrokeStyle::new(WHITE);
        for diameter in [HEIGHT - 1, HEIGHT / 2] {
            let Ok(()) = Circle::with_center(CENTER, diameter).into_styled(style).draw(&mut picture);
        }
        for ray in [0, 3, 7] {
            let [from, to] = [1, 5].map(|fifths| polar(ray, number, fifths));
            let Ok(()) = Line::new(from, to).into_styled(style).draw(&mut picture);
        }
        let mut flood = Flood::new(visited, queue);
        flood.fill_with(&mut picture, Point::new(0, 0), Pattern::from_bits(hatch::DOTS, WHITE, BLACK)).ok()?;
        let between = polar(1, number, 4);
        flood.fill_with(&mut picture, between, Pattern::from_bits(hatch::DIAGONAL, WHITE, BLACK)).ok()?;
        send(&picture, screen);
        Some(())
    }
}
