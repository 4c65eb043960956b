//! Pictures onto frames: packed pixels copied, or combined with what is there, at any place.
//!
//! A [`Frame`] over bytes in flash or memory is a picture; [`Blit::blit`] draws it, or a
//! [part](Frame::part) of it, on another frame of the same colour. [`Blit::paint`] draws the shape of a
//! one-bit picture in one colour of any depth. What does not fit is clipped, and no byte that holds no
//! pixel is written.
//!
//! ```text
//!   source     ▒▒▒▒▒▒│▒▒▒▒▒▒▒▒│▒▒▒▒▒▒▒▒│      a word of the source falls on a word of the
//!               ╰──────── strip ───────╯       target and on the byte behind it:
//!   target   ▒▒▒▒▒▒▒▒│▒▒▒▒▒▒▒▒│▒▒▒▒▒▒▒▒│▒▒     rotate, mask, merge; the same in every line
//! ```
//!
//! - **Method** lines of one layout: the area is cut into strips of a machine word, and each
//!   strip is done from line to line with one rotation and one mask (the `BitBlt` of D. Ingalls,
//!   Xerox PARC 1975; operations by J. D. Foley et al., *Computer Graphics: Principles and Practice*,
//!   section 19.6). Pages: the same with words of eight rows, each joined from two. Rows onto pages:
//!   blocks of 8 × 8 pixels are [transposed](super::transpose). Any other two layouts: a pixel at a time.
//! - **Cost** about 15 instructions for each strip of a line, 40 for each word of a page and 60 for each
//!   block, on a desk; some 150 before that. A pixel at a time costs dozens each.
//! - **Memory** none.

mod lines;
mod op;
mod packing;
mod pages;
mod part;
mod pixels;
mod scroll;
mod stencil;
mod strip;
mod transposed;

use core::iter::once;

use embedded_graphics::{
    geometry::{Dimensions, OriginDimensions, Point},
    pixelcolor::BinaryColor,
};

use crate::{
    display::{frame::Frame, layout::Layout},
    space::Rect,
};

use op::Op;
pub use op::{Coded, RasterOp};
pub use packing::Packing;
use packing::Way;
pub use part::Part;
pub(in crate::display) use part::clip;
use part::{Job, Pixels, Source};

/// Takes pictures: a [`Frame`], or a [`Window`](crate::Window) on one.
///
/// ```
/// use aquatint::{
///     Frame, Pages, Rows,
///     display::blit::{Blit, RasterOp},
/// };
/// use embedded_graphics::{pixelcolor::BinaryColor, prelude::Point};
///
/// // A picture in flash.
/// static ARROW: Frame<BinaryColor, Rows, [u8; 2]> = match Frame::with_array([0b0100_0000, 0b1110_0000], 3, 2) {
///     Ok(arrow) => arrow,
///     Err(_) => panic!(),
/// };
///
/// let mut rows = Frame::<BinaryColor, Rows, _>::with_array([0b1000_0001; 3], 8, 3)?;
/// rows.blit(&ARROW, Point::new(3, 1), RasterOp::Or);
/// assert_eq!(rows.bytes(), [0b1000_0001, 0b1000_1001, 0b1001_1101]);
///
/// let mut pages = Frame::<BinaryColor, Pages, _>::with_array([0; 8], 8, 3)?;
/// pages.blit(&ARROW, Point::new(3, 1), RasterOp::Copy);
/// assert_eq!(pages.bytes(), [0, 0, 0, 0b100, 0b110, 0b100, 0, 0]);
/// # Ok::<(), aquatint::TooSmall>(())
/// ```
pub trait Blit: Dimensions + sealed::Sealed {
    /// Of the pixels that are drawn on.
    type Color: Coded;

