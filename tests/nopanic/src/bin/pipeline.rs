//! Meshes in every shading, with every way to hide.
#![no_std]
#![no_main]

use aquatint::{
    BoundingBox3, BoundingSphere, ClipPlane, Dithered, Fog, Frame, HalfSpace, Levels, Light, Rows, Sampler, Window, Words,
    fragment::{
        shade::{
            Corner, Flat, Fogged, Gouraud, LineShading, Mapped, Phong, Plain, Shader, Shading, Stippled, Textured,
            Unlit,
        },
        texture::{Bilinear, ClampToEdge, LightTexture, Mirror},
    },
    geometry::{
        light::{Lamp, Lighting},
        lights::{Lights, Source},
    },
    hidden::{
        Hidden,
        bsp::Tree,
        convex::Convex,
        depth::{Depth, DepthBuffer, DepthTest},
        raycast::{Shape, Sphere},
    },
    model::mesh::Mesh,
    pipeline::{
        Bounds, Instance, MeshVertex, Scene, TreeInstance, Unpainted, Workspace, draw_mesh, draw_tree, draw_wireframe,
        mesh_shapes,
    },
};
use embedded_graphics::pixelcolor::BinaryColor;
use heapless::Vec;
use nopanic::{
    any, keep, lent, one_of, part,
    scenes::{Model, camera, material, scene, source},
    some,
};

/// What a caller lends.
struct Memory {
    model: Model,
    bytes: [u8; 4096],
    vertices: [MeshVertex; 12],
    planes: Vec<ClipPlane, 4>,
    texels: [Light; 16],
    depths_8: [u8; 2048],
    depths_16: [u16; 2048],
    depths_32: [u32; 2048],
    shapes: Vec<Shape, 8>,
}

const MEMORY: Memory = Memory {
    model: Model::NEW,
    bytes: [0; 4096],
    vertices: [MeshVertex::EMPTY; 12],
    planes: Vec::new(),
    texels: [Light::BLACK; 16],
    depths_8: [0; 2048],
    depths_16: [0; 2048],
    depths_32: [0; 2048],
    shapes: Vec::new(),
};

nopanic::entries! { MEMORY;
    draw_mesh_gouraud = |memory: &mut Memory| shaded(Gouraud, memory),
    draw_mesh_flat = |memory: &mut Memory| shaded(Flat, memory),
    draw_mesh_phong = |memory: &mut Memory| shaded(Phong, memory),
    draw_mesh_unlit = |memory: &mut Memory| shaded(Unlit, memory),
    draw_mesh_plain = |memory: &mut Memory| shaded(Plain(any::<Light>()), memory),
    draw_mesh_mapped,
    draw_mesh_stippled,
    draw_mesh_fogged_gouraud,
    draw_mesh_fogged_phong,
    draw_mesh_shader,
}
