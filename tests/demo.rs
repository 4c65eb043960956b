//! The demo as a person uses it: a program with arguments, files, and an exit code.

use std::{
    ffi::OsStr,
    fs,
    io::Cursor,
    path::{Path, PathBuf},
    process::Command,
};

use png::{BitDepth, ColorType};
use tempfile::TempDir;

/// How a run ended.
#[derive(Debug)]
struct Ended {
    code: Option<i32>,
    stdout: String,
    stderr: String,
}

/// Runs the example, which `cargo test` builds beside the tests, where there is no display.
fn demo(arguments: &[&OsStr]) -> Ended {
    let test = std::env::current_exe().expect("a path");
    let built = test.ancestors().nth(2).expect("target/debug").join("examples");
    let path = built.join(format!("demo{}", std::env::consts::EXE_SUFFIX));
    assert!(path.exists(), "{} is not built: run `cargo test` whole, or `cargo build --examples`", path.display());
    let mut command = Command::new(path);
    let output = command.args(arguments).env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY").output().expect("it runs");
    let utf8 = |bytes| String::from_utf8(bytes).expect("text");
    Ended { code: output.status.code(), stdout: utf8(output.stdout), stderr: utf8(output.stderr) }
}

/// A folder of its own with one file of the user's in it.
struct Desk {
    folder: TempDir,
}

impl Desk {
    fn new() -> Self {
        Self { folder: tempfile::tempdir().expect("a folder") }
    }

    fn out(&self) -> PathBuf {
        self.folder.path().join("out")
    }

    fn file(&self, name: &str, bytes: &[u8]) -> PathBuf {
        let path = self.folder.path().join(name);
        fs::write(&path, bytes).expect("written");
        path
    }

    /// Runs the demo for as few frames as there can be.
    fn show(&self, option: &str, file: &Path) -> Ended {
        demo(&[
            option.as_ref(),
            file.as_ref(),
            "--out".as_ref(),
            self.out().as_ref(),
            "--frames".as_ref(),
            "1".as_ref(),
        ])
    }

    /// The picture of the smallest panel with a file in it.
    fn shown(&self, option: &str, file: &Path) -> Vec<Vec<u8>> {
        let ended = self.show(option, file);
        assert_eq!((ended.code, ended.stderr.as_str()), (Some(0), ""), "{}", file.display());
        frames(&self.out().join("oled-128x64.png")).1
    }

    /// The file is refused in one line that names it, and nothing is written. Gives the line.
    fn refuses(&self, option: &str, file: &Path) -> String {
        let ended = self.show(option, file);
        assert_one_line(&ended);
        assert!(ended.stderr.contains(&file.display().to_string()), "{ended:?}");
        assert_eq!(ended.stdout, "", "{}", file.display());
        assert!(!self.out().exists(), "{}", file.display());
        ended.stderr
    }
}

fn assert_one_line(ended: &Ended) {
    assert_eq!(ended.code, Some(2), "{ended:?}");
    assert!(ended.stderr.starts_with("demo: ") && ended.stderr.ends_with('\n'), "{ended:?}");
    assert_eq!(ended.stderr.lines().count(), 1, "{ended:?}");
}

/// Width, height and the pixels of each frame of a PNG file.
fn frames(path: &Path) -> ((u32, u32), Vec<Vec<u8>>) {
    let mut decoder = png::Decoder::new(Cursor::new(fs::read(path).expect("a file")));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().expect("a PNG file");
    let count = reader.info().animation_control.map_or(1, |animation| animation.num_frames);
    let size = reader.info().size();
    let mut frame = vec![0; reader.output_buffer_size().expect("small")];
    let frames = (0..count).map(|_| {
        reader.next_frame(&mut frame).expect("a whole PNG file");
        frame.clone()
    });
    (size, frames.collect())
}

#[test]
fn it_writes_the_files_that_it_names_and_no_others() {
    let desk = Desk::new();
    let out = desk.out();
    let ended = demo(&["--out".as_ref(), out.as_ref(), "--frames".as_ref(), "2".as_ref(), "--no-window".as_ref()]);
    assert_eq!((ended.code, ended.stderr.as_str()), (Some(0), ""));
    let mut named: Vec<_> =
        ended.stdout.lines().filter_map(|line| line.strip_prefix("wrote ")).map(PathBuf::from).collect();
    let mut written: Vec<_> =
        fs::read_dir(&out).expect("a folder").map(|entry| entry.expect("a file").path()).collect();
    named.sort();
    written.sort();
    assert_eq!(named, written);

    let expected = [
        ("demo", (824, 912), 2),
        ("grey-oled-256x64", (768, 192), 1),
        ("memory-lcd-400x240", (800, 480), 1),
        ("oled-128x64", (384, 192), 1),
    ];
    assert_eq!(named, expected.map(|(name, ..)| out.join(name).with_extension("png")));
    for (name, size, count) in expected {
        let (found, frames) = frames(&out.join(name).with_extension("png"));
        assert_eq!((found, frames.len()), (size, count), "{name}");
        assert!(frames.windows(2).all(|pair| pair[0] != pair[1]), "the mesh turns");
    }
}

