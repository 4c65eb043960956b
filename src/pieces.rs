//! Curves in pieces: how many straight edges stand for one, and where each of them ends.
//!
//! A curve is cut into `n = 2^k` pieces of equal parameter, and `n` is known before the first is drawn. Each vertex has a
//! number and can be computed for itself, so a fill can keep a curve in its list in place of all of its edges.
//!
//! ```text
//!        P₁                            Bézier curves: the chord of a piece is at most M / 4n² from a quadratic curve
//!        ╱╲      ● vertices,           and 3M / 4n² from a cubic one, where M is the length of the longest second
//!       ●──●       n = 4               difference P₀ − 2P₁ + P₂ of its control points.
//!     ●      ●                         Arcs: the chord of an angle θ / n is at most r·θ² / 8n² from the arc.
//!    P₀       P₂
//! ```
//!
//! The bounds are that of G. Farin, *Curves and Surfaces for CAGD*, for the chord of a twice differentiable curve:
//! an eighth of the longest second derivative times the square of the piece.

use crate::{
    angle::sine_and_cosine,
    edge::LIMIT,
    num::{Subpixel, bits, count, low_i32, low_index, low_u8, low_u32},
    polynomial::{Axis, bend, step, vertex},
    space::Point2,
};

/// No Bézier curve has more pieces than 2 to this. Then a vertex fits 26 + 3 · 12 bits and a sign.
const MOST_HALVINGS: u32 = 12;

/// A curve that a [`Pen`](crate::Pen) draws from where it stands: a Bézier curve or an arc, cut into straight pieces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Curve {
    kind: Kind,
    /// Control points; of an arc its centre, two conjugate radii, and the turns where it begins and from piece to piece.
    points: [Point2; 4],
    pieces: u32,
    halvings: u8,
    /// Pieces without length are left out where they are drawn one after the other.
    is_distinct: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Quadratic,
    Cubic,
    Arc,
}

impl Curve {
    /// A quadratic Bézier curve: start, control point, end.
    pub(crate) fn quadratic(points: [Point2; 3]) -> Self {
        let [from, control, to] = points.map(|point| point.nearest_within(LIMIT));
        // M / 4n² ≤ 1/4
        Self::bezier(Kind::Quadratic, [from, control, to, to], bend(Axis::of_quadratic([from, control, to])))
    }

    /// A cubic Bézier curve: start, two control points, end.
    pub(crate) fn cubic(points: [Point2; 4]) -> Self {
        let points = points.map(|point| point.nearest_within(LIMIT));
        // 3M / 4n² ≤ 1/4
        Self::bezier(Kind::Cubic, points, bend(Axis::of_cubic(points)))
    }

    fn bezier(kind: Kind, points: [Point2; 4], bend: u64) -> Self {
        let halvings = halvings(bend).min(MOST_HALVINGS);
        Self { kind, points, halvings: low_u8(halvings), pieces: 1 << halvings, is_distinct: false }
    }

    /// An arc about a centre: the points `radii[0]·cos t + radii[1]·sin t` away from it, from a turn of 2³² parts on over
    /// `sweep` parts of 2¹⁶, at most one turn. The arc is less than [`LIMIT`] from the origin.
    pub(crate) fn arc(center: Point2, radii: [Point2; 2], start: u32, sweep: i32) -> Self {
        let halvings = arc_halvings(radii, sweep);
        // Exact: a sweep is a multiple of 2¹⁶ here, and k at most 16.
        let step = low_u32((i64::from(sweep) << 16) >> halvings);
        let turns = Point2::from_sixteenths(start.cast_signed(), step.cast_signed());
        let points = [center, radii[0], radii[1], turns];
        Self { kind: Kind::Arc, points, halvings: low_u8(halvings), pieces: 1 << halvings, is_distinct: false }
    }

    /// The same without its last piece.
    pub(crate) const fn without_last(self) -> Self {
        Self { pieces: self.pieces.saturating_sub(1), ..self }
    }

    /// The same in half as many pieces or a quarter, as long as it is at most 1.5 sixteenths from their chords.
    pub(crate) fn coarser(self) -> Self {
        // For each bit of this the error is four times as large.
        let excess = match self.kind {
            Kind::Quadratic => spare(bend(Axis::of_quadratic(self.three())), self.halvings),
            Kind::Cubic => spare(bend(Axis::of_cubic(self.points)), self.halvings),
            Kind::Arc => 1,
        };
        self.halved(excess.min(self.halvings))
    }

