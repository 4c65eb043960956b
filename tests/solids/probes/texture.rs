//! A wall that recedes, with a texture: how many pixels show the right texel.
//!
//! The wall of the benches: depth 2 at the left end, 6 at the right, filling the view; u = (depth − 2)/4, and v from the
//! top to the bottom of the right end, over a texture of 64 × 64.

use aquatint::{Rect, Scalar};

use crate::{
    probes::scaled,
    reference::{Reference, float},
    renderer::{Scene, number, place, seen},
};

/// Texels of the texture across and down.
const TEXELS: f64 = 64.0;

pub const SMALL: Rect = Rect::new(0, 0, 128, 64);
pub const LARGE: Rect = Rect::new(0, 0, 400, 240);

/// The wall in a view.
pub fn receding_wall(view: Rect) -> Scene {
    let aspect = f64::from(view.width()) / f64::from(view.height());
    let corner = |side: f64, up: f64, depth: f64| {
        let [x, y] = [side * 0.998 * depth * aspect / 2.0, up * 0.998 * depth / 2.0];
        (place([x, y, -depth].map(|v| v / 8.0)), [(depth - 2.0) / 4.0, 0.5 - y / 5.988])
    };
    let corners = [corner(-1.0, -1.0, 2.0), corner(1.0, -1.0, 6.0), corner(1.0, 1.0, 6.0), corner(-1.0, 1.0, 2.0)];
    let mut scene = Scene::new(&corners.map(|(place, _)| place), &[[0, 1, 2], [0, 2, 3]], scaled(8.0), view);
    scene.uvs = corners.map(|(_, uv)| uv).to_vec();
    scene
}

/// The texel at a place of the texture.
pub fn texel(uv: [f64; 2]) -> [f64; 2] {
    uv.map(|v| (v * TEXELS).floor().clamp(0.0, TEXELS - 1.0))
}

/// The share of the covered pixels whose texels are within one of the right ones, both ways.
pub fn share(reference: &Reference, texels: impl Fn(usize) -> Option<[f64; 2]>) -> f64 {
    let covered = || (0..reference.seen.len()).filter_map(|at| Some((at, reference.seen[at]?)));
    let is_right = |(at, right): (usize, [f64; 2])| {
        texels(at).is_some_and(|[u, v]| (u - right[0]).abs() <= 1.0 && (v - right[1]).abs() <= 1.0)
    };
    let right = covered().filter(|(at, seen)| is_right((*at, texel(seen.uv)))).count();
    float(right) / float(covered().count())
}

/// The texel that a ray through the centre of a pixel strikes, by the equation of the wall.
fn by_ray(view: Rect, at: usize) -> [f64; 2] {
    let (width, height) = (view.width() as usize, view.height() as usize);
    let aspect = float(width) / float(height);
    let x = 2.0 * (float(at % width) + 0.5) / float(width) - 1.0;
    let y = 1.0 - 2.0 * (float(at / width) + 0.5) / float(height);
    // From (left, 2) to (right, 6), seen from above; the ray goes along (x · aspect/2, 1).
    let (left, right) = (-0.998 * aspect, 2.994 * aspect);
    let depth = (2.0 * right - 6.0 * left) / ((right - left) - x * aspect / 2.0 * 4.0);
    texel([(depth - 2.0) / 4.0, 0.5 - y * depth / 2.0 / 5.988])
}

/// What the reference says is what rays strike.
#[test]
fn the_reference_has_the_texels_that_rays_strike() {
    for view in [SMALL, LARGE] {
        let reference = seen(&[receding_wall(view)]);
        let right = share(&reference, |at| Some(by_ray(view, at)));
        assert!(right > 0.999_9, "{right}");
    }
}

/// A texture that is linear on the screen, as cheap renderers have it, would be found out.
#[test]
fn a_texture_without_perspective_fails() {
    for view in [SMALL, LARGE] {
        let reference = seen(&[receding_wall(view)]);
        let width = view.width() as usize;
        let across = |at: usize| (float(at % width) + 0.5) / float(width);
        let right = share(&reference, |at| Some(texel([across(at), texel(reference.seen[at]?.uv)[1] / TEXELS])));
        assert!(right < 0.5, "{right}");
        // A gap of an eighth of the width counts, too.
        let right = share(&reference, |at| (at % 8 > 0).then(|| by_ray(view, at)));
        assert!(right < 0.88, "{right}");
    }
}

/// Places of the texture are exact in our numbers.
#[test]
fn the_wall_is_where_it_should_be() {
    let scene = receding_wall(SMALL);
    let ends = [scene.positions[0], scene.positions[1]].map(|[_, _, z]| Scalar::from_bits(i32::from(z) * 4));
    assert_eq!(ends, [number(-0.25), number(-0.75)]);
}
