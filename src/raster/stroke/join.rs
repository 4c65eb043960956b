//! What fills the gap between two segments: a fan of triangles about the corner.
//!
//! ```text
//!   bevel              miter              round
//!       ●╲                 ●━━━●              ●─●╮
//!   ━━━━┃  ╲           ━━━━┃   ┃          ━━━━┃   ●
//!       ┃    ╲             ┃   ┃              ┃   │
//!   ┄┄┄┄○━━━━━●        ┄┄┄┄○━━━●          ┄┄┄┄○━━━●      ○ the corner
//!       ┊     ┃            ┊   ┃              ┊   ┃
//! ```
//!
//! Every triangle is given clockwise, as seen on the screen, so that no two pieces of a stroke can cancel
//! each other out. The first and the last point of a fan are corners of the two strips, to the bit.

use super::direction::{Direction, ONE, Offset};
use crate::{
    edge::LIMIT,
    num::{divide_round, saturate_i32},
    outline::Pen,
    space::Point2,
    style::Join,
};

/// The cosine and the sine of the angles by which a round border is stepped: 2π / (8 · √2ⁿ), 30 fraction bits.
const TURNS: [(i32, i32); 15] = [
    (759_250_125, 759_250_125),
    (912_369_694, 566_129_885),
    (992_008_094, 410_903_207),
    (1_032_611_012, 294_339_944),
    (1_053_110_176, 209_476_638),
    (1_063_409_408, 148_599_921),
    (1_068_571_464, 105_245_103),
    (1_071_155_605, 74_479_352),
    (1_072_448_455, 52_686_014),
    (1_073_095_075, 37_262_120),
    (1_073_418_433, 26_350_943),
    (1_073_580_124, 18_633_866),
    (1_073_660_973, 13_176_464),
    (1_073_701_398, 9_317_284),
    (1_073_721_611, 6_588_356),
];

/// More steps than half a circle takes by the smallest of the [`TURNS`].
const MOST_STEPS: usize = 8 * 128 / 2;

/// The largest of the [`TURNS`] whose chords lie within ¼ sixteenth of a circle of this diameter.
///
/// With `n` chords in a circle they come as near as `½ width · (1 − cos(π/n)) ≤ width · π² / 4n²`; so
/// `n² = 64 · 2ᵏ ≥ 10 · width` is enough.
pub(super) fn turn_for(width: u16) -> (i32, i32) {
    let mut squares = 64;
    let is_fine = |_: &&(i32, i32)| {
        let is_fine = squares >= 10 * u32::from(width);
        squares *= 2;
        is_fine
    };
    let [.., finest] = TURNS;
    *TURNS.iter().find(is_fine).unwrap_or(&finest)
}

/// The corner between two segments.
pub(super) struct Corner {
    pub(super) at: Point2,
    /// From the end of one border to the beginning of the other, clockwise.
    from: Direction,
    to: Direction,
    /// The cosine of the angle between the two segments.
    cosine: i32,
}

impl Corner {
    /// The corner on whose outer side there is a gap to fill; `None` where there is none.
    pub(super) fn between(at: Point2, before: Segment, after: Segment) -> Option<Self> {
        let [one, other] = [before, after].map(|segment| segment.direction.right());
        // Ahead, the gap is where the *rounded* borders leave one. Where the line turns back, they are almost
        // opposite, and the exact vectors say which side is the outer one.
        let turn = if dot(before.run, after.run) > 0 {
            match before.side.cross(after.side) {
                0 => return None,
                turn => turn,
            }
        } else {
            cross(before.run, after.run)
        };
        let cosine = before.direction.dot(after.direction);
        let (from, to) = if turn >= 0 { (one.reversed(), other.reversed()) } else { (other, one) };
        Some(Self { at, from, to, cosine })
    }

    /// Half a turn about the end of a segment.
    pub(super) const fn about_end(at: Point2, direction: Direction) -> Self {
        Self { at, from: direction.left(), to: direction.right(), cosine: -ONE }
    }

    /// Fills the gap.
    pub(super) fn join(&self, join: Join, width: u16, turn: (i32, i32), pen: &mut impl Pen) {
        match join {
            Join::Bevel => self.fan(width, pen).end_at(self.to.half(width)),
            Join::Round => self.round(width, turn, pen),
            Join::Miter { limit } => {
                let mut fan = self.fan(width, pen);
                if let Some(tip) = self.tip(limit, width) {
                    fan.go_to(tip);
                }
                fan.end_at(self.to.half(width));
            }
        }
    }

