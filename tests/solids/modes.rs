//! The fill modes, and what light is expected of each.

use core::convert::Infallible;

use aquatint::{
    Light,
    fragment::{
        shade::{self, Corner, Shading, Textured, Unlit},
        texture::{LightTexture, Sampler},
    },
    hidden,
    pipeline::DrawError,
};

use super::{
    compare::{Judged, LIGHT_UNITS, NEAR, assert_like},
    reference::{Reference, Seen},
    renderer::{DIFFUSE, Picture, Renderer, Scene, draw_hidden, draw_with, lambert, length, unit},
};

pub type Drawn = Result<(), DrawError<Infallible>>;

/// A fill mode as a value.
#[derive(Clone, Copy)]
pub struct Mode {
    pub name: &'static str,
    pub draw: fn(&[Scene], &mut Picture) -> Drawn,
    pub judge: fn(&Picture, &Reference) -> Judged,
}

impl Mode {
    const fn of<R: Renderer>(name: &'static str) -> Self {
        Self { name, draw: R::draw, judge: assert_like::<R> }
    }
}

/// All of them; the last one is for convex solids.
pub const ALL: [Mode; 11] = [
    Mode::of::<Gouraud>("Gouraud"),
    Mode::of::<Gouraud8>("Gouraud, 8 bits of depth"),
    Mode::of::<Gouraud32>("Gouraud, 32 bits of depth"),
    Mode::of::<FlatByFace>("flat by face"),
    Mode::of::<FlatByCorners>("flat by corners"),
    Mode::of::<Phong>("Phong"),
    Mode::of::<UnlitTexture>("textured"),
    Mode::of::<LitTexture>("textured in light"),
    Mode::of::<Affine>("affine"),
    Mode::of::<Negative>("shader"),
    Mode::of::<Convex>("convex"),
];

/// Light at the vertices, linear on the screen between them.
pub enum Gouraud {}

impl Renderer for Gouraud {
    fn draw(scenes: &[Scene], picture: &mut Picture) -> Drawn {
        draw_with::<u16, _>(scenes, picture, shade::Gouraud, false)
    }

    fn light(seen: &Seen) -> Option<[f64; 2]> {
        let off = seen.slopes[1] * NEAR + LIGHT_UNITS;
        Some([seen.light[0] - off, seen.light[1] + off])
    }
}

/// The same with depths of 8 bits: what is apart by less than a 256th is not told apart.
pub enum Gouraud8 {}

impl Renderer for Gouraud8 {
    const RESOLVES: f64 = 1.0 / 256.0 + 2.0 / 65_535.0;

    fn draw(scenes: &[Scene], picture: &mut Picture) -> Drawn {
        draw_with::<u8, _>(scenes, picture, shade::Gouraud, false)
    }

    fn light(seen: &Seen) -> Option<[f64; 2]> {
        Gouraud::light(seen)
    }
}

/// The same with depths of 32 bits, of which 24 count at the corners.
pub enum Gouraud32 {}

impl Renderer for Gouraud32 {
    const RESOLVES: f64 = 4.0 / 16_777_216.0;

    fn draw(scenes: &[Scene], picture: &mut Picture) -> Drawn {
        draw_with::<u32, _>(scenes, picture, shade::Gouraud, false)
    }

    fn light(seen: &Seen) -> Option<[f64; 2]> {
        Gouraud::light(seen)
    }
}

/// The same without depths.
pub enum Convex {}

impl Renderer for Convex {
    const HAS_DEPTH: bool = false;

    fn draw(scenes: &[Scene], picture: &mut Picture) -> Drawn {
        draw_hidden(scenes, (picture, &mut hidden::convex::Convex), shade::Gouraud, false)
    }

    fn light(seen: &Seen) -> Option<[f64; 2]> {
        Gouraud::light(seen)
    }
}

/// One light a face, by its normal.
pub enum FlatByFace {}

impl Renderer for FlatByFace {
    fn draw(scenes: &[Scene], picture: &mut Picture) -> Drawn {
        draw_with::<u16, _>(scenes, picture, shade::Flat, true)
    }

