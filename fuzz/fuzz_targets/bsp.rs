//! Trees of any triangles, from any eye: the pixels of the mesh, each triangle; lists of any numbers: no panic, and an end.
#![no_main]

use aquatint::{
    Clip, Dithered, Frame, Levels, Light, Matrix, Model, Point3, Point4, Rect, Rows, Scalar, Vector3, View, World,
    fragment::shade::Gouraud,
    geometry::{face::Faces, light::Lamp, viewport::Viewport},
    hidden::{
        bsp::{Arena, Choice, Node, Piece, Split, Tree, Triangles},
        convex::Convex,
        solid_bsp::SolidTree,
    },
    model::mesh::Mesh,
    pipeline::{Camera, Instance, Material, MeshVertex, Scene, TreeInstance, Workspace, draw_mesh, draw_tree},
};
use arbitrary::Arbitrary;
use embedded_graphics::pixelcolor::BinaryColor;
use libfuzzer_sys::fuzz_target;

const VERTICES: usize = 24;
const TRIANGLES: usize = 12;

#[derive(Arbitrary, Debug)]
struct Input {
    positions: Vec<[i16; 3]>,
    triangles: Vec<[u8; 3]>,
    candidates: u8,
    tolerance: u8,
    placement: [[i32; 4]; 3],
    projection: Option<[[i32; 4]; 4]>,
    eye: [i32; 4],
    to: [i32; 3],
    nodes: Vec<[u8; 5]>,
    pieces: Vec<[u8; 3]>,
    cuts: Vec<(bool, [u8; 2])>,
}

fuzz_target!(|input: Input| {
    let positions: Vec<_> = input.positions.iter().copied().take(VERTICES).collect();
    let Some(count) = u16::try_from(positions.len()).ok().filter(|&count| count > 0) else { return };
    let triangles: Vec<_> =
        input.triangles.iter().take(TRIANGLES).map(|corners| corners.map(|at| u16::from(at) % count)).collect();
    let list = Triangles::new(&positions, &triangles);

    let (mut nodes, mut pieces, mut cuts) = ([Node::EMPTY; 300], [Piece::EMPTY; 300], [Split::EMPTY; 500]);
    let choice = Choice::best_of(input.candidates.into()).with_tolerance(input.tolerance);
    if let Ok(tree) = Arena::new(&mut nodes, &mut pieces, &mut cuts).build(list, choice) {
        assert!(Tree::new(list, tree.nodes(), tree.pieces(), tree.cuts()).is_ok());
        assert_eq!(walked(&tree, &input), tree.pieces().len());
        draw(&input, &tree, &positions, &triangles);
    }

    // Low numbers, and none.
    let link = |v: u8| if v > 200 { u16::MAX } else { u16::from(v) };
    let nodes: Vec<_> = input.nodes.iter().map(|links| links.map(link)).collect();
    let nodes: Vec<_> =
        nodes.into_iter().map(|[face, parent, front, back, first]| Node { face, parent, front, back, first }).collect();
    let pieces: Vec<_> = input.pieces.iter().map(|links| links.map(link)).collect();
    let pieces: Vec<_> = pieces.into_iter().map(|[triangle, cut, next]| Piece { triangle, cut, next }).collect();
    let split = |&(is_back, [node, before]): &(bool, [u8; 2])| Split {
        side: u16::from(node) | u16::from(is_back) << 15,
        before: link(before),
    };
    let cuts: Vec<_> = input.cuts.iter().map(split).collect();
    if let Ok(tree) = Tree::new(list, &nodes, &pieces, &cuts) {
        assert!(walked(&tree, &input) <= pieces.len());
        draw(&input, &tree, &positions, &[]);
    }
});

/// In both orders, and as a solid.
fn walked(tree: &Tree<'_>, input: &Input) -> usize {
    let [x, y, z, w] = input.eye.map(Scalar::from_bits);
    let eye = Point4::<Model>::new(x, y, z, w);
    let [from, to] =
        [Point3::new(x, y, z), Point3::new(Scalar::from_bits(input.to[0]), Scalar::from_bits(input.to[1]), z)];
    let solid = SolidTree::new(*tree);
    let _ = (solid.place(from), solid.first_hit(from, to));
    let count = tree.back_to_front(eye).count();
    assert_eq!(tree.front_to_back(eye).count(), count);
    count
}

/// The pixels that a tree covers are those that its mesh covers.
fn draw(input: &Input, tree: &Tree<'_>, positions: &[[i16; 3]], triangles: &[[u16; 3]]) {
    let Some(scene) = scene(input) else { return };
    let normals = vec![[0, 0, 127]; positions.len()];
    let mesh = Mesh::new(positions, &normals, triangles).expect("indices are right");
    let [x, y, z] = input.placement.map(|row| row.map(Scalar::from_bits));
    let last = [Scalar::ZERO, Scalar::ZERO, Scalar::ZERO, Scalar::ONE];
    let placement = Matrix::<Model, World>::from_rows([x, y, z, last]);
    let material = Material { faces: Faces::Both, ..Material::new(Gouraud) };
    let instance = Instance::new(mesh, placement).with_material(material);
    let draw = |by_tree: bool| {
        let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 256], 64, 32).expect("large enough");
        let mut target = Dithered::new(&mut frame, Levels::ONE_BIT);
        let mut vertices = [MeshVertex::EMPTY; VERTICES];
        let mut workspace = Workspace { vertices: &mut vertices, hidden: &mut Convex };
        let is_drawn = if by_tree {
            draw_tree(&TreeInstance { instance, tree: *tree }, &scene, &mut workspace, &mut target).is_ok()
        } else {
            draw_mesh(&instance, &scene, &mut workspace, &mut target).is_ok()
        };
        (is_drawn, frame.bytes().to_vec())
    };
    let shown = draw(true);
    // Triangles without area are in no tree, but may be rounded to some.
    let is_in = |triangle: usize| tree.pieces().iter().any(|piece| usize::from(piece.triangle) == triangle);
    if !triangles.is_empty() && (0..triangles.len()).all(is_in) {
        assert_eq!(shown, draw(false));
    }
}

/// In full light, that every pixel is white.
fn scene(input: &Input) -> Option<Scene> {
    let one = Scalar::ONE;
    let rows = |rows: [[i32; 4]; 4]| rows.map(|row| row.map(Scalar::from_bits));
    let projection = match input.projection {
        Some(any) => Matrix::<View, Clip>::from_rows(rows(any)),
        None => Matrix::from_rows(rows([
            [80_000, 0, 0, 0],
            [0, 160_000, 0, 0],
            [0, 0, -70_000, -70_000],
            [0, 0, -65_536, 0],
        ])),
    };
    let viewport = Viewport::new(Rect::new(0, 0, 64, 32)).ok()?;
    let camera = Camera { view: Matrix::IDENTITY, projection, viewport };
    let direction = Vector3::new(one, one, one);
    Some(Scene { camera, light: Lamp { direction, ambient: Light::WHITE, diffuse: Light::BLACK } })
}
