//! Strips, fans and polygons are drawn as the triangles that they stand for; what has none draws nothing.

use aquatint::{
    Angle, Light, Matrix, Model, Rect, World,
    fragment::shade::{Flat, Gouraud, Phong, Shading, Textured},
    fragment::texture::{LightTexture, Sampler},
    geometry::face::Faces,
    hidden::depth::DepthBuffer,
    model::{
        assembly::{Assembly, RESTART},
        mesh::Mesh,
    },
    pipeline::{Instance, Material, MeshVertex, Workspace, draw_mesh},
};
use proptest::prelude::*;

use crate::common::{Canvas, camera_scene, number};

const SCREEN: Rect = Rect::new(0, 0, 48, 32);

#[derive(Clone, Debug)]
struct Arrays {
    positions: Vec<[i16; 3]>,
    normals: Vec<[i8; 3]>,
    lights: Vec<Light>,
    uv: Vec<[i16; 2]>,
}

impl Arrays {
    fn mesh<'a>(&'a self, assembly: Assembly<'a>, face_normals: &'a [[i8; 3]]) -> Mesh<'a> {
        let mesh = Mesh::with_assembly(&self.positions, &self.normals, assembly).expect("indices are right");
        let mesh = mesh.with_lights(&self.lights).and_then(|mesh| mesh.with_uv(&self.uv)).expect("one each");
        if face_normals.is_empty() { mesh } else { mesh.with_face_normals(face_normals).expect("one each") }
    }
}

fn drawn<S: Shading<Color = Light>>(mesh: Mesh<'_>, shading: S, turns: [u16; 2]) -> (Canvas, Vec<u16>) {
    let mut canvas = Canvas::new(SCREEN);
    let mut depths = vec![0_u16; canvas.colors.len()];
    let mut buffer = DepthBuffer::new(&mut depths, SCREEN).expect("large enough");
    let placement = Matrix::<Model, World>::rotation_x(Angle(turns[0]))
        .then(&Matrix::<World, World>::rotation_y(Angle(turns[1])))
        .then(&Matrix::<World, World>::translation(number(0.0), number(0.0), number(-3.0)));
    let mut vertices = vec![MeshVertex::EMPTY; mesh.positions().len()];
    let mut workspace = Workspace { vertices: &mut vertices, hidden: &mut buffer };
    let material = Material { faces: Faces::Both, ..Material::new(shading) };
    let instance = Instance::new(mesh, placement).with_material(material);
    draw_mesh(&instance, &camera_scene(SCREEN), &mut workspace, &mut canvas).expect("in range");
    (canvas, depths)
}

/// By every shading.
fn all_drawn(mesh: Mesh<'_>, turns: [u16; 2]) -> Vec<(Canvas, Vec<u16>)> {
    static TEXELS: [Light; 4] = [Light(9), Light(0x5000), Light(0x9000), Light(0xE000)];
    let texture = || Sampler::new(LightTexture::new(&TEXELS, 2, 2).expect("a texture"));
    vec![
        drawn(mesh, Gouraud, turns),
        drawn(mesh, Flat, turns),
        drawn(mesh, Phong, turns),
        drawn(mesh, Textured::new(texture(), Flat), turns),
        drawn(mesh, Textured::new(texture(), Gouraud).affine(), turns),
    ]
}

fn arrays() -> impl Strategy<Value = Arrays> {
    let vertex = (prop::array::uniform3(-20_000..20_000_i16), any::<[i8; 3]>(), any::<u16>(), any::<[i16; 2]>());
    prop::collection::vec(vertex, 3..12).prop_map(|vertices| Arrays {
        positions: vertices.iter().map(|vertex| vertex.0).collect(),
        normals: vertices.iter().map(|vertex| vertex.1).collect(),
        lights: vertices.iter().map(|vertex| Light(vertex.2)).collect(),
        uv: vertices.iter().map(|vertex| vertex.3).collect(),
    })
}

