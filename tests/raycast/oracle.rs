//! Shapes and rays in doubles.

use aquatint::{Point3, Scalar, Vector3, World};

pub type V = [f64; 3];

pub fn of_point(p: Point3<World>) -> V {
    [p.x, p.y, p.z].map(Scalar::to_num)
}

pub fn of_vector(v: Vector3<World>) -> V {
    [v.x, v.y, v.z].map(Scalar::to_num)
}

pub fn minus(a: V, b: V) -> V {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn along(origin: V, t: f64, direction: V) -> V {
    [0, 1, 2].map(|axis| origin[axis] + t * direction[axis])
}

pub fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: V, b: V) -> V {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub fn length(v: V) -> f64 {
    dot(v, v).sqrt()
}

pub fn unit(v: V) -> V {
    let length = length(v);
    v.map(|v| v / length)
}

/// What a ray of length 1 may hit: distances from the least to the most, or surely nothing; `is_sure` if it must hit.
#[derive(Clone, Copy, Debug)]
pub struct Expected {
    pub distances: Option<[f64; 2]>,
    pub is_sure: bool,
}

impl Expected {
    pub const NOTHING: Self = Self { distances: None, is_sure: true };

    pub fn about(distance: f64, error: f64) -> Self {
        Self { distances: Some([distance - error, distance + error]), is_sure: true }
    }
}

/// The sphere's radius may seem to be off by so much, and so may sides of triangles.
pub const SIDEWAYS: f64 = 1.0 / (1 << 19) as f64;
/// So much may a distance be off.
pub const ALONG: f64 = 1.0 / (1 << 15) as f64;

pub fn sphere(center: V, radius: f64, origin: V, direction: V) -> Expected {
    let to_center = minus(center, origin);
    let (foot, across) = (dot(to_center, direction), length(cross(to_center, direction)));
    let half = |radius: f64| (radius * radius - across * across).max(0.0).sqrt();
    let (least, most) = (half(radius - SIDEWAYS), half(radius + SIDEWAYS));
    if across > radius + SIDEWAYS || foot + most < 0.0 {
        return Expected::NOTHING;
    }
    let is_outside = length(to_center) > radius + ALONG;
    let is_inside = length(to_center) < radius - ALONG;
    let distances = match (is_outside, is_inside) {
        (true, _) => [foot - most, foot - least],
        (_, true) => [foot + least, foot + most],
        _ => [foot - most, foot + most],
    };
    let [nearest, farthest] = distances;
    Expected {
        distances: Some([nearest - ALONG, farthest + ALONG]),
        is_sure: across < radius - SIDEWAYS && (is_outside || is_inside) && (foot - most > 0.0 || is_inside),
    }
}

pub fn plane(point: V, normal: V, origin: V, direction: V) -> Expected {
    let (way, step) = (dot(minus(point, origin), normal), dot(direction, normal));
    let distance = way / step;
    let hit = along(origin, distance, direction);
    let farthest = hit.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    if step == 0.0 || distance < -ALONG || farthest > 64.0 + ALONG {
        return Expected::NOTHING;
    }
    Expected { is_sure: distance > ALONG && farthest < 64.0 - ALONG, ..Expected::about(distance, ALONG) }
}

pub fn block(min: V, max: V, origin: V, direction: V) -> Expected {
    let (mut entry, mut exit) = (f64::NEG_INFINITY, f64::INFINITY);
    for axis in 0..3 {
        let ends = [min[axis] - origin[axis], max[axis] - origin[axis]];
        if direction[axis] == 0.0 {
            if ends[0] > 0.0 || ends[1] < 0.0 {
                return Expected::NOTHING;
            }
            continue;
        }
        let [a, b] = ends.map(|end| end / direction[axis]);
        (entry, exit) = (entry.max(a.min(b)), exit.min(a.max(b)));
    }
    if entry > exit + 1e-9 || exit < -1e-9 {
        return Expected::NOTHING;
    }
    let is_sure = entry < exit - 1e-9 && exit > ALONG && entry.abs() > ALONG;
    let distance = if entry > 0.0 { entry } else { exit };
    let doubtful = Expected { distances: Some([entry.max(0.0) - ALONG, exit + ALONG]), is_sure };
    if is_sure { Expected { is_sure, ..Expected::about(distance, ALONG) } } else { doubtful }
}

/// The corners may seem to be off sideways, which counts along the ray the more the flatter it strikes.
pub fn triangle(corners: [V; 3], origin: V, direction: V) -> Expected {
    let [a, b, c] = corners.map(|corner| minus(corner, origin));
    let normal = cross(minus(b, a), minus(c, a));
    let cosine = (dot(normal, direction) / length(normal)).abs();
    // How far inside of each side, seen along the ray; of both orientations the one that is farther in.
    let side = |a: V, b: V| dot(cross(a, b), direction) / length(cross(minus(b, a), direction));
    let sides = [side(a, b), side(b, c), side(c, a)];
    let inside = |sign: f64| sides.iter().fold(f64::INFINITY, |least: f64, v| least.min(sign * v));
    let inside = inside(1.0).max(inside(-1.0));
    let distance = dot(normal, a) / dot(normal, direction);
    if cosine < 1e-3 {
        return Expected { distances: Some([0.0, 512.0]), is_sure: false };
    }
    let error = ALONG + SIDEWAYS / cosine;
    if inside < -SIDEWAYS || distance < -error {
        return Expected::NOTHING;
    }
    Expected { is_sure: inside > SIDEWAYS && distance > error, ..Expected::about(distance, error) }
}
