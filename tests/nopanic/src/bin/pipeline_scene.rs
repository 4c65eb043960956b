//! Scenes row by row, trees, object space, depth sort; rays for a mesh.
#![no_std]
#![no_main]

use core::hint::black_box;

use aquatint::{
    Dithered, Frame, HalfSpace, Levels, Light, Rect, Rows, Words,
    fragment::shade::{Flat, Gouraud, Phong, Shading},
    hidden::{
        bsp::{Node, Piece, Split, Tree, Triangles},
        convex::Convex,
        object_space::{ComparedFace, PartBound},
        painter::{PieceCorner, PieceCut, SortedPiece},
        raycast::{Shape, Sphere},
    },
    model::mesh::Mesh,
    pipeline::{
        DepthSortMemory, Instance, ListedFace, MeshVertex, ObjectSpaceMemory, Scanlines, SceneMemory, TreeInstance,
        Workspace, draw_scene, draw_tree,
    },
};
use embedded_graphics::pixelcolor::BinaryColor;
use heapless::Vec;
use nopanic::{
    any, keep, lent, part,
    scenes::{Model, PAIR, built_tree, camera, material, scene},
    side,
};

/// What a caller lends.
struct Memory {
    models: [Model; 2],
    bytes: [u8; 4096],
    vertices: [MeshVertex; 16],
    gouraud: SceneMemory<16, 16, 16, Gouraud>,
    flat: SceneMemory<16, 16, 16, Flat>,
    phong: SceneMemory<16, 16, 16, Phong>,
    nodes: [Node; 16],
    pieces: [Piece; 16],
    cuts: [Split; 16],
    shapes: Vec<Shape, 12>,
    faces: Vec<ListedFace, 16>,
    compared: Vec<ComparedFace, 16>,
    bounds: Vec<PartBound, 48>,
    sorted: Vec<SortedPiece, 32>,
    corners: Vec<PieceCorner, 160>,
    piece_cuts: Vec<PieceCut, 32>,
}

const MEMORY: Memory = Memory {
    models: [Model::NEW; 2],
    bytes: [0; 4096],
    vertices: [MeshVertex::EMPTY; 16],
    gouraud: SceneMemory::NEW,
    flat: SceneMemory::NEW,
    phong: SceneMemory::NEW,
    nodes: [Node::EMPTY; 16],
    pieces: [Piece::EMPTY; 16],
    cuts: [Split::EMPTY; 16],
    shapes: Vec::new(),
    faces: Vec::new(),
    compared: Vec::new(),
    bounds: Vec::new(),
    sorted: Vec::new(),
    corners: Vec::new(),
    piece_cuts: Vec::new(),
};

nopanic::entries! { MEMORY;
    draw_scene_gouraud = |memory: &mut Memory| {
        draw(Gouraud, &mut memory.gouraud, &mut memory.models, &mut memory.bytes);
    },
    draw_scene_flat = |memory: &mut Memory| draw(Flat, &mut memory.flat, &mut memory.models, &mut memory.bytes),
    draw_scene_phong = |memory: &mut Memory| draw(Phong, &mut memory.phong, &mut memory.models, &mut memory.bytes),
    scanlines_gouraud = |memory: &mut Memory| {
        scanned(Gouraud, &mut memory.gouraud, &mut memory.models, &mut memory.bytes);
    },
    scanlines_flat = |memory: &mut Memory| scanned(Flat, &mut memory.flat, &mut memory.models, &mut memory.bytes),
    scanlines_phong = |memory: &mut Memory| scanned(Phong, &mut memory.phong, &mut memory.models, &mut memory.bytes),
    draw_built_tree,
    draw_made_up_tree,
    draw_compared,
    draw_sorted,
    mesh_shapes,
    camera_clip_plane,
}

type Scenery<S> = SceneMemory<16, 16, 16, S>;

/// Instances of two models.
fn instances<S: Shading + Copy>(models: &mut [Model; 2], shading: S) -> Option<[Instance<'_, S>; 2]> {
    let [one, other] = models;
    Some([
        Instance::new(one.mesh()?, any()).with_material(material(shading)),
        Instance::new(other.mesh()?, any()).with_material(material(shading)),
    ])
}

fn draw<S>(shading: S, memory: &mut Scenery<S>, models: &mut [Model; 2], bytes: &mut [u8])
where
    S: Shading<Color = Light> + Copy,
{
    let (Some(instances), Some(scene)) = (instances(models, shading), scene()) else { return };
    let Ok(mut frame) = Frame::<BinaryColor, Rows, _>::new(lent(bytes), side(), side()) else { return };
    let mut light = Dithered::new(&mut frame, Levels::ONE_BIT);
    keep(draw_scene(&instances, &scene, memory, &mut light).is_ok());
}

