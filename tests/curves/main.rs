//! Circles, ellipses, arcs, curves and paths, against embedded-graphics and against slow, exact oracles.

#[path = "../exact/mod.rs"]
mod exact;

mod arcs;
mod beziers;
mod paths;
mod pictures;
mod recorder;
mod whole_pixels;

/// How far a point is from a straight edge.
fn distance([x, y]: [f64; 2], [[ax, ay], [bx, by]]: [[f64; 2]; 2]) -> f64 {
    let (dx, dy) = (bx - ax, by - ay);
    let square = dx * dx + dy * dy;
    let along = if square == 0.0 { 0.0 } else { (((x - ax) * dx + (y - ay) * dy) / square).clamp(0.0, 1.0) };
    (ax + along * dx - x).hypot(ay + along * dy - y)
}
