//! The primitives of embedded-graphics, antialiased.
#![no_std]
#![no_main]

use embedded_graphics::{geometry::Point, primitives};
use nopanic::{any, shapes::soft, some};

/// What a caller lends.
struct Memory {
    bytes: [u8; 2048],
    points: [Point; 8],
}

const MEMORY: Memory = Memory { bytes: [0; 2048], points: [Point::zero(); 8] };

nopanic::entries! { MEMORY, 60;
    soft_line = |memory: &mut Memory| soft(&primitives::Line::new(any(), any()), &mut memory.bytes),
    soft_ellipse = |memory: &mut Memory| soft(&primitives::Ellipse::new(any(), any()), &mut memory.bytes),
    soft_triangle = |memory: &mut Memory| soft(&primitives::Triangle::new(any(), any(), any()), &mut memory.bytes),
    soft_rectangle = |memory: &mut Memory| soft(&primitives::Rectangle::new(any(), any()), &mut memory.bytes),
    soft_rounded_rectangle,
    soft_polyline_of_points,
}

fn soft_rounded_rectangle(memory: &mut Memory) {
    soft(&primitives::RoundedRectangle::with_equal_corners(any(), any()), &mut memory.bytes);
}

fn soft_polyline_of_points(memory: &mut Memory) {
    soft(&primitives::Polyline::new(some(&mut memory.points)), &mut memory.bytes);
}
