//! Meshes in every shading, with every way to hide; wireframes, trees, rows of scenes.
#![no_std]
#![no_main]

use core::hint::black_box;

use aquatint::{
    BoundingBox3, BoundingSphere, ClipPlane, Dithered, Fog, Frame, Levels, Light, Rect, Rows, Sampler, Window, Words,
    fragment::{
        shade::{
            Corner, Flat, Fogged, Gouraud, LineShading, Mapped, Phong, Plain, Shader, Shading, Stippled, Textured,
            Unlit,
        },
        texture::{Bilinear, ClampToEdge, LightTexture, Mirror},
    },
    geometry::{
        face::Faces,
        light::{Lamp, Lighting, Surface},
        lights::{Lights, Source},
        viewport::Viewport,
    },
    hidden::{
        Hidden,
        bsp::{Node, Piece, Split, Tree, Triangles},
        convex::Convex,
        depth::{Depth, DepthBuffer, DepthTest},
        raycast::{Shape, Sphere},
    },
    model::{assembly::Assembly, mesh::Mesh},
    pipeline::{
        Bounds, Camera, DepthBias, DepthSortMemory, Instance, Material, MeshVertex, ObjectSpaceMemory, Scanlines, Scene,
        SceneMemory, TreeInstance, Unpainted, Workspace, draw_compared, draw_mesh, draw_scene, draw_sorted, draw_tree, draw_wireframe,
        mesh_shapes,
    },
};
use embedded_graphics::pixelcolor::BinaryColor;
use heapless::Vec;
use nopanic::{any, keep, lent, part};

#[cortex_m_rt::entry]
fn main() -> ! {
    shadings();
    more_shadings();
    hiding::<u8>();
    hiding::<u16>();
    hiding::<u32>();
    lit();
    bounded();
    lines();
    rows();
    trees();
    ways();
    shapes();
    loop {}
}

fn camera() -> Option<Camera> {
    Some(Camera { view: any(), projection: any(), viewport: Viewport::new(any()).ok()? })
}

fn scene() -> Option<Scene> {
    Some(Scene { camera: camera()?, light: Lamp { direction: any(), ambient: any(), diffuse: any() } })
}

fn material<S>(shading: S) -> Material<S> {
    let surface = Surface { diffuse: any(), specular: any(), shininess: any() };
    let bias = DepthBias { constant: any(), slope: any() };
    Material { shading, surface, faces: black_box(Faces::Both), bias }
}

/// The arrays of a mesh.
struct Arrays {
    positions: [[i16; 3]; 8],
    normals: [[i8; 3]; 8],
    uv: [[i16; 2]; 8],
    lights: [Light; 8],
    triangles: [[u16; 3]; 8],
}

impl Arrays {
    fn any() -> Self {
        Self { positions: any(), normals: any(), uv: any(), lights: any(), triangles: any() }
    }

    fn mesh(&self) -> Option<Mesh<'_>> {
        let indices = self.triangles.as_flattened();
        let assembly = [
            Assembly::Triangles(part(&self.triangles)),
            Assembly::Strip(part(indices)),
            Assembly::Fan(part(indices)),
            Assembly::Polygons { counts: part(&[3; 8]), indices: part(indices) },
        ];
        let assembly = *black_box(&assembly).get(any::<usize>())?;
        let mesh = Mesh::with_assembly(part(&self.positions), part(&self.normals), assembly).ok()?;
        let mesh = mesh.with_uv(part(&self.uv)).ok()?.with_lights(part(&self.lights)).ok()?;
        mesh.with_face_normals(part(&self.normals)).ok()
    }
}

/// A mesh in a shading, onto light that is dithered.
#[inline(never)]
fn shaded<S: Shading<Color = Light>>(shading: S) {
    let mut depths = [0_u16; 64];
    let Ok(mut depth) = DepthBuffer::new(lent(&mut depths), any()) else { return };
    drawn(shading, &mut depth, (), scene());
}

