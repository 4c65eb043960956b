//! Paths: contours of straight edges, Bézier curves and arcs, as a list that may lie in flash.
//!
//! - **Takes** segments, borrowed and checked.
//! - **Gives** an [`Outline`] of straight edges, at most one sixteenth of a pixel off: see
//!   [`curve`](crate::curve), and [`Arc`] for arcs; or sixteen times as large, at most one 256th off.
//! - **Memory** none: curves are cut anew each time that the path is traced.

use crate::{
    arc::Arc,
    curve::Flatten,
    edge::LIMIT,
    error::OutOfRange,
    outline::{Outline, Pen, fine, trace_enlarged},
    space::Point2,
};

/// One step of a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Segment {
    /// Begins a contour.
    MoveTo(Point2),
    /// A straight edge.
    LineTo(Point2),
    /// A quadratic Bézier curve: control point, end.
    QuadTo(Point2, Point2),
    /// A cubic Bézier curve: two control points, end.
    CubicTo(Point2, Point2, Point2),
    /// A straight edge to where the arc begins, and the arc. As the first segment of a path, only the arc.
    Arc(Arc),
    /// A straight edge back to where the contour began.
    Close,
}

impl Segment {
    const fn is_in_range(&self) -> bool {
        match self {
            Self::MoveTo(point) | Self::LineTo(point) => point.within(LIMIT),
            Self::QuadTo(one, other) => one.within(LIMIT) && other.within(LIMIT),
            Self::CubicTo(one, other, to) => one.within(LIMIT) && other.within(LIMIT) && to.within(LIMIT),
            Self::Arc(_) | Self::Close => true,
        }
    }

    /// The same sixteen times as large, if that is in range.
    fn enlarged(&self) -> Option<Self> {
        Some(match *self {
            Self::MoveTo(point) => Self::MoveTo(fine(point)?),
            Self::LineTo(to) => Self::LineTo(fine(to)?),
            Self::QuadTo(control, to) => Self::QuadTo(fine(control)?, fine(to)?),
            Self::CubicTo(one, other, to) => Self::CubicTo(fine(one)?, fine(other)?, fine(to)?),
            Self::Arc(arc) => Self::Arc(arc.enlarged()?),
            Self::Close => Self::Close,
        })
    }

    fn draw<P: Pen>(&self, pen: &mut Flatten<P>) {
        match *self {
            Self::MoveTo(point) => pen.move_to(point),
            Self::LineTo(to) => pen.line_to(to),
            Self::QuadTo(control, to) => pen.quad_to(control, to),
            Self::CubicTo(one, other, to) => pen.cubic_to(one, other, to),
            Self::Arc(ref arc) => pen.arc(arc),
            Self::Close => pen.close(),
        }
    }
}

/// Contours of lines and curves.
///
/// A segment before any [`MoveTo`](Segment::MoveTo) begins at the origin, a segment behind a
/// [`Close`](Segment::Close) where the closed contour began. Contours without a segment are nothing. Filling
/// closes what is open.
///
/// ```
/// use aquatint::{FillStyle, Path, Point2, Segment};
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
///
/// // Checked while compiling, kept in flash.
/// static LEAF: Path = match Path::new(&[
///     Segment::MoveTo(Point2::corner(0, 2)),
///     Segment::QuadTo(Point2::corner(6, -2), Point2::corner(12, 2)),
///     Segment::QuadTo(Point2::corner(6, 6), Point2::corner(0, 2)),
/// ]) {
///     Ok(path) => path,
///     Err(_) => panic!("out of range"),
/// };
///
/// let mut display = MockDisplay::new();
/// LEAF.into_styled(FillStyle::new(BinaryColor::On)).draw(&mut display)?;
/// display.assert_pattern(&[
///     "   ######   ",
///     " ########## ",
///     " ########## ",
///     "   ######   ",
/// ]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Path<'a> {
    segments: &'a [Segment],
}

impl<'a> Path<'a> {
    /// Borrows and checks segments.
    ///
    /// # Errors
    /// [`OutOfRange`] when a point or a control point is 4,194,304 pixels or more from the origin.
    pub const fn new(segments: &'a [Segment]) -> Result<Self, OutOfRange> {
        let mut unchecked = segments;
        while let [segment, rest @ ..] = unchecked {
            if !segment.is_in_range() {
                return Err(OutOfRange);
            }
            unchecked = rest;
        }
        Ok(Self { segments })
    }
}

impl Outline for Path<'_> {
    fn trace<P: Pen>(&self, pen: &mut P) {
        let mut pen = Flatten::new(pen);
        self.segments.iter().for_each(|segment| segment.draw(&mut pen));
    }

    /// Curves are cut for 256ths of a pixel where all points are less than 262,144 pixels from the origin.
    fn trace_fine<P: Pen>(&self, pen: &mut P) {
        let large = || self.segments.iter().map(Segment::enlarged);
        if large().all(|segment| segment.is_some()) {
            let mut pen = Flatten::new(pen);
            large().flatten().for_each(|segment| segment.draw(&mut pen));
        } else {
            trace_enlarged(self, pen);
        }
    }
}