    /// A part of a disc. The points lie on the circle to half a sixteenth in x and in y.
    pub(super) fn round(&self, width: u16, turn: (i32, i32), pen: &mut impl Pen) {
        let mut fan = self.fan(width, pen);
        let mut direction = self.from.turned(turn);
        for _ in 0..MOST_STEPS {
            // Both are less than half a turn ahead.
            if direction.cross(self.to) <= 0 {
                break;
            }
            fan.go_to(direction.half(width));
            direction = direction.turned(turn);
        }
        fan.end_at(self.to.half(width));
    }

    fn fan<'p, P: Pen>(&self, width: u16, pen: &'p mut P) -> Fan<'p, P> {
        Fan::new(pen, self.at, self.from.half(width))
    }

    /// Where the two borders meet, unless that is too far away, or so near that it makes no difference.
    ///
    /// With the angle φ between the segments it is `½ width / cos(φ/2)` from the corner, which is to be no more than
    /// `½ width · limit`: so `limit² · (1 + cos φ) ≥ 2`.
    fn tip(&self, limit: u8, width: u16) -> Option<Offset> {
        let (cosine, width) = (i64::from(self.cosine), i64::from(width));
        let one = i64::from(ONE);
        let is_within = i64::from(limit).pow(2) * (one + cosine) >= 2 * one;
        // It is less than ⅛ sixteenth outside of the bevel where width · (1 − cos φ) ≤ ½.
        let is_flat = width * (one - cosine) <= one / 2;
        if !is_within || is_flat {
            return None;
        }
        // With s = from + to, the tip is width · s / |s|²: 14 and 16 bits are moved so that all fits.
        let [x, y] = [(self.from.x, self.to.x), (self.from.y, self.to.y)].map(|(a, b)| i64::from(a) + i64::from(b));
        let square = (x * x + y * y) >> 16;
        let [x, y] = [x, y].map(|v| {
            let magnitude = saturate_i32(divide_round((v.abs() * width) << 14, square));
            if v < 0 { -magnitude } else { magnitude }
        });
        Some(Offset { x, y })
    }
}

/// A segment that is not a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Segment {
    /// From its beginning to its end.
    pub(super) run: (i32, i32),
    pub(super) direction: Direction,
    /// From the middle to the right border.
    pub(super) side: Offset,
}

/// A segment whose direction is computed when it is asked for: many are nowhere near to what is looked at.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ahead {
    pub(super) run: (i32, i32),
    known: Option<(Direction, Offset)>,
}

impl Ahead {
    /// From its beginning to its end.
    pub(super) const fn new(run: (i32, i32)) -> Self {
        Self { run, known: None }
    }

    /// The segment of a stroke of some width; `None` for a point.
    pub(super) fn segment(&mut self, width: u16) -> Option<Segment> {
        let (direction, side) = if let Some(known) = self.known {
            known
        } else {
            let direction = Direction::of(self.run)?;
            (direction, direction.right().half(width))
        };
        self.known = Some((direction, side));
        Some(Segment { run: self.run, direction, side })
    }
}

/// Whether a line turns by less than a right angle from one segment to another.
pub(super) fn is_gentle(before: (i32, i32), after: (i32, i32)) -> bool {
    dot(before, after) > 0
}

fn dot((ax, ay): (i32, i32), (bx, by): (i32, i32)) -> i64 {
    i64::from(ax) * i64::from(bx) + i64::from(ay) * i64::from(by)
}

fn cross((ax, ay): (i32, i32), (bx, by): (i32, i32)) -> i64 {
    i64::from(ax) * i64::from(by) - i64::from(ay) * i64::from(bx)
}

/// Triangles about a point, each clockwise, drawn as one contour where they follow each other clockwise.
struct Fan<'p, P> {
    pen: &'p mut P,
    centre: Point2,
    last: Offset,
}

impl<'p, P: Pen> Fan<'p, P> {
    fn new(pen: &'p mut P, centre: Point2, first: Offset) -> Self {
        let mut fan = Self { pen, centre, last: first };
        fan.begin(first);
        fan
    }

