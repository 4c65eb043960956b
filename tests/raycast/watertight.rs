//! No ray passes between triangles that share a side, least of all one that is aimed at the side itself.

use aquatint::{
    Angle, Matrix, Model, Point3, Scalar, Vector3, World,
    hidden::raycast::{Objects, Ray, Shape, Triangle},
    model::{mesh::Mesh, solids},
};
use proptest::prelude::*;

use super::meshes::shapes_of;

fn point([x, y, z]: [i32; 3]) -> Point3<World> {
    let [x, y, z] = [x, y, z].map(Scalar::from_bits);
    Point3::new(x, y, z)
}

fn ray(from: [i32; 3], to: [i32; 3]) -> Ray {
    let [x, y, z] = [0, 1, 2].map(|axis| Scalar::from_bits(to[axis] - from[axis]));
    Ray::new(point(from), Vector3::new(x, y, z)).expect("in range")
}

/// All corners, and places on the sides between them as exact as there are numbers for.
fn aims(shapes: &[[[i32; 3]; 3]]) -> Vec<[i32; 3]> {
    let mid = |a: [i32; 3], b: [i32; 3], part: i32| [0, 1, 2].map(|i| a[i] + (b[i] - a[i]) / 8 * part);
    shapes
        .iter()
        .flat_map(|&[a, b, c]| (0..8).flat_map(move |part| [mid(a, b, part), mid(b, c, part), mid(c, a, part)]))
        .collect()
}

/// From inside of a closed solid, every ray hits it.
#[test]
fn from_inside_nothing_gets_out() {
    let solids: [(&str, Mesh<'static>); 5] = [
        ("tetrahedron", solids::TETRAHEDRON),
        ("cube", solids::CUBE),
        ("octahedron", solids::OCTAHEDRON),
        ("icosahedron", solids::ICOSAHEDRON),
        ("dodecahedron", solids::DODECAHEDRON),
    ];
    for (name, mesh) in solids {
        for turn in 0..24_u16 {
            let angle = Angle(turn * 2_731);
            let scale = Matrix::<Model, Model>::scale(Scalar::from_num(1 + turn % 5 * 12));
            let placement =
                scale.then(&Matrix::<Model, Model>::rotation_x(angle)).then(&Matrix::<Model, World>::rotation_y(angle));
            let (shapes, corners) = shapes_of(mesh, placement);
            let out = |from: [i32; 3], to: [i32; 3]| {
                assert!(shapes.is_hit(&ray(from, to)), "{name} {turn}: {from:?} to {to:?}");
            };
            for aim in aims(&corners) {
                out([0; 3], aim);
                out([100 * i32::from(turn), -77, 131], aim);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    /// Four triangles around a corner, as in any mesh: whatever is aimed at that corner, or at a place of a side, hits.
    #[test]
    fn around_a_corner(
        size in 1..22_u32,
        middle in prop::array::uniform3(-1_000..1_000_i32),
        depths in prop::array::uniform5(-1_000..1_000_i32),
        (ahead, beside) in (100_000..4_190_000_i32, prop::array::uniform2(-999..=999_i32)),
        aside in prop::array::uniform2(-3..=3_i32),
    ) {
        let reach = 1 << size.max(11);
        let [a, b, c, d, _] = depths;
        let corners = [[reach, 0, a], [0, reach, b], [-reach, 0, c], [0, -reach, d]]
            .map(|ring| [0, 1, 2].map(|axis| (ring[axis] + middle[axis]).clamp(-4_194_304, 4_194_304)));
        let shapes = [0, 1, 2, 3].map(|i| {
            let corners = [middle, corners[i], corners[(i + 1) % 4]].map(point);
            Shape::Triangle(Triangle::new(corners).expect("in range"))
        });
        // From in front, not flat.
        let [left, up] = beside.map(|part| ahead / 1_000 * part);
        let from = [left, up, ahead];
        let [x, y] = aside;
        for aim in [middle, [middle[0] + x, middle[1] + y, middle[2]]] {
            prop_assert!(shapes.is_hit(&ray(from, aim)), "{:?} to {:?}", from, aim);
        }
    }
}