#[inline(never)]
fn drawn<S, H, B, L>(shading: S, hidden: &mut H, bounds: B, scene: Option<Scene<L>>)
where
    S: Shading<Color = Light>,
    H: Hidden,
    B: Bounds,
    L: Lighting,
{
    let (arrays, mut bytes, mut vertices) = (Arrays::any(), [0; 64], [MeshVertex::EMPTY; 8]);
    let (Some(mesh), Some(scene)) = (arrays.mesh(), scene) else { return };
    let Ok(mut frame) = Frame::<BinaryColor, Rows, _>::new(lent(&mut bytes), any(), any()) else { return };
    let Ok(plane) = ClipPlane::new(any()) else { return };
    let planes = [plane; 8];
    let instance = Instance::new(mesh, any()).with_material(material(shading)).with_planes(part(&planes));
    let mut workspace = Workspace { vertices: lent(&mut vertices), hidden };
    let mut band = Window::band(&mut frame, any());
    let mut light = Dithered::new(&mut band, Levels::ONE_BIT);
    keep(draw_mesh(&instance.with_bounds(bounds), &scene, &mut workspace, &mut light).is_ok());
}

fn shadings() {
    shaded(Gouraud);
    shaded(Flat);
    shaded(Phong);
    shaded(Unlit);
    shaded(Plain(any::<Light>()));
    shaded(Mapped::new(Gouraud, |light: Light| Light(!light.0)));
    shaded(Stippled::new(Flat, any::<[u8; 3]>()));
    if let Ok(fog) = Fog::linear(any(), any(), any()) {
        shaded(Fogged::new(Gouraud, fog));
        shaded(Fogged::new(Phong, fog));
    }
    let corner = |corner: &Corner| [corner.light.0, corner.position[0].cast_unsigned(), corner.index];
    shaded(Shader::new(corner, |[light, x, _]: [u16; 3]| (x & 0x400 == 0).then_some(Light(light))));
}

fn more_shadings() {
    let texels = [any(); 16];
    let Ok(texture) = LightTexture::new(part(&texels), any(), any()) else { return };
    shaded(Textured::new(Sampler::new(texture), Unlit));
    shaded(Textured::new(Sampler::new(texture).with_wrap(ClampToEdge), Gouraud));
    shaded(Textured::new(Sampler::new(texture).with_wrap(Mirror).with_filter(Bilinear), Phong));
    shaded(Textured::new(Sampler::new(texture), Flat).affine());
}

fn hiding<D: Depth + Ord>() {
    let mut depths = [D::FARTHEST; 64];
    let Ok(mut depth) = DepthBuffer::new(lent(&mut depths), any()) else { return };
    drawn(Gouraud, &mut depth, (), scene());
    let mut depth = depth.with_test(black_box(DepthTest::Nearer));
    drawn(Phong, &mut depth, (), scene());
    drawn(Flat, &mut depth.without_writing(), (), scene());
}

/// With several lamps.
fn lit() {
    let position = any();
    let spot = Source::Spot { position, direction: any(), light: any(), reach: any(), inner: any(), outer: any() };
    let sources = black_box([spot, Source::Point { position, light: any(), reach: any() }]);
    let scene = || Some(Scene { camera: camera()?, light: Lights { ambient: any(), sources } });
    drawn(Gouraud, &mut Convex, (), scene());
    drawn(Phong, &mut Convex, (), scene());
}

fn bounded() {
    let places = [any(); 8];
    drawn(Gouraud, &mut Convex, BoundingSphere::new(any(), any()), scene());
    if let Some(bounds) = BoundingBox3::of_places(part(&places)) {
        drawn(Unlit, &mut Convex, bounds, scene());
    }
}

fn lines() {
    wireframe(Gouraud);
    wireframe(Unlit);
    wireframe(Plain(any::<Light>()));
    if let Ok(fog) = Fog::exponential(any(), any()) {
        wireframe(Fogged::new(Gouraud, fog));
    }
}

fn wireframe<S: LineShading<Color = Light>>(shading: S) {
    let (arrays, mut bytes, mut vertices, mut depths) = (Arrays::any(), [0; 64], [MeshVertex::EMPTY; 8], [0_u16; 64]);
    let (Some(mesh), Some(scene)) = (arrays.mesh(), scene()) else { return };
    let Ok(mut depth) = DepthBuffer::new(lent(&mut depths), any()) else { return };
    let Ok(mut frame) = Frame::<Light, Words, _>::new(lent(&mut bytes), any(), any()) else { return };
    let instance = Instance::new(mesh, any()).with_material(material(shading));
    let mut workspace = Workspace { vertices: lent(&mut vertices), hidden: &mut depth };
    keep(draw_wireframe(&instance, &scene, &mut workspace, &mut frame).is_ok());
    keep(draw_mesh(&instance, &scene, &mut workspace, &mut Unpainted::new()).is_ok());
}

