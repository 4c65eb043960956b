//! The exact area: rows are cut wherever an edge begins, ends or crosses another, and trapezoids are integrated.

use aquatint::{Outline, Pen, Point2, Rect, Rule};

/// An edge in pixels, from above.
#[derive(Clone, Copy)]
struct Edge {
    top: (f64, f64),
    bottom: (f64, f64),
    winding: i32,
}

impl Edge {
    fn at(&self, y: f64) -> f64 {
        let along = (y - self.top.1) / (self.bottom.1 - self.top.1);
        self.top.0 + (self.bottom.0 - self.top.0) * along
    }
}

#[derive(Default)]
struct Edges {
    all: Vec<Edge>,
    first: Option<(f64, f64)>,
    last: (f64, f64),
}

impl Edges {
    fn to(&mut self, to: (f64, f64)) {
        let from = self.last;
        self.last = to;
        if from.1 < to.1 {
            self.all.push(Edge { top: from, bottom: to, winding: 1 });
        } else if from.1 > to.1 {
            self.all.push(Edge { top: to, bottom: from, winding: -1 });
        }
    }
}

fn in_pixels(point: Point2) -> (f64, f64) {
    (f64::from(point.x.to_bits()) / 256.0, f64::from(point.y.to_bits()) / 256.0)
}

impl Pen for Edges {
    fn move_to(&mut self, point: Point2) {
        self.close();
        self.first = Some(in_pixels(point));
        self.last = in_pixels(point);
    }

    fn line_to(&mut self, point: Point2) {
        self.to(in_pixels(point));
    }

    fn close(&mut self) {
        if let Some(first) = self.first {
            self.to(first);
        }
    }
}

/// The covered part of each pixel of a window, row by row, by the fine trace of an outline.
pub fn coverage(outline: &impl Outline, rule: Rule, window: Rect) -> Vec<f64> {
    let mut edges = Edges::default();
    outline.trace_fine(&mut edges);
    edges.close();
    let edges = edges.all;
    window.rows().flat_map(|row| row_coverage(&edges, rule, (row, window))).collect()
}

fn row_coverage(edges: &[Edge], rule: Rule, (row, window): (i32, Rect)) -> Vec<f64> {
    let (top, bottom) = (f64::from(row), f64::from(row + 1));
    let edges: Vec<Edge> = edges.iter().copied().filter(|edge| edge.top.1 < bottom && edge.bottom.1 > top).collect();
    let mut cuts = vec![top, bottom];
    for (index, edge) in edges.iter().enumerate() {
        cuts.extend([edge.top.1, edge.bottom.1]);
        cuts.extend(edges[..index].iter().filter_map(|other| crossing(edge, other)));
    }
    cuts.retain(|y| (top..=bottom).contains(y));
    cuts.sort_by(f64::total_cmp);
    let mut covered = vec![0.0; window.columns().len()];
    for band in cuts.windows(2).filter(|band| band[1] > band[0]) {
        add_band(&edges, rule, (band[0], band[1]), (window, &mut covered));
    }
    covered
}

/// The height at which the lines through two edges cross.
fn crossing(one: &Edge, other: &Edge) -> Option<f64> {
    let slope = |edge: &Edge| (edge.bottom.0 - edge.top.0) / (edge.bottom.1 - edge.top.1);
    let relative = slope(one) - slope(other);
    let y = one.top.1 + (other.at(one.top.1) - one.top.0) / relative;
    (relative != 0.0 && y.is_finite()).then_some(y)
}

fn add_band(edges: &[Edge], rule: Rule, (top, bottom): (f64, f64), (window, covered): (Rect, &mut [f64])) {
    let middle = f64::midpoint(top, bottom);
    let mut crossed: Vec<&Edge> = edges.iter().filter(|edge| edge.top.1 <= middle && edge.bottom.1 > middle).collect();
    crossed.sort_by(|a, b| a.at(middle).total_cmp(&b.at(middle)));
    let mut winding = 0;
    for edge in crossed {
        let was = is_inside(winding, rule);
        winding += edge.winding;
        let sign = f64::from(i32::from(is_inside(winding, rule)) - i32::from(was));
        if sign != 0.0 {
            for (column, covered) in window.columns().zip(&mut *covered) {
                let right_of = |x: f64| f64::from(column + 1) - x;
                let (from, to) = (right_of(edge.at(top)), right_of(edge.at(bottom)));
                *covered += sign * (bottom - top) * mean_clamped(from, to);
            }
        }
    }
}

fn is_inside(winding: i32, rule: Rule) -> bool {
    match rule {
        Rule::NonZero => winding != 0,
        Rule::EvenOdd => winding % 2 != 0,
    }
}

/// The mean of a value that runs evenly from one number to another, after it is clamped to 0 … 1.
fn mean_clamped(from: f64, to: f64) -> f64 {
    // The integral of clamp(v, 0, 1).
    let integral = |v: f64| {
        if v <= 0.0 {
            0.0
        } else if v <= 1.0 {
            v * v / 2.0
        } else {
            v - 0.5
        }
    };
    if (to - from).abs() < 1e-9 { from.clamp(0.0, 1.0) } else { (integral(to) - integral(from)) / (to - from) }
}

/// Lines in a row of [`by_lines`].
const LINES: i32 = 2048;

/// The covered part of each pixel of a window inside of contours of many short edges: the lengths of many lines.
pub fn by_lines(contours: &[Vec<(f64, f64)>], rule: Rule, window: Rect) -> Vec<f64> {
    let mut edges = Edges::default();
    for contour in contours {
        for (from, to) in contour.iter().zip(contour.iter().cycle().skip(1)) {
            edges.last = *from;
            edges.to(*to);
        }
    }
    let edges = edges.all;
    window.rows().flat_map(|row| row_by_lines(&edges, rule, (row, window))).collect()
}

fn row_by_lines(edges: &[Edge], rule: Rule, (row, window): (i32, Rect)) -> Vec<f64> {
    let (top, bottom) = (f64::from(row), f64::from(row + 1));
    let edges: Vec<Edge> = edges.iter().copied().filter(|edge| edge.top.1 < bottom && edge.bottom.1 > top).collect();
    let mut covered = vec![0.0; window.columns().len()];
    for line in 0..LINES {
        let y = top + (f64::from(line) + 0.5) / f64::from(LINES);
        let crossed = edges.iter().filter(|edge| edge.top.1 <= y && edge.bottom.1 > y);
        let mut crossings: Vec<_> = crossed.map(|edge| (edge.at(y), edge.winding)).collect();
        crossings.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut winding = 0;
        for pair in crossings.windows(2) {
            winding += pair[0].1;
            if is_inside(winding, rule) {
                for (column, covered) in window.columns().zip(&mut covered) {
                    let part = |x: f64| (x - f64::from(column)).clamp(0.0, 1.0);
                    *covered += (part(pair[1].0) - part(pair[0].0)) / f64::from(LINES);
                }
            }
        }
    }
    covered
}
