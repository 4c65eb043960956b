//! Numbers, places, and the scene that the pictures show.

use aquatint::{
    Angle, Clip, Light, Matrix, Point3, Rect, Scalar, Vector3, View, World,
    geometry::{light::Lamp, projection::Lens, viewport::Viewport},
    hidden::raycast::{Block, Plane, Shape, Sphere, Triangle},
    pipeline::{Camera, Finish, Raycast},
};

pub fn number(value: f64) -> Scalar {
    Scalar::saturating_from_num(value)
}

pub fn point(place: [f64; 3]) -> Point3<World> {
    let [x, y, z] = place.map(number);
    Point3::new(x, y, z)
}

pub fn vector(way: [f64; 3]) -> Vector3<World> {
    let [x, y, z] = way.map(number);
    Vector3::new(x, y, z)
}

pub fn sphere(center: [f64; 3], radius: f64) -> Shape {
    Shape::Sphere(Sphere::new(point(center), number(radius)).expect("in range"))
}

pub fn block(corner: [f64; 3], opposite: [f64; 3]) -> Shape {
    Shape::Block(Block::new(point(corner), point(opposite)).expect("in range"))
}

pub fn plane(place: [f64; 3], normal: [f64; 3]) -> Shape {
    Shape::Plane(Plane::new(point(place), vector(normal)).expect("in range"))
}

pub fn triangle(corners: [[f64; 3]; 3]) -> Shape {
    Shape::Triangle(Triangle::new(corners.map(point)).expect("in range"))
}

pub fn perspective(degrees: f64, view: Rect) -> Matrix<View, Clip> {
    let aspect = number(f64::from(view.width()) / f64::from(view.height()));
    let field_of_view = Angle::from_degrees(degrees as f32);
    Matrix::perspective(Lens { field_of_view, aspect, near: number(0.5), far: number(64.0) }).expect("a lens")
}

/// From a place towards another.
pub fn camera(eye: [f64; 3], centre: [f64; 3], view: Rect) -> Camera {
    Camera {
        view: Matrix::look_at(point(eye), point(centre), vector([0.0, 1.0, 0.0])).expect("apart"),
        projection: perspective(50.0, view),
        viewport: Viewport::new(view).expect("a viewport"),
    }
}

pub const LAMP: Lamp = Lamp {
    direction: Vector3::new(Scalar::lit("-2"), Scalar::lit("4"), Scalar::lit("2.5")),
    ambient: Light(7_000),
    diffuse: Light(50_000),
};

/// On a floor: a ball that is a mirror, a matte one, a box and a triangle.
pub fn still_life() -> [Shape; 5] {
    [
        plane([0.0, -1.0, 0.0], [0.0, 1.0, 0.0]),
        sphere([0.25, 0.0, 0.0], 1.0),
        sphere([-1.5, -0.5, 1.25], 0.5),
        block([1.75, -1.0, -0.5], [2.75, 0.75, 0.5]),
        triangle([[-3.25, -1.0, -1.0], [-1.5, -1.0, -2.0], [-2.5, 1.75, -1.75]]),
    ]
}

pub const FINISHES: [Finish; 5] = [
    Finish { diffuse: 50_000, mirror: 0 },
    Finish::MIRROR,
    Finish::MATTE,
    Finish { diffuse: 56_000, mirror: 0 },
    Finish { diffuse: 60_000, mirror: 0 },
];

pub fn scene<O>(objects: O) -> Raycast<'static, O> {
    Raycast { objects, finishes: &FINISHES, lamp: LAMP, background: Light(8_000) }
}
