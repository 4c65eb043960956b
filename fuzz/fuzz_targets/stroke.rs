//! Strokes, dashes and thick lines of anything: no pixel twice or outside, the same in pieces and from both ends.
#![no_main]

#[path = "../../tests/exact/mod.rs"]
mod exact;

use aquatint::{
    Cap, Dashed, Flatten, Join, Line, Outline, Pen, Point2, Rect, SpanFn, Stroke, Stroked, Subpixel,
    raster::scan::ActiveEdge,
};
use arbitrary::Arbitrary;
use embedded_graphics::geometry::Point;
use exact::Overdraw;
use heapless::Vec as List;
use libfuzzer_sys::fuzz_target;

#[derive(Arbitrary, Clone, Copy, Debug)]
enum Place {
    Near(i8, i8),
    Wide(i16, i16),
    Far(i32, i32),
}

#[derive(Arbitrary, Debug)]
enum Step {
    Move(Place),
    Line(Place),
    Quad(Place, Place),
    Cubic(Place, Place, Place),
    Close,
}

#[derive(Arbitrary, Debug)]
struct Input {
    steps: Vec<Step>,
    width: u16,
    join: u8,
    cap: u8,
    dashes: Vec<u8>,
    offset: i16,
    ends: (Place, Place),
    corner: (i8, i8),
    size: (u8, u8),
}

impl Place {
    fn sixteenths(self) -> Point2 {
        match self {
            Self::Near(x, y) => Point2::from_sixteenths(4 * i32::from(x), 4 * i32::from(y)),
            Self::Wide(x, y) => Point2::from_sixteenths(x.into(), y.into()),
            Self::Far(x, y) => Point2::from_sixteenths(x, y),
        }
    }

    fn pixel(self) -> Point {
        match self {
            Self::Near(x, y) => Point::new(x.into(), y.into()),
            Self::Wide(x, y) => Point::new(x.into(), y.into()),
            Self::Far(x, y) => Point::new(x, y),
        }
    }
}

/// A path of a few steps.
struct Steps<'i>(&'i [Step]);

impl Outline for Steps<'_> {
    fn trace<P: Pen>(&self, pen: &mut P) {
        let mut pen = Flatten::new(pen);
        for step in self.0.iter().take(6) {
            match step {
                Step::Move(to) => pen.move_to(to.sixteenths()),
                Step::Line(to) => pen.line_to(to.sixteenths()),
                Step::Quad(control, to) => pen.quad_to(control.sixteenths(), to.sixteenths()),
                Step::Cubic(a, b, to) => pen.cubic_to(a.sixteenths(), b.sixteenths(), to.sixteenths()),
                Step::Close => pen.close(),
            }
        }
    }
}

/// How often each pixel of a window is drawn.
fn drawn(window: Rect, draw: impl FnOnce(&mut SpanFn<&mut dyn FnMut(i32, std::ops::Range<i32>, ())>)) -> Overdraw {
    let mut pixels = Overdraw::new(window);
    draw(&mut SpanFn::new(window, &mut |row, columns, ()| pixels.add(row, columns)));
    pixels
}

fuzz_target!(|input: Input| {
    let join = [Join::Miter { limit: input.join }, Join::Round, Join::Bevel][usize::from(input.join) % 3];
    let cap = [Cap::Butt, Cap::Round, Cap::Square][usize::from(input.cap) % 3];
    let stroke = Stroke::of_width(Subpixel::from_bits(input.width.into())).with_join(join).with_cap(cap);
    let (left, top) = (i32::from(input.corner.0 % 30), i32::from(input.corner.1 % 30));
    let window = Rect::new(left, top, left + i32::from(input.size.0 % 20), top + i32::from(input.size.1 % 20));

    let path = Steps(&input.steps);
    let stroked = Stroked::new(&path, stroke);
    let whole = drawn(window, |sink| {
        let Ok(()) = stroked.spans(&mut List::<ActiveEdge, 64>::new(), sink);
    });
    let pieces = drawn(window, |sink| {
        let Ok(()) = stroked.spans_of_pieces(sink);
    });
    for (x, y) in whole.places() {
        assert_eq!(whole.count(x, y), pieces.count(x, y).min(1), "{x}, {y}");
    }

    let lengths: Vec<_> = input.dashes.iter().take(6).map(|&length| Subpixel::from_bits(length.into())).collect();
    let dashed = Dashed::new(&path, &lengths, Subpixel::from_bits(input.offset.into())).within(window);
    let dashes = drawn(window, |sink| {
        let Ok(()) = Stroked::new(&dashed, stroke).spans_of_pieces(sink);
    });
    std::hint::black_box(dashes);

    let thick = |start: Place, end: Place| {
        drawn(window, |sink| {
            let Ok(()) = Line::new(start.pixel(), end.pixel()).stroke_spans(stroke, sink);
        })
    };
    let line = thick(input.ends.0, input.ends.1);
    assert_eq!(line, thick(input.ends.1, input.ends.0), "from both ends");
    assert!(line.places().all(|(x, y)| line.count(x, y) < 2), "a pixel twice");
});
