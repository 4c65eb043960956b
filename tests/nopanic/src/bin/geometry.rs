//! Matrices, quaternions, projections, faces, lamps, fog; meshes, solids and affine maps.
#![no_std]
#![no_main]

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
    illumination,
    model::{
        assembly::Assembly,
        mesh::Mesh,
        revolved::{Parts, sphere_triangles, torus_triangles, vertices},
        solids,
    },
};
use embedded_graphics::{primitives::Rectangle, transform::Transform};
use nopanic::{any, keep, one_of, some};

/// What a caller lends.
struct Memory {
    positions: [[i16; 3]; 8],
    normals: [[i8; 3]; 8],
    face_normals: [[i8; 3]; 8],
    triangles: [[u16; 3]; 8],
    counts: [u8; 8],
    indices: [u16; 12],
    uv: [[i16; 2]; 8],
    lights: [Light; 8],
}

const MEMORY: Memory = Memory {
    positions: [[0; 3]; 8],
    normals: [[0; 3]; 8],
    face_normals: [[0; 3]; 8],
    triangles: [[0; 3]; 8],
    counts: [0; 8],
    indices: [0; 12],
    uv: [[0; 2]; 8],
    lights: [Light::BLACK; 8],
};

nopanic::entries! { MEMORY;
    angle,
    affine,
    arc,
    twice_area,
    rect,
    vector_normalized,
    matrix_then,
    matrix_transform,
    matrix_inverse,
    matrix_normals,
    matrix_orthonormalized,
    matrix_untransform,
    matrix_rotation,
    matrix_rotation_about,
    matrix_scale,
    look_at,
    perspective,
    orthographic,
    mesh_transform,
    viewport_project,
    quaternion,
    quaternion_slerp,
    quaternion_to_matrix,
    face_side,
    unit_normal,
    lamp_for_object,
    lamp_in_model_space,
    light_everywhere,
    lights_for_object,
    fog,
    mesh_new,
    mesh_with_assembly,
    mesh_faces,
    mesh_triangles,
    assembly_triangles,
    solids,
}

fn angle(_: &mut Memory) {
    let angle = any::<Angle>();
    keep((angle.sin(), angle.cos(), angle.half()));
}

fn affine(_: &mut Memory) {
    let map = any::<Affine>().then(Affine::turn(any())).then(Affine::scale(any(), any()));
    keep(map.about(any()).then(Affine::translation(any())).apply(any()));
}

fn arc(_: &mut Memory) {
    let (Ok(oval), Ok(circle)) = (Oval::new(any(), any()), Oval::circle(any(), any())) else { return };
    let arc = oval.arc(any(), any());
    keep((circle, arc.start_point(), Arc::new(circle, any(), any()), Chord(arc), Sector(arc)));
    keep(Placed::new(arc, any()).then(any()).translate(any()));
}

fn twice_area(_: &mut Memory) {
    keep(aquatint::twice_area(any::<Point2>(), any(), any()));
}

fn rect(_: &mut Memory) {
    let rect = any::<Rect>();
    keep((rect.columns(), rect.rows(), rect.is_empty(), rect.width(), rect.height(), rect.contains(any())));
    keep((rect.intersection(any()), rect.clip_run(any(), any()..any()), Rect::of_size(any())));
    keep(Rect::from(any::<Rectangle>()));
}

fn vector_normalized(_: &mut Memory) {
    keep(any::<Vector3<World>>().normalized());
}

fn matrix_then(_: &mut Memory) {
    keep(any::<Matrix<Model, World>>().then(&any::<Matrix<World, View>>()));
}

fn matrix_transform(_: &mut Memory) {
    let matrix = any::<Matrix<Model, World>>();
    keep((matrix.transform_point(any()), matrix.transform_vector(any()), matrix.unrotate_vector(any())));
}

fn matrix_inverse(_: &mut Memory) {
    keep(any::<Matrix<Model, World>>().inverse());
}

fn matrix_normals(_: &mut Memory) {
    keep(any::<Matrix<Model, World>>().normals());
}

fn matrix_orthonormalized(_: &mut Memory) {
    keep(any::<Matrix<Model, World>>().orthonormalized());
}

fn matrix_untransform(_: &mut Memory) {
    keep(any::<Matrix<Model, World>>().untransform_point(any()));
    keep(any::<Matrix<World, View>>().eye());
}

fn matrix_rotation(_: &mut Memory) {
    keep(Matrix::<Model, World>::rotation_x(any()));
    keep(Matrix::<Model, World>::rotation_y(any()));
    keep(Matrix::<Model, World>::rotation_z(any()));
}

fn matrix_rotation_about(_: &mut Memory) {
    keep(Matrix::<Model, World>::rotation_about(any(), any()));
}

fn matrix_scale(_: &mut Memory) {
    keep(Matrix::<World, World>::translation(any(), any(), any()));
    keep(Matrix::<Model, World>::scale(any()));
    keep(Matrix::<Model, World>::scale_by(any(), any(), any()));
}

fn look_at(_: &mut Memory) {
    keep(Matrix::look_at(any(), any(), any()));
}

fn perspective(_: &mut Memory) {
    keep(Matrix::perspective(Lens { field_of_view: any(), aspect: any(), near: any(), far: any() }));
}

fn orthographic(_: &mut Memory) {
    keep(Matrix::orthographic(ViewBox { height: any(), aspect: any(), near: any(), far: any() }));
}

fn mesh_transform(_: &mut Memory) {
    if let Ok(transform) = MeshTransform::new(&any::<Matrix<Model, Clip>>()) {
        keep((transform.apply(any()), transform.apply_w(any())));
    }
}

fn viewport_project(_: &mut Memory) {
    if let Ok(viewport) = Viewport::new(any()) {
        keep((viewport.rect(), viewport.project(&any())));
    }
}

