//! Elliptical arcs as SVG describes them, by where they begin and end, as cubic curves.
//!
//! ```text
//!             ╭──────╮               In the space where the ellipse is a circle of radius 1 about 0, an arc is quarter
//!     from ●╱          ╲             turns and a rest of at most one more. A piece over an angle θ is a cubic curve:
//!          │╲    ·c    │             its control points lie 4/3 · tan(θ/4) along the tangents. It is at most
//!           ╲ ╲       ╱              0.027 % of the radius off.
//!             ╰──●──╯
//!                to
//! ```
//!
//! Half of the chord, `d`, has a length `h` in that space, and the centre is `√(1 − h²)` to one side of its middle. Radii
//! that are too short for the chord, `h > 1`, are made longer, until it is a diameter. Implementation notes of W3C,
//! *Scalable Vector Graphics 2*, appendix B.2; without its angles, so that there is no arc tangent.
//!
//! Everything is integers: vectors of the circle with 30 fraction bits. Five square roots and twelve divisions an arc.
//! The control points are good to 0.03 % of the radius; a chord that is nearly a diameter leaves its centre uncertain,
//! by 0.003 % of the radius.

use crate::{
    angle::sine_and_cosine,
    num::{divide_round, low_u32, saturate_i32},
    svg_number::Place,
};

/// A vector of the circle, or a sine: one has 30 fraction bits.
const FRACTION: u32 = 30;
const ONE: i64 = 1 << FRACTION;
/// `4/3 · tan(90°/4)`.
const QUARTER: i64 = 592_994_018;
/// No radius is made longer than this: 65,536 units.
const LONGEST: i64 = 1 << 32;

/// The arc of an ellipse from a place to another, in user units of 16.16.
#[derive(Clone, Copy, Debug)]
pub(crate) struct EndpointArc {
    pub(crate) from: Place,
    pub(crate) to: Place,
    pub(crate) radii: [i32; 2],
    /// Of the axis of the first radius against x, clockwise, in degrees of 16.16.
    pub(crate) rotation: i32,
    /// Of the two arcs that are left: more than half of the ellipse?
    pub(crate) is_large: bool,
    /// And clockwise?
    pub(crate) is_clockwise: bool,
}

/// A vector in the space of the circle, or on the screen in user units.
type Vector = [i64; 2];

impl EndpointArc {
    /// Whether it is nothing but a straight edge, which the caller draws.
    pub(crate) const fn is_straight(&self) -> bool {
        let [x, y] = self.radii;
        x == 0 || y == 0
    }

    /// Draws cubic curves, at most four: two control points, end. None where it ends as it begins. Control points that
    /// are out of the range of 16.16 are moved to its border.
    pub(crate) fn cubics(&self, mut take: impl FnMut([Place; 3])) {
        if self.from == self.to || self.is_straight() {
            return;
        }
        let (ellipse, [mut at, end]) = self.ellipse();
        for _ in 0..self.quarters(at, end) {
            let next = self.quarter_turn(at);
            let [one, other] = self.control_points([at, next], QUARTER);
            take([one, other, next].map(|vector| ellipse.place(vector)));
            at = next;
        }
        let [one, other] = self.control_points([at, end], handle(at, end)).map(|vector| ellipse.place(vector));
        take([one, other, self.to]);
    }

    /// The ellipse, and the vectors from its centre to where the arc begins and ends.
    fn ellipse(&self) -> (Ellipse, [Vector; 2]) {
        let (axis, radii) = (self.axis(), self.radii.map(|radius| i64::from(radius.unsigned_abs())));
        let middle = each(self.from.map(i64::from), self.to.map(i64::from), |from, to| (from + to) >> 1);
        let (direction, half) = self.half_chord(axis, radii);
        let ellipse = Ellipse { radii, axis, middle, center: [0; 2] };
        if half >= ONE {
            let radii = radii.map(|radius| stretched(radius, half));
            return (Ellipse { radii, ..ellipse }, [direction, direction.map(|v| -v)]);
        }
        let aside = (ONE * ONE - half * half).unsigned_abs().isqrt().cast_signed();
        let aside = if self.is_large == self.is_clockwise { -aside } else { aside };
        let [x, y] = direction;
        let center = [y, -x].map(|v| nearest(v * aside));
        let end = |half: i64| each(direction, center, |direction, center| nearest(direction * half) - center);
        (Ellipse { center, ..ellipse }, [end(half), end(-half)])
    }

    /// The direction of the first radius: the cosine and the sine of the rotation.
    fn axis(&self) -> Vector {
        let turn = low_u32(divide_round(i64::from(self.rotation) << 16, 360));
        let (sin, cos) = sine_and_cosine(turn);
        [cos, sin].map(|v| (v + 1) >> 1)
    }

