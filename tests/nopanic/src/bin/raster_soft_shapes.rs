//! Antialiased polygons, ovals and dashes.
#![no_std]
#![no_main]

use aquatint::{Dashed, Oval, Path, Point2, Polygon, Polyline, Segment, Subpixel};
use nopanic::{
    any, part,
    shapes::{segments, soft},
    some,
};

/// What a caller lends.
struct Memory {
    bytes: [u8; 2048],
    segments: [Segment; 8],
    corners: [Point2; 8],
    lengths: [Subpixel; 6],
}

const MEMORY: Memory = Memory {
    bytes: [0; 2048],
    segments: [Segment::Close; 8],
    corners: [Point2::corner(0, 0); 8],
    lengths: [Subpixel::ZERO; 6],
};

nopanic::entries! { MEMORY, 60;
    soft_polygon,
    soft_polyline,
    soft_oval,
    soft_dashed,
}

fn soft_polygon(memory: &mut Memory) {
    let corners = some(&mut memory.corners);
    if let Ok(polygon) = Polygon::new(part(&[corners, part(corners)])) {
        soft(&polygon, &mut memory.bytes);
    }
}

fn soft_polyline(memory: &mut Memory) {
    if let Ok(line) = Polyline::new(some(&mut memory.corners)) {
        soft(&line, &mut memory.bytes);
    }
}

fn soft_oval(memory: &mut Memory) {
    if let Ok(oval) = Oval::new(any(), any()) {
        soft(&oval, &mut memory.bytes);
    }
}

fn soft_dashed(memory: &mut Memory) {
    let Ok(path) = Path::new(segments(&mut memory.segments)) else { return };
    soft(&Dashed::new(&path, some(&mut memory.lengths), any()).within(any()), &mut memory.bytes);
}
