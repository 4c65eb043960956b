//! How a shape is drawn as a `Drawable`: used as embedded-graphics' own `PrimitiveStyle` is used.

use crate::{
    coverage::CoverageCurve,
    num::{SUBPIXELS, Subpixel, format_fixed, saturate_u16},
};

/// Which points are inside a polygon that crosses itself or has several contours.
///
/// Lecture 4.2.1. Send a ray from the point to infinity and look at the edges that it crosses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Rule {
    /// Inside when the crossings, counted +1 downwards and −1 upwards, do not cancel out: where
    /// the contour winds around the point. A pentagram is filled all over.
    #[default]
    NonZero,
    /// Inside when the number of crossings is odd. A pentagram has a hole in the middle.
    EvenOdd,
}

impl Rule {
    /// The bits of a winding number that decide: all, or the lowest.
    pub(crate) const fn mask(self) -> i32 {
        match self {
            Self::NonZero => -1,
            Self::EvenOdd => 1,
        }
    }
}

/// Fills a shape with one colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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

/// How two edges of a stroke meet.
///
/// ```text
///   miter      round     bevel
///   ────┐      ────╮     ────╲
///   ──┐ │      ──┐ │     ──┐ │
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Join {
    /// The borders are prolonged until they meet, where the tip is no farther from the corner than
    /// `limit` times half the width; a bevel else. A limit of 4, as of SVG, miters corners of 29° and more.
    Miter {
        /// At 0 and 1 no corner is mitered. Above 64 the tips of strokes wider than 256 pixels are no longer exact.
        limit: u8,
    },
    /// The borders are joined by an arc about the corner.
    Round,
    /// The outer corners are joined by a straight edge.
    Bevel,
}

/// How a stroke that is not closed ends.
///
/// ```text
///   butt       round      square
///   ───┐       ────╮      ─────┐
///   ──●│       ──● │      ──●  │      ● the end of the line
///   ───┘       ────╯      ─────┘
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Cap {
    /// At the end.
    #[default]
    Butt,
    /// By half a disc about the end.
    Round,
    /// Half the width behind the end.
    Square,
}

/// The shape of a stroke: how wide it is, and what its corners and ends look like.
///
/// ```
/// use aquatint::{Cap, Join, Stroke, Subpixel};
///
/// let marker = Stroke::new(6).with_join(Join::Round).with_cap(Cap::Round);
/// let hairline = Stroke::of_width(Subpixel::from_num(0.75));
/// assert_eq!((marker.width.to_bits(), hairline.width.to_bits()), (96, 12));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stroke {
    /// Across, in sixteenths of a pixel. Draws nothing unless positive, and no wider than [`WIDEST`](Self::WIDEST).
    pub width: Subpixel,
    /// At corners.
    pub join: Join,
    /// At the ends of contours that are not closed.
    pub cap: Cap,
}

format_fixed! {
    impl[] |it: Stroke| "Stroke {{ width: {}, join: {}, cap: {} }}", Fixed(it.width), it.join, it.cap
}

impl Stroke {
    /// 4095 pixels and 15 sixteenths. A stroke that is wider is drawn this wide.
    pub const WIDEST: Subpixel = Subpixel::from_bits(0xFFFF);

    /// A stroke this many pixels wide, with mitered corners (limit 4) and butt ends.
    #[must_use]
    pub const fn new(pixels: u16) -> Self {
        Self::of_width(Subpixel::from_bits((pixels as i32) << Subpixel::FRAC_NBITS))
    }

    /// The same with a width in sixteenths of a pixel. A width that is not positive draws nothing.
    #[must_use]
    pub const fn of_width(width: Subpixel) -> Self {
        Self { width, join: Join::Miter { limit: 4 }, cap: Cap::Butt }
    }

    /// The same with other corners.
    #[must_use]
    pub const fn with_join(self, join: Join) -> Self {
        Self { join, ..self }
    }

    /// The same with other ends.
    #[must_use]
    pub const fn with_cap(self, cap: Cap) -> Self {
        Self { cap, ..self }
    }

    /// The width that is drawn, in sixteenths of a pixel; zero draws nothing.
    pub(crate) const fn sixteenths(self) -> u16 {
        saturate_u16(self.width.to_bits() as i64)
    }
}

