//! The ideal stroke in floating point: strips, joins and caps, each a convex polygon.

use aquatint::{Cap, Join, Point2, Stroke};

type Vector = (f64, f64);

fn minus(a: Vector, b: Vector) -> Vector {
    (a.0 - b.0, a.1 - b.1)
}

/// `a + f · b`
fn plus(a: Vector, f: f64, b: Vector) -> Vector {
    (a.0 + f * b.0, a.1 + f * b.1)
}

fn dot(a: Vector, b: Vector) -> f64 {
    a.0 * b.0 + a.1 * b.1
}

fn cross(a: Vector, b: Vector) -> f64 {
    a.0 * b.1 - a.1 * b.0
}

/// A convex piece of the ideal stroke; its corners in any direction.
#[derive(Clone, Debug)]
struct Piece(Vec<Vector>);

impl Piece {
    /// How deep inside a point is; outside the negative distance.
    fn depth(&self, p: Vector) -> f64 {
        let sides: Vec<_> = self.0.iter().zip(self.0.iter().cycle().skip(1)).collect();
        let area: f64 = sides.iter().map(|&(&a, &b)| cross(minus(a, self.0[0]), minus(b, self.0[0]))).sum();
        let nearest = sides.iter().map(|&(&a, &b)| distance(p, a, b)).fold(f64::INFINITY, f64::min);
        let is_left = |a: Vector, b: Vector| area.signum() * cross(minus(b, a), minus(p, a)) >= 0.0;
        let is_inside = area.abs() > 1e-6 && sides.iter().all(|&(&a, &b)| is_left(a, b));
        if is_inside { nearest } else { -nearest }
    }
}

/// From a point to a segment.
fn distance(p: Vector, a: Vector, b: Vector) -> f64 {
    let (d, from) = (minus(b, a), minus(p, a));
    let along = if dot(d, d) == 0.0 { 0.0 } else { (dot(from, d) / dot(d, d)).clamp(0.0, 1.0) };
    let off = plus(from, -along, d);
    off.0.hypot(off.1)
}

/// The part of a disc from one radius to another, less than or just half of it.
fn sector(centre: Vector, from: Vector, to: Vector) -> Piece {
    let half_turn = cross(from, to).atan2(dot(from, to));
    let steps = 64;
    let arc = (0..=steps).map(|step| {
        let (sine, cosine) = (half_turn * f64::from(step) / f64::from(steps)).sin_cos();
        plus(plus(centre, cosine, from), sine, (-from.1, from.0))
    });
    Piece(std::iter::once(centre).chain(arc).collect())
}

/// The pieces of a stroke, and which lie side by side.
#[derive(Debug, Default)]
pub struct Ideal {
    pieces: Vec<Piece>,
    neighbours: Vec<Vec<usize>>,
    /// The stroke cannot be told from another one within the precision of floating point.
    pub is_ambiguous: bool,
}

impl Ideal {
    fn push(&mut self, piece: Piece) -> usize {
        self.pieces.push(piece);
        self.pieces.len() - 1
    }

