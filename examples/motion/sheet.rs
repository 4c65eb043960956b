//! Pictures and words on one panel of 16 greys.

use aquatint::{Frame, Rows};
use aquatint_simulator::{Panel, Picture, Zoom};
use embedded_graphics::{
    image::GetPixel,
    mono_font::{MonoFont, MonoTextStyle, iso_8859_1::FONT_5X8, iso_8859_1::FONT_6X10},
    pixelcolor::Gray4,
    prelude::*,
    primitives::Rectangle,
    text::{Baseline, Text},
};

use crate::shutter::Film;

pub struct Sheet {
    film: Film,
}

impl Sheet {
    pub fn new(width: u32, height: u32) -> Result<Self, String> {
        let bytes = vec![0; Frame::<Gray4, Rows, ()>::bytes_needed(width, height)];
        Film::new(bytes, width, height).map(|film| Self { film }).map_err(|error| error.to_string())
    }

    /// Adds the light of a picture, its pixels `scale` times as large. Greys are equal steps of light.
    pub fn paste(&mut self, picture: &Film, at: Point, scale: u32) {
        let pixels = picture.bounding_box().points().filter_map(|place| Some((place, picture.pixel(place)?.luma())));
        for (place, light) in pixels.filter(|(_, light)| *light > 0) {
            let corner = at + place * scale.cast_signed();
            let there = self.film.pixel(corner).map_or(0, |grey| grey.luma());
            let Ok(()) = self
                .film
                .fill_solid(&Rectangle::new(corner, Size::new_equal(scale)), Gray4::new((there + light).min(15)));
        }
    }

    pub fn title(&mut self, text: &str, at: Point) {
        self.write(text, at, &FONT_6X10, Gray4::WHITE);
    }

    pub fn text(&mut self, text: &str, at: Point) {
        self.write(text, at, &FONT_5X8, Gray4::new(6));
    }

    fn write(&mut self, text: &str, at: Point, font: &MonoFont, grey: Gray4) {
        let Ok(_) = Text::with_baseline(text, at, MonoTextStyle::new(font, grey), Baseline::Top).draw(&mut self.film);
    }

    /// What the panel shows.
    pub fn picture(&self) -> Result<Picture, String> {
        let Size { width, height } = self.film.size();
        let panel = Panel { width, height, ..Panel::SSD1322_256X64 };
        panel.render(self.film.bytes(), Zoom { scale: 2, gap: 0 }).map_err(|error| error.to_string())
    }
}
