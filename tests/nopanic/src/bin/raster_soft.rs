//! Antialiased paths: area averaging, oversampling, and the antialiased style.
#![no_std]
#![no_main]

use aquatint::{
    AntialiasedStyle, Coverage, CoverageMask, Oversampled, Path, Placed, Segment, Sink,
    raster::{
        area::{self, AreaEdge, Scratch},
        scan::{self, ActiveEdge},
    },
};
use embedded_graphics::{pixelcolor::Gray4, primitives::StyledDimensions};
use heapless::Vec;
use nopanic::{
    any, keep, lent,
    shapes::{map, rule, segments, soft, soft_sink},
};

/// What a caller lends.
struct Memory {
    bytes: [u8; 2048],
    segments: [Segment; 8],
    edges: Vec<ActiveEdge, 24>,
    area_edges: Vec<AreaEdge, 24>,
    cells: [Coverage; 64],
}

const MEMORY: Memory = Memory {
    bytes: [0; 2048],
    segments: [Segment::Close; 8],
    edges: Vec::new(),
    area_edges: Vec::new(),
    cells: [Coverage::NONE; 64],
};

nopanic::entries! { MEMORY, 60;
    area_fill,
    coverage_mask_fill,
    coverage_mask_spans,
    oversampled_span,
    oversampled_fill,
    soft_path,
    soft_placed_path,
    soft_path_bounding_box,
}

fn path(memory: &mut [Segment; 8]) -> Option<Path<'_>> {
    Path::new(segments(memory)).ok()
}

fn area_fill(memory: &mut Memory) {
    let Some(path) = path(&mut memory.segments) else { return };
    let scratch = Scratch { edges: &mut memory.area_edges, cells: lent(&mut memory.cells) };
    keep(area::fill(&path, rule(), scratch, &mut soft_sink()));
}

fn coverage_mask_fill(memory: &mut Memory) {
    let Some(path) = path(&mut memory.segments) else { return };
    let Some(mut mask) = CoverageMask::new(lent(&mut memory.bytes), any()) else { return };
    let scratch = Scratch { edges: &mut memory.area_edges, cells: lent(&mut memory.cells) };
    keep(area::fill(&path, rule(), scratch, &mut mask));
}

fn coverage_mask_spans(memory: &mut Memory) {
    let Some(mut mask) = CoverageMask::new(lent(&mut memory.bytes), any()) else { return };
    keep((mask.bytes().len(), mask.spans(any(), &mut soft_sink())));
    mask.clear();
}

fn oversampled_span(memory: &mut Memory) {
    let mut soft = soft_sink();
    let mut fine = Oversampled::new(lent(&mut memory.cells), &mut soft);
    keep(fine.span(any(), any()..any(), ()));
    keep(fine.finish());
}

fn oversampled_fill(memory: &mut Memory) {
    let Some(path) = path(&mut memory.segments) else { return };
    let mut soft = soft_sink();
    let mut fine = Oversampled::new(lent(&mut memory.cells), &mut soft);
    keep(scan::fill(&path, rule(), &mut memory.edges, &mut fine));
    keep(fine.finish());
}

fn soft_path(memory: &mut Memory) {
    if let Some(path) = path(&mut memory.segments) {
        soft(&path, &mut memory.bytes);
    }
}

fn soft_placed_path(memory: &mut Memory) {
    if let Some(path) = path(&mut memory.segments) {
        soft(&Placed::new(path, map()), &mut memory.bytes);
    }
}

fn soft_path_bounding_box(memory: &mut Memory) {
    let style = AntialiasedStyle::stroke(Gray4::new(any()), any());
    keep(path(&mut memory.segments).map(|path| path.styled_bounding_box(&style)));
}
