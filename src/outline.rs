//! Outlines: shapes as contours of straight edges, drawn with a pen as often as one asks.
//!
//! ```text
//!  polygon ──┐                                          ┌──▶ edges ──▶ scanline fill
//!  path ─────┼──▶ move_to, line_to, line_to, close ─────┼──▶ a stroke: again an outline
//!  arc ──────┘                                          └──▶ your own pen
//! ```
//!
//! Nothing is stored: whoever needs the points again traces the outline again. So a curve costs no
//! memory, and a stroke of dashes of a path is three small machines, one inside the other.

use core::ops::Range;

use embedded_graphics::primitives::Rectangle;

use crate::{
    edge::{LIMIT, first_row},
    num::{SUBPIXELS, Subpixel},
    pieces::Curve,
    space::{Point2, Rect},
};

/// A shape whose boundary can be traced.
///
/// ```
/// use aquatint::{Outline, Pen, Point2};
///
/// /// A kite on its tip.
/// struct Kite(i32);
///
/// impl Outline for Kite {
///     fn trace<P: Pen>(&self, pen: &mut P) {
///         pen.move_to(Point2::corner(self.0, 0));
///         pen.line_to(Point2::corner(2 * self.0, self.0));
///         pen.line_to(Point2::corner(self.0, 3 * self.0));
///         pen.line_to(Point2::corner(0, self.0));
///         pen.close();
///     }
/// }
/// # assert_eq!(aquatint::pixel_bounds(&Kite(4)), aquatint::Rect::new(0, 0, 8, 12));
/// ```
pub trait Outline {
    /// Whether all of its contours wind the same way around, so that what overlaps is inside by the non-zero rule
    /// whichever contour it is looked at. Antialiasing gets by with less memory then. A stroke is such an outline.
    const WINDS_ONE_WAY: bool = false;

    /// Draws the contours, one after the other, the same ones each time.
    fn trace<P: Pen>(&self, pen: &mut P);

    /// Draws the same contours sixteen times as large, for antialiasing: the pen moves on 256ths of a pixel then.
    ///
    /// Without its own implementation an outline is traced as ever and enlarged. One with curves does better to cut
    /// them for that size: coverage shows a sixteenth of a pixel, which the 1-bit fills do not.
    ///
    /// The outlines of this crate do so where they are less than 262,144 pixels from the origin; their vertices are
    /// as near to the curve then as those of [`trace`](Self::trace), in 256ths instead of sixteenths. Farther out it
    /// is the same contour as ever, enlarged. Coordinates are less than 2³⁰ from zero; a pen clamps what others draw
    /// beyond.
    fn trace_fine<P: Pen>(&self, pen: &mut P) {
        trace_enlarged(self, pen);
    }
}

/// How many times as large [`Outline::trace_fine`] draws.
pub(crate) const FINE: i32 = 16;

/// Takes contours of straight edges, and of curves that stand for some.
pub trait Pen {
    /// Begins a contour. The one before stays open if it was not closed.
    fn move_to(&mut self, point: Point2);

    /// A straight edge to a point.
    fn line_to(&mut self, point: Point2);

    /// A curve from where the pen stands, in straight pieces. Without its own implementation a pen draws these edges.
    fn curve_to(&mut self, curve: &Curve) {
        curve.each(|vertex| self.line_to(vertex));
    }

    /// A straight edge back to where the contour began. Another contour follows, or nothing.
    fn close(&mut self);

    /// Which heights, in the unit of y, the pen wants to see at the moment: contours that lie wholly above or below may
    /// be left out. Without its own implementation a pen wants everything.
    fn heights(&self) -> Range<Subpixel> {
        Subpixel::MIN..Subpixel::MAX
    }
}

impl<O: Outline> Outline for &O {
    const WINDS_ONE_WAY: bool = O::WINDS_ONE_WAY;

    fn trace<P: Pen>(&self, pen: &mut P) {
        (**self).trace(pen);
    }

    fn trace_fine<P: Pen>(&self, pen: &mut P) {
        (**self).trace_fine(pen);
    }
}

/// [`Outline::trace_fine`] for outlines that know nothing of it.
pub(crate) fn trace_enlarged<O: Outline + ?Sized, P: Pen>(outline: &O, pen: &mut P) {
    outline.trace(&mut Enlarged { pen });
}

/// Traces a shape that was made sixteen times as large, or, where that did not fit, the shape itself, enlarged.
pub(crate) fn trace_large<O: Outline, P: Pen>(large: Option<O>, outline: &O, pen: &mut P) {
    match large {
        Some(large) => large.trace(pen),
        None => trace_enlarged(outline, pen),
    }
}

/// The pen of [`trace_enlarged`].
struct Enlarged<'p, P> {
    pen: &'p mut P,
}

impl<P: Pen> Pen for Enlarged<'_, P> {
    #[inline]
    fn move_to(&mut self, point: Point2) {
        self.pen.move_to(enlarged(point));
    }

    #[inline]
    fn line_to(&mut self, point: Point2) {
        self.pen.line_to(enlarged(point));
    }

    #[inline]
    fn close(&mut self) {
        self.pen.close();
    }
}

/// The point for [`Outline::trace_fine`], of the nearest one that can be drawn.
#[inline]
pub(crate) fn enlarged(point: Point2) -> Point2 {
    let Point2 { x, y } = in_range(point);
    Point2::from_sixteenths(x.to_bits() * FINE, y.to_bits() * FINE)
}

/// The point sixteen times as far out, if curves can be computed there.
pub(crate) fn fine(point: Point2) -> Option<Point2> {
    point.within(LIMIT / FINE.cast_unsigned()).then(|| enlarged(point))
}