/// The triangles of runs, by the words of the lecture: without those of which two corners are one vertex.
fn of_runs(indices: &[u16], is_fan: bool) -> Vec<[u16; 3]> {
    let mut triangles = vec![];
    for run in indices.split(|index| *index == RESTART) {
        for (at, three) in run.windows(3).enumerate() {
            let [a, b, c] = [three[0], three[1], three[2]];
            triangles.push(if is_fan {
                [run[0], b, c]
            } else if at % 2 == 1 {
                [b, a, c]
            } else {
                [a, b, c]
            });
        }
    }
    triangles.retain(|[a, b, c]| a != b && b != c && c != a);
    triangles
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]
    #[test]
    fn strips_and_fans_are_drawn_as_triangles(
        arrays in arrays(), raw in prop::collection::vec(any::<u16>(), 0..20), turns in any::<[u16; 2]>(), is_fan: bool,
        normal in any::<[i8; 3]>(), with_normals: bool,
    ) {
        let count = u16::try_from(arrays.positions.len()).expect("few");
        let indices: Vec<_> = raw.iter().map(|v| if v % 6 == 0 { RESTART } else { v / 6 % count }).collect();
        let triangles = of_runs(&indices, is_fan);
        let assembly = if is_fan { Assembly::Fan(&indices) } else { Assembly::Strip(&indices) };
        let mut normals = vec![normal; triangles.len()];
        if let Some(first) = normals.first_mut() {
            *first = [0, 0, 127];
        }
        let normals = if with_normals { normals } else { vec![] };
        let by_run = arrays.mesh(assembly, &normals);
        let by_triangles = arrays.mesh(Assembly::Triangles(&triangles), &normals);
        prop_assert_eq!(all_drawn(by_run, turns), all_drawn(by_triangles, turns));
    }

    #[test]
    fn polygons_are_drawn_as_triangles(
        arrays in arrays(), raw in prop::collection::vec((3..7_u8, any::<[u16; 7]>()), 0..5), turns in any::<[u16; 2]>(),
        normal in any::<[[i8; 3]; 5]>(), with_normals: bool,
    ) {
        let count = u16::try_from(arrays.positions.len()).expect("few");
        let counts: Vec<_> = raw.iter().map(|(corners, _)| *corners).collect();
        let polygons: Vec<Vec<_>> =
            raw.iter().map(|(corners, at)| at[..usize::from(*corners)].iter().map(|v| v % count).collect()).collect();
        let indices = polygons.concat();
        let fan = |polygon: &[u16]| of_runs(polygon, true);
        let triangles: Vec<_> = polygons.iter().flat_map(|polygon| fan(polygon)).collect();
        // The normal of a polygon is that of all its triangles.
        let of_faces: Vec<_> = normal[..polygons.len()].to_vec();
        let of_triangles: Vec<_> =
            polygons.iter().zip(&of_faces).flat_map(|(polygon, normal)| fan(polygon).into_iter().map(|_| *normal)).collect();
        let (of_faces, of_triangles) = if with_normals { (of_faces, of_triangles) } else { (vec![], vec![]) };
        let by_polygons = arrays.mesh(Assembly::Polygons { counts: &counts, indices: &indices }, &of_faces);
        let by_triangles = arrays.mesh(Assembly::Triangles(&triangles), &of_triangles);
        prop_assert_eq!(all_drawn(by_polygons, turns), all_drawn(by_triangles, turns));
    }
}

#[test]
fn empty_lists_draw_nothing() {
    let full = Arrays {
        positions: vec![[-9_000, -9_000, 0], [9_000, -9_000, 0], [0, 9_000, 0]],
        normals: vec![[0, 0, 127]; 3],
        lights: vec![Light::WHITE; 3],
        uv: vec![[0; 2]; 3],
    };
    let empty = Arrays { positions: vec![], normals: vec![], lights: vec![], uv: vec![] };
    let none: [Assembly; 4] = [
        Assembly::Triangles(&[]),
        Assembly::Strip(&[]),
        Assembly::Fan(&[]),
        Assembly::Polygons { counts: &[], indices: &[] },
    ];
    for assembly in none {
        for arrays in [&full, &empty] {
            for (canvas, depths) in all_drawn(arrays.mesh(assembly, &[]), [0; 2]) {
                assert!(canvas.colors.iter().all(Option::is_none) && depths.iter().all(|depth| *depth == 0));
            }
        }
    }
    for short in [Assembly::Strip(&[0, 1]), Assembly::Fan(&[0, 1, RESTART, 1, 2]), Assembly::Strip(&[RESTART; 5])] {
        assert!(all_drawn(full.mesh(short, &[]), [0; 2])[0].0.colors.iter().all(Option::is_none));
    }
    let one = drawn(full.mesh(Assembly::Fan(&[0, 1, 2]), &[]), Gouraud, [0; 2]);
    assert!(one.0.colors.iter().flatten().count() > 50, "what is not empty is drawn");
}
