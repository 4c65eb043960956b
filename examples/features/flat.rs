//! What the smallest pictures are made of: lines, a polygon, dithered light.

use aquatint::{
    Brush, Dithered, Light, Line, Polygon, Rule, StrokeStyle,
    raster::scan::{ActiveEdge, fill},
};
use embedded_graphics::prelude::*;
use heapless::Vec as List;

use super::{BYTES, Feature, Screen, black, lines::polar, polygons::star, send};
use crate::panel::{HEIGHT, LEVELS, WHITE};

/// A star in half of the light, and two lines.
pub struct Flat {
    bytes: [u8; BYTES],
    edges: List<ActiveEdge, 6>,
}

impl Feature for Flat {
    const NEW: Self = Self { bytes: [0; BYTES], edges: List::new() };

    fn draw(&mut self, number: u16, screen: &mut impl Screen) -> Option<()> {
        let mut picture = black(&mut self.bytes)?;
        let star = star(HEIGHT.cast_signed() / 2, number);
        let contours = [&star[..]];
        let mut light = Dithered::new(&mut picture, LEVELS);
        let polygon = Polygon::new(&contours).ok()?;
        let Ok(()) = fill(&polygon, Rule::NonZero, &mut self.edges, &mut Brush::new(&mut light, Light(32_768)));
        for ray in [1, 2] {
            let line = Line::new(polar(ray, number, 5), polar(ray + 6, number, 5));
            let Ok(()) = line.into_styled(StrokeStyle::new(WHITE)).draw(&mut picture);
        }
        send(&picture, screen);
        Some(())
    }
}
