//! A pixel at a time: between layouts that have nothing in common.

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::Point,
    image::GetPixel,
    pixelcolor::BinaryColor,
    primitives::{PointsIter, Rectangle},
};

use super::{
    op::{Coded, RasterOp},
    packing::Packing,
    part::Part,
};
use crate::{
    display::{
        frame::{Frame, Spacing},
        layout::Layout,
    },
    num::index,
    space::Rect,
};

/// Draws a clipped area of a part.
pub(super) fn blit<C, M, T>(target: &mut T, part: &Part<C, M>, (area, at): (Rect, Point), op: RasterOp)
where
    C: Coded,
    M: Layout<C>,
    T: DrawTarget<Color = C> + GetPixel<Color = C>,
{
    let memory = part.source().memory;
    let spacing = Spacing { before: 0, stride: memory.stride };
    let Ok(source) = Frame::<C, M, _>::with_spacing(memory.bytes, part.size(), spacing) else { return };
    for (from, to) in places(part, area, at) {
        if let (Some(old), Some(new)) = (target.pixel(to), source.pixel(from)) {
            put(target, to, C::from_number(op.apply(old.number(), new.number())));
        }
    }
}

/// Paints a clipped area of a shape.
pub(super) fn paint<C, M, T>(target: &mut T, shape: &Part<BinaryColor, M>, (area, at): (Rect, Point), color: C)
where
    M: Packing,
    T: DrawTarget<Color = C>,
    C: Coded,
{
    for (from, to) in places(shape, area, at) {
        if M::FACTS.is_on(shape.source().memory, index(from.x), index(from.y)) {
            put(target, to, color);
        }
    }
}

/// The pixels that are not masked, in the picture and on the target.
fn places<C, M: Packing>(part: &Part<C, M>, area: Rect, at: Point) -> impl Iterator<Item = (Point, Point)> {
    let (area, mask) = (Rectangle::from(area), part.source().mask);
    let is_shown = move |from: &Point| mask.is_none_or(|mask| M::FACTS.is_on(mask, index(from.x), index(from.y)));
    area.points().filter(is_shown).map(move |from| (from, from - area.top_left + at))
}

fn put<T: DrawTarget>(target: &mut T, at: Point, color: T::Color) {
    // In memory nothing goes wrong.
    drop(target.draw_iter([Pixel(at, color)]));
}