#[test]
fn the_picture_of_the_readme_is_what_it_draws() {
    let desk = Desk::new();
    let ended = demo(&["--frames".as_ref(), "1".as_ref(), "--out".as_ref(), desk.out().as_ref()]);
    assert_eq!(ended.code, Some(0), "{}", ended.stderr);
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/assets/demo.png");
    assert!(frames(&desk.out().join("demo.png")) == frames(&shipped), "see examples/assets/README.md");
}

#[test]
fn it_draws_the_panel_in_the_terminal() {
    let desk = Desk::new();
    let ended = demo(&["--out".as_ref(), desk.out().as_ref(), "--frames".as_ref(), "1".as_ref()]);
    let is_braille = |line: &&str| line.chars().all(|sign| ('\u{2800}'..='\u{28FF}').contains(&sign));
    let lines: Vec<_> = ended.stdout.lines().take_while(is_braille).map(|line| line.chars().count()).collect();
    assert_eq!(lines, [64; 16], "128 x 64 pixels, 2 x 4 a sign");
}

// Models.

const CUBE: &str = "\
mtllib there-is-none.mtl
o cube
v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1
vn 0 0 -1\nvn 0 0 1\nvn 0 -1 0\nvn 1 0 0\nvn 0 1 0\nvn -1 0 0
usemtl grey
f 1//1 4//1 3//1 2//1
f 5//2 6//2 7//2 8//2
f 1//3 2//3 6//3 5//3
f 2//4 3//4 7//4 6//4
f 3//5 4//5 8//5 7//5
f 4//6 1//6 5//6 8//6
";

const TETRAHEDRON: &str = "v 1 1 1\nv -1 -1 1\nv -1 1 -1\nv 1 -1 -1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

#[test]
fn models_with_quads_and_without_normals_are_shown() {
    let desk = Desk::new();
    let photo = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/assets/photo.png");
    let bunny = desk.shown("--image", &photo);
    let cube = desk.shown("--model", &desk.file("cube.obj", CUBE.as_bytes()));
    let tetrahedron = desk.shown("--model", &desk.file("tetrahedron.obj", TETRAHEDRON.as_bytes()));
    assert!(bunny != cube && cube != tetrahedron && bunny != tetrahedron);
}

#[test]
fn what_is_no_model_is_refused() {
    let corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    let files = [
        ("empty.obj", String::new()),
        ("text.obj", "Dear reader,\nthis is a letter.\n".into()),
        ("corners.obj", corners.into()),
        ("above.obj", format!("{corners}f 1 2 9\n")),
        ("below.obj", format!("{corners}f 1 2 -9\n")),
        ("zero.obj", format!("{corners}f 0 1 2\n")),
        ("nan.obj", format!("{corners}v NaN 0 0\nf 1 2 3\nf 2 3 4\n")),
        ("infinite.obj", format!("{corners}v 1e39 0 0\nf 1 2 3\nf 2 3 4\n")),
        ("point.obj", "v 7 7 7\n".repeat(3) + "f 1 2 3\n"),
        ("cut.obj", "v 0 0 0\nv 1 0".into()),
    ];
    for (name, text) in files {
        let desk = Desk::new();
        desk.refuses("--model", &desk.file(name, text.as_bytes()));
    }
    let desk = Desk::new();
    desk.refuses("--model", &desk.file("binary.obj", &[0xFF, 0xFE, 0, 10, 0xC3, 0x28]));
}

#[test]
fn a_model_of_more_vertices_than_a_mesh_can_name_is_refused() {
    let corners: Vec<_> = (1..=70_000).map(|corner| corner.to_string()).collect();
    let text = "v 1 2 3\n".repeat(corners.len()) + "f " + &corners.join(" ") + "\n";
    let desk = Desk::new();
    assert!(desk.refuses("--model", &desk.file("many.obj", text.as_bytes())).contains("65536"));
}

#[test]
fn what_is_no_file_is_refused() {
    let desk = Desk::new();
    for option in ["--model", "--image"] {
        desk.refuses(option, desk.folder.path());
        desk.refuses(option, &desk.folder.path().join("missing"));
    }
}

