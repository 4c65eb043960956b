//! A wall that recedes, with a texture: how many pixels show the right texel.
//!
//! The wall of the benches: depth 2 at the left end, 6 at the right, filling the view; u = (depth − 2)/4, and v from the
//! top to the bottom of the right end, over a texture of 64 × 64.

use aquatint::{
    Light, Rect, Scalar,
    fragment::{
        shade::{self, Unlit},
        texture::{ClampToEdge, LightTexture, Sampler},
    },
};

use crate::{
    probes::scaled,
    reference::{Seen, float},
    renderer::{Picture, Scene, draw_with, number, place, seen},
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

/// Somebody who draws textures.
pub trait Textured {
    /// The texel that each pixel of a scene shows, if it shows one.
    fn texels(scene: &Scene) -> Vec<Option<[f64; 2]>>;
}

/// The share of the pixels of the wall whose texels are within one of the right ones, both ways.
pub fn share<T: Textured>(view: Rect) -> f64 {
    let scene = receding_wall(view);
    let reference = seen(core::slice::from_ref(&scene));
    let is_right = |got: &Option<[f64; 2]>, seen: &Option<Seen>| {
        let both = got.zip(seen.map(|seen| texel(seen.uv)));
        both.is_some_and(|([u, v], [right_u, right_v])| (u - right_u).abs() <= 1.0 && (v - right_v).abs() <= 1.0)
    };
    let right = T::texels(&scene).iter().zip(&reference.seen).filter(|(got, seen)| is_right(got, seen)).count();
    let covered = reference.seen.iter().flatten().count();
    assert_eq!(covered, reference.seen.len(), "the wall fills the view");
    float(right) / float(covered)
}

/// 99 of 100 pixels, in the small view and in the large one.
pub fn is_in_perspective<T: Textured>() {
    for view in [SMALL, LARGE] {
        let share = share::<T>(view);
        println!("{} × {}: {:.3} % of the texels are right", view.width(), view.height(), share * 100.0);
        assert!(share >= 0.99, "{share}");
    }
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

fn each_pixel(view: Rect, texel: impl Fn(usize) -> Option<[f64; 2]>) -> Vec<Option<[f64; 2]>> {
    (0..view.width() as usize * view.height() as usize).map(texel).collect()
}

/// What rays strike.
enum Rays {}

impl Textured for Rays {
    fn texels(scene: &Scene) -> Vec<Option<[f64; 2]>> {
        let view = scene.camera.viewport.rect();
        each_pixel(view, |at| Some(by_ray(view, at)))
    }
}

/// Linear on the screen, from left to right, as cheap renderers have it.
enum Linear {}

impl Textured for Linear {
    fn texels(scene: &Scene) -> Vec<Option<[f64; 2]>> {
        let view = scene.camera.viewport.rect();
        let across = |at: usize| (float(at % view.width() as usize) + 0.5) / f64::from(view.width());
        each_pixel(view, |at| Some([(across(at) * TEXELS).floor(), by_ray(view, at)[1]]))
    }
}

/// Right, with a gap of a pixel in eight.
enum Gaps {}

impl Textured for Gaps {
    fn texels(scene: &Scene) -> Vec<Option<[f64; 2]>> {
        let view = scene.camera.viewport.rect();
        each_pixel(view, |at| (at % 8 > 0).then(|| by_ray(view, at)))
    }
}

#[test]
fn the_reference_has_the_texels_that_rays_strike() {
    is_in_perspective::<Rays>();
    assert!(share::<Rays>(SMALL) > 0.999_9 && share::<Rays>(LARGE) > 0.999_9);
}

#[test]
fn a_texture_without_perspective_or_with_gaps_is_found_out() {
    for view in [SMALL, LARGE] {
        assert!(share::<Linear>(view) < 0.5 && share::<Gaps>(view) < 0.88);
    }
}

/// Ours: the number of the texel is its light, one coordinate at a time.
struct Ours;

/// A texture whose texels are as bright as their number along one axis.
fn numbers(axis: usize) -> Vec<Light> {
    let number = |at: usize| Light(u16::try_from([at % 64, at / 64][axis]).expect("small"));
    (0..64 * 64).map(number).collect()
}

impl Textured for Ours {
    fn texels(scene: &Scene) -> Vec<Option<[f64; 2]>> {
        let along = |axis: usize| {
            let texels = numbers(axis);
            let texture = LightTexture::new(&texels, 64, 64).expect("a texture");
            let shading = shade::Textured::new(Sampler::new(texture).with_wrap(ClampToEdge), Unlit);
            let mut picture = Picture::new(scene.camera.viewport.rect());
            draw_with::<u16, _>(core::slice::from_ref(scene), &mut picture, shading, false).expect("in range");
            picture.lights.shown
        };
        let both = along(0).into_iter().zip(along(1));
        both.map(|(u, v)| Some([u?, v?].map(|light| f64::from(light.0)))).collect()
    }
}

#[test]
fn our_wall_is_in_perspective() {
    is_in_perspective::<Ours>();
}

/// A wall of so many copies of the texture across, or a floor; how much of it is within a texel, in copies of the texture too.
fn share_of(scene: &Scene) -> f64 {
    let reference = seen(core::slice::from_ref(scene));
    // The texel is told without its copy.
    let along = |axis: usize| {
        let texels = numbers(axis);
        let texture = LightTexture::new(&texels, 64, 64).expect("a texture");
        let shading = shade::Textured::new(Sampler::new(texture), Unlit);
        let mut picture = Picture::new(scene.camera.viewport.rect());
        draw_with::<u16, _>(core::slice::from_ref(scene), &mut picture, shading, false).expect("in range");
        picture.lights.shown
    };
    let (mut right, mut covered) = (0, 0);
    for ((u, v), seen) in along(0).into_iter().zip(along(1)).zip(&reference.seen) {
        let (Some(u), Some(v), Some(seen)) = (u, v, seen) else { continue };
        let is_near = |light: Light, uv: f64| {
            let off = (f64::from(light.0) - (uv * TEXELS).floor()).rem_euclid(TEXELS);
            off <= 1.0 || off >= TEXELS - 1.0
        };
        covered += 1;
        right += usize::from(is_near(u, seen.uv[0]) && is_near(v, seen.uv[1]));
    }
    assert!(covered > reference.seen.len() / 4, "{covered}");
    float(right) / float(covered)
}

/// Eight copies of the texture across the wall: 512 texels.
#[test]
fn a_wall_of_eight_copies() {
    for (view, least) in [(SMALL, 0.5), (LARGE, 0.9)] {
        let mut scene = receding_wall(view);
        scene.uvs.iter_mut().for_each(|uv| uv[0] = uv[0] * 8.0 - 4.0);
        let share = share_of(&scene);
        println!("{} × {}, 8 copies: {:.3} %", view.width(), view.height(), share * 100.0);
        assert!(share >= least, "{share}");
    }
}

/// A floor that is 30 times as far at its far end, and a wall beside the viewer of that depth.
#[test]
fn a_steep_floor_and_a_steep_wall() {
    for view in [SMALL, LARGE] {
        let aspect = f64::from(view.width()) / f64::from(view.height());
        let floor = [(-1.0, 15.0), (1.0, 15.0), (1.0, 0.5), (-1.0, 0.5)]
            .map(|(side, depth)| ([side * 4.0 * aspect, -0.25, -depth], [side / 2.0 + 0.5, (15.0 - depth) / 14.5]));
        let wall = [(-1.0, 0.5), (-1.0, 15.0), (1.0, 15.0), (1.0, 0.5)]
            .map(|(up, depth)| ([-0.25 * aspect, up * 2.0, -depth], [(15.0 - depth) / 14.5, up / 2.0 + 0.5]));
        for (name, corners) in [("floor", floor), ("wall", wall)] {
            let positions = corners.map(|(at, _)| place(at.map(|v| v / 16.0)));
            let mut scene = Scene::new(&positions, &[[0, 1, 2], [0, 2, 3], [0, 2, 1], [0, 3, 2]], scaled(16.0), view);
            scene.uvs = corners.map(|(_, uv)| uv).to_vec();
            let share = share_of(&scene);
            println!("{} × {}, {name}: {:.3} %", view.width(), view.height(), share * 100.0);
            assert!(share >= 0.5, "{share}");
        }
    }
}

/// Places of the texture are exact in our numbers.
#[test]
fn the_wall_is_where_it_should_be() {
    let scene = receding_wall(SMALL);
    let ends = [scene.positions[0], scene.positions[1]].map(|[_, _, z]| Scalar::from_bits(i32::from(z) * 4));
    assert_eq!(ends, [number(-0.25), number(-0.75)]);
}
