//! How each way to remove hidden surfaces grows: with the number of triangles, and with the number of pixels. On the desk.
//!
//! The triangles lie anyhow in a box before the eye, some through others, seen from both sides, each flat. With more of them
//! they are smaller, so that they always cover about as much: 1.2 times the picture. What can be done once for all pictures
//! is not counted: trees and hierarchies are there.

use core::convert::Infallible;

use aquatint::{
    Dithered, Frame, Levels, Light, Matrix, Rows, Scalar, Target,
    fragment::shade::Flat,
    geometry::face::Faces,
    hidden::{
        bsp::{Arena, Choice, Node, Piece, Split, Tree, Triangles},
        convex::Convex,
        depth::DepthBuffer,
        object_space::{ComparedFace, PartBound},
        painter::{PieceCorner, PieceCut, SortedPiece},
        raycast::{Hierarchy, Node as BoxNode, Objects, Shape},
    },
    model::mesh::Mesh,
    pipeline::{
        DepthSortMemory, Finish, Instance, ListedFace, Material, MeshVertex, ObjectSpaceMemory, PixelRays, Raycast,
        Scene, SceneMemory, TreeInstance, Workspace, draw_compared, draw_mesh, draw_rays, draw_scene, draw_sorted,
        draw_tree, mesh_shapes,
    },
};
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Size},
    pixelcolor::BinaryColor,
};
use heapless::Vec as Room;

use super::{
    Item, Label, OURS, Visitor,
    peers::{Shapes, Surface},
    solid_ours::scene,
};

/// So many triangles, on the picture of the middle size.
const COUNTS: [(&str, usize); 7] =
    [("k8", 8), ("k16", 16), ("k32", 32), ("k64", 64), ("k128", 128), ("k256", 256), ("k512", 512)];
/// Pictures, of the middle number of triangles.
const SIZES: [(&str, Size); 4] = [
    ("p64x32", Size::new(64, 32)),
    ("p128x64", Size::new(128, 64)),
    ("p256x128", Size::new(256, 128)),
    ("p512x256", Size::new(512, 256)),
];

/// What everybody draws.
fn items<'s>() -> &'s [Item<Grown>] {
    &[
        ("grow_depth", Grown::by_depth),
        ("grow_scanline", Grown::by_rows),
        ("grow_tree", Grown::by_tree),
        ("grow_object", Grown::by_comparing),
        ("grow_sort", Grown::by_sorting),
        ("grow_rays", Grown::by_rays),
        ("grow_list", Grown::by_list),
    ]
}

/// Shows all of them.
pub fn all(visitor: &mut impl Visitor) {
    let (_, middle) = COUNTS[3];
    let panels = COUNTS.map(|(panel, count)| (panel, SIZES[1].1, count));
    for (panel, size, count) in panels.into_iter().chain(SIZES.map(|(panel, size)| (panel, size, middle))) {
        for &(item, draw) in items() {
            visitor.visit(Label::new(item, panel, OURS), &mut Grown::new(size, count), draw);
        }
    }
}

/// A picture, and what is needed to draw it in every way. What is lent lives as long as the program.
struct Grown {
    frame: Frame<BinaryColor, Rows, Vec<u8>>,
    instance: Instance<'static, Flat>,
    list: &'static [[u16; 3]],
    vertices: Vec<MeshVertex>,
    depths: Vec<u32>,
    memory: Box<SceneMemory<1536, 1024, 256, Flat>>,
    faces: Box<Room<ListedFace, 600>>,
    compared: Box<Room<ComparedFace, 600>>,
    bounds: Box<Room<PartBound, 2_000>>,
    pieces: Box<Room<SortedPiece, 8_000>>,
    corners: Box<Room<PieceCorner, 60_000>>,
    cuts: Box<Room<PieceCut, 16_000>>,
    /// Made when the picture is cleared, which is not counted.
    built: Option<Built>,
}

struct Built {
    tree: Tree<'static>,
    shapes: &'static [Shape],
    hierarchy: Hierarchy<'static>,
}

