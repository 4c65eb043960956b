//! Lines, polygons, boxes and spheres against windows, volumes and planes.
#![no_std]
#![no_main]

use core::convert::Infallible;

use aquatint::{
    BoundingBox, BoundingBox3, BoundingCircle, BoundingSphere, Clip, ClipPlane, ClipVertex, ClipWindow, ConvexWindow,
    Frustum, HalfSpace, Matrix, Model, Outcode, Point2, Point3, Point4, Rect, World,
    clip::{
        cohen_sutherland, cohen_sutherland_3d,
        frustum::BoundingVolume,
        liang_barsky, liang_barsky_3d,
        separate::{Node, separate},
        sutherland_hodgman::{self, Pipeline, Stage},
        sutherland_hodgman_3d,
        volume::{self, Plane, Volume},
        window::{Boundary, HalfPlane, PlanePoint},
    },
    vary::Vertex,
};
use embedded_graphics::geometry::Point;
use heapless::Vec;
use nopanic::{Any, any, keep, lent, one_of, part, some};

/// What a caller lends.
struct Memory {
    pixels: [Point; 8],
    points: [Point2; 8],
    places: [[i16; 3]; 8],
    in_space: [Point3<World>; 8],
    polygon: Vec<Point2, 32>,
    vertices: Vec<Vertex<2>, 8>,
    clipped: Vec<Vertex<2>, 32>,
    stages: Vec<Stage<Point2>, 8>,
    pieces: Vec<Node, 64>,
    corners: Vec<ClipVertex<2>, 16>,
    spare: Vec<ClipVertex<2>, 16>,
}

const MEMORY: Memory = Memory {
    pixels: [Point::zero(); 8],
    points: [Point2::corner(0, 0); 8],
    places: [[0; 3]; 8],
    in_space: [Point3::ORIGIN; 8],
    polygon: Vec::new(),
    vertices: Vec::new(),
    clipped: Vec::new(),
    stages: Vec::new(),
    pieces: Vec::new(),
    corners: Vec::new(),
    spare: Vec::new(),
};

nopanic::entries! { MEMORY;
    outcode,
    cohen_sutherland_pixels = cohen_sutherland::<Point>,
    cohen_sutherland_points = cohen_sutherland::<Point2>,
    liang_barsky_pixels = liang_barsky::<Point>,
    liang_barsky_points = liang_barsky::<Point2>,
    bounds_of_pixels,
    bounds_of_points,
    convex_window,
    sutherland_hodgman_half_plane,
    sutherland_hodgman_rectangle,
    sutherland_hodgman_attributes,
    sutherland_hodgman_pipeline,
    build_pipeline,
    separate_polygon,
    volume_outcode,
    cohen_sutherland_3d,
    liang_barsky_3d,
    liang_barsky_3d_planes,
    sutherland_hodgman_3d,
    half_space,
    frustum,
    bounding_sphere,
    bounding_sphere_collides,
    bounding_sphere_against,
    bounding_box_3,
    bounding_box_3_transformed,
    bounding_box_3_against,
}

fn outcode(_: &mut Memory) {
    let code = Outcode::of(any(), any());
    keep((code.is_inside(), code.is_left(), code.is_right(), code.is_above(), code.is_below()));
}

fn window<P: PlanePoint + Any>() -> ClipWindow<P> {
    ClipWindow::new(any(), any())
}

fn cohen_sutherland<P: PlanePoint + Any>(_: &mut Memory) {
    keep(cohen_sutherland::clip((any::<P>(), any()), window()));
    keep((window::<P>().outcode(any()), window::<P>().half_planes()));
}

fn liang_barsky<P: PlanePoint + Any>(_: &mut Memory)
where
    ClipWindow<P>: From<Rect>,
{
    keep(liang_barsky::clip((any::<P>(), any()), window()));
    keep(liang_barsky::clip((any::<P>(), any()), any::<Rect>()));
}

fn bounds_of_pixels(memory: &mut Memory) {
    bounds(some(&mut memory.pixels));
}

fn bounds_of_points(memory: &mut Memory) {
    bounds(some(&mut memory.points));
}

fn bounds<P: PlanePoint + Any>(points: &[P]) {
    if let Some(bounds) = BoundingBox::of(points.iter().copied()) {
        keep((bounds.min(), bounds.max(), bounds.against(window())));
    }
    if let Some(bounds) = BoundingCircle::of(points.iter().copied()) {
        let other = BoundingCircle::new(any::<P>(), any());
        keep((bounds.center(), bounds.radius(), bounds.against(window()), bounds.against_circle(&other)));
    }
}

fn convex_window(memory: &mut Memory) {
    if let Ok(window) = ConvexWindow::new(some(&mut memory.points)) {
        window.half_planes().for_each(keep);
    }
    if let Ok(window) = ConvexWindow::new(part(&SQUARE)) {
        window.half_planes().for_each(keep);
    }
}

const SQUARE: [Point2; 4] =
    [Point2::corner(0, 0), Point2::corner(30, 0), Point2::corner(30, 30), Point2::corner(0, 30)];

fn half_planes() -> [HalfPlane; 4] {
    window::<Point2>().half_planes()
}

fn sutherland_hodgman_half_plane(memory: &mut Memory) {
    let Ok(side) = HalfPlane::new(any(), any()) else { return };
    keep(sutherland_hodgman::clip(some(&mut memory.points), |v| side.distance(v), &mut memory.polygon));
    keep(memory.polygon.as_slice());
}

fn sutherland_hodgman_rectangle(memory: &mut Memory) {
    keep(sutherland_hodgman::clip_to_rectangle(some(&mut memory.points), any::<Rect>(), &mut memory.polygon));
}

