//! Depth bias: decals on walls that lean away.

use aquatint::{
    Light, Matrix, Model, Rect, World,
    fragment::shade::Gouraud,
    geometry::face::Faces,
    hidden::{
        convex::Convex,
        depth::{Depth, DepthBuffer, DepthTest},
    },
    pipeline::{DepthBias, Instance, Material, MeshVertex, Workspace, draw_mesh},
};

use crate::common::{Canvas, Shape, VIEW, camera_scene, draw, panel, place};

const SCREEN: Rect = Rect::new(0, 0, 128, 64);

/// A quadrangle on the plane z = −3 + s · x + t · y, between places of it.
fn on_plane([s, t]: [f64; 2], corners: [[f64; 2]; 4], light: u16) -> Shape {
    let positions = corners.map(|[x, y]| place([x, y, -3.0 + s * x + t * y].map(|v| v / 4.0))).to_vec();
    Shape {
        positions,
        normals: vec![[0, 0, 127]; 4],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        lights: vec![Light(light); 4],
        uv: vec![[0; 2]; 4],
    }
}

/// Pixels of the decal that are seen, and all that it has.
fn seen<D: Depth + Ord>(slopes: [f64; 2], bias: DepthBias, nothing: D) -> [usize; 2] {
    let wall = on_plane(slopes, [[-4.0, -2.0], [4.0, -2.0], [4.0, 2.0], [-4.0, 2.0]], 0x4000);
    let decal = on_plane(slopes, [[-0.9, -0.41], [0.77, -0.63], [1.03, 0.38], [-0.57, 0.72]], 0xA000);
    let scene = camera_scene(SCREEN);
    let placement = Matrix::<Model, World>::scale(crate::common::number(4.0));
    let count = |with_wall: bool| {
        let mut canvas = Canvas::new(SCREEN);
        let mut depths = vec![nothing; 128 * 64];
        let mut buffer = DepthBuffer::new(&mut depths, SCREEN).expect("large enough");
        let mut material = Material { faces: Faces::Both, ..Material::new(Gouraud) };
        for (shape, bias) in [(&wall, DepthBias::NONE), (&decal, bias)].into_iter().skip(usize::from(!with_wall)) {
            material.bias = bias;
            let mut vertices = [MeshVertex::EMPTY; 4];
            let mut workspace = Workspace { vertices: &mut vertices, hidden: &mut buffer };
            let instance = Instance::new(shape.mesh(), placement).with_material(material);
            draw_mesh(&instance, &scene, &mut workspace, &mut canvas).expect("in range");
        }
        canvas.colors.iter().flatten().filter(|light| light.0 > 0x6000).count()
    };
    [count(true), count(false)]
}

/// From walls seen squarely to steep ones.
const LEANING: [[f64; 2]; 6] = [[0.0, 0.0], [0.3, 0.1], [-0.5, 0.4], [0.9, -0.2], [-0.9, 0.0], [0.1, 1.3]];

#[test]
fn a_biased_decal_is_seen_as_a_whole() {
    for slopes in LEANING {
        let [seen_part, all] = seen(slopes, DepthBias { constant: 2, slope: 1 }, 0_u16);
        assert!(all > 300 && seen_part == all, "{slopes:?}: {seen_part} of {all}");
        let [seen_part, all] = seen(slopes, DepthBias { constant: 2, slope: 1 }, 0_u32);
        assert!(seen_part == all, "{slopes:?}, 32 bits: {seen_part} of {all}");
        // With 8 bits a depth is 256 units.
        let [seen_part, all] = seen(slopes, DepthBias { constant: 256, slope: 1 }, 0_u8);
        assert!(seen_part == all, "{slopes:?}, 8 bits: {seen_part} of {all}");
    }
}

#[test]
fn without_a_bias_it_fights() {
    let shares = LEANING.map(|slopes| seen(slopes, DepthBias::NONE, 0_u16));
    assert!(shares.iter().all(|[part, all]| part < all), "{shares:?}");
    assert!(shares.iter().filter(|[part, all]| *part > 0 && part < all).count() >= 3, "{shares:?}");
}

#[test]
fn negative_numbers_push_away() {
    for slopes in LEANING {
        let [seen_part, _] = seen(slopes, DepthBias { constant: -2, slope: -1 }, 0_u16);
        assert_eq!(seen_part, 0, "{slopes:?}");
    }
}

/// What is stored at the ends.
const NEAREST: u16 = u16::MAX - 2;
const FARTHEST: u16 = 3;

/// What is stored of a level panel at a depth, where everything passes.
fn stored(z: f64, bias: DepthBias) -> u16 {
    let mut depths = [0_u16; 128];
    let buffer = DepthBuffer::new(&mut depths, VIEW).expect("large enough");
    let material = Material { bias, ..Material::new(Gouraud) };
    let mut buffer = buffer.with_test(DepthTest::Always);
    draw(&panel(VIEW, [z; 2]), material, &mut buffer, &mut Canvas::new(VIEW)).expect("in range");
    assert!(depths.iter().all(|depth| *depth == depths[0]));
    depths[0]
}

#[test]
fn a_bias_is_of_16_bit_depths() {
    let with = |constant, slope| stored(0.0, DepthBias { constant, slope });
    assert_eq!([with(0, 0), with(1, 0), with(-1, 0), with(300, 127)], [32_768, 32_769, 32_767, 33_068]);
}

#[test]
fn a_bias_saturates_at_the_ends() {
    let [most, least] = [(i16::MAX, 127), (i16::MIN, -128)].map(|(constant, slope)| DepthBias { constant, slope });
    // The ends are three units before those of the numbers.
    assert_eq!([stored(-1.0, most), stored(-0.5, most)], [NEAREST; 2]);
    assert_eq!([stored(1.0, least), stored(0.5, least), stored(0.0, least)], [FARTHEST; 3]);
    assert_eq!(stored(1.0, most), FARTHEST + i16::MAX.cast_unsigned());
    // A leaning panel: the steepest bias there is leaves nothing out of range.
    for (bias, want) in
        [(DepthBias { constant: 0, slope: 127 }, NEAREST), (DepthBias { constant: 0, slope: -128 }, FARTHEST)]
    {
        let mut depths = [1_u16; 128];
        let mut buffer = DepthBuffer::new(&mut depths, VIEW).expect("large enough").with_test(DepthTest::Always);
        let material = Material { bias, ..Material::new(Gouraud) };
        draw(&panel(VIEW, [-0.9, 0.9]), material, &mut buffer, &mut Canvas::new(VIEW)).expect("in range");
        assert!(depths.iter().all(|depth| *depth == want), "{depths:?}");
    }
}

/// A bias moves nothing where no depth is looked at.
#[test]
fn without_depths_a_bias_changes_nothing() {
    let drawn = |bias| {
        let mut canvas = Canvas::new(VIEW);
        let material = Material { bias, ..Material::new(Gouraud) };
        draw(&panel(VIEW, [-0.5, 0.5]), material, &mut Convex, &mut canvas).expect("in range");
        canvas
    };
    assert_eq!(drawn(DepthBias { constant: i16::MIN, slope: i8::MIN }), drawn(DepthBias::NONE));
}
