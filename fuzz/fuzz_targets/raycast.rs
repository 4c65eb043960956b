//! Rays at shapes of any numbers: no panic, a hierarchy finds what a list finds, and bands have the pixels of the whole.
#![no_main]

use aquatint::{
    Frame, Light, Matrix, Point3, Rect, Scalar, Vector3, View, Window, Words, World,
    geometry::{light::Lamp, viewport::Viewport},
    hidden::raycast::{Block, Hierarchy, Node, Objects, Plane, Ray, Shape, Sphere, Triangle},
    pipeline::{Camera, Finish, PixelRays, Raycast, draw_rays},
};
use arbitrary::Arbitrary;
use libfuzzer_sys::fuzz_target;

/// A number in 2⁻¹⁶, of any size or one of a scene.
#[derive(Arbitrary, Clone, Copy, Debug)]
enum Number {
    Any(i32),
    Near(i16),
    Whole(i8),
}

type Place = [Number; 3];

#[derive(Arbitrary, Clone, Copy, Debug)]
enum Thing {
    Sphere(Place, Number),
    Plane(Place, Place),
    Triangle([Place; 3]),
    Block(Place, Place),
}

#[derive(Arbitrary, Debug)]
struct Input {
    things: Vec<Thing>,
    rays: Vec<(Place, Place)>,
    view: [[Number; 4]; 3],
    projection: [[i32; 4]; 4],
    corner: (u8, u8),
    lamp: (Place, u16, u16),
    finishes: Vec<(u16, u16)>,
    background: u16,
    cut: u8,
}

fn scalar(number: Number) -> Scalar {
    Scalar::from_bits(match number {
        Number::Any(bits) => bits,
        Number::Near(bits) => i32::from(bits) * 16,
        Number::Whole(whole) => i32::from(whole) << 15,
    })
}

fn point(place: Place) -> Point3<World> {
    let [x, y, z] = place.map(scalar);
    Point3::new(x, y, z)
}

fn vector(way: Place) -> Vector3<World> {
    let [x, y, z] = way.map(scalar);
    Vector3::new(x, y, z)
}

fn shape(thing: &Thing) -> Option<Shape> {
    match *thing {
        Thing::Sphere(center, radius) => Sphere::new(point(center), scalar(radius)).ok().map(Shape::Sphere),
        Thing::Plane(place, normal) => Plane::new(point(place), vector(normal)).ok().map(Shape::Plane),
        Thing::Triangle(corners) => Triangle::new(corners.map(point)).ok().map(Shape::Triangle),
        Thing::Block(corner, opposite) => Block::new(point(corner), point(opposite)).ok().map(Shape::Block),
    }
}

fuzz_target!(|input: Input| {
    let shapes: Vec<_> = input.things.iter().take(40).filter_map(shape).collect();
    let mut nodes = vec![Node::default(); 2 * shapes.len()];
    let tree = Hierarchy::new(&shapes, &mut nodes).expect("two for each");
    for &(from, to) in input.rays.iter().take(8) {
        for ray in [Ray::new(point(from), vector(to)), Ray::between(point(from), point(to))].into_iter().flatten() {
            let hit = shapes.nearest(&ray);
            assert_eq!(tree.nearest(&ray), hit);
            assert_eq!(tree.is_hit(&ray), hit.is_some());
            if let Some(hit) = hit {
                let mirrored = ray.reflected(&hit);
                assert_eq!(tree.nearest(&mirrored), shapes.nearest(&mirrored));
                let shadow = hit.towards(vector(to));
                assert_eq!(tree.is_hit(&shadow), shapes.is_hit(&shadow));
            }
        }
    }
    draw(&input, tree);
});

/// The whole picture, and two bands of it.
fn draw(input: &Input, objects: Hierarchy<'_>) {
    // The target is at the origin; the view may begin before it, so that directions are anywhere.
    let (left, top) = (-i32::from(input.corner.0), -i32::from(input.corner.1));
    let [x, y, z] = input.view.map(|row| row.map(scalar));
    let nil = Scalar::ZERO;
    let mut projection = input.projection.map(|row| row.map(Scalar::from_bits));
    for row in [0, 1, 3] {
        projection[row][3] = nil;
    }
    let camera = Camera {
        view: Matrix::<World, View>::from_rows([x, y, z, [nil, nil, nil, Scalar::ONE]]),
        projection: Matrix::from_rows(projection),
        viewport: Viewport::new(Rect::new(left, top, 12, 8)).expect("in range"),
    };
    let Ok(rays) = PixelRays::new(&camera) else { return };
    let finishes: Vec<_> = input.finishes.iter().map(|&(diffuse, mirror)| Finish { diffuse, mirror }).collect();
    let (direction, ambient, diffuse) = input.lamp;
    let lamp = Lamp { direction: vector(direction), ambient: Light(ambient), diffuse: Light(diffuse) };
    let scene = Raycast { objects, finishes: &finishes, lamp, background: Light(input.background) };
    let rows = |top: i32, height: u32| {
        let mut frame = Frame::<Light, Words, _>::new(vec![0; 12 * 8 * 2], 12, height).expect("large enough");
        draw_rays(&scene, &rays, &mut Window::band(&mut frame, top)).expect("in memory");
        frame.bytes().to_vec()
    };
    let cut = u32::from(input.cut) % 7 + 1;
    let mut bands = rows(0, cut);
    bands.extend(rows(cut.cast_signed(), 8 - cut));
    assert_eq!(rows(0, 8), bands);
}
