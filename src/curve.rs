//! Curves as straight edges: Bézier curves, and the pen that draws them.
//!
//! A curve is cut into `n = 2^k` pieces of equal parameter, and `n` is known before the first is drawn: the chord
//! of a piece is at most `M / 4n²` from a quadratic curve and `3M / 4n²` from a cubic one, where `M` is the length
//! of the longest second difference `P₀ − 2P₁ + P₂` of its control points.
//!
//! ```text
//!        P₁                            the curve is at most ¼ of a sixteenth of a pixel from its chords,
//!        ╱╲      ● vertices,           and rounding moves a vertex by 0.71 sixteenths at most:
//!       ●──●       n = 4               0.96 sixteenths in all
//!     ●      ●
//!    P₀       P₂
//! ```
//!
//! Forward differences lead from vertex to vertex, in whole units of `2^−3k` sixteenths: nothing is rounded on the
//! way, so nothing drifts, and the last vertex is the end point.
//!
//! - **Takes** points; those outside of the range of coordinates are moved to its border first.
//! - **Gives** a [`Pen`] vertices.
//! - **Memory** none, whatever the curve.
//! - **Cost** a vertex is six additions of 64 bits; no division. A curve has at most 4,096 pieces. So a quadratic
//!   curve with a second difference of more than 1,048,576 pixels and a cubic one of more than 349,525 may be
//!   farther from their chords than promised, 1.1 pixels at the very most.
//!
//! The bound is that of G. Farin, *Curves and Surfaces for CAGD*, for the chord of a twice differentiable curve:
//! an eighth of the longest second derivative times the square of the piece. T. O. Sederberg, *Computer Aided
//! Geometric Design*, chapter 4, for forward differences.

use crate::{
    arc::Arc,
    num::{Subpixel, low_i32},
    outline::{Pen, in_range},
    space::Point2,
};

/// No curve has more pieces than 2 to this. Then a vertex fits 26 + 3 · 12 bits and a sign.
const MOST_HALVINGS: u32 = 12;

/// Draws a quadratic Bézier curve: start, control point, end. The pen stands at the start already.
pub fn quadratic<P: Pen>(pen: &mut P, points: [Point2; 3]) {
    let [from, control, to] = points.map(in_range);
    let x = Coefficients::of_quadratic([from.x, control.x, to.x]);
    let y = Coefficients::of_quadratic([from.y, control.y, to.y]);
    let bend = length(x.square, y.square);
    // M / 4n² ≤ 1/4
    draw(pen, [x, y], (halvings(bend), to));
}

/// Draws a cubic Bézier curve: start, two control points, end. The pen stands at the start already.
pub fn cubic<P: Pen>(pen: &mut P, points: [Point2; 4]) {
    let [from, one, other, to] = points.map(in_range);
    let x = Coefficients::of_cubic([from.x, one.x, other.x, to.x]);
    let y = Coefficients::of_cubic([from.y, one.y, other.y, to.y]);
    // The second differences at the start, three times, and at the end.
    let bend = length(x.square, y.square).max(length(x.square + 3 * x.cube, y.square + 3 * y.cube));
    // 3M / 4n² ≤ 1/4
    draw(pen, [x, y], (halvings(bend), to));
}

/// The least k with 4ᵏ ≥ `bend`, as far as allowed.
fn halvings(bend: u64) -> u32 {
    let bits = u64::BITS - bend.saturating_sub(1).leading_zeros();
    bits.div_ceil(2).min(MOST_HALVINGS)
}

/// No less than the length of a vector, and at most an eighth more.
fn length(x: i64, y: i64) -> u64 {
    let (x, y) = (x.unsigned_abs(), y.unsigned_abs());
    x.max(y) + x.min(y).div_ceil(2)
}

/// One coordinate as a polynomial of the parameter: `cube·t³ + square·t² + line·t + start`.
#[derive(Clone, Copy)]
struct Coefficients {
    cube: i64,
    square: i64,
    line: i64,
    start: i64,
}

impl Coefficients {
    fn of_quadratic(points: [Subpixel; 3]) -> Self {
        let [from, control, to] = points.map(|v| i64::from(v.to_bits()));
        Self { cube: 0, square: from - 2 * control + to, line: 2 * (control - from), start: from }
    }

    fn of_cubic(points: [Subpixel; 4]) -> Self {
        let [from, one, other, to] = points.map(|v| i64::from(v.to_bits()));
        let square = 3 * (from - 2 * one + other);
        Self { cube: to - from + 3 * (one - other), square, line: 3 * (one - from), start: from }
    }