/// Draws along a line or a contour with one colour.
///
/// A [`Line`](crate::Line) one pixel wide is Bresenham's, of whole pixels and without caps; everything else is an area.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct StrokeStyle<C> {
    /// The colour.
    pub color: C,
    /// The shape of the stroke.
    pub stroke: Stroke,
}

impl<C> StrokeStyle<C> {
    /// One colour, one pixel wide.
    pub const fn new(color: C) -> Self {
        Self { color, stroke: Stroke::new(1) }
    }

    /// The same, this many pixels wide.
    #[must_use]
    pub fn with_width(self, pixels: u16) -> Self {
        let stroke = Stroke { width: Stroke::new(pixels).width, ..self.stroke };
        self.with_stroke(stroke)
    }

    /// The same with a stroke of another shape.
    #[must_use]
    pub fn with_stroke(self, stroke: Stroke) -> Self {
        Self { stroke, ..self }
    }
}

/// Draws a shape antialiased: used as embedded-graphics' own `PrimitiveStyle` is, for its primitives too.
///
/// What is drawn are [`Alpha`](crate::Alpha) colours, for a [`Blended`](crate::Blended) target.
///
/// ```
/// use aquatint::{AntialiasedStyle, Blended, Frame, Rows};
/// use embedded_graphics::{pixelcolor::Gray2, prelude::*, primitives::Triangle};
///
/// let mut frame = Frame::<Gray2, Rows, _>::with_array([0; 32], 16, 8).unwrap();
/// let style = AntialiasedStyle::fill(Gray2::new(1)).with_stroke(Gray2::WHITE, 1);
/// let triangle = Triangle::new(Point::new(1, 1), Point::new(14, 2), Point::new(6, 7));
/// triangle.into_styled(style).draw(&mut Blended::new(&mut frame))?;
/// // From the first corner to the right, the border goes over into the row below.
/// assert_eq!(frame.bytes()[4..8], [0x7F, 0xEA, 0xA9, 0x50]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AntialiasedStyle<C> {
    /// What the inside is filled with, if it is.
    pub fill_color: Option<C>,
    /// What is inside.
    pub rule: Rule,
    /// What the border is drawn with, if it is, over the inside.
    pub stroke_color: Option<C>,
    /// The shape of the border.
    pub stroke: Stroke,
    /// What is made of partly covered pixels.
    pub curve: CoverageCurve,
}

impl<C> AntialiasedStyle<C> {
    /// Nothing is drawn yet.
    const NOTHING: Self = Self {
        fill_color: None,
        rule: Rule::NonZero,
        stroke_color: None,
        stroke: Stroke::new(1),
        curve: CoverageCurve::LINEAR,
    };

    /// The inside, in one colour.
    pub const fn fill(color: C) -> Self
    where
        C: Copy,
    {
        Self { fill_color: Some(color), ..Self::NOTHING }
    }

    /// The border, in one colour and so many pixels wide.
    pub const fn stroke(color: C, pixels: u16) -> Self
    where
        C: Copy,
    {
        Self { stroke_color: Some(color), stroke: Stroke::new(pixels), ..Self::NOTHING }
    }

    /// The same with the inside in this colour.
    #[must_use]
    pub fn with_fill(self, color: C) -> Self {
        Self { fill_color: Some(color), ..self }
    }

    /// The same with a border in this colour and so many pixels wide.
    #[must_use]
    pub fn with_stroke(self, color: C, pixels: u16) -> Self {
        let stroke = Stroke { width: Stroke::new(pixels).width, ..self.stroke };
        Self { stroke_color: Some(color), ..self }.with_shape(stroke)
    }

    /// The same with a border of another shape, such as a hairline.
    #[must_use]
    pub fn with_shape(self, stroke: Stroke) -> Self {
        Self { stroke, ..self }
    }

    /// The same inside by another rule.
    #[must_use]
    pub fn with_rule(self, rule: Rule) -> Self {
        Self { rule, ..self }
    }

    /// The same with partly covered pixels bolder or thinner.
    #[must_use]
    pub fn with_curve(self, curve: CoverageCurve) -> Self {
        Self { curve, ..self }
    }

    /// How far inside of the border of a shape of whole pixels the middle of its stroke is: as embedded-graphics puts
    /// it, an odd width has the greater half inside, so that its sides fall between pixels.
    pub(crate) const fn inset(&self) -> i32 {
        if self.stroke.width.to_bits() % (2 * SUBPIXELS) == SUBPIXELS { SUBPIXELS / 2 } else { 0 }
    }
}
