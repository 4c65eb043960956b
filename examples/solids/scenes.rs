//! One function for each fill mode.

use aquatint::{
    Alpha, Coverage, Fog, HalfSpace, Light, Matrix, Model, Vector3, World,
    fragment::{
        shade::{Flat, Fogged, Gouraud, Mapped, Phong, Plain, Textured, Unlit},
        texture::{Bilinear, Sampler, Texture},
        toon::Bands,
    },
    geometry::{
        face::Faces,
        light::Surface,
        lights::{Lights, Source},
    },
    model::{
        assembly::Assembly,
        mesh::Mesh,
        revolved::{Parts, sphere_triangles, torus_triangles, vertices},
        solids::{CUBE, CUBE_FACES, DODECAHEDRON, ICOSAHEDRON},
    },
    pipeline::{DepthBias, Instance, Material},
};

use crate::easel::{Drawn, Easel, number, turned};

/// A picture and its name.
pub struct Named {
    pub name: &'static str,
    pub draw: fn(&mut Easel) -> Drawn,
}

const fn named(name: &'static str, draw: fn(&mut Easel) -> Drawn) -> Named {
    Named { name, draw }
}

pub static ALL: [Named; 12] = [
    named("flat", flat),
    named("Gouraud", gouraud),
    named("Phong", phong),
    named("toon", toon),
    named("cross hatch", gouraud),
    named("textured", textured),
    named("depth-cued wires", wires),
    named("hidden lines", hidden_lines),
    named("edges on faces", edges_on_faces),
    named("fog", fog),
    named("translucent", translucent),
    named("sliced", sliced),
];

static RING: Parts<{ vertices(24, 12) }, { torus_triangles(24, 12) }> = Parts::torus::<24, 12>(6_200);
const COARSE: Parts<{ vertices(14, 8) }, { torus_triangles(14, 8) }> = Parts::torus::<14, 8>(6_200);
static COARSE_RING: Parts<{ vertices(14, 8) }, { torus_triangles(14, 8) }> = COARSE;
static BALL: Parts<{ vertices(24, 12) }, { sphere_triangles(24, 12) }> = Parts::sphere::<24, 12>();
static FLOOR: Parts<{ vertices(12, 12) }, { torus_triangles(12, 12) }> = Parts::grid::<12, 12>();

/// The coarse ring as quadrangles: two triangles each, without the diagonal.
static QUADS: [u16; 4 * 14 * 8] = {
    let Ok(mesh) = COARSE.mesh() else { panic!("too many vertices") };
    let Assembly::Triangles(triangles) = mesh.assembly() else { panic!("no triangles") };
    let (mut indices, mut at) = ([0; 4 * 14 * 8], 0);
    while at < indices.len() {
        let ([a, b, c], [_, _, d]) = (triangles[at / 2], triangles[at / 2 + 1]);
        (indices[at], indices[at + 1], indices[at + 2], indices[at + 3]) = (a, b, c, d);
        at += 4;
    }
    indices
};

fn net() -> Mesh<'static> {
    let mesh = mesh(&COARSE_RING);
    let quads = Assembly::Polygons { counts: &[4; 14 * 8], indices: &QUADS };
    Mesh::with_assembly(mesh.positions(), mesh.normals(), quads).unwrap_or(mesh)
}

fn mesh<const V: usize, const T: usize>(parts: &'static Parts<V, T>) -> Mesh<'static> {
    parts.mesh().unwrap_or(CUBE)
}

fn ring() -> Instance<'static> {
    Instance::new(mesh(&RING), turned(25.0, 50.0))
}

fn at(x: f64, y: f64, z: f64, scale: f64) -> Matrix<Model, World> {
    Matrix::<Model, Model>::scale(number(scale)).then(&Matrix::translation(number(x), number(y), number(z)))
}

fn flat(easel: &mut Easel) -> Drawn {
    easel.faces(&Instance { mesh: mesh(&COARSE_RING), ..ring() }.with_material(Material::new(Flat)))
}

fn gouraud(easel: &mut Easel) -> Drawn {
    easel.faces(&ring())
}

fn phong(easel: &mut Easel) -> Drawn {
    let sun = Source::Directional { direction: easel.lamp.direction, light: Light(58_000) };
    let glossy = Surface { diffuse: 32_000, ..Surface::GLOSSY };
    let material = Material { surface: glossy, ..Material::new(Phong) };
    easel.faces_in(&ring().with_material(material), Lights { ambient: Light(3_000), sources: [sun] })
}

