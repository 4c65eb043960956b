//! Files of meshes, OBJ and STL, to Rust.

#[path = "../demo/obj.rs"]
pub mod obj;
pub mod report;
pub mod stl;
pub mod tree;

use std::{fmt::Debug, io::Write, path::Path};

use aquatint::model::mesh::Mesh;
use obj::{OwnedMesh, RawMesh};

/// The mesh of a file as an expression, and what was lost by it. What is wrong with the file is one line.
pub fn convert(path: &Path) -> Result<(String, String), String> {
    convert_to(path, |_, source| Ok(source))
}

/// The same, with the mesh's tree.
pub fn convert_with_tree(path: &Path) -> Result<(String, String), String> {
    convert_to(path, |mesh, source| tree::source(mesh, &source))
}

fn convert_to(path: &Path, form: impl Fn(&Mesh, String) -> Result<String, String>) -> Result<(String, String), String> {
    let raw = read(path)?.merged()?;
    let owned = OwnedMesh::of(&raw)?;
    let mesh = owned.borrow().map_err(|e| e.to_string())?;
    Ok((form(&mesh, source(&mesh))?, report::of(&raw, &owned)?))
}

/// By the name of the file.
fn read(path: &Path) -> Result<RawMesh, String> {
    let named = |name: &str| path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case(name));
    if named("obj") {
        obj::read(&obj::bytes(path)?)
    } else if named("stl") {
        stl::read(&obj::bytes(path)?)
    } else {
        Err("is named neither .obj nor .stl".into())
    }
}

/// An expression of type `Mesh<'static>`, checked by the compiler that includes it.
fn source(mesh: &Mesh) -> String {
    let triangles: Vec<_> = mesh.triangles().collect();
    let arrays = [rows(mesh.positions()), rows(mesh.normals()), rows(&triangles)].map(|rows| format!("&[{rows}],\n"));
    let ok = match mesh.uv() {
        None => "mesh".into(),
        Some(uv) => format!("match mesh.with_uv(&[{}]) {{ Ok(mesh) => mesh, Err(_) => panic!() }}", rows(uv)),
    };
    let arrays = arrays.concat();
    format!(
        "match aquatint::model::mesh::Mesh::new(\n{arrays}) {{\n    Ok(mesh) => {ok},\n    Err(_) => panic!(),\n}}\n"
    )
}

fn rows<T: Debug, const N: usize>(groups: &[[T; N]]) -> String {
    let text = |group: &[T; N]| format!("{group:?},").replace(' ', "");
    groups.chunks(8).map(|chunk| chunk.iter().map(text).collect::<String>() + "\n").collect()
}

/// Writes a file whole or not at all: under another name first.
pub fn write(path: &Path, text: &str) -> Result<(), String> {
    let mut name = path.file_name().ok_or("is no name of a file")?.to_owned();
    name.push(format!(".{}.part", std::process::id()));
    let part = path.with_file_name(name);
    let written = std::fs::File::create(&part).and_then(|mut file| {
        file.write_all(text.as_bytes())?;
        file.sync_all()?;
        std::fs::rename(&part, path)
    });
    written.map_err(|error| {
        // It may not even be there.
        let _ = std::fs::remove_file(&part);
        error.to_string()
    })
}