fn scanned<S>(shading: S, memory: &mut Scenery<S>, models: &mut [Model; 2], bytes: &mut [u8])
where
    S: Shading<Color = Light> + Copy,
{
    let (Some(instances), Some(scene)) = (instances(models, shading), scene()) else { return };
    let Ok(mut frame) = Frame::<BinaryColor, Rows, _>::new(lent(bytes), side(), side()) else { return };
    let mut light = Dithered::new(&mut frame, Levels::ONE_BIT);
    let mut memory = memory.lend();
    memory.vertices = lent(memory.vertices);
    memory.buckets = lent(memory.buckets);
    let mut rows = Scanlines::new(any::<Rect>(), memory);
    keep(rows.begin(&instances, &scene).is_ok());
    while let Some(row) = rows.row() {
        keep((row, rows.draw_row(&mut light).is_ok()));
    }
}

/// That of the mesh.
fn draw_built_tree(memory: &mut Memory) {
    tree_drawn(PAIR, built_tree(), &mut memory.vertices, &mut memory.bytes);
}

/// One that somebody made up.
fn draw_made_up_tree(memory: &mut Memory) {
    let [model, listed] = &mut memory.models;
    let Some(mesh) = model.mesh() else { return };
    memory.nodes.fill_with(|| Node { face: any(), parent: any(), front: any(), back: any(), first: any() });
    memory.pieces.fill_with(|| Piece { triangle: any(), cut: any(), next: any() });
    memory.cuts.fill_with(|| Split { side: any(), before: any() });
    let list = Triangles::new(part(&listed.positions), part(&listed.triangles));
    if let Ok(tree) = Tree::new(list, part(&memory.nodes), part(&memory.pieces), part(&memory.cuts)) {
        tree_drawn(mesh, tree, &mut memory.vertices, &mut memory.bytes);
    }
}

fn tree_drawn(mesh: Mesh<'_>, tree: Tree<'_>, vertices: &mut [MeshVertex], bytes: &mut [u8]) {
    let Some(scene) = scene() else { return };
    let Ok(mut frame) = Frame::<Light, Words, _>::new(lent(bytes), side(), side()) else { return };
    let instance = Instance::new(mesh, any()).with_material(material(Gouraud));
    let mut workspace = Workspace { vertices: lent(vertices), hidden: &mut Convex };
    keep(draw_tree(&TreeInstance { instance, tree }, &scene, &mut workspace, &mut frame).is_ok());
}

/// In object space, in lists of any length.
fn draw_compared(memory: &mut Memory) {
    let (Some(instances), Some(scene)) = (instances(&mut memory.models, Gouraud), scene()) else { return };
    let Ok(mut frame) = Frame::<Light, Words, _>::new(lent(&mut memory.bytes), side(), side()) else { return };
    let memory = ObjectSpaceMemory {
        vertices: lent(&mut memory.vertices),
        faces: black_box(&mut memory.faces),
        compared: black_box(&mut memory.compared),
        bounds: black_box(&mut memory.bounds),
    };
    keep(aquatint::pipeline::draw_compared(&instances, &scene, memory, &mut frame).is_ok());
}

/// By depth, in lists of any length.
fn draw_sorted(memory: &mut Memory) {
    let (Some(instances), Some(scene)) = (instances(&mut memory.models, Gouraud), scene()) else { return };
    let Ok(mut frame) = Frame::<Light, Words, _>::new(lent(&mut memory.bytes), side(), side()) else { return };
    let memory = DepthSortMemory {
        vertices: lent(&mut memory.vertices),
        faces: black_box(&mut memory.faces),
        pieces: black_box(&mut memory.sorted),
        corners: black_box(&mut memory.corners),
        cuts: black_box(&mut memory.piece_cuts),
    };
    keep(aquatint::pipeline::draw_sorted(&instances, &scene, memory, &mut frame).is_ok());
}

fn mesh_shapes(memory: &mut Memory) {
    let (Some(mesh), Ok(sphere)) = (memory.models[0].mesh(), Sphere::new(any(), any())) else { return };
    keep(memory.shapes.resize(12, Shape::Sphere(sphere)));
    keep(aquatint::pipeline::mesh_shapes(&Instance::new(mesh, any()), lent(&mut memory.shapes)));
}

fn camera_clip_plane(_: &mut Memory) {
    let (Some(camera), Ok(side)) = (camera(), HalfSpace::new(any(), any())) else { return };
    keep(camera.clip_plane(&side));
}
