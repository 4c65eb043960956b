//! Closed meshes in random poses: no hole, no pixel twice, and depth and light as the reference has them.

use super::{
    Random,
    compare::{Judged, NEAR, assert_like},
    models::{self, Model},
    reference::Reference,
    renderer::{Picture, Renderer, Scene, VIEW, pose, seen},
};

/// Turned anyhow; near enough to be cut by the near plane, or far; partly beside the view.
pub fn random_pose(model: &Model, random: &mut Random) -> Scene {
    let mut within = |low: f64, high: f64| low + f64::from(random.below(1 << 16)) / 65_536.0 * (high - low);
    let distance = within(1.0, 9.0);
    let at = [within(-0.7, 0.7) * distance, within(-0.4, 0.4) * distance, -distance];
    let mut angle = || u16::try_from(random.below(1 << 16)).expect("16 bits");
    model.scene(pose([angle(), angle()], at), VIEW)
}

/// Many poses.
fn poses<R: Renderer>(model: &Model, count: u32, check: impl Fn(&Picture, &Reference)) -> Judged {
    let (mut random, mut judged) = (Random(count), Judged::default());
    for _ in 0..count {
        let scene = random_pose(model, &mut random);
        let (mut picture, reference) = (Picture::new(VIEW), seen(core::slice::from_ref(&scene)));
        R::draw(&[scene], &mut picture).expect("in range");
        judged.add(assert_like::<R>(&picture, &reference));
        check(&picture, &reference);
    }
    println!("{} × {count}: {judged:?}", model.name);
    judged
}

/// The front faces of a convex solid cover each pixel once.
pub fn cubes<R: Renderer>() {
    let judged = poses::<R>(&models::cube(), 1000, |picture, reference| {
        let once = picture.lights.writes.iter().all(|count| *count <= 1);
        assert!(once, "\n{}", picture.picture());
        let sure = |at: &usize| reference.border[*at] > NEAR;
        let layers = (0..reference.layers.len()).filter(sure).all(|at| reference.layers[at] <= 1);
        assert!(layers, "the reference, too");
    });
    assert!(judged.covered > 500_000 && judged.lights > 400_000, "{judged:?}");
}

pub fn tori<R: Renderer>() {
    let judged = poses::<R>(&models::torus(), 1000, |_, _| {});
    assert!(judged.covered > 300_000 && judged.lights > 100_000, "{judged:?}");
}

pub fn bunnies<R: Renderer>() {
    let judged = poses::<R>(&models::bunny(), 1000, |_, _| {});
    assert!(judged.covered > 300_000 && judged.lights > 100_000, "{judged:?}");
}
