//! Area averaging of any contours: no panic, spans inside and in order, bands as the whole, little memory nearly so.
#![no_main]

use std::ops::Range;

use aquatint::{
    Coverage, Covered, Join, Outline, Pen, Point2, Rect, Rule, SpanFn, Stroke, Stroked, Subpixel,
    raster::area::{AreaEdge, Scratch, fill},
};
use arbitrary::Arbitrary;
use heapless::{Vec as List, vec::VecView};
use libfuzzer_sys::fuzz_target;

#[derive(Arbitrary, Clone, Copy, Debug)]
enum Place {
    Near(u8, u8),
    Wide(i16, i16),
    Far(i32, i32),
}

#[derive(Arbitrary, Debug)]
struct Input {
    contours: Vec<Vec<Place>>,
    is_even_odd: bool,
    width: Option<u8>,
    join: u8,
    corner: (i32, i32),
    size: (u8, u8),
    cells: u8,
    band: u8,
}

/// A few contours of a few corners.
struct Contours<'i>(&'i [Vec<Place>]);

impl Outline for Contours<'_> {
    fn trace<P: Pen>(&self, pen: &mut P) {
        for contour in self.0.iter().take(3) {
            let mut places = contour.iter().take(8).map(|place| match *place {
                Place::Near(x, y) => Point2::from_sixteenths(2 * i32::from(x), 2 * i32::from(y)),
                Place::Wide(x, y) => Point2::from_sixteenths(x.into(), y.into()),
                Place::Far(x, y) => Point2::from_sixteenths(x, y),
            });
            let Some(first) = places.next() else { continue };
            pen.move_to(first);
            places.for_each(|place| pen.line_to(place));
            pen.close();
        }
    }
}

/// The covered parts of the pixels of a window, each given once at most.
fn covered(
    outline: &impl Outline,
    (rule, window): (Rule, Rect),
    edges: &mut VecView<AreaEdge>,
    cells: &mut [Coverage],
) -> Vec<u16> {
    let width = window.columns().len();
    let mut picture = vec![0; width * window.rows().len()];
    let mut last = None;
    let mut sink = SpanFn::new(window, |row: i32, columns: Range<i32>, covered: Covered<'_>| {
        assert_eq!(window.clip_run(row, columns.clone()), Some(columns.clone()));
        assert!(last.is_none_or(|last| last <= (row, columns.start)), "out of order");
        last = Some((row, columns.end));
        for (offset, column) in columns.enumerate() {
            let place = row.abs_diff(window.top) as usize * width + column.abs_diff(window.left) as usize;
            picture[place] = covered.at(offset).parts();
        }
    });
    let Ok(()) = fill(outline, rule, Scratch { edges, cells }, &mut sink);
    picture
}

fn check(outline: &impl Outline, rule: Rule, window: Rect, input: &Input) {
    let mut cells = [Coverage::NONE; 32];
    let whole = covered(outline, (rule, window), &mut List::<AreaEdge, 512>::new(), &mut cells);
    // In pieces of the row, and from any row on.
    let mut few = vec![Coverage::FULL; usize::from(input.cells % 40)];
    let pieces = covered(outline, (rule, window), &mut List::<AreaEdge, 512>::new(), &mut few);
    assert!(whole.iter().zip(&pieces).all(|(whole, piece)| whole.abs_diff(*piece) <= 16), "{whole:?}\n{pieces:?}");
    let top = window.top.saturating_add(i32::from(input.band % 16)).min(window.bottom);
    let band = covered(outline, (rule, Rect { top, ..window }), &mut List::<AreaEdge, 512>::new(), &mut cells);
    assert_eq!(whole[whole.len() - band.len()..], band[..]);
    // With no list at all; crossings and slopes are sampled.
    let strips = covered(outline, (rule, window), &mut List::<AreaEdge, 3>::new(), &mut cells);
    assert!(strips.iter().all(|parts| *parts <= 32_768));
}

fuzz_target!(|input: Input| {
    let (left, top) = input.corner;
    let window = Rect::new(
        left,
        top,
        left.saturating_add((input.size.0 % 32).into()),
        top.saturating_add((input.size.1 % 16).into()),
    );
    let near = Rect::new(0, 0, 32, 16);
    let rule = if input.is_even_odd { Rule::EvenOdd } else { Rule::NonZero };
    let shape = Contours(&input.contours);
    match input.width {
        None => [window, near].into_iter().for_each(|window| check(&shape, rule, window, &input)),
        Some(width) => {
            let join = [Join::Miter { limit: 4 }, Join::Round, Join::Bevel][usize::from(input.join) % 3];
            let stroke = Stroke::of_width(Subpixel::from_bits(width.into())).with_join(join);
            let line = Stroked::new(&shape, stroke);
            [window, near].into_iter().for_each(|window| check(&line, Rule::NonZero, window, &input));
        }
    }
});
