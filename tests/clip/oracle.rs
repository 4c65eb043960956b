//! Slow and exact: lines, windings and areas in 128-bit integers. The fuzz targets use it too.
#![allow(dead_code, reason = "the fuzz targets use a part")]

use aquatint::Point2;

/// A place: x and y in any unit.
pub type Place = (i32, i32);

/// A closed rectangle: its least and its greatest place.
pub type Window = (Place, Place);

/// A fraction with a positive denominator, up to 2⁶⁶ in each part.
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

/// The part of a line in a window, and how many of its ends are cut. By the four inequalities of the window.
pub fn line_part((a, b): (Place, Place), (min, max): Window) -> Option<((Place, Place), usize)> {
    let inside = |(x, y): Place| {
        let [x, y] = [x, y].map(i128::from);
        let [left, top, right, bottom] = [min.0, min.1, max.0, max.1].map(i128::from);
        [x - left, y - top, right - x, bottom - y]
    };
    let (mut enter, mut leave) = (Fraction(0, 1), Fraction(1, 1));
    for (at_a, at_b) in inside(a).into_iter().zip(inside(b)) {
        match (at_a < 0, at_b < 0) {
            (true, true) => return None,
            (true, false) if enter.is_less(Fraction(-at_a, at_b - at_a)) => enter = Fraction(-at_a, at_b - at_a),
            (false, true) if Fraction(at_a, at_a - at_b).is_less(leave) => leave = Fraction(at_a, at_a - at_b),
            _ => {}
        }
    }
    let is_empty = min.0 > max.0 || min.1 > max.1 || leave.is_less(enter);
    let at = |t: Fraction| (t.between(a.0, b.0), t.between(a.1, b.1));
    let cuts = usize::from(enter.0 > 0) + usize::from(leave.0 < leave.1);
    (!is_empty).then(|| ((at(enter), at(leave)), cuts))
}

/// x and y in sixteenths.
pub fn place(point: Point2) -> Place {
    (point.x.to_bits(), point.y.to_bits())
}

/// The edges of a contour.
pub fn edges(contour: &[Point2]) -> impl Iterator<Item = (Place, Place)> + '_ {
    contour.iter().zip(contour.iter().cycle().skip(1)).map(|(&a, &b)| (place(a), place(b)))
}

/// How often a contour winds around a place, seen from infinitesimally right of and below it.
pub fn winding(contour: &[Point2], (x, y): Place) -> i32 {
    let (x, y) = (i128::from(x), i128::from(y));
    let crossing = |((ax, ay), (bx, by)): (Place, Place)| {
        let [ax, ay, bx, by] = [ax, ay, bx, by].map(i128::from);
        let direction = i32::from(ay <= y && y < by) - i32::from(by <= y && y < ay);
        let side = (x - ax) * (by - ay) - (y - ay) * (bx - ax);
        if side * (by - ay).signum() >= 0 { direction } else { 0 }
    };
    edges(contour).map(crossing).sum()
}

/// Twice the area, signed: positive where it runs clockwise as seen on the screen.
pub fn twice_area(contour: &[Point2]) -> i128 {
    let product = |((ax, ay), (bx, by)): (Place, Place)| {
        let [ax, ay, bx, by] = [ax, ay, bx, by].map(i128::from);
        ax * by - bx * ay
    };
    edges(contour).map(product).sum()
}

/// Whether a place is within `reach` of a segment along both axes.
pub fn is_near((x, y): Place, ((ax, ay), (bx, by)): (Place, Place), reach: i32) -> bool {
    // A segment meets the square around the place exactly if a part of it is left when it is clipped to that.
    let corner = |sign: i32| (x.saturating_add(sign * reach), y.saturating_add(sign * reach));
    line_part(((ax, ay), (bx, by)), (corner(-1), corner(1))).is_some()
}

/// Cross product of two edges' directions: positive when the second turns right, as seen on the screen.
pub fn cross((a, b): (Place, Place), (c, d): (Place, Place)) -> i128 {
    let difference = |a: i32, b: i32| i128::from(b) - i128::from(a);
    difference(a.0, b.0) * difference(c.1, d.1) - difference(a.1, b.1) * difference(c.0, d.0)
}

/// Whether two segments have a point in common.
pub fn touch((a, b): (Place, Place), (c, d): (Place, Place)) -> bool {
    let side = |from: (Place, Place), p: Place| cross(from, (from.0, p)).signum();
    let (sides_of_first, sides_of_second) = ((side((a, b), c), side((a, b), d)), (side((c, d), a), side((c, d), b)));
    let overlap = |a: i32, b: i32, c: i32, d: i32| a.min(b) <= c.max(d) && c.min(d) <= a.max(b);
    sides_of_first.0 * sides_of_first.1 <= 0
        && sides_of_second.0 * sides_of_second.1 <= 0
        && overlap(a.0, b.0, c.0, d.0)
        && overlap(a.1, b.1, c.1, d.1)
}
