//! The photographs.

use std::{fs::File, io::BufReader, path::Path};

/// 256 × 256 sRGB codes.
pub const SIDE: usize = 256;

/// All four.
pub fn all() -> [Vec<u8>; 4] {
    ["examples/assets/photo.png", "tests/photos/astronaut.png", "tests/photos/chelsea.png", "tests/photos/coffee.png"]
        .map(load)
}

fn load(path: &str) -> Vec<u8> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    let decoder = png::Decoder::new(BufReader::new(File::open(&path).expect("it exists")));
    let mut reader = decoder.read_info().expect("a PNG");
    let mut codes = vec![0; reader.output_buffer_size().expect("small")];
    let info = reader.next_frame(&mut codes).expect("whole");
    assert_eq!((info.width, info.height, info.buffer_size()), (256, 256, SIDE * SIDE), "{}", path.display());
    codes
}
