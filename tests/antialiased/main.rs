//! Antialiased drawings: blended in light, on every kind of target, against real numbers.
#![expect(clippy::cast_sign_loss, reason = "small, and tested before")]

mod light;
mod modes;
mod pictures;
mod primitives;
#[cfg(feature = "ttf")]
mod text;

use std::convert::Infallible;

use aquatint::{
    Affine, Alpha, Angle, AntialiasedStyle, Blend, Blended, Coverage, Covered, Hershey, LinearGradient, Oval, Point2,
    Rule, Sink, Stroke, Subpixel, Target, Text,
    raster::area::{AreaEdge, Scratch, fill},
};
use embedded_graphics::{
    image::GetPixel,
    prelude::*,
    primitives::{Circle, Line, Rectangle},
};
use heapless::Vec as List;

/// The size of the scene.
const SIZE: Size = Size::new(64, 40);

/// How many drawings the scene has.
const DRAWINGS: usize = 8;

/// One of the drawings of the scene; `shade` makes a colour of an 8-bit grey.
fn draw<C: PixelColor, D: DrawTarget<Color = Alpha<C>>>(
    which: usize,
    shade: impl Fn(u8) -> C,
    target: &mut D,
) -> Result<(), D::Error> {
    let line = |y: i32| Line::new(Point::new(2, y), Point::new(27, y + 6));
    let stroke = |sixteenths| {
        let stroke = Stroke::of_width(Subpixel::from_bits(sixteenths));
        AntialiasedStyle::stroke(shade(255), 1).with_shape(stroke)
    };
    match which {
        0 => Circle::new(Point::new(1, 1), 15).into_styled(AntialiasedStyle::fill(shade(255))).draw(target),
        1 => Circle::new(Point::new(18, 1), 15).into_styled(AntialiasedStyle::stroke(shade(255), 3)).draw(target),
        2 => {
            let style = AntialiasedStyle::fill(shade(85)).with_stroke(shade(255), 1);
            Rectangle::new(Point::new(36, 2), Size::new(11, 8)).into_styled(style).draw(target)
        }
        3 => line(18).into_styled(stroke(4)).draw(target),
        4 => line(22).into_styled(stroke(16)).draw(target),
        5 => line(28).into_styled(stroke(48)).draw(target),
        6 => {
            let text = Text::new(&Hershey::SIMPLEX, "soft", Subpixel::from_num(16), Point2::corner(31, 37));
            let turned = text.with_map(Affine::turn(Angle::from_degrees(-15.0)));
            turned.into_styled(stroke(20)).draw(target)
        }
        // A shadow that one sees through.
        _ => target.fill_solid(
            &Rectangle::new(Point::new(8, 8), Size::new(20, 3)),
            Alpha::new(shade(0), Coverage::from_byte(128)),
        ),
    }
}

/// An oval with a ramp of greys, from dark on the left to bright.
fn draw_ramp<T>(shade: impl Fn(u8) -> <T as Target>::Color, target: &mut T)
where
    T: Target<Error = Infallible> + GetPixel<Color = <T as Target>::Color>,
    <T as Target>::Color: Blend,
{
    let ramp = |number: u16| shade(number.to_be_bytes()[0]);
    let gradient = LinearGradient::new(Point2::corner(50, 0), Point2::corner(63, 0), ramp);
    cover(&ramped(), &mut Blended::new(target).brush(gradient));
}

fn ramped() -> Oval {
    Oval::new(Point2::corner(56, 8), [6, 7].map(Subpixel::from_num)).expect("in range")
}

/// Gives the coverage of an outline.
fn cover<S: for<'c> Sink<Covered<'c>, Error = Infallible>>(outline: &impl aquatint::Outline, sink: &mut S) {
    let (mut edges, mut cells) = (List::<AreaEdge, 64>::new(), [Coverage::NONE; 64]);
    let Ok(()) = fill(outline, Rule::NonZero, Scratch { edges: &mut edges, cells: &mut cells }, sink);
}

/// All of the scene.
fn draw_all<T>(shade: impl Fn(u8) -> <T as Target>::Color + Copy, target: &mut T)
where
    T: Target<Error = Infallible> + GetPixel<Color = <T as Target>::Color>,
    <T as Target>::Color: Blend,
{
    for which in 0..DRAWINGS {
        let Ok(()) = draw(which, shade, &mut Blended::new(target));
    }
    draw_ramp(shade, target);
}

/// Keeps what is drawn: the last colour of each pixel, and how often one is drawn.
struct Record<C> {
    size: Size,
    pixels: Vec<(Option<Alpha<C>>, usize)>,
}

impl<C: Copy> Record<C> {
    fn new(size: Size) -> Self {
        Self { size, pixels: vec![(None, 0); (size.width * size.height) as usize] }
    }

    fn at(&self, Point { x, y }: Point) -> Option<Alpha<C>> {
        self.pixels[y as usize * self.size.width as usize + x as usize].0
    }
}

impl<C> OriginDimensions for Record<C> {
    fn size(&self) -> Size {
        self.size
    }
}

impl<C: PixelColor> DrawTarget for Record<C> {
    type Color = Alpha<C>;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Alpha<C>>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(point, color) in pixels {
            assert!(self.bounding_box().contains(point), "{point:?} is outside");
            let place = point.y as usize * self.size.width as usize + point.x as usize;
            self.pixels[place] = (Some(color), self.pixels[place].1 + 1);
        }
        Ok(())
    }
}

fn points(size: Size) -> impl Iterator<Item = Point> {
    Rectangle::new(Point::zero(), size).points()
}