fn rows() {
    scanned(Gouraud);
    scanned(Flat);
    scanned(Phong);
}

fn scanned<S: Shading<Color = Light> + Copy>(shading: S) {
    let (one, other, mut bytes) = (Arrays::any(), Arrays::any(), [0; 64]);
    let (Some(one), Some(other), Some(scene)) = (one.mesh(), other.mesh(), scene()) else { return };
    let Ok(mut frame) = Frame::<BinaryColor, Rows, _>::new(lent(&mut bytes), any(), any()) else { return };
    let instances = [one, other].map(|mesh| Instance::new(mesh, any()).with_material(material(shading)));
    let mut memory = SceneMemory::<16, 8, 8, S>::NEW;
    let mut light = Dithered::new(&mut frame, Levels::ONE_BIT);
    keep(draw_scene(&instances, &scene, &mut memory, &mut light).is_ok());
    let mut memory = memory.lend();
    memory.vertices = lent(memory.vertices);
    memory.buckets = lent(memory.buckets);
    let mut rows = Scanlines::new(any::<Rect>(), memory);
    keep(rows.begin(&instances, &scene).is_ok());
    while let Some(row) = rows.row() {
        keep((row, rows.draw_row(&mut light).is_ok()));
    }
}

fn trees() {
    let (arrays, mut vertices, mut bytes) = (Arrays::any(), [MeshVertex::EMPTY; 8], [0; 64]);
    let (Some(mesh), Some(scene)) = (arrays.mesh(), scene()) else { return };
    let node = Node { face: any(), parent: any(), front: any(), back: any(), first: any() };
    let (nodes, pieces) = ([node; 4], [Piece { triangle: any(), cut: any(), next: any() }; 4]);
    let cuts = [Split { side: any(), before: any() }; 4];
    let list = Triangles::new(part(&arrays.positions), part(&arrays.triangles));
    let Ok(tree) = Tree::new(list, part(&nodes), part(&pieces), part(&cuts)) else { return };
    let Ok(mut frame) = Frame::<Light, Words, _>::new(lent(&mut bytes), any(), any()) else { return };
    let instance = Instance::new(mesh, any()).with_material(material(Gouraud));
    let mut workspace = Workspace { vertices: lent(&mut vertices), hidden: &mut Convex };
    keep(draw_tree(&TreeInstance { instance, tree }, &scene, &mut workspace, &mut frame).is_ok());
}

/// In object space, and sorted by depth, in lists of any length.
fn ways() {
    let (one, other, mut bytes) = (Arrays::any(), Arrays::any(), [0; 64]);
    let (Some(one), Some(other), Some(scene)) = (one.mesh(), other.mesh(), scene()) else { return };
    let Ok(mut frame) = Frame::<Light, Words, _>::new(lent(&mut bytes), any(), any()) else { return };
    let instances = [one, other].map(|mesh| Instance::new(mesh, any()).with_material(material(Gouraud)));
    let (mut vertices, mut faces) = ([MeshVertex::EMPTY; 16], list::<_, 8>());
    let (mut compared, mut bounds) = (list::<_, 8>(), list::<_, 8>());
    let memory = ObjectSpaceMemory {
        vertices: lent(&mut vertices),
        faces: black_box(&mut faces),
        compared: black_box(&mut compared),
        bounds: black_box(&mut bounds),
    };
    keep(draw_compared(&instances, &scene, memory, &mut frame).is_ok());
    let (mut pieces, mut corners, mut cuts) = (list::<_, 8>(), list::<_, 8>(), list::<_, 8>());
    let memory = DepthSortMemory {
        vertices: lent(&mut vertices),
        faces: black_box(&mut faces),
        pieces: black_box(&mut pieces),
        corners: black_box(&mut corners),
        cuts: black_box(&mut cuts),
    };
    keep(draw_sorted(&instances, &scene, memory, &mut frame).is_ok());
}

const fn list<T, const N: usize>() -> Vec<T, N> {
    Vec::new()
}

fn shapes() {
    let arrays = Arrays::any();
    let (Some(mesh), Ok(sphere)) = (arrays.mesh(), Sphere::new(any(), any())) else { return };
    let mut shapes = [Shape::Sphere(sphere); 8];
    keep(mesh_shapes(&Instance::new(mesh, any()), lent(&mut shapes)));
    let Some(camera) = camera() else { return };
    if let Ok(side) = aquatint::HalfSpace::new(any(), any()) {
        keep(camera.clip_plane(&side));
    }
}
