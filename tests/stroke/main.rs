//! Thick lines, strokes and dashes against slow oracles, and as pictures.

mod dashes;
#[path = "../exact/mod.rs"]
mod exact;
mod heights;
mod ideal;
mod pictures;
mod strokes;
mod thick_lines;

use core::ops::Range;

use aquatint::{Outline, Rect, Rule, SpanFn, Stroke, Stroked, raster::scan::ActiveEdge, raster::scan::fill};
use exact::Overdraw;
use heapless::Vec as List;

/// How often each pixel is drawn by an outline that is filled by the non-zero rule.
fn filled<const N: usize>(outline: &impl Outline, window: Rect) -> Overdraw {
    let (mut edges, mut pixels) = (List::<ActiveEdge, N>::new(), Overdraw::new(window));
    let sink = |row, columns: Range<i32>, ()| pixels.add(row, columns);
    let Ok(()) = fill(outline, Rule::NonZero, &mut edges, &mut SpanFn::new(window, sink));
    pixels
}

/// The same of its stroke.
fn stroked(outline: &impl Outline, stroke: Stroke, window: Rect) -> Overdraw {
    filled::<24>(&Stroked::new(outline, stroke), window)
}
