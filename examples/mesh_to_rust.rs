//! Writes a Wavefront OBJ file as a constant mesh: `cargo run --example mesh_to_rust -- model.obj > model.rs`
//!
//! In the firmware, `const MESH: Mesh = include!("model.rs");`
#![cfg_attr(target_os = "none", no_std, no_main)]
#![cfg(not(target_os = "none"))]

#[path = "demo/obj.rs"]
mod obj;

use aquatint::model::mesh::Mesh;
use std::{fmt::Debug, io::Write, path::PathBuf, process::ExitCode};

fn main() -> ExitCode {
    let arguments: Vec<_> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    let [path] = &arguments[..] else {
        eprintln!("usage: mesh_to_rust MODEL.obj > MESH.rs");
        return ExitCode::from(2);
    };
    let written = obj::load(path).and_then(|owned| {
        let mesh = owned.borrow().map_err(|e| format!("{e:?}"))?;
        std::io::stdout().write_all(source(&mesh).as_bytes()).map_err(|e| e.to_string())?;
        Ok(format!("{} vertices, {} triangles", mesh.positions().len(), mesh.triangles().len()))
    });
    match written {
        Ok(summary) => {
            eprintln!("{summary}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("mesh_to_rust: {} {error}", path.display());
            ExitCode::from(2)
        }
    }
}

/// An expression of type `Mesh<'static>`, checked by the compiler that includes it.
fn source(mesh: &Mesh) -> String {
    format!(
        "match aquatint::model::mesh::Mesh::new(\n&[{}],\n&[{}],\n&[{}],\n) {{\n    Ok(mesh) => mesh,\n    Err(_) => panic!(),\n}}\n",
        rows(mesh.positions()),
        rows(mesh.normals()),
        rows(mesh.triangles()),
    )
}

fn rows<T: Debug>(triples: &[[T; 3]]) -> String {
    let text = |[a, b, c]: &[T; 3]| format!("[{a:?},{b:?},{c:?}],");
    triples.chunks(8).map(|chunk| chunk.iter().map(text).collect::<String>() + "\n").collect()
}
