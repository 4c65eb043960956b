//! Attributes in perspective against doubles, and the same values whatever part of a triangle is drawn.

use aquatint::{
    Illumination, Light, Matrix, Model, Rect, World,
    fragment::shade::{Corner, Facet, Gouraud, Perspective, Placed, Shading},
    geometry::face::Faces,
    hidden::{convex::Convex, depth::DepthBuffer},
    pipeline::{Instance, Material, MeshVertex, Scene, Workspace, draw_mesh},
};
use proptest::prelude::*;

use crate::common::{Canvas, Shape, camera_scene, number, place};

/// What arrives at a pixel, in units of a texture coordinate: 64 are a texel of 64.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Arrived {
    got: [f64; 2],
    exact: [f64; 2],
    /// On the straight way between the ends of its block of eight, if both are in front of the eye.
    chord: Option<[f64; 2]>,
    /// How much an error of a corner counts at the ends of the block.
    spread: f64,
}

/// Shows texture coordinates instead of a colour.
#[derive(Clone, Copy)]
struct Places;

struct Face {
    plane: Perspective<2>,
    placed: [Placed<[u16; 2]>; 3],
}

impl Shading for Places {
    type Attributes = [u16; 2];
    type Face = Face;
    type Color = Arrived;
    const NEEDS_W: bool = true;

    fn corner(&self, corner: &Corner) -> [u16; 2] {
        corner.uv.map(|v| v.cast_unsigned() ^ 0x8000)
    }

    fn face<I: Illumination>(&self, _: &I, facet: &Facet<'_, [u16; 2]>) -> Face {
        Face { plane: Perspective::new(facet.slopes, facet.placed), placed: *facet.placed }
    }

    fn colors<I: Illumination>(
        &self,
        _: &I,
        face: &Face,
        (row, column): (i32, i32),
    ) -> impl Iterator<Item = Option<Arrived>> {
        let run = face.plane.at(row, column).zip(column..);
        run.map(move |(values, column)| {
            let got = values.map(|value| f64::from(value) / 32_768.0);
            Some(face.arrived(got, row, column))
        })
    }
}

