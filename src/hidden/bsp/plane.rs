//! The planes of triangles, exact.

use crate::{
    num::Scalar,
    space::{Model, Point4},
};

/// Bits of fraction that places of pieces have more than vertices: 2.22 numbers.
pub(super) const FINER: u32 = 8;

/// The plane of a triangle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plane {
    /// Twice the area long, in units of vertices squared: less than 2³³.
    normal: [i64; 3],
    /// One of its corners, 2.14.
    place: [i64; 3],
}

impl Plane {
    /// Its front is the side from which the corners run counter-clockwise. `None` for a triangle without area.
    pub(super) const fn new([a, b, c]: [[i16; 3]; 3]) -> Option<Self> {
        let [[px, py, pz], [qx, qy, qz]] = [way(a, b), way(a, c)];
        let normal = [py * qz - pz * qy, pz * qx - px * qz, px * qy - py * qx];
        let [x, y, z] = normal;
        if x == 0 && y == 0 && z == 0 { None } else { Some(Self { normal, place: widened(a) }) }
    }

    /// The distance of a vertex, positive in front, times the length of the normal: less than 2⁵¹.
    #[inline]
    pub(crate) const fn of_vertex(&self, vertex: [i16; 3]) -> i64 {
        let ([a, b, c], [x, y, z], [px, py, pz]) = (self.normal, widened(vertex), self.place);
        a * (x - px) + b * (y - py) + c * (z - pz)
    }

    /// The same of a place of a piece, a 2.22 number: less than 2⁵⁹.
    pub(super) const fn of_place(&self, [x, y, z]: [i64; 3]) -> i64 {
        let ([a, b, c], [px, py, pz]) = (self.normal, finer(self.place));
        a * (x - px) + b * (y - py) + c * (z - pz)
    }

    /// What is added to a distance at most when each coordinate of a place changes by one.
    pub(super) const fn steepest(&self) -> i64 {
        let [a, b, c] = self.normal;
        a.abs() + b.abs() + c.abs()
    }

    /// The same of a point, 16.16: less than 2⁶⁹.
    pub(crate) fn of_point(&self, point: [i32; 3]) -> i128 {
        let ([a, b, c], [px, py, pz], [x, y, z]) = (self.normal, self.place, point.map(i64::from));
        let way = [x - (px << 2), y - (py << 2), z - (pz << 2)];
        let is_near = |way: i64| way.unsigned_abs() < 1 << 28;
        let [x, y, z] = way;
        if is_near(x) && is_near(y) && is_near(z) {
            // Closer than 4096: three short products.
            return i128::from(a * x + b * y + c * z);
        }
        i128::from(a) * i128::from(x) + i128::from(b) * i128::from(y) + i128::from(c) * i128::from(z)
    }

    /// Whether an eye sees the front of the plane, or is in it.
    pub(super) fn faces(&self, eye: &Point4<Model>) -> bool {
        let point = [eye.x, eye.y, eye.z].map(Scalar::to_bits);
        if eye.w == Scalar::ONE {
            return self.of_point(point) >= 0;
        }
        // A point over `w`; without one, a direction. All times 2¹⁴ and `w`.
        let w = i128::from(eye.w.to_bits());
        let products = self.normal.iter().zip(self.place).zip(point);
        let sum: i128 = products.map(|((&n, p), e)| i128::from(n) * ((i128::from(e) << 14) - i128::from(p) * w)).sum();
        if w < 0 { sum <= 0 } else { sum >= 0 }
    }
}

const fn way([x, y, z]: [i16; 3], [to_x, to_y, to_z]: [i16; 3]) -> [i64; 3] {
    [to_x as i64 - x as i64, to_y as i64 - y as i64, to_z as i64 - z as i64]
}

const fn widened([x, y, z]: [i16; 3]) -> [i64; 3] {
    [x as i64, y as i64, z as i64]
}

const fn finer([x, y, z]: [i64; 3]) -> [i64; 3] {
    [x << FINER, y << FINER, z << FINER]
}

/// A vertex as a place of a piece.
pub(super) const fn place_of(vertex: [i16; 3]) -> [i64; 3] {
    finer(widened(vertex))
}
