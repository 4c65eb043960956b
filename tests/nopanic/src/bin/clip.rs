//! Lines, polygons, boxes and spheres against windows, volumes and planes.
#![no_std]
#![no_main]

use core::{convert::Infallible, hint::black_box};

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
use nopanic::{Any, any, keep, lent, part};

#[cortex_m_rt::entry]
fn main() -> ! {
    lines::<Point>();
    lines::<Point2>();
    outcodes();
    polygons();
    pipelines();
    pieces();
    volumes();
    spaces();
    loop {}
}

fn lines<P: PlanePoint + Any>()
where
    ClipWindow<P>: From<Rect>,
{
    let window = ClipWindow::new(any::<P>(), any());
    keep(cohen_sutherland::clip((any::<P>(), any()), window));
    keep(liang_barsky::clip((any::<P>(), any()), window));
    keep(liang_barsky::clip((any::<P>(), any()), any::<Rect>()));
    keep((window.outcode(any()), window.half_planes()));
    let points = [any::<P>(); 8];
    if let Some(bounds) = BoundingBox::of(part(&points).iter().copied()) {
        keep((bounds.min(), bounds.max(), bounds.against(window)));
    }
    if let Some(bounds) = BoundingCircle::of(part(&points).iter().copied()) {
        let other = BoundingCircle::new(any::<P>(), any());
        keep((bounds.center(), bounds.radius(), bounds.against(window), bounds.against_circle(&other)));
    }
}

fn outcodes() {
    let code = Outcode::of(any(), any());
    keep((code.is_inside(), code.is_left(), code.is_right(), code.is_above(), code.is_below()));
}

fn half_planes() -> [HalfPlane; 4] {
    ClipWindow::new(any::<Point2>(), any()).half_planes()
}

fn polygons() {
    let corners = [any::<Point2>(); 8];
    let mut list = Vec::<Point2, 32>::new();
    let Ok(side) = HalfPlane::new(any(), any()) else { return };
    keep(sutherland_hodgman::clip(part(&corners), |v| side.distance(v), &mut list));
    keep(list.as_slice());
    keep(sutherland_hodgman::clip_to_rectangle(part(&corners), any::<Rect>(), &mut list));
    let vertices = [(); 8].map(|()| Vertex { position: any(), attributes: any::<[u16; 2]>() });
    let mut list = Vec::<Vertex<2>, 32>::new();
    keep(sutherland_hodgman::clip_to_rectangle(part(&vertices), any::<Rect>(), &mut list));
    keep(list.as_slice());
    if let Ok(window) = ConvexWindow::new(part(&corners)) {
        window.half_planes().for_each(keep);
    }
}

fn pipelines() {
    let mut stages = half_planes().map(Stage::<Point2, HalfPlane>::new);
    let mut pipeline = Pipeline::new(lent(&mut stages));
    let corners = [any::<Point2>(); 8];
    let mut emit = |v: Point2| {
        keep(v);
        Ok::<(), Infallible>(())
    };
    keep(pipeline.clip(part(&corners), &mut emit));
    keep(pipeline.push(any(), &mut emit));
    keep(pipeline.close(&mut emit));
    let mut memory = Vec::<Stage<Point2>, 8>::new();
    keep(Pipeline::build(half_planes(), &mut memory).is_ok());
}

fn pieces() {
    let corners = [any::<Point2>(); 8];
    let contours = [part(&corners), part(&corners)];
    let (mut memory, mut list) = (Vec::<Node, 64>::new(), Vec::<Point2, 32>::new());
    let Ok(mut pieces) = separate(part(&contours), half_planes(), &mut memory) else { return };
    while pieces.next_into(&mut list) == Ok(true) {
        keep(list.as_slice());
    }
}

fn vertex() -> ClipVertex<2> {
    ClipVertex { point: any(), attributes: any() }
}

fn volumes() {
    let (volume, place) = (black_box(Volume::View), any::<Point4<Clip>>());
    keep((volume.is_inside(&place), volume.outcode(&place), volume::outcode(&place)));
    for face in volume.faces() {
        keep((face.plane(), face.plane().distance(&place), Boundary::distance(&face, &place)));
    }
    keep(Plane::ALL.map(|plane| plane.distance(&place)));
    keep(cohen_sutherland_3d::clip((vertex(), vertex()), volume));
    keep(cohen_sutherland_3d::clip_with((vertex(), vertex()), any(), volume));
    keep(liang_barsky_3d::clip((vertex(), vertex()), volume));
    let Ok(plane) = ClipPlane::new(any()) else { return };
    let planes = [plane; 6];
    keep(liang_barsky_3d::clip_to((vertex(), vertex()), part(&planes).iter().copied()));
    let (mut polygon, mut spare) = (Vec::<ClipVertex<2>, 16>::new(), Vec::<ClipVertex<2>, 16>::new());
    keep(polygon.extend_from_slice(part(&[vertex(); 8])));
    if let Ok(clipped) = sutherland_hodgman_3d::clip(&mut polygon, &mut spare, part(&planes), volume) {
        keep(clipped.as_slice());
    }
}

fn spaces() {
    let Ok(side) = HalfSpace::<World>::new(any(), any()) else { return };
    let Ok(other) = HalfSpace::<World>::through(any(), any()) else { return };
    keep((side.opposite(), other.contains(any()), side.in_clip_space(&any::<Matrix<World, Clip>>())));
    let points = [any::<Point3<World>>(); 8];
    let part = || part(&points).iter().copied();
    let Ok(frustum) = Frustum::<World>::new(&any()) else { return };
    keep(frustum.sides());
    let (Some(sphere), Some(cuboid)) = (BoundingSphere::of(part()), BoundingBox3::of(part())) else { return };
    let other = BoundingSphere::new(any(), any());
    keep((sphere.center(), sphere.radius(), sphere.contains(&any()), sphere.collides(&other), sphere.union(&other)));
    keep((sphere.collides_with_box(&cuboid), sphere.transformed(&any::<Matrix<World, Model>>())));
    keep((sphere.against(&frustum), sphere.against_half_space(&side)));
    boxes(&cuboid, &frustum, &side);
}

fn boxes(cuboid: &BoundingBox3<World>, frustum: &Frustum<World>, side: &HalfSpace<World>) {
    let places = [any::<[i16; 3]>(); 8];
    let Some(model) = BoundingBox3::of_places(part(&places)) else { return };
    let other = model.transformed(&any::<Matrix<Model, World>>());
    keep((cuboid.min(), cuboid.max(), cuboid.union(&other), cuboid.contains(&any()), cuboid.collides(&other)));
    keep((cuboid.against(frustum), cuboid.against_half_space(side)));
}
