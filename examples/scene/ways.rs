//! One scene, every way to hide what is behind: a ring, and a block that it goes through. On the desk.
#![allow(dead_code, reason = "the benches draw it, too")]

use std::convert::Infallible;

use aquatint::{
    Angle, Light, Matrix, Model, Rect, Scalar, Target, Vector3, View, World,
    fragment::shade::Flat,
    geometry::{light::Lamp, projection::Lens, viewport::Viewport},
    hidden::{
        bsp::{Arena, Choice, Node, Piece, Split, Tree, Triangles},
        convex::Convex,
        depth::DepthBuffer,
        object_space::{ComparedFace, PartBound},
        painter::{PieceCorner, PieceCut, SortedPiece},
        raycast::{Hierarchy, Node as BoxNode, Shape},
    },
    model::{
        mesh::Mesh,
        revolved::{Parts, torus_triangles, vertices},
        solids::CUBE,
    },
    pipeline::{
        Camera, DepthSortMemory, Finish, Instance, ListedFace, Material, MeshVertex, ObjectSpaceMemory, PixelRays,
        Raycast, Scene, SceneMemory, TreeInstance, Workspace, draw_compared, draw_mesh, draw_rays, draw_scene,
        draw_sorted, draw_tree, mesh_shapes,
    },
};
use heapless::Vec as Room;

/// The pixels that are drawn.
pub const WINDOW: Rect = Rect::new(0, 0, 128, 64);
const PIXELS: usize = 128 * 64;

/// Of the ring: segments around, and rings.
const RING_VERTICES: usize = vertices(14, 8);
const RING_TRIANGLES: usize = torus_triangles(14, 8);
const VERTICES: usize = RING_VERTICES + 8;
const TRIANGLES: usize = RING_TRIANGLES + 12;
static RING: Parts<RING_VERTICES, RING_TRIANGLES> = Parts::torus::<14, 8>(6_000);

/// A way to hide what is behind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Back faces are left out, and that is all: enough for one convex solid.
    BackFaces,
    /// A depth for each pixel.
    DepthBuffer,
    /// Row by row, without memory for pixels.
    Scanline,
    /// By a tree of planes, from the back to the front.
    BspTree,
    /// Each face compared with each other.
    ObjectSpace,
    /// From the farthest face to the nearest, those split that hide each other.
    DepthSort,
    /// A ray for each pixel, and another one to the lamp.
    Rays,
}

/// Room for the faces that show, and for those in one row.
const FACES: usize = 160;
type RowMemory = SceneMemory<VERTICES, FACES, 64, Flat>;

/// What bounds a part of a face that is seen.
const BOUNDS: usize = 64;

/// Faces and their pieces, and what splits need.
const PIECES: usize = FACES + 96;
const CORNERS: usize = 3 * FACES + 8 * 96;
const CUTS: usize = 2 * 96;

impl Way {
    pub const ALL: [Self; 7] = [
        Self::BackFaces,
        Self::DepthBuffer,
        Self::Scanline,
        Self::BspTree,
        Self::ObjectSpace,
        Self::DepthSort,
        Self::Rays,
    ];

    /// As a bench, and in captions.
    pub const fn names(self) -> [&'static str; 2] {
        match self {
            Self::BackFaces => ["way_back_faces", "back faces only"],
            Self::DepthBuffer => ["way_depth_buffer", "depth buffer"],
            Self::Scanline => ["way_scanline", "scanline"],
            Self::BspTree => ["way_bsp_tree", "BSP tree"],
            Self::ObjectSpace => ["way_object_space", "object space"],
            Self::DepthSort => ["way_depth_sort", "depth sort"],
            Self::Rays => ["way_rays", "rays, shadows"],
        }
    }

    /// Bytes that must be lent.
    pub const fn ram(self) -> usize {
        let vertices = VERTICES * size_of::<MeshVertex>();
        match self {
            Self::BackFaces | Self::BspTree => vertices,
            Self::DepthBuffer => vertices + PIXELS * size_of::<u16>(),
            Self::Scanline => size_of::<RowMemory>(),
            Self::ObjectSpace => {
                vertices
                    + FACES * (size_of::<ListedFace>() + size_of::<ComparedFace>())
                    + BOUNDS * size_of::<PartBound>()
            }
            Self::DepthSort => {
                let pieces = FACES * size_of::<ListedFace>() + PIECES * size_of::<SortedPiece>();
                vertices + pieces + CORNERS * size_of::<PieceCorner>() + CUTS * size_of::<PieceCut>()
            }
            Self::Rays => 0,
        }
    }
}

/// The scene, and memory for each way.
pub struct Ways {
    instance: Instance<'static, Flat>,
    scene: Scene,
    tree: Tree<'static>,
    boxes: Hierarchy<'static>,
    vertices: Vec<MeshVertex>,
    depths: Vec<u16>,
    rows: Box<RowMemory>,
    faces: Box<Room<ListedFace, FACES>>,
    compared: Box<Room<ComparedFace, FACES>>,
    bounds: Box<Room<PartBound, BOUNDS>>,
    pieces: Box<Room<SortedPiece, PIECES>>,
    corners: Box<Room<PieceCorner, CORNERS>>,
    cuts: Box<Room<PieceCut, CUTS>>,
}