    /// The same in `2^times` times fewer pieces.
    fn halved(mut self, times: u8) -> Self {
        let is_whole = self.pieces == 1 << self.halvings;
        self.halvings = self.halvings.saturating_sub(times);
        self.pieces = (1 << self.halvings) - u32::from(!is_whole);
        if self.kind == Kind::Arc {
            let [_, _, _, turns] = &mut self.points;
            *turns = Point2::from_sixteenths(turns.x.to_bits(), turns.y.to_bits().wrapping_shl(times.into()));
        }
        self
    }

    /// +1 where all of the curve goes down, −1 where it goes up, 0 where it is level, if the control points say so.
    pub(crate) fn slope(&self) -> Option<i32> {
        let [a, b, c, d] = self.points.map(|point| point.y);
        let (least, most) = (a.min(d), a.max(d));
        let is_monotone = match self.kind {
            Kind::Arc => return None,
            // The end stands there twice.
            Kind::Quadratic => (least..=most).contains(&b),
            Kind::Cubic => {
                if a <= d {
                    a <= b && b <= c && c <= d
                } else {
                    a >= b && b >= c && c >= d
                }
            }
        };
        is_monotone.then_some(i32::from(a < d) - i32::from(a > d))
    }

    /// The same arc, drawn without the pieces that have no length.
    pub(crate) const fn distinct(self) -> Self {
        Self { is_distinct: true, ..self }
    }

    /// The curve whose points are moved by an affine map, given for points and for differences; `None` where
    /// that is out of range.
    pub(crate) fn mapped(&self, point: impl Fn(Point2) -> Point2, vector: impl Fn(Point2) -> Point2) -> Option<Self> {
        let [a, b, c, d] = self.points;
        let is_whole = self.pieces == 1 << self.halvings;
        let in_range = |points: &[Point2]| points.iter().all(|point| point.within(LIMIT / 4));
        let mapped = match self.kind {
            Kind::Arc => {
                let (center, radii) = (point(a), [vector(b), vector(c)]);
                if !(center.within(LIMIT / 4) && in_range(&radii)) {
                    return None;
                }
                // An arc that has a length has so many pieces that none is half a turn.
                let sweep = i64::from(d.y.to_bits()) << self.halvings >> 16;
                Self::arc(center, radii, bits(d.x.to_bits()), low_i32(sweep))
            }
            Kind::Quadratic => {
                let points = [point(a), point(b), point(c)];
                in_range(&points).then(|| Self::quadratic(points))?
            }
            Kind::Cubic => {
                let points = [point(a), point(b), point(c), point(d)];
                in_range(&points).then(|| Self::cubic(points))?
            }
        };
        Some(if is_whole { mapped } else { mapped.without_last() })
    }

    /// Points that hold it between them.
    pub(crate) fn hull(&self) -> [Point2; 4] {
        let [center, a, b, _] = self.points;
        if self.kind != Kind::Arc {
            return self.points;
        }
        let reach = |a: Subpixel, b: Subpixel| a.to_bits().abs().saturating_add(b.to_bits().abs());
        let (x, y) = (reach(a.x, b.x), reach(a.y, b.y));
        [(-x, -y), (x, y), (-x, y), (x, -y)].map(|(x, y)| {
            Point2::from_sixteenths(center.x.to_bits().saturating_add(x), center.y.to_bits().saturating_add(y))
        })
    }

    /// How many edges stand for it.
    #[must_use]
    pub fn pieces(&self) -> usize {
        count(self.pieces.into())
    }

    /// Where it begins, at 0, and where each piece ends. Some ten multiplications of 64 bits.
    #[must_use]
    pub fn vertex(&self, number: usize) -> Point2 {
        self.vertex_at(low_index(number))
    }

    pub(crate) const fn len(&self) -> u32 {
        self.pieces
    }

    pub(crate) fn vertex_at(&self, number: u32) -> Point2 {
        let [center, _, _, turns] = self.points;
        match self.kind {
            Kind::Quadratic | Kind::Cubic if number == 0 => center,
            // Of a quadratic curve it is the end, too.
            Kind::Quadratic | Kind::Cubic if number == 1 << self.halvings => turns,
            Kind::Quadratic => vertex(Axis::of_quadratic(self.three()), self.halvings.into(), number),
            Kind::Cubic => vertex(Axis::of_cubic(self.points), self.halvings.into(), number),
            Kind::Arc => {
                let [start, step] = [turns.x, turns.y].map(|turn| bits(turn.to_bits()));
                self.on_arc(center, start.wrapping_add(step.wrapping_mul(number)))
            }
        }
    }

