//! Cohen-Sutherland line clipping. Lecture 3.2.2.
//!
//! ```text
//!        ●                    both outcodes zero:           accept
//!  ┌─────┼──────┐             a bit that both have:         reject
//!  │      ╲     │             else cut at the boundary of   and look again
//!  │       ╲────●             a bit that is set,
//!  └────────────┘
//! ```
//!
//! Every cut is made on the *original* line: moving an end, rounding it and cutting the moved line
//! again, as the textbook does, drifts by hundreds of pixels on long lines and decides wrongly on
//! some. So an intersection here is the nearest whole point of the true line.

use embedded_graphics::geometry::Point;

use crate::{outcode::Outcode, space::Rect};

/// The part of the line from `start` to `end` that lies in `window`, ends included; `None` if it
/// has none.
///
/// Right for all coordinates. Cut ends lie on the boundary and within half a pixel of the line.
/// For *drawing*, use [`raster::bresenham`](crate::raster::bresenham), which clips without moving
/// a pixel.
///
/// ```
/// use aquatint::{Rect, clip::cohen_sutherland::clip};
/// use embedded_graphics::geometry::Point;
///
/// let window = Rect::new(0, 0, 10, 10);
/// let part = clip((Point::new(-5, 0), Point::new(15, 20)), window);
/// assert_eq!(part, Some((Point::new(0, 5), Point::new(4, 9))));
/// ```
#[must_use]
pub fn clip((start, end): (Point, Point), window: Rect) -> Option<(Point, Point)> {
    // In one order, so that a line that only grazes a corner is judged alike from both ends.
    if (start.x, start.y) > (end.x, end.y) {
        return clip_ordered((end, start), window).map(|(near, far)| (far, near));
    }
    clip_ordered((start, end), window)
}

fn clip_ordered(line: (Point, Point), window: Rect) -> Option<(Point, Point)> {
    if window.is_empty() {
        return None;
    }
    let (mut near, mut far) = line;
    // At most two cuts an end; the bound makes plain that this ends.
    for _ in 0..5 {
        let (near_code, far_code) = (Outcode::of(near, window), Outcode::of(far, window));
        if near_code.is_inside() && far_code.is_inside() {
            return Some((near, far));
        }
        if !(near_code & far_code).is_inside() {
            return None;
        }
        if near_code.is_inside() {
            far = cut(line, window, far_code);
        } else {
            near = cut(line, window, near_code);
        }
    }
    None
}

/// Where the line crosses the boundary of a set bit.
fn cut((a, b): (Point, Point), window: Rect, code: Outcode) -> Point {
    // The last row and column inside: `right` and `bottom` are behind.
    if code.is_above() || code.is_below() {
        let y = if code.is_above() { window.top } else { window.bottom - 1 };
        Point::new(crossing((a.y, a.x), (b.y, b.x), y), y)
    } else {
        let x = if code.is_left() { window.left } else { window.right - 1 };
        Point::new(x, crossing((a.x, a.y), (b.x, b.y), x))
    }
}

/// The second coordinate of the line where the first is `at`, to the nearest.
fn crossing(a: (i32, i32), b: (i32, i32), at: i32) -> i32 {
    // From the lower end, so that both directions of a line are cut alike.
    let (a, b) = if a.0 <= b.0 { (a, b) } else { (b, a) };
    let run = u64::from(a.0.abs_diff(b.0));
    if run == 0 {
        return a.1;
    }
    // Both factors are below 2³², so the product fits; half of `run` is added without a carry.
    let product = u64::from(a.0.abs_diff(at)) * u64::from(a.1.abs_diff(b.1));
    let (quotient, remainder) = (product / run, product % run);
    let steps = crate::num::saturate_u32(quotient + u64::from(remainder >= run - remainder));
    if a.1 <= b.1 { a.1.saturating_add_unsigned(steps) } else { a.1.saturating_sub_unsigned(steps) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn coordinate() -> impl Strategy<Value = i32> {
        prop_oneof![-20..20_i32, -2000..2000_i32, any::<i32>(), Just(i32::MIN), Just(i32::MAX)]
    }

    /// The true line's other coordinate at `at`, as a fraction over a positive denominator.
    fn exact(a: (i32, i32), b: (i32, i32), at: i32) -> (i128, i128) {
        let [a0, a1, b0, b1, at] = [a.0, a.1, b.0, b.1, at].map(i128::from);
        let (numerator, denominator) = (a1 * (b0 - a0) + (at - a0) * (b1 - a1), b0 - a0);
        if denominator < 0 { (-numerator, -denominator) } else { (numerator, denominator) }
    }

    /// Whether a whole point lies within half a pixel of the line, measured along an axis.
    fn is_near(p: Point, (a, b): (Point, Point)) -> bool {
        let close = |a, b, (at, value): (i32, i32)| {
            let (n, d) = exact(a, b, at);
            d != 0 && (n - i128::from(value) * d).abs() * 2 <= d
        };
        p == a || p == b || close((a.x, a.y), (b.x, b.y), (p.x, p.y)) || close((a.y, a.x), (b.y, b.x), (p.y, p.x))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(10_000))]
        #[test]
        fn ends_are_inside_and_on_the_line(
            ax in coordinate(), ay in coordinate(), bx in coordinate(), by in coordinate(),
            left in coordinate(), top in coordinate(), width in 1..500_i32, height in 1..500_i32,
        ) {
            let (left, top) = (left.min(i32::MAX - width), top.min(i32::MAX - height));
            let window = Rect::new(left, top, left + width, top + height);
            let line = (Point::new(ax, ay), Point::new(bx, by));
            match clip(line, window) {
                Some((near, far)) => {
                    for p in [near, far] {
                        prop_assert!(Outcode::of(p, window).is_inside());
                        prop_assert!(is_near(p, line), "{p:?}");
                    }
                    prop_assert_eq!(clip((line.1, line.0), window), Some((far, near)), "same both ways");
                }
                // Rejected: then no point of the true line lies well inside.
                None => for x in window.left..window.right {
                    if ax == bx || (x < ax.min(bx)) || (x > ax.max(bx)) { continue }
                    let (n, d) = exact((ax, ay), (bx, by), x);
                    let (top, last) = (i128::from(window.top) * d, i128::from(window.bottom - 1) * d);
                    prop_assert!(n * 2 <= top * 2 + d || n * 2 >= last * 2 - d, "column {} is inside", x);
                },
            }
        }
    }

    #[test]
    fn the_cases_of_the_lecture() {
        let window = Rect::new(10, 10, 20, 20);
        let line = |a, b, c, d| clip((Point::new(a, b), Point::new(c, d)), window);
        assert_eq!(line(12, 12, 18, 15), Some((Point::new(12, 12), Point::new(18, 15))), "inside");
        assert_eq!(line(0, 0, 30, 5), None, "both above");
        assert_eq!(line(0, 15, 15, 15), Some((Point::new(10, 15), Point::new(15, 15))), "one end in");
        assert_eq!(line(0, 12, 40, 16), Some((Point::new(10, 13), Point::new(19, 14))), "through");
        assert_eq!(line(0, 18, 12, 30), None, "both outside, passes the corner");
        assert_eq!(clip((Point::zero(), Point::zero()), Rect::new(5, 5, 5, 5)), None, "empty window");
    }
}
