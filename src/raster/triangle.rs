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
//!
//! Triangles of some pixels, as meshes have them, are not worth the divisions of a walk: there each pixel of the
//! bounding box is tested against the three *edge functions*, whose signs tell on which side of an edge it lies
//! (J. Pineda, "A parallel algorithm for polygon rasterization", SIGGRAPH 1988). Both ways give the same pixels.

use core::ops::Range;

use super::edge_pair::EdgePair;
use crate::{
    edge::reached_by,
    error::OutOfRange,
    slopes::Slopes,
    space::{Point2, Rect},
    span::Sink,
    vary::{LIMIT, Ramp, Vertex},
};

/// A triangle whose corners carry `N` attributes; `N` may be 0.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Triangle<const N: usize> {
    corners: [Vertex<N>; 3],
}

impl<const N: usize> Triangle<N> {
    /// A triangle, its corners in any order. One without area holds no pixel.
    ///
    /// # Errors
    /// [`OutOfRange`] when a corner is 65,536 pixels or more from the origin.
    pub fn new(corners: [Vertex<N>; 3]) -> Result<Self, OutOfRange> {
        if corners.iter().all(|corner| corner.position.within(LIMIT)) { Ok(Self { corners }) } else { Err(OutOfRange) }
    }

    /// Emits the spans inside the bounds of `sink`, with the attributes along them.
    ///
    /// Three edge set-ups (two divisions each, none for a triangle of some pixels); attributes cost their gradients
    /// only when there is a span at all, which for small triangles there often is not. No memory.
    ///
    /// # Errors
    /// What the sink says.
    pub fn spans<S: Sink<Ramp<N>>>(&self, sink: &mut S) -> Result<(), S::Error> {
        let mut plane = None;
        let bounds = sink.bounds();
        shape(&self.corners.map(|corner| corner.position), bounds, &mut |row, columns: Range<i32>| {
            let plane = plane.get_or_insert_with(|| {
                let slopes = Slopes::new(&self.corners.map(|corner| corner.position));
                slopes.plane(&self.corners.map(|corner| corner.attributes))
            });
            let ramp = plane.at(row, columns.start);
            sink.span(row, columns, ramp)
        })
    }
}

/// Emits the spans of a triangle inside the bounds of `sink`, without attributes.
///
/// # Errors
/// What the sink says.
#[inline]
pub(crate) fn spans<S: Sink>(corners: &[Point2; 3], sink: &mut S) -> Result<(), S::Error> {
    let bounds = sink.bounds();
    shape(corners, bounds, &mut |row, columns| sink.span(row, columns, ()))
}

/// Gives the spans of a triangle with corners nearer than [`LIMIT`].
#[inline]
fn shape<E>(
    corners: &[Point2; 3],
    bounds: Rect,
    take: &mut impl FnMut(i32, Range<i32>) -> Result<(), E>,
) -> Result<(), E> {
    let all = reached_by(corners);
    let area = all.intersection(bounds);
    if area.is_empty() {
        Ok(())
    } else if is_small(all) {
        tested(corners, area, take)
    } else {
        walked(corners, area, take)
    }
}

/// Pixels in a row or column of a box, and in the whole box, that are tested one by one.
pub(super) const LONGEST: u32 = 16;
const MOST_TESTS: u32 = 32;

/// Whether the pixels of a box are few enough.
#[inline]
pub(super) fn is_small(area: Rect) -> bool {
    let (width, height) = (area.width(), area.height());
    height <= LONGEST && width <= LONGEST && height * width <= MOST_TESTS
}

/// The edge function of a side, in square sixteenths: not negative on the inner side.
#[derive(Clone, Copy)]
struct Side {
    /// At a pixel's centre.
    value: i32,
    /// What is added a column to the right, and a row down.
    across: i32,
    down: i32,
}

impl Side {
    /// Of the side from one corner to the next, clockwise around the triangle, standing on a pixel.
    #[inline]
    fn new(from: Point2, to: Point2, (column, row): (i32, i32)) -> Self {
        let (dx, dy) = (to.x.to_bits() - from.x.to_bits(), to.y.to_bits() - from.y.to_bits());
        let (x, y) = (column * 16 + 8 - from.x.to_bits(), row * 16 + 8 - from.y.to_bits());
        // A centre on a side belongs to it if that is a left one, which runs up, or an upper one, which runs right.
        let owns = dy < 0 || (dy == 0 && dx > 0);
        Self { value: dx * y - dy * x - i32::from(!owns), across: -16 * dy, down: 16 * dx }
    }
}

/// Tests every pixel of a small box.
#[inline]
fn tested<E>(
    &[a, b, c]: &[Point2; 3],
    area: Rect,
    take: &mut impl FnMut(i32, Range<i32>) -> Result<(), E>,
) -> Result<(), E> {
    let (b, c) = if twice_area_of_small(a, b, c) < 0 { (c, b) } else { (b, c) };
    let mut sides = [(a, b), (b, c), (c, a)].map(|(from, to)| Side::new(from, to, (area.left, area.top)));
    for row in area.rows() {
        let [mut first, mut second, mut third] = sides.map(|side| side.value);
        let [first_step, second_step, third_step] = sides.map(|side| side.across);
        let (mut start, mut end) = (area.right, area.right);
        for column in area.columns() {
            // The sign of the union is negative if one of them is.
            if first | second | third >= 0 {
                start = start.min(column);
            } else if start < column {
                end = column;
                break;
            }
            (first, second, third) = (first + first_step, second + second_step, third + third_step);
        }
        if start < end {
            take(row, start..end)?;
        }
        for side in &mut sides {
            side.value += side.down;
        }
    }
    Ok(())
}

/// [`twice_area`] of corners less than 2¹⁵ sixteenths from each other.
#[inline]
fn twice_area_of_small(a: Point2, b: Point2, c: Point2) -> i32 {
    let to = |p: Point2| (p.x.to_bits() - a.x.to_bits(), p.y.to_bits() - a.y.to_bits());
    let ((bx, by), (cx, cy)) = (to(b), to(c));
    bx * cy - cx * by
}

/// Walks down the edges.
#[inline(never)]
fn walked<E>(
    corners: &[Point2; 3],
    area: Rect,
    take: &mut impl FnMut(i32, Range<i32>) -> Result<(), E>,
) -> Result<(), E> {
    let Some(mut edges) = EdgePair::new(corners, area.top) else { return Ok(()) };
    let mut row = area.top;
    loop {
        let Range { start, end } = edges.columns();
        let columns = start.max(area.left)..end.min(area.right);
        if !columns.is_empty() {
            take(row, columns)?;
        }
        row += 1;
        if row >= area.bottom {
            return Ok(());
        }
        edges.advance(row);
    }
}
