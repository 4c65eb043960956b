//! What [`Circle`](crate::Circle) and [`Ellipse`](crate::Ellipse) have in common: where the borders of a stroke
//! are, where the pixels go to, and what embedded-graphics wants of a primitive.
//!
//! ```text
//!   stroke of 3   Inside      Center      Outside
//!   border        │###        #│##     ###│
//! ```

use core::ops::Range;

use embedded_graphics::{
    draw_target::DrawTarget,
    geometry::{Point, Size},
    primitives::{Rectangle, StrokeAlignment},
};

use crate::{
    num::{Subpixel, bits},
    raster::conic::Blocks,
    space::Rect,
    span::Sink,
};

/// The sides of the outer and the inner border of a stroke, as embedded-graphics puts it about a shape: an odd
/// width about a border has the greater half inside.
pub(crate) const fn borders(size: Size, width: u32, alignment: StrokeAlignment) -> [Size; 2] {
    let (outside, inside) = match alignment {
        StrokeAlignment::Inside => (0, width),
        StrokeAlignment::Center => (width / 2, width - width / 2),
        StrokeAlignment::Outside => (width, 0),
    };
    let outer = Size::new_equal(outside.saturating_mul(2));
    [size.saturating_add(outer), size.saturating_sub(Size::new_equal(inside.saturating_mul(2)))]
}

/// A width in sixteenths to the nearest whole pixel, and no less than one; `None` for no stroke at all.
pub(crate) const fn whole_pixels(width: Subpixel) -> Option<u32> {
    let sixteenths = width.to_bits();
    if sixteenths <= 0 {
        return None;
    }
    let pixels = (bits(sixteenths) + 8) >> 4;
    Some(if pixels == 0 { 1 } else { pixels })
}

/// As spans, row by row.
pub(crate) struct Spans<'s, S>(pub(crate) &'s mut S);

impl<S: Sink> Blocks for Spans<'_, S> {
    const IN_ORDER: bool = true;
    type Error = S::Error;

    fn bounds(&self) -> Rect {
        self.0.bounds()
    }

    #[inline]
    fn block(&mut self, rows: Range<i32>, columns: [Range<i32>; 2]) -> Result<(), S::Error> {
        for row in rows {
            for columns in columns.iter().filter(|columns| !columns.is_empty()) {
                self.0.span(row, columns.clone(), ())?;
            }
        }
        Ok(())
    }
}

/// As rectangles of one colour, so that there are fewer of them.
pub(crate) struct Rectangles<'d, D: DrawTarget> {
    pub(crate) display: &'d mut D,
    pub(crate) color: D::Color,
}

impl<D: DrawTarget> Blocks for Rectangles<'_, D> {
    const IN_ORDER: bool = false;
    type Error = D::Error;

    fn bounds(&self) -> Rect {
        self.display.bounding_box().into()
    }

    #[inline]
    fn block(&mut self, rows: Range<i32>, columns: [Range<i32>; 2]) -> Result<(), D::Error> {
        for columns in columns {
            if !columns.is_empty() {
                let size = Size::new(columns.start.abs_diff(columns.end), rows.start.abs_diff(rows.end));
                let block = Rectangle::new(Point::new(columns.start, rows.start), size);
                self.display.fill_solid(&block, self.color)?;
            }
        }
        Ok(())
    }
}

/// Makes a shape of whole pixels what embedded-graphics calls a primitive.
macro_rules! primitive {
    ($shape:ident) => {
        impl Primitive for $shape {}

        impl Dimensions for $shape {
            fn bounding_box(&self) -> Rectangle {
                Rectangle::new(self.top_left, self.size())
            }
        }

        impl Transform for $shape {
            /// The same shape elsewhere. Positions saturate.
            fn translate(&self, by: Point) -> Self {
                let Point { x, y } = self.top_left;
                Self { top_left: Point::new(x.saturating_add(by.x), y.saturating_add(by.y)), ..*self }
            }

            fn translate_mut(&mut self, by: Point) -> &mut Self {
                *self = self.translate(by);
                self
            }
        }

        impl<C: PixelColor> StyledDimensions<FillStyle<C>> for $shape {
            fn styled_bounding_box(&self, _style: &FillStyle<C>) -> Rectangle {
                self.bounding_box()
            }
        }

        impl<C: PixelColor> StyledDrawable<FillStyle<C>> for $shape {
            type Color = C;
            type Output = ();

            fn draw_styled<D: DrawTarget<Color = C>>(
                &self,
                style: &FillStyle<C>,
                target: &mut D,
            ) -> Result<(), D::Error> {
                self.draw_filled(&mut Rectangles { display: target, color: style.color })
            }
        }

        impl<C: PixelColor> StyledDimensions<StrokeStyle<C>> for $shape {
            fn styled_bounding_box(&self, style: &StrokeStyle<C>) -> Rectangle {
                let width = whole_pixels(style.stroke.width).unwrap_or(0);
                let [outer, _] = borders(self.size(), width, StrokeAlignment::Center);
                Middle::of(self.top_left, self.size()).resized(outer).bounding_box()
            }
        }

        impl<C: PixelColor> StyledDrawable<StrokeStyle<C>> for $shape {
            type Color = C;
            type Output = ();

            /// The width of the stroke is rounded to whole pixels; positive widths draw at least one.
            fn draw_styled<D: DrawTarget<Color = C>>(
                &self,
                style: &StrokeStyle<C>,
                target: &mut D,
            ) -> Result<(), D::Error> {
                let Some(width) = whole_pixels(style.stroke.width) else { return Ok(()) };
                let middle = self.middle();
                if width == 1 && thin::is_possible(&middle, target) {
                    return self.draw_thin(&middle, (target, style.color));
                }
                let mut blocks = Rectangles { display: target, color: style.color };
                self.draw_stroked(width, StrokeAlignment::Center, &mut blocks)
            }
        }
    };
}

pub(crate) use primitive;
