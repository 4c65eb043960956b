//! Depth buffers, trees of triangles, rays and their hierarchy.
#![no_std]
#![no_main]

use core::convert::Infallible;

use aquatint::{
    Frame, Light, Model, Point3, Point4, Words, World,
    geometry::light::Lamp,
    hidden::{
        Hidden,
        bsp::{Arena, Choice, Node, Piece, Split, Tree, TreeArrays, Triangles},
        depth::{Depth, DepthBuffer, DepthTest},
        raycast::{self, Block, Hierarchy, Objects, Plane, Ray, Shape, Sphere, Triangle},
        solid_bsp::SolidTree,
    },
    pipeline::{Finish, PixelRays, Raycast},
};
use heapless::Vec;
use nopanic::{
    any, keep, lent, one_of, part,
    scenes::{built_tree, camera},
    side, some,
};

/// What a caller lends.
struct Memory {
    depths_8: [u8; 1536],
    depths_16: [u16; 1536],
    depths_32: [u32; 1536],
    positions: [[i16; 3]; 8],
    triangles: [[u16; 3]; 8],
    nodes: [Node; 16],
    pieces: [Piece; 16],
    cuts: [Split; 16],
    shapes: Vec<Shape, 4>,
    boxes: Vec<raycast::Node, 16>,
    finishes: [Finish; 4],
    /// Those that [`pixel_rays`] found.
    rays: [Option<PixelRays>; 8],
    bytes: [u8; 4096],
}

const MEMORY: Memory = Memory {
    depths_8: [0; 1536],
    depths_16: [0; 1536],
    depths_32: [0; 1536],
    positions: [[0; 3]; 8],
    triangles: [[0; 3]; 8],
    nodes: [Node::EMPTY; 16],
    pieces: [Piece::EMPTY; 16],
    cuts: [Split::EMPTY; 16],
    shapes: Vec::new(),
    boxes: Vec::new(),
    finishes: [Finish { diffuse: 0, mirror: 0 }; 4],
    rays: [None; 8],
    bytes: [0; 4096],
};

nopanic::entries! { MEMORY;
    depth_buffer_u8 = |memory: &mut Memory| depth_buffer(&mut memory.depths_8),
    depth_buffer_u16 = |memory: &mut Memory| depth_buffer(&mut memory.depths_16),
    depth_buffer_u32 = |memory: &mut Memory| depth_buffer(&mut memory.depths_32),
    triangles,
    build_tree,
    build_tree_arrays,
    read_tree,
    back_to_front,
    front_to_back,
    solid_tree_place,
    line_of_sight,
    first_hit,
    hierarchy,
    ray_new,
    is_hit,
    nearest,
    is_hit_in_hierarchy,
    nearest_in_hierarchy,
    pixel_rays,
    draw_rays,
    draw_rays_in_hierarchy,
}

fn depth_buffer<D: Depth + Ord>(depths: &mut [D]) {
    let Ok(mut buffer) = DepthBuffer::new(lent(depths), any()) else { return };
    buffer.clear();
    keep((buffer.window(), buffer.run(any(), any()..any())));
    let buffer = buffer.with_test(one_of(&[DepthTest::Nearer, DepthTest::NotFarther]));
    keep(Hidden::bounds(&buffer));
    buffer.without_writing().clear();
}

impl Memory {
    fn triangles(&mut self) -> Triangles<'_> {
        Triangles::new(some(&mut self.positions), some(&mut self.triangles))
    }

    /// A tree that was built before, or one that somebody made up.
    fn tree(&mut self) -> Option<Tree<'_>> {
        if any::<u16>() > 1 {
            return Some(built_tree());
        }
        self.nodes.fill_with(|| Node { face: any(), parent: any(), front: any(), back: any(), first: any() });
        self.pieces.fill_with(|| Piece { triangle: any(), cut: any(), next: any() });
        self.cuts.fill_with(|| Split { side: any(), before: any() });
        let list = Triangles::new(some(&mut self.positions), some(&mut self.triangles));
        Tree::new(list, part(&self.nodes), part(&self.pieces), part(&self.cuts)).ok()
    }

    fn shapes(&mut self) -> &[Shape] {
        self.shapes.clear();
        while let Some(Ok(())) = shape().map(|shape| self.shapes.push(shape)) {}
        &self.shapes
    }

    fn hierarchy(&mut self) -> Option<Hierarchy<'_>> {
        self.shapes();
        keep(self.boxes.resize_default(16));
        Hierarchy::new(&self.shapes, lent(&mut self.boxes)).ok()
    }
}

fn triangles(memory: &mut Memory) {
    let list = memory.triangles();
    keep((list.count(), list.vertices(any()), list.corners(any())));
}

fn choice() -> Choice {
    Choice::best_of(any()).with_tolerance(any())
}

