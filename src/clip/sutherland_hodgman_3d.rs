//! Sutherland-Hodgman polygon clipping in clip space: planes of the user's, then the volume. Lecture 3.5 and 3.3.3.
//!
//! ```text
//!   polygon ──▶ clip planes ──▶ eye ──▶ near ──▶ far ──▶ left … top ──▶ what can be divided by w
//! ```
//!
//! One boundary after the other, into another list and back, and only those beyond which there is a vertex:
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

/// Leaves of a polygon in clip space what lies inside of all planes and of the volume, which may be nothing.
///
/// What the other list holds is used up. Of `n` vertices and `k` planes, a convex polygon has at
/// most `n + k + 7`, any other `n + (k + 7)·⌊n/2⌋`: that is the room that both lists need.
///
/// Cost: an outcode a vertex; a distance for each vertex and clip plane; one 64-bit division where an edge is cut.
///
/// # Errors
/// [`Full`] when a list has no room. Then the polygon is something between what it was and what would be left of it.
pub fn clip<V: Homogeneous + Cut>(
    polygon: &mut VecView<V>,
    spare: &mut VecView<V>,
    planes: &[ClipPlane],
    volume: Volume,
) -> Result<(), Full> {
    let codes = polygon.iter().map(|vertex| volume.outcode(&vertex.point()));
    let (any, all) = codes.fold((0, u8::MAX), |(any, all), code| (any | code, all & code));
    if all != 0 {
        polygon.clear();
        return Ok(());
    }
    for plane in planes {
        if polygon.iter().any(|vertex| plane.distance(vertex) < 0) {
            step(polygon, spare, |vertex| plane.distance(vertex))?;
        }
    }
    for (bit, face) in volume.faces().iter().enumerate() {
        if any >> bit & 1 != 0 {
            step(polygon, spare, |vertex| face.distance(vertex))?;
        }
    }
    Ok(())
}

/// Clips into the other list, and copies back: what is left is where the caller has it.
fn step<V: Cut>(polygon: &mut VecView<V>, spare: &mut VecView<V>, distance: impl Fn(&V) -> i64) -> Result<(), Full> {
    sutherland_hodgman::clip(polygon, distance, spare)?;
    polygon.clear();
    polygon.extend_from_slice(spare).map_err(|_| Full)
}
