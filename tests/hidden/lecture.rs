//! The lecture's three problems of the painter's algorithm (5.7.3), each solved by every method, and not by sorting alone.

use core::convert::Infallible;

use aquatint::{
    Clip, Light, Matrix, Rect, Scalar, Vector3, View, World,
    geometry::{face::Faces, light::Lamp, projection::ViewBox, viewport::Viewport},
    hidden::{convex::Convex, depth::DepthBuffer},
    model::mesh::Mesh,
    pipeline::{
        Camera, DepthSortMemory, Instance, Material, MeshVertex, ObjectSpaceMemory, Scene, SceneMemory, Workspace,
        draw_compared, draw_mesh, draw_scene, draw_sorted,
    },
};
use heapless::Vec as Room;

use crate::{
    numbered::{FIRST, Numbered},
    picture::Picture,
};

const SCREEN: Rect = Rect::new(0, 0, 32, 16);

/// Faces of three corners of their own each, in sixteenths of the view's half height: x, y and z, which grows towards the eye.
struct Faced {
    positions: Vec<[i16; 3]>,
    normals: Vec<[i8; 3]>,
    triangles: Vec<[u16; 3]>,
    names: &'static str,
}

impl Faced {
    fn new(names: &'static str, faces: &[[[i16; 3]; 3]]) -> Self {
        assert_eq!(names.len(), faces.len());
        let positions: Vec<_> = faces.iter().flatten().map(|place| place.map(|v| v * 1024)).collect();
        let corner = |face: usize, at: usize| u16::try_from(3 * face + at).expect("few");
        let triangles = (0..faces.len()).map(|face| [0, 1, 2].map(|at| corner(face, at))).collect();
        Self { normals: vec![[0, 0, 127]; positions.len()], positions, triangles, names }
    }

    fn mesh(&self) -> Mesh<'_> {
        Mesh::new(&self.positions, &self.normals, &self.triangles).expect("indices are right")
    }

    fn instance(&self) -> Instance<'_, Numbered> {
        Instance::new(self.mesh(), Matrix::IDENTITY)
            .with_material(Material { faces: Faces::Both, ..Material::new(Numbered(FIRST)) })
    }

    /// The rows of a picture, by the names of the faces.
    fn text(&self, picture: &Picture) -> Vec<String> {
        let name = |(row, column): (i32, i32)| {
            let face = usize::from(picture.at(row, column).0).saturating_sub(FIRST);
            if picture.is_covered(row, column) { self.names.chars().nth(face).unwrap_or('?') } else { '.' }
        };
        SCREEN.rows().map(|row| SCREEN.columns().map(|column| name((row, column))).collect()).collect()
    }
}

/// From in front, without perspective: 2 by 1 and as deep as it takes.
fn scene() -> Scene {
    let one = Scalar::ONE;
    let seen = ViewBox { height: one * 2, aspect: one * 2, near: one, far: one * 7 };
    let camera = Camera {
        view: Matrix::<World, View>::translation(Scalar::ZERO, Scalar::ZERO, one * -4),
        projection: Matrix::<View, Clip>::orthographic(seen).expect("a box"),
        viewport: Viewport::new(SCREEN).expect("pixels"),
    };
    Scene { camera, light: Lamp { direction: Vector3::new(one, one, one), ambient: Light(0), diffuse: Light(0) } }
}

fn by_depth(faces: &Faced) -> Vec<String> {
    let (mut picture, mut depths) = (Picture::new(SCREEN), [0_u32; 32 * 16]);
    let mut hidden = DepthBuffer::new(&mut depths, SCREEN).expect("large enough");
    let mut workspace = Workspace { vertices: &mut [MeshVertex::EMPTY; 48], hidden: &mut hidden };
    draw_mesh(&faces.instance(), &scene(), &mut workspace, &mut picture).expect("in range");
    faces.text(&picture)
}

fn by_rows(faces: &Faced) -> Vec<String> {
    let (mut picture, mut memory) = (Picture::new(SCREEN), SceneMemory::<48, 16, 16, Numbered>::NEW);
    draw_scene(&[faces.instance()], &scene(), &mut memory, &mut picture).expect("room");
    faces.text(&picture)
}

fn by_comparison(faces: &Faced) -> Vec<String> {
    let mut picture = Picture::new(SCREEN);
    let memory = ObjectSpaceMemory {
        vertices: &mut [MeshVertex::EMPTY; 48],
        faces: &mut Room::<_, 16>::new(),
        compared: &mut Room::<_, 16>::new(),
        bounds: &mut Room::<_, 60>::new(),
    };
    draw_compared(&[faces.instance()], &scene(), memory, &mut picture).expect("room");
    faces.text(&picture)
}

fn by_sort(faces: &Faced) -> Vec<String> {
    let mut picture = Picture::new(SCREEN);
    let memory = DepthSortMemory {
        vertices: &mut [MeshVertex::EMPTY; 48],
        faces: &mut Room::<_, 16>::new(),
        pieces: &mut Room::<_, 40>::new(),
        corners: &mut Room::<_, 300>::new(),
        cuts: &mut Room::<_, 64>::new(),
    };
    draw_sorted(&[faces.instance()], &scene(), memory, &mut picture).expect("room");
    faces.text(&picture)
}