    /// Gives the ends of the pieces, one after the other.
    #[inline]
    pub(crate) fn each(&self, mut give: impl FnMut(Point2)) {
        if !self.is_distinct {
            return self.each_numbered(give);
        }
        let mut last = self.vertex_at(0);
        self.each_numbered(|vertex| {
            if vertex != last {
                give(vertex);
            }
            last = vertex;
        });
    }

    /// Gives the vertices 1, 2, 3 …
    #[inline]
    pub(crate) fn each_numbered(&self, mut give: impl FnMut(Point2)) {
        let [center, _, _, turns] = self.points;
        let pieces = (u32::from(self.halvings), self.pieces);
        match self.kind {
            Kind::Quadratic => step(Axis::of_quadratic(self.three()), pieces, give),
            Kind::Cubic => step(Axis::of_cubic(self.points), pieces, give),
            Kind::Arc => {
                let [start, step] = [turns.x, turns.y].map(|turn| bits(turn.to_bits()));
                let mut turn = start;
                for _ in 0..self.pieces {
                    turn = turn.wrapping_add(step);
                    give(self.on_arc(center, turn));
                }
            }
        }
    }

    const fn three(&self) -> [Point2; 3] {
        let [from, control, to, _] = self.points;
        [from, control, to]
    }

    /// The vertex at a turn of 2³² parts, to the nearest sixteenth on each axis.
    fn on_arc(&self, center: Point2, turn: u32) -> Point2 {
        let (sin, cos) = sine_and_cosine(turn);
        let [_, a, b, _] = self.points;
        // Rounded without its sign, so that both halves are the same.
        let part = |a: Subpixel, b: Subpixel| {
            let sum = i64::from(a.to_bits()) * cos + i64::from(b.to_bits()) * sin;
            let magnitude = (sum.abs() + (1 << 30)) >> 31;
            low_i32(if sum < 0 { -magnitude } else { magnitude })
        };
        let [x, y] = [part(a.x, b.x), part(a.y, b.y)];
        Point2::from_sixteenths(center.x.to_bits() + x, center.y.to_bits() + y)
    }
}

/// The least k so that 2^k chords are at most 0.2 sixteenths from the arc: `4ᵏ > 25·r·(sweep/turn)²`, where
/// 25 is a little more than `(2π)²/8 / 0.2`. The radius is that along an axis, or no less than the largest one.
fn arc_halvings(radii: [Point2; 2], sweep: i32) -> u32 {
    let [a, b] = radii.map(|Point2 { x, y }| [x, y].map(|v| u64::from(v.to_bits().unsigned_abs())));
    let radius = if a[1] == 0 && b[0] == 0 { a[0].max(b[1]) } else { a[0] + a[1] + b[0] + b[1] };
    let sweep = u64::from(sweep.unsigned_abs());
    let chords = (25 * radius * sweep * sweep) >> 32;
    (u64::BITS - chords.leading_zeros()).div_ceil(2).min(16)
}

/// The least k with 4ᵏ ≥ `bend`.
fn halvings(bend: u64) -> u32 {
    let digits = u64::BITS - bend.saturating_sub(1).leading_zeros();
    digits.div_ceil(2)
}

/// How many halvings too many there are where an error of 1.5 will do, in place of ¼.
fn spare(bend: u64, halvings_now: u8) -> u8 {
    halvings_now.saturating_sub(low_u8(halvings(bend.div_ceil(6))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn point() -> impl Strategy<Value = Point2> {
        let end = LIMIT.cast_signed() - 1;
        let coordinate = || prop_oneof![-500..500_i32, -40_000..40_000_i32, -end..=end, Just(end), Just(-end)];
        (coordinate(), coordinate()).prop_map(|(x, y)| Point2::from_sixteenths(x, y))
    }

    fn curve() -> impl Strategy<Value = Curve> {
        let small = || (-20_000..20_000_i32, -20_000..20_000_i32).prop_map(|(x, y)| Point2::from_sixteenths(x, y));
        prop_oneof![
            [point(), point(), point()].prop_map(Curve::quadratic),
            [point(), point(), point(), point()].prop_map(Curve::cubic),
            (small(), [small(), small()], any::<u32>(), -65_536..=65_536)
                .prop_map(|(c, r, start, sweep)| Curve::arc(c, r, start, sweep)),
        ]
    }

    proptest! {
        #[test]
        fn vertices_by_number_are_those_of_the_walk(curve in curve()) {
            let mut number = 0;
            curve.each(|vertex| {
                number += 1;
                assert_eq!(vertex, curve.vertex(number), "{number}");
            });
            prop_assert_eq!(number, curve.pieces());
        }
    }
}
