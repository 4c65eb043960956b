//! What a pen does not want to see may be left out, and nothing else.

use core::ops::Range;

use aquatint::{Affine, Angle, Hershey, Outline, Pen, Point2, Polygon, Polyline, Rect, Stroked, Subpixel, Text};
use proptest::prelude::*;

use super::strokes::{points, stroke};

/// Collects the edges that reach into some heights.
struct Seen {
    heights: Range<i32>,
    says_so: bool,
    first: Point2,
    last: Point2,
    edges: Vec<[(i32, i32); 2]>,
}

impl Pen for Seen {
    fn move_to(&mut self, point: Point2) {
        (self.first, self.last) = (point, point);
    }

    fn line_to(&mut self, point: Point2) {
        let [from, to] = [self.last, point].map(|end| (end.x.to_bits(), end.y.to_bits()));
        self.last = point;
        let (top, bottom) = (from.1.min(to.1), from.1.max(to.1));
        if top < bottom && top < self.heights.end && bottom > self.heights.start {
            self.edges.push([from, to]);
        }
    }

    fn close(&mut self) {
        self.line_to(self.first);
    }

    fn heights(&self) -> Range<Subpixel> {
        if self.says_so {
            return Subpixel::from_bits(self.heights.start)..Subpixel::from_bits(self.heights.end);
        }
        Subpixel::MIN..Subpixel::MAX
    }
}

/// The edges of an outline in some heights, coarse or fine, and whether its pen says which heights those are.
fn edges(outline: &impl Outline, heights: Range<i32>, is_fine: bool, says_so: bool) -> Vec<[(i32, i32); 2]> {
    let (first, last) = (Point2::default(), Point2::default());
    let mut seen = Seen { heights, says_so, first, last, edges: vec![] };
    if is_fine {
        outline.trace_fine(&mut seen);
    } else {
        outline.trace(&mut seen);
    }
    seen.edges
}

fn is_whole(outline: &impl Outline, heights: &Range<i32>) -> Result<(), TestCaseError> {
    for is_fine in [false, true] {
        let all = edges(outline, heights.clone(), is_fine, false);
        prop_assert_eq!(edges(outline, heights.clone(), is_fine, true), all, "fine: {}", is_fine);
    }
    Ok(())
}

fn heights() -> impl Strategy<Value = Range<i32>> {
    let start = prop_oneof![-100..400_i32, -2000..7000_i32, Just(i32::MIN), Just(i32::MAX - 600)];
    (start, 0..600_i32).prop_map(|(start, height)| start..start + height)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3_000))]

    #[test]
    fn strokes_leave_out_nothing_that_is_wanted(corners in points(2..8), stroke in stroke(), heights in heights()) {
        is_whole(&Stroked::new(Polyline::new(&corners).expect("in range"), stroke), &heights)?;
        let contours = [&corners[..]];
        is_whole(&Stroked::new(Polygon::new(&contours).expect("in range"), stroke), &heights)?;
    }

    #[test]
    fn nor_do_strokes_of_glyphs(stroke in stroke(), heights in heights(), turn in any::<u16>()) {
        let text = Text::new(&Hershey::SIMPLEX, "a&g", Subpixel::from_num(20), Point2::corner(4, 18));
        let text = text.with_map(Affine::turn(Angle(turn)));
        for glyph in text.glyphs(Rect::new(-40, -40, 80, 80)) {
            is_whole(&Stroked::new(glyph, stroke), &heights)?;
        }
    }
}

#[test]
fn what_is_out_of_sight_is_left_out() {
    let corners = [(0, 0), (0, 1000), (500, 1000)].map(|(x, y)| Point2::from_sixteenths(x, y));
    let stroked = Stroked::new(Polyline::new(&corners).expect("in range"), aquatint::Stroke::new(2));
    let mut lines = 0;
    stroked.trace(&mut Counter { lines: &mut lines });
    // Of two strips, a join and no caps there is one strip near the upper end.
    assert_eq!(lines, 3);
}

/// Wants the uppermost pixels, and counts.
struct Counter<'l> {
    lines: &'l mut u32,
}

impl Pen for Counter<'_> {
    fn move_to(&mut self, _: Point2) {}

    fn line_to(&mut self, _: Point2) {
        *self.lines += 1;
    }

    fn close(&mut self) {}

    fn heights(&self) -> Range<Subpixel> {
        Subpixel::ZERO..Subpixel::from_num(10)
    }
}
