//! Scenes of two meshes without a depth buffer.

use aquatint::{
    Dithered, Frame, Levels, Rows, Target,
    fragment::shade::Gouraud,
    geometry::light::Lighting,
    hidden::depth::DepthBuffer,
    model::mesh::Mesh,
    pipeline::{
        DepthSortMemory, Instance, MeshVertex, ObjectSpaceMemory, Scene, SceneMemory, Workspace, draw_compared, draw_mesh,
        draw_scene, draw_sorted,
    },
};
use embedded_graphics::pixelcolor::BinaryColor;
use heapless::Vec as Room;

use super::{Arrays, HEIGHT, VERTICES, WIDTH};

/// Two meshes row by row and in object space: the pixels of a depth buffer of 32 bits. Sorted by depth: no panic.
pub fn check<L: Lighting>(meshes: [&Arrays; 2], scene: &Scene<L>) {
    let instances = meshes.map(|arrays| {
        let mesh = Mesh::with_assembly(&arrays.positions, &arrays.normals, arrays.assembly()).expect("indices are right");
        Instance::new(mesh, arrays.placement).with_material(arrays.look.material(Gouraud))
    });
    let (mut rows, mut pixels) = ([0; (WIDTH * HEIGHT / 8) as usize], [0; (WIDTH * HEIGHT / 8) as usize]);
    let mut frame = Frame::<BinaryColor, Rows, _>::new(&mut rows[..], WIDTH, HEIGHT).expect("large enough");
    let mut memory = SceneMemory::<{ 2 * VERTICES }, 512, 512>::NEW;
    let result = draw_scene(&instances, scene, &mut memory, &mut Dithered::new(&mut frame, Levels::ONE_BIT));
    let mut frame = Frame::<BinaryColor, Rows, _>::new(&mut pixels[..], WIDTH, HEIGHT).expect("large enough");
    let mut depths = [0_u32; (WIDTH * HEIGHT) as usize];
    let mut hidden = DepthBuffer::new(&mut depths, frame.bounds()).expect("large enough");
    let mut light = Dithered::new(&mut frame, Levels::ONE_BIT);
    for instance in &instances {
        let mut vertices = [MeshVertex::EMPTY; VERTICES];
        let mut workspace = Workspace { vertices: &mut vertices, hidden: &mut hidden };
        let drawn = draw_mesh(instance, scene, &mut workspace, &mut light);
        assert!(drawn.is_ok() || result.is_err());
    }
    assert!(result.is_err() || rows == pixels);
    let (mut vertices, mut faces) = ([MeshVertex::EMPTY; 2 * VERTICES], Room::<_, 512>::new());
    let mut frame = Frame::<BinaryColor, Rows, _>::new(vec![0; rows.len()], WIDTH, HEIGHT).expect("large enough");
    let (mut compared, mut bounds) = (Room::<_, 512>::new(), Room::<_, 2048>::new());
    let memory = ObjectSpaceMemory {
        vertices: &mut vertices,
        faces: &mut faces,
        compared: &mut compared,
        bounds: &mut bounds,
    };
    let drawn = draw_compared(&instances, scene, memory, &mut Dithered::new(&mut frame, Levels::ONE_BIT));
    assert!(drawn.is_err() || frame.bytes() == pixels);
    let (mut pieces, mut corners, mut cuts) = (Room::<_, 1024>::new(), Room::<_, 8192>::new(), Room::<_, 2048>::new());
    let memory = DepthSortMemory {
        vertices: &mut vertices,
        faces: &mut faces,
        pieces: &mut pieces,
        corners: &mut corners,
        cuts: &mut cuts,
    };
    // Where depths tie, another face may be seen: only that it ends, and stays inside.
    let _ = draw_sorted(&instances, scene, memory, &mut Dithered::new(&mut frame, Levels::ONE_BIT));
}