impl Ways {
    /// What is lent lives as long as the program.
    pub fn new() -> Self {
        let (mesh, list) = mesh();
        let placement = Matrix::rotation_y(Angle::from_degrees(35.0));
        let placement = Matrix::<Model, Model>::rotation_x(Angle::from_degrees(60.0)).then(&placement);
        let instance = Instance::new(mesh, placement).with_material(Material::new(Flat));
        let [nodes, pieces, cuts] = [8 * TRIANGLES; 3];
        let (nodes, pieces, cuts) = (vec![Node::EMPTY; nodes], vec![Piece::EMPTY; pieces], vec![Split::EMPTY; cuts]);
        let arena = Arena::new(nodes.leak(), pieces.leak(), cuts.leak());
        let tree = arena.build(Triangles::new(mesh.positions(), list), Choice::best_of(20)).expect("room enough");
        let mut shapes = vec![Shape::NOTHING; TRIANGLES];
        mesh_shapes(&instance, &mut shapes).expect("near enough");
        let boxes = vec![BoxNode::default(); 2 * TRIANGLES];
        Self {
            instance,
            scene: scene(),
            tree,
            boxes: Hierarchy::new(shapes.leak(), boxes.leak()).expect("two each"),
            vertices: vec![MeshVertex::EMPTY; VERTICES],
            depths: vec![0; PIXELS],
            rows: Box::new(RowMemory::NEW),
            faces: Box::default(),
            compared: Box::default(),
            bounds: Box::default(),
            pieces: Box::default(),
            corners: Box::default(),
            cuts: Box::default(),
        }
    }

    /// Bytes of what does not change from picture to picture, besides the mesh: it may be in flash.
    pub const fn flash(&self, way: Way) -> usize {
        match way {
            Way::BspTree => {
                size_of_val(self.tree.nodes()) + size_of_val(self.tree.pieces()) + size_of_val(self.tree.cuts())
            }
            Way::Rays => TRIANGLES * (size_of::<Shape>() + 2 * size_of::<BoxNode>()),
            _ => 0,
        }
    }

    /// Draws the scene on the window of a target that is black.
    pub fn draw<T: Target<Color = Light, Error = Infallible>>(&mut self, way: Way, target: &mut T) {
        let Self {
            instance,
            scene,
            tree,
            boxes,
            vertices,
            depths,
            rows,
            faces,
            compared,
            bounds,
            pieces,
            corners,
            cuts,
        } = self;
        let instances = [*instance];
        let drawn = match way {
            Way::BackFaces => draw_mesh(instance, scene, &mut Workspace { vertices, hidden: &mut Convex }, target),
            Way::DepthBuffer => {
                let mut hidden = DepthBuffer::new(depths, WINDOW).expect("one each");
                draw_mesh(instance, scene, &mut Workspace { vertices, hidden: &mut hidden }, target)
            }
            Way::Scanline => draw_scene(&instances, scene, rows, target),
            Way::BspTree => {
                let faces = TreeInstance { instance: *instance, tree: *tree };
                draw_tree(&faces, scene, &mut Workspace { vertices, hidden: &mut Convex }, target)
            }
            Way::ObjectSpace => {
                let (faces, compared, bounds) = (&mut **faces, &mut **compared, &mut **bounds);
                draw_compared(&instances, scene, ObjectSpaceMemory { vertices, faces, compared, bounds }, target)
            }
            Way::DepthSort => {
                let (faces, pieces, corners, cuts) = (&mut **faces, &mut **pieces, &mut **corners, &mut **cuts);
                draw_sorted(&instances, scene, DepthSortMemory { vertices, faces, pieces, corners, cuts }, target)
            }
            Way::Rays => {
                let Scene { camera, light: lamp } = *scene;
                let rays = PixelRays::new(&camera).expect("an eye");
                let scene = Raycast { objects: *boxes, finishes: &[Finish::MATTE], lamp, background: Light::BLACK };
                let Ok(()) = draw_rays(&scene, &rays, target);
                Ok(())
            }
        };
        drawn.expect("room enough, and in range");
    }
}

/// The ring and the block as one mesh, as a tree needs it, and its triangles.
fn mesh() -> (Mesh<'static>, &'static [[u16; 3]]) {
    let ring = RING.mesh().expect("indices are right");
    let (mut positions, mut normals) = (ring.positions().to_vec(), ring.normals().to_vec());
    // Around a part of the ring, which comes out of four of its sides.
    positions.extend(CUBE.positions().iter().map(|[x, y, z]| [x * 2 / 3 + 9_000, *y, z * 2 / 3]));
    normals.extend(CUBE.normals());
    let first = u16::try_from(RING_VERTICES).expect("few");
    let block = CUBE.triangles().map(|corners| corners.map(|corner| corner + first));
    let list: &[_] = ring.triangles().chain(block).collect::<Vec<_>>().leak();
    (Mesh::new(positions.leak(), normals.leak(), list).expect("indices are right"), list)
}

fn scene() -> Scene {
    let number = |tenths: i32| Scalar::from_num(tenths) / 10;
    let lens = Lens { field_of_view: Angle::from_degrees(40.0), aspect: number(20), near: number(10), far: number(80) };
    let camera = Camera {
        view: Matrix::<World, View>::translation(number(0), number(0), number(-30)),
        projection: Matrix::perspective(lens).expect("a lens"),
        viewport: Viewport::new(WINDOW).expect("pixels"),
    };
    let direction = Vector3::new(number(-9), number(7), number(5));
    Scene { camera, light: Lamp { direction, ambient: Light(2_500), diffuse: Light(60_000) } }
}
