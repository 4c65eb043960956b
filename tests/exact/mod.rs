//! Slow and exact: what the rasterisers must agree with, in 128-bit integers.
#![allow(dead_code, reason = "each test file uses a part")]
#![expect(clippy::cast_sign_loss, clippy::cast_precision_loss, reason = "small, and tested before")]

use std::ops::Range;

use aquatint::{Line, Point2, Rect, Rule};

/// How often each pixel of a window has been drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Overdraw {
    window: Rect,
    counts: Vec<u32>,
}

impl Overdraw {
    pub fn new(window: Rect) -> Self {
        Self { window, counts: vec![0; window.width() as usize * window.height() as usize] }
    }

    pub fn window(&self) -> Rect {
        self.window
    }

    fn index(&self, x: i32, y: i32) -> usize {
        assert!(self.window.columns().contains(&x) && self.window.rows().contains(&y), "{x}, {y} is outside");
        (y - self.window.top) as usize * self.window.width() as usize + (x - self.window.left) as usize
    }

    /// A span; the contract says that it is not empty and inside.
    pub fn add(&mut self, row: i32, columns: Range<i32>) {
        assert!(!columns.is_empty(), "an empty span in row {row}");
        for column in columns {
            let index = self.index(column, row);
            self.counts[index] += 1;
        }
    }

    pub fn count(&self, x: i32, y: i32) -> u32 {
        self.counts[self.index(x, y)]
    }

    pub fn places(&self) -> impl Iterator<Item = (i32, i32)> + use<> {
        let window = self.window;
        window.rows().flat_map(move |y| window.columns().map(move |x| (x, y)))
    }

    /// `.` not drawn, `#` drawn once, a digit when more often.
    pub fn picture(&self) -> String {
        let sign = |&count: &u32| match count {
            0 => '.',
            1 => '#',
            more => char::from_digit(more.min(9), 10).expect("a digit"),
        };
        let rows = self.counts.chunks(self.window.width().max(1) as usize);
        rows.map(|row| row.iter().map(sign).collect::<String>() + "\n").collect()
    }
}

/// Whether the centre of a pixel is inside, by the winding number of a ray to the left.
///
/// A centre exactly on a left or top edge counts as inside, on a right or bottom edge as outside:
/// the ray runs from a point infinitesimally right of and below the centre.
pub fn is_inside(contours: &[Vec<Point2>], rule: Rule, (x, y): (i32, i32)) -> bool {
    let (cx, cy) = (i128::from(x) * 16 + 8, i128::from(y) * 16 + 8);
    let (mut winding, mut crossings) = (0, 0);
    for contour in contours {
        for (index, a) in contour.iter().enumerate() {
            let b = contour[(index + 1) % contour.len()];
            let [ax, ay, bx, by] = [a.x, a.y, b.x, b.y].map(|v| i128::from(v.to_bits()));
            // Rows are owned half-open.
            let direction = i32::from(ay <= cy && cy < by) - i32::from(by <= cy && cy < ay);
            // Crossing at or left of the centre: ax + (cy − ay)(bx − ax)/(by − ay) ≤ cx.
            let (rise, side) = (by - ay, (cx - ax) * (by - ay) - (cy - ay) * (bx - ax));
            if direction != 0 && side * rise.signum() >= 0 {
                winding += direction;
                crossings += 1;
            }
        }
    }
    match rule {
        Rule::NonZero => winding != 0,
        Rule::EvenOdd => crossings % 2 != 0,
    }
}

/// The value at the centre of a pixel of the plane through three corners.
pub fn interpolated(corners: [Point2; 3], values: [u16; 3], (x, y): (i32, i32)) -> f64 {
    let [a, b, c] = corners.map(|p| (i128::from(p.x.to_bits()), i128::from(p.y.to_bits())));
    let p = (i128::from(x) * 16 + 8, i128::from(y) * 16 + 8);
    let area =
        |p: (i128, i128), q: (i128, i128), r: (i128, i128)| (q.0 - p.0) * (r.1 - p.1) - (r.0 - p.0) * (q.1 - p.1);
    let [va, vb, vc] = values.map(i128::from);
    let weighed = va * area(p, b, c) + vb * area(a, p, c) + vc * area(a, b, p);
    weighed as f64 / area(a, b, c) as f64
}

/// The pixels of the whole line that lie in the window, sorted: for each step along the longer
/// axis the nearest pixel on the other, ties to the larger coordinate, ends in canonical order.
pub fn line(line: Line, window: Rect) -> Vec<(i32, i32)> {
    let [ax, ay, bx, by] = [line.start.x, line.start.y, line.end.x, line.end.y].map(i128::from);
    let is_steep = (by - ay).abs() > (bx - ax).abs();
    let swap = |(x, y)| if is_steep { (y, x) } else { (x, y) };
    let (a, b): ((i128, i128), (i128, i128)) = (swap((ax, ay)), swap((bx, by)));
    let (a, b) = if a.0 <= b.0 { (a, b) } else { (b, a) };
    let range = if is_steep { window.rows() } else { window.columns() };
    let mut pixels: Vec<_> = range
        .map(i128::from)
        .filter(|major| (a.0..=b.0).contains(major))
        .map(|major| {
            let (run, rise) = ((b.0 - a.0).max(1), b.1 - a.1);
            // ⌊exact + ½⌋
            let minor = a.1 + (2 * (major - a.0) * rise + run).div_euclid(2 * run);
            swap((major, minor))
        })
        .filter_map(|(x, y)| Some((i32::try_from(x).ok()?, i32::try_from(y).ok()?)))
        .filter(|(x, y)| window.columns().contains(x) && window.rows().contains(y))
        .collect();
    pixels.sort_unstable();
    pixels
}

/// A small generator, so that a failing picture can be drawn again.
pub struct Random(pub u32);

impl Random {
    pub fn below(&mut self, limit: i32) -> i32 {
        // Xorshift, G. Marsaglia 2003.
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        (self.0 % limit.unsigned_abs()).cast_signed()
    }
}
