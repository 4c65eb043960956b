//! Sutherland-Hodgman polygon clipping: one boundary at a time, each feeding the next.
//! Lecture 3.3.3.
//!
//! ```text
//!   vertices ──▶ left ──▶ top ──▶ right ──▶ bottom ──▶ what is visible
//! ```
//!
//! A boundary is a small machine, a [`Stage`]: it keeps the vertex before and the first one, and gives none,
//! one or two vertices for each that it takes. A [`Pipeline`] joins any number of them, so that no polygon
//! is stored in between. [`clip`] is one boundary by itself, from one list into another.
//!
//! Works on any kind of vertex that can be cut ([`Cut`]), so that points with depth, light or
//! texture coordinates take one path. A concave polygon comes out as one polygon with edges that
//! run along the boundary and back; its winding is exact, so both fill rules stay right. Where these edges are
//! in the way, because the outline is wanted and not the area, there is [`separate`](super::separate).
//!
//! An intersection is the exact one, correctly rounded. It is the same number from both ends of an
//! edge, so two polygons that share an edge still share it when both have been cut: no crack. A boundary
//! rounds by half a unit at most, and what it has rounded the next one takes for exact: behind `k` boundaries an
//! edge is less than `k/2` units from its place along each axis. So pixels keep their winding unless their centre
//! is as near as that to an edge.
//!
//! **How many vertices.** Any line crosses what comes out of a boundary at most as often as what went in, and a
//! boundary adds half as many vertices as it has crossings. So `k` boundaries make at most `n + k·⌊n/2⌋`
//! vertices of `n`, and `n + k` of a convex polygon. Rounding has not been seen to break this; if it did, the
//! answer would be [`Full`].
//!
//! I. E. Sutherland and G. W. Hodgman, "Reentrant polygon clipping", Communications of the ACM 17(1), 1974.

use heapless::vec::VecView;

use crate::{error::describe, space::Point2};

use super::window::{ClipWindow, HalfPlane};
pub use super::{
    crossing::{Crossing, Cut},
    window::Boundary,
};

/// No room for more in the memory that was lent; the output is cut short.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Full;

describe! { Full, Self => "no room for more in the memory lent"; }

/// A vertex, and how far it lies inside of the boundary that looks at it.
type Placed<V> = (V, i64);

/// Where an edge crosses the boundary, if it does.
///
/// A vertex on the boundary is inside and no crossing: it would come twice.
#[inline]
fn crossing<V: Cut>((start, before): Placed<V>, (end, here): Placed<V>) -> Option<V> {
    if before > 0 && here < 0 {
        Some(V::cut(start, end, Crossing::new(before, here)))
    } else if before < 0 && here > 0 {
        Some(V::cut(end, start, Crossing::new(here, before)))
    } else {
        None
    }
}

/// Keeps the part of a polygon where `distance` is not negative.
///
/// The output is emptied first. A convex polygon gains at most one vertex; any polygon of `n` at
/// most `n / 2`.
///
/// # Errors
/// [`Full`] when the output has no room.
pub fn clip<V: Cut>(polygon: &[V], distance: impl Fn(&V) -> i64, output: &mut VecView<V>) -> Result<(), Full> {
    output.clear();
    let Some(&last) = polygon.last() else { return Ok(()) };
    let mut previous = (last, distance(&last));
    for &vertex in polygon {
        let here = (vertex, distance(&vertex));
        if let Some(cut) = crossing(previous, here) {
            output.push(cut).map_err(|_| Full)?;
        }
        if here.1 >= 0 {
            output.push(vertex).map_err(|_| Full)?;
        }
        previous = here;
    }
    Ok(())
}

/// Clips a polygon to a rectangle, in sixteenths of a pixel, with any border: the four stages in one call.
///
/// The output is emptied first; `n + 4·⌊n/2⌋` vertices are room enough for `n`, and `n + 4` if they are convex.
/// Any coordinates. 1.3 kB of stack for points, 400 bytes of it the stages.
///
/// ```
/// use aquatint::{Point2, Rect, clip::sutherland_hodgman::clip_to_rectangle};
/// use heapless::Vec;
///
/// let triangle = [(-4, 0), (4, 0), (4, 8)].map(|(x, y)| Point2::corner(x, y));
/// let mut visible = Vec::<Point2, 7>::new();
/// clip_to_rectangle(&triangle, Rect::new(0, 0, 16, 6), &mut visible)?;
/// assert_eq!(visible, [(0, 0), (4, 0), (4, 6), (2, 6), (0, 4)].map(|(x, y)| Point2::corner(x, y)));
/// # Ok::<(), aquatint::clip::sutherland_hodgman::Full>(())
/// ```
///
/// # Errors
/// [`Full`] when the output has no room.
pub fn clip_to_rectangle<V: Cut>(
    polygon: &[V],
    window: impl Into<ClipWindow<Point2>>,
    output: &mut VecView<V>,
) -> Result<(), Full>
where
    HalfPlane: Boundary<V>,
{
    output.clear();
    let mut stages = window.into().half_planes().map(Stage::new);
    Pipeline::new(&mut stages).clip(polygon, |vertex| output.push(vertex)).map_err(|_| Full)
}

