//! Two triangles that share an edge, which planes cut: still each pixel once.

use crate::{
    Random,
    compare::NEAR,
    probes::{one_by_one, scaled},
    renderer::{Renderer, Scene, VIEW, place, seen},
};

/// Quads around the eye, often far beside the view, cut along a diagonal, from both sides.
pub fn cut_edges<R: Renderer>() {
    let (mut random, mut inner) = (Random(7), 0);
    for size in [4.0, 8.0, 30.0].into_iter().cycle().take(4500) {
        let mut within = |most: f64| (f64::from(random.below(1 << 16)) / 32_768.0 - 1.0) * most;
        // Through the eye plane, and through those beside the view, which is up to 40 wide at the far end.
        let corners = [(); 4].map(|()| place([within(size), within(size), within(15.0) - 5.0].map(|v| v / 16.0)));
        for triangles in [[[0, 1, 2], [0, 2, 3]], [[0, 2, 1], [0, 3, 2]]] {
            let scene = Scene::new(&corners, &triangles, scaled(16.0), VIEW);
            inner += joined::<R>(&scene);
        }
    }
    println!("{inner} pixels beside shared edges");
    assert!(inner > 2_000, "{inner}");
}

/// Where the reference has two faces or none, each pixel is drawn as often, but for those near the borders. Gives the
/// number of pixels near inner edges.
fn joined<R: Renderer>(scene: &Scene) -> usize {
    let reference = seen(core::slice::from_ref(scene));
    let picture = one_by_one::<R>(scene);
    let mut inner = 0;
    for at in 0..reference.layers.len() {
        // In the last depth before the far plane nothing is seen: with 8 bits of it that counts.
        let is_deep = reference.seen[at].is_some_and(|seen| seen.depth < R::RESOLVES + 0.1 * seen.slopes[0]);
        let is_inner = reference.border[at] > NEAR && reference.layers[at] > 0 && !is_deep;
        if is_inner {
            assert_eq!(picture.lights.writes[at], 1, "{scene:?}\n{}", picture.picture());
        }
        assert!(picture.lights.writes[at] <= 1, "{scene:?}\n{}", picture.picture());
        inner += usize::from(is_inner && reference.edge[at] <= NEAR);
    }
    inner
}
