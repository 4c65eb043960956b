//! Fog over faces and lines, in floating point.

use super::*;
use aquatint::{
    Fog,
    fragment::shade::{Fogged, Gouraud, Unlit},
    geometry::face::Faces,
};
use proptest::prelude::*;

const VIEW: Rect = Rect::new(0, 0, 64, 48);

fn dusk() -> Fog {
    Fog::linear(number(2.25), number(4.0), Light(10_000)).expect("it grows")
}

/// What `dusk` leaves of white, where a part of the light is hidden.
fn left(part: f64) -> f64 {
    65_535.0 + (10_000.0 - 65_535.0) * part
}

fn part(w: f64) -> f64 {
    ((w - 2.25) / 1.75).clamp(0.0, 1.0)
}

/// Weights of the corners of a triangle at the centre of a pixel.
fn weights([a, b, c]: [[f64; 3]; 3], (x, y): (i32, i32)) -> [f64; 3] {
    let p = [f64::from(x) + 0.5, f64::from(y) + 0.5, 0.0];
    let area = |a: [f64; 3], b: [f64; 3], c: [f64; 3]| (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
    [area(p, b, c), area(a, p, c), area(a, b, p)].map(|part| part / area(a, b, c))
}

const TRIANGLE: Mesh = match Mesh::new(
    &[[-14_000, -9_000, 9_000], [14_000, -9_000, 9_000], [2_000, 12_000, -16_000]],
    &[[0, 0, 127]; 3],
    &[[0, 1, 2]],
) {
    Ok(mesh) => mesh,
    Err(_) => panic!(),
};

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]
    #[test]
    fn faces_have_the_fog_of_their_corners(y in -60..60_i32, x in -60..60_i32) {
        let scene = scene(VIEW);
        let mut material = Material::new(Fogged::new(Unlit, dusk()));
        material.faces = Faces::Both;
        let instance = Instance::new(TRIANGLE, pose(y, x)).with_material(material);
        let corners: [_; 3] = projected(&instance, &scene).try_into().expect("three");
        let canvas = faces(&instance, &scene, VIEW);
        let size = corners[0][0] * (corners[1][1] - corners[2][1]) + corners[1][0] * (corners[2][1] - corners[0][1])
            + corners[2][0] * (corners[0][1] - corners[1][1]);
        // Seen almost from its side, rounded corners are too much of it.
        prop_assume!(size.abs() > 200.0);
        for at in canvas.places() {
            let Some(Light(light)) = canvas.at(at.0, at.1) else { continue };
            let exact = left(weights(corners, at).iter().zip(corners).map(|(weight, [_, _, w])| weight * part(w)).sum());
            prop_assert!((f64::from(light) - exact).abs() < 900.0, "{:?}: {} for {}", at, light, exact);
        }
    }

    #[test]
    fn lines_have_the_fog_of_their_ends(y in -80..80_i32, x in -80..80_i32) {
        let scene = scene(VIEW);
        let mut material = Material::new(Fogged::new(Unlit, dusk()));
        material.faces = Faces::Both;
        let instance = Instance::new(TRIANGLE, pose(y, x)).with_material(material);
        let [a, b, c] = projected(&instance, &scene).try_into().expect("three");
        prop_assume!(![[a, b], [b, c], [c, a]].into_iter().any(lines::is_diagonal));
        let canvas = edges(&instance, &scene, VIEW);
        for at in canvas.places() {
            let Some(Light(light)) = canvas.at(at.0, at.1) else { continue };
            let error = |ends: [[f64; 3]; 2]| {
                lines::aside(ends, at).filter(|&aside| aside <= 0.64)?;
                let ((way, length), [from, to]) = (lines::along(ends, at), ends.map(|[_, _, w]| left(part(w))));
                Some((f64::from(light) - from - (to - from) * way).abs() - (to - from).abs() / (2.5 * length.max(0.5)))
            };
            let error = [[a, b], [b, c], [c, a]].into_iter().filter_map(error).fold(f64::MAX, f64::min);
            prop_assert!(error < 8.0, "{:?}: {} too far off", at, error);
        }
    }
}

#[test]
fn corners_that_clipping_makes_have_the_fog_of_their_own_distance() {
    // A floor from behind the eye into the fog. Were the fog that of the corners behind the eye, which is none, and cut with
    // the floor, a third of it would lie on the near plane, and 36,000 would be the most that is seen.
    let positions =
        [[-32_000, -3_000, 32_000], [32_000, -3_000, 32_000], [32_000, -3_000, -32_000], [-32_000, -3_000, -32_000]];
    let mesh = Mesh::new(&positions, &[[0, 127, 0]; 4], &[[0, 1, 2], [0, 2, 3]]).expect("fits");
    let fog = Fog::linear(number(1.0), number(7.0), Light::BLACK).expect("it grows");
    let placement = Matrix::scale(number(2.0));
    let floor = Instance::new(mesh, placement).with_material(Material::new(Fogged::new(Unlit, fog)));
    let mut scene = scene(VIEW);
    scene.camera.view = Matrix::translation(number(0.0), number(-0.2), number(-2.0));
    let canvas = faces(&floor, &scene, VIEW);
    let row = |y: i32| canvas.at(32, y).map(|Light(light)| light);
    let seen: Vec<_> = (0..48).filter_map(row).collect();
    assert!(seen.len() > 15);
    // The far border is at a distance of 5.9.
    assert!(seen[0] < 20_000, "{seen:?}");
    assert!(*seen.last().expect("some") > 40_000, "{seen:?}");
    assert!(seen.is_sorted(), "{seen:?}");
}

#[test]
fn without_fog_between_the_light_is_as_before() {
    let far = Fog::linear(number(7.0), number(8.0), Light::WHITE).expect("it grows");
    let cube = Instance::new(SQUARES, turned(30.0, 25.0));
    let fogged = cube.with_material(Material::new(Fogged::new(Gouraud, far)));
    let scene = scene(VIEW);
    assert_eq!(faces(&fogged, &scene, VIEW), faces(&cube, &scene, VIEW));
    assert_eq!(edges(&fogged, &scene, VIEW), edges(&cube, &scene, VIEW));
}
