//! A star by either fill rule.

use aquatint::{Angle, FillStyle, Point2, Polygon, Rule, Scalar, Subpixel};
use embedded_graphics::prelude::*;

use super::{BYTES, Feature, PANEL, Screen, black, send};
use crate::panel::{HEIGHT, WHITE};

/// Two stars that turn.
pub struct Polygons {
    bytes: [u8; BYTES],
}

impl Feature for Polygons {
    const NEW: Self = Self { bytes: [0; BYTES] };

    fn draw(&mut self, number: u16, screen: &mut impl Screen) -> Option<()> {
        let mut picture = black(&mut self.bytes)?;
        for (quarter, rule) in [(1, Rule::NonZero), (3, Rule::EvenOdd)] {
            let star = star(PANEL.right * quarter / 4, number);
            let contours = [&star[..]];
            let polygon = Polygon::new(&contours).ok()?;
            let Ok(()) = polygon.into_styled(FillStyle::new(WHITE).with_rule(rule)).draw(&mut picture);
        }
        send(&picture, screen);
        Some(())
    }
}

/// Five corners around a column, each joined with the next but one.
pub fn star(column: i32, number: u16) -> [Point2; 5] {
    [0, 26_214, 52_428, 13_106, 39_320].map(|corner| {
        let angle = Angle(number * 900 + corner);
        let radius = Scalar::from_num(HEIGHT) / 2;
        let [x, y] = [angle.sin(), -angle.cos()].map(|part| Subpixel::from_num(part * radius));
        Point2::new(Subpixel::from_num(column) + x, Subpixel::from_num(HEIGHT / 2) + y)
    })
}
