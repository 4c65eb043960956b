//! Slow and exact: lines against any boundaries, by fractions of 128 bits.

/// A fraction with a positive denominator, below 2⁶³ in each part.
#[derive(Clone, Copy)]
struct Fraction(i128, i128);

impl Fraction {
    fn is_less(self, other: Self) -> bool {
        self.0 * other.1 < other.0 * self.1
    }

    /// `from + (to − from) · self`, to the nearest, ties to the larger.
    fn between(self, from: i32, to: i32) -> i32 {
        let (from, to) = (i128::from(from), i128::from(to));
        let rounded = (2 * (from * self.1 + (to - from) * self.0) + self.1).div_euclid(2 * self.1);
        i32::try_from(rounded).expect("between the ends")
    }
}

/// The part of a line with any coordinates whose ends are so far inside of each boundary.
pub fn line_part<const N: usize>(
    (start, end): ([i32; N], [i32; N]),
    distances: impl IntoIterator<Item = (i128, i128)>,
) -> Option<([i32; N], [i32; N])> {
    let (mut enter, mut leave) = (Fraction(0, 1), Fraction(1, 1));
    for (at_start, at_end) in distances {
        match (at_start < 0, at_end < 0) {
            (true, true) => return None,
            (true, false) if enter.is_less(Fraction(-at_start, at_end - at_start)) => {
                enter = Fraction(-at_start, at_end - at_start);
            }
            (false, true) if Fraction(at_start, at_start - at_end).is_less(leave) => {
                leave = Fraction(at_start, at_start - at_end);
            }
            _ => {}
        }
    }
    let at = |t: Fraction| core::array::from_fn(|i| t.between(start[i], end[i]));
    (!leave.is_less(enter)).then(|| (at(enter), at(leave)))
}

/// How far a place is inside of the seven planes of a volume `width` times as wide as the view.
pub fn volume_distances([x, y, z, w]: [i32; 4], width: i128) -> [i128; 7] {
    let [x, y, z, w] = [x, y, z, w].map(i128::from);
    let eighth = 1 << 13;
    [w - eighth, w + z, w - z, width * w + x, width * w - x, width * w + y, width * w - y]
}

/// Pairs of what the two ends have of a list.
pub fn pairs<const N: usize>(start: [i128; N], end: [i128; N]) -> impl Iterator<Item = (i128, i128)> {
    start.into_iter().zip(end)
}
