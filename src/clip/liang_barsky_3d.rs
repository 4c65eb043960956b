//! Liang-Barsky line clipping in three dimensions, against a volume or any planes. Lecture 3.5.3.
//!
//! ```text
//!          near ╲   far         p(t) = start + t · (end − start)
//!   start ●──────╲───│───● end
//!                 ╲  │          enters near at t = 3/8, leaves far at t = 3/4:
//!               3/8╲ │3/4       visible between them
//! ```
//!
//! Each boundary is crossed at some t, inwards or outwards. What is inside of all of them begins where the last is
//! crossed inwards and ends where the first is crossed outwards; if that is not in this order, nothing is. No t is
//! computed: each is kept as a fraction of two distances, and two are compared by cross multiplication, exactly. So
//! there are divisions only for an end that is cut, after the line has been accepted.
//!
//! A boundary is whatever tells distances: the [faces](Volume::faces) of the volume, [`ClipPlane`](super::clip_plane::ClipPlane)s
//! and, for lines in the world or in a model, [`HalfSpace`](super::half_space::HalfSpace)s.
//!
//! Y.-D. Liang and B. A. Barsky, "A new concept and method for line clipping", ACM Transactions on Graphics
//! 3(1), 1984.

use super::{
    crossing::Cut,
    line_3d::{Meeting, Parameter},
    vertex::Homogeneous,
    volume::Volume,
    window::Boundary,
};

/// The part of a line in clip space that lies in a volume, before the perspective divide; `None` if it has none.
///
/// Attributes are cut with it. Decides exactly for all coordinates. Ends that are cut are the true intersections to the
/// nearest, ties to the larger, the same whichever end comes first; in [`Volume::View`] they are inside of all of its
/// boundaries again.
#[must_use]
pub fn clip<V: Homogeneous + Cut>(line: (V, V), volume: Volume) -> Option<(V, V)> {
    clip_to(line, volume.faces())
}

/// The part of a line that lies on the inner side of all boundaries, in any space; `None` if it has none.
///
/// No memory. Two distances a boundary, one 64-bit division for an end that is cut.
///
/// ```
/// use aquatint::{HalfSpace, Point3, Scalar, Vector3, World, clip::liang_barsky_3d::clip_to};
///
/// let point = |x: i32, y: i32| Point3::<World>::new(Scalar::from_num(x), Scalar::from_num(y), Scalar::ZERO);
/// // What is above the ground, where y is 1.
/// let up = Vector3::new(Scalar::ZERO, Scalar::ONE, Scalar::ZERO);
/// let ground = HalfSpace::through(point(0, 1), up)?;
/// assert_eq!(clip_to((point(0, 0), point(8, 4)), [ground]), Some((point(2, 1), point(8, 4))));
/// # Ok::<(), aquatint::OutOfRange>(())
/// ```
#[must_use]
pub fn clip_to<V: Cut, B: Boundary<V>>(
    (start, end): (V, V),
    boundaries: impl IntoIterator<Item = B>,
) -> Option<(V, V)> {
    let (mut enters, mut leaves) = (None::<Parameter>, None::<Parameter>);
    for boundary in boundaries {
        match Meeting::of(boundary.distance(&start), boundary.distance(&end)) {
            Meeting::Outside => return None,
            Meeting::Enters(place) if enters.is_none_or(|last| place.is_after(last)) => enters = Some(place),
            Meeting::Leaves(place) if leaves.is_none_or(|first| first.is_after(place)) => leaves = Some(place),
            Meeting::Inside | Meeting::Enters(_) | Meeting::Leaves(_) => {}
        }
    }
    if enters.zip(leaves).is_some_and(|(enters, leaves)| enters.is_after(leaves)) {
        return None;
    }
    let first = enters.map_or(start, |place| place.entry(start, end));
    let last = leaves.map_or(end, |place| place.exit(start, end));
    Some((first, last))
}
