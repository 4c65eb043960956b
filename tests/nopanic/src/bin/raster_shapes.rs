//! Shapes with outlines: traced, filled, stroked and dashed.
#![no_std]
#![no_main]

use aquatint::{
    Chord, Dashed, Flatten, Oval, Path, Pen, Placed, Point2, Polygon, Polyline, RoundedRectangle, Sector, Segment,
    Stroked, Subpixel, SvgPath, curve,
    raster::scan::{self, ActiveEdge},
};
use embedded_graphics::{
    prelude::*,
    primitives::{ContainsPoint, StyledDimensions},
    transform::Transform,
};
use heapless::Vec;
use nopanic::{
    any, keep, part,
    shapes::{Kept, fill_style, map, rule, segments, sink, stroke, stroke_style, styled, traced},
    some, text,
};

/// What a caller lends.
struct Memory {
    bytes: [u8; 2048],
    segments: [Segment; 8],
    corners: [Point2; 8],
    lengths: [Subpixel; 6],
    edges: Vec<ActiveEdge, 24>,
}

const MEMORY: Memory = Memory {
    bytes: [0; 2048],
    segments: [Segment::Close; 8],
    corners: [Point2::corner(0, 0); 8],
    lengths: [Subpixel::ZERO; 6],
    edges: Vec::new(),
};

nopanic::entries! { MEMORY, 100;
    scan_fill,
    scan_peak_edges,
    scan_contains,
    pixel_bounds,
    path_traced,
    path_filled,
    path_stroked,
    placed_path_traced,
    placed_path_filled,
    polygon_traced,
    polygon_spans,
    polygon_filled,
    polyline_bounding_box,
    polyline_stroked,
    rounded_rectangle_traced,
    oval_traced,
    oval_filled,
    arc_traced,
    chord_traced,
    sector_traced,
    svg_path_traced,
    svg_path_filled,
    svg_path_bounding_box,
    quadratic,
    cubic,
    flatten,
    stroke_spans,
    stroke_spans_of_pieces,
    polyline_stroke_spans,
    dashed,
    dashed_bounding_box,
}

fn path(memory: &mut [Segment; 8]) -> Option<Path<'_>> {
    Path::new(segments(memory)).ok()
}

fn scan_fill(memory: &mut Memory) {
    let Some(path) = path(&mut memory.segments) else { return };
    keep(scan::fill(&path, rule(), &mut memory.edges, &mut sink()));
}

fn scan_peak_edges(memory: &mut Memory) {
    keep(path(&mut memory.segments).map(|path| scan::peak_edges(&path)));
}

fn scan_contains(memory: &mut Memory) {
    keep(path(&mut memory.segments).map(|path| (scan::contains(&path, rule(), any()), path.contains(any()))));
}

fn pixel_bounds(memory: &mut Memory) {
    keep(path(&mut memory.segments).map(|path| (aquatint::pixel_bounds(&path), path.bounding_box())));
}

fn path_traced(memory: &mut Memory) {
    if let Some(path) = path(&mut memory.segments) {
        traced(&path);
    }
}

fn path_filled(memory: &mut Memory) {
    if let Some(path) = path(&mut memory.segments) {
        styled(&path, &fill_style(), &mut memory.bytes);
    }
}

fn path_stroked(memory: &mut Memory) {
    if let Some(path) = path(&mut memory.segments) {
        styled(&path, &stroke_style(), &mut memory.bytes);
    }
}

fn placed_path_traced(memory: &mut Memory) {
    if let Some(path) = path(&mut memory.segments) {
        traced(&Placed::new(path, map()).translate(any()));
    }
}

fn placed_path_filled(memory: &mut Memory) {
    if let Some(path) = path(&mut memory.segments) {
        styled(&Placed::new(path, map()), &fill_style(), &mut memory.bytes);
    }
}

fn polygon_traced(memory: &mut Memory) {
    let corners = some(&mut memory.corners);
    if let Ok(polygon) = Polygon::new(part(&[corners, part(corners)])) {
        traced(&polygon);
        keep((polygon.bounding_box(), polygon.contains(any())));
    }
}

fn polygon_spans(memory: &mut Memory) {
    let corners = some(&mut memory.corners);
    if let Ok(polygon) = Polygon::new(part(&[corners, part(corners)])) {
        keep(polygon.spans(rule(), &mut memory.edges, &mut sink()));
    }
}

fn polygon_filled(memory: &mut Memory) {
    let corners = some(&mut memory.corners);
    if let Ok(polygon) = Polygon::new(part(&[corners, part(corners)])) {
        styled(&polygon, &fill_style(), &mut memory.bytes);
    }
}

