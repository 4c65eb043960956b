//! Lines, circles, triangles and floods.
#![no_std]
#![no_main]

use core::ops::Range;

use aquatint::{
    Circle, Connectivity, DdaLine, Ellipse, Flood, Frame, InPlace, Line, RampLine, Region, Rows, SpanFn, Stipple,
    StippledLine, Triangle,
    cut::Cut,
    raster::flood::{Run, words_needed},
    vary::{Ramp, Vertex},
};
use embedded_graphics::{
    geometry::Point, image::GetPixel, pixelcolor::Gray4, prelude::*, primitives::StrokeAlignment, transform::Transform,
};
use heapless::Vec;
use nopanic::{
    any, keep, lent, one_of,
    shapes::{fill_style, sink, stroke, stroke_style, styled},
    side, window,
};

/// What a caller lends.
struct Memory {
    bytes: [u8; 2048],
    visited: [u32; 128],
    queue: Vec<Run, 32>,
}

const MEMORY: Memory = Memory { bytes: [0; 2048], visited: [0; 128], queue: Vec::new() };

nopanic::entries! { MEMORY;
    line_spans = |_: &mut Memory| keep(Line::new(any(), any()).spans(&mut sink())),
    line_stroke_spans = |_: &mut Memory| keep(Line::new(any(), any()).stroke_spans(stroke(), &mut sink())),
    line_styled = |memory: &mut Memory| styled(&Line::new(any(), any()), &stroke_style(), &mut memory.bytes),
    dda_line_spans = |_: &mut Memory| keep(DdaLine::new(any(), any()).spans(&mut sink())),
    dda_line_styled = |memory: &mut Memory| styled(&DdaLine::new(any(), any()), &stroke_style(), &mut memory.bytes),
    stippled_line_spans = |_: &mut Memory| keep(stippled().spans(&mut sink())),
    stippled_line_styled = |memory: &mut Memory| styled(&stippled(), &stroke_style(), &mut memory.bytes),
    lines_bounding_box,
    ramp_line_spans,
    circle_spans = |_: &mut Memory| keep(circle().spans(&mut sink())),
    circle_stroke_spans = |_: &mut Memory| keep(circle().stroke_spans(any(), alignment(), &mut sink())),
    circle_filled = |memory: &mut Memory| styled(&circle(), &fill_style(), &mut memory.bytes),
    circle_stroked = |memory: &mut Memory| styled(&circle(), &stroke_style(), &mut memory.bytes),
    ellipse_spans = |_: &mut Memory| keep(ellipse().spans(&mut sink())),
    ellipse_stroke_spans = |_: &mut Memory| keep(ellipse().stroke_spans(any(), alignment(), &mut sink())),
    ellipse_filled = |memory: &mut Memory| styled(&ellipse(), &fill_style(), &mut memory.bytes),
    ellipse_stroked = |memory: &mut Memory| styled(&ellipse(), &stroke_style(), &mut memory.bytes),
    rounds_bounding_box,
    triangle_spans,
    cut,
    flood_words_needed = |_: &mut Memory| keep(words_needed(any(), any())),
    flood_from_point,
    flood_fill,
    flood_fill_with,
    flood_search,
    flood_in_place,
}

fn stippled() -> StippledLine {
    Stipple::new(any()).times(any()).along(Line::new(any(), any()))
}

fn lines_bounding_box(_: &mut Memory) {
    let line = Line::new(any(), any());
    keep((line.bounding_box(), line.translate(any()), DdaLine::new(any(), any()).bounding_box()));
    keep(stippled().bounding_box());
}

fn vertex() -> Vertex<2> {
    Vertex { position: any(), attributes: any() }
}

fn ramp_line_spans(_: &mut Memory) {
    if let Ok(line) = RampLine::new([vertex(), vertex()]) {
        let mut sink = SpanFn::new(window(), |row: i32, columns: Range<i32>, ramp: Ramp<2>| keep((row, columns, ramp)));
        keep(line.spans(&mut sink));
    }
}

fn circle() -> Circle {
    Circle::new(any(), any())
}

fn ellipse() -> Ellipse {
    Ellipse::new(any(), any())
}

fn alignment() -> StrokeAlignment {
    one_of(&[StrokeAlignment::Inside, StrokeAlignment::Center, StrokeAlignment::Outside])
}

fn rounds_bounding_box(_: &mut Memory) {
    keep((circle().contains(any()), ellipse().contains(any())));
    keep((Circle::with_center(any(), any()), Ellipse::with_center(any(), any()), Ellipse::from(circle())));
    keep((circle().bounding_box(), ellipse().bounding_box(), circle().translate(any()), ellipse().translate(any())));
}

fn triangle_spans(_: &mut Memory) {
    if let Ok(triangle) = Triangle::new([vertex(), vertex(), vertex()]) {
        let mut sink = SpanFn::new(window(), |row: i32, columns: Range<i32>, ramp: Ramp<2>| keep((row, columns, ramp)));
        keep(triangle.spans(&mut sink));
    }
}

fn cut(_: &mut Memory) {
    let cuts = [Cut::of_edge(any(), any()), Cut::of_values(&any(), any())];
    keep((cuts[0].other(), cuts[1].keeps(any(), any()), cuts[1].keep(any(), any()..any())));
}

type Grey<'a> = Frame<Gray4, Rows, &'a mut [u8]>;

/// A frame, and what else a flood is lent.
fn lent_flood(memory: &mut Memory) -> Option<(Grey<'_>, Flood<'_>)> {
    let frame = Grey::new(lent(&mut memory.bytes), side(), side()).ok()?;
    Some((
        frame,
        Flood::new(lent(&mut memory.visited), lent(full(&mut memory.queue))).with_connectivity(connectivity()),
    ))
}

fn connectivity() -> Connectivity {
    one_of(&[Connectivity::Four, Connectivity::Eight])
}

fn color() -> Gray4 {
    Gray4::new(any())
}

fn region() -> Region<Gray4> {
    if any() { Region::Boundary(any(), color()) } else { Region::Flood(any()) }
}

fn flood_from_point(memory: &mut Memory) {
    let Some((mut frame, mut flood)) = lent_flood(memory) else { return };
    keep((frame.pixel(any()), flood.fill(&mut frame, any::<Point>(), color()).is_ok()));
}

fn flood_fill(memory: &mut Memory) {
    let Some((mut frame, flood)) = lent_flood(memory) else { return };
    keep(flood.with_window(any()).fill(&mut frame, region(), color()).is_ok());
}

fn flood_fill_with(memory: &mut Memory) {
    let Some((mut frame, flood)) = lent_flood(memory) else { return };
    keep(flood.with_window(any()).fill_with(&mut frame, region(), color()).is_ok());
}

fn flood_search(memory: &mut Memory) {
    let Some((frame, flood)) = lent_flood(memory) else { return };
    if let Ok(found) = flood.with_window(any()).search(&frame, region()) {
        keep(found.spans(&mut sink()));
    }
}

fn flood_in_place(memory: &mut Memory) {
    let Ok(mut frame) = Grey::new(lent(&mut memory.bytes), side(), side()) else { return };
    let flood = InPlace::new(lent(full(&mut memory.queue))).with_connectivity(connectivity());
    let mut flood = if any() { flood } else { flood.with_window(any()) };
    keep(flood.fill(&mut frame, region(), color()).is_ok());
}

fn full(queue: &mut Vec<Run, 32>) -> &mut [Run] {
    keep(queue.resize_default(32));
    queue
}