fn toon(easel: &mut Easel) -> Drawn {
    let Some(bands) = Bands::even_to_the_eye(4) else { return Ok(()) };
    easel.faces(&ring().with_material(Material::new(Mapped::new(Phong, move |light| bands.of(light)))))
}

/// Bricks, a bit a texel.
fn textured(easel: &mut Easel) -> Drawn {
    let bricks = [0b1110_1111, 0b1110_1111, 0b1110_1111, 0, 0b1111_1110, 0b1111_1110, 0b1111_1110, 0];
    let Ok(texture) = Texture::new(&bricks, 8, 8, &[Light(5_000), Light::WHITE]) else { return Ok(()) };
    let shading = Textured::new(Sampler::new(texture).with_filter(Bilinear), Gouraud);
    easel.faces(&Instance::new(CUBE_FACES, turned(-35.0, 25.0)).with_material(Material::new(shading)))
}

/// All edges, those that are far away darker.
fn wires(easel: &mut Easel) -> Drawn {
    let Ok(fog) = Fog::linear(number(1.8), number(4.4), Light::BLACK) else { return Ok(()) };
    let material = Material { faces: Faces::Both, ..Material::new(Fogged::new(Unlit, fog)) };
    easel.edges(&Instance::new(ICOSAHEDRON, turned(20.0, 12.0)).with_material(material))
}

/// Faces push back, so that their own edges are seen on them.
fn hidden_lines(easel: &mut Easel) -> Drawn {
    let white = Material::new(Plain(Light::WHITE));
    let ring = Instance { mesh: net(), ..ring() }.with_material(white);
    easel.unseen(&ring.with_material(Material { bias: DepthBias::BEHIND_LINES, ..white }))?;
    easel.edges(&ring)
}

fn edges_on_faces(easel: &mut Easel) -> Drawn {
    let solid = Instance::new(DODECAHEDRON, turned(30.0, 20.0));
    let grey = Surface { diffuse: 24_000, ..Surface::MATTE };
    let faces = Material { bias: DepthBias::BEHIND_LINES, surface: grey, ..Material::new(Flat) };
    easel.faces(&solid.with_material(faces))?;
    easel.edges(&solid.with_material(Material::new(Plain(Light::WHITE))))
}

fn fog(easel: &mut Easel) -> Drawn {
    let air = Light(24_000);
    let Ok(fog) = Fog::linear(number(2.0), number(9.0), air) else { return Ok(()) };
    let material = Material::new(Fogged::new(Gouraud, fog));
    let Ok(()) = embedded_graphics::draw_target::DrawTarget::clear(easel.picture, air);
    let ground = Material { surface: Surface { diffuse: 22_000, ..Surface::MATTE }, ..material };
    easel.faces(&Instance::new(mesh(&FLOOR), at(0.0, -0.9, -3.0, 5.0)).with_material(ground))?;
    for (x, z) in [(-0.75, 0.2), (0.1, -1.2), (1.0, -2.6), (2.1, -4.2)] {
        easel.faces(&Instance::new(mesh(&BALL), at(x, -0.4, z, 0.5)).with_material(material))?;
    }
    Ok(())
}

/// A ball in a box of glass: the far panes first.
fn translucent(easel: &mut Easel) -> Drawn {
    easel.faces(&Instance::new(mesh(&BALL), at(0.0, 0.0, 0.0, 0.5)))?;
    let glass = Mapped::new(Flat, |light: Light| Alpha::new(light, Coverage::from_byte(90)));
    let pane = Instance::new(CUBE_FACES, turned(-35.0, 25.0)).with_material(Material::new(glass));
    let back = Material { faces: Faces::Back, ..Material::new(glass) };
    easel.glass(&pane.with_material(back))?;
    easel.glass(&pane)
}

/// A hollow ring, cut open by a plane; what is gone is shown by lines.
fn sliced(easel: &mut Easel) -> Drawn {
    let normal = Vector3::<World>::new(number(-0.6), number(0.1), number(-0.8));
    let Ok(kept) = HalfSpace::new(normal, number(0.15)) else { return Ok(()) };
    let Some(planes) = easel.camera.clip_plane(&kept).zip(easel.camera.clip_plane(&kept.opposite())) else {
        return Ok(());
    };
    let both = Material { faces: Faces::Both, ..Material::new(Gouraud) };
    easel.faces(&ring().with_material(both).with_planes(&[planes.0]))?;
    let dim = Material::new(Plain(Light(9_000)));
    easel.edges(&Instance { mesh: net(), ..ring() }.with_material(dim).with_planes(&[planes.1]))
}
