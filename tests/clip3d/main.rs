//! Clipping in space against exact arithmetic, on random and hostile input.
#![expect(clippy::cast_precision_loss, reason = "oracles with a margin")]

#[path = "../exact/mod.rs"]
mod exact;

mod bounding;
mod lines;
mod oracle;
mod pictures;
mod planes;
mod polygons;

use aquatint::{Clip, ClipVertex, Point3, Point4, Scalar};
use proptest::prelude::*;

/// Coordinates of all kinds: small, of a scene, of clip space, anywhere, and at the ends of the range.
fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        4 => -20..20_i32,
        4 => -200_000..200_000_i32,
        2 => -(1 << 28) + 1..1_i32 << 28,
        2 => any::<i32>(),
        1 => (0..20_i32).prop_map(|v| i32::MIN + v),
        1 => (0..20_i32).prop_map(|v| i32::MAX - v),
    ]
}

/// Homogeneous places: anywhere, or near to the boundaries of a volume.
fn places() -> impl Strategy<Value = [i32; 4]> {
    let times = prop_oneof![Just(-4_i64), Just(-1), Just(0), Just(1), Just(4)];
    let on_boundaries = (coordinate(), prop::array::uniform3((times, -2..=2_i64))).prop_map(|(w, sides)| {
        let [x, y, z] = sides.map(|(times, more)| i32::try_from(i64::from(w) * times + more).unwrap_or(w));
        [x, y, z, w]
    });
    let at_the_eye = (prop::array::uniform3(coordinate()), 8190..8195_i32).prop_map(|([x, y, z], w)| [x, y, z, w]);
    prop_oneof![6 => prop::array::uniform4(coordinate()), 3 => on_boundaries, 1 => at_the_eye]
}

fn point4([x, y, z, w]: [i32; 4]) -> Point4<Clip> {
    let [x, y, z, w] = [x, y, z, w].map(Scalar::from_bits);
    Point4::new(x, y, z, w)
}

fn point3<S>([x, y, z]: [i32; 3]) -> Point3<S> {
    let [x, y, z] = [x, y, z].map(Scalar::from_bits);
    Point3::new(x, y, z)
}

fn vertex((place, attributes): ([i32; 4], [u16; 2])) -> ClipVertex<2> {
    ClipVertex { point: point4(place), attributes }
}

fn vertices() -> impl Strategy<Value = ([i32; 4], [u16; 2])> {
    (places(), prop::array::uniform2(prop_oneof![Just(0), Just(u16::MAX), any::<u16>()]))
}
