//! Triangles: two edges walked down, spans between them, attributes along. Lecture 4.2 and 2.4.2.
//!
//! ```text
//!          ● top
//!         ╱  ╲ short edge
//!   long ╱     ● middle
//!  edge ╱   ╱  second short edge
//!      ● bottom
//! ```
//!
//! Which pixels: the rule of [`raster`](super). Triangles that share an edge share no pixel and
//! leave none, whatever the order of their corners, because both walk that edge in the same direction.

use core::ops::Range;

use crate::{
    edge::{Edge, first_row},
    error::OutOfRange,
    space::{Rect, twice_area},
    span::Sink,
    vary::{LIMIT, Plane, Ramp, Vertex},
};

/// A triangle whose corners carry `N` attributes; `N` may be 0.
#[derive(Clone, Copy, Debug)]
pub struct Triangle<const N: usize> {
    /// From top to bottom.
    corners: [Vertex<N>; 3],
    middle_is_right: bool,
}

impl<const N: usize> Triangle<N> {
    /// A triangle, its corners in any order. One without area holds no pixel.
    ///
    /// # Errors
    /// [`OutOfRange`] when a corner is 65,536 pixels or more from the origin.
    pub fn new(corners: [Vertex<N>; 3]) -> Result<Self, OutOfRange> {
        if !corners.iter().all(|corner| corner.position.within(LIMIT)) {
            return Err(OutOfRange);
        }
        let [mut a, mut b, mut c] = corners;
        let order = |upper: &mut Vertex<N>, lower: &mut Vertex<N>| {
            if lower.position.y < upper.position.y {
                core::mem::swap(upper, lower);
            }
        };
        order(&mut a, &mut b);
        order(&mut b, &mut c);
        order(&mut a, &mut b);
        let middle_is_right = twice_area(a.position, b.position, c.position) > 0;
        Ok(Self { corners: [a, b, c], middle_is_right })
    }

    /// Emits the spans inside the bounds of `sink`.
    ///
    /// Three edge set-ups (two divisions each); attributes cost their gradients only when there is
    /// a span at all, which for small triangles there often is not. No memory.
    ///
    /// # Errors
    /// What the sink says.
    pub fn spans<S: Sink<Ramp<N>>>(&self, sink: &mut S) -> Result<(), S::Error> {
        let bounds = sink.bounds();
        let [top, middle, bottom] = self.corners.map(|corner| corner.position);
        let rows = visible_rows(first_row(top.y.to_bits())..first_row(bottom.y.to_bits()), bounds);
        if rows.is_empty() {
            return Ok(());
        }
        let turn = first_row(middle.y.to_bits()).max(rows.start).min(rows.end);
        let mut walk = Spans { long: Edge::new(top, bottom, rows.start), plane: None, triangle: self, bounds };
        if rows.start < turn {
            walk.rows(rows.start..turn, Edge::new(top, middle, rows.start), sink)?;
        }
        if turn < rows.end {
            walk.rows(turn..rows.end, Edge::new(middle, bottom, turn), sink)?;
        }
        Ok(())
    }
}

fn visible_rows(rows: Range<i32>, bounds: Rect) -> Range<i32> {
    rows.start.max(bounds.top)..rows.end.min(bounds.bottom)
}

/// The walk down the long edge.
struct Spans<'t, const N: usize> {
    long: Edge,
    /// Made at the first span.
    plane: Option<Plane<N>>,
    triangle: &'t Triangle<N>,
    bounds: Rect,
}

impl<const N: usize> Spans<'_, N> {
    /// The rows beside one of the short edges.
    fn rows<S: Sink<Ramp<N>>>(&mut self, rows: Range<i32>, mut short: Edge, sink: &mut S) -> Result<(), S::Error> {
        for row in rows {
            let (long, other) = (self.long.column(), short.column());
            let (left, right) = if self.triangle.middle_is_right { (long, other) } else { (other, long) };
            let columns = left.max(self.bounds.left)..right.min(self.bounds.right);
            if !columns.is_empty() {
                let plane = self.plane.get_or_insert_with(|| Plane::through(&self.triangle.corners));
                let ramp = plane.at(row, columns.start);
                sink.span(row, columns, ramp)?;
            }
            self.long.advance();
            short.advance();
        }
        Ok(())
    }
}