    fn light(seen: &Seen) -> Option<[f64; 2]> {
        Some([seen.flat[0] - LIGHT_UNITS, seen.flat[0] + LIGHT_UNITS])
    }
}

/// One light a face, by the normals of its corners.
pub enum FlatByCorners {}

impl Renderer for FlatByCorners {
    fn draw(scenes: &[Scene], picture: &mut Picture) -> Drawn {
        draw_with::<u16, _>(scenes, picture, shade::Flat, false)
    }

    fn light(seen: &Seen) -> Option<[f64; 2]> {
        Some([seen.flat[1] - LIGHT_UNITS, seen.flat[1] + LIGHT_UNITS])
    }
}

/// The light of a normal that is linear on the screen.
pub enum Phong {}

/// What normals are rounded to, of their length of 1: to 7 bits 16-bit numbers, which stay between their corners.
const NORMAL_UNITS: f64 = 1.0 / 16_384.0;

impl Renderer for Phong {
    fn draw(scenes: &[Scene], picture: &mut Picture) -> Drawn {
        draw_with::<u16, _>(scenes, picture, shade::Phong, false)
    }

    /// A normal that is off by some part of its length turns by as much, and light changes by no more than the lamp times that.
    fn light(seen: &Seen) -> Option<[f64; 2]> {
        let mixed = |weights: [f64; 3]| -> [f64; 3] {
            let along = |axis: usize| weights.iter().zip(&seen.corner_normals).map(|(w, n)| w * n[axis]).sum();
            [0, 1, 2].map(along)
        };
        if !seen.is_whole {
            return Some(among(&seen.corner_normals));
        }
        let normal = mixed(seen.linear);
        let [across, down] = seen.linear_slopes.map(mixed).map(|change| length(&change));
        let off = across.hypot(down) * NEAR + NORMAL_UNITS;
        let least = length(&normal) - off;
        let turned = DIFFUSE * off / least + LIGHT_UNITS;
        let light = lambert(unit(normal));
        (least > 0.0).then_some([light - turned, light + turned])
    }
}

/// The least and the most light of a normal between three: of so many of them that the lights between are within a
/// step of these.
fn among(normals: &[[f64; 3]; 3]) -> [f64; 2] {
    const STEPS: i32 = 16;
    let (mut least, mut most) = (f64::MAX, f64::MIN);
    for (i, j) in (0..=STEPS).flat_map(|i| (0..=STEPS - i).map(move |j| (i, j))) {
        let weights = [i, j, STEPS - i - j].map(|v| f64::from(v) / f64::from(STEPS));
        let along = |axis: usize| weights.iter().zip(normals).map(|(w, n)| w * n[axis]).sum();
        let light = lambert(unit([0, 1, 2].map(along)));
        (least, most) = (least.min(light), most.max(light));
    }
    let step = (most - least) / f64::from(STEPS) + LIGHT_UNITS;
    [least - step, most + step]
}

/// A texture of 64 × 64 texels, each brighter than those on its left and above by a step.
static STEPS: [Light; 64 * 64] = {
    let (mut lights, mut at, mut row) = ([Light::BLACK; 64 * 64], 0, 0_u16);
    while row < 64 {
        let mut column = 0;
        while column < 64 {
            lights[at] = Light(STEP * (column + row));
            column += 1;
            at += 1;
        }
        row += 1;
    }
    lights
};

const STEP: u16 = 512;

pub fn steps() -> Sampler<LightTexture<'static>> {
    Sampler::new(LightTexture::new(&STEPS, 64, 64).expect("a texture"))
}