impl Grown {
    fn new(size: Size, count: usize) -> Self {
        let pixels = (size.width * size.height) as usize;
        let positions: &[_] = soup(count).leak();
        let corner = |at: usize| u16::try_from(at).expect("few");
        let list = (0..count).map(|at| [corner(3 * at), corner(3 * at + 1), corner(3 * at + 2)]).collect::<Vec<_>>();
        let (list, normals) = (&*list.leak(), &*vec![[0, 0, 127]; positions.len()].leak());
        let mesh = Mesh::new(positions, normals, list).expect("indices are right");
        let mesh = mesh.with_face_normals(faces(positions).leak()).expect("one each");
        let material = Material { faces: Faces::Both, ..Material::new(Flat) };
        Self {
            frame: Frame::new(vec![0; pixels / 8], size.width, size.height).expect("one each"),
            instance: Instance::new(mesh, Matrix::scale(Scalar::from_num(3) / 2)).with_material(material),
            list,
            vertices: vec![MeshVertex::EMPTY; positions.len()],
            depths: vec![0; pixels],
            memory: Box::new(SceneMemory::NEW),
            faces: Box::default(),
            compared: Box::default(),
            bounds: Box::default(),
            pieces: Box::default(),
            corners: Box::default(),
            cuts: Box::default(),
            built: None,
        }
    }

    /// A tree, shapes and boxes.
    fn build(&self) -> Built {
        let (count, room) = (self.list.len(), 64 * self.list.len());
        let (nodes, pieces, cuts) = (vec![Node::EMPTY; room], vec![Piece::EMPTY; room], vec![Split::EMPTY; room]);
        let arena = Arena::new(nodes.leak(), pieces.leak(), cuts.leak());
        let triangles = Triangles::new(self.instance.mesh.positions(), self.list);
        let tree = arena.build(triangles, Choice::best_of(5)).expect("room enough");
        let mut shapes = vec![Shape::NOTHING; count];
        mesh_shapes(&self.instance, &mut shapes).expect("near enough");
        let shapes: &[Shape] = shapes.leak();
        let hierarchy = Hierarchy::new(shapes, vec![BoxNode::default(); 2 * count].leak()).expect("two each");
        Built { tree, shapes, hierarchy }
    }

    fn scene(&self) -> Scene {
        scene(self.frame.bounds()).expect("a view")
    }

    #[expect(clippy::unnecessary_wraps, reason = "an item")]
    fn by_depth(&mut self) -> Result<(), Infallible> {
        let scene = self.scene();
        let mut hidden = DepthBuffer::new(&mut self.depths, self.frame.bounds()).expect("one each");
        let mut workspace = Workspace { vertices: &mut self.vertices, hidden: &mut hidden };
        let mut light = Dithered::new(&mut self.frame, Levels::ONE_BIT);
        draw_mesh(&self.instance, &scene, &mut workspace, &mut light).expect("in range");
        Ok(())
    }

    #[expect(clippy::unnecessary_wraps, reason = "an item")]
    fn by_rows(&mut self) -> Result<(), Infallible> {
        let scene = self.scene();
        let mut light = Dithered::new(&mut self.frame, Levels::ONE_BIT);
        draw_scene(&[self.instance], &scene, &mut self.memory, &mut light).expect("room enough");
        Ok(())
    }

    #[expect(clippy::unnecessary_wraps, reason = "an item")]
    fn by_tree(&mut self) -> Result<(), Infallible> {
        let (scene, built) = (self.scene(), self.built.as_ref().expect("cleared before"));
        let faces = TreeInstance { instance: self.instance, tree: built.tree };
        let mut workspace = Workspace { vertices: &mut self.vertices, hidden: &mut Convex };
        let mut light = Dithered::new(&mut self.frame, Levels::ONE_BIT);
        draw_tree(&faces, &scene, &mut workspace, &mut light).expect("in range");
        Ok(())
    }

