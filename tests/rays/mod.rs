//! Rays cast in floating point: what the pipeline must show. Lecture 5.2.

use aquatint::{
    Illumination, Light, Point3,
    pipeline::{Camera, Instance, Scene},
};

/// A triangle in view space and its light.
pub struct Face {
    corners: [[f64; 3]; 3],
    light: Light,
}

/// What a ray tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seen {
    Nothing,
    Face(Light),
    Unsure,
}

/// The faces of a mesh whose normals are the same in all corners of a face.
pub fn faces(instance: &Instance, scene: &Scene) -> Vec<Face> {
    let lamp = scene.light.in_model_space(&instance.placement);
    let to_view = instance.placement.then(&scene.camera.view);
    let place = |position: [i16; 3]| {
        let [x, y, z] = position.map(|v| aquatint::Scalar::from_bits(i32::from(v) * 4));
        let p = to_view.transform_point(Point3::new(x, y, z));
        [p.x, p.y, p.z].map(|v| v.to_num())
    };
    let face = |triangle: [u16; 3]| Face {
        corners: triangle.map(|i| place(instance.mesh.positions()[usize::from(i)])),
        light: lamp.on_vertex([0; 3], instance.mesh.normals()[usize::from(triangle[0])]),
    };
    instance.mesh.triangles().map(face).collect()
}

/// What a pixel shows. Unsure when rays an eighth of a pixel apart do not agree.
pub fn seen(faces: &[Face], Scene { camera, .. }: &Scene, (x, y): (i32, i32)) -> Seen {
    let (x, y) = (f64::from(x) + 0.5, f64::from(y) + 0.5);
    let near = 0.125;
    let samples = [(0.0, 0.0), (-near, -near), (near, -near), (-near, near), (near, near)];
    let mut hits = samples.iter().map(|(dx, dy)| hit(faces, ray(camera, x + dx, y + dy)));
    let first = hits.next().unwrap_or(Seen::Unsure);
    if hits.all(|other| other == first) { first } else { Seen::Unsure }
}

/// The direction through a place on the screen, of length 1 along −z.
fn ray(camera: &Camera, x: f64, y: f64) -> [f64; 3] {
    let view = camera.viewport.rect();
    let across = |at: f64, from: i32, to: i32| 2.0 * (at - f64::from(from)) / f64::from(to - from) - 1.0;
    let focal = camera.projection.rows();
    [
        across(x, view.left, view.right) / focal[0][0].to_num::<f64>(),
        -across(y, view.top, view.bottom) / focal[1][1].to_num::<f64>(),
        -1.0,
    ]
}

/// The nearest front face between the near and the far plane of the tests. Unsure when another face
/// is almost as near.
fn hit(faces: &[Face], ray: [f64; 3]) -> Seen {
    let hits = faces.iter().filter_map(|face| Some((distance(&face.corners, ray)?, face.light)));
    let mut visible: Vec<_> = hits.filter(|(distance, _)| (0.5..64.0).contains(distance)).collect();
    visible.sort_by(|a, b| a.0.total_cmp(&b.0));
    // A step is 1/65535 of 0.5/w. Corners are rounded to 1/16 of a pixel, which moves a face that is
    // seen almost from its side by many steps: those of the tests by less than 32.
    let depth = |distance: f64| 65_535.0 * 0.5 / distance;
    match visible[..] {
        [(a, light), (b, other), ..] if light != other && depth(a) - depth(b) <= 32.0 => Seen::Unsure,
        [(_, light), ..] => Seen::Face(light),
        [] => Seen::Nothing,
    }
}

/// How far along the ray from the eye it strikes the front of a triangle.
fn distance([a, b, c]: &[[f64; 3]; 3], ray: [f64; 3]) -> Option<f64> {
    let minus = |p: &[f64; 3], q: &[f64; 3]| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    let normal = cross(minus(b, a), minus(c, a));
    let facing = dot(normal, ray);
    if facing >= 0.0 {
        return None;
    }
    // Inside when the ray passes all three edges on the same side.
    let inside = [(a, b), (b, c), (c, a)].iter().all(|(p, q)| dot(cross(**p, **q), ray) <= 0.0);
    inside.then(|| dot(normal, *a) / facing)
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