    fn begin(&mut self, at: Offset) {
        self.pen.move_to(self.centre);
        self.pen.line_to(at.from(self.centre));
        self.last = at;
    }

    /// The next triangle. Rounding may turn a thin one over: then it becomes a contour of its own.
    fn go_to(&mut self, next: Offset) {
        let next = in_range(self.centre, next);
        if self.last.cross(next) >= 0 {
            self.pen.line_to(next.from(self.centre));
            self.last = next;
            return;
        }
        let last = self.last;
        self.pen.close();
        self.begin(next);
        self.pen.line_to(last.from(self.centre));
        self.pen.close();
        self.begin(next);
    }

    fn end_at(&mut self, last: Offset) {
        self.go_to(last);
        self.pen.close();
    }
}

/// The tip of a miter may lie farther out than edges can be walked.
fn in_range(centre: Point2, offset: Offset) -> Offset {
    let end = LIMIT.cast_signed() - 1;
    let clamp = |centre: i32, v: i32| centre.saturating_add(v).clamp(-end, end).saturating_sub(centre);
    Offset { x: clamp(centre.x.to_bits(), offset.x), y: clamp(centre.y.to_bits(), offset.y) }
}

#[cfg(test)]
mod tests {
    use core::fmt::Write;

    use super::*;

    #[test]
    fn the_turns_are_what_they_say() {
        for (power, (cosine, sine)) in (0_i32..).zip(TURNS) {
            let angle = core::f64::consts::TAU / (8.0 * 2_f64.sqrt().powi(power));
            for (got, exact) in [(cosine, angle.cos()), (sine, angle.sin())] {
                assert!((f64::from(got) / f64::from(ONE) - exact).abs() < 0.6 / f64::from(ONE), "{power}: {got}");
            }
        }
        assert_eq!([0, 6, 7, 16, u16::MAX].map(turn_for), [TURNS[0], TURNS[0], TURNS[1], TURNS[2], TURNS[14]]);
    }

    /// The contours, each begun by `m` and ended by `z`.
    #[derive(Default)]
    struct Contours(heapless::String<128>);

    impl Pen for Contours {
        fn move_to(&mut self, point: Point2) {
            self.0.push('m').expect("room");
            self.line_to(point);
        }

        fn line_to(&mut self, point: Point2) {
            write!(self.0, "{},{} ", point.x.to_bits(), point.y.to_bits()).expect("room");
        }

        fn close(&mut self) {
            self.0.push('z').expect("room");
        }
    }

    #[test]
    fn a_triangle_that_is_turned_over_becomes_a_clockwise_contour_of_its_own() {
        let mut contours = Contours::default();
        let mut fan = Fan::new(&mut contours, Point2::default(), Offset { x: 9, y: 0 });
        fan.go_to(Offset { x: 8, y: 3 });
        fan.go_to(Offset { x: 8, y: 2 });
        fan.end_at(Offset { x: 0, y: 9 });
        assert_eq!(contours.0, "m0,0 9,0 8,3 zm0,0 8,2 8,3 zm0,0 8,2 0,9 z");
    }

    #[test]
    fn ahead_the_gap_is_where_the_rounded_borders_leave_it() {
        let segment = |run, (x, y)| Segment { run, direction: Direction::EAST, side: Offset { x, y } };
        // Clockwise by next to nothing, but rounded the other way: the gap is on the right.
        let before = segment((1000, 0), (-1, 80));
        let right = Corner::between(Point2::default(), before, segment((1_000_000, 1), (0, 80))).expect("a gap");
        assert_eq!((right.from.y, right.to.y), (ONE, ONE));
        let left = Corner::between(Point2::default(), before, segment((1_000_000, 1), (-2, 80))).expect("a gap");
        assert_eq!((left.from.y, left.to.y), (-ONE, -ONE));
        assert!(Corner::between(Point2::default(), before, segment((1_000_000, 1), (-1, 80))).is_none());
    }

    #[test]
    fn the_smallest_turn_goes_half_around_in_fewer_steps_than_there_are() {
        let [.., (cosine, sine)] = TURNS;
        let steps = core::f64::consts::PI / f64::from(sine).atan2(f64::from(cosine));
        assert!(steps < 513.0 && MOST_STEPS >= 512, "{steps}");
    }
}
