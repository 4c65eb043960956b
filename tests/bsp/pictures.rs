//! What a tree shows is what a depth buffer shows.

use core::{convert::Infallible, ops::Range};

use aquatint::{
    Angle, Clip, Light, Matrix, Model, Rect, Scalar, Target, Vector3, View, World,
    fragment::shade::{Corner, Gouraud, Shader, Shading},
    geometry::{
        face::Faces,
        light::Lamp,
        projection::{Lens, ViewBox},
        viewport::Viewport,
    },
    hidden::{
        Hidden,
        bsp::{Choice, Tree},
        convex::Convex,
        depth::DepthBuffer,
    },
    pipeline::{Camera, Instance, Material, MeshVertex, Scene, TreeInstance, Workspace, draw_mesh, draw_tree},
};

use super::{
    exact::Random,
    shapes::{self, LARGE, Memory, Shape},
};

const VIEW: Rect = Rect::new(0, 0, 96, 64);

/// What is shown, and how often each pixel was drawn.
struct Picture {
    shown: Vec<Option<Light>>,
    writes: Vec<u32>,
}

impl Picture {
    fn new() -> Self {
        let count = usize::try_from(VIEW.width() * VIEW.height()).expect("small");
        Self { shown: vec![None; count], writes: vec![0; count] }
    }
}

fn at(row: i32, column: i32) -> usize {
    usize::try_from((row - VIEW.top) * (VIEW.right - VIEW.left) + column - VIEW.left).expect("inside")
}

impl Target for Picture {
    type Color = Light;
    type Error = Infallible;

    fn bounds(&self) -> Rect {
        VIEW
    }

    fn fill_run<const N: usize>(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: [Light; N],
    ) -> Result<(), Infallible> {
        self.write_run(row, columns, core::iter::repeat(Some(colors[0])))
    }

    fn write_run(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: impl Iterator<Item = Option<Light>>,
    ) -> Result<(), Infallible> {
        assert!(!columns.is_empty() && columns.start >= VIEW.left && columns.end <= VIEW.right);
        for (column, color) in columns.zip(colors) {
            let at = at(row, column);
            self.writes[at] += u32::from(color.is_some());
            self.shown[at] = color.or(self.shown[at]);
        }
        Ok(())
    }
}

/// Where a shape is seen from.
#[derive(Clone, Copy)]
struct Pose {
    placement: Matrix<Model, World>,
    projection: Matrix<View, Clip>,
    faces: Faces,
}

impl Pose {
    fn random(random: &mut Random, faces: Faces) -> Self {
        let mut within = |low: f64, high: f64| low + f64::from(random.below(1 << 16)) / 65_536.0 * (high - low);
        let distance = within(0.6, 6.0);
        let [x, y, z] = [within(-0.4, 0.4) * distance, within(-0.3, 0.3) * distance, -distance].map(Scalar::from_num);
        let mut angle = || Angle(u16::try_from(random.below(1 << 16)).expect("16 bits"));
        let turned = Matrix::<Model, World>::rotation_x(angle()).then(&Matrix::<World, World>::rotation_y(angle()));
        let [near, far, aspect] = [0.5, 12.0, 1.5].map(Scalar::from_num);
        let lens = Lens { field_of_view: Angle::from_degrees(50.0), aspect, near, far };
        let projection = Matrix::perspective(lens).expect("a lens");
        Self { placement: turned.then(&Matrix::<World, World>::translation(x, y, z)), projection, faces }
    }

    fn scene(&self) -> Scene {
        let one = Scalar::ONE;
        let camera = Camera {
            view: Matrix::IDENTITY,
            projection: self.projection,
            viewport: Viewport::new(VIEW).expect("a view"),
        };
        let direction = Vector3::new(one, one * 2, one * 3);
        Scene { camera, light: Lamp { direction, ambient: Light(9_000), diffuse: Light(50_000) } }
    }

