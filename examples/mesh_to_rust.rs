//! Writes a Wavefront OBJ or an STL file as a constant mesh: `cargo run --example mesh_to_rust -- model.obj > model.rs`
//!
//! In the firmware, `const MESH: Mesh = include!("model.rs");`. With `--out FILE` it writes that file, whole or not at
//! all. With `--bsp` the expression is a mesh and its BSP tree: `static MODEL: (Mesh, Tree) = include!("model.rs")`. What was
//! lost by quantising is told on stderr.
#![cfg_attr(target_os = "none", no_std, no_main)]
#![cfg(not(target_os = "none"))]

mod meshes;

use std::{
    io::Write,
    path::{Path, PathBuf},
    process::ExitCode,
};

fn main() -> ExitCode {
    let (trees, arguments): (Vec<_>, Vec<_>) =
        std::env::args_os().skip(1).map(PathBuf::from).partition(|argument| argument.as_os_str() == "--bsp");
    let convert = if trees.is_empty() { meshes::convert } else { meshes::convert_with_tree };
    let (model, out) = match &arguments[..] {
        [model] => (model, None),
        [model, option, out] if option.as_os_str() == "--out" => (model, Some(out)),
        [option, out, model] if option.as_os_str() == "--out" => (model, Some(out)),
        _ => {
            eprintln!("usage: mesh_to_rust MODEL.obj|MODEL.stl [--bsp] [--out MESH.rs]");
            return ExitCode::from(2);
        }
    };
    match convert(model)
        .map_err(|error| format!("{} {error}", model.display()))
        .and_then(|converted| written(converted, out.map(PathBuf::as_path)))
    {
        Ok(summary) => {
            eprintln!("{summary}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("mesh_to_rust: {error}");
            ExitCode::from(2)
        }
    }
}

fn written((source, summary): (String, String), out: Option<&Path>) -> Result<String, String> {
    match out {
        Some(out) => meshes::write(out, &source).map_err(|error| format!("{} {error}", out.display()))?,
        None => std::io::stdout().write_all(source.as_bytes()).map_err(|error| error.to_string())?,
    }
    Ok(summary)
}