/// Sorted by the farthest corner, and not looked at again.
fn by_sort_alone(faces: &Faced) -> Vec<String> {
    let mut order = faces.triangles.clone();
    let far = |face: &[u16; 3]| face.map(|corner| faces.positions[usize::from(corner)][2]).into_iter().min();
    order.sort_by_key(far);
    let sorted = Mesh::new(&faces.positions, &faces.normals, &order).expect("the same");
    let mut picture = Picture::new(SCREEN);
    let mut workspace = Workspace { vertices: &mut [MeshVertex::EMPTY; 48], hidden: &mut Convex };
    let Ok(()) = draw_mesh(&Instance { mesh: sorted, ..faces.instance() }, &scene(), &mut workspace, &mut picture)
        .map_err(|error| -> Infallible { panic!("{error}") });
    faces.text(&picture)
}

fn check(faces: &Faced, expected: &[&str; 16]) {
    assert_eq!(by_sort(faces), expected, "depth sort");
    assert_eq!(by_comparison(faces), expected, "object space");
    assert_eq!(by_depth(faces), expected, "depth buffer");
    assert_eq!(by_rows(faces), expected, "scanline");
    assert_ne!(by_sort_alone(faces), expected, "the problem is one");
}

/// A bar of two faces.
fn bar([a, b, c, d]: [[i16; 3]; 4]) -> [[[i16; 3]; 3]; 2] {
    [[a, b, c], [a, c, d]]
}

const LARGE: [&str; 16] = [
    "................................",
    "..................h...........l.",
    ".................hh.........lll.",
    "................hhh.......lllll.",
    "..............hhhhh....llllllll.",
    ".............hhhhhh..llllllllll.",
    "............hhhhhhhllllllllllll.",
    "............hhhhhllllllllllllll.",
    "..............hllllllllllllllll.",
    ".............llllllllllllllllll.",
    "...........llllllllllllllllllll.",
    "........lllllllllllllllllllllll.",
    "......lllllllslllllllllllllllll.",
    "....lllllllssssllllllllllllllll.",
    "..lllllllllllllllllllllllllllll.",
    "................................",
];

/// A large face that slopes away: its farthest corner is behind the small one that it hides, and it is behind another.
#[test]
fn a_large_face_and_a_small_one() {
    let large = [[-30, -14, -32], [30, -14, 28], [30, 14, 28]];
    let hidden = [[-10, 2, -14], [6, 14, -14], [6, -6, -14]];
    let seen = [[-14, -13, -28], [0, -13, 30], [-4, -8, 30]];
    check(&Faced::new("lhs", &[large, hidden, seen]), &LARGE);
}

const CIRCLE: [&str; 16] = [
    "................................",
    ".............bbbbcc.............",
    "..............bbbb..............",
    ".............ccbbbb.............",
    ".............ccbbbb.............",
    "............ccccbbbb............",
    "...........cccc..bbbb...........",
    "..........cccc....bbbb..........",
    ".........cccc......bbbb.........",
    "........cccc........bbbb........",
    "........cccc........bbbb........",
    "...aaaaccccaaaaaaaaaaaaaaaaaa...",
    "...aaaccccaaaaaaaaaaaaaaaaaaa...",
    "...aaccccaaaaaaaaaaaaaaaaaaaa...",
    "....cccc................bbbb....",
    "................................",
];

/// Three bars, each over the next.
#[test]
fn faces_that_hide_each_other_in_a_circle() {
    let a = bar([[-26, -12, -8], [26, -12, 8], [26, -7, 8], [-26, -7, -8]]);
    let b = bar([[17, -15, -8], [25, -15, -8], [1, 14, 8], [-7, 14, 8]]);
    let c = bar([[-1, 14, -8], [7, 14, -8], [-17, -15, 8], [-25, -15, 8]]);
    check(&Faced::new("aabbcc", &[a, b, c].concat()), &CIRCLE);
}

const THROUGH: [&str; 16] = [
    "................................",
    "...........r....................",
    ".....ffffffffffffffffffffffff...",
    "......ffffffffrfffffffffffff....",
    ".......fffffffrrrffffffffff.....",
    "........ffffffrrrrfffffffff.....",
    ".......rrffffffrrrrrffffff......",
    ".......rrrfffffrrrrrrffff.......",
    "......rrrrrffffrrrrrrrrf........",
    "......rrrrrrfffrrrrrrrrr........",
    ".....rrrrrrrrffrrrrrrrrrrr......",
    "....rrrrrrrrrrfrrrrrrrrrrrrr....",
    "....rrrrrrrrrrrrrrrrrrrrrrrrr...",
    "...rrrrrrrrrrrrrrrrrrrr.........",
    "..rrrrrrr........ff.............",
    "................................",
];

/// Two faces, one through the other.
#[test]
fn faces_through_each_other() {
    let rising = [[-28, -14, -8], [28, -10, 12], [-10, 14, 0]];
    let falling = [[-24, 12, 9], [28, 13, -9], [4, -15, 0]];
    check(&Faced::new("rf", &[rising, falling]), &THROUGH);
}
