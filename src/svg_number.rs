//! The signs of SVG path data: numbers, flags, what separates them, and what can be wrong with them.
//!
//! ```text
//!   -.5.5-1e-3,7      four numbers: -.5  .5  -1e-3  7
//! ```
//!
//! A number becomes a signed 16.16, to the nearest: one division of 64 bits where it has a fraction. Of more than 14
//! digits the rest is left out. The grammar is that of W3C, *Scalable Vector Graphics 2*, section 9.3.9. All of it
//! can run while the program is compiled.

use crate::error::describe;

/// Where path data are wrong, and how. Nothing was drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SvgError {
    /// The bytes before the place.
    pub offset: usize,
    /// What is wrong there.
    pub problem: SvgProblem,
}

/// What can be wrong with path data.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum SvgProblem {
    /// The first command is no `M` or `m`.
    MoveExpected,
    /// There is no command of that letter, or no command at all.
    UnexpectedCharacter,
    /// Something else than a number, or the end.
    NumberExpected,
    /// Something else than `0` or `1` as a flag of an arc, or the end.
    FlagExpected,
    /// A number, or the place that it leads to, is 32,768 units or more from zero.
    OutOfRange,
}

describe! { SvgError, Self { offset, problem } => "{problem} at byte {offset}"; }
describe! { SvgProblem,
    Self::MoveExpected => "a path begins with a move, which is missing";
    Self::UnexpectedCharacter => "no command of a path";
    Self::NumberExpected => "a number is missing";
    Self::FlagExpected => "a flag, 0 or 1, is missing";
    Self::OutOfRange => "a coordinate is out of range";
}

/// `?`, which a `const fn` cannot use yet.
macro_rules! ok {
    ($result:expr) => {
        match $result {
            Ok(value) => value,
            Err(error) => return Err(error),
        }
    };
}

pub(crate) use ok;

/// A place in user units of 16.16.
pub(crate) type Place = [i32; 2];

/// What has not been read of the data.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scanner<'a> {
    rest: &'a [u8],
    offset: usize,
}

impl<'a> Scanner<'a> {
    pub(crate) const fn new(data: &'a str) -> Self {
        Self { rest: data.as_bytes(), offset: 0 }
    }

    /// A problem with what comes next.
    pub(crate) const fn error(&self, problem: SvgProblem) -> SvgError {
        SvgError { offset: self.offset, problem }
    }

    pub(crate) const fn peek(&self) -> Option<u8> {
        if let [byte, ..] = self.rest { Some(*byte) } else { None }
    }

    pub(crate) const fn skip(&mut self) {
        if let [_, rest @ ..] = self.rest {
            self.rest = rest;
            self.offset += 1;
        }
    }

    pub(crate) const fn spaces(&mut self) {
        while let Some(b'\t' | b'\n' | b'\x0C' | b'\r' | b' ') = self.peek() {
            self.skip();
        }
    }

    /// Space, a comma, both or nothing. Says whether there was a comma.
    pub(crate) const fn separator(&mut self) -> bool {
        self.spaces();
        let is_comma = matches!(self.peek(), Some(b','));
        if is_comma {
            self.skip();
            self.spaces();
        }
        is_comma
    }

    /// Whether another number has to follow, or does.
    pub(crate) const fn has_more(&mut self) -> bool {
        self.separator() || matches!(self.peek(), Some(b'0'..=b'9' | b'+' | b'-' | b'.'))
    }

    pub(crate) const fn flag(&mut self) -> Result<bool, SvgError> {
        let flag = self.peek();
        if !matches!(flag, Some(b'0' | b'1')) {
            return Err(self.error(SvgProblem::FlagExpected));
        }
        self.skip();
        Ok(matches!(flag, Some(b'1')))
    }

    /// A number as 16.16.
    pub(crate) const fn number(&mut self) -> Result<i32, SvgError> {
        let start = *self;
        let is_negative = self.sign();
        let mut decimal = Decimal { digits: 0, exponent: 0 };
        let is_whole = self.digits(&mut decimal, false);
        let is_fraction = matches!(self.peek(), Some(b'.'));
        if is_fraction {
            self.skip();
        }
        if !(if is_fraction { self.digits(&mut decimal, true) } else { is_whole }) {
            return Err(self.error(SvgProblem::NumberExpected));
        }
        decimal.exponent = decimal.exponent.saturating_add(ok!(self.exponent()));
        match decimal.to_fixed() {
            Some(magnitude) => Ok(if is_negative { -magnitude } else { magnitude }),
            None => Err(start.error(SvgProblem::OutOfRange)),
        }
    }

    /// Whether there was a minus.
    const fn sign(&mut self) -> bool {
        let sign = self.peek();
        if matches!(sign, Some(b'+' | b'-')) {
            self.skip();
        }
        matches!(sign, Some(b'-'))
    }