impl Face {
    /// What the corners weigh at the centre of a pixel, linear on the screen.
    fn weights(&self, row: i32, column: i32) -> [f64; 3] {
        let [a, b, c] = self.placed.map(|corner| [corner.position.x, corner.position.y].map(|v| v.to_num::<f64>()));
        let p = [f64::from(column) + 0.5, f64::from(row) + 0.5];
        let area =
            |a: [f64; 2], b: [f64; 2], c: [f64; 2]| (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
        let whole = area(a, b, c);
        [area(p, b, c) / whole, area(a, p, c) / whole, area(a, b, p) / whole]
    }

    fn over_w(&self, weights: [f64; 3]) -> f64 {
        weights.iter().zip(&self.placed).map(|(weight, corner)| weight / corner.w.to_num::<f64>()).sum()
    }

    fn exact(&self, weights: [f64; 3]) -> [f64; 2] {
        [0, 1].map(|axis| {
            let over = weights.iter().zip(&self.placed);
            let sum: f64 =
                over.map(|(w, corner)| w * f64::from(corner.attributes[axis]) / corner.w.to_num::<f64>()).sum();
            sum / self.over_w(weights)
        })
    }

    fn arrived(&self, got: [f64; 2], row: i32, column: i32) -> Arrived {
        let first = column.div_euclid(8) * 8;
        let [start, end] = [first, first + 8].map(|column| self.weights(row, column));
        let nearest = self.placed.iter().map(|corner| corner.w.to_num::<f64>()).fold(f64::MAX, f64::min);
        let along = f64::from(column - first) / 8.0;
        let is_before = [start, end].iter().all(|weights| self.over_w(*weights) > 0.0);
        let chord = is_before.then(|| {
            let [a, b] = [start, end].map(|weights| self.exact(weights));
            [0, 1].map(|axis| a[axis] + along * (b[axis] - a[axis]))
        });
        let here = self.weights(row, column);
        let spread = |weights: [f64; 3]| {
            weights.iter().map(|weight| weight.abs()).sum::<f64>() / (self.over_w(weights).abs() * nearest)
        };
        let spread = if is_before { spread(start).max(spread(end)) } else { spread(here) };
        Arrived { got, exact: self.exact(here), chord, spread }
    }
}

fn quadrangle(corners: [[f64; 3]; 4], uv: [[i16; 2]; 4]) -> Shape {
    Shape {
        positions: corners.map(|corner| place(corner.map(|v| v / 16.0))).to_vec(),
        normals: vec![[0, 0, 127]; 4],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        lights: vec![Light::WHITE; 4],
        uv: uv.to_vec(),
    }
}

fn drawn<S: Shading>(shape: &Shape, shading: S, scene: &Scene, canvas: &mut Canvas<S::Color>) {
    let mut vertices = vec![MeshVertex::EMPTY; shape.positions.len()];
    let mut workspace = Workspace { vertices: &mut vertices, hidden: &mut Convex };
    let material = Material { faces: Faces::Both, ..Material::new(shading) };
    let instance = Instance::new(shape.mesh(), Matrix::<Model, World>::scale(number(16.0))).with_material(material);
    draw_mesh(&instance, scene, &mut workspace, canvas).expect("in range");
}

/// A wall of 64 texels whose ends are exactly at the borders of a view twice as wide as high; the far end so many times as far as the
/// near one. Gives the greatest errors, in texels: against exact numbers, and against the straight way.
fn errors(width: i32, ratio: f64) -> [f64; 2] {
    let view = Rect::new(0, 0, width, width / 2);
    let far = ratio;
    let corners = [[-1.0, -0.5, -1.0], [far, -far / 2.0, -far], [far, far / 2.0, -far], [-1.0, 0.5, -1.0]];
    let shape = quadrangle(corners, [[0, 4_095], [4_096, 4_095], [4_096, 0], [0, 0]]);
    let mut canvas = Canvas::new(view);
    drawn(&shape, Places, &camera_scene(view), &mut canvas);
    let mut most = [0.0_f64; 2];
    for arrived in canvas.colors.iter().map(|arrived| arrived.expect("the wall fills the view")) {
        let chord = arrived.chord.unwrap_or(arrived.exact);
        for ((got, exact), chord) in arrived.got.into_iter().zip(arrived.exact).zip(chord) {
            let (error, way) = ((got - exact).abs(), (got - chord).abs());
            // Where it is not on the way, it is divided by itself.
            most = [most[0].max(error / 64.0), most[1].max(error.min(way) / 64.0)];
        }
    }
    println!("{width} pixels, {ratio} times as far: off by {:.3} texels, by {:.4} from the way", most[0], most[1]);
    most
}

/// The numbers that the module states.
#[test]
fn a_wall_is_off_by_parts_of_a_texel() {
    let [small, large] = [errors(128, 4.0), errors(400, 4.0)];
    assert!(small[0] <= 0.7 && large[0] <= 0.09, "{small:?} {large:?}");
    assert!(small[0] > 0.5 && large[0] > 0.05, "the statement is not far from the truth");
    for width in [64, 128, 240, 400] {
        for ratio in [1.0, 1.5, 2.0, 8.0, 15.0] {
            let [_, from_way] = errors(width, ratio);
            assert!(from_way < 0.25, "{from_way}");
        }
    }
}

/// A texel of 64, in units.
const TEXEL: f64 = 64.0;

fn corner() -> impl Strategy<Value = [f64; 3]> {
    (-6.0..6.0_f64, -3.0..3.0_f64, prop_oneof![-1.0..-0.6_f64, -4.0..-0.6_f64, -19.0..-0.6_f64])
        .prop_map(|(x, y, z)| [x * -z / 4.0, y * -z / 4.0, z])
}

fn uv(reach: i16) -> impl Strategy<Value = [i16; 2]> {
    prop::array::uniform2(-reach..=reach)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1_500))]

    /// Either divided by itself, or between two divisions.
    #[test]
    fn places_are_those_of_doubles(
        corners in prop::array::uniform4(corner()),
        uv in prop_oneof![prop::array::uniform4(uv(4_096)), prop::array::uniform4(uv(600)), prop::array::uniform4(uv(i16::MAX))],
    ) {
        let view = Rect::new(0, 0, 128, 64);
        let mut canvas = Canvas::new(view);
        drawn(&quadrangle(corners, uv), Places, &camera_scene(view), &mut canvas);
        for arrived in canvas.colors.iter().flatten() {
            let reach = f64::from(uv.iter().flatten().map(|v| i32::from(*v)).max().expect("four")
                - uv.iter().flatten().map(|v| i32::from(*v)).min().expect("four")) + 1.0;
            for axis in 0..2 {
                // Numbers are modulo 2¹⁷ units.
                let off = |want: f64| (arrived.got[axis] - want + 65_536.0).rem_euclid(131_072.0) - 65_536.0;
                let off = |want: f64| off(want).abs();
                let exact = off(arrived.exact[axis]);
                let error = arrived.chord.map_or(exact, |chord| exact.min(off(chord[axis])));
                // Half a texel, and a part of the reach of the coordinates: slivers are the worst.
                let most = arrived.spread * (32.0 + reach / 1_024.0);
                // Ends that are as far off as this are out of range, and which of both ways was taken is not known here.
                prop_assert!(error <= most || arrived.spread > 1_000.0, "{:?}, axis {}: {} of {}, {}", arrived, axis, error, most, reach);
            }
        }
    }

    /// Tiles, bands, and what is left of spans of which a part is hidden.
    #[test]
    fn parts_get_the_values_of_the_whole(
        corners in prop::array::uniform4(corner()), uv in prop::array::uniform4(uv(4_096)),
        (left, top) in (0..120_i32, 0..60_i32), (width, height) in (1..40_i32, 1..10_i32), bars in any::<u128>(),
    ) {
        let (view, shape) = (Rect::new(0, 0, 128, 64), quadrangle(corners, uv));
        let mut whole = Canvas::new(view);
        drawn(&shape, Places, &camera_scene(view), &mut whole);
        let part = Rect::new(left, top, (left + width).min(128), (top + height).min(64));
        let mut tile = Canvas::new(part);
        drawn(&shape, Places, &camera_scene(view), &mut tile);
        for (x, y) in part.rows().flat_map(|y| part.columns().map(move |x| (x, y))) {
            prop_assert_eq!(tile.at(x, y), whole.at(x, y));
        }
        // Columns that something before all hides.
        let mut depths = vec![0_u16; 128 * 64];
        let mut buffer = DepthBuffer::new(&mut depths, view).expect("large enough");
        for row in 0..64 {
            let run = buffer.run(row, 0..128).expect("inside");
            for (at, depth) in run.iter_mut().enumerate() {
                *depth = if bars >> at & 1 == 1 { u16::MAX } else { 0 };
            }
        }
        let mut seen = Canvas::new(view);
        let mut nearest = Canvas::new(view);
        let mut vertices = vec![MeshVertex::EMPTY; 4];
        let placement = Matrix::<Model, World>::scale(number(16.0));
        let material = Material { faces: Faces::Both, ..Material::new(Places) };
        let mut workspace = Workspace { vertices: &mut vertices, hidden: &mut buffer };
        let instance = Instance::new(shape.mesh(), placement).with_material(material);
        draw_mesh(&instance, &camera_scene(view), &mut workspace, &mut seen).expect("in range");
        let mut clear_depths = vec![0_u16; 128 * 64];
        let mut clear = DepthBuffer::new(&mut clear_depths, view).expect("large enough");
        let mut workspace = Workspace { vertices: &mut vertices, hidden: &mut clear };
        draw_mesh(&instance, &camera_scene(view), &mut workspace, &mut nearest).expect("in range");
        for (x, y) in view.rows().flat_map(|y| view.columns().map(move |x| (x, y))) {
            let is_hidden = bars >> x & 1 == 1;
            prop_assert_eq!(seen.at(x, y), if is_hidden { None } else { nearest.at(x, y) });
        }
    }
}

