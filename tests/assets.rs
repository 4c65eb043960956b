//! The bunny that is compiled in is the one of the OBJ file, and a mesh as `Mesh` wants it.

use std::{
    collections::HashMap,
    path::{Path, PathBuf},
    process::Command,
};

use aquatint::model::mesh::Mesh;

const BUNNY: Mesh<'static> = include!("../examples/assets/bunny.rs");

/// The program of an example, which `cargo test` has built.
fn example(name: &str) -> PathBuf {
    let test = std::env::current_exe().expect("a path");
    let built = test.ancestors().nth(2).expect("target/debug").join("examples");
    let path = built.join(format!("{name}{}", std::env::consts::EXE_SUFFIX));
    assert!(path.exists(), "{} is not built: run `cargo test` whole, or `cargo build --examples`", path.display());
    path
}

#[test]
fn the_constant_is_what_the_converter_makes_of_the_file() {
    let model = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/assets/bunny.obj");
    let output = Command::new(example("mesh_to_rust")).arg(model).output().expect("it runs");
    assert!(output.status.success());
    let (made, kept) = (String::from_utf8(output.stdout).expect("text"), include_str!("../examples/assets/bunny.rs"));
    let differing = made.lines().zip(kept.lines()).position(|(made, kept)| made != kept);
    assert_eq!((differing, made.len()), (None, kept.len()), "the first line that differs, and the lengths");
}

#[test]
fn it_has_the_size_that_is_told() {
    assert_eq!((BUNNY.positions().len(), BUNNY.normals().len(), BUNNY.triangles().count()), (1839, 1839, 3674));
}

#[test]
fn every_edge_is_used_once_in_each_direction() {
    let mut uses = HashMap::new();
    for [a, b, c] in BUNNY.triangles() {
        for edge in [(a, b), (b, c), (c, a)] {
            *uses.entry(edge).or_insert(0) += 1;
        }
    }
    for (&(from, to), &count) in &uses {
        assert_eq!((count, uses.get(&(to, from))), (1, Some(&1)), "the edge from {from} to {to}");
    }
}

#[test]
fn its_front_faces_are_outside() {
    let six_volumes = BUNNY.triangles().map(|corners| {
        let [[ax, ay, az], [bx, by, bz], [cx, cy, cz]] =
            corners.map(|corner| BUNNY.positions()[usize::from(corner)].map(i64::from));
        ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
    });
    assert!(six_volumes.sum::<i64>() > 0);
}

#[test]
fn it_fills_the_unit_sphere() {
    let farthest = BUNNY.positions().iter().map(|position| length(position.map(f64::from))).fold(0.0, f64::max);
    assert!((farthest - 16_384.0).abs() < 1.0, "{farthest}");
}

#[test]
fn normals_have_a_length_of_127() {
    for (vertex, normal) in BUNNY.normals().iter().enumerate() {
        let length = length(normal.map(f64::from));
        assert!((126.0..=128.0).contains(&length), "vertex {vertex}: {length}");
    }
}

fn length(vector: [f64; 3]) -> f64 {
    vector.iter().map(|v| v * v).sum::<f64>().sqrt()
}

#[test]
fn pictures_are_what_the_examples_draw() {
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["shapes", "antialiasing", "solids", "motion", "hidden"] {
        let made = folder.path().join(format!("{name}.png"));
        let output = Command::new(example(name)).arg(&made).output().expect("it runs");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let kept = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("examples/assets/{name}.png"));
        assert!(pixels(&made) == pixels(&kept), "cargo run --release --example {name} examples/assets/{name}.png");
    }
}

/// Size and bytes of a PNG.
fn pixels(path: &Path) -> (u32, u32, Vec<u8>) {
    let file = std::io::BufReader::new(std::fs::File::open(path).expect("a file"));
    let mut reader = png::Decoder::new(file).read_info().expect("a PNG");
    let mut bytes = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut bytes).expect("a picture");
    (info.width, info.height, bytes)
}