fn turn() -> Option<Quaternion> {
    Quaternion::from_axis_angle::<World>(any(), any())
}

fn quaternion(_: &mut Memory) {
    let (Some(one), Some(other)) = (turn(), turn()) else { return };
    keep((one.then(other), one.conjugate(), one.nlerp(other, any())));
}

fn quaternion_slerp(_: &mut Memory) {
    let (Some(one), Some(other)) = (turn(), turn()) else { return };
    keep(one.slerp(other, any()));
}

fn quaternion_to_matrix(_: &mut Memory) {
    if let Some(turn) = turn() {
        keep(turn.to_matrix::<Model, World>());
    }
}

fn face_side(_: &mut Memory) {
    keep((face::side(any(), any(), any()), face::is_front(any(), any(), any())));
    let faces = one_of(&[Faces::Front, Faces::Back, Faces::Both]);
    keep((faces.shows(any()), faces.shows(any()).map(|side| faces.includes(side))));
    keep(face::faces_viewer(any(), any(), any::<Point3<Model>>()));
}

fn unit_normal(_: &mut Memory) {
    keep(illumination::unit_normal(any()));
}

fn lamp() -> Lamp {
    Lamp { direction: any(), ambient: any(), diffuse: any() }
}

fn surface() -> Surface {
    Surface { diffuse: any(), specular: any(), shininess: any() }
}

fn lamp_for_object(_: &mut Memory) {
    shine(&lamp().for_object(&Lit { placement: &any(), eye: any(), surface: surface() }));
}

fn lamp_in_model_space(_: &mut Memory) {
    shine(&lamp().in_model_space(&any()));
}

fn light_everywhere(_: &mut Memory) {
    shine(&any::<Light>());
}

fn source() -> Source {
    let (position, light, reach) = (any(), any(), any());
    match any::<u16>() {
        0 => Source::Directional { direction: any(), light },
        1 => Source::Point { position, light, reach },
        _ => Source::Spot { position, direction: any(), light, reach, inner: any(), outer: any() },
    }
}

fn lights_for_object(_: &mut Memory) {
    let lights = Lights { ambient: any(), sources: [source(), source()] };
    shine(&lights.for_object(&Lit { placement: &any(), eye: any(), surface: surface() }));
}

fn shine(light: &impl Illumination) {
    keep((light.on(any(), any()), light.on_vertex(any(), any())));
}

fn fog(_: &mut Memory) {
    let fog = if any() { Fog::linear(any(), any(), any()) } else { Fog::exponential(any(), any()) };
    if let Ok(fog) = fog {
        keep((fog.part(any()), fog.over(any(), any()), fog.hiding(any(), any())));
    }
}

fn mesh_new(memory: &mut Memory) {
    let triangles = some(&mut memory.triangles);
    keep(Mesh::new(some(&mut memory.positions), some(&mut memory.normals), triangles).is_ok());
}

impl Memory {
    fn assembly<'a>(counts: &'a mut [u8], indices: &'a mut [u16], triangles: &'a mut [[u16; 3]]) -> Assembly<'a> {
        match any::<u16>() {
            0 | 1 => Assembly::Triangles(some(triangles)),
            2 | 3 => Assembly::Strip(some(indices)),
            4 | 5 => Assembly::Fan(some(indices)),
            6 => Assembly::Polygons { counts: &[4, 5, 3], indices: some(indices) },
            _ => Assembly::Polygons { counts: some(counts), indices: some(indices) },
        }
    }

    fn mesh(&mut self) -> Option<Mesh<'_>> {
        let assembly = Self::assembly(&mut self.counts, &mut self.indices, &mut self.triangles);
        Mesh::with_assembly(some(&mut self.positions), some(&mut self.normals), assembly).ok()
    }
}

fn mesh_with_assembly(memory: &mut Memory) {
    let assembly = Memory::assembly(&mut memory.counts, &mut memory.indices, &mut memory.triangles);
    let Ok(mesh) = Mesh::with_assembly(some(&mut memory.positions), some(&mut memory.normals), assembly) else {
        return;
    };
    let Ok(mesh) = mesh.with_uv(some(&mut memory.uv)) else { return };
    let Ok(mesh) = mesh.with_lights(some(&mut memory.lights)) else { return };
    let Ok(mesh) = mesh.with_face_normals(some(&mut memory.face_normals)) else { return };
    keep((mesh.positions(), mesh.normals(), mesh.uv(), mesh.lights(), mesh.face_normals(), mesh.assembly()));
}

fn mesh_faces(memory: &mut Memory) {
    if let Some(mesh) = memory.mesh() {
        mesh.faces().for_each(keep);
    }
}

fn mesh_triangles(memory: &mut Memory) {
    if let Some(mesh) = memory.mesh() {
        mesh.triangles().for_each(keep);
    }
}

fn assembly_triangles(memory: &mut Memory) {
    Memory::assembly(&mut memory.counts, &mut memory.indices, &mut memory.triangles).triangles().for_each(keep);
}

fn solids(_: &mut Memory) {
    let solids = [solids::TETRAHEDRON, solids::CUBE, solids::CUBE_FACES, solids::OCTAHEDRON, solids::ICOSAHEDRON];
    static BALL: Parts<{ vertices(8, 5) }, { sphere_triangles(8, 5) }> = Parts::sphere::<8, 5>();
    static RING: Parts<{ vertices(8, 5) }, { torus_triangles(8, 5) }> = Parts::torus::<8, 5>(100);
    keep((one_of(&solids).faces().count(), solids::DODECAHEDRON.faces().count()));
    keep((BALL.mesh().is_ok(), RING.mesh().is_ok()));
}
