//! Models, cameras and lamps for the programs that draw scenes.

use core::hint::black_box;

use aquatint::{
    Light,
    geometry::{
        face::Faces,
        light::{Lamp, Surface},
        lights::Source,
        viewport::Viewport,
    },
    hidden::bsp::{Choice, Tree, TreeArrays, Triangles},
    model::{assembly::Assembly, mesh::Mesh},
    pipeline::{Camera, DepthBias, Material, Scene},
};

use crate::{any, one_of, part, some, view_and_lens};

/// The arrays of a mesh.
pub struct Model {
    pub positions: [[i16; 3]; 8],
    pub triangles: [[u16; 3]; 8],
    normals: [[i8; 3]; 8],
    face_normals: [[i8; 3]; 12],
    uv: [[i16; 2]; 8],
    lights: [Light; 8],
    counts: [u8; 4],
}

impl Model {
    pub const NEW: Self = Self {
        positions: [[0; 3]; 8],
        triangles: [[0; 3]; 8],
        normals: [[0; 3]; 8],
        face_normals: [[0; 3]; 12],
        uv: [[0; 2]; 8],
        lights: [Light::BLACK; 8],
        counts: [0; 4],
    };

    /// Makes another model of the arrays, in whatever assembly.
    #[inline(never)]
    pub fn mesh(&mut self) -> Option<Mesh<'_>> {
        let triangles = some(&mut self.triangles);
        let indices = triangles.as_flattened();
        let assembly = match any::<u16>() {
            0..=4 => Assembly::Triangles(triangles),
            5 => Assembly::Strip(indices),
            6 => Assembly::Fan(indices),
            _ if any() => Assembly::Polygons { counts: part(&[3; 8]), indices },
            _ => Assembly::Polygons { counts: some(&mut self.counts), indices },
        };
        let mesh = Mesh::with_assembly(some(&mut self.positions), some(&mut self.normals), assembly).ok()?;
        let mesh = mesh.with_uv(some(&mut self.uv)).ok()?.with_lights(some(&mut self.lights)).ok()?;
        // One for each face, which is what the whole of it is cut to.
        let faces = if any() { mesh.faces().count() } else { any() };
        let normals = some(&mut self.face_normals);
        mesh.with_face_normals(normals.get(..faces).unwrap_or(normals)).ok()
    }
}

pub fn camera() -> Option<Camera> {
    let (view, projection) = view_and_lens();
    Some(Camera { view, projection, viewport: Viewport::new(any()).ok()? })
}

pub fn scene() -> Option<Scene> {
    Some(Scene { camera: camera()?, light: Lamp { direction: any(), ambient: any(), diffuse: any() } })
}

pub fn material<S>(shading: S) -> Material<S> {
    let surface = Surface { diffuse: any(), specular: any(), shininess: any() };
    let bias = DepthBias { constant: any(), slope: any() };
    Material { shading, surface, faces: one_of(&[Faces::Both, Faces::Front, Faces::Back]), bias }
}

pub fn source() -> Source {
    let (position, light, reach) = (any(), any(), any());
    match any::<u16>() {
        0 => Source::Directional { direction: any(), light },
        1 | 2 => Source::Point { position, light, reach },
        _ => Source::Spot { position, direction: any(), light, reach, inner: any(), outer: any() },
    }
}

/// Two tetrahedra, one through the other.
pub const PAIR: Mesh<'static> = match Mesh::new(&PLACES, &[[0, 0, 127]; 8], &FACES) {
    Ok(mesh) => mesh,
    Err(_) => panic!("bad mesh"),
};

const PLACES: [[i16; 3]; 8] = [
    [9_000, 9_000, 9_000],
    [-9_000, -9_000, 9_000],
    [-9_000, 9_000, -9_000],
    [9_000, -9_000, -9_000],
    [12_000, 5_000, -1_000],
    [-12_000, -5_000, 1_000],
    [1_000, 12_000, -5_000],
    [5_000, -1_000, 12_000],
];

const FACES: [[u16; 3]; 8] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3], [4, 6, 5], [4, 5, 7], [4, 7, 6], [5, 6, 7]];

static BUILT: TreeArrays<'static, 64, 96, 96> = match TreeArrays::build(TRIANGLES, Choice::best_of(2)) {
    Ok(tree) => tree,
    Err(_) => panic!("no room for the tree"),
};

const TRIANGLES: Triangles<'static> = Triangles::new(&PLACES, &FACES);

/// The tree of [`PAIR`], built while compiling.
pub fn built_tree() -> Tree<'static> {
    black_box(&BUILT).tree()
}