    /// The differences of 2^k steps, at the start.
    const fn differences(self, k: u32) -> Differences {
        Differences {
            value: self.start << (3 * k),
            first: self.cube + (self.square << k) + (self.line << (2 * k)),
            second: 6 * self.cube + ((2 * self.square) << k),
            third: 6 * self.cube,
        }
    }
}

/// A coordinate and its differences, in units of 2^−3k sixteenths.
struct Differences {
    value: i64,
    first: i64,
    second: i64,
    third: i64,
}

impl Differences {
    /// The coordinate at the next step, in sixteenths.
    fn next(&mut self, k: u32) -> i32 {
        self.value += self.first;
        self.first += self.second;
        self.second += self.third;
        // The curve stays between its control points.
        low_i32((self.value + (1 << (3 * k) >> 1)) >> (3 * k))
    }
}

fn draw<P: Pen>(pen: &mut P, axes: [Coefficients; 2], (k, to): (u32, Point2)) {
    let [mut x, mut y] = axes.map(|axis| axis.differences(k));
    for _ in 1..1_u32 << k {
        pen.line_to(Point2::from_sixteenths(x.next(k), y.next(k)));
    }
    pen.line_to(to);
}

/// Draws curves with a pen for straight edges.
///
/// For outlines whose curves come from elsewhere, such as the glyphs of a font: implement
/// [`Outline`](crate::Outline), and in there draw with this. What is drawn before any [`move_to`](Self::move_to)
/// begins at the origin; what is drawn behind a [`close`](Self::close) begins where the closed contour began. A
/// contour in which nothing is drawn does not reach the pen.
///
/// ```
/// use aquatint::{Flatten, Outline, Pen, Point2};
///
/// /// A drop, its tip at the top.
/// struct Drop;
///
/// impl Outline for Drop {
///     fn trace<P: Pen>(&self, pen: &mut P) {
///         let [tip, right, left] = [(8, 0), (24, 20), (-8, 20)].map(|(x, y)| Point2::corner(x, y));
///         let mut pen = Flatten::new(pen);
///         pen.move_to(tip);
///         pen.cubic_to(right, left, tip);
///         pen.close();
///     }
/// }
/// # assert_eq!(aquatint::pixel_bounds(&Drop), aquatint::Rect::new(3, 0, 13, 15));
/// ```
#[derive(Debug)]
pub struct Flatten<'p, P> {
    pen: &'p mut P,
    /// Where the contour began, and where it has come to; nothing before anything was drawn.
    first: Point2,
    last: Option<Point2>,
    is_open: bool,
}

impl<'p, P: Pen> Flatten<'p, P> {
    /// Draws with this pen, whose contour so far stays as it is.
    pub fn new(pen: &'p mut P) -> Self {
        Self { pen, first: Point2::default(), last: None, is_open: false }
    }

    /// Begins a contour.
    pub const fn move_to(&mut self, point: Point2) {
        (self.first, self.last, self.is_open) = (point, Some(point), false);
    }

    /// A straight edge.
    pub fn line_to(&mut self, to: Point2) {
        self.begin();
        self.pen.line_to(to);
        self.last = Some(to);
    }

    /// A quadratic Bézier curve: [`quadratic`].
    pub fn quad_to(&mut self, control: Point2, to: Point2) {
        let from = self.begin();
        quadratic(self.pen, [from, control, to]);
        self.last = Some(to);
    }

    /// A cubic Bézier curve: [`cubic`].
    pub fn cubic_to(&mut self, one: Point2, other: Point2, to: Point2) {
        let from = self.begin();
        cubic(self.pen, [from, one, other, to]);
        self.last = Some(to);
    }

    /// A straight edge to where an arc begins, and the arc. With nothing drawn before, only the arc.
    pub fn arc(&mut self, arc: &Arc) {
        let from = self.last.unwrap_or_else(|| {
            self.first = arc.start_point();
            self.first
        });
        self.last = Some(from);
        self.begin();
        for vertex in arc.vertices() {
            // The contour may stand there already.
            if self.last != Some(vertex) {
                self.pen.line_to(vertex);
                self.last = Some(vertex);
            }
        }
    }

    /// A straight edge back to where the contour began.
    pub fn close(&mut self) {
        if self.is_open {
            self.pen.close();
            self.is_open = false;
            self.last = Some(self.first);
        }
    }

    /// Begins a contour for the pen, if there is none; says where it has come to.
    fn begin(&mut self) -> Point2 {
        let last = self.last.unwrap_or_default();
        if !self.is_open {
            self.pen.move_to(last);
            self.is_open = true;
        }
        last
    }
}
