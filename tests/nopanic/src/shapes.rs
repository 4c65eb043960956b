//! Styles, frames and paths for the programs that draw shapes.

use core::{convert::Infallible, ops::Range};

use aquatint::{
    Affine, Alpha, AntialiasedStyle, Blended, Cap, Covered, FillStyle, Frame, Join, Outline, Oval, Pen, Point2, Rows,
    Rule, Segment, Sink, SpanFn, Stroke, StrokeStyle,
};
use embedded_graphics::{
    pixelcolor::{BinaryColor, Gray4},
    primitives::{StyledDimensions, StyledDrawable},
};

use crate::{Any, any, keep, lent, one_of, side, window};

pub fn sink() -> impl Sink<Error = Infallible> {
    SpanFn::new(window(), |row: i32, columns: Range<i32>, ()| keep((row, columns)))
}

pub fn soft_sink() -> impl for<'c> Sink<Covered<'c>, Error = Infallible> {
    SpanFn::new(window(), |row: i32, columns: Range<i32>, covered: Covered<'_>| keep((row, columns, covered.at(any()))))
}

/// Draws with any style on a frame.
pub fn styled<S, D>(shape: &D, style: &S, bytes: &mut [u8])
where
    D: StyledDrawable<S, Color = BinaryColor> + StyledDimensions<S>,
{
    let Ok(mut frame) = Frame::<BinaryColor, Rows, _>::new(lent(bytes), side(), side()) else { return };
    keep(shape.draw_styled(style, &mut frame).is_ok());
    keep(shape.styled_bounding_box(style));
}

/// Draws antialiased on a frame.
pub fn soft<D>(shape: &D, bytes: &mut [u8])
where
    D: StyledDrawable<AntialiasedStyle<Gray4>, Color = Alpha<Gray4>>,
{
    let Ok(mut frame) = Frame::<Gray4, Rows, _>::new(lent(bytes), side(), side()) else { return };
    let style = AntialiasedStyle::fill(Gray4::new(any())).with_stroke(Gray4::new(any()), any()).with_shape(stroke());
    let style = style.with_rule(rule());
    keep(shape.draw_styled(&style, &mut Blended::new(&mut frame)).is_ok());
}

pub fn rule() -> Rule {
    one_of(&[Rule::NonZero, Rule::EvenOdd])
}

pub fn stroke() -> Stroke {
    let stroke = if any() { Stroke::new(any()) } else { Stroke::of_width(any()) };
    let join = one_of(&[Join::Miter { limit: 4 }, Join::Round, Join::Bevel]);
    stroke.with_join(join).with_cap(one_of(&[Cap::Butt, Cap::Round, Cap::Square]))
}

pub fn stroke_style() -> StrokeStyle<BinaryColor> {
    StrokeStyle::new(one_of(&[BinaryColor::On, BinaryColor::Off])).with_width(any()).with_stroke(stroke())
}

pub fn fill_style() -> FillStyle<BinaryColor> {
    FillStyle::new(one_of(&[BinaryColor::On, BinaryColor::Off])).with_rule(rule())
}

impl Any for Segment {
    fn any() -> Self {
        match any::<u16>() {
            0 => Self::MoveTo(any()),
            1 | 2 => Self::LineTo(any()),
            3 => Self::QuadTo(any(), any()),
            4 | 5 => Self::CubicTo(any(), any(), any()),
            6 => Oval::circle(any(), any()).map_or(Self::Close, |oval| Self::Arc(oval.arc(any(), any()))),
            _ => Self::Close,
        }
    }
}

/// Some segments; the first goes to a point, as it must.
pub fn segments(memory: &mut [Segment; 8]) -> &[Segment] {
    crate::some(memory);
    memory[0] = Segment::MoveTo(any());
    crate::part(memory)
}

/// A map that leaves most shapes where they can be seen.
pub fn map() -> Affine {
    if any() { any() } else { Affine::translation(any()) }
}

/// Takes what is traced.
pub struct Kept;

impl Pen for Kept {
    fn move_to(&mut self, point: Point2) {
        keep(point);
    }

    fn line_to(&mut self, point: Point2) {
        keep(point);
    }

    fn close(&mut self) {
        keep(());
    }
}

/// What differs from outline to outline: how it is traced.
pub fn traced<O: Outline>(shape: &O) {
    shape.trace(&mut Kept);
    shape.trace_fine(&mut Kept);
}
