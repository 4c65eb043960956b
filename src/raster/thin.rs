//! The outline of a circle or an ellipse, one pixel wide and wholly on the display: by symmetry, four pixels at a
//! time.
//!
//! ```text
//!       ◤▔▔▔▔▔▔◥       for each pixel of a quarter, the
//!      ◤        ◥      one of each corner
//!      ◣        ◢
//!       ◣▁▁▁▁▁▁◢
//! ```
//!
//! Setting a pixel costs a quarter of filling a rectangle, and most runs of a thin outline are one or two pixels
//! long. It is the choice that [`Line`](crate::Line) makes for steep lines.
//!
//! **Memory** none. **Cost** two [boundaries](super::conic) for half of the rows, some additions a pixel.

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
};

use crate::{
    num::low_i32,
    raster::conic::{Boundary, Conic, Middle, Whole},
    space::Rect,
};

/// Whether an outline can be drawn so: all of it is on the display, and the pixel in the middle is no part of it.
pub(crate) fn is_possible<D: Dimensions>(middle: &Middle, display: &D) -> bool {
    let area = Rect::from(middle.bounding_box());
    area.width() > 2 && area.height() > 2 && area.intersection(display.bounding_box().into()) == area
}

/// Draws what is inside an ellipse that fills its box and not inside the second one.
pub(crate) fn draw<N: Whole, D: DrawTarget>(
    middle: &Middle,
    conics: [Conic<N>; 2],
    (display, color): (&mut D, D::Color),
) -> Result<(), D::Error> {
    let Rect { top, bottom, .. } = middle.bounding_box().into();
    let [mut outer, mut inner] = conics.map(|conic| Boundary::of_first_row(conic, middle));
    let (left, right) = middle.columns();
    let (mut upper, mut lower) = (top, bottom.wrapping_sub(1));
    while upper <= lower {
        let offset = inner.advance();
        let count = outer.advance() - offset;
        let (mut x, mut mirror) = (low_i32(left - offset), low_i32(right + offset));
        for _ in 0..count {
            // The first two differ where the row or the column lies in the middle.
            let corners = [(x, upper), (mirror, lower), (mirror, upper), (x, lower)];
            let distinct = if x == mirror || upper == lower { 2 } else { 4 };
            let pixels = corners.into_iter().take(distinct).map(|(x, y)| Pixel(Point::new(x, y), color));
            display.draw_iter(pixels)?;
            (x, mirror) = (x.wrapping_sub(1), mirror.wrapping_add(1));
        }
        (upper, lower) = (upper.wrapping_add(1), lower.wrapping_sub(1));
    }
    Ok(())
}