    #[expect(clippy::unnecessary_wraps, reason = "an item")]
    fn by_comparing(&mut self) -> Result<(), Infallible> {
        let scene = self.scene();
        let memory = ObjectSpaceMemory {
            vertices: &mut self.vertices,
            faces: &mut *self.faces,
            compared: &mut *self.compared,
            bounds: &mut *self.bounds,
        };
        let mut light = Dithered::new(&mut self.frame, Levels::ONE_BIT);
        draw_compared(&[self.instance], &scene, memory, &mut light).expect("room enough");
        Ok(())
    }

    #[expect(clippy::unnecessary_wraps, reason = "an item")]
    fn by_sorting(&mut self) -> Result<(), Infallible> {
        let scene = self.scene();
        let memory = DepthSortMemory {
            vertices: &mut self.vertices,
            faces: &mut *self.faces,
            pieces: &mut *self.pieces,
            corners: &mut *self.corners,
            cuts: &mut *self.cuts,
        };
        let mut light = Dithered::new(&mut self.frame, Levels::ONE_BIT);
        draw_sorted(&[self.instance], &scene, memory, &mut light).expect("room enough");
        Ok(())
    }

    fn by_rays(&mut self) -> Result<(), Infallible> {
        let hierarchy = self.built.as_ref().expect("cleared before").hierarchy;
        self.rays(hierarchy)
    }

    fn by_list(&mut self) -> Result<(), Infallible> {
        let shapes = self.built.as_ref().expect("cleared before").shapes;
        self.rays(shapes)
    }

    fn rays<O: Objects>(&mut self, objects: O) -> Result<(), Infallible> {
        let Scene { camera, light: lamp } = self.scene();
        let scene = Raycast { objects, finishes: &[Finish::MATTE], lamp, background: Light::BLACK };
        let rays = PixelRays::new(&camera).expect("an eye");
        draw_rays(&scene, &rays, &mut Dithered::new(&mut self.frame, Levels::ONE_BIT))
    }
}

impl OriginDimensions for Grown {
    fn size(&self) -> Size {
        self.frame.size()
    }
}

impl DrawTarget for Grown {
    type Color = BinaryColor;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<BinaryColor>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        self.frame.draw_iter(pixels)
    }

    fn clear(&mut self, color: BinaryColor) -> Result<(), Infallible> {
        self.built = Some(self.build());
        self.frame.clear(color)
    }
}

impl Shapes for Grown {}

impl Surface for Grown {
    fn picture(&self, look: impl FnOnce(&[u8])) {
        look(self.frame.bytes());
    }
}

/// Three corners for each triangle, by D. H. Lehmer's generator.
#[expect(clippy::cast_possible_truncation, clippy::cast_precision_loss, reason = "small numbers")]
fn soup(count: usize) -> Vec<[i16; 3]> {
    let mut state = 1_u64;
    let mut within = |reach: f64| {
        state = state * 48_271 % 2_147_483_647;
        (state as f64 / 1_073_741_824.0 - 1.0) * reach
    };
    let size = 20_000.0 / (count as f64).sqrt();
    let triangle = |_| {
        let middle = [22_000.0, 11_000.0, 12_000.0].map(&mut within);
        let mut corner = || middle.map(|v| (v + within(size)).clamp(-32_000.0, 32_000.0) as i16);
        [corner(), corner(), corner()]
    };
    (0..count).flat_map(triangle).collect()
}

/// The normals of the triangles.
#[expect(clippy::cast_possible_truncation, reason = "of length 127")]
fn faces(positions: &[[i16; 3]]) -> Vec<[i8; 3]> {
    let normal = |corners: &[[i16; 3]]| {
        let [a, b, c] = [0, 1, 2].map(|corner| corners[corner].map(f64::from));
        let (u, v) = ([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
        let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        let length = cross.iter().map(|v| v * v).sum::<f64>().sqrt().max(1e-9);
        cross.map(|v| (v / length * 127.0).round() as i8)
    };
    positions.chunks_exact(3).map(normal).collect()
}
