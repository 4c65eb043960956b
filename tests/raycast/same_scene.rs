//! One scene, two methods: which triangle is seen at each pixel, by rays and by the rasteriser with a depth buffer.
//!
//! They must agree on every pixel but for those of which doubles say that a sixteenth of a pixel may decide:
//!
//! - eight rays, an eighth of a pixel around the centre, do not all see the triangle that is seen at the centre, or
//! - another triangle is, somewhere within that eighth, not farther than the first one is, elsewhere there.

use core::convert::Infallible;

use aquatint::{
    Angle, Frame, Light, Matrix, Model, Rect, Words, World,
    fragment::shade::{Corner, Shader},
    hidden::{
        depth::DepthBuffer,
        raycast::{Hierarchy, Node, Objects},
    },
    model::{
        mesh::Mesh,
        revolved::{Parts, torus_triangles, vertices},
        solids::CUBE,
    },
    pipeline::{Camera, DrawError, Instance, Material, MeshVertex, PixelRays, Scene, Workspace, draw_mesh},
};
use embedded_graphics::{image::GetPixel, prelude::Point};

use super::{
    exact::Random,
    meshes::shapes_of,
    oracle::{V, cross, dot, minus},
    scenes::{LAMP, camera, number},
};

const VIEW: Rect = Rect::new(0, 0, 96, 64);
const BUNNY: Mesh<'static> = include!("../../examples/assets/bunny.rs");
const TORUS: Parts<{ vertices(20, 12) }, { torus_triangles(20, 12) }> = Parts::torus::<20, 12>(6_000);

/// A mesh in which no two triangles share a vertex, so that each can have a number.
struct Solid {
    positions: Vec<[i16; 3]>,
    triangles: Vec<[u16; 3]>,
    placement: Matrix<Model, World>,
}

impl Solid {
    fn new(mesh: Mesh<'_>, placement: Matrix<Model, World>) -> Self {
        let positions: Vec<_> =
            mesh.triangles().flatten().map(|corner| mesh.positions()[usize::from(corner)]).collect();
        let triangles =
            (0..u16::try_from(positions.len()).expect("few")).step_by(3).map(|i| [i, i + 1, i + 2]).collect();
        Self { positions, triangles, placement }
    }

    fn draw_on(
        &self,
        first: u16,
        camera: Camera,
        depths: &mut DepthBuffer<'_, u32>,
        frame: &mut Frame<Light, Words, Vec<u8>>,
    ) -> Result<(), DrawError<Infallible>> {
        let normals = vec![[0, 0, 127]; self.positions.len()];
        let mesh = Mesh::new(&self.positions, &normals, &self.triangles).expect("indices are right");
        // Sixteen apart, so that no rounding makes another number of it.
        let number = Shader::new(
            |corner: &Corner| [corner.index / 3 * 16 + 8],
            |[number]: [u16; 1]| Some(Light(first + number / 16 + 1)),
        );
        let instance = Instance::new(mesh, self.placement).with_material(Material::new(number));
        let mut vertices = vec![MeshVertex::EMPTY; self.positions.len()];
        let mut workspace = Workspace { vertices: &mut vertices, hidden: depths };
        draw_mesh(&instance, &Scene { camera, light: LAMP }, &mut workspace, frame)
    }
}

/// The number of the triangle at each pixel, from 1; 0 for none.
fn by_depths(solids: &[Solid], camera: Camera) -> Vec<usize> {
    let mut frame = Frame::<Light, Words, _>::new(vec![0; 96 * 64 * 2], 96, 64).expect("large enough");
    let mut depths = vec![0_u32; 96 * 64];
    let mut depths = DepthBuffer::new(&mut depths, VIEW).expect("large enough");
    let mut first = 0;
    for solid in solids {
        solid.draw_on(first, camera, &mut depths, &mut frame).expect("in range");
        first += u16::try_from(solid.triangles.len()).expect("few");
    }
    let number = |at: i32| frame.pixel(Point::new(at % 96, at / 96)).expect("inside").0.into();
    (0..96 * 64).map(number).collect()
}

fn by_rays(shapes: &[aquatint::hidden::raycast::Shape], camera: &Camera) -> Vec<usize> {
    let mut nodes = vec![Node::default(); 2 * shapes.len()];
    let tree = Hierarchy::new(shapes, &mut nodes).expect("two for each");
    let rays = PixelRays::new(camera).expect("an eye");
    let seen = |row| rays.run(row, VIEW.columns()).map(|ray| tree.nearest(&ray).map_or(0, |hit| hit.number + 1));
    VIEW.rows().flat_map(seen).collect()
}

/// In doubles: which pixels are sure.
struct Reference {
    eye: V,
    view: [V; 3],
    focal: [f64; 2],
    triangles: Vec<[V; 3]>,
}

impl Reference {
    fn new(camera: &Camera, corners: &[[[i32; 3]; 3]]) -> Self {
        let rows = camera.view.rows().map(|row| row.map(|v| v.to_num::<f64>()));
        let view = [0, 1, 2].map(|i| [rows[i][0], rows[i][1], rows[i][2]]);
        let eye = [0, 1, 2].map(|axis| -(0..3).map(|i| view[i][axis] * rows[i][3]).sum::<f64>());
        let projection = camera.projection.rows();
        let focal = [projection[0][0].to_num(), projection[1][1].to_num()];
        let triangles = corners.iter().map(|all| all.map(|place| place.map(|v| f64::from(v) / 65_536.0))).collect();
        Self { eye, view, focal, triangles }
    }