/// A wall that vanishes on the screen, at any column of a block: where the horizon is inside of it, each pixel is divided by
/// itself.
#[test]
fn a_horizon_inside_of_a_block() {
    let view = Rect::new(0, 0, 128, 64);
    let (mut blocks, mut worst) = (0, 0.0_f64);
    for at in 0..64 {
        // Towards x / w = vanish: a wall along (vanish, 0, −1).
        let vanish = f64::from(at) / 64.0;
        let along = |w: f64, y: f64| [vanish * w - 0.9, y, -w];
        let corners = [along(0.6, -0.2), along(19.0, -0.2), along(19.0, 0.2), along(0.6, 0.2)];
        let shape = quadrangle(corners, [[0, 4_095], [32_000, 4_095], [32_000, 0], [0, 0]]);
        let mut canvas = Canvas::new(view);
        drawn(&shape, Places, &camera_scene(view), &mut canvas);
        for arrived in canvas.colors.iter().flatten().filter(|arrived| arrived.chord.is_none()) {
            blocks += 1;
            for axis in 0..2 {
                worst = worst.max((arrived.got[axis] - arrived.exact[axis]).abs() / TEXEL / arrived.spread);
            }
        }
    }
    println!("{blocks} pixels beside horizons: off by {worst:.4} texels at the nearest");
    assert!(blocks > 30 && worst < 0.2, "{blocks} {worst}");
}

