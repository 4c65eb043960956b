//! Three panels, and the picture that is drawn on each: mesh, photograph, caption.

use aquatint::{
    Code, Dithered, Frame, Levels, Light, Matrix, Model, Pages, Rect, Rows, Solid, Target, World,
    display::{dither::Method, layout::Layout},
    hidden::depth::DepthBuffer,
    model::mesh::Mesh,
    pipeline::{Instance, MeshVertex, Workspace, draw_mesh},
};
use aquatint_simulator::{Panel, Zoom};
use embedded_graphics::{
    mono_font::{MonoTextStyle, ascii::FONT_5X8},
    pixelcolor::{BinaryColor, Gray4},
    prelude::*,
    text::{Alignment, Baseline, Text, TextStyleBuilder},
};

use crate::{photo::Photo, scene};

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

/// Where things go, and in which light and ink.
#[derive(Clone, Copy)]
struct Place {
    mesh: Rect,
    background: Light,
    photo: Rect,
    caption: Point,
    /// The code of the caption: the last one on a panel that glows, 0 for ink on paper.
    ink: u8,
}

/// The three panels of the demo.
pub fn all(photo: &Photo) -> Vec<Screen> {
    let (oled, memory_lcd, grey) = (Panel::SSD1306_128X64, Panel::SHARP_400X240, Panel::SSD1322_256X64);
    let screen = |panel: Panel, file_name, place: Place| Screen {
        panel,
        zoom: Zoom { scale: 3, gap: 1 },
        file_name,
        place,
        photo: photo.fitted(place.photo.width() as usize, place.photo.height() as usize),
        bytes: vec![0; panel.byte_len()],
        draw: Screen::draw_as::<BinaryColor, Pages>,
    };
    vec![
        screen(
            oled,
            "oled-128x64",
            Place {
                mesh: Rect::new(0, 0, 64, 64),
                background: Light::BLACK,
                photo: Rect::new(68, 0, 124, 54),
                caption: Point::new(96, 56),
                ink: 1,
            },
        ),
        Screen {
            zoom: Zoom { scale: 2, gap: 0 },
            draw: Screen::draw_as::<BinaryColor, Rows>,
            ..screen(
                memory_lcd,
                "memory-lcd-400x240",
                Place {
                    mesh: Rect::new(0, 0, 220, 240),
                    background: Light(58_000),
                    photo: Rect::new(220, 20, 390, 210),
                    caption: Point::new(305, 220),
                    ink: 0,
                },
            )
        },
        Screen {
            draw: Screen::draw_as::<Gray4, Rows>,
            ..screen(
                grey,
                "grey-oled-256x64",
                Place {
                    mesh: Rect::new(0, 0, 84, 64),
                    background: Light::BLACK,
                    photo: Rect::new(88, 0, 168, 64),
                    caption: Point::new(214, 28),
                    ink: 15,
                },
            )
        },
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
        let Ok(()) = frame.clear(C::from_code(0));
        let levels = if C::BITS == 1 { Levels::ONE_BIT } else { Levels::LINEAR_16 };
        let mut light = Dithered::new(&mut frame, levels).with_method(content.method);
        fill(&mut light, Rect::new(0, 0, i32::MAX, i32::MAX), self.place.background);
        show_photo(&mut light, self.place.photo, &self.photo);
        spin(&mut light, self.place.mesh, content)?;
        let style = MonoTextStyle::new(&FONT_5X8, C::from_code(self.place.ink));
        let centred = TextStyleBuilder::new().alignment(Alignment::Center).baseline(Baseline::Top).build();
        let Ok(_) = Text::with_text_style(content.caption, self.place.caption, style, centred).draw(&mut frame);
        Ok(())
    }
}

type NoError = core::convert::Infallible;

fn fill(target: &mut impl Target<Color = Light, Error = NoError>, area: Rect, light: Light) {
    for row in area.intersection(target.bounds()).rows() {
        let Ok(()) = target.fill_run(row, area.columns(), &Solid(light));
    }
}

fn show_photo(target: &mut impl Target<Color = Light, Error = NoError>, place: Rect, photo: &Photo) {
    for (row, lights) in place.rows().zip(photo.rows()) {
        let Ok(()) = target.write_run(row, place.columns(), lights.iter().copied().map(Some));
    }
}

fn spin(
    target: &mut impl Target<Color = Light, Error = NoError>,
    place: Rect,
    content: &Content<'_>,
) -> Result<(), String> {
    let mut vertices = vec![MeshVertex::default(); content.mesh.positions().len()];
    let mut depths = vec![0; place.width() as usize * place.height() as usize];
    let mut depth = DepthBuffer::new(&mut depths, place).map_err(|e| format!("{e:?}"))?;
    let mut workspace = Workspace { vertices: &mut vertices, depth: &mut depth };
    let camera = scene::camera(place).ok_or("no camera")?;
    let instance = Instance { mesh: content.mesh, placement: content.placement };
    draw_mesh(&instance, &camera, &mut workspace, target).map_err(|e| format!("{e:?}"))
}
