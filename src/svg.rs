//! SVG path data as an outline: icons from a drawing program, kept as text in flash.
//!
//! ```text
//!   "M12 21 C…Z" ──▶ commands ──▶ × map ──▶ curves cut for that size ──▶ edges
//!                    user units,   to sixteenths or 256ths of a pixel
//!                    16.16
//! ```
//!
//! - **Takes** the text of a `d` attribute: all commands of W3C, *Scalable Vector Graphics 2*, section 9.3, with all of their
//!   abbreviations. One unit is one pixel, unless it is mapped.
//! - **Gives** an [`Outline`]. Numbers are right to 2⁻¹⁷ units and rounded once more, to sixteenths of a pixel, when they
//!   have been mapped. So an icon of 24 units is as smooth at 96 pixels as one that was made for that: at most one
//!   sixteenth off, as [`curve`](crate::curve) says. Arcs become cubic curves, at most 0.03 % of their radius off.
//! - **Memory** none; the text is read anew each time that it is traced.
//! - **Cost** reading every byte, one division of 64 bits for a number with a fraction; five square
//!   roots and twelve divisions for an arc. A path that is drawn many times a second is better kept as [`Path`](crate::Path).

use embedded_graphics::{geometry::Point, transform::Transform};

use crate::{
    affine::Affine,
    curve::Flatten,
    edge::LIMIT,
    num::Scalar,
    outline::{FINE, Outline, Pen, trace_enlarged},
    space::Point2,
    svg_data::{Command, Commands},
    svg_number::ok,
};

pub use crate::svg_number::{SvgError, SvgProblem};

/// Path data as SVG has them, and where they go.
///
/// A control point that is more than 4,194,304 pixels from the origin after it is mapped is moved to there, and so are
/// arcs that leave the range of ±32,768 units to its border.
///
/// ```
/// use aquatint::{FillStyle, Scalar, SvgPath};
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
///
/// // Checked while compiling, kept in flash.
/// const HEART: SvgPath = match SvgPath::new("M12 21C5 15 2 12 2 8a5 5 0 0 1 10-2 5 5 0 0 1 10 2c0 4-3 7-10 13z") {
///     Ok(path) => path,
///     Err(_) => panic!("no path"),
/// };
///
/// let mut display = MockDisplay::new();
/// // 24 units, on 12 pixels.
/// HEART.scaled(Scalar::from_num(0.5)).into_styled(FillStyle::new(BinaryColor::On)).draw(&mut display)?;
/// display.assert_pattern(&[
///     "            ",
///     "  ###  ###  ",
///     " ########## ",
///     " ########## ",
///     " ########## ",
///     " ########## ",
///     "  ########  ",
///     "   ######   ",
///     "    ####    ",
///     "     ##     ",
/// ]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SvgPath<'a> {
    data: &'a str,
    map: Affine,
}

impl<'a> SvgPath<'a> {
    /// Borrows and checks path data. Text without a command is a path without a contour.
    ///
    /// # Errors
    /// [`SvgError`] with the place of what is wrong first.
    pub const fn new(data: &'a str) -> Result<Self, SvgError> {
        let mut commands = Commands::of(data);
        while ok!(commands.next()).is_some() {}
        Ok(Self { data, map: Affine::IDENTITY })
    }

    /// The same path, which goes to where another map says, from its units to pixels.
    #[must_use]
    pub const fn with_map(self, map: Affine) -> Self {
        Self { map, ..self }
    }

    /// The same so many times as large as it is mapped so far, about the corner of the screen.
    #[must_use]
    pub fn scaled(self, by: Scalar) -> Self {
        Self { map: self.map.then(Affine::scale(by, by)), ..self }
    }

    /// Gives what is drawn on a screen so many times, 1 or 16, as large.
    fn each_step(&self, times: i32, mut take: impl FnMut(Step)) {
        let place = |units| self.map.apply_units(times, units);
        let mut commands = Commands::of(self.data);
        // It was checked: no error is to come.
        while let Ok(Some(command)) = commands.next() {
            match command {
                Command::Move(to) => take(Step::Move(place(to))),
                Command::Line(to) => take(Step::Line(place(to))),
                Command::Quad(points) => take(Step::Quad(points.map(place))),
                Command::Cubic(points) => take(Step::Cubic(points.map(place))),
                Command::Arc(arc) if arc.is_straight() => take(Step::Line(place(arc.to))),
                Command::Arc(arc) => arc.cubics(|points| take(Step::Cubic(points.map(place)))),
                Command::Close => take(Step::Close),
            }
        }
    }
}

/// A command on the screen.
enum Step {
    Move(Point2),
    Line(Point2),
    Quad([Point2; 2]),
    Cubic([Point2; 3]),
    Close,
}

impl Step {
    fn is_in_range(&self) -> bool {
        let points: &[Point2] = match self {
            Self::Move(point) | Self::Line(point) => core::slice::from_ref(point),
            Self::Quad(points) => points,
            Self::Cubic(points) => points,
            Self::Close => &[],
        };
        points.iter().all(|point| point.within(LIMIT))
    }

    fn draw<P: Pen>(self, pen: &mut Flatten<P>) {
        match self {
            Self::Move(point) => pen.move_to(point),
            Self::Line(to) => pen.line_to(to),
            Self::Quad([control, to]) => pen.quad_to(control, to),
            Self::Cubic([one, other, to]) => pen.cubic_to(one, other, to),
            Self::Close => pen.close(),
        }
    }
}

impl Outline for SvgPath<'_> {
    fn trace<P: Pen>(&self, pen: &mut P) {
        let mut pen = Flatten::new(pen);
        self.each_step(1, |step| step.draw(&mut pen));
    }

    /// Curves are cut for 256ths of a pixel where all control points are less than 262,144 pixels from the origin. To know
    /// that, the text is read twice.
    fn trace_fine<P: Pen>(&self, pen: &mut P) {
        let mut is_in_range = true;
        self.each_step(FINE, |step| is_in_range &= step.is_in_range());
        if is_in_range {
            let mut pen = Flatten::new(pen);
            self.each_step(FINE, |step| step.draw(&mut pen));
        } else {
            trace_enlarged(self, pen);
        }
    }
}

impl Transform for SvgPath<'_> {
    /// The same path so many pixels to the right and down.
    fn translate(&self, by: Point) -> Self {
        self.with_map(self.map.then(Affine::translation(Point2::corner(by.x, by.y))))
    }

    fn translate_mut(&mut self, by: Point) -> &mut Self {
        *self = self.translate(by);
        self
    }
}
