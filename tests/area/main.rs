//! Area averaging against the exact area.

#![expect(clippy::cast_sign_loss, reason = "small, and tested before")]

mod curves;
mod hostile;
mod masks;
mod oracle;
mod pieces;
mod polygons;
mod samples;
mod sharing;
mod strokes;

use aquatint::{Coverage, Outline, Point2, Rect, Rule, raster::area::AreaEdge};
use heapless::Vec as List;
use proptest::prelude::*;

const WINDOW: Rect = Rect { left: -3, top: -2, right: 29, bottom: 22 };

/// The covered parts of the pixels of a window, with memory enough.
fn drawn(outline: &impl Outline, rule: Rule, window: Rect) -> Vec<u16> {
    let (mut edges, mut cells) = (List::<AreaEdge, 1024>::new(), [Coverage::NONE; 64]);
    polygons::covered(outline, rule, window, &mut edges, &mut cells)
}

/// The greatest error in 256ths of a pixel.
fn worst(ours: &[u16], exact: &[f64]) -> f64 {
    let errors = ours.iter().zip(exact).map(|(ours, exact)| (f64::from(*ours) / 128.0 - exact * 256.0).abs());
    errors.fold(0.0, f64::max)
}

/// The greatest difference in 32768ths of a pixel.
fn apart(one: &[u16], other: &[u16]) -> u16 {
    assert_eq!(one.len(), other.len());
    one.iter().zip(other).map(|(one, other)| one.abs_diff(*other)).max().unwrap_or(0)
}

fn point() -> impl Strategy<Value = Point2> {
    let coordinate = || prop_oneof![4 => -100..500_i32, 1 => -5000..5000_i32];
    (coordinate(), coordinate()).prop_map(|(x, y)| Point2::from_sixteenths(x, y))
}

fn rule() -> impl Strategy<Value = Rule> {
    prop_oneof![Just(Rule::NonZero), Just(Rule::EvenOdd)]
}