    /// Whether there was a digit.
    const fn digits(&mut self, decimal: &mut Decimal, are_fraction: bool) -> bool {
        let start = self.offset;
        while let Some(digit @ b'0'..=b'9') = self.peek() {
            decimal.push(digit - b'0', are_fraction);
            self.skip();
        }
        self.offset != start
    }

    /// The power of ten behind a number, 0 where there is none. Beyond ±9999 it makes no difference.
    const fn exponent(&mut self) -> Result<i32, SvgError> {
        if !matches!(self.peek(), Some(b'e' | b'E')) {
            return Ok(0);
        }
        self.skip();
        let is_negative = self.sign();
        if !matches!(self.peek(), Some(b'0'..=b'9')) {
            return Err(self.error(SvgProblem::NumberExpected));
        }
        let mut exponent = 0;
        while let Some(digit @ b'0'..=b'9') = self.peek() {
            exponent = 10 * exponent + (digit - b'0') as i32;
            exponent = if exponent > 9999 { 9999 } else { exponent };
            self.skip();
        }
        Ok(if is_negative { -exponent } else { exponent })
    }
}

/// `digits · 10^exponent`.
struct Decimal {
    /// Less than 10¹⁴, so that 16 more bits fit.
    digits: u64,
    exponent: i32,
}

impl Decimal {
    const fn push(&mut self, digit: u8, is_fraction: bool) {
        let has_room = self.digits < 10_u64.pow(13);
        if has_room {
            self.digits = 10 * self.digits + digit as u64;
        }
        match (has_room, is_fraction) {
            (true, true) => self.exponent = self.exponent.saturating_sub(1),
            (false, false) => self.exponent = self.exponent.saturating_add(1),
            _ => {}
        }
    }

    /// The nearest 16.16, if it is less than 32,768.
    const fn to_fixed(&self) -> Option<i32> {
        let (mut digits, mut exponent) = (self.digits, self.exponent);
        while exponent > 0 && 0 < digits && digits < 1 << 15 {
            digits *= 10;
            exponent -= 1;
        }
        let units = match exponent.unsigned_abs() {
            _ if digits == 0 => 0,
            0 => digits << 16,
            _ if exponent > 0 => u64::MAX,
            power @ 1..=19 => over(digits << 16, 10_u64.pow(power)),
            _ => 0,
        };
        if units < 1 << 31 { Some(crate::num::low_i32(units.cast_signed())) } else { None }
    }
}

/// A quotient, rounded to the nearest. Zero when `divisor` is, so that there is no panic.
const fn over(dividend: u64, divisor: u64) -> u64 {
    match (dividend + divisor / 2).checked_div(divisor) {
        Some(quotient) => quotient,
        None => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(text: &str) -> Result<(i32, usize), SvgError> {
        let mut scanner = Scanner::new(text);
        scanner.number().map(|number| (number, scanner.offset))
    }

    #[test]
    fn numbers_are_read_as_far_as_they_go() {
        let cases = [
            ("7", 7.0, 1),
            ("+7", 7.0, 2),
            ("-.5.5", -0.5, 3),
            ("007-3", 7.0, 3),
            ("1e-3", 0.001, 4),
            ("1E+3", 1000.0, 4),
            ("2.5e1.5", 25.0, 5),
            ("0e999999999999999999", 0.0, 20),
            ("1e-999999999999999999", 0.0, 21),
            ("32767.99999", 32767.99999, 11),
            ("0.00000000000000000000000000032e30", 320.0, 34),
            ("3200000000000000000000000000000e-28", 320.0, 35),
            ("0.333333333333333333333333333333", 1.0 / 3.0, 32),
            ("0.00000762939453125", 1.0 / 131_072.0, 19),
            ("0.0000076293945312", 0.0, 18),
        ];
        for (text, value, length) in cases {
            #[expect(clippy::cast_possible_truncation, reason = "less than 2^31")]
            let fixed = (value * 65_536.0_f64).round() as i32;
            assert_eq!(number(text), Ok((fixed, length)), "{text}");
        }
    }

    #[test]
    fn what_is_no_number_says_where() {
        let wrong = |offset, problem| Err(SvgError { offset, problem });
        for (text, offset) in
            [("", 0), ("-", 1), (".", 1), ("1.", 2), ("1.e3", 2), ("+-1", 1), ("1e", 2), ("1e+", 3), ("x", 0)]
        {
            assert_eq!(number(text), wrong(offset, SvgProblem::NumberExpected), "{text}");
        }
        for text in ["32768", "-32768", "1e5", "1e99999999999", "123456789012345678901234567890", "32767.999999"] {
            assert_eq!(number(text), wrong(0, SvgProblem::OutOfRange), "{text}");
        }
    }
}
