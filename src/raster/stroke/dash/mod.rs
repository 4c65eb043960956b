//! Dashes: an outline cut into pieces of given lengths, which are contours of their own.
//!
//! ```text
//!   lengths 4, 2     ━━━━  ━━━━  ━━━━  ━━     along the contour, and around its corners
//!   offset 3         ━  ━━━━  ━━━━  ━━━━
//! ```
//!
//! - **Takes** an [`Outline`], lengths (dash, gap, dash, gap …) and where in the pattern a contour begins.
//! - **Gives** an outline of open contours, to be [stroked](super) or drawn by a pen of your own.
//! - **Memory** the lengths are borrowed; some 100 bytes for the state.
//! - **Cost** one integer square root and one division a segment, four multiplications a dash.
//!
//! **No drift.** Along a contour lengths are summed in 2⁻²⁰ pixels. That of a segment is at most 2⁻²⁰ pixels too short, and
//! 2⁻³⁰ of itself: after a thousand segments a dash is less than a hundredth of a sixteenth from its place. Only
//! where it begins and ends is rounded, to the nearest sixteenth.
//!
//! **Bounded work.** What is farther from the [window](Dashed::within) than its size is skipped by one division. A
//! segment that shows more than [`MOST_REPEATS`] of the pattern is drawn without gaps, and so is everything when
//! the pattern is shorter than a pixel.
//!
//! As in SVG, an odd number of lengths is used twice, a dash of length zero is a dot where the cap is not butt, and a
//! negative length counts as zero. It differs in two things. Square dots lie along the axes. And where a dash runs over
//! the beginning of a closed contour, its two parts are not one but overlap on the first segment: so the corner is
//! joined, but a cap of either part may stand out where the corner is sharp or the first segment shorter than wide.

mod pattern;
mod sight;

use core::ops::Range;

use self::{
    pattern::{Pattern, Phase},
    sight::Sight,
};
use super::direction::{Direction, between};
use crate::{
    edge::LIMIT,
    num::Subpixel,
    outline::{Outline, Pen, is_fine_within, trace_enlarged},
    space::{Point2, Rect},
};

/// How often the pattern is repeated within one segment at most.
pub const MOST_REPEATS: u16 = 1024;

/// An outline cut into dashes: itself an outline, of open contours.
///
/// ```
/// use aquatint::{Point2, Polyline, Stroke, StrokeStyle, Subpixel, raster::stroke::dash::Dashed};
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
///
/// let points = [(0, 1), (9, 1), (9, 6)].map(|(x, y)| Point2::corner(x, y));
/// let polyline = Polyline::new(&points).unwrap();
/// let lengths = [4, 2].map(Subpixel::from_num);
///
/// let mut display = MockDisplay::new();
/// let dashed = Dashed::new(&polyline, &lengths, Subpixel::ZERO);
/// dashed.into_styled(StrokeStyle::new(BinaryColor::On).with_width(2)).draw(&mut display)?;
/// display.assert_pattern(&[
///     "####  ####",
///     "####  ####",
///     "          ",
///     "          ",
///     "        ##",
///     "        ##",
/// ]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Dashed<'a, O> {
    outline: O,
    pattern: Pattern<'a>,
    window: Option<Rect>,
}

impl<'a, O: Outline> Dashed<'a, O> {
    /// Cuts an outline, or a reference to one. Each contour begins `offset` behind the beginning of the first dash.
    ///
    /// With no lengths, or none that is positive, nothing is cut.
    pub fn new(outline: O, lengths: &'a [Subpixel], offset: Subpixel) -> Self {
        Self { outline, pattern: Pattern::new(lengths, offset), window: None }
    }

    /// Leaves out the dashes that are far from a window of pixels; those in it stay where they are.
    ///
    /// For a stroke the window must be larger than what is seen by what the stroke reaches. Drawing on a target sees to
    /// that.
    #[must_use]
    pub fn within(self, window: Rect) -> Self {
        Self { window: Some(window), ..self }
    }

    /// What is cut.
    pub(in crate::raster) const fn outline(&self) -> &O {
        &self.outline
    }

    /// The same, where only a window is seen.
    pub(in crate::raster) fn seen(&self, window: Rect) -> Dashed<'a, &O> {
        let window = self.window.map_or(window, |own| own.intersection(window));
        Dashed { outline: &self.outline, pattern: self.pattern, window: Some(window) }
    }
}

