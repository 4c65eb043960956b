//! How a shape is drawn as a `Drawable`: used as embedded-graphics' own `PrimitiveStyle` is used.

/// Which points are inside a polygon that crosses itself or has several contours.
///
/// Lecture 4.2.1. Send a ray from the point to infinity and look at the edges that it crosses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rule {
    /// Inside when the crossings, counted +1 downwards and −1 upwards, do not cancel out: where
    /// the contour winds around the point. A pentagram is filled all over.
    #[default]
    NonZero,
    /// Inside when the number of crossings is odd. A pentagram has a hole in the middle.
    EvenOdd,
}

/// Fills a shape with one colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FillStyle<C> {
    /// The colour.
    pub color: C,
    /// What is inside.
    pub rule: Rule,
}

impl<C> FillStyle<C> {
    /// One colour, by the non-zero rule.
    pub const fn new(color: C) -> Self {
        Self { color, rule: Rule::NonZero }
    }

    /// The same colour by another rule.
    #[must_use]
    pub fn with_rule(self, rule: Rule) -> Self {
        Self { rule, ..self }
    }
}

/// Draws a line, one pixel wide.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StrokeStyle<C> {
    /// The colour.
    pub color: C,
}

impl<C> StrokeStyle<C> {
    /// One colour, one pixel wide.
    pub const fn new(color: C) -> Self {
        Self { color }
    }
}
