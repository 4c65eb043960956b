//! The visible pixels of a line are those of the whole line, whatever its ends and the window.
#![no_main]

#[path = "../../tests/exact/mod.rs"]
mod exact;

use aquatint::{Line, Rect, SpanFn};
use arbitrary::Arbitrary;
use embedded_graphics::geometry::Point;
use libfuzzer_sys::fuzz_target;

#[derive(Arbitrary, Debug)]
struct Input {
    start: (i32, i32),
    end: (i32, i32),
    /// Ends near the window instead of anywhere.
    is_near: bool,
    corner: (i32, i32),
    size: (u16, u16),
}

fuzz_target!(|input: Input| {
    let size = (i32::from(input.size.0 % 600), i32::from(input.size.1 % 600));
    let (left, top) = (input.corner.0.min(i32::MAX - size.0), input.corner.1.min(i32::MAX - size.1));
    let window = Rect::new(left, top, left + size.0, top + size.1);
    let place = |(x, y): (i32, i32)| {
        if input.is_near {
            Point::new(left.saturating_add(x % 2000), top.saturating_add(y % 2000))
        } else {
            Point::new(x, y)
        }
    };
    let line = Line::new(place(input.start), place(input.end));

    let mut pixels = vec![];
    let Ok(()) = line.spans(&mut SpanFn::new(window, |row: i32, columns: core::ops::Range<i32>, ()| {
        assert_eq!(window.clip_run(row, columns.clone()), Some(columns.clone()), "inside and not empty");
        pixels.extend(columns.map(|column| (column, row)));
    }));
    pixels.sort_unstable();
    assert_eq!(pixels, exact::line(line, window));
});