    fn instance<'a, S>(&self, shape: &'a Shape, shading: S) -> Instance<'a, S> {
        let material = Material { faces: self.faces, ..Material::new(shading) };
        Instance::new(shape.mesh(), self.placement).with_material(material)
    }

    /// By a tree, without depths.
    fn by_tree(&self, shape: &Shape, tree: &Tree<'_>, shading: impl Shading<Color = Light>) -> Picture {
        self.by_tree_and(shape, tree, shading, &mut Convex)
    }

    fn by_tree_and(
        &self,
        shape: &Shape,
        tree: &Tree<'_>,
        shading: impl Shading<Color = Light>,
        hidden: &mut impl Hidden,
    ) -> Picture {
        let (mut picture, mut vertices) = (Picture::new(), vec![MeshVertex::EMPTY; shape.positions.len()]);
        let mut workspace = Workspace { vertices: &mut vertices, hidden };
        let faces = TreeInstance { instance: self.instance(shape, shading), tree: *tree };
        draw_tree(&faces, &self.scene(), &mut workspace, &mut picture).expect("in range");
        picture
    }

    /// All triangles, in the order of the list.
    fn unordered(&self, shape: &Shape, shading: impl Shading<Color = Light>) -> Picture {
        let (mut picture, mut vertices) = (Picture::new(), vec![MeshVertex::EMPTY; shape.positions.len()]);
        let mut workspace = Workspace { vertices: &mut vertices, hidden: &mut Convex };
        draw_mesh(&self.instance(shape, shading), &self.scene(), &mut workspace, &mut picture).expect("in range");
        picture
    }

    /// By a depth buffer, of which the depths are given, too.
    fn by_depths(&self, shape: &Shape, shading: impl Shading<Color = Light>) -> (Picture, Vec<u32>) {
        let (mut picture, mut vertices) = (Picture::new(), vec![MeshVertex::EMPTY; shape.positions.len()]);
        let mut depths = vec![0; picture.shown.len()];
        let mut buffer = DepthBuffer::<u32>::new(&mut depths, VIEW).expect("large enough");
        let mut workspace = Workspace { vertices: &mut vertices, hidden: &mut buffer };
        draw_mesh(&self.instance(shape, shading), &self.scene(), &mut workspace, &mut picture).expect("in range");
        (picture, depths)
    }

    /// How deep a triangle alone is at a pixel, in 2⁻³¹, and how much that changes to the next pixels across and down: nothing
    /// where it is too narrow to tell.
    fn depth(&self, shape: &Shape, triangle: usize, pixel: usize) -> Option<(i64, Option<i64>)> {
        let (_, depths) = self.by_depths(&shape.only(triangle), numbers());
        let depth = |at: usize| depths.get(at).map(|&depth| i64::from(depth)).filter(|&depth| depth > 0);
        let here = depth(pixel)?;
        let along = |step: usize| {
            let next = depth(pixel.wrapping_sub(step)).or_else(|| depth(pixel + step))?;
            Some((next - here).abs())
        };
        let (across, down) = (along(1), along(usize::try_from(VIEW.width()).expect("small")));
        Some((here, across.zip(down).map(|(across, down)| across + down)))
    }
}

/// The number of the triangle as its light.
fn numbers() -> impl Shading<Color = Light> + Copy {
    Shader::new(|corner: &Corner| [corner.index / 3], |[number]: [u16; 1]| Some(Light(number)))
}

/// What was compared.
#[derive(Debug, Default)]
struct Compared {
    covered: usize,
    /// Where another triangle is seen, as near as the rounding of corners tells.
    differ: usize,
    unsure: usize,
}

/// A unit of a depth of 16 bits.
const UNIT: i64 = 1 << 15;

/// A pose: the same pixels are covered; where another triangle is seen, it is as near.
fn compare(shape: &Shape, tree: &Tree<'_>, pose: &Pose, compared: &mut Compared) {
    let (found, (wanted, _)) = (pose.by_tree(shape, tree, numbers()), pose.by_depths(shape, numbers()));
    let (lights, (lights_wanted, _)) = (pose.by_tree(shape, tree, Gouraud), pose.by_depths(shape, Gouraud));
    for (pixel, (found, wanted)) in found.shown.iter().zip(&wanted.shown).enumerate() {
        let (Some(found), Some(wanted)) = (found, wanted) else {
            assert_eq!(found, wanted, "{}: a pixel is lost or gained", shape.name);
            assert_eq!(lights.shown[pixel], lights_wanted.shown[pixel]);
            continue;
        };
        compared.covered += 1;
        if found == wanted {
            assert_eq!(lights.shown[pixel], lights_wanted.shown[pixel], "the light of the whole triangle");
            continue;
        }
        compared.differ += 1;
        let depth = |triangle: &Light| pose.depth(shape, usize::from(triangle.0), pixel);
        let (Some((found_depth, found_steep)), Some((wanted_depth, wanted_steep))) = (depth(found), depth(wanted))
        else {
            panic!("{}: a triangle is drawn where it is not", shape.name)
        };
        let Some((found_steep, wanted_steep)) = found_steep.zip(wanted_steep) else {
            compared.unsure += 1;
            continue;
        };
        let behind = wanted_depth - found_depth;
        let allowed = 2 * UNIT + (found_steep + wanted_steep) / 16;
        assert!(behind <= allowed, "{}: {found:?} hides {wanted:?}: {behind} > {allowed}", shape.name);
    }
}

