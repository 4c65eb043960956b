//! Triangles that reach before the near plane, to the eye and behind it.

use crate::{
    Random,
    compare::{Judged, assert_like},
    probes::scaled,
    renderer::{Picture, Renderer, Scene, VIEW, place, seen},
};

/// A triangle, and the same from behind: one of them is seen.
fn both_sides(corners: [[f64; 3]; 3]) -> Scene {
    let positions = corners.map(|corner| place(corner.map(|v| v / 8.0)));
    let mut scene = Scene::new(&positions, &[[0, 1, 2], [0, 2, 1]], scaled(8.0), VIEW);
    scene.normals = vec![[0, 0, 127], [127, 0, 0], [0, -127, 0]];
    scene.face_normals = vec![[0, 127, 0], [90, 0, 90]];
    scene.uvs = vec![[0.2, 0.3], [0.8, 0.1], [0.5, 0.9]];
    scene
}

/// Compares. Says how many pixels were drawn, and how many the reference has.
fn drawn<R: Renderer>(scene: Scene) -> ([usize; 2], Judged) {
    let (mut picture, reference) = (Picture::new(VIEW), seen(core::slice::from_ref(&scene)));
    R::draw(&[scene], &mut picture).expect("in range");
    let judged = assert_like::<R>(&picture, &reference);
    ([picture.drawn(), reference.seen.iter().flatten().count()], judged)
}

/// Three that are seen, and three that are not.
pub fn six_cases<R: Renderer>() {
    let cases = [
        ("a floor, one corner behind the eye", [[-3.0, -1.0, -6.0], [3.0, -1.0, -6.0], [0.0, -1.0, 2.0]], true),
        ("a floor, two corners behind the eye", [[0.0, -1.0, -8.0], [-4.0, -1.0, 3.0], [4.0, -1.0, 2.0]], true),
        ("a wall, one corner behind the eye", [[-2.0, -1.0, 1.0], [4.0, -1.0, -8.0], [1.0, 2.0, -5.0]], true),
        ("a corner on the near plane", [[0.0, -0.0625, -0.4], [-2.0, -1.0, -5.0], [2.0, 1.0, -6.0]], true),
        ("a corner at the eye", [[0.0, 0.0, 0.0], [-2.0, -1.0, -5.0], [2.0, -1.0, -6.0]], false),
        ("all corners behind the eye", [[-1.0, -1.0, 1.0], [1.0, -1.0, 2.0], [0.0, 1.0, 3.0]], false),
    ];
    for (name, corners, is_seen) in cases {
        let ([drawn, expected], judged) = drawn::<R>(both_sides(corners));
        println!("{name}: {drawn} pixels of {expected}, {judged:?}");
        // Those whose centres an edge almost passes through may be either.
        assert!(drawn.abs_diff(expected) <= 8, "{name}: {drawn} pixels, not {expected}");
        assert_eq!(expected > 0, is_seen, "{name}");
    }
}

/// Corners all around the eye, many of them behind it.
pub fn anywhere<R: Renderer>() {
    let (mut random, mut sum) = (Random(6), Judged::default());
    for _ in 0..3000 {
        let mut within = || f64::from(random.below(1 << 16)) / 4_096.0 - 8.0;
        let corners = [(); 3].map(|()| [within(), within(), within() - 4.0]);
        sum.add(drawn::<R>(both_sides(corners)).1);
    }
    println!("{sum:?}");
    assert!(sum.covered > 500_000 && sum.pixels > 20_000_000, "{sum:?}");
}