impl<O: Outline> Outline for Dashed<'_, O> {
    fn trace<P: Pen>(&self, pen: &mut P) {
        if self.pattern.is_too_fine() {
            return self.outline.trace(pen);
        }
        let mut dasher = Dasher::new(pen, self.pattern, self.window.map(Sight::of));
        self.outline.trace(&mut dasher);
    }

    /// Dashes begin and end on 256ths of a pixel where the outline is less than 262,144 pixels from the origin. To know
    /// that, it is traced once more. The curves of the outline are traced finely too, which makes them a little longer.
    fn trace_fine<P: Pen>(&self, pen: &mut P) {
        if self.pattern.is_too_fine() {
            return self.outline.trace_fine(pen);
        }
        if !is_fine_within(&self.outline, 0) {
            return trace_enlarged(self, pen);
        }
        let sight = self.window.map(|window| Sight::of(window).enlarged());
        self.outline.trace_fine(&mut Dasher::new(pen, self.pattern.enlarged(), sight));
    }
}

/// The pen that the inner outline draws with.
struct Dasher<'p, 'a, P> {
    pen: &'p mut P,
    pattern: Pattern<'a>,
    sight: Option<Sight>,
    /// Where each contour begins.
    start: Phase,
    phase: Phase,
    begin: Point2,
    last: Point2,
    /// Where the part on the first segment of the dash that the contour begins with is half over.
    first: Option<Point2>,
    /// A dash has been begun.
    is_down: bool,
}

impl<P: Pen> Pen for Dasher<'_, '_, P> {
    fn move_to(&mut self, point: Point2) {
        self.begin = point.clamped(LIMIT);
        (self.last, self.phase, self.first, self.is_down) = (self.begin, self.start, None, false);
    }

    fn line_to(&mut self, point: Point2) {
        let point = point.clamped(LIMIT);
        let Some((direction, length)) = Direction::and_length(between(self.last, point)) else {
            if self.phase.is_dash {
                self.draw(point, point);
            }
            return;
        };
        let segment = Segment { from: self.last, to: point, direction, length };
        if self.first.is_none() {
            self.first = Some(segment.point(self.start.left.min(segment.length) / 2));
        }
        self.segment(&segment);
        self.last = point;
    }

    fn close(&mut self) {
        self.line_to(self.begin);
        if let Some(first) = self.first.filter(|_| self.is_down && self.start.is_dash) {
            self.pen.line_to(first);
        }
        self.is_down = false;
    }
}

impl<'p, 'a, P: Pen> Dasher<'p, 'a, P> {
    fn new(pen: &'p mut P, pattern: Pattern<'a>, sight: Option<Sight>) -> Self {
        let (start, at) = (pattern.start(), Point2::default());
        Self { pen, pattern, sight, start, phase: start, begin: at, last: at, first: None, is_down: false }
    }

    fn segment(&mut self, segment: &Segment) {
        let seen =
            self.sight.map_or(0..segment.length, |sight| sight.part(segment.from, segment.direction, segment.length));
        if self.pattern.repeats(seen.end - seen.start) > i64::from(MOST_REPEATS) {
            self.draw(segment.from, segment.to);
            self.phase = self.pattern.skip(self.phase, segment.length);
            self.is_down &= self.phase.is_dash;
            return;
        }
        if seen.is_empty() {
            return self.skip(segment.length);
        }
        self.skip(seen.start);
        let began = if self.phase.is_dash { self.pattern.behind(self.phase).min(seen.start) } else { 0 };
        self.phase.left += began;
        let end = self.dashes(segment, seen.start - began..seen.end);
        self.skip(segment.length - end);
    }

    /// Goes on unseen.
    fn skip(&mut self, distance: i64) {
        if distance > 0 {
            self.is_down = false;
            self.phase = self.pattern.skip(self.phase, distance);
        }
    }

    /// The dashes that begin in a part of a segment; gives where the last of them ends. None is cut off within the
    /// segment, so that the part changes nothing that is seen.
    fn dashes(&mut self, segment: &Segment, part: Range<i64>) -> i64 {
        let mut at = part.start;
        loop {
            let ahead = segment.length - at;
            if at > part.end || ahead == 0 && self.phase.left > 0 {
                // A dash that would begin where the segment ends begins with the next.
                return at;
            }
            let length = self.phase.left.min(ahead);
            let end = at + length;
            if self.phase.is_dash {
                self.draw(segment.point(at), segment.point(end));
            }
            if self.phase.left > ahead {
                self.phase.left -= ahead;
                return end;
            }
            self.is_down = false;
            (at, self.phase) = (end, self.pattern.next(self.phase));
        }
    }

    fn draw(&mut self, from: Point2, to: Point2) {
        if !self.is_down {
            self.pen.move_to(from);
            self.is_down = true;
        }
        self.pen.line_to(to);
    }
}

/// A segment that is not a point.
struct Segment {
    from: Point2,
    to: Point2,
    direction: Direction,
    length: i64,
}

impl Segment {
    /// The point some distance from the beginning.
    fn point(&self, distance: i64) -> Point2 {
        if distance >= self.length { self.to } else { self.direction.times(distance).from(self.from) }
    }
}
