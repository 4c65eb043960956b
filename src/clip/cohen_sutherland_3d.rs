//! Cohen-Sutherland line clipping in three dimensions, before the perspective divide. Lecture 3.5.2.
//!
//! ```text
//!   bit  6    5      4     3    2   1    0        both outcodes zero:      accept
//!       top bottom right left far near  eye       a bit that both have:    reject
//!                                                 else cut at a plane of   and look again
//!   an outcode a vertex, once for all its lines   a bit that is set,
//! ```
//!
//! Best where most lines lie outside altogether, and where vertices are shared: an outcode serves all the lines that
//! end there. [`liang_barsky_3d`](super::liang_barsky_3d) gives the same ends to the last bit.
//!
//! As in [two dimensions](super::cohen_sutherland), a cut is made on the *original* line: the place is kept as the
//! fraction of its way, and judged exactly, before anything is rounded.

use super::{
    crossing::Cut,
    line_3d::{Meeting, Parameter},
    vertex::Homogeneous,
    volume::{Face, Volume},
    window::Boundary,
};

/// The part of a line in clip space that lies in a volume; `None` if it has none.
///
/// What [`liang_barsky_3d::clip`](super::liang_barsky_3d::clip) gives, to the last bit. No arithmetic but for the
/// outcodes if they decide; else two distances a plane that is looked at, and one 64-bit division for an end that is cut.
///
/// ```
/// use aquatint::{Clip, Point4, Scalar, clip::{cohen_sutherland_3d::clip, volume::Volume}};
///
/// let point = |x: i32, w: i32| Point4::<Clip>::new(Scalar::from_num(x), Scalar::ZERO, Scalar::ZERO, Scalar::from_num(w));
/// // From inside to the right and behind the eye.
/// let part = clip((point(0, 3), point(4, -1)), Volume::View);
/// assert_eq!(part, Some((point(0, 3), Point4::new(Scalar::from_num(1.5), Scalar::ZERO, Scalar::ZERO, Scalar::from_num(1.5)))));
/// ```
#[must_use]
pub fn clip<V: Homogeneous + Cut>((start, end): (V, V), volume: Volume) -> Option<(V, V)> {
    let codes = (volume.outcode(&start.point()), volume.outcode(&end.point()));
    clip_with((start, end), codes, volume)
}

/// [`clip`] where the outcodes of the ends are known, of this volume.
///
/// With other outcodes some part of the line comes out, or none.
#[must_use]
pub fn clip_with<V: Homogeneous + Cut>(
    (start, end): (V, V),
    (mut start_code, mut end_code): (u8, u8),
    volume: Volume,
) -> Option<(V, V)> {
    let (mut enters, mut leaves) = (None::<Parameter>, None::<Parameter>);
    // Each cut clears a bit for good, so there are seven an end at most; the bound makes plain that this ends.
    for _ in 0..15 {
        if start_code & end_code != 0 {
            return None;
        }
        if start_code | end_code == 0 {
            let first = enters.map_or(start, |place| place.entry(start, end));
            let last = leaves.map_or(end, |place| place.exit(start, end));
            return Some((first, last));
        }
        let faces = volume.faces();
        let meeting = |face: &Face| Meeting::of(face.distance(&start), face.distance(&end));
        let code_of = |place| {
            let code = |code: u8, face: &Face| code << 1 | u8::from(meeting(face).is_outside(place));
            faces.iter().rev().fold(0, code)
        };
        let lowest = (start_code | end_code).trailing_zeros();
        match faces.iter().zip(0..).find(|(_, bit)| *bit == lowest).map(|(face, _)| meeting(face))? {
            Meeting::Enters(place) => (enters, start_code) = (Some(place), code_of(place)),
            Meeting::Leaves(place) => (leaves, end_code) = (Some(place), code_of(place)),
            Meeting::Inside | Meeting::Outside => return None,
        }
    }
    None
}
