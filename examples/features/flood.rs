//! Rings, and the space between them flooded with patterns.

use aquatint::{
    Circle, Flood, Line, Pattern, StrokeStyle,
    fragment::pattern::hatch,
    raster::flood::{Run, words_needed},
};
use embedded_graphics::prelude::*;

use super::{Feature, PICTURE, Picture, Screen, lines::{CENTER, polar}, send};
use crate::panel::{BLACK, HEIGHT, WHITE, WIDTH};

/// Rings with a wall that turns; what it parts is flooded.
pub struct Floods {
    picture: Picture,
    visited: [u32; words_needed(WIDTH, HEIGHT)],
    queue: [Run; 8],
}

impl Feature for Floods {
    const NEW: Self =
        Self { picture: PICTURE, visited: [0; words_needed(WIDTH, HEIGHT)], queue: [Run::EMPTY; 8] };

    fn draw(&mut self, number: u16, screen: &mut impl Screen) -> Option<()> {
        let Self { picture, visited, queue } = self;
        let Ok(()) = picture.clear(BLACK);
        let style = StrokeStyle::new(WHITE);
        for diameter in [HEIGHT - 1, HEIGHT / 2] {
            let Ok(()) = Circle::with_center(CENTER, diameter).into_styled(style).draw(picture);
        }
        for ray in [0, 3, 7] {
            let [from, to] = [1, 5].map(|fifths| polar(ray, number, fifths));
            let Ok(()) = Line::new(from, to).into_styled(style).draw(picture);
        }
        let mut flood = Flood::new(visited, queue);
        flood.fill_with(picture, Point::new(0, 0), Pattern::from_bits(hatch::DOTS, WHITE, BLACK)).ok()?;
        let between = polar(1, number, 4);
        flood.fill_with(picture, between, Pattern::from_bits(hatch::DIAGONAL, WHITE, BLACK)).ok()?;
        send(picture, screen)
    }
}
