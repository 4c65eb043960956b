//! Polygon clipping that gives separate polygons where a concave subject falls apart. Lecture 3.3.2.
//!
//! ```text
//!   ┌─────┐ ┌─────┐           ┌─────┐ ┌─────┐
//!  ─┼─────┼─┼─────┼─▶    ──▶  └◀────┘ └◀────┘     each way out is joined with the
//!   │     └─┘     │          out   in out   in    next way in along the boundary
//!   └─────────────┘
//! ```
//!
//! As in [`sutherland_hodgman`](super::sutherland_hodgman), one boundary after the other, and the same cuts. But
//! the places where the outline goes out and comes in again are sorted along the boundary, and the first way out
//! is joined with the first way in, the second with the second and so on. The inside of a simple polygon lies
//! between just these, whichever way round it runs, so no edge runs along the boundary and back. After K. Weiler and
//! P. Atherton, "Hidden surface removal using polygon area sorting", Computer Graphics (SIGGRAPH) 11(2), 1977, for
//! a window that is convex.
//!
//! - **Takes** contours that do not cross themselves or each other; holes run the other way round than what they are
//!   holes of. Any coordinates.
//! - **Gives** the polygons one by one, in any order, and each in the orientation of the subject. A hole that is cut
//!   becomes part of the outline; one that is not is given as a polygon by itself.
//! - **Memory** a [`Node`] of 12 bytes for each vertex and each cut: `n + 2·k·⌊n/2⌋` for `n` vertices and `k`
//!   boundaries are always enough, `n + 2·k` if they are convex; 65,535 at most. And a list for one polygon.
//! - **Cost** a distance for each node and boundary, four where something is outside; sorting the cuts.
//!
//! Contours that cross are not refused: how ways out and in are joined changes the winding only on the boundary. So
//! the polygons together still have the area of the subject, by both fill rules, though they may touch, overlap or
//! have edges there and back. The same goes for cuts that round to one point.

use heapless::vec::VecView;

use crate::{
    sort::heap_sort,
    space::{Point2, twice_area},
};

use super::{
    crossing::{Crossing, Cut},
    sutherland_hodgman::Full,
    window::{HalfPlane, PlanePoint},
};

/// A vertex in a closed chain: what [`separate`] works in.
#[derive(Clone, Copy, Debug)]
pub struct Node {
    position: Point2,
    /// The next vertex; for a fresh way out the one before.
    link: u16,
    state: State,
}

impl Node {
    fn distance(&self, boundary: HalfPlane) -> i64 {
        boundary.distance(self.position.coordinates())
    }
}

/// What a node is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum State {
    /// Where the outline leaves through the present boundary.
    WayOut,
    /// Where it comes in again.
    WayIn,
    /// Part of the outline.
    Linked,
    /// Outside, or given to the caller.
    Gone,
}

/// Clips contours to the common part of half-planes: a rectangle's or a convex window's.
///
/// ```
/// use aquatint::{Point2, Rect, clip::{separate::separate, window::ClipWindow}};
/// use heapless::Vec;
///
/// // A U, of which only the arms are seen.
/// let subject = [(0, 0), (2, 0), (2, 4), (4, 4), (4, 0), (6, 0), (6, 6), (0, 6)].map(|(x, y)| Point2::corner(x, y));
/// let window = ClipWindow::<Point2>::from(Rect::new(0, 0, 6, 3));
/// let mut memory = Vec::<_, 16>::new();
/// let mut pieces = separate(&[&subject], window.half_planes(), &mut memory)?;
///
/// let (mut corners, mut left) = (Vec::<Point2, 8>::new(), Vec::<i32, 2>::new());
/// while pieces.next_into(&mut corners)? {
///     left.push(corners.iter().map(|v| v.x.to_num()).min().unwrap()).unwrap();
/// }
/// assert_eq!(left, [0, 4]);
/// # Ok::<(), aquatint::clip::sutherland_hodgman::Full>(())
/// ```
///
/// # Errors
/// [`Full`] when `memory`, which is emptied first, has not enough nodes.
pub fn separate<'m>(
    contours: &[&[Point2]],
    boundaries: impl IntoIterator<Item = HalfPlane>,
    memory: &'m mut VecView<Node>,
) -> Result<Pieces<'m>, Full> {
    memory.clear();
    for contour in contours {
        load(contour, memory)?;
    }
    for boundary in boundaries {
        let is_outside = |node: &Node| node.state == State::Linked && node.distance(boundary) < 0;
        if memory.iter().any(is_outside) {
            cut(boundary, memory)?;
            join(boundary, memory);
        }
    }
    Ok(Pieces { nodes: memory, next: 0 })
}

/// The number of a node that is about to be added.
fn next_index(nodes: &[Node]) -> Result<u16, Full> {
    u16::try_from(nodes.len()).map_err(|_| Full)
}

/// Adds a node, if there is room and its number is below 65,535.
fn push(nodes: &mut VecView<Node>, node: Node) -> Result<(), Full> {
    if next_index(nodes)? == u16::MAX { Err(Full) } else { nodes.push(node).map_err(|_| Full) }
}