/// One boundary of the pipeline: keeps the first and the last vertex that it has taken.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Stage<V, B = HalfPlane> {
    boundary: B,
    first: Option<Placed<V>>,
    previous: Option<Placed<V>>,
    /// The end of an edge whose crossing is still on its way through the next stages.
    waiting: Option<V>,
}

impl<V: Cut, B: Boundary<V>> Stage<V, B> {
    /// The stage of a boundary, which has taken nothing yet.
    #[must_use]
    pub const fn new(boundary: B) -> Self {
        Self { boundary, first: None, previous: None, waiting: None }
    }

    /// Takes a vertex, gives one; a second one waits.
    fn take(&mut self, vertex: V) -> Option<V> {
        let here = (vertex, self.boundary.distance(&vertex));
        let inside = (here.1 >= 0).then_some(vertex);
        let Some(previous) = self.previous.replace(here) else {
            self.first = Some(here);
            return inside;
        };
        let cut = crossing(previous, here);
        if cut.is_some() {
            self.waiting = inside;
        }
        cut.or(inside)
    }

    /// Closes the polygon: gives the crossing of its last edge. Then nothing is kept any more.
    fn close(&mut self) -> Option<V> {
        let (previous, first) = self.previous.take().zip(self.first.take())?;
        crossing(previous, first)
    }

    fn reset(&mut self) {
        (self.first, self.previous, self.waiting) = (None, None, None);
    }
}

/// Stages, one behind the other, in memory of the caller's. No stages let everything through.
///
/// ```
/// use aquatint::{Point2, clip::{convex::ConvexWindow, sutherland_hodgman::Pipeline}};
/// use heapless::Vec;
///
/// let diamond = [(4, 0), (8, 4), (4, 8), (0, 4)].map(|(x, y)| Point2::corner(x, y));
/// let window = ConvexWindow::new(&diamond).unwrap();
/// let mut stages = Vec::<_, 4>::new();
/// let mut pipeline = Pipeline::build(window.half_planes(), &mut stages)?;
///
/// let square = [(0, 0), (4, 0), (4, 4), (0, 4)].map(|(x, y)| Point2::corner(x, y));
/// let mut visible = Vec::<Point2, 8>::new();
/// pipeline.clip(&square, |vertex| visible.push(vertex)).unwrap();
/// assert_eq!(visible, [(4, 0), (4, 4), (0, 4)].map(|(x, y)| Point2::corner(x, y)));
/// # Ok::<(), aquatint::clip::sutherland_hodgman::Full>(())
/// ```
#[derive(Debug)]
pub struct Pipeline<'s, V, B = HalfPlane> {
    stages: &'s mut [Stage<V, B>],
}

impl<'s, V: Cut, B: Boundary<V>> Pipeline<'s, V, B> {
    /// A pipeline of these stages. Forgets what they have taken before.
    #[must_use]
    pub fn new(stages: &'s mut [Stage<V, B>]) -> Self {
        stages.iter_mut().for_each(Stage::reset);
        Self { stages }
    }

    /// A pipeline of a stage for each boundary. `memory` is emptied first.
    ///
    /// # Errors
    /// [`Full`] when there are more boundaries than `memory` has room for stages.
    pub fn build(boundaries: impl IntoIterator<Item = B>, memory: &'s mut VecView<Stage<V, B>>) -> Result<Self, Full> {
        memory.clear();
        for boundary in boundaries {
            memory.push(Stage::new(boundary)).map_err(|_| Full)?;
        }
        Ok(Self { stages: memory })
    }

    /// Sends a whole polygon through. Gives `emit` the vertices of what lies inside of all boundaries.
    ///
    /// Cost: a distance for each vertex and stage, one division a coordinate where an edge is cut.
    ///
    /// # Errors
    /// What `emit` says; the polygon ends there.
    pub fn clip<E>(&mut self, polygon: &[V], mut emit: impl FnMut(V) -> Result<(), E>) -> Result<(), E> {
        for &vertex in polygon {
            self.push(vertex, &mut emit)?;
        }
        self.close(emit)
    }

