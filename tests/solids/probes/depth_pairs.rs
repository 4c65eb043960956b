//! Walls one behind the other, and one through the other: no wrong pixel.

use crate::{
    modes::{Gouraud, Gouraud8, Gouraud32},
    probes::scaled,
    reference::float,
    renderer::{Picture, Renderer, Scene, VIEW, place, seen},
};

/// A wall that fills the view, so far away at its left and at its right end, with a normal of its own.
fn wall([left, right]: [f64; 2], normal: [i8; 3]) -> Scene {
    // All of what is seen at 16, and more.
    let corners = [(-24.0, -12.0, left), (24.0, -12.0, right), (24.0, 12.0, right), (-24.0, 12.0, left)];
    let positions = corners.map(|(x, y, distance)| place([x / 16.0, y / 16.0, -distance / 16.0]));
    let mut scene = Scene::new(&positions, &[[0, 1, 2], [0, 2, 3]], scaled(16.0), VIEW);
    // One of them is dark, as their texels are.
    let texel = if normal == NORMALS[0] { 0.75 } else { 0.25 };
    scene.uvs = vec![[texel + 1.0 / 128.0; 2]; 4];
    scene.with_normal(normal)
}

/// Pixels that show the wrong one of two walls, in the order in which they are drawn, where `is_judged`.
fn wrong<R: Renderer>(walls: &[Scene; 2], is_judged: impl Fn(usize) -> bool) -> usize {
    let (mut picture, reference) = (Picture::new(VIEW), seen(walls));
    let shown = |at: usize| usize::from(reference.seen[at].is_some_and(|seen| seen.triangle >= 2));
    assert!(walls[shown(0)].positions[0][2] >= walls[1 - shown(0)].positions[0][2], "the reference shows the nearer");
    R::draw(walls, &mut picture).expect("in range");
    let is_wrong = |&at: &usize| {
        let seen = reference.seen[at].expect("walls fill the view");
        // Almost as near, the other one may be seen.
        let is_resolved = seen.depth - seen.next_depth > R::RESOLVES;
        let light = picture.lights.shown[at].map_or(-1e9, |light| f64::from(light.0));
        let is_right = R::light(&seen).is_none_or(|[least, most]| (least - 60.0..=most + 60.0).contains(&light));
        is_judged(at) && is_resolved && !is_right
    };
    (0..reference.seen.len()).filter(is_wrong).count()
}

/// Towards the viewer, and to the right: lights that differ by a quarter.
const NORMALS: [[i8; 3]; 2] = [[0, 0, 127], [127, 0, 0]];

/// Walls that are parallel to the view, in both orders.
fn parallel([near, far]: [f64; 2]) -> [[Scene; 2]; 2] {
    let [first, second] = [wall([near; 2], NORMALS[0]), wall([far; 2], NORMALS[1])];
    [[first.clone(), second.clone()], [second, first]]
}

pub fn one_behind_the_other<R: Renderer>() {
    for [near, far] in [[4.0, 4.1], [4.0, 4.5], [10.0, 10.1], [10.0, 10.5], [15.0, 16.0]] {
        for walls in parallel([near, far]) {
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

/// The share of the pixels that show the wrong one of two walls when the farther is drawn first, and when it is drawn last.
fn shares<R: Renderer>(distances: [f64; 2]) -> [f64; 2] {
    let [near_first, far_first] = parallel(distances);
    // Whatever is said of close depths: the nearer wall is wanted.
    let wrong = |walls: [Scene; 2]| {
        let mut picture = Picture::new(VIEW);
        R::draw(&walls, &mut picture).expect("in range");
        let nearer = picture.lights.shown.iter().filter(|light| light.is_some_and(|light| light.0 > 43_000)).count();
        1.0 - float(nearer) / float(picture.lights.shown.len())
    };
    [wrong(far_first), wrong(near_first)]
}

/// What 8, 16 and 32 bits tell apart, between planes at 0.4 and at 20. Walls at one depth show the one that is drawn first.
#[test]
#[expect(clippy::float_cmp, reason = "shares of none and of all are exact")]
fn more_bits_tell_more_apart() {
    // A 256th: from a tenth of a unit at 3, a third at 6.
    assert_eq!(shares::<Gouraud8>([3.0, 3.15]), [0.0; 2]);
    assert_eq!(shares::<Gouraud8>([6.0, 6.6]), [0.0; 2]);
    assert_eq!(shares::<Gouraud8>([15.0, 15.2]), [1.0, 0.0]);
    // A 65536th: an 80th of a unit at 15.
    assert_eq!(shares::<Gouraud>([15.0, 15.02]), [0.0; 2]);
    assert_eq!(shares::<Gouraud>([15.0, 15.002]), [1.0, 0.0]);
    // All that is computed: places of the mesh are a thousandth of a unit apart here.
    for far in [15.01, 15.002, 15.001] {
        assert_eq!(shares::<Gouraud32>([15.0, far]), [0.0; 2], "{far}");
    }
}
