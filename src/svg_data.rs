//! The commands of SVG path data, one after the other, with absolute coordinates.
//!
//! ```text
//!   m 1 1 2 0 h 3 z       M 1 1   L 3 1   L 6 1   Z
//! ```
//!
//! Relative commands, repetitions and reflected control points are worked out here, in user units of 16.16: whole sums,
//! so nothing drifts. Nothing is stored but where the path has come to, some 60 bytes. All of it can run while the
//! program is compiled.

use crate::{
    num::low_i32,
    svg_arc::EndpointArc,
    svg_number::{Place, Scanner, SvgError, SvgProblem, ok},
};

/// A command, in user units.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Command {
    Move(Place),
    Line(Place),
    Quad([Place; 2]),
    Cubic([Place; 3]),
    Arc(EndpointArc),
    Close,
}

/// Reads commands.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Commands<'a> {
    scanner: Scanner<'a>,
    /// What is repeated where numbers follow; nothing at the beginning.
    letter: Option<u8>,
    begin: Place,
    last: Place,
    /// The last control points of a cubic and of a quadratic curve, if one came last; else the same as `last`.
    cubic: Place,
    quad: Place,
}

impl<'a> Commands<'a> {
    pub(crate) const fn of(data: &'a str) -> Self {
        let origin = [0, 0];
        Self { scanner: Scanner::new(data), letter: None, begin: origin, last: origin, cubic: origin, quad: origin }
    }

    /// The next command; `None` at the end.
    pub(crate) const fn next(&mut self) -> Result<Option<Command>, SvgError> {
        let Some(letter) = ok!(self.letter()) else { return Ok(None) };
        let command = match letter.to_ascii_lowercase() {
            b'm' => ok!(self.begin_contour()),
            b'l' => {
                let to = ok!(self.pair());
                self.line_to(to)
            }
            b'h' => ok!(self.horizontal()),
            b'v' => ok!(self.vertical()),
            b'c' | b's' => ok!(self.cubic()),
            b'q' | b't' => ok!(self.quadratic()),
            b'a' => ok!(self.arc()),
            _ => {
                self.go(self.begin);
                Command::Close
            }
        };
        Ok(Some(command))
    }

    /// The letter of the next command, which stands there or is repeated.
    const fn letter(&mut self) -> Result<Option<u8>, SvgError> {
        match self.letter {
            // Nothing is repeated.
            None | Some(b'z' | b'Z') => self.scanner.spaces(),
            Some(letter) => {
                if self.scanner.has_more() {
                    return Ok(Some(letter));
                }
            }
        }
        let Some(letter) = self.scanner.peek() else { return Ok(None) };
        if self.letter.is_none() && !matches!(letter, b'm' | b'M') {
            return Err(self.scanner.error(SvgProblem::MoveExpected));
        }
        let lower = letter.to_ascii_lowercase();
        if !matches!(lower, b'm' | b'l' | b'h' | b'v' | b'c' | b's' | b'q' | b't' | b'a' | b'z') {
            return Err(self.scanner.error(SvgProblem::UnexpectedCharacter));
        }
        self.scanner.skip();
        self.scanner.spaces();
        self.letter = Some(letter);
        Ok(self.letter)
    }

    const fn begin_contour(&mut self) -> Result<Command, SvgError> {
        let to = ok!(self.pair());
        self.go(to);
        self.begin = to;
        // What is repeated are edges.
        self.letter = Some(if self.is_relative() { b'l' } else { b'L' });
        Ok(Command::Move(to))
    }

    const fn line_to(&mut self, to: Place) -> Command {
        self.go(to);
        Command::Line(to)
    }

    const fn horizontal(&mut self) -> Result<Command, SvgError> {
        let [_, y] = self.last;
        let x = ok!(self.along_x());
        Ok(self.line_to([x, y]))
    }

    const fn vertical(&mut self) -> Result<Command, SvgError> {
        let [x, _] = self.last;
        let y = ok!(self.along_y());
        Ok(self.line_to([x, y]))
    }

    const fn cubic(&mut self) -> Result<Command, SvgError> {
        let one = if matches!(self.letter, Some(b's' | b'S')) {
            ok!(self.reflected(self.cubic))
        } else {
            ok!(self.pair_and_separator())
        };
        let (other, to) = (ok!(self.pair_and_separator()), ok!(self.pair()));
        self.go(to);
        self.cubic = other;
        Ok(Command::Cubic([one, other, to]))
    }

    const fn quadratic(&mut self) -> Result<Command, SvgError> {
        let control = if matches!(self.letter, Some(b't' | b'T')) {
            ok!(self.reflected(self.quad))
        } else {
            ok!(self.pair_and_separator())
        };
        let to = ok!(self.pair());
        self.go(to);
        self.quad = control;
        Ok(Command::Quad([control, to]))
    }

    const fn arc(&mut self) -> Result<Command, SvgError> {
        let from = self.last;
        let radii = [ok!(self.number_and_separator()), ok!(self.number_and_separator())];
        let rotation = ok!(self.number_and_separator());
        let (is_large, is_clockwise) = (ok!(self.flag_and_separator()), ok!(self.flag_and_separator()));
        let to = ok!(self.pair());
        self.go(to);
        Ok(Command::Arc(EndpointArc { from, to, radii, rotation, is_large, is_clockwise }))
    }

    /// Sets where the path has come to.
    const fn go(&mut self, to: Place) {
        (self.last, self.cubic, self.quad) = (to, to, to);
    }

    const fn is_relative(&self) -> bool {
        matches!(self.letter, Some(b'a'..=b'z'))
    }

    /// A control point on the other side of where the path has come to.
    const fn reflected(&self, control: Place) -> Result<Place, SvgError> {
        let ([x, y], [from_x, from_y]) = (self.last, control);
        Ok([ok!(sum(&self.scanner, x, x as i64 - from_x as i64)), ok!(sum(&self.scanner, y, y as i64 - from_y as i64))])
    }

    const fn pair(&mut self) -> Result<Place, SvgError> {
        let x = ok!(self.along_x());
        self.scanner.separator();
        Ok([x, ok!(self.along_y())])
    }

    const fn pair_and_separator(&mut self) -> Result<Place, SvgError> {
        let pair = self.pair();
        self.scanner.separator();
        pair
    }

    const fn number_and_separator(&mut self) -> Result<i32, SvgError> {
        let number = self.scanner.number();
        self.scanner.separator();
        number
    }

    const fn flag_and_separator(&mut self) -> Result<bool, SvgError> {
        let flag = self.scanner.flag();
        self.scanner.separator();
        flag
    }

    const fn along_x(&mut self) -> Result<i32, SvgError> {
        let [x, _] = self.last;
        self.coordinate(x)
    }

    const fn along_y(&mut self) -> Result<i32, SvgError> {
        let [_, y] = self.last;
        self.coordinate(y)
    }

    /// A number, from where the path has come to if the command is relative.
    const fn coordinate(&mut self, last: i32) -> Result<i32, SvgError> {
        let start = self.scanner;
        let number = ok!(self.scanner.number());
        if self.is_relative() { sum(&start, last, number as i64) } else { Ok(number) }
    }
}

/// A coordinate and a distance, if that is in range.
const fn sum(at: &Scanner, from: i32, distance: i64) -> Result<i32, SvgError> {
    let sum = from as i64 + distance;
    if sum.unsigned_abs() < 1 << 31 { Ok(low_i32(sum)) } else { Err(at.error(SvgProblem::OutOfRange)) }
}