    /// Draws a picture of the same colour with its top left corner at `at`.
    fn blit<'s, L>(&mut self, source: impl Into<Part<'s, Self::Color, L>>, at: Point, op: RasterOp)
    where
        L: Layout<Self::Color>;

    /// Draws a shape in one colour: the pixels that are `On` in a one-bit picture, whose top left
    /// corner is at `at`.
    ///
    /// ```
    /// use aquatint::{Frame, Rows, display::blit::Blit};
    /// use embedded_graphics::{pixelcolor::{BinaryColor, Gray4}, prelude::*};
    ///
    /// let shape = Frame::<BinaryColor, Rows, _>::with_array([0b1011_0000], 4, 1)?;
    /// let mut grey = Frame::<Gray4, Rows, _>::with_array([0x12, 0x34, 0x56], 6, 1)?;
    /// grey.paint(&shape, Point::new(1, 0), Gray4::new(0xA));
    /// assert_eq!(grey.bytes(), [0x1A, 0x3A, 0xA6]);
    /// # Ok::<(), aquatint::TooSmall>(())
    /// ```
    fn paint<'s, L>(&mut self, shape: impl Into<Part<'s, BinaryColor, L>>, at: Point, color: Self::Color)
    where
        L: Layout<BinaryColor>,
    {
        let shape = shape.into();
        self.paint_all(&shape, once((shape.area(), at)), color);
    }

    /// Paints areas that lie in a shape, each with its top left corner somewhere: glyphs of a sheet.
    #[doc(hidden)]
    fn paint_all<L>(
        &mut self,
        shape: &Part<BinaryColor, L>,
        places: impl Iterator<Item = (Rect, Point)>,
        color: Self::Color,
    ) where
        L: Layout<BinaryColor>;
}

mod sealed {
    pub trait Sealed {}
    impl<C, L, B> Sealed for crate::display::frame::Frame<C, L, B> {}
    impl<T> Sealed for crate::display::window::Window<'_, T> {}
}

impl<C, L, B> Blit for Frame<C, L, B>
where
    C: Coded,
    L: Layout<C>,
    B: AsRef<[u8]> + AsMut<[u8]>,
{
    type Color = C;

    fn blit<'s, M>(&mut self, source: impl Into<Part<'s, C, M>>, at: Point, op: RasterOp)
    where
        M: Layout<C>,
    {
        let part = source.into();
        let Some((area, at)) = clip(part.area(), at, Rect::of_size(self.size())) else { return };
        let (way, pixels) = const { (Way::new(L::FACTS, M::FACTS), Pixels::new::<C, C, M>()) };
        if way == Way::Pixels {
            return pixels::blit(self, &part, (area, at), op);
        }
        let op = Op::new(op, L::FACTS, M::FACTS);
        self.merge(way, (part.source(), pixels), once(Job::new(area, at)), op);
    }

    fn paint_all<M>(&mut self, shape: &Part<BinaryColor, M>, places: impl Iterator<Item = (Rect, Point)>, color: C)
    where
        M: Layout<BinaryColor>,
    {
        let bounds = Rect::of_size(self.size());
        let places = places.filter_map(|(area, at)| clip(area, at, bounds));
        let (way, pixels) = const { (Way::new(L::FACTS, M::FACTS), Pixels::new::<C, BinaryColor, M>()) };
        if way == Way::Pixels {
            return places.for_each(|place| pixels::paint(self, shape, place, color));
        }
        let jobs = places.map(|(area, at)| Job::new(area, at));
        self.merge(way, (shape.source(), pixels), jobs, Op::paint(color, L::FACTS, M::FACTS));
    }
}

impl<C, L, B> Frame<C, L, B>
where
    C: Coded,
    L: Layout<C>,
    B: AsRef<[u8]> + AsMut<[u8]>,
{
    /// Merges rectangles that are not empty and lie inside.
    #[inline]
    fn merge(&mut self, way: Way, source: (&Source, Pixels), jobs: impl Iterator<Item = Job>, op: Op<u8>) {
        let target = self.memory_mut();
        match way {
            Way::Rows { msb_first: true } => lines::merge::<true>(target, source, jobs, op),
            Way::Rows { msb_first: false } => lines::merge::<false>(target, source, jobs, op),
            Way::Columns { msb_first: true } => lines::merge::<true>(target, source, jobs.map(Job::turned), op),
            Way::Columns { msb_first: false } => lines::merge::<false>(target, source, jobs.map(Job::turned), op),
            Way::Pages { msb_first } => pages::merge(target, source, (jobs, msb_first), op),
            Way::Transposed { .. } => transposed::merge(target, source, (jobs, way), op),
            Way::Pixels => {}
        }
    }
}
