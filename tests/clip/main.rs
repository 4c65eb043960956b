//! Clipping in two dimensions against exact arithmetic, on random and hostile input.

#[path = "../exact/mod.rs"]
mod exact;

mod bounds;
mod lines;
mod oracle;
mod pictures;
mod polygons;
mod separate;

use aquatint::Point2;
use proptest::prelude::*;

/// Coordinates of all kinds: small, of a screen, anywhere, and at the ends of the range.
fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        4 => -20..20_i32,
        4 => -2000..2000_i32,
        2 => any::<i32>(),
        1 => (0..20_i32).prop_map(|v| i32::MIN + v),
        1 => (0..20_i32).prop_map(|v| i32::MAX - v),
    ]
}

fn places() -> impl Strategy<Value = (i32, i32)> {
    (coordinate(), coordinate())
}

/// Corners on sixteenths within a range.
fn corners(range: core::ops::Range<i32>, count: core::ops::Range<usize>) -> impl Strategy<Value = Vec<Point2>> {
    let point = (range.clone(), range).prop_map(|(x, y)| Point2::from_sixteenths(x, y));
    prop::collection::vec(point, count)
}
