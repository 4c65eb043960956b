//! Depth buffers, trees of triangles, rays and their hierarchy.
#![no_std]
#![no_main]

use core::{convert::Infallible, hint::black_box};

use aquatint::{
    Frame, Light, Matrix, Model, Point3, Point4, View, Words, World,
    geometry::{light::Lamp, viewport::Viewport},
    hidden::{
        Hidden,
        bsp::{Arena, Choice, Node, Piece, Split, Tree, TreeArrays, Triangles},
        depth::{Depth, DepthBuffer, DepthTest},
        raycast::{self, Block, Hierarchy, Objects, Plane, Ray, Shape, Sphere, Triangle},
        solid_bsp::SolidTree,
    },
    pipeline::{Camera, Finish, PixelRays, Raycast, draw_rays},
};
use nopanic::{any, keep, lent, part};

#[cortex_m_rt::entry]
fn main() -> ! {
    depths::<u8>();
    depths::<u16>();
    depths::<u32>();
    trees();
    read_trees();
    rays();
    loop {}
}

fn depths<D: Depth + Ord>() {
    let mut depths = [D::FARTHEST; 64];
    let Ok(mut buffer) = DepthBuffer::new(lent(&mut depths), any()) else { return };
    buffer.clear();
    keep((buffer.window(), buffer.run(any(), any()..any())));
    let buffer = buffer.with_test(black_box(DepthTest::Nearer));
    keep(Hidden::bounds(&buffer));
    buffer.without_writing().clear();
}

fn trees() {
    let (positions, triangles) = ([any(); 8], [any(); 8]);
    let list = Triangles::new(part(&positions), part(&triangles));
    keep((list.count(), list.vertices(any()), list.corners(any())));
    let (mut nodes, mut pieces, mut cuts) = ([Node::EMPTY; 16], [Piece::EMPTY; 16], [Split::EMPTY; 16]);
    let choice = Choice::best_of(any()).with_tolerance(any());
    if let Ok(tree) = Arena::new(lent(&mut nodes), lent(&mut pieces), lent(&mut cuts)).build(list, choice) {
        walk(&tree);
    }
    if let Ok(arrays) = TreeArrays::<16, 16, 16>::build(list, choice) {
        walk(&arrays.tree());
    }
}

fn read_trees() {
    let (positions, triangles) = ([any(); 8], [any(); 8]);
    let node = Node { face: any(), parent: any(), front: any(), back: any(), first: any() };
    let piece = Piece { triangle: any(), cut: any(), next: any() };
    let split = Split { side: any(), before: any() };
    keep((split.node(), split.is_front()));
    let (nodes, pieces, cuts) = ([node; 4], [piece; 4], [split; 4]);
    let list = Triangles::new(part(&positions), part(&triangles));
    if let Ok(tree) = Tree::new(list, part(&nodes), part(&pieces), part(&cuts)) {
        walk(&tree);
    }
}

fn walk(tree: &Tree<'_>) {
    let tree = black_box(tree);
    keep((tree.triangles().count(), tree.nodes(), tree.pieces(), tree.cuts()));
    tree.back_to_front(any::<Point4<Model>>()).for_each(keep);
    tree.front_to_back(any::<Point4<Model>>()).for_each(keep);
    let solid = SolidTree::new(*tree);
    keep((solid.place(any()), solid.line_of_sight(any(), any()), solid.first_hit(any(), any())));
}

fn shapes() -> Option<[Shape; 4]> {
    let sphere = Sphere::new(any(), any()).ok()?;
    let plane = Plane::new(any(), any()).ok()?;
    let triangle = Triangle::new(any()).ok()?;
    let block = Block::new(any(), any()).ok()?;
    Some(black_box([Shape::Sphere(sphere), Shape::Plane(plane), Shape::Triangle(triangle), Shape::Block(block)]))
}

fn rays() {
    let Some(shapes) = shapes() else { return };
    let mut nodes = [raycast::Node::default(); 16];
    let Ok(tree) = Hierarchy::new(part(&shapes), lent(&mut nodes)) else { return };
    if let (Ok(ray), Ok(between)) = (Ray::new(any(), any()), Ray::between(any(), any::<Point3<World>>())) {
        asked(&tree, &ray);
        asked(part(&shapes), &between);
    }
    drawn(tree);
    drawn(part(&shapes));
}

fn asked(objects: &(impl Objects + ?Sized), ray: &Ray) {
    keep(objects.is_hit(ray));
    if let Some(hit) = objects.nearest(ray) {
        keep((ray.reflected(&hit), hit.towards(any()), hit.ray_to(any())));
    }
}

fn drawn<O: Objects>(objects: O) {
    let Ok(viewport) = Viewport::new(any()) else { return };
    let camera = Camera { view: any::<Matrix<World, View>>(), projection: any(), viewport };
    let Ok(rays) = PixelRays::new(&camera) else { return };
    keep((rays.rect(), rays.run(any(), any()..any()).next()));
    let finishes = [Finish { diffuse: any(), mirror: any() }; 4];
    let lamp = Lamp { direction: any(), ambient: any(), diffuse: any() };
    let scene = Raycast { objects, finishes: part(&finishes), lamp, background: any() };
    let mut bytes = [0; 64];
    let Ok(mut frame) = Frame::<Light, Words, _>::new(lent(&mut bytes), any(), any()) else { return };
    let drawn: Result<(), Infallible> = draw_rays(&scene, &rays, &mut frame);
    keep(drawn);
}