fn sutherland_hodgman_attributes(memory: &mut Memory) {
    memory.vertices.clear();
    while memory.vertices.push(Vertex { position: any(), attributes: any() }).is_ok() {}
    keep(sutherland_hodgman::clip_to_rectangle(part(&memory.vertices), any::<Rect>(), &mut memory.clipped));
    keep(memory.clipped.as_slice());
}

fn sutherland_hodgman_pipeline(memory: &mut Memory) {
    memory.stages.clear();
    keep(memory.stages.extend_from_slice(&half_planes().map(Stage::new)));
    let mut pipeline = Pipeline::new(lent(&mut memory.stages));
    let mut emit = |v: Point2| {
        keep(v);
        Ok::<(), Infallible>(())
    };
    keep(pipeline.clip(some(&mut memory.points), &mut emit));
    keep(pipeline.push(any(), &mut emit));
    keep(pipeline.close(&mut emit));
}

fn build_pipeline(memory: &mut Memory) {
    keep(Pipeline::build(half_planes(), &mut memory.stages).is_ok());
}

fn separate_polygon(memory: &mut Memory) {
    let corners = some(&mut memory.points);
    let contours = [corners, part(corners)];
    let Ok(mut pieces) = separate(part(&contours), half_planes(), &mut memory.pieces) else { return };
    while pieces.next_into(&mut memory.polygon) == Ok(true) {
        keep(memory.polygon.as_slice());
    }
}

fn vertex() -> ClipVertex<2> {
    ClipVertex { point: any(), attributes: any() }
}

fn volume() -> Volume {
    one_of(&[Volume::View, Volume::GuardBand])
}

fn volume_outcode(_: &mut Memory) {
    let (volume, place) = (volume(), any::<Point4<Clip>>());
    keep((volume.is_inside(&place), volume.outcode(&place), volume::outcode(&place)));
    for face in volume.faces() {
        keep((face.plane(), face.plane().distance(&place), Boundary::distance(&face, &place)));
    }
    keep(Plane::ALL.map(|plane| plane.distance(&place)));
}

fn cohen_sutherland_3d(_: &mut Memory) {
    keep(cohen_sutherland_3d::clip((vertex(), vertex()), volume()));
    keep(cohen_sutherland_3d::clip_with((vertex(), vertex()), any(), volume()));
}

fn liang_barsky_3d(_: &mut Memory) {
    keep(liang_barsky_3d::clip((vertex(), vertex()), volume()));
}

fn liang_barsky_3d_planes(_: &mut Memory) {
    let Ok(plane) = ClipPlane::new(any()) else { return };
    keep(liang_barsky_3d::clip_to((vertex(), vertex()), part(&[plane; 6]).iter().copied()));
}

fn sutherland_hodgman_3d(memory: &mut Memory) {
    let Ok(plane) = ClipPlane::new(any()) else { return };
    memory.corners.clear();
    for _ in 0..any::<u8>() {
        keep(memory.corners.push(vertex()));
    }
    let planes = [plane; 6];
    let clipped = sutherland_hodgman_3d::clip(&mut memory.corners, &mut memory.spare, part(&planes), volume());
    keep(clipped);
    keep(memory.corners.as_slice());
}

fn half_space(_: &mut Memory) {
    let Ok(side) = HalfSpace::<World>::new(any(), any()) else { return };
    let Ok(other) = HalfSpace::<World>::through(any(), any()) else { return };
    keep((side.opposite(), other.contains(any()), side.in_clip_space(&any::<Matrix<World, Clip>>())));
}

fn frustum(_: &mut Memory) {
    if let Ok(frustum) = Frustum::<World>::new(&any()) {
        keep(frustum.sides());
    }
}

fn bounding_sphere(memory: &mut Memory) {
    let Some(sphere) = BoundingSphere::of(some(&mut memory.in_space).iter().copied()) else { return };
    keep((sphere.center(), sphere.radius(), sphere.contains(&any())));
    keep(sphere.transformed(&any::<Matrix<World, Model>>()));
}

fn sphere() -> BoundingSphere<World> {
    BoundingSphere::new(any(), any())
}

fn bounding_sphere_collides(memory: &mut Memory) {
    keep((sphere().collides(&sphere()), sphere().union(&sphere())));
    if let Some(cuboid) = cuboid(memory) {
        keep(sphere().collides_with_box(&cuboid));
    }
}

fn bounding_sphere_against(_: &mut Memory) {
    if let Ok(frustum) = Frustum::<World>::new(&any()) {
        keep(sphere().against(&frustum));
    }
    if let Ok(side) = HalfSpace::<World>::new(any(), any()) {
        keep(sphere().against_half_space(&side));
    }
}

fn cuboid(memory: &mut Memory) -> Option<BoundingBox3<World>> {
    BoundingBox3::of(some(&mut memory.in_space).iter().copied())
}

fn bounding_box_3(memory: &mut Memory) {
    let (Some(cuboid), Some(other)) = (cuboid(memory), cuboid(memory)) else { return };
    keep((cuboid.min(), cuboid.max(), cuboid.union(&other), cuboid.contains(&any()), cuboid.collides(&other)));
}

fn bounding_box_3_transformed(memory: &mut Memory) {
    if let Some(model) = BoundingBox3::of_places(some(&mut memory.places)) {
        keep(model.transformed(&any::<Matrix<Model, World>>()));
    }
}

fn bounding_box_3_against(memory: &mut Memory) {
    let Some(cuboid) = cuboid(memory) else { return };
    if let Ok(frustum) = Frustum::<World>::new(&any()) {
        keep(cuboid.against(&frustum));
    }
    if let Ok(side) = HalfSpace::<World>::new(any(), any()) {
        keep(cuboid.against_half_space(&side));
    }
}
