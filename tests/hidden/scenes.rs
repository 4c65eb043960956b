//! Scenes of three things: soups of random triangles, solids that stand through each other, any numbers at all.

use aquatint::{
    Angle, Clip, Light, Matrix, Model, Rect, Scalar, Vector3, View, World,
    geometry::{face::Faces, light::Lamp, projection::Lens, viewport::Viewport},
    model::{
        mesh::Mesh,
        revolved::{Parts, sphere_triangles, torus_triangles, vertices},
        solids::{CUBE, DODECAHEDRON, TETRAHEDRON},
    },
    pipeline::{Camera, Instance, Material, Scene},
};
use proptest::prelude::*;

pub static BUNNY: Mesh<'static> = include!("../../examples/assets/bunny.rs");
static TORUS: Parts<{ vertices(14, 9) }, { torus_triangles(14, 9) }> = Parts::torus::<14, 9>(6_000);
static BALL: Parts<{ vertices(12, 7) }, { sphere_triangles(12, 7) }> = Parts::sphere::<12, 7>();

/// The pixels of all pictures.
pub const WINDOW: Rect = Rect::new(-3, 2, 93, 62);

/// A mesh that is owned, and where it stands.
#[derive(Clone)]
pub struct Thing {
    pub positions: Vec<[i16; 3]>,
    pub normals: Vec<[i8; 3]>,
    pub triangles: Vec<[u16; 3]>,
    pub placement: Matrix<Model, World>,
}

impl core::fmt::Debug for Thing {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let few = self.positions.len() < 40;
        f.debug_struct("Thing")
            .field("positions", &if few { &self.positions[..] } else { &[] })
            .field("triangles", &if few { &self.triangles[..] } else { &[] })
            .field("placement", &self.placement)
            .finish_non_exhaustive()
    }
}

impl Thing {
    fn of(mesh: Mesh, placement: Matrix<Model, World>) -> Self {
        Self {
            positions: mesh.positions().to_vec(),
            normals: mesh.normals().to_vec(),
            triangles: mesh.triangles().collect(),
            placement,
        }
    }

    pub fn mesh(&self) -> Mesh<'_> {
        Mesh::new(&self.positions, &self.normals, &self.triangles).expect("indices are right")
    }
}

/// Three things and the sides of them that are drawn.
#[derive(Clone, Debug)]
pub struct Things {
    pub things: [Thing; 3],
    pub faces: Faces,
}

impl Things {
    pub fn instances<S: Copy>(&self, shading: S) -> [Instance<'_, S>; 3] {
        self.things.each_ref().map(|thing| {
            let material = Material { faces: self.faces, ..Material::new(shading) };
            Instance::new(thing.mesh(), thing.placement).with_material(material)
        })
    }

    pub fn vertices(&self) -> usize {
        self.things.iter().map(|thing| thing.positions.len()).sum()
    }

    pub fn triangles(&self) -> usize {
        self.things.iter().map(|thing| thing.triangles.len()).sum()
    }
}

/// The eye at the origin, looking down −z.
pub fn scene() -> Scene {
    let (one, near) = (Scalar::ONE, Scalar::from_num(0.4));
    let lens = Lens { field_of_view: Angle::from_degrees(53.0), aspect: Scalar::from_num(1.6), near, far: one * 20 };
    let camera = Camera {
        view: Matrix::<World, View>::IDENTITY,
        projection: Matrix::<View, Clip>::perspective(lens).expect("a lens"),
        viewport: Viewport::new(WINDOW).expect("pixels"),
    };
    let direction = Vector3::new(Scalar::from_num(0.4), Scalar::from_num(0.6), Scalar::from_num(0.69));
    Scene { camera, light: Lamp { direction, ambient: Light(6_000), diffuse: Light(59_000) } }
}

fn turned(angles: [u16; 3], scale: i32, [x, y, z]: [i32; 3]) -> Matrix<Model, World> {
    let number = |v: i32| Scalar::from_bits(v);
    let [around, down, aside] = angles.map(Angle);
    Matrix::<Model, Model>::scale(number(scale))
        .then(&Matrix::<Model, Model>::rotation_y(around))
        .then(&Matrix::<Model, Model>::rotation_x(down))
        .then(&Matrix::<Model, Model>::rotation_z(aside))
        .then(&Matrix::translation(number(x), number(y), number(z)))
}

/// Somewhere before the eye, or around it.
fn placement() -> impl Strategy<Value = Matrix<Model, World>> {
    let place = [-0x2_0000..0x2_0000, -0x1_8000..0x1_8000, -0x6_0000..0x4000];
    (any::<[u16; 3]>(), 0x6000..0x1_8000, place).prop_map(|(angles, scale, place)| turned(angles, scale, place))
}

/// Any triangles.
fn soup() -> impl Strategy<Value = Thing> {
    let position = prop_oneof![prop::array::uniform3(-12_000..12_000_i16), any::<[i16; 3]>()];
    let normal = prop::array::uniform3(-90..90_i8);
    let vertices = prop::collection::vec((position, normal), 3..14);
    let triangles = prop::collection::vec(any::<[prop::sample::Index; 3]>(), 0..10);
    (vertices, triangles, placement()).prop_map(|(vertices, triangles, placement)| {
        let (positions, normals): (Vec<_>, Vec<_>) = vertices.into_iter().unzip();
        let index = |i: prop::sample::Index| u16::try_from(i.index(positions.len())).expect("few");
        let triangles = triangles.into_iter().map(|triangle| triangle.map(index)).collect();
        Thing { positions, normals, triangles, placement }
    })
}

/// A closed solid.
fn solid() -> impl Strategy<Value = Thing> {
    (0..5_u8, placement()).prop_map(|(which, placement)| match which {
        0 => Thing::of(CUBE, placement),
        1 => Thing::of(TETRAHEDRON, placement),
        2 => Thing::of(DODECAHEDRON, placement),
        3 => Thing::of(TORUS.mesh().expect("right"), placement),
        _ => Thing::of(BALL.mesh().expect("right"), placement),
    })
}

fn faces() -> impl Strategy<Value = Faces> {
    prop_oneof![Just(Faces::Front), Just(Faces::Back), Just(Faces::Both)]
}

pub fn soups() -> impl Strategy<Value = Things> {
    (prop::array::uniform3(soup()), faces()).prop_map(|(things, faces)| Things { things, faces })
}

pub fn solids() -> impl Strategy<Value = Things> {
    (prop::array::uniform3(solid()), faces()).prop_map(|(things, faces)| Things { things, faces })
}

/// The bunny, and two solids.
pub fn bunnies() -> impl Strategy<Value = Things> {
    (placement(), solid(), solid())
        .prop_map(|(placement, a, b)| Things { things: [Thing::of(BUNNY, placement), a, b], faces: Faces::Front })
}
