//! Meshes in every shading, with every way to hide.
#![no_std]
#![no_main]

use aquatint::{
    BoundingBox3, BoundingSphere, ClipPlane, Dithered, Fog, Frame, Levels, Light, Rows, Sampler, Window, Words,
    fragment::{
        shade::{
            Corner, Flat, Fogged, Gouraud, LineShading, Mapped, Phong, Plain, Shader, Shading, Stippled, Textured,
            Unlit,
        },
        texture::{Bilinear, ClampToEdge, LightTexture, Mirror},
    },
    geometry::{light::Lighting, lights::Lights},
    hidden::{
        Hidden,
        convex::Convex,
        depth::{Depth, DepthBuffer, DepthTest},
    },
    pipeline::{Bounds, Instance, MeshVertex, Scene, Unpainted, Workspace, draw_mesh, draw_wireframe},
};
use embedded_graphics::pixelcolor::BinaryColor;
use heapless::Vec;
use nopanic::{
    any, keep, lent, one_of,
    scenes::{Model, camera, material, scene, source},
    side, some,
};

/// What a caller lends.
struct Memory {
    drawing: Drawing,
    places: [[i16; 3]; 8],
    texels: [Light; 16],
    depths_8: [u8; 2048],
    depths_16: [u16; 2048],
    depths_32: [u32; 2048],
}

struct Drawing {
    model: Model,
    bytes: [u8; 4096],
    vertices: [MeshVertex; 12],
    planes: Vec<ClipPlane, 4>,
}

const MEMORY: Memory = Memory {
    drawing: Drawing { model: Model::NEW, bytes: [0; 4096], vertices: [MeshVertex::EMPTY; 12], planes: Vec::new() },
    places: [[0; 3]; 8],
    texels: [Light::BLACK; 16],
    depths_8: [0; 2048],
    depths_16: [0; 2048],
    depths_32: [0; 2048],
};

nopanic::entries! { MEMORY;
    draw_mesh_gouraud = |memory: &mut Memory| shaded(Gouraud, memory),
    draw_mesh_flat = |memory: &mut Memory| shaded(Flat, memory),
    draw_mesh_phong = |memory: &mut Memory| shaded(Phong, memory),
    draw_mesh_unlit = |memory: &mut Memory| shaded(Unlit, memory),
    draw_mesh_plain = |memory: &mut Memory| shaded(Plain(any::<Light>()), memory),
    draw_mesh_mapped = |memory: &mut Memory| shaded(Mapped::new(Gouraud, |light: Light| Light(!light.0)), memory),
    draw_mesh_stippled = |memory: &mut Memory| shaded(Stippled::new(Flat, any::<[u8; 3]>()), memory),
    draw_mesh_fogged_gouraud = |memory: &mut Memory| fogged(Gouraud, memory),
    draw_mesh_fogged_phong = |memory: &mut Memory| fogged(Phong, memory),
    draw_mesh_shader,
    draw_mesh_textured = |memory: &mut Memory| textured(|texture| Textured::new(Sampler::new(texture), Unlit), memory),
    draw_mesh_textured_clamped = |memory: &mut Memory| {
        textured(|texture| Textured::new(Sampler::new(texture).with_wrap(ClampToEdge), Gouraud), memory);
    },
    draw_mesh_textured_bilinear = |memory: &mut Memory| {
        textured(|texture| Textured::new(Sampler::new(texture).with_wrap(Mirror).with_filter(Bilinear), Phong), memory);
    },
    draw_mesh_textured_affine = |memory: &mut Memory| {
        textured(|texture| Textured::new(Sampler::new(texture), Flat).affine(), memory);
    },
    draw_mesh_depth_u8 = |memory: &mut Memory| hiding(&mut memory.depths_8, &mut memory.drawing),
    draw_mesh_depth_u32 = |memory: &mut Memory| hiding(&mut memory.depths_32, &mut memory.drawing),
    draw_mesh_depth_test = |memory: &mut Memory| tested(&mut memory.depths_16, &mut memory.drawing),
    draw_mesh_without_writing = |memory: &mut Memory| unwritten(&mut memory.depths_16, &mut memory.drawing),
    draw_mesh_convex = |memory: &mut Memory| drawn(Gouraud, &mut Convex, (), scene(), &mut memory.drawing),
    draw_mesh_lights_gouraud = |memory: &mut Memory| drawn(Gouraud, &mut Convex, (), lit(), &mut memory.drawing),
    draw_mesh_lights_phong = |memory: &mut Memory| drawn(Phong, &mut Convex, (), lit(), &mut memory.drawing),
    draw_mesh_in_sphere,
    draw_mesh_in_box,
    draw_mesh_unpainted,
    draw_wireframe_gouraud = |memory: &mut Memory| wireframe(Gouraud, memory),
    draw_wireframe_unlit = |memory: &mut Memory| wireframe(Unlit, memory),
    draw_wireframe_plain = |memory: &mut Memory| wireframe(Plain(any::<Light>()), memory),
    draw_wireframe_fogged,
}

/// A mesh in a shading, behind a depth buffer, onto light that is dithered.
fn shaded<S: Shading<Color = Light>>(shading: S, memory: &mut Memory) {
    let Ok(mut depth) = DepthBuffer::new(lent(&mut memory.depths_16), any()) else { return };
    depth.clear();
    drawn(shading, &mut depth, (), scene(), &mut memory.drawing);
}

