//! Outlines traced for antialiasing: sixteen times as large, and as exact as that asks for.

mod range;
mod shapes;
mod strokes;

use aquatint::{Outline, Pen, Point2};
use proptest::{prelude::*, sample::select};

/// A pen that keeps its contours.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Recorder {
    contours: Vec<Vec<(i32, i32)>>,
    closed: usize,
}

impl Pen for Recorder {
    fn move_to(&mut self, point: Point2) {
        self.contours.push(vec![(point.x.to_bits(), point.y.to_bits())]);
    }

    fn line_to(&mut self, point: Point2) {
        self.contours.last_mut().expect("a contour").push((point.x.to_bits(), point.y.to_bits()));
    }

    fn close(&mut self) {
        self.closed += 1;
    }
}

fn coarse(outline: &impl Outline) -> Recorder {
    let mut pen = Recorder::default();
    outline.trace(&mut pen);
    pen
}

fn fine(outline: &impl Outline) -> Recorder {
    let mut pen = Recorder::default();
    outline.trace_fine(&mut pen);
    pen
}

/// The contours of an outline that is traced as ever, enlarged.
fn enlarged(outline: &impl Outline) -> Recorder {
    let mut pen = coarse(outline);
    let end = (1 << 26) - 1;
    for (x, y) in pen.contours.iter_mut().flatten() {
        (*x, *y) = (16 * (*x).clamp(-end, end), 16 * (*y).clamp(-end, end));
    }
    pen
}

type Place = [f64; 2];

/// In the unit of the fine pen, 256ths of a pixel, from sixteenths.
fn large(point: Point2) -> Place {
    [point.x, point.y].map(|v| 16.0 * f64::from(v.to_bits()))
}

fn place((x, y): (i32, i32)) -> Place {
    [x.into(), y.into()]
}

fn apart(a: Place, b: Place) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// How far a point is from a straight edge.
fn from_edge([x, y]: Place, [a, b]: [Place; 2]) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let square = dx * dx + dy * dy;
    let along = if square == 0.0 { 0.0 } else { (((x - a[0]) * dx + (y - a[1]) * dy) / square).clamp(0.0, 1.0) };
    apart([a[0] + along * dx, a[1] + along * dy], [x, y])
}

/// How far a point is from the nearest edge of a contour.
fn from_contour(point: Place, contour: &[(i32, i32)]) -> f64 {
    let edges = contour.iter().zip(contour.iter().cycle().skip(1));
    edges.map(|(&a, &b)| from_edge(point, [a, b].map(place))).fold(f64::INFINITY, f64::min)
}

fn point(end: i32) -> impl Strategy<Value = Point2> {
    (-end..=end, -end..=end).prop_map(|(x, y)| Point2::from_sixteenths(x, y))
}

/// Any number, and the ends of all ranges.
fn hostile() -> impl Strategy<Value = i32> {
    const LIMIT: i32 = 1 << 26;
    let ends = vec![i32::MIN, i32::MAX, LIMIT - 1, 1 - LIMIT, LIMIT, LIMIT / 16, LIMIT / 16 - 1, 1 - LIMIT / 16, 0, 1];
    prop_oneof![-300..300_i32, any::<i32>(), select(ends), -LIMIT / 16..LIMIT / 16]
}

fn hostile_point() -> impl Strategy<Value = Point2> {
    (hostile(), hostile()).prop_map(|(x, y)| Point2::from_sixteenths(x, y))
}

/// The nearest point that shapes may be made of.
fn in_range(point: Point2) -> Point2 {
    let end = (1 << 26) - 1;
    Point2::from_sixteenths(point.x.to_bits().clamp(-end, end), point.y.to_bits().clamp(-end, end))
}
