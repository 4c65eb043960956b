//! Matrices, quaternions, projections, faces, lamps, fog; meshes, solids and affine maps.
#![no_std]
#![no_main]

use core::hint::black_box;

use aquatint::{
    Affine, Angle, Arc, Chord, Clip, Fog, Illumination, Light, Matrix, Model, Oval, Placed, Point2, Point3, Rect,
    Sector, Vector3, View, World,
    geometry::{
        face::{self, Faces},
        light::{Lamp, Lighting, Lit, Surface},
        lights::{Lights, Source},
        projection::{Lens, ViewBox},
        quaternion::Quaternion,
        transform::MeshTransform,
        viewport::Viewport,
    },
    illumination::unit_normal,
    model::{
        assembly::Assembly,
        mesh::Mesh,
        revolved::{Parts, sphere_triangles, torus_triangles, vertices},
        solids,
    },
    twice_area,
};
use embedded_graphics::transform::Transform;
use nopanic::{any, keep, part};

#[cortex_m_rt::entry]
fn main() -> ! {
    words();
    matrices();
    more_matrices();
    projections();
    quaternions();
    faces();
    lamps();
    fog();
    meshes();
    solids();
    loop {}
}

fn words() {
    let angle = any::<Angle>();
    keep((angle.sin(), angle.cos(), angle.half()));
    let map = Affine::new(any(), any(), any()).then(Affine::turn(angle)).then(Affine::scale(any(), any()));
    let map = map.about(any()).then(Affine::translation(any()));
    keep(map.apply(any()));
    let (Ok(oval), Ok(circle)) = (Oval::new(any(), any()), Oval::circle(any(), any())) else { return };
    let arc = oval.arc(any(), any());
    keep((circle, arc.start_point(), Arc::new(circle, any(), any()), Chord(arc), Sector(arc)));
    keep(Placed::new(arc, map).then(any()).translate(any()));
    keep(twice_area(any::<Point2>(), any(), any()));
    let rect = any::<Rect>();
    keep((rect.columns(), rect.rows(), rect.is_empty(), rect.width(), rect.height(), rect.contains(any())));
    keep((rect.intersection(any()), rect.clip_run(any(), any()..any()), Rect::of_size(any())));
    keep((Rect::from(any::<embedded_graphics::primitives::Rectangle>()), any::<Vector3<World>>().normalized()));
}

fn matrices() {
    let matrix = any::<Matrix<Model, World>>();
    let further = any::<Matrix<World, View>>();
    keep((matrix.then(&further), matrix.transform_point(any()), matrix.transform_vector(any())));
    keep((matrix.unrotate_vector(any()), matrix.inverse(), matrix.normals(), matrix.orthonormalized()));
    keep((matrix.untransform_point(any()), further.eye(), *matrix.rows()));
}

fn more_matrices() {
    keep(Matrix::<Model, World>::rotation_x(any()).then(&Matrix::<World, World>::rotation_y(any())));
    keep(Matrix::<Model, World>::rotation_z(any()).then(&Matrix::<World, World>::translation(any(), any(), any())));
    keep((Matrix::<Model, World>::rotation_about(any(), any()), Matrix::<Model, World>::scale(any())));
    keep(Matrix::<Model, World>::scale_by(any(), any(), any()));
    keep(Matrix::look_at(any(), any(), any()));
}

fn projections() {
    keep(Matrix::perspective(Lens { field_of_view: any(), aspect: any(), near: any(), far: any() }));
    keep(Matrix::orthographic(ViewBox { height: any(), aspect: any(), near: any(), far: any() }));
    if let Ok(transform) = MeshTransform::new(&any::<Matrix<Model, Clip>>()) {
        keep((transform.apply(any()), transform.apply_w(any())));
    }
    if let Ok(viewport) = Viewport::new(any()) {
        keep((viewport.rect(), viewport.project(&any())));
    }
}

fn quaternions() {
    let (Some(one), Some(other)) =
        (Quaternion::from_axis_angle::<World>(any(), any()), Quaternion::from_axis_angle::<World>(any(), any()))
    else {
        return;
    };
    keep((one.then(other), one.conjugate(), one.slerp(other, any()), one.nlerp(other, any())));
    keep(one.to_matrix::<Model, World>());
}

fn faces() {
    keep((face::side(any(), any(), any()), face::is_front(any(), any(), any())));
    let faces = black_box(Faces::Front);
    keep((faces.shows(any()), faces.shows(any()).map(|side| faces.includes(side))));
    keep(face::faces_viewer(any(), any(), any::<Point3<Model>>()));
    keep(unit_normal(any()));
}

fn lamp() -> Lamp {
    Lamp { direction: any(), ambient: any(), diffuse: any() }
}

fn lamps() {
    let placement = any();
    let surface = Surface { diffuse: any(), specular: any(), shininess: any() };
    let lit = Lit { placement: &placement, eye: any(), surface };
    shine(&lamp().for_object(&lit));
    shine(&lamp().in_model_space(&placement));
    shine(&any::<Light>());
    let position = any();
    let spot = Source::Spot { position, direction: any(), light: any(), reach: any(), inner: any(), outer: any() };
    let point = Source::Point { position, light: any(), reach: any() };
    let sources = [spot, point, Source::Directional { direction: any(), light: any() }, black_box(point)];
    shine(&Lights { ambient: any(), sources }.for_object(&lit));
}

fn shine(light: &impl Illumination) {
    keep((light.on(any(), any()), light.on_vertex(any(), any())));
}

fn fog() {
    let (Ok(linear), Ok(exponential)) = (Fog::linear(any(), any(), any()), Fog::exponential(any(), any())) else {
        return;
    };
    for fog in [linear, exponential] {
        keep((fog.part(any()), fog.over(any(), any()), fog.hiding(any(), any())));
    }
}

fn meshes() {
    let (positions, normals, triangles) = ([any(); 8], [any(); 8], [any(); 8]);
    keep(Mesh::new(part(&positions), part(&normals), part(&triangles)).is_ok());
    let (counts, indices, uv, lights) = ([any(); 8], [any(); 8], [any(); 8], [any(); 8]);
    let polygons = Assembly::Polygons { counts: part(&counts), indices: part(&indices) };
    for assembly in [polygons, Assembly::Strip(part(&indices)), Assembly::Fan(part(&indices)), black_box(polygons)] {
        assembly.triangles().for_each(keep);
        let Ok(mesh) = Mesh::with_assembly(part(&positions), part(&normals), assembly) else { continue };
        let Ok(mesh) = mesh.with_uv(part(&uv)).and_then(|mesh| mesh.with_lights(part(&lights))) else { continue };
        let Ok(mesh) = mesh.with_face_normals(part(&normals)) else { continue };
        mesh.faces().for_each(keep);
        mesh.triangles().for_each(keep);
        keep((mesh.positions(), mesh.normals(), mesh.uv(), mesh.lights(), mesh.face_normals(), mesh.assembly()));
    }
}

fn solids() {
    keep([solids::TETRAHEDRON, solids::CUBE, solids::CUBE_FACES, solids::OCTAHEDRON, solids::ICOSAHEDRON]);
    static BALL: Parts<{ vertices(8, 5) }, { sphere_triangles(8, 5) }> = Parts::sphere::<8, 5>();
    static RING: Parts<{ vertices(8, 5) }, { torus_triangles(8, 5) }> = Parts::torus::<8, 5>(100);
    keep((BALL.mesh().is_ok(), RING.mesh().is_ok(), solids::DODECAHEDRON));
}
