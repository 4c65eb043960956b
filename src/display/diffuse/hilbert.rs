//! Hilbert's curve: all pixels of a picture, each next to the one before. Lecture 7.4.
//!
//! ```text
//!   order 1   order 2      each quarter is the curve of the order below: the first one mirrored at its
//!     ╷ ╷     ╶─┐ ┌─╴      diagonal, the last one at the other diagonal
//!     └─┘     ┌─┘ └─┐
//!             │ ┌─┐ │      0 3
//!             └─┘ └─┘      1 2    the quarters in the order of the walk
//! ```
//!
//! Pictures of any size are walked over on the curve of the next power of two; quarters that lie outside are
//! skipped whole. No recursion: the way down to a pixel is a word of two bits a level. D. Hilbert, "Über die stetige
//! Abbildung einer Linie auf ein Flächenstück", Mathematische Annalen 38, 1891.

use embedded_graphics::geometry::{Point, Size};

/// The pixels of a picture in the order of Hilbert's curve, each once.
///
/// Neighbours in this order are neighbours in the picture, save where the curve leaves it, which it does not in a
/// square whose side is a power of two. Takes some 150 instructions a pixel.
///
/// ```
/// use aquatint::display::diffuse::Hilbert;
/// use embedded_graphics::geometry::{Point, Size};
///
/// let points = [(0, 0), (0, 1), (1, 1), (1, 0)].map(|(x, y)| Point::new(x, y));
/// assert!(Hilbert::new(Size::new(2, 2)).eq(points));
/// assert_eq!(Hilbert::new(Size::new(3, 2)).count(), 6);
/// ```
#[derive(Clone, Debug)]
pub struct Hilbert {
    size: Size,
    /// The square at work: how often it was doubled from a pixel, and its place in squares of that size.
    level: u32,
    x: u32,
    y: u32,
    /// The level of the whole.
    top: u32,
    /// Which quarters were taken on the way down, the last one in the low bits.
    digits: u64,
    /// Whether the curve in the square is mirrored at the diagonal, and whether it is turned by half.
    is_mirrored: bool,
    is_turned: bool,
    is_done: bool,
}

impl Hilbert {
    /// The curve for a picture of this size.
    #[must_use]
    pub const fn new(size: Size) -> Self {
        let longer = if size.width > size.height { size.width } else { size.height };
        let top = u32::BITS - longer.saturating_sub(1).leading_zeros();
        Self {
            size,
            level: top,
            x: 0,
            y: 0,
            top,
            digits: 0,
            is_mirrored: false,
            is_turned: false,
            is_done: size.width == 0 || size.height == 0,
        }
    }

    #[inline]
    fn is_outside(&self) -> bool {
        let start = |place: u32| u64::from(place) << self.level;
        start(self.x) >= u64::from(self.size.width) || start(self.y) >= u64::from(self.size.height)
    }

    /// To a quarter of the square.
    #[inline]
    fn descend(&mut self, digit: u64) {
        let (right, down) = (digit >= 2, digit == 1 || digit == 2);
        let (right, down) = (right ^ self.is_turned, down ^ self.is_turned);
        let (right, down) = if self.is_mirrored { (down, right) } else { (right, down) };
        (self.x, self.y) = (self.x << 1 | u32::from(right), self.y << 1 | u32::from(down));
        (self.level, self.digits) = (self.level.saturating_sub(1), self.digits << 2 | digit);
        self.turn(digit);
    }

    /// To the square that this one is a quarter of. Says which.
    #[inline]
    fn ascend(&mut self) -> u64 {
        let digit = self.digits & 3;
        (self.x, self.y) = (self.x >> 1, self.y >> 1);
        (self.level, self.digits) = (self.level + 1, self.digits >> 2);
        self.turn(digit);
        digit
    }

    /// Between a square and its quarter, either way.
    #[inline]
    fn turn(&mut self, digit: u64) {
        self.is_mirrored ^= digit == 0 || digit == 3;
        self.is_turned ^= digit == 3;
    }

    /// To the next square, without looking into this one.
    #[inline]
    fn skip(&mut self) {
        while self.level < self.top {
            let digit = self.ascend();
            if digit < 3 {
                return self.descend(digit + 1);
            }
        }
        self.is_done = true;
    }
}

impl Iterator for Hilbert {
    type Item = Point;

    fn next(&mut self) -> Option<Point> {
        while !self.is_done {
            if self.is_outside() {
                self.skip();
            } else if self.level > 0 {
                self.descend(0);
            } else {
                let point = Point::new(self.x.cast_signed(), self.y.cast_signed());
                self.skip();
                return Some(point);
            }
        }
        None
    }
}