fn poses(shape: &Shape, count: u32, faces: Faces, choice: Choice) {
    let mut memory = Memory::new(LARGE);
    let tree = memory.build_by(shape, choice).expect("room");
    let (mut random, mut compared) = (Random(count + 1), Compared::default());
    for _ in 0..count {
        compare(shape, &tree, &Pose::random(&mut random, faces), &mut compared);
    }
    let (triangles, pieces) = (shape.triangles.len(), tree.pieces().len());
    println!("{}: {triangles} triangles, {} nodes, {pieces} pieces, {compared:?}", shape.name, tree.nodes().len());
    assert!(
        compared.covered > 1000
            && compared.differ * 500 <= compared.covered
            && compared.unsure * 5000 <= compared.covered,
        "{compared:?}"
    );
}

/// Pieces fill the pixels of their triangles, none twice: each pixel is drawn as often as without a tree. And each piece has the
/// depths of the whole: with a depth buffer, the picture is the same to the pixel.
#[test]
fn pieces_are_their_triangle() {
    let mut random = Random(31);
    let shapes = [shapes::torus(12, 9), shapes::crossing(20, &mut random), shapes::crossing(50, &mut random)];
    for shape in &shapes {
        let mut memory = Memory::new(LARGE);
        let tree = memory.build(shape, 3).expect("room");
        let mut most = 0;
        for _ in 0..50 {
            let pose = Pose::random(&mut random, Faces::Both);
            for (by_tree, unordered) in [
                (pose.by_tree(shape, &tree, Gouraud), pose.unordered(shape, Gouraud)),
                (pose.by_tree(shape, &tree, numbers()), pose.unordered(shape, numbers())),
            ] {
                assert!(by_tree.writes == unordered.writes, "{}", shape.name);
                most = by_tree.writes.into_iter().fold(most, u32::max);
            }
            let (wanted, wanted_depths) = pose.by_depths(shape, Gouraud);
            let mut depths = vec![0; wanted.shown.len()];
            let mut buffer = DepthBuffer::<u32>::new(&mut depths, VIEW).expect("large enough");
            let found = pose.by_tree_and(shape, &tree, Gouraud, &mut buffer);
            assert!(depths == wanted_depths, "{}", shape.name);
            let differ = found.shown.iter().zip(&wanted.shown).filter(|(found, wanted)| found != wanted).count();
            assert!(differ <= 3, "only where depths are equal: {differ}");
        }
        assert!(most > 3, "{most}");
    }
}

#[test]
fn tori() {
    poses(&shapes::torus(28, 18), 300, Faces::Front, Choice::best_of(5));
    poses(&shapes::torus(12, 9), 100, Faces::Both, Choice::best_of(1));
    poses(&shapes::torus(12, 9), 50, Faces::Back, Choice::best_of(20));
    poses(&shapes::torus(28, 18), 300, Faces::Front, Choice::best_of(5).with_tolerance(2));
}

#[test]
fn bunnies() {
    poses(&shapes::bunny(), 100, Faces::Front, Choice::best_of(5));
    poses(&shapes::bunny(), 100, Faces::Front, Choice::best_of(5).with_tolerance(2));
}

#[test]
fn triangles_that_cross_each_other() {
    let mut random = Random(77);
    for _ in 0..20 {
        poses(&shapes::crossing(20, &mut random), 20, Faces::Both, Choice::best_of(5));
    }
    poses(&shapes::crossing(100, &mut random), 5, Faces::Both, Choice::best_of(5));
}

#[test]
fn soups() {
    let mut random = Random(99);
    for size in [600, 2500, 6000] {
        poses(&shapes::soup("soup", 100, size, &mut random), 50, Faces::Both, Choice::best_of(20));
    }
}

/// The eye is nowhere, only a direction.
#[test]
fn parallel_projections() {
    let mut random = Random(7);
    for shape in [shapes::torus(28, 18), shapes::crossing(20, &mut random)] {
        let mut memory = Memory::new(LARGE);
        let tree = memory.build(&shape, 5).expect("room");
        let mut compared = Compared::default();
        for _ in 0..100 {
            let [height, aspect, near, far] = [3.0, 1.5, -4.0, 12.0].map(Scalar::from_num);
            let projection = Matrix::orthographic(ViewBox { height, aspect, near, far }).expect("a box");
            let pose = Pose { projection, ..Pose::random(&mut random, Faces::Both) };
            compare(&shape, &tree, &pose, &mut compared);
        }
        assert!(compared.covered > 1000 && compared.differ * 500 <= compared.covered, "{compared:?}");
    }
}
