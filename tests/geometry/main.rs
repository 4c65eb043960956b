//! Geometry processing against floating point and exact arithmetic, on random and hostile input.

mod chain;
mod face;
mod inverse;
mod light;
mod quaternion;
mod transform;
mod viewport;

use aquatint::Scalar;
use proptest::prelude::*;

fn number(value: f64) -> Scalar {
    Scalar::saturating_from_num(value)
}

/// A matrix element: of a usual matrix, of any size, and the ends of the range.
fn element() -> impl Strategy<Value = Scalar> {
    prop_oneof![
        4 => -300_000..300_000_i32,
        2 => -(1 << 27)..(1 << 27),
        1 => any::<i32>(),
        1 => prop::sample::select(vec![0, 1, -1, i32::MIN, i32::MAX]),
    ]
    .prop_map(Scalar::from_bits)
}

/// The rows of a matrix of such elements.
fn rows() -> impl Strategy<Value = [[Scalar; 4]; 4]> {
    prop::array::uniform4(prop::array::uniform4(element()))
}

/// A place in a mesh, its ends more often than chance.
fn place() -> impl Strategy<Value = [i16; 3]> {
    let coordinate = prop_oneof![3 => any::<i16>(), 1 => prop::sample::select(vec![0, i16::MIN, i16::MAX])];
    prop::array::uniform3(coordinate)
}