/// Links the vertices of a contour in a ring.
fn load(contour: &[Point2], nodes: &mut VecView<Node>) -> Result<(), Full> {
    let first = next_index(nodes)?;
    for &position in contour {
        let link = next_index(nodes)?.saturating_add(1);
        push(nodes, Node { position, link, state: State::Linked })?;
    }
    if let (Some(last), false) = (nodes.last_mut(), contour.is_empty()) {
        last.link = first;
    }
    Ok(())
}

/// Adds the ways out and in through a boundary behind the other nodes, and drops what is outside.
///
/// What is on the boundary is outside here: an edge along it is no part of the outline but what joins a way out and
/// a way in, if the inside of the subject and that of the boundary are on the same side of it.
fn cut(boundary: HalfPlane, nodes: &mut VecView<Node>) -> Result<(), Full> {
    for index in 0..next_index(nodes)? {
        let Some(&node) = linked(nodes, index) else { continue };
        let Some(&next) = linked(nodes, node.link) else { continue };
        let (before, here) = (node.distance(boundary), next.distance(boundary));
        let way = if before > 0 && here <= 0 {
            let position = Cut::cut(node.position, next.position, Crossing::new(before, here));
            Node { position, link: index, state: State::WayOut }
        } else if before <= 0 && here > 0 {
            let position = Cut::cut(next.position, node.position, Crossing::new(here, before));
            Node { position, link: node.link, state: State::WayIn }
        } else {
            continue;
        };
        push(nodes, way)?;
    }
    for node in nodes.iter_mut().filter(|node| node.state == State::Linked && node.distance(boundary) <= 0) {
        node.state = State::Gone;
    }
    Ok(())
}

/// A node that is part of the outline.
fn linked(nodes: &[Node], index: u16) -> Option<&Node> {
    nodes.get(usize::from(index)).filter(|node| node.state == State::Linked)
}

/// Joins the ways out with the ways in, in the order in which both lie along the boundary.
fn join(boundary: HalfPlane, nodes: &mut [Node]) {
    let old = nodes.iter().take_while(|node| matches!(node.state, State::Linked | State::Gone)).count();
    let Some((nodes, ways)) = nodes.split_at_mut_checked(old) else { return };
    let key = |way: &Node| (way.state, boundary.position(way.position.coordinates()));
    heap_sort(ways, |one, other| key(one) < key(other));
    // A ring goes out as often as it comes in.
    let Some((ways_out, ways_in)) = ways.split_at_mut_checked(ways.len() / 2) else { return };
    let numbers = (old..).zip(old + ways_out.len()..).map(|(out, into)| (u16::try_from(out), u16::try_from(into)));
    for ((way_out, way_in), numbers) in ways_out.iter_mut().zip(ways_in).zip(numbers) {
        let (Ok(out), Ok(into)) = numbers else { return };
        if let Some(before) = nodes.get_mut(usize::from(way_out.link)) {
            before.link = out;
        }
        way_out.link = into;
        (way_out.state, way_in.state) = (State::Linked, State::Linked);
    }
}

/// The polygons that are left.
#[derive(Debug)]
pub struct Pieces<'m> {
    nodes: &'m mut [Node],
    next: u16,
}

impl Pieces<'_> {
    /// Writes the next polygon to `corners`, which is emptied first; false when there is none any more.
    ///
    /// It has three corners or more, no two in succession are equal, and they are not all in line.
    ///
    /// # Errors
    /// [`Full`] when `corners` has no room for it. With a larger list one can ask again.
    pub fn next_into(&mut self, corners: &mut VecView<Point2>) -> Result<bool, Full> {
        while usize::from(self.next) < self.nodes.len() {
            corners.clear();
            self.walk(|node| push_distinct(corners, node.position))?;
            while corners.len() > 1 && corners.first() == corners.last() {
                corners.pop();
            }
            self.walk(|node| {
                node.state = State::Gone;
                Ok(())
            })?;
            self.next = self.next.saturating_add(1);
            if has_area(corners) {
                return Ok(true);
            }
        }
        corners.clear();
        Ok(false)
    }

    /// Visits the ring of the next node, if that is part of one.
    fn walk(&mut self, mut visit: impl FnMut(&mut Node) -> Result<(), Full>) -> Result<(), Full> {
        let mut at = self.next;
        for _ in 0..self.nodes.len() {
            let Some(node) = self.nodes.get_mut(usize::from(at)).filter(|node| node.state == State::Linked) else {
                return Ok(());
            };
            at = node.link;
            visit(node)?;
            if at == self.next {
                return Ok(());
            }
        }
        Ok(())
    }
}

fn push_distinct(corners: &mut VecView<Point2>, corner: Point2) -> Result<(), Full> {
    if corners.last() == Some(&corner) { Ok(()) } else { corners.push(corner).map_err(|_| Full) }
}

/// Whether there are three corners that are not in line. Exact: an area within the range of `i32` is below 2⁶⁴.
fn has_area(corners: &[Point2]) -> bool {
    match corners {
        [a, b, others @ ..] => others.iter().any(|&c| twice_area(*a, *b, c) != 0),
        _ => false,
    }
}
