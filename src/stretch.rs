//! Outlines for antialiasing: contours on 256ths of a pixel, as stretches that only go down or only up.
//!
//! ```text
//!   trace_fine ──move_to, line_to, curve_to──▶ Directed   a straight edge
//!                                              Run        pieces of a curve, up to where it turns
//! ```
//!
//! A run is a curve with the numbers of two vertices, so that a list of edges holds it in one place.

use core::ops::Range;

use crate::{
    edge::LIMIT,
    num::Subpixel,
    outline::{Directed, FINE, Outline, Pen},
    pieces::Curve,
    space::Point2,
};

/// Points of [`Outline::trace_fine`] are nearer to zero than this.
const FINE_LIMIT: u32 = LIMIT * FINE.cast_unsigned();

/// Pieces of a curve from above to below, by the numbers of their first and their last vertex.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Run {
    pub(crate) curve: Curve,
    pub(crate) upper: u32,
    pub(crate) lower: u32,
    pub(crate) winding: i32,
}

impl Run {
    /// The pieces of a curve between two of its vertices, +1 where they go down, −1 up; none where they are level.
    fn between(curve: Curve, (from, to): (u32, u32), winding: i32) -> Option<Self> {
        let (upper, lower) = if winding > 0 { (from, to) } else { (to, from) };
        (winding != 0).then_some(Self { curve, upper, lower, winding })
    }

    /// How many pieces it has.
    pub(crate) const fn len(&self) -> u32 {
        self.upper.abs_diff(self.lower)
    }

    /// The vertices from above, counted from 0.
    pub(crate) fn vertex(&self, place: u32) -> Point2 {
        let place = place.min(self.len());
        let number =
            if self.upper < self.lower { self.upper.wrapping_add(place) } else { self.upper.wrapping_sub(place) };
        self.curve.vertex_at(number)
    }

    /// The pieces from above, counted from 0; behind the last one there is a level one.
    pub(crate) fn piece(&self, place: u32) -> Directed {
        let (upper, lower) = (self.vertex(place), self.vertex(place.saturating_add(1)));
        Directed { upper, lower, winding: self.winding }
    }

    /// The first piece that ends below a height and is not level; there is one.
    pub(crate) fn piece_below(&self, y: i32) -> u32 {
        // Not the height of the first vertex either.
        let y = self.vertex(0).y.to_bits().max(y);
        let (mut above, mut below) = (0, self.len());
        if self.vertex(1).y.to_bits() > y {
            return 0;
        }
        while below - above > 1 {
            let middle = u32::midpoint(above, below);
            if self.vertex(middle).y.to_bits() > y { below = middle } else { above = middle }
        }
        above
    }
}

/// Takes the stretches of an outline. Two functions, because outlines without curves need only one of them.
pub(crate) trait Taker {
    /// A straight edge, not horizontal.
    fn edge(&mut self, edge: Directed);

    /// Pieces of a curve, not all of them horizontal.
    fn run(&mut self, run: Run);

    /// The rows of which it wants the stretches at the moment.
    fn rows(&self) -> Range<i32>;
}

/// Gives all stretches of [`Outline::trace_fine`], of contours that are closed where they were left open. Closed ones that
/// do not reach the rows that are wanted may be left out.
#[inline]
pub(crate) fn each_stretch<O: Outline, T: Taker>(outline: &O, taker: &mut T) {
    let mut stretches = Stretches { taker, first: Point2::default(), last: Point2::default() };
    outline.trace_fine(&mut stretches);
    stretches.close();
}

/// The pen of [`each_stretch`].
struct Stretches<'t, T> {
    taker: &'t mut T,
    first: Point2,
    last: Point2,
}

impl<T: Taker> Pen for Stretches<'_, T> {
    #[inline]
    fn move_to(&mut self, point: Point2) {
        self.close();
        self.first = point.nearest_within(FINE_LIMIT);
        self.last = self.first;
    }

    #[inline]
    fn line_to(&mut self, point: Point2) {
        let to = point.nearest_within(FINE_LIMIT);
        let edge = Directed::between(self.last, to);
        self.last = to;
        if edge.upper.y < edge.lower.y {
            self.taker.edge(edge);
        }
    }

    /// In fewer pieces: they are at most 1.5 256ths of a pixel from the curve, and coverage is right to 2/256.
    fn curve_to(&mut self, curve: &Curve) {
        let curve = curve.coarser();
        let start = curve.vertex_at(0);
        self.line_to(start);
        let taker = &mut *self.taker;
        let mut end = |from: u32, to: u32, winding: i32| {
            if let Some(run) = Run::between(curve, (from, to), winding) {
                taker.run(run);
            }
        };
        if let Some(winding) = curve.slope() {
            end(0, curve.len(), winding);
            self.last = curve.vertex_at(curve.len());
            return;
        }
        // The vertex where the present stretch began, and +1 where it goes down, −1 up, 0 while it is level.
        let (mut from, mut number, mut winding, mut last) = (0, 0, 0, start);
        curve.each_numbered(|vertex| {
            let turn = i32::from(vertex.y > last.y) - i32::from(vertex.y < last.y);
            if turn != 0 && turn != winding {
                end(from, number, winding);
                (from, winding) = (number, turn);
            }
            (last, number) = (vertex, number + 1);
        });
        end(from, number, winding);
        self.last = last;
    }

    #[inline]
    fn close(&mut self) {
        if self.first != self.last {
            self.line_to(self.first);
        }
    }

    #[inline]
    fn heights(&self) -> Range<Subpixel> {
        let Range { start, end } = self.taker.rows();
        Subpixel::from_bits(start.saturating_mul(256))..Subpixel::from_bits(end.saturating_mul(256))
    }
}

/// The columns that stretches are in.
pub(crate) struct Columns {
    least: i32,
    most: i32,
}

impl Columns {
    /// Those of nothing.
    pub(crate) const NONE: Self = Self { least: i32::MAX, most: i32::MIN };

    /// Reaches over more points.
    pub(crate) fn hold<const N: usize>(&mut self, points: [Point2; N]) {
        for point in points {
            let x = point.nearest_within(FINE_LIMIT).x.to_bits();
            (self.least, self.most) = (self.least.min(x), self.most.max(x));
        }
    }

    /// What they are.
    pub(crate) const fn range(&self) -> Range<i32> {
        // In 256ths of a pixel; a sixteenth more, because curves are rounded.
        let end = (self.most.saturating_add(FINE) >> 8).saturating_add(1);
        self.least.saturating_sub(FINE) >> 8..end
    }
}
