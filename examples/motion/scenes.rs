//! Three things that move.

use aquatint::{FillStyle, Oval, Point2, Polyline, StrokeStyle, Subpixel};
use embedded_graphics::{pixelcolor::BinaryColor, prelude::*};

/// When, and from where.
pub struct Moment {
    /// Number of the frame.
    pub frame: u16,
    /// How much of it is over, 0 to 1.
    pub part: f32,
    /// How far the picture is moved, in pixels.
    pub shift: [f32; 2],
}

/// What is seen.
pub enum Scene {
    /// A wheel of eight spokes that turns by so many degrees a frame. A mark on one of them tells the truth.
    Wheel { degrees: f32 },
    /// A bouncing ball.
    Ball,
    /// Discs of 0.6 pixels, each frame in the row of its number.
    Stars,
}

impl Scene {
    /// Columns and rows.
    pub const fn size(&self) -> Size {
        match self {
            Self::Wheel { .. } => Size::new(44, 44),
            Self::Ball => Size::new(352, 44),
            Self::Stars => Size::new(56, 20),
        }
    }

    /// Draws the scene as it is at a moment, on black.
    pub fn draw<D: DrawTarget<Color = BinaryColor>>(&self, display: &mut D, at: &Moment) -> Result<(), D::Error> {
        display.clear(BinaryColor::Off)?;
        let time = f32::from(at.frame) + at.part;
        match self {
            Self::Wheel { degrees } => wheel(display, degrees * time),
            Self::Ball => {
                // Bounces at times 2, 6, 10.
                let fall = ((time + 2.0) % 4.0 - 2.0) / 2.0;
                disc(display, [14.0 + 27.0 * time, 9.5 + 25.0 * fall * fall], 8.0)
            }
            Self::Stars => (0..5_u8).map(f32::from).try_for_each(|star| {
                let x = 3.2 + 10.3 * star + (0.2 + 0.1 * star) * time;
                disc(display, [x + at.shift[0], f32::from(at.frame) + 0.5 + at.shift[1]], 0.3)
            }),
        }
    }
}

fn wheel<D: DrawTarget<Color = BinaryColor>>(display: &mut D, turned: f32) -> Result<(), D::Error> {
    let style = StrokeStyle::new(BinaryColor::On);
    let place = |spoke: u8, radius: f32| {
        let (sin, cos) = (turned - 90.0 + 45.0 * f32::from(spoke)).to_radians().sin_cos();
        [22.0 + radius * cos, 22.0 + radius * sin]
    };
    for spoke in 0..8 {
        if let Ok(line) = Polyline::new(&[point(place(spoke, 3.0)), point(place(spoke, 19.0))]) {
            line.into_styled(style.with_width(2)).draw(display)?;
        }
    }
    if let Ok(rim) = Oval::circle(point([22.0, 22.0]), Subpixel::from_num(19.5)) {
        rim.into_styled(style.with_width(3)).draw(display)?;
    }
    disc(display, [22.0, 22.0], 4.0)?;
    disc(display, place(0, 14.0), 3.5)
}

fn disc<D: DrawTarget<Color = BinaryColor>>(display: &mut D, center: [f32; 2], radius: f32) -> Result<(), D::Error> {
    let Ok(disc) = Oval::circle(point(center), Subpixel::from_num(radius)) else { return Ok(()) };
    disc.into_styled(FillStyle::new(BinaryColor::On)).draw(display)
}

fn point([x, y]: [f32; 2]) -> Point2 {
    Point2::new(Subpixel::from_num(x), Subpixel::from_num(y))
}