    /// All that a ray through a place of the screen hits: distances and numbers from 1.
    fn hits(&self, x: f64, y: f64) -> Vec<(f64, usize)> {
        let (u, v) = ((x / 48.0 - 1.0) / self.focal[0], (1.0 - y / 32.0) / self.focal[1]);
        let direction = [0, 1, 2].map(|axis| self.view[0][axis] * u + self.view[1][axis] * v - self.view[2][axis]);
        let hit = |(number, corners): (usize, &[V; 3])| {
            let [a, b, c] = corners.map(|corner| minus(corner, self.eye));
            let sides = [(a, b), (b, c), (c, a)].map(|(a, b)| dot(cross(a, b), direction));
            let is_inside = sides.iter().all(|side| *side >= 0.0) || sides.iter().all(|side| *side <= 0.0);
            let normal = cross(minus(b, a), minus(c, a));
            let distance = dot(normal, a) / dot(normal, direction);
            (is_inside && distance > 0.0).then_some((distance, number + 1))
        };
        self.triangles.iter().enumerate().filter_map(hit).collect()
    }

    /// The triangle that is seen at a pixel, if an eighth of a pixel cannot change that.
    fn sure(&self, column: i32, row: i32) -> Option<usize> {
        let at = |angle: i32, away: f64| {
            let (sin, cos) = (f64::from(angle) * core::f64::consts::FRAC_PI_4).sin_cos();
            self.hits(f64::from(column) + 0.5 + away * cos, f64::from(row) + 0.5 + away * sin)
        };
        let all: Vec<_> = [at(0, 0.0)].into_iter().chain((0..8).map(|angle| at(angle, 0.125))).collect();
        let nearest = |hits: &Vec<(f64, usize)>| hits.iter().copied().min_by(|a, b| a.0.total_cmp(&b.0));
        let seen = |hits: &Vec<(f64, usize)>| nearest(hits).map_or(0, |hit| hit.1);
        let first = all.first().map_or(0, seen);
        if all.iter().any(|hits| seen(hits) != first) {
            return None;
        }
        let of = |own: bool| all.iter().flatten().filter(move |hit| (hit.1 == first) == own).map(|hit| hit.0);
        let (farthest, next) = (of(true).fold(0.0, f64::max), of(false).fold(f64::INFINITY, f64::min));
        (farthest < next).then_some(first)
    }
}

/// Draws solids both ways. Gives how many pixels could be judged, and of how many triangles.
fn compare(name: &str, solids: &[Solid], camera: Camera) -> [usize; 3] {
    let (mut shapes, mut corners) = (vec![], vec![]);
    for solid in solids {
        let normals = vec![[0, 0, 127]; solid.positions.len()];
        let mesh = Mesh::new(&solid.positions, &normals, &solid.triangles).expect("indices are right");
        let (more, places) = shapes_of(mesh, solid.placement);
        shapes.extend(more);
        corners.extend(places);
    }
    let reference = Reference::new(&camera, &corners);
    let (rays, depths) = (by_rays(&shapes, &camera), by_depths(solids, camera));
    let (mut sure, mut covered, mut differ) = (0, 0, 0);
    for (at, (ray, depth)) in (0..).zip(rays.into_iter().zip(depths)) {
        let (column, row) = (at % 96, at / 96);
        differ += usize::from(ray != depth);
        if let Some(number) = reference.sure(column, row) {
            assert_eq!((ray, depth), (number, number), "{name}: rays, then depths, at {column}, {row}");
            (sure, covered) = (sure + 1, covered + usize::from(number > 0));
        }
    }
    [sure, covered, differ]
}

fn pose(random: &mut Random, scale: f64, at: [f64; 3]) -> Matrix<Model, World> {
    let mut angle = || Angle(u16::try_from(random.below(1 << 16)).expect("16 bits"));
    let [x, y, z] = at.map(number);
    Matrix::<Model, Model>::scale(number(scale))
        .then(&Matrix::<Model, Model>::rotation_x(angle()))
        .then(&Matrix::<Model, World>::rotation_y(angle()))
        .then(&Matrix::<World, World>::translation(x, y, z))
}

fn check(name: &str, mesh: Mesh<'_>, poses: u32, least: usize) {
    let mut random = Random(poses + 1);
    let mut all = [0; 3];
    for _ in 0..poses {
        let solid = Solid::new(mesh, pose(&mut random, 1.5, [0.0; 3]));
        let counts = compare(name, &[solid], camera([0.4, 0.8, 4.5], [0.0; 3], VIEW));
        all = [0, 1, 2].map(|i| all[i] + counts[i]);
    }
    println!("{name}: {all:?} sure, covered, different of {}", poses * 96 * 64);
    assert!(all[1] > least * poses as usize, "{all:?}");
}

#[test]
fn cubes() {
    check("cube", CUBE, 20, 800);
}

#[test]
fn tori() {
    check("torus", TORUS.mesh().expect("a mesh"), 6, 500);
}

#[test]
fn a_bunny() {
    check("bunny", BUNNY, 2, 200);
}

/// Solids before, behind and through each other.
#[test]
fn many_solids() {
    let (mut random, mut all) = (Random(77), [0; 3]);
    for _ in 0..12 {
        let solids: Vec<_> = (0..9)
            .map(|number| {
                let at = [4, 3, 3].map(|reach| f64::from(random.below(reach * 512) - reach * 256) / 256.0);
                let mesh = if number % 2 == 0 { CUBE } else { aquatint::model::solids::ICOSAHEDRON };
                Solid::new(mesh, pose(&mut random, 1.0, at))
            })
            .collect();
        let counts = compare("many", &solids, camera([0.5, 1.0, 9.0], [0.0; 3], VIEW));
        all = [0, 1, 2].map(|i| all[i] + counts[i]);
    }
    println!("many: {all:?} sure, covered, different of {}", 12 * 96 * 64);
    assert!(all[0] > 12 * 5_000 && all[1] > 12 * 700, "{all:?}");
}