// Photographs.

fn encode(size: u32, color: ColorType, depth: BitDepth, data: &[u8]) -> Vec<u8> {
    let mut bytes = vec![];
    let mut encoder = png::Encoder::new(&mut bytes, size, size);
    encoder.set_color(color);
    encoder.set_depth(depth);
    if color == ColorType::Indexed {
        encoder.set_palette(vec![0, 0, 0, 255, 255, 255]);
    }
    encoder.write_header().expect("in memory").write_image_data(data).expect("as many bytes as the size says");
    bytes
}

#[test]
fn photographs_of_every_kind_are_shown() {
    let desk = Desk::new();
    let shown =
        |color, depth, data: &[u8]| desk.shown("--image", &desk.file("photo.png", &encode(2, color, depth, data)));
    let white = shown(ColorType::Rgb, BitDepth::Eight, &[0xFF; 12]);
    assert_eq!(shown(ColorType::Rgba, BitDepth::Eight, &[0xFF; 16]), white);
    assert_eq!(shown(ColorType::Rgb, BitDepth::Sixteen, &[0xFF; 24]), white);
    assert_eq!(shown(ColorType::Indexed, BitDepth::One, &[0b1100_0000; 2]), white);
    assert_eq!(shown(ColorType::Grayscale, BitDepth::One, &[0b1100_0000; 2]), white);
    assert_eq!(shown(ColorType::GrayscaleAlpha, BitDepth::Eight, &[0xFF; 8]), white);
    let black = shown(ColorType::Indexed, BitDepth::One, &[0; 2]);
    assert_ne!(black, white);
    assert_eq!(shown(ColorType::Rgba, BitDepth::Eight, &[0xFF, 0xFF, 0xFF, 0].repeat(4)), black, "transparent");
    assert_eq!(shown(ColorType::Rgb, BitDepth::Sixteen, &[0; 24]), black);
}

#[test]
fn what_is_no_photograph_is_refused() {
    let photo = include_bytes!("../examples/assets/photo.png");
    let files: [(&str, &[u8]); 5] = [
        ("empty.png", b""),
        ("text.png", b"Dear reader,\nthis is a letter.\n"),
        ("half.png", &photo[..photo.len() / 2]),
        ("header.png", &photo[..33]),
        ("signature.png", &photo[..8]),
    ];
    for (name, bytes) in files {
        let desk = Desk::new();
        desk.refuses("--image", &desk.file(name, bytes));
    }
}

#[test]
fn a_photograph_that_promises_more_than_memory_holds_is_refused() {
    let mut bytes = vec![];
    let mut header = png::Encoder::new(&mut bytes, 100_000, 100_000).write_header().expect("in memory");
    header.write_chunk(png::chunk::IDAT, &[0x78, 0x9C, 0x03, 0, 0, 0, 0, 1]).expect("in memory");
    drop(header);
    let desk = Desk::new();
    assert!(desk.refuses("--image", &desk.file("gigantic.png", &bytes)).contains("100000"));
}

// Options.

#[test]
fn a_window_without_a_display_is_refused_in_one_line() {
    let desk = Desk::new();
    let ended = demo(&["--window".as_ref(), "--frames".as_ref(), "1".as_ref(), "--out".as_ref(), desk.out().as_ref()]);
    assert_one_line(&ended);
    assert!(ended.stderr.contains("DISPLAY"), "{ended:?}");
}

#[test]
fn options_that_make_no_sense_are_refused() {
    let desk = Desk::new();
    for options in [&["--frames", "0"][..], &["--frames", "x"], &["--unknown"], &["--window", "--no-window"], &["file"]]
    {
        let out = desk.out();
        let arguments: Vec<_> = options.iter().map(OsStr::new).chain(["--out".as_ref(), out.as_ref()]).collect();
        let ended = demo(&arguments);
        assert_eq!((ended.code, ended.stdout.as_str()), (Some(2), ""), "{options:?}");
        assert!(ended.stderr.starts_with("error: ") && !out.exists(), "{options:?}");
    }
}

#[test]
fn a_place_that_cannot_be_written_to_is_refused_in_one_line() {
    let desk = Desk::new();
    let file = desk.file("file", b"mine");
    for out in [file.clone(), file.join("below")] {
        let ended = demo(&["--out".as_ref(), out.as_ref(), "--frames".as_ref(), "1".as_ref()]);
        assert_one_line(&ended);
        assert!(ended.stderr.contains(&out.display().to_string()), "{ended:?}");
    }
    assert_eq!(fs::read(file).expect("still there"), b"mine");
}
