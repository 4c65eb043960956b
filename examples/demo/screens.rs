//! Three panels, and the picture that is drawn on each: mesh, photograph, caption.

use aquatint::{
    Code, Dithered, Frame, Levels, Matrix, Model, Pages, Rect, Rows, World,
    display::{dither::Method, layout::Layout},
    model::mesh::Mesh,
};
use aquatint_simulator::{Panel, Zoom};
use embedded_graphics::{
    mono_font::{
        MonoFont, MonoTextStyle,
        ascii::{FONT_6X10, FONT_8X13, FONT_10X20},
    },
    pixelcolor::{BinaryColor, Gray4},
    prelude::*,
    text::{Alignment, Baseline, Text, TextStyleBuilder},
};

use crate::{
    parts::{show_mesh, show_photo, show_ramp},
    photo::Photo,
};

/// What is to be seen in a frame.
pub struct Content<'a> {
    pub mesh: Mesh<'a>,
    pub placement: Matrix<Model, World>,
    pub method: Method,
    pub caption: &'a str,
}

/// A panel, and the firmware's side of it: a frame in its layout.
pub struct Screen {
    pub panel: Panel,
    pub zoom: Zoom,
    pub file_name: &'static str,
    place: Place,
    photo: Photo,
    bytes: Vec<u8>,
    draw: fn(&mut Self, &Content<'_>) -> Result<(), String>,
}

/// Where things go.
#[derive(Clone, Copy)]
struct Place {
    mesh: Rect,
    photo: Rect,
    /// A strip that runs from black to white; may be empty.
    ramp: Rect,
    /// Centre of the caption's upper border.
    caption: Point,
    font: &'static MonoFont<'static>,
    /// Whether the panel is white where nothing is drawn, as paper.
    on_paper: bool,
}

const OLED: Place = Place {
    mesh: Rect::new(0, 0, 66, 64),
    photo: Rect::new(70, 0, 126, 53),
    ramp: Rect::new(0, 0, 0, 0),
    caption: Point::new(98, 55),
    font: &FONT_6X10,
    on_paper: false,
};

const MEMORY_LCD: Place = Place {
    mesh: Rect::new(14, 14, 194, 194),
    photo: Rect::new(206, 14, 386, 194),
    ramp: Rect::new(206, 206, 386, 226),
    caption: Point::new(104, 206),
    font: &FONT_10X20,
    on_paper: true,
};

const GREY_OLED: Place = Place {
    mesh: Rect::new(0, 0, 84, 64),
    photo: Rect::new(92, 0, 172, 64),
    ramp: Rect::new(182, 42, 250, 58),
    caption: Point::new(216, 14),
    font: &FONT_8X13,
    on_paper: false,
};

/// The three panels of the demo.
pub fn all(photo: &Photo) -> Vec<Screen> {
    let screen = |panel: Panel, file_name, place: Place| Screen {
        panel,
        zoom: Zoom { scale: 3, gap: 1 },
        file_name,
        place,
        photo: photo.fitted(place.photo.width() as usize, place.photo.height() as usize),
        bytes: vec![0; panel.byte_len()],
        draw: Screen::draw_as::<BinaryColor, Pages>,
    };
    let oled = screen(Panel::SSD1306_128X64, "oled-128x64", OLED);
    let memory_lcd = screen(Panel::SHARP_400X240, "memory-lcd-400x240", MEMORY_LCD);
    let grey_oled = screen(Panel::SSD1322_256X64, "grey-oled-256x64", GREY_OLED);
    vec![
        oled,
        // A gap would lay a light grid over black ink.
        Screen { zoom: Zoom { scale: 2, gap: 0 }, draw: Screen::draw_as::<BinaryColor, Rows>, ..memory_lcd },
        Screen { draw: Screen::draw_as::<Gray4, Rows>, ..grey_oled },
    ]
}

impl Screen {
    /// Draws a frame and gives the bytes that would go to the panel.
    pub fn draw(&mut self, content: &Content<'_>) -> Result<&[u8], String> {
        (self.draw)(self, content)?;
        Ok(&self.bytes)
    }

    fn draw_as<C: Code, L: Layout<C>>(&mut self, content: &Content<'_>) -> Result<(), String> {
        let (width, height) = (self.panel.width, self.panel.height);
        let mut frame = Frame::<C, L, _>::new(&mut self.bytes[..], width, height).map_err(|e| format!("{e:?}"))?;
        // Nothing that is drawn in memory can fail.
        let (place, white) = (self.place, C::from_code(u8::MAX));
        let (paper, ink) = if place.on_paper { (white, C::from_code(0)) } else { (C::from_code(0), white) };
        let Ok(()) = frame.clear(paper);
        let levels = if C::BITS == 1 { Levels::ONE_BIT } else { Levels::LINEAR_16 };
        let mut light = Dithered::new(&mut frame, levels).with_method(content.method);
        show_photo(&mut light, place.photo, &self.photo);
        show_ramp(&mut light, place.ramp);
        show_mesh(&mut light, place.mesh, content.mesh, content.placement)?;
        let style = MonoTextStyle::new(place.font, ink);
        let centred = TextStyleBuilder::new().alignment(Alignment::Center).baseline(Baseline::Top).build();
        let Ok(_) = Text::with_text_style(content.caption, place.caption, style, centred).draw(&mut frame);
        Ok(())
    }
}
