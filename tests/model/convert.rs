//! The converter's own functions on good and broken files.

#[path = "../../examples/meshes/mod.rs"]
mod meshes;

use std::path::{Path, PathBuf};

use aquatint::{hidden::bsp::Tree, model::mesh::Mesh};

/// What the converter makes of a tetrahedron.
static TETRAHEDRON: (Mesh, Tree) = include!("tetrahedron_with_tree.rs");

/// Two triangles with a common edge, one vertex written twice.
const QUAD: &str = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 2 0 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n\
                    f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/4/1\nf 5/2/1 3/3/1 1/1/1\n";

fn in_folder(name: &str, bytes: &[u8]) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(name);
    std::fs::write(&path, bytes).expect("written");
    (folder, path)
}

fn convert(name: &str, bytes: impl AsRef<[u8]>) -> Result<(String, String), String> {
    let (_folder, path) = in_folder(name, bytes.as_ref());
    meshes::convert(&path)
}

/// A tetrahedron as binary STL.
fn tetrahedron() -> Vec<u8> {
    let corners = [[1.0_f32, 1.0, 1.0], [-1.0, -1.0, 1.0], [-1.0, 1.0, -1.0], [1.0, -1.0, -1.0]];
    let mut bytes = b"solid, says the header of this binary file".to_vec();
    bytes.resize(80, b' ');
    bytes.extend(4_u32.to_le_bytes());
    for face in [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]] {
        bytes.extend([0; 12]);
        bytes.extend(face.iter().flat_map(|&i: &usize| corners[i]).flat_map(f32::to_le_bytes));
        bytes.extend([0; 2]);
    }
    bytes
}

const TEXT: &str = "solid one\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1 0\n  endloop\n endfacet\nendsolid one\n";

#[test]
fn an_obj_with_texture() {
    let (source, report) = convert("quad.OBJ", QUAD).expect("a good file");
    assert!(source.contains("[-11585,-11585,0],[11585,-11585,0],[11585,11585,0],[-11585,11585,0],\n],"), "{source}");
    assert!(source.contains("[0,1,2],[0,2,3],[1,2,0],"), "the vertex written twice is one: {source}");
    assert!(source.contains("mesh.with_uv(&[[0,4096],[4096,4096],[4096,0],[0,0],"), "{source}");
    assert!(report.starts_with("4 vertices, 3 triangles, 70 bytes of flash\nplaces: off by "), "{report}");
    assert!(report.contains("normals: off by 0.00 degrees") && report.contains("texture: off by 0.00000"), "{report}");
}

#[test]
fn both_kinds_of_stl() {
    let (source, report) = convert("t.stl", tetrahedron()).expect("a good file");
    assert!(source.contains("[9459,9459,9459],[-9459,9459,-9459],[-9459,-9459,9459],[9459,-9459,-9459],"), "{source}");
    assert!(source.contains("[73,73,73],[-73,73,-73],[-73,-73,73],[73,-73,-73],"), "smooth normals: {source}");
    assert!(report.starts_with("4 vertices, 4 triangles, 60 bytes of flash\n"), "{report}");
    let (source, report) = convert("t.stl", TEXT).expect("a good file");
    assert!(source.contains("[0,1,2],") && report.starts_with("3 vertices, 1 triangles"), "{source}");
    assert!(report.contains("normals: off by 0.00"), "{report}");
}

#[test]
fn broken_files_are_told_apart() {
    let mut short = tetrahedron();
    short.truncate(200);
    let not_finite = TEXT.replace("vertex 1 0 0", "vertex inf 0 0");
    let cases: [(&str, &[u8], &str); 12] = [
        ("a.ply", b"", "is named neither .obj nor .stl"),
        ("a.obj", b"", "has no triangles"),
        ("a.obj", b"v 0 0 x\nf 1 1 1\n", "is not a Wavefront OBJ file"),
        ("a.obj", b"v 0 0 0\nv 1 0 0\nf 1 2 3\n", "is not a Wavefront OBJ file"),
        ("a.obj", b"v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n", "has no triangle with an area"),
        ("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 9 0\nf 1/1 2/1 3/1\n", "has texture coordinates beyond 8"),
        ("a.stl", b"", "ends before its last triangle"),
        ("a.stl", &short, "is not an STL file"),
        ("a.stl", b"solid a\nvertex 1 2\n", "is not an STL file: line 2"),
        ("a.stl", b"solid a\nvertex 1 2 c\n", "has no numbers in line 2"),
        ("a.stl", b"solid a\nouter loop\nvertex 1 2 3\nendloop\n", "has no triangle before line 4"),
        ("a.stl", not_finite.as_bytes(), "has a coordinate that is not a number"),
    ];
    for (name, bytes, expected) in cases {
        let error = convert(name, bytes).expect_err(expected);
        assert!(error.starts_with(expected) && !error.contains('\n'), "{error:?} for {expected:?}");
    }
    assert!(meshes::convert(Path::new("/nowhere/a.obj")).is_err());
}

#[test]
fn any_bytes_are_read_or_refused() {
    let mut seed = 1_u64;
    for length in 0..600_usize {
        let mut bytes = if length % 2 == 0 { tetrahedron() } else { QUAD.as_bytes().to_vec() };
        bytes.truncate(length);
        for _ in 0..3 {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            let at = usize::try_from(seed >> 40).expect("24 bits") % bytes.len().max(1);
            if let Some(byte) = bytes.get_mut(at) {
                *byte = seed.to_le_bytes()[6];
            }
        }
        let _ = meshes::stl::read(&bytes).and_then(|raw| raw.merged());
        let _ = meshes::obj::read(&bytes).and_then(|raw| raw.merged());
    }
}

#[test]
fn a_file_is_written_whole_or_not_at_all() {
    let (folder, path) = in_folder("mesh.rs", b"old");
    meshes::write(&path, "new").expect("written");
    assert_eq!(std::fs::read(&path).expect("there"), b"new");
    assert!(meshes::write(&folder.path().join("no/such/folder.rs"), "new").is_err());
    assert_eq!(std::fs::read_dir(folder.path()).expect("a folder").count(), 1, "nothing else is left");
}

#[test]
fn a_mesh_with_its_tree() {
    let (_folder, path) = in_folder("t.stl", &tetrahedron());
    let (source, _) = meshes::convert_with_tree(&path).expect("a good file");
    assert_eq!(source, include_str!("tetrahedron_with_tree.rs"));
    let (mesh, tree) = &TETRAHEDRON;
    assert_eq!((mesh.positions().len(), tree.nodes().len(), tree.pieces().len()), (4, 4, 4));
}