    pub fn of(points: &[Point2], is_closed: bool, stroke: Stroke) -> Self {
        let mut ideal = Self::default();
        let half = f64::from(stroke.width.to_bits()) / 2.0;
        let mut points: Vec<Vector> =
            points.iter().map(|p| (f64::from(p.x.to_bits()), f64::from(p.y.to_bits()))).collect();
        points.dedup();
        while is_closed && points.len() > 1 && points.first() == points.last() {
            points.pop();
        }
        let Some(&first) = points.first() else { return ideal };
        if points.len() == 1 {
            ideal.cap(first, (half, 0.0), stroke.cap);
            ideal.cap(first, (-half, 0.0), stroke.cap);
            return ideal;
        }
        if is_closed {
            points.push(first);
        }
        // Along each segment, half the width long.
        let ahead: Vec<Vector> = points
            .windows(2)
            .map(|ends| {
                let d = minus(ends[1], ends[0]);
                plus((0.0, 0.0), half / d.0.hypot(d.1), d)
            })
            .collect();
        let strips: Vec<usize> = points
            .windows(2)
            .zip(&ahead)
            .map(|(ends, &(x, y))| {
                let n = (-y, x);
                ideal.push(Piece(vec![
                    plus(ends[0], 1.0, n),
                    plus(ends[1], 1.0, n),
                    plus(ends[1], -1.0, n),
                    plus(ends[0], -1.0, n),
                ]))
            })
            .collect();
        for corner in 1..points.len() {
            let next = corner % ahead.len();
            if corner == ahead.len() && !is_closed {
                continue;
            }
            let joined = ideal.join(points[corner], (ahead[corner - 1], ahead[next]), stroke.join);
            let (one, other) = (strips[corner - 1], strips[next]);
            ideal.neighbours.extend([vec![one, joined], vec![joined, other]]);
            if dot(ahead[corner - 1], ahead[next]) > 0.0 {
                ideal.neighbours.push(vec![one, joined, other]);
            }
        }
        if !is_closed {
            let (last, end) = (ahead.len() - 1, points[points.len() - 1]);
            let caps = [
                (strips[0], ideal.cap(first, plus((0.0, 0.0), -1.0, ahead[0]), stroke.cap)),
                (strips[last], ideal.cap(end, ahead[last], stroke.cap)),
            ];
            ideal.neighbours.extend(caps.into_iter().filter_map(|(strip, cap)| Some(vec![strip, cap?])));
        }
        ideal
    }

    fn cap(&mut self, at: Vector, ahead: Vector, cap: Cap) -> Option<usize> {
        let n = (-ahead.1, ahead.0);
        let (left, right) = (plus(at, 1.0, n), plus(at, -1.0, n));
        match cap {
            Cap::Butt => None,
            Cap::Round => {
                let [one, other] = [n, (-n.0, -n.1)].map(|side| sector(at, ahead, side));
                let (one, other) = (self.push(one), self.push(other));
                self.neighbours.push(vec![one, other]);
                Some(one)
            }
            Cap::Square => Some(self.push(Piece(vec![left, plus(left, 1.0, ahead), plus(right, 1.0, ahead), right]))),
        }
    }

    fn join(&mut self, at: Vector, (before, after): (Vector, Vector), join: Join) -> usize {
        let half_square = dot(before, before);
        let outside = |a: Vector| if cross(before, after) >= 0.0 { (a.1, -a.0) } else { (-a.1, a.0) };
        let (from, to) = (outside(before), outside(after));
        let (one, other) = (plus(at, 1.0, from), plus(at, 1.0, to));
        let cosine = dot(before, after) / half_square;
        match join {
            Join::Round if cosine < -0.999_999_9 => {
                let [one, other] = [from, to].map(|side| sector(at, before, side));
                let (one, other) = (self.push(one), self.push(other));
                self.neighbours.push(vec![one, other]);
                one
            }
            Join::Round => self.push(sector(at, from, to)),
            Join::Miter { limit } => {
                let excess = f64::from(limit).powi(2) * (1.0 + cosine) - 2.0;
                self.is_ambiguous |= excess.abs() < 1e-6;
                let tip = plus(at, 1.0 / (1.0 + cosine), plus(from, 1.0, to));
                self.push(if excess > 0.0 { Piece(vec![at, one, tip, other]) } else { Piece(vec![at, one, other]) })
            }
            Join::Bevel => self.push(Piece(vec![at, one, other])),
        }
    }

    /// How deep in one of the pieces a point is; outside of all the negative distance.
    pub fn depth(&self, p: Vector) -> f64 {
        self.pieces.iter().map(|piece| piece.depth(p)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Whether a disc about a point lies in pieces side by side.
    pub fn is_in_neighbours(&self, p: Vector, radius: f64) -> bool {
        let rim = (0..24).map(|step| (f64::from(step) * std::f64::consts::TAU / 24.0).sin_cos());
        let rim: Vec<_> = rim.map(|at| plus(p, radius, at)).chain([p]).collect();
        self.neighbours
            .iter()
            .any(|pieces| rim.iter().all(|&at| pieces.iter().any(|&piece| self.pieces[piece].depth(at) >= 0.0)))
    }
}
