//! Antialiased drawings of any primitives on a frame of four bits: no panic, nothing outside of the part that is seen,
//! and in bands what the whole shows.
#![no_main]

use aquatint::{
    Alpha, AntialiasedStyle, BlendMode, Blended, Cap, Coverage, CoverageCurve, Frame, Join, Rows, Stroke, Subpixel,
    Window,
};
use arbitrary::Arbitrary;
use embedded_graphics::{
    pixelcolor::Gray4,
    prelude::*,
    primitives::{Circle, Ellipse, Line, Polyline, Rectangle, RoundedRectangle, Triangle},
};
use libfuzzer_sys::fuzz_target;

#[derive(Arbitrary, Clone, Copy, Debug)]
enum Place {
    Near(i8, i8),
    Far(i32, i32),
}

#[derive(Arbitrary, Clone, Copy, Debug)]
enum Extent {
    Small(u8, u8),
    Large(u32, u32),
}

#[derive(Arbitrary, Clone, Copy, Debug)]
enum Shape {
    Line(Place, Place),
    Circle(Place, u8),
    LargeCircle(Place, u32),
    Ellipse(Place, Extent),
    Triangle(Place, Place, Place),
    Polyline(Place, Place, Place),
    Rectangle(Place, Extent),
    RoundedRectangle(Place, Extent, u8),
    Glass(Place, Extent),
}

#[derive(Arbitrary, Debug)]
struct Input {
    shapes: Vec<(Shape, Style)>,
    mode: u8,
    band: u8,
}

#[derive(Arbitrary, Clone, Copy, Debug)]
struct Style {
    fill: Option<u8>,
    stroke: Option<u8>,
    width: u8,
    join: u8,
    cap: u8,
    curve: i8,
    parts: u16,
}

impl From<Place> for Point {
    fn from(place: Place) -> Self {
        match place {
            Place::Near(x, y) => Self::new(x.into(), y.into()),
            Place::Far(x, y) => Self::new(x, y),
        }
    }
}

impl From<Extent> for Size {
    fn from(extent: Extent) -> Self {
        match extent {
            Extent::Small(width, height) => Self::new((width % 40).into(), (height % 40).into()),
            Extent::Large(width, height) => Self::new(width, height),
        }
    }
}

impl Style {
    fn style(self) -> AntialiasedStyle<Gray4> {
        let join = [Join::Miter { limit: 4 }, Join::Round, Join::Bevel][usize::from(self.join) % 3];
        let cap = [Cap::Butt, Cap::Round, Cap::Square][usize::from(self.cap) % 3];
        let stroke = Stroke::of_width(Subpixel::from_bits(self.width.into())).with_join(join).with_cap(cap);
        let percent = self.curve.unsigned_abs();
        let curve = if self.curve < 0 { CoverageCurve::thinner(percent) } else { CoverageCurve::bolder(percent) };
        AntialiasedStyle {
            fill_color: self.fill.map(Gray4::new),
            stroke_color: self.stroke.map(Gray4::new),
            ..AntialiasedStyle::stroke(Gray4::WHITE, 1).with_shape(stroke).with_curve(curve)
        }
    }
}

fn draw<D: DrawTarget<Color = Alpha<Gray4>>>(shape: Shape, styled: Style, target: &mut D) -> Result<(), D::Error> {
    let style = styled.style();
    match shape {
        Shape::Line(from, to) => Line::new(from.into(), to.into()).into_styled(style).draw(target),
        Shape::Circle(at, diameter) => Circle::new(at.into(), diameter.into()).into_styled(style).draw(target),
        Shape::LargeCircle(at, diameter) => Circle::new(at.into(), diameter).into_styled(style).draw(target),
        Shape::Ellipse(at, size) => Ellipse::new(at.into(), size.into()).into_styled(style).draw(target),
        Shape::Triangle(a, b, c) => Triangle::new(a.into(), b.into(), c.into()).into_styled(style).draw(target),
        Shape::Polyline(a, b, c) => Polyline::new(&[a.into(), b.into(), c.into()]).into_styled(style).draw(target),
        Shape::Rectangle(at, size) => Rectangle::new(at.into(), size.into()).into_styled(style).draw(target),
        Shape::RoundedRectangle(at, size, radius) => {
            let area = Rectangle::new(at.into(), size.into());
            let shape = RoundedRectangle::with_equal_corners(area, Size::new_equal(radius.into()));
            shape.into_styled(style).draw(target)
        }
        Shape::Glass(at, size) => {
            let color = Alpha::new(Gray4::new(styled.width), Coverage::new(styled.parts));
            target.fill_solid(&Rectangle::new(at.into(), size.into()), color)
        }
    }
}

fuzz_target!(|input: Input| {
    let modes = [
        BlendMode::Over,
        BlendMode::Add,
        BlendMode::Multiply,
        BlendMode::Screen,
        BlendMode::Darken,
        BlendMode::Lighten,
    ];
    let mode = modes[usize::from(input.mode) % 6];
    let mut whole = Frame::<Gray4, Rows, _>::with_array([0x5A; 192], 24, 16).expect("memory enough");
    let mut banded = Frame::<Gray4, Rows, _>::with_array([0x5A; 192], 24, 16).expect("memory enough");
    let edge = i32::from(input.band % 16);
    for (shape, style) in input.shapes.iter().take(6) {
        let Ok(()) = draw(*shape, *style, &mut Blended::new(&mut whole).with_mode(mode));
    }
    // The same on two parts, one above the other, where each is seen in the place that it has.
    for rows in [0..edge, edge..16] {
        let mut band = Frame::<Gray4, Rows, _>::with_array([0x5A; 192], 24, 16).expect("memory enough");
        let mut window = Window::band(&mut band, rows.start);
        for (shape, style) in input.shapes.iter().take(6) {
            let Ok(()) = draw(*shape, *style, &mut Blended::new(&mut window).with_mode(mode));
        }
        let height = rows.len();
        banded_rows(&mut banded, rows.start, &band.bytes()[..height * 12]);
    }
    assert_eq!(whole.bytes(), banded.bytes());
});

/// Copies rows of 12 bytes into a frame.
fn banded_rows(frame: &mut Frame<Gray4, Rows, [u8; 192]>, top: i32, bytes: &[u8]) {
    let area = Rectangle::new(Point::new(0, top), Size::new(24, u32::try_from(bytes.len() / 12).expect("few")));
    let colors = bytes.iter().flat_map(|byte| [Gray4::new(byte >> 4), Gray4::new(byte & 15)]);
    let Ok(()) = frame.fill_contiguous(&area, colors);
}