    /// From the middle of the chord to where the arc begins, in the circle: the direction and the length.
    fn half_chord(&self, [cos, sin]: Vector, [rx, ry]: [i64; 2]) -> (Vector, i64) {
        let chord = each(self.from.map(i64::from), self.to.map(i64::from), |from, to| from - to);
        // Scaled to 2²⁹ … 2³⁰, so that short ones keep their digits.
        let bits = magnitude(chord);
        let [x, y] = chord.map(|v| shifted(v, 29 - bits));
        let [x, y] = [x * cos + y * sin, y * cos - x * sin].map(nearest);
        let (direction, _) = polar([x * ry, y * rx]);
        // No longer than 2³⁰ of the circle, so that the squares fit.
        let half = each([x, y], [rx, ry], |v, radius| {
            shifted(divide_round(v.abs() << FRACTION, radius), bits - 30).min(ONE * ONE)
        });
        (direction, polar(half).1)
    }

    /// How many quarters to draw before the rest: the whole is at most half a turn, or at least that.
    fn quarters(&self, start: Vector, end: Vector) -> u32 {
        let [x, y] = each(start, end, |start, end| nearest(start * end));
        if self.is_large { 2 + u32::from(x + y > 0) } else { u32::from(x + y < 0) }
    }

    const fn quarter_turn(&self, [x, y]: Vector) -> Vector {
        if self.is_clockwise { [-y, x] } else { [y, -x] }
    }

    /// So far along the tangents at both ends of a piece.
    fn control_points(&self, [from, to]: [Vector; 2], handle: i64) -> [Vector; 2] {
        let along = |vector: Vector, handle: i64| {
            each(vector, self.quarter_turn(vector), |v, tangent| v + nearest(tangent * handle))
        };
        [along(from, handle), along(to, -handle)]
    }
}

/// Where vectors of the circle lie.
struct Ellipse {
    radii: Vector,
    axis: Vector,
    /// Of the chord, in user units.
    middle: Vector,
    /// From there to the centre, in the circle.
    center: Vector,
}

impl Ellipse {
    /// The place of a vector from the centre. It is at most 1.2 long, so products stay below 2⁶³.
    fn place(&self, vector: Vector) -> Place {
        let from_middle = each(vector, self.center, |v, center| v + center);
        let [x, y] = each(from_middle, self.radii, |v, radius| nearest(v * radius));
        let [cos, sin] = self.axis;
        let turned = [x * cos - y * sin, x * sin + y * cos].map(nearest);
        each(turned, self.middle, |v, middle| v + middle).map(saturate_i32)
    }
}

/// A radius that is made longer until the chord is a diameter.
fn stretched(radius: i64, half: i64) -> i64 {
    if half < divide_round(LONGEST << FRACTION, radius) { nearest(radius * half) } else { LONGEST }
}

/// `4/3 · tan(θ/4)` for two vectors of length 1 with an angle θ of at most 90°, as `4/3 · |b − a| / (2 + |a + b|)`.
fn handle(a: Vector, b: Vector) -> i64 {
    let (_, chord) = polar(each(a, b, |a, b| b - a));
    let (_, sum) = polar(each(a, b, |a, b| a + b));
    divide_round((4 * chord) << FRACTION, 3 * (2 * ONE + sum))
}

/// The direction and the length of a vector with components of at most 2⁶¹; zero has no direction.
fn polar(vector: Vector) -> (Vector, i64) {
    let bits = magnitude(vector);
    // 2³⁰ ≤ longer < 2³¹, the sum of the squares < 2⁶³.
    let scaled = vector.map(|v| shifted(v, 30 - bits));
    let length = scaled.map(|v| v.unsigned_abs().pow(2)).iter().sum::<u64>().isqrt().cast_signed();
    let direction = scaled.map(|v| divide_round(v << FRACTION, length));
    (direction, shifted(length, bits - 30))
}

/// The power of two below the longer component.
fn magnitude([x, y]: Vector) -> i32 {
    (x.unsigned_abs() | y.unsigned_abs()).checked_ilog2().unwrap_or(0).cast_signed()
}

/// To the left by so many bits, or to the right.
const fn shifted(value: i64, by: i32) -> i64 {
    if by < 0 { value >> by.unsigned_abs() } else { value << by }
}

/// Takes 30 fraction bits off, to the nearest.
const fn nearest(value: i64) -> i64 {
    (value + (1 << (FRACTION - 1))) >> FRACTION
}

fn each([ax, ay]: Vector, [bx, by]: Vector, f: impl Fn(i64, i64) -> i64) -> Vector {
    [f(ax, bx), f(ay, by)]
}
