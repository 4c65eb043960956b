//! A picture against the reference.
//!
//! The statement: corners are rounded to sixteenths of a pixel, so edges are within [`NEAR`] of their places. A pixel whose
//! centre is farther from all edges is covered, or not, as the reference says; and where it is farther from the edges
//! of all faces, its depth and its light are those of a place within that distance: what corners carry is
//! linear, so that moving corners moves no value farther.

use super::{
    reference::Reference,
    renderer::{Picture, Renderer},
};

/// Pixels.
pub const NEAR: f64 = 0.125;

/// How much depth is rounded, of 65535.
const DEPTH_UNITS: f64 = 2.0;

/// How much light is rounded, of 65535: the cosine has 14 bits.
pub const LIGHT_UNITS: f64 = 40.0;

/// How many pixels could be judged.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Judged {
    pub pixels: usize,
    pub covered: usize,
    pub depths: usize,
    pub lights: usize,
}

impl Judged {
    pub fn add(&mut self, other: Self) {
        self.pixels += other.pixels;
        self.covered += other.covered;
        self.depths += other.depths;
        self.lights += other.lights;
    }
}

/// Panics where a picture is not what the reference says.
pub fn assert_like<R: Renderer>(picture: &Picture, reference: &Reference) -> Judged {
    let mut judged = Judged::default();
    for at in 0..reference.seen.len() {
        judge::<R>(picture, reference, at, &mut judged);
    }
    judged
}

fn judge<R: Renderer>(picture: &Picture, reference: &Reference, at: usize, judged: &mut Judged) {
    let place = || format!("pixel {}, {}", at % reference.view.width, at / reference.view.width);
    if reference.border[at] <= NEAR {
        return;
    }
    let (drawn, seen) = (picture.lights.shown[at], reference.seen[at]);
    // In the last depth before the far plane nothing is seen: with 8 bits of it that counts.
    if R::HAS_DEPTH && seen.is_some_and(|seen| seen.depth < R::RESOLVES + seen.slopes[0] * NEAR) {
        return;
    }
    assert_eq!(drawn.is_some(), seen.is_some(), "{} of\n{}", place(), picture.picture());
    judged.pixels += 1;
    let (Some(drawn), Some(seen)) = (drawn, seen) else { return };
    judged.covered += 1;
    if reference.edge[at] <= NEAR {
        return;
    }
    let depth_error = (picture.depths[at] - seen.depth).abs();
    let most = seen.slopes[0] * NEAR + R::RESOLVES.max(DEPTH_UNITS / 65_535.0);
    assert!(depth_error <= most || !R::HAS_DEPTH, "{}: depth {} for {}", place(), picture.depths[at], seen.depth);
    judged.depths += 1;
    // Almost as near, the other surface may be seen.
    if seen.next_depth >= seen.depth - 2.0 * most {
        return;
    }
    let Some([least, most]) = R::light(&seen) else { return };
    let light = f64::from(drawn.0);
    assert!((least..=most).contains(&light), "{}: light {light} for {least}..{most}, {seen:?}", place());
    judged.lights += 1;
}
