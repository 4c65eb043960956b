//! Shapes of whole pixels, with soft borders: lines from centre to centre of two pixels, circles in squares of pixels.

use embedded_graphics::{
    draw_target::DrawTarget,
    geometry::{Point, Size},
    pixelcolor::PixelColor,
    primitives::{self, Rectangle, StyledDrawable},
};

use super::draw;
use crate::{
    arc::Oval,
    blend::Alpha,
    edge::LIMIT,
    num::{SUBPIXELS, Subpixel, low_i32},
    outline::{Outline, Pen},
    raster::{bresenham::Line, ellipse::Ellipse, rounded_rectangle::RoundedRectangle},
    space::{Point2, Rect},
    style::AntialiasedStyle,
};

/// The middle of a pixel; far ones are moved nearer.
fn center(Point { x, y }: Point) -> Point2 {
    let half = SUBPIXELS / 2;
    let [x, y] = [x, y].map(|v| v.saturating_mul(SUBPIXELS).saturating_add(half));
    Point2::from_sixteenths(x, y).clamped(LIMIT)
}

/// Points that are joined by straight lines: those of embedded-graphics' shapes, as an outline.
struct Joined<I>(I, bool);

impl<I: Iterator<Item = Point2> + Clone> Outline for Joined<I> {
    fn trace<P: Pen>(&self, pen: &mut P) {
        let mut points = self.0.clone();
        let Some(first) = points.next() else { return };
        pen.move_to(first);
        points.for_each(|point| pen.line_to(point));
        if self.1 {
            pen.close();
        }
    }
}

/// The two ends of a line of pixels, as far as they can be computed with.
fn ends(line: &Line) -> [Point2; 2] {
    [shortened(line.start, line.end), shortened(line.end, line.start)]
}

/// The centre of `near`, or, if that is too far away, a point between it and `far` that is not.
fn shortened(near: Point, far: Point) -> Point2 {
    let [from, to] = [near, far].map(|Point { x, y }| [x, y].map(|v| i64::from(v) * 16 + 8));
    let reach = i64::from(LIMIT) - 1;
    let excess = from.map(|v| (v.abs() - reach).max(0));
    let axis = usize::from(excess[1] > excess[0]);
    let length = (to[axis] - from[axis]).abs();
    if excess[axis] == 0 || length < excess[axis] {
        return center(near);
    }
    let at = |axis: usize, part: i64| {
        let way = i128::from(to[axis] - from[axis]) * i128::from(part);
        let moved = way.checked_div(length.into()).and_then(|moved| i64::try_from(moved).ok());
        low_i32((from[axis] + moved.unwrap_or(0)).clamp(-reach, reach))
    };
    Point2::from_sixteenths(at(0, excess[axis]), at(1, excess[axis]))
}

/// The oval in a rectangle of pixels, smaller by so many sixteenths of a pixel all around.
pub(super) fn oval(top_left: Point, Size { width, height }: Size, inset: i32) -> Option<Oval> {
    let radius = |length: u32| (i64::from(length) * i64::from(SUBPIXELS) / 2).checked_sub(inset.into());
    let middle = |from: i32, length: u32| {
        let twice = 2 * i64::from(from) + i64::from(length);
        i32::try_from(twice * i64::from(SUBPIXELS) / 2).ok()
    };
    let center = Point2::from_sixteenths(middle(top_left.x, width)?, middle(top_left.y, height)?);
    let radii = [i32::try_from(radius(width)?).ok()?, i32::try_from(radius(height)?).ok()?];
    Oval::new(center, radii.map(Subpixel::from_bits)).ok()
}

/// A rectangle of pixels with round corners, smaller by so many sixteenths of a pixel all around.
pub(super) fn rectangle(area: Rectangle, radii: [u32; 4], inset: i32) -> Option<RoundedRectangle> {
    let Rect { left, top, right, bottom } = area.into();
    let at = |x: i32, y: i32, inset: i32| {
        let [x, y] = [x, y].map(|v| v.saturating_mul(SUBPIXELS).saturating_add(inset));
        Point2::from_sixteenths(x, y)
    };
    let corners = [at(left, top, inset), at(right, bottom, -inset)];
    let is_empty = corners[0].x > corners[1].x || corners[0].y > corners[1].y;
    let radius = |pixels: u32| {
        let sixteenths = i64::from(pixels) * i64::from(SUBPIXELS) - i64::from(inset);
        Subpixel::from_bits(low_i32(sixteenths.clamp(0, i64::from(LIMIT))))
    };
    let rectangle = RoundedRectangle::new(corners, Subpixel::ZERO).ok()?;
    (!is_empty).then(|| rectangle.with_radii(radii.map(radius)))
}

/// Draws shapes with the expressions for the inside and for the middle of the border.
macro_rules! antialiased {
    ($($shape:ty, |$this:ident, $inset:ident| $inside:expr, $border:expr;)+) => { $(
        impl<C: PixelColor> StyledDrawable<AntialiasedStyle<C>> for $shape {
            type Color = Alpha<C>;
            type Output = ();

            /// By area averaging, with four to seven kB of the stack. Shapes that reach 4,194,304 pixels from the origin are
            /// not drawn.
            fn draw_styled<D: DrawTarget<Color = Alpha<C>>>(
                &self,
                style: &AntialiasedStyle<C>,
                target: &mut D,
            ) -> Result<(), D::Error> {
                let ($this, $inset) = (self, style.inset());
                let _ = $inset;
                draw($inside, $border, style, target)
            }
        }
    )+ };
}

/// No inside.
const NONE: Option<Oval> = None;

antialiased!(
    Line, |this, inset| NONE, Some(Joined(ends(this).into_iter(), false));
    Ellipse, |this, inset| oval(this.top_left, this.size, 0), oval(this.top_left, this.size, inset);
    primitives::Line, |this, inset| NONE, Some(Joined(ends(&Line::new(this.start, this.end)).into_iter(), false));
    primitives::Ellipse, |this, inset| oval(this.top_left, this.size, 0), oval(this.top_left, this.size, inset);
    primitives::Triangle, |this, inset| Some(Joined(this.vertices.into_iter().map(center), true)),
        Some(Joined(this.vertices.into_iter().map(center), true));
    primitives::Polyline<'_>, |this, inset| NONE, Some(Joined(vertices(this), false));
    primitives::RoundedRectangle, |this, inset| rectangle(this.rectangle, radii(this), 0),
        rectangle(this.rectangle, radii(this), inset);
);

/// The centres of a polyline's pixels.
fn vertices<'p>(polyline: &primitives::Polyline<'p>) -> impl Iterator<Item = Point2> + Clone + use<'p> {
    let by = polyline.translate;
    polyline
        .vertices
        .iter()
        .map(move |point| center(Point::new(point.x.saturating_add(by.x), point.y.saturating_add(by.y))))
}

/// Circular corners; of elliptical ones the smaller radius.
fn radii(shape: &primitives::RoundedRectangle) -> [u32; 4] {
    let corners = shape.corners;
    [corners.top_left, corners.top_right, corners.bottom_right, corners.bottom_left]
        .map(|Size { width, height }| width.min(height))
}
