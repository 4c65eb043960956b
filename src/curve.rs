//! Curves as straight edges: Bézier curves, and the pen that draws them.
//!
//! A curve is cut into [pieces](crate::Curve): it is at most ¼ of a sixteenth of a pixel from their chords, and rounding
//! moves a vertex by 0.71 sixteenths at most: 0.96 sixteenths in all.
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

use crate::{arc::Arc, outline::Pen, pieces::Curve, space::Point2};

/// Draws a quadratic Bézier curve: start, control point, end. The pen stands at the start already.
pub fn quadratic<P: Pen>(pen: &mut P, points: [Point2; 3]) {
    pen.curve_to(&Curve::quadratic(points));
}

/// Draws a cubic Bézier curve: start, two control points, end. The pen stands at the start already.
pub fn cubic<P: Pen>(pen: &mut P, points: [Point2; 4]) {
    pen.curve_to(&Curve::cubic(points));
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
        let curve = arc.curve().distinct();
        // The contour may stand there already.
        if from != arc.start_point() {
            self.pen.line_to(arc.start_point());
        }
        self.pen.curve_to(&curve);
        self.last = Some(curve.vertex_at(curve.len()));
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
