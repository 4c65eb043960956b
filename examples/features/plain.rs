//! The same lines and stars by embedded-graphics alone, on a framebuffer of its own.

use aquatint::{Angle, Scalar};
use embedded_graphics::{
    framebuffer::{Framebuffer, buffer_size},
    mono_font::{MonoTextStyle, ascii::FONT_6X10},
    pixelcolor::raw::{BigEndian, RawU4},
    prelude::*,
    primitives::{Line, PrimitiveStyle, Triangle},
    text::{Baseline, Text},
};

use crate::{
    features::{Feature, PANEL, Screen, lines::polar},
    panel::{BLACK, Color, HEIGHT, WHITE, WIDTH},
};

const BYTES: usize = buffer_size::<Color>(WIDTH as usize, HEIGHT as usize);

type Picture = Framebuffer<Color, RawU4, BigEndian, { WIDTH as usize }, { HEIGHT as usize }, BYTES>;

fn send(picture: &Picture, screen: &mut impl Screen) {
    screen.window(PANEL);
    screen.data(picture.data());
}

/// The rose of lines, and text.
pub struct Lines {
    picture: Picture,
}

impl Feature for Lines {
    const NEW: Self = Self { picture: Picture::new() };

    fn draw(&mut self, number: u16, screen: &mut impl Screen) -> Option<()> {
        let Ok(()) = self.picture.clear(BLACK);
        for ray in 0..12 {
            let [from, to] = [1, 5].map(|fifths| polar(ray, number, fifths));
            let style = PrimitiveStyle::with_stroke(WHITE, 1 + u32::from(ray % 3 == 0));
            let Ok(()) = Line::new(from, to).into_styled(style).draw(&mut self.picture);
        }
        let style = MonoTextStyle::new(&FONT_6X10, WHITE);
        let Ok(_) = Text::with_baseline("21.5 C", Point::new(2, 3), style, Baseline::Top).draw(&mut self.picture);
        send(&self.picture, screen);
        Some(())
    }
}

/// The two stars, of triangles on whole pixels: five for the tips, three for what is between them.
pub struct Polygons {
    picture: Picture,
}

impl Feature for Polygons {
    const NEW: Self = Self { picture: Picture::new() };

    fn draw(&mut self, number: u16, screen: &mut impl Screen) -> Option<()> {
        let Ok(()) = self.picture.clear(BLACK);
        for quarter in [1, 3] {
            let corners = corners(PANEL.right * quarter / 4, number);
            let tips = [0, 2, 4, 6, 8].map(|tip| [(tip + 9) % 10, tip, tip + 1]);
            let between = [[1, 3, 5], [1, 5, 7], [1, 7, 9]];
            let between = if quarter == 1 { &between[..] } else { &[] };
            for triangle in tips.iter().chain(between) {
                let [a, b, c] = triangle.map(|corner| corners[corner]);
                let style = PrimitiveStyle::with_fill(WHITE);
                let Ok(()) = Triangle::new(a, b, c).into_styled(style).draw(&mut self.picture);
            }
        }
        send(&self.picture, screen);
        Some(())
    }
}

/// The outline of a star around a column: tips and the corners between them by turns.
fn corners(column: i32, number: u16) -> [Point; 10] {
    // In the golden ratio, twice.
    let radii = [Scalar::from_num(HEIGHT) / 2, Scalar::from_num(HEIGHT) * 191 / 1000];
    let (mut angle, mut points) = (Angle(number * 900), [Point::zero(); 10]);
    for (point, radius) in points.iter_mut().zip(radii.into_iter().cycle()) {
        let [x, y] = [angle.sin(), -angle.cos()].map(|part| (part * radius).round().to_num::<i32>());
        *point = Point::new(column + x, HEIGHT.cast_signed() / 2 + y);
        angle.0 = angle.0.wrapping_add(6553);
    }
    points
}