fn polyline(corners: &mut [Point2]) -> Option<Polyline<'_>> {
    if any() { Polyline::new(some(corners)).ok() } else { Polyline::closed(some(corners)).ok() }
}

fn polyline_bounding_box(memory: &mut Memory) {
    keep(polyline(&mut memory.corners).map(|line| line.bounding_box()));
}

fn polyline_stroked(memory: &mut Memory) {
    if let Some(line) = polyline(&mut memory.corners) {
        styled(&line, &stroke_style(), &mut memory.bytes);
    }
}

fn rounded_rectangle_traced(_: &mut Memory) {
    if let Ok(rounded) = RoundedRectangle::new(any(), any()) {
        traced(&rounded.with_radii(any()));
        keep((rounded.radii(), rounded.bounding_box(), rounded.contains(any())));
    }
}

fn oval_traced(_: &mut Memory) {
    if let Ok(oval) = Oval::new(any(), any()) {
        traced(&oval);
        keep((oval.bounding_box(), oval.contains(any())));
    }
}

fn oval_filled(memory: &mut Memory) {
    if let Ok(oval) = Oval::new(any(), any()) {
        styled(&oval, &fill_style(), &mut memory.bytes);
    }
}

fn arc_traced(_: &mut Memory) {
    if let Ok(oval) = Oval::new(any(), any()) {
        let arc = oval.arc(any(), any());
        traced(&arc);
        keep((arc.bounding_box(), arc.start_point()));
    }
}

fn chord_traced(_: &mut Memory) {
    if let Ok(oval) = Oval::new(any(), any()) {
        let chord = Chord(oval.arc(any(), any()));
        traced(&chord);
        keep((chord.bounding_box(), chord.contains(any())));
    }
}

fn sector_traced(_: &mut Memory) {
    if let Ok(oval) = Oval::new(any(), any()) {
        let sector = Sector(oval.arc(any(), any()));
        traced(&sector);
        keep((sector.bounding_box(), sector.contains(any())));
    }
}

fn svg_path_traced(_: &mut Memory) {
    match SvgPath::new(text()) {
        Ok(path) => traced(&path.with_map(map()).scaled(any())),
        Err(error) => keep((error.offset, error.problem)),
    }
}

fn svg_path_filled(memory: &mut Memory) {
    if let Ok(path) = SvgPath::new(text()) {
        styled(&path, &fill_style(), &mut memory.bytes);
    }
}

fn svg_path_bounding_box(_: &mut Memory) {
    if let Ok(path) = SvgPath::new(text()) {
        keep((path.translate(any()).bounding_box(), path.contains(any())));
    }
}

fn quadratic(_: &mut Memory) {
    curve::quadratic(&mut Kept, any());
}

fn cubic(_: &mut Memory) {
    curve::cubic(&mut Kept, any());
}

fn flatten(_: &mut Memory) {
    let mut kept = Kept;
    let mut pen = Flatten::new(&mut kept);
    pen.move_to(any());
    pen.line_to(any());
    pen.quad_to(any(), any());
    pen.cubic_to(any(), any(), any());
    if let Ok(oval) = Oval::new(any(), any()) {
        pen.arc(&oval.arc(any(), any()));
    }
    pen.close();
}

fn stroke_spans(memory: &mut Memory) {
    let Some(path) = path(&mut memory.segments) else { return };
    keep(Stroked::new(&path, stroke()).spans(&mut memory.edges, &mut sink()));
}

fn stroke_spans_of_pieces(memory: &mut Memory) {
    let Some(path) = path(&mut memory.segments) else { return };
    keep(Stroked::new(&path, stroke()).spans_of_pieces(&mut sink()));
}

fn polyline_stroke_spans(memory: &mut Memory) {
    let Some(line) = polyline(&mut memory.corners) else { return };
    keep(Stroked::new(&line, stroke()).spans(&mut memory.edges, &mut sink()));
}

fn dashed(memory: &mut Memory) {
    let Some(path) = path(&mut memory.segments) else { return };
    let dashed = Dashed::new(&path, some(&mut memory.lengths), any()).within(any());
    styled(&dashed, &stroke_style(), &mut memory.bytes);
}

fn dashed_bounding_box(memory: &mut Memory) {
    let Some(path) = path(&mut memory.segments) else { return };
    keep(Dashed::new(&path, some(&mut memory.lengths), any()).within(any()).bounding_box());
}
