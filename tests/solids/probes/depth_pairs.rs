//! Walls one behind the other, and one through the other: no wrong pixel.

use crate::{
    probes::scaled,
    renderer::{Picture, Renderer, Scene, VIEW, place, seen},
};

/// A wall that fills the view, so far away at its left and at its right end, with a normal of its own.
fn wall([left, right]: [f64; 2], normal: [i8; 3]) -> Scene {
    // All of what is seen at 16, and more.
    let corners = [(-24.0, -12.0, left), (24.0, -12.0, right), (24.0, 12.0, right), (-24.0, 12.0, left)];
    let positions = corners.map(|(x, y, distance)| place([x / 16.0, y / 16.0, -distance / 16.0]));
    let mut scene = Scene::new(&positions, &[[0, 1, 2], [0, 2, 3]], scaled(16.0), VIEW);
    scene.normals = vec![normal; 4];
    scene
}

/// Pixels that show the wrong one of two walls, in the order in which they are drawn, where `is_judged`.
fn wrong<R: Renderer>(walls: &[Scene; 2], is_judged: impl Fn(usize) -> bool) -> usize {
    let (mut picture, reference) = (Picture::new(VIEW), seen(walls));
    let shown = |at: usize| usize::from(reference.seen[at].is_some_and(|seen| seen.triangle >= 2));
    assert!(walls[shown(0)].positions[0][2] >= walls[1 - shown(0)].positions[0][2], "the reference shows the nearer");
    R::draw(walls, &mut picture).expect("in range");
    let is_wrong = |&at: &usize| {
        let seen = reference.seen[at].expect("walls fill the view");
        let ([least, most], _) = R::light(&seen);
        let light = picture.lights.shown[at].map_or(-1e9, |light| f64::from(light.0));
        is_judged(at) && !(least - 100.0..=most + 100.0).contains(&light)
    };
    (0..reference.seen.len()).filter(is_wrong).count()
}

/// Towards the viewer, and to the right: lights that differ by a quarter.
const NORMALS: [[i8; 3]; 2] = [[0, 0, 127], [127, 0, 0]];

pub fn one_behind_the_other<R: Renderer>() {
    for [near, far] in [[4.0, 4.1], [4.0, 4.5], [10.0, 10.1], [10.0, 10.5], [15.0, 16.0]] {
        let [first, second] = [wall([near; 2], NORMALS[0]), wall([far; 2], NORMALS[1])];
        for walls in [[first.clone(), second.clone()], [second, first]] {
            assert_eq!(wrong::<R>(&walls, |_| true), 0, "{near} and {far}");
        }
    }
}

/// The leaning wall is as far away as the other in the middle of the view.
pub fn one_through_the_other<R: Renderer>() {
    for [left, right] in [[9.0, 11.0], [8.0, 12.0], [11.0, 9.0], [9.5, 10.5]] {
        let [first, second] = [wall([10.0; 2], NORMALS[0]), wall([left, right], NORMALS[1])];
        for walls in [[first.clone(), second.clone()], [second, first]] {
            let beside = |at: usize| (at % 128).abs_diff(63).min((at % 128).abs_diff(64)) >= 1;
            assert_eq!(wrong::<R>(&walls, beside), 0, "{left} to {right}");
        }
    }
}