/// Whether all points of an outline, as [`trace_fine`](Outline::trace_fine) will draw them, are less than
/// [`LIMIT`] from zero even when they are moved by `reach` sixteenths. One coarse trace.
pub(crate) fn is_fine_within<O: Outline>(outline: &O, reach: u32) -> bool {
    Extent::of(outline).is_fine_within(reach)
}

/// How far, in sixteenths, a fine point may be from the coarse contour: hardly 1, but 18 where curves are cut too coarsely.
pub(crate) const FINE_ERROR: u32 = 18;

/// An edge that owns the centre of a row: where it begins and ends, from above, and which way it winds.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Directed {
    pub(crate) upper: Point2,
    pub(crate) lower: Point2,
    /// +1 where the contour runs downwards, −1 upwards.
    pub(crate) winding: i32,
}

impl Directed {
    /// The edge of a contour from a point to another.
    #[inline]
    pub(crate) fn between(from: Point2, to: Point2) -> Self {
        let (upper, lower, winding) = if from.y <= to.y { (from, to, 1) } else { (to, from, -1) };
        Self { upper, lower, winding }
    }

    /// The first row that the edge owns.
    #[inline]
    pub(crate) const fn first_row(&self) -> i32 {
        first_row(self.upper.y.to_bits())
    }

    /// The first row behind.
    #[inline]
    pub(crate) const fn end_row(&self) -> i32 {
        first_row(self.lower.y.to_bits())
    }
}

/// Gives every edge that owns a row, of contours that are closed where they were left open.
#[inline]
pub(crate) fn each_edge<O: Outline>(outline: &O, mut take: impl FnMut(Directed)) {
    let take = |edge: Directed| {
        if edge.first_row() < edge.end_row() {
            take(edge);
        }
    };
    let mut edges = Edges { take, first: Point2::default(), last: Point2::default() };
    outline.trace(&mut edges);
    edges.close();
}

/// The pen of [`each_edge`].
struct Edges<F> {
    take: F,
    first: Point2,
    last: Point2,
}

impl<F: FnMut(Directed)> Pen for Edges<F> {
    #[inline]
    fn move_to(&mut self, point: Point2) {
        self.close();
        self.first = point.nearest_within(LIMIT);
        self.last = self.first;
    }

    #[inline]
    fn line_to(&mut self, point: Point2) {
        let to = point.nearest_within(LIMIT);
        (self.take)(Directed::between(self.last, to));
        self.last = to;
    }

    #[inline]
    fn close(&mut self) {
        if self.first != self.last {
            self.line_to(self.first);
        }
    }
}

/// The nearest point whose edges can be walked exactly: an outline may be anybody's.
#[inline]
pub(crate) fn in_range(point: Point2) -> Point2 {
    point.nearest_within(LIMIT)
}

/// The smallest rectangle of pixels that holds all points of an outline; empty for an empty outline.
#[must_use]
pub fn pixel_bounds<O: Outline>(outline: &O) -> Rect {
    Extent::of(outline).pixels_within(0)
}

/// The pixels whose centres are no farther out than the outermost points.
pub(crate) fn center_bounds<O: Outline>(outline: &O) -> Rect {
    let Some((least, most)) = Extent::of(outline).0 else { return Rect::default() };
    // Centres on the left and top are inside, on the right and bottom outside: columns as rows.
    let [left, top, right, bottom] =
        [least.x, least.y, most.x, most.y].map(|v| first_row(v.to_bits().min(i32::MAX - SUBPIXELS)));
    Rect::new(left, top, right, bottom)
}

/// [`pixel_bounds`] as embedded-graphics wants it.
pub(crate) fn bounding_box<O: Outline>(outline: &O) -> Rectangle {
    pixel_bounds(outline).into()
}

/// The pen that keeps the least and the greatest coordinates seen.
pub(crate) struct Extent(pub(crate) Option<(Point2, Point2)>);

impl Extent {
    /// That of an outline.
    pub(crate) fn of<O: Outline>(outline: &O) -> Self {
        let mut extent = Self(None);
        outline.trace(&mut extent);
        extent
    }

    /// Whether it is that of [`is_fine_within`].
    pub(crate) fn is_fine_within(&self, reach: u32) -> bool {
        let limit = (LIMIT / FINE.cast_unsigned()).saturating_sub(reach).saturating_sub(32);
        self.0.is_none_or(|(least, most)| least.within(limit) && most.within(limit))
    }

    /// The smallest rectangle of pixels that holds all that is `reach` sixteenths from it.
    pub(crate) fn pixels_within(&self, reach: u32) -> Rect {
        let (Some((least, most)), reach) = (self.0, reach.cast_signed()) else { return Rect::default() };
        let [left, top] = [least.x, least.y].map(|v| v.to_bits().saturating_sub(reach) >> Subpixel::FRAC_NBITS);
        let [right, bottom] =
            [most.x, most.y].map(|v| v.to_bits().saturating_add(reach).saturating_add(15) >> Subpixel::FRAC_NBITS);
        Rect::new(left, top, right, bottom)
    }
}

impl Pen for Extent {
    fn move_to(&mut self, point: Point2) {
        let (least, most) = self.0.unwrap_or((point, point));
        self.0 = Some((
            Point2::new(least.x.min(point.x), least.y.min(point.y)),
            Point2::new(most.x.max(point.x), most.y.max(point.y)),
        ));
    }

    fn line_to(&mut self, point: Point2) {
        self.move_to(point);
    }

    fn close(&mut self) {}
}
