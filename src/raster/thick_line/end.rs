//! The ends of a thick line: where the strip is cut off, and the disc of a round cap.

use core::ops::Range;

use super::border::Border;

/// One end of a strip. Only the rows near it know of it.
#[derive(Clone, Debug)]
pub(super) struct End {
    /// The rows in which the border may cut off a part of the strip.
    pub(super) rows: Range<i32>,
    /// Where the strip begins, or the first column behind it.
    pub(super) border: Border,
    pub(super) is_left: bool,
}

impl End {
    /// What is left of the strip in a row. Rows come one after the other.
    #[inline]
    pub(super) fn cut(&mut self, row: i32, strip: Range<i64>) -> Range<i64> {
        if !self.rows.contains(&row) {
            return strip;
        }
        let column = self.border.column();
        self.border.advance();
        if self.is_left { strip.start.max(column)..strip.end } else { strip.start..strip.end.min(column) }
    }
}

/// The pixels whose centres are in a disc about the centre of a pixel.
///
/// Centres on its border are inside on the left, outside on the right; of those exactly above and below the middle the
/// upper one is inside.
#[derive(Clone, Copy, Debug)]
pub(super) struct Disc {
    x: i64,
    y: i64,
    /// ⌊radius²⌋: centres are whole numbers of pixels apart.
    square: i64,
    /// Centres may lie exactly on the border.
    is_whole: bool,
    /// Half the chord of the last row.
    half: i64,
}

impl Disc {
    /// A disc of a diameter in sixteenths.
    pub(super) fn new((x, y): (i32, i32), diameter: u16) -> Self {
        let square = i64::from(diameter).pow(2);
        let (square, rest) = (square / 1024, square % 1024);
        Self { x: i64::from(x), y: i64::from(y), square, is_whole: rest == 0, half: 0 }
    }

    /// The columns of a row; an empty range for none. Cheap where rows come one after the other.
    #[inline]
    pub(super) fn chord(&mut self, row: i32) -> Range<i64> {
        let down = i64::from(row) - self.y;
        let Some(left) = down.checked_mul(down).map(|square| self.square - square).filter(|left| *left >= 0) else {
            return 0..0;
        };
        self.fit(left);
        let is_on_border = self.is_whole && self.half * self.half == left;
        match (is_on_border, self.half) {
            (false, half) => self.x - half..self.x + half + 1,
            (true, 0) if down > 0 => 0..0,
            (true, 0) => self.x..self.x + 1,
            (true, half) => self.x - half..self.x + half,
        }
    }

    /// Makes the half chord the square root of a number: from row to row it hardly changes.
    fn fit(&mut self, square: i64) {
        if self.half == 0 {
            self.half = square.isqrt();
        }
        while self.half * self.half > square {
            self.half -= 1;
        }
        while (self.half + 1) * (self.half + 1) <= square {
            self.half += 1;
        }
    }
}