fn drawn<S, H, B, L>(shading: S, hidden: &mut H, bounds: B, scene: Option<Scene<L>>, memory: &mut Drawing)
where
    S: Shading<Color = Light>,
    H: Hidden,
    B: Bounds,
    L: Lighting,
{
    let (Some(mesh), Some(scene)) = (memory.model.mesh(), scene) else { return };
    let Ok(mut frame) = Frame::<BinaryColor, Rows, _>::new(lent(&mut memory.bytes), side(), side()) else { return };
    memory.planes.clear();
    while any::<u16>() > 5 && ClipPlane::new(any()).is_ok_and(|plane| memory.planes.push(plane).is_ok()) {}
    let instance = Instance::new(mesh, any()).with_material(material(shading)).with_planes(&memory.planes);
    let mut workspace = Workspace { vertices: lent(&mut memory.vertices), hidden };
    let mut band = Window::band(&mut frame, any());
    let mut light = Dithered::new(&mut band, Levels::ONE_BIT);
    keep(draw_mesh(&instance.with_bounds(bounds), &scene, &mut workspace, &mut light).is_ok());
}

fn fog() -> Option<Fog> {
    if any() { Fog::linear(any(), any(), any()).ok() } else { Fog::exponential(any(), any()).ok() }
}

fn fogged<S: Shading<Color = Light>>(shading: S, memory: &mut Memory)
where
    Fogged<S>: Shading<Color = Light>,
{
    if let Some(fog) = fog() {
        shaded(Fogged::new(shading, fog), memory);
    }
}

fn draw_mesh_shader(memory: &mut Memory) {
    let corner = |corner: &Corner| [corner.light.0, corner.position[0].cast_unsigned(), corner.index];
    shaded(Shader::new(corner, |[light, x, _]: [u16; 3]| (x & 0x400 == 0).then_some(Light(light))), memory);
}

fn textured<'a, S: Shading<Color = Light>>(shading: impl FnOnce(LightTexture<'a>) -> S, memory: &'a mut Memory) {
    let Memory { texels, depths_16, drawing, .. } = memory;
    let Ok(texture) = LightTexture::new(some(texels), any::<u32>() & 4, any::<u32>() & 4) else { return };
    let Ok(mut depth) = DepthBuffer::new(lent(depths_16), any()) else { return };
    depth.clear();
    drawn(shading(texture), &mut depth, (), scene(), drawing);
}

fn hiding<D: Depth + Ord>(depths: &mut [D], memory: &mut Drawing) {
    let Ok(mut depth) = DepthBuffer::new(lent(depths), any()) else { return };
    depth.clear();
    drawn(Gouraud, &mut depth, (), scene(), memory);
}

const TESTS: [DepthTest; 4] = [DepthTest::Nearer, DepthTest::NotFarther, DepthTest::Farther, DepthTest::NotEqual];

fn tested(depths: &mut [u16], memory: &mut Drawing) {
    let Ok(depth) = DepthBuffer::new(lent(depths), any()) else { return };
    drawn(Phong, &mut depth.with_test(one_of(&TESTS)), (), scene(), memory);
}

fn unwritten(depths: &mut [u16], memory: &mut Drawing) {
    let Ok(depth) = DepthBuffer::new(lent(depths), any()) else { return };
    drawn(Flat, &mut depth.with_test(one_of(&TESTS)).without_writing(), (), scene(), memory);
}

/// With several lamps.
fn lit() -> Option<Scene<Lights<2>>> {
    Some(Scene { camera: camera()?, light: Lights { ambient: any(), sources: [source(), source()] } })
}

fn draw_mesh_in_sphere(memory: &mut Memory) {
    drawn(Gouraud, &mut Convex, BoundingSphere::new(any(), any()), scene(), &mut memory.drawing);
}

fn draw_mesh_in_box(memory: &mut Memory) {
    if let Some(bounds) = BoundingBox3::of_places(some(&mut memory.places)) {
        drawn(Unlit, &mut Convex, bounds, scene(), &mut memory.drawing);
    }
}

fn draw_mesh_unpainted(memory: &mut Memory) {
    let Memory { depths_16, drawing, .. } = memory;
    let (Some(mesh), Some(scene)) = (drawing.model.mesh(), scene()) else { return };
    let Ok(mut depth) = DepthBuffer::new(lent(depths_16), any()) else { return };
    let instance = Instance::new(mesh, any()).with_material(material(Plain(any::<Light>())));
    let mut workspace = Workspace { vertices: lent(&mut drawing.vertices), hidden: &mut depth };
    keep(draw_mesh(&instance, &scene, &mut workspace, &mut Unpainted::new()).is_ok());
}

fn draw_wireframe_fogged(memory: &mut Memory) {
    if let Some(fog) = fog() {
        wireframe(Fogged::new(Gouraud, fog), memory);
    }
}

fn wireframe<S: LineShading<Color = Light>>(shading: S, memory: &mut Memory) {
    let Memory { depths_16, drawing, .. } = memory;
    let (Some(mesh), Some(scene)) = (drawing.model.mesh(), scene()) else { return };
    let Ok(mut depth) = DepthBuffer::new(lent(depths_16), any()) else { return };
    depth.clear();
    let Ok(mut frame) = Frame::<Light, Words, _>::new(lent(&mut drawing.bytes), side(), side()) else { return };
    let instance = Instance::new(mesh, any()).with_material(material(shading));
    let mut workspace = Workspace { vertices: lent(&mut drawing.vertices), hidden: &mut depth };
    keep(draw_wireframe(&instance, &scene, &mut workspace, &mut frame).is_ok());
}