/// The lights of the texels around a place; none where some of them are of another copy of the texture.
fn texels(uv: [[f64; 2]; 2], off: [f64; 2]) -> Option<[f64; 2]> {
    let texel = |v: f64| (v * 64.0).floor();
    let least = [0, 1].map(|axis| texel(uv[0][axis].min(uv[1][axis]) - off[axis]));
    let most = [0, 1].map(|axis| texel(uv[0][axis].max(uv[1][axis]) + off[axis]));
    let copy = |texels: [f64; 2]| texels.map(|texel| (texel / 64.0).floor());
    let light = |[u, v]: [f64; 2]| f64::from(STEP) * (u.rem_euclid(64.0) + v.rem_euclid(64.0));
    let is_one_copy = copy(least).into_iter().zip(copy(most)).all(|(least, most)| (least - most).abs() < 0.5);
    is_one_copy.then(|| [light(least), light(most)])
}

/// How far off texture coordinates are at most in our numbers: a sixteenth of a texel of 64.
const UV_UNITS: f64 = 1.0 / 1_024.0;

/// A texture as it is, right in perspective: between the divisions, on a straight way.
pub enum UnlitTexture {}

impl Renderer for UnlitTexture {
    fn draw(scenes: &[Scene], picture: &mut Picture) -> Drawn {
        draw_with::<u16, _>(scenes, picture, Textured::new(steps(), Unlit), false)
    }

    /// By one division, or on the way between two.
    fn light(seen: &Seen) -> Option<[f64; 2]> {
        let [chord, off] = seen.chord?;
        texels([chord, seen.uv], off.map(|v| v + UV_UNITS))
    }
}

/// A texture in light.
pub enum LitTexture {}

impl Renderer for LitTexture {
    fn draw(scenes: &[Scene], picture: &mut Picture) -> Drawn {
        draw_with::<u16, _>(scenes, picture, Textured::new(steps(), shade::Gouraud), false)
    }

    fn light(seen: &Seen) -> Option<[f64; 2]> {
        Some(product(UnlitTexture::light(seen)?, Gouraud::light(seen)?))
    }
}

fn product(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0].max(0.0) * b[0].max(0.0) / 65_536.0 - 1.0, a[1] * b[1] / 65_535.0 + 1.0]
}

/// A texture without perspective, in light.
pub enum Affine {}

impl Renderer for Affine {
    fn draw(scenes: &[Scene], picture: &mut Picture) -> Drawn {
        draw_with::<u16, _>(scenes, picture, Textured::new(steps(), shade::Gouraud).affine(), false)
    }

    fn light(seen: &Seen) -> Option<[f64; 2]> {
        let axes = [0, 1];
        let along = |weights: [f64; 3], axis: usize| -> f64 {
            weights.iter().zip(&seen.corner_uvs).map(|(weight, uv)| weight * uv[axis]).sum()
        };
        let texels = if seen.is_whole {
            let uv = axes.map(|axis| along(seen.linear, axis));
            let [across, down] = seen.linear_slopes;
            texels([uv; 2], axes.map(|axis| along(across, axis).hypot(along(down, axis)) * NEAR + UV_UNITS))
        } else {
            // What is cut is between the corners.
            let [a, b, c] = seen.corner_uvs;
            let least = axes.map(|axis| a[axis].min(b[axis]).min(c[axis]));
            let most = axes.map(|axis| a[axis].max(b[axis]).max(c[axis]));
            texels([least, most], [UV_UNITS; 2])
        };
        Some(product(texels?, Gouraud::light(seen)?))
    }
}

/// A user's own: dark where Gouraud shading is bright.
pub enum Negative {}

/// Carries light and texture coordinates.
fn negative() -> impl Shading<Color = Light> + Copy {
    let corner = |corner: &Corner| {
        let [u, v] = corner.uv.map(i16::cast_unsigned);
        [u, corner.light.0, v]
    };
    shade::Shader::new(corner, |[_, light, _]: [u16; 3]| Some(Light(u16::MAX - light)))
}

impl Renderer for Negative {
    fn draw(scenes: &[Scene], picture: &mut Picture) -> Drawn {
        draw_with::<u16, _>(scenes, picture, negative(), false)
    }

    fn light(seen: &Seen) -> Option<[f64; 2]> {
        Gouraud::light(seen).map(|[least, most]| [65_535.0 - most, 65_535.0 - least])
    }
}