    /// Sends the next vertex of a polygon through, as it is made: no list of them is needed.
    ///
    /// # Errors
    /// What `emit` says; the polygon ends there.
    pub fn push<E>(&mut self, vertex: V, emit: impl FnMut(V) -> Result<(), E>) -> Result<(), E> {
        self.flow(0, vertex, emit)
    }

    /// Joins the last vertex with the first. The next one begins another polygon.
    ///
    /// # Errors
    /// What `emit` says; the polygon ends there.
    pub fn close<E>(&mut self, mut emit: impl FnMut(V) -> Result<(), E>) -> Result<(), E> {
        for at in 0..self.stages.len() {
            if let Some(vertex) = self.stages.get_mut(at).and_then(Stage::close) {
                self.flow(at + 1, vertex, &mut emit)?;
            }
        }
        Ok(())
    }

    /// Sends a vertex through the stages from `at` on, and what it makes them give.
    ///
    /// A loop and no recursion: the depth of the stack does not grow with the number of stages.
    fn flow<E>(&mut self, mut at: usize, mut vertex: V, mut emit: impl FnMut(V) -> Result<(), E>) -> Result<(), E> {
        loop {
            let given = self.stages.get_mut(at).map(|stage| stage.take(vertex));
            if given.is_none() {
                emit(vertex).inspect_err(|_| self.stages.iter_mut().for_each(Stage::reset))?;
            }
            let next = given.flatten().map(|vertex| (at + 1, vertex)).or_else(|| self.waiting_before(at));
            let Some(next) = next else { return Ok(()) };
            (at, vertex) = next;
        }
    }

    /// The last vertex that waits in a stage up to `at`, and the stage that it goes to.
    fn waiting_before(&mut self, at: usize) -> Option<(usize, V)> {
        let mut stages = self.stages.iter_mut().enumerate().take(at.saturating_add(1)).rev();
        stages.find_map(|(at, stage)| Some((at + 1, stage.waiting.take()?)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use heapless::Vec;

    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    struct Corner(i32, i32);

    impl Cut for Corner {
        fn cut(inside: Self, outside: Self, crossing: Crossing) -> Self {
            Self(crossing.coordinate(inside.0, outside.0), crossing.coordinate(inside.1, outside.1))
        }
    }

    #[test]
    fn a_triangle_loses_a_corner() {
        //   ·    x = 4
        //  ╱ ╲    │
        // ●───────┼──●
        let mut out = Vec::<Corner, 4>::new();
        clip(&[Corner(0, 0), Corner(8, 0), Corner(2, 4)], |v| i64::from(4 - v.0), &mut out).unwrap();
        assert_eq!(out, [Corner(0, 0), Corner(4, 0), Corner(4, 3), Corner(2, 4)]);
    }

    #[test]
    fn all_in_all_out_and_no_room() {
        let square = [Corner(0, 0), Corner(2, 0), Corner(2, 2), Corner(0, 2)];
        let mut out = Vec::<Corner, 4>::new();
        clip(&square, |_| 0, &mut out).unwrap();
        assert_eq!(out, square, "on the boundary is inside");
        clip(&square, |v| -i64::from(v.0), &mut out).unwrap();
        assert_eq!(out, [Corner(0, 0), Corner(0, 2)], "a vertex on the boundary comes once");
        clip(&square, |_| -1, &mut out).unwrap();
        assert!(out.is_empty());
        clip(&[], |_: &Corner| 0, &mut out).unwrap();
        assert!(out.is_empty());
        assert_eq!(clip(&square, |v| i64::from(3 - v.0 - v.1), &mut out), Err(Full));
    }

    #[test]
    fn a_pipeline_that_was_interrupted_begins_anew() {
        let square = [(0, 0), (9, 0), (9, 9), (0, 9)].map(|(x, y)| Point2::from_sixteenths(x, y));
        let window = ClipWindow::new(Point2::from_sixteenths(-1, 3), Point2::from_sixteenths(5, 6));
        let (mut stages, mut whole) = (window.half_planes().map(Stage::new), Vec::<Point2, 12>::new());
        let mut pipeline = Pipeline::new(&mut stages);
        pipeline.clip(&square, |v| whole.push(v)).unwrap();
        for room in 0..whole.len() {
            let mut left = room;
            let refused = pipeline.clip(&square, |_| left.checked_sub(1).map(|less| left = less).ok_or(room));
            assert_eq!(refused, Err(room));
            let mut again = Vec::<Point2, 12>::new();
            pipeline.clip(&square, |v| again.push(v)).unwrap();
            assert_eq!(again, whole);
        }
    }
}
