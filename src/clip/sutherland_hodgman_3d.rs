//! Sutherland-Hodgman polygon clipping in clip space: planes of the user's, then the volume. Lecture 3.5 and 3.3.3.
//!
//! ```text
//!   polygon ──▶ clip planes ──▶ eye ──▶ near ──▶ far ──▶ left … top ──▶ what can be divided by w
//! ```
//!
//! One boundary after the other, from one list into another and back, and only those beyond which there is a vertex:
//! most polygons need one or none. See [`sutherland_hodgman`] for the method, its exact and
//! symmetric cuts, and the bounds.

use heapless::vec::VecView;

use super::{
    clip_plane::ClipPlane,
    crossing::Cut,
    sutherland_hodgman::{self, Full},
    vertex::Homogeneous,
    volume::Volume,
    window::Boundary,
};

/// The part of a polygon in clip space that lies inside of all planes and of the volume. Empty if there is none.
///
/// It is in one of the two lists, whose contents are used up. Of `n` vertices and `k` planes, a convex polygon has at
/// most `n + k + 7`, any other `n + (k + 7)·⌊n/2⌋`: that is the room that both lists need.
///
/// Cost: an outcode a vertex; a distance for each vertex and clip plane; one 64-bit division where an edge is cut.
///
/// # Errors
/// [`Full`] when a list has no room.
pub fn clip<'m, V: Homogeneous + Cut>(
    polygon: &'m mut VecView<V>,
    spare: &'m mut VecView<V>,
    planes: &[ClipPlane],
    volume: Volume,
) -> Result<&'m mut VecView<V>, Full> {
    let codes = polygon.iter().map(|vertex| volume.outcode(&vertex.point()));
    let (any, all) = codes.fold((0, u8::MAX), |(any, all), code| (any | code, all & code));
    if all != 0 {
        polygon.clear();
        return Ok(polygon);
    }
    let mut lists = (polygon, spare);
    for plane in planes {
        if lists.0.iter().any(|vertex| plane.distance(vertex) < 0) {
            lists = step(lists, plane)?;
        }
    }
    for (bit, face) in volume.faces().iter().enumerate() {
        if any >> bit & 1 != 0 {
            lists = step(lists, face)?;
        }
    }
    Ok(lists.0)
}

/// A list of vertices, and another to work in.
type Lists<'m, V> = (&'m mut VecView<V>, &'m mut VecView<V>);

/// Clips from one list into the other, and changes their places.
fn step<'m, V: Cut>((polygon, spare): Lists<'m, V>, boundary: &impl Boundary<V>) -> Result<Lists<'m, V>, Full> {
    sutherland_hodgman::clip(polygon, |vertex| boundary.distance(vertex), spare)?;
    Ok((spare, polygon))
}
