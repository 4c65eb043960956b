//! Closed meshes in random poses: no hole, no pixel twice, and depth and light as the reference has them.

use super::{
    Random,
    compare::{Judged, NEAR},
    models::{self, Model},
    modes::{ALL, Mode},
    reference::Reference,
    renderer::{Picture, Scene, VIEW, pose, seen},
};

/// Turned anyhow; near enough to be cut by the near plane, or far; partly beside the view.
pub fn random_pose(model: &Model, random: &mut Random) -> Scene {
    let mut within = |low: f64, high: f64| low + f64::from(random.below(1 << 16)) / 65_536.0 * (high - low);
    let distance = within(1.0, 9.0);
    let at = [within(-0.7, 0.7) * distance, within(-0.4, 0.4) * distance, -distance];
    let mut angle = || u16::try_from(random.below(1 << 16)).expect("16 bits");
    model.scene(pose([angle(), angle()], at), VIEW)
}

/// Many poses, each in all of some modes.
fn poses(model: &Model, count: u32, all: &[Mode], check: impl Fn(&Picture, &Reference)) {
    let (mut random, mut judged) = (Random(count), vec![Judged::default(); all.len()]);
    for _ in 0..count {
        let scene = random_pose(model, &mut random);
        let reference = seen(core::slice::from_ref(&scene));
        for (mode, judged) in all.iter().zip(&mut judged) {
            let mut picture = Picture::new(VIEW);
            (mode.draw)(core::slice::from_ref(&scene), &mut picture).expect("in range");
            judged.add((mode.judge)(&picture, &reference));
            check(&picture, &reference);
        }
    }
    for (mode, judged) in all.iter().zip(judged) {
        println!("{} × {count}, {}: {judged:?}", model.name, mode.name);
        assert!(judged.covered > 300_000 && judged.lights > 100_000, "{judged:?}");
    }
}

/// The front faces of a convex solid cover each pixel once.
#[test]
fn cubes_in_a_thousand_poses() {
    poses(&models::cube(), 1000, &ALL, |picture, reference| {
        let once = picture.lights.writes.iter().all(|count| *count <= 1);
        assert!(once, "\n{}", picture.picture());
        let sure = |at: &usize| reference.border[*at] > NEAR;
        let layers = (0..reference.layers.len()).filter(sure).all(|at| reference.layers[at] <= 1);
        assert!(layers, "the reference, too");
    });
}

#[test]
fn tori_in_a_thousand_poses() {
    poses(&models::torus(), 1000, &ALL[..ALL.len() - 1], |_, _| {});
}

#[test]
fn bunnies_in_a_thousand_poses() {
    poses(&models::bunny(), 1000, &ALL[..ALL.len() - 1], |_, _| {});
}