fn build_tree(memory: &mut Memory) {
    let list = Triangles::new(some(&mut memory.positions), some(&mut memory.triangles));
    let arena = Arena::new(lent(&mut memory.nodes), lent(&mut memory.pieces), lent(&mut memory.cuts));
    keep(arena.build(list, choice()).is_ok());
}

fn build_tree_arrays(memory: &mut Memory) {
    if let Ok(arrays) = TreeArrays::<16, 16, 16>::build(memory.triangles(), choice()) {
        keep(arrays.tree().nodes());
    }
}

fn read_tree(memory: &mut Memory) {
    let split = Split { side: any(), before: any() };
    keep((split.node(), split.is_front()));
    if let Some(tree) = memory.tree() {
        keep((tree.triangles().count(), tree.nodes(), tree.pieces(), tree.cuts()));
    }
}

fn back_to_front(memory: &mut Memory) {
    if let Some(tree) = memory.tree() {
        tree.back_to_front(any::<Point4<Model>>()).for_each(keep);
    }
}

fn front_to_back(memory: &mut Memory) {
    if let Some(tree) = memory.tree() {
        tree.front_to_back(any::<Point4<Model>>()).for_each(keep);
    }
}

fn solid_tree_place(memory: &mut Memory) {
    if let Some(tree) = memory.tree() {
        keep(SolidTree::new(tree).place(any()));
    }
}

fn line_of_sight(memory: &mut Memory) {
    if let Some(tree) = memory.tree() {
        keep(SolidTree::new(tree).line_of_sight(any(), any()));
    }
}

fn first_hit(memory: &mut Memory) {
    if let Some(tree) = memory.tree() {
        keep(SolidTree::new(tree).first_hit(any(), any()));
    }
}

#[inline(never)]
fn shape() -> Option<Shape> {
    Some(match any::<u16>() {
        0 | 1 => Shape::Sphere(Sphere::new(any(), any()).ok()?),
        2 | 3 => Shape::Plane(Plane::new(any(), any()).ok()?),
        4 | 5 => Shape::Triangle(Triangle::new(any()).ok()?),
        _ => Shape::Block(Block::new(any(), any()).ok()?),
    })
}

fn ray() -> Option<Ray> {
    if any() { Ray::new(any(), any()).ok() } else { Ray::between(any(), any::<Point3<World>>()).ok() }
}

fn hierarchy(memory: &mut Memory) {
    keep(memory.hierarchy().is_some());
}

fn ray_new(_: &mut Memory) {
    keep(ray());
}

fn is_hit(memory: &mut Memory) {
    if let Some(ray) = ray() {
        keep(memory.shapes().is_hit(&ray));
    }
}

fn is_hit_in_hierarchy(memory: &mut Memory) {
    if let (Some(ray), Some(tree)) = (ray(), memory.hierarchy()) {
        keep(tree.is_hit(&ray));
    }
}

fn nearest(memory: &mut Memory) {
    asked(memory.shapes());
}

fn nearest_in_hierarchy(memory: &mut Memory) {
    if let Some(tree) = memory.hierarchy() {
        asked(&tree);
    }
}

fn asked(objects: &(impl Objects + ?Sized)) {
    let Some(ray) = ray() else { return };
    if let Some(hit) = objects.nearest(&ray) {
        keep((ray.reflected(&hit), hit.towards(any()), hit.ray_to(any())));
    }
}

fn pixel_rays(memory: &mut Memory) {
    let Some(camera) = camera() else { return };
    let Ok(rays) = PixelRays::new(&camera) else { return };
    keep((rays.rect(), rays.run(any(), any()..any()).next()));
    if let Some(place) = memory.rays.get_mut(any::<usize>()) {
        *place = Some(rays);
    }
}

fn draw_rays(memory: &mut Memory) {
    memory.shapes();
    drawn(&memory.shapes[..], memory.rays.get(any::<usize>()), &mut memory.finishes, &mut memory.bytes);
}

fn draw_rays_in_hierarchy(memory: &mut Memory) {
    memory.shapes();
    keep(memory.boxes.resize_default(16));
    let Ok(tree) = Hierarchy::new(&memory.shapes, lent(&mut memory.boxes)) else { return };
    drawn(tree, memory.rays.get(any::<usize>()), &mut memory.finishes, &mut memory.bytes);
}

fn drawn<O: Objects>(objects: O, rays: Option<&Option<PixelRays>>, finishes: &mut [Finish], bytes: &mut [u8]) {
    let Some(Some(rays)) = rays else { return };
    finishes.fill_with(|| Finish { diffuse: any(), mirror: any() });
    let lamp = Lamp { direction: any(), ambient: any(), diffuse: any() };
    let scene = Raycast { objects, finishes: part(finishes), lamp, background: any() };
    let Ok(mut frame) = Frame::<Light, Words, _>::new(lent(bytes), side(), side()) else { return };
    let drawn: Result<(), Infallible> = aquatint::pipeline::draw_rays(&scene, rays, &mut frame);
    keep(drawn);
}
