//! Turned and mirrored targets: for panels that are mounted another way round.
//!
//! Nothing is buffered: coordinates are mapped on their way. A run along a row becomes one along
//! a column when turned by a quarter, so it costs a filled rectangle one pixel wide.

use core::ops::Range;

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, OriginDimensions, Point, Size},
    image::GetPixel,
    primitives::Rectangle,
};

use crate::{
    num::size_i32,
    phase::{phase, repeated},
    space::Rect,
    target::Target,
};

/// How a picture lies on the panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Turn {
    /// By 90° clockwise: the picture's left border is the panel's upper one.
    Clockwise,
    /// Upside down.
    Half,
    /// By 90° counter-clockwise: the picture's left border is the panel's lower one.
    CounterClockwise,
    /// Left and right exchanged.
    MirroredLeftRight,
    /// Top and bottom exchanged.
    MirroredTopBottom,
}

/// A display that is drawn on turned or mirrored.
///
/// ```
/// use aquatint::{Frame, Pages, Turn, Turned};
/// use embedded_graphics::{pixelcolor::BinaryColor, prelude::*};
///
/// let mut frame = Frame::<BinaryColor, Pages, _>::with_array([0; 1024], 128, 64).unwrap();
/// let mut portrait = Turned::new(&mut frame, Turn::Clockwise);
/// assert_eq!(portrait.bounding_box().size, Size::new(64, 128));
/// Pixel(Point::new(0, 0), BinaryColor::On).draw(&mut portrait)?;
/// assert_eq!(frame.bytes()[127], 1); // the upper right corner of the panel
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug)]
pub struct Turned<'d, D> {
    display: &'d mut D,
    map: Map,
}

/// From the coordinates of the picture to those of the display.
#[derive(Clone, Copy, Debug)]
struct Map {
    turn: Turn,
    /// Last column and last row of the display.
    last: Point,
}

impl Map {
    /// Where a pixel of the picture is.
    fn place(self, Point { x, y }: Point) -> Point {
        let (from_right, from_bottom) =
            (|at: i32| self.last.x.wrapping_sub(at), |at: i32| self.last.y.wrapping_sub(at));
        match self.turn {
            Turn::Clockwise => Point::new(from_right(y), x),
            Turn::Half => Point::new(from_right(x), from_bottom(y)),
            Turn::CounterClockwise => Point::new(y, from_bottom(x)),
            Turn::MirroredLeftRight => Point::new(from_right(x), y),
            Turn::MirroredTopBottom => Point::new(x, from_bottom(y)),
        }
    }

    /// Where a rectangle of the picture is.
    fn area(self, area: Rect) -> Rectangle {
        let first = self.place(Point::new(area.left, area.top));
        let last = self.place(Point::new(area.right.wrapping_sub(1), area.bottom.wrapping_sub(1)));
        Rectangle::with_corners(first, last)
    }

    /// Whether what runs to the right in the picture runs to the left or upwards on the display.
    const fn is_backwards(self) -> bool {
        matches!(self.turn, Turn::Half | Turn::CounterClockwise | Turn::MirroredLeftRight)
    }
}

impl<'d, D: OriginDimensions> Turned<'d, D> {
    /// Draws on `display` turned.
    pub fn new(display: &'d mut D, turn: Turn) -> Self {
        let Size { width, height } = display.size();
        let last = Point::new(size_i32(width).wrapping_sub(1), size_i32(height).wrapping_sub(1));
        Self { display, map: Map { turn, last } }
    }
}

impl<D: OriginDimensions> OriginDimensions for Turned<'_, D> {
    fn size(&self) -> Size {
        let Size { width, height } = self.display.size();
        let is_quarter = matches!(self.map.turn, Turn::Clockwise | Turn::CounterClockwise);
        if is_quarter { Size::new(height, width) } else { Size::new(width, height) }
    }
}

impl<D: DrawTarget + OriginDimensions> DrawTarget for Turned<'_, D> {
    type Color = D::Color;
    type Error = D::Error;

    fn draw_iter<I: IntoIterator<Item = Pixel<D::Color>>>(&mut self, pixels: I) -> Result<(), D::Error> {
        let (map, bounds) = (self.map, Target::bounds(self));
        let seen = pixels.into_iter().filter(|Pixel(point, _)| bounds.contains(*point));
        self.display.draw_iter(seen.map(|Pixel(point, color)| Pixel(map.place(point), color)))
    }

    fn fill_solid(&mut self, area: &Rectangle, color: D::Color) -> Result<(), D::Error> {
        let seen = Rect::from(*area).intersection(self.bounding_box().into());
        if seen.is_empty() { Ok(()) } else { self.display.fill_solid(&self.map.area(seen), color) }
    }
}

impl<D: DrawTarget + OriginDimensions> Target for Turned<'_, D> {
    type Color = D::Color;
    type Error = D::Error;

    fn bounds(&self) -> Rect {
        self.bounding_box().into()
    }

    fn fill_run<const N: usize>(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: [D::Color; N],
    ) -> Result<(), D::Error> {
        let Some(columns) = self.bounds().clip_run(row, columns) else { return Ok(()) };
        let area = self.map.area(Rect::new(columns.start, row, columns.end, row.saturating_add(1)));
        if let [color] = *colors.as_slice() {
            self.display.fill_solid(&area, color)
        } else if self.map.is_backwards() {
            self.display.fill_contiguous(&area, columns.rev().filter_map(|column| phase(&colors, column)))
        } else {
            self.display.fill_contiguous(&area, repeated(&colors, columns.start))
        }
    }

    fn write_run(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: impl Iterator<Item = Option<D::Color>>,
    ) -> Result<(), D::Error> {
        let Some(visible) = self.bounds().clip_run(row, columns.clone()) else { return Ok(()) };
        let hidden = usize::try_from(visible.start.abs_diff(columns.start)).unwrap_or(usize::MAX);
        let pixels = visible.zip(colors.skip(hidden));
        self.draw_iter(pixels.filter_map(|(column, color)| Some(Pixel(Point::new(column, row), color?))))
    }
}

impl<D: GetPixel + OriginDimensions> GetPixel for Turned<'_, D> {
    type Color = D::Color;

    fn pixel(&self, point: Point) -> Option<D::Color> {
        let inside = Rect::of_size(self.size()).contains(point);
        if inside { self.display.pixel(self.map.place(point)) } else { None }
    }
}