/// Where a panel is seen almost from its edge, the ends of a block are far beside it, and the way between them is too. Measured: 7 of 100
/// pixels are off by more than a texel, 8 of 1000 by more than 8, and one of 1300 by more than the texture.
#[test]
fn a_turning_panel() {
    let view = Rect::new(0, 0, 128, 64);
    let (mut judged, mut off) = (0, [0; 3]);
    for turn in 0..256_u16 {
        let [sin, cos] = {
            let angle = f64::from(turn) / 256.0 * core::f64::consts::TAU;
            [angle.sin(), angle.cos()]
        };
        let corners = [[-1.0, -0.5], [1.0, -0.5], [1.0, 0.5], [-1.0, 0.5]].map(|[x, y]| [x * cos, y, x * sin - 2.2]);
        let shape = quadrangle(corners, [[0, 4_096], [4_096, 4_096], [4_096, 0], [0, 0]]);
        let mut canvas = Canvas::new(view);
        drawn(&shape, Places, &camera_scene(view), &mut canvas);
        for arrived in canvas.colors.iter().flatten() {
            judged += 1;
            let error = [0, 1].map(|axis| (arrived.got[axis] - arrived.exact[axis]).abs() / TEXEL);
            let error = error[0].max(error[1]);
            for (count, least) in off.iter_mut().zip([1.0, 8.0, 64.0]) {
                *count += usize::from(error > least);
            }
        }
    }
    println!("a turning panel: of {judged} pixels {off:?} are off by more than 1, 8, 64 texels");
    assert!(
        judged > 100_000 && off[0] * 13 < judged && off[1] * 100 < judged && off[2] * 1_000 < judged,
        "{off:?} of {judged}"
    );
    // A light is not bent by that.
    let mut canvas = Canvas::new(view);
    let shape = quadrangle([[-1.0, -0.5, -1.0], [1.0, -0.5, -1.0], [1.0, 0.5, -1.0], [-1.0, 0.5, -1.0]], [[0; 2]; 4]);
    drawn(&shape, Gouraud, &camera_scene(view), &mut canvas);
    assert!(canvas.colors.iter().flatten().all(|light| light.0 > 0xFF00));
}
