//! Pictures as text, compared with text.

use aquatint_simulator::{Codes, Picture, braille, half_blocks};

fn codes(rows: &[&str]) -> Codes {
    let values: Vec<u8> =
        rows.iter().flat_map(|row| row.bytes()).map(|character| u8::from(character == b'#') * 15).collect();
    let height = u32::try_from(rows.len()).expect("few rows");
    let width = u32::try_from(rows[0].len()).expect("few columns");
    Codes { width, height, levels: 16, values }
}

#[test]
fn half_blocks_set_a_colour_where_it_changes() {
    let rgb = [
        [1, 2, 3],
        [1, 2, 3],
        [0, 0, 0], //
        [4, 5, 6],
        [7, 8, 9],
        [7, 8, 9],
    ];
    let picture = Picture::from_rgb(3, 2, rgb.concat()).expect("six pixels");
    assert_eq!(half_blocks(&picture), "\x1b[38;2;1;2;3m\x1b[48;2;4;5;6m▀\x1b[48;2;7;8;9m▀\x1b[38;2;0;0;0m▀\x1b[0m\n");
}

#[test]
fn an_odd_last_row_has_no_background() {
    let picture = Picture::filled(1, 3, [255, 0, 9]);
    assert_eq!(half_blocks(&picture), "\x1b[38;2;255;0;9m\x1b[48;2;255;0;9m▀\x1b[0m\n\x1b[38;2;255;0;9m▀\x1b[0m\n");
    assert_eq!(half_blocks(&Picture::filled(0, 0, [0; 3])), "");
}

#[test]
fn every_braille_dot_is_where_it_belongs() {
    let mut text = String::new();
    for dot in 0..8 {
        let mut codes = codes(&["..", "..", "..", ".."]);
        codes.values[dot] = 15;
        text.push_str(braille(&codes, 8).trim_end());
    }
    assert_eq!(text, "⠁⠈⠂⠐⠄⠠⡀⢀");
}

#[test]
fn braille_of_any_size() {
    let panel = codes(&[
        "#####", //
        "#...#", "#...#", "#...#", "#####",
    ]);
    assert_eq!(braille(&panel, 8), "⡏⠉⡇\n⠉⠉⠁\n");
    assert_eq!(braille(&codes(&["#"]), 1), "⠁\n");
}

#[test]
fn the_threshold_is_the_first_code_that_is_a_dot() {
    let grey = Codes { width: 2, height: 1, levels: 16, values: vec![7, 8] };
    assert_eq!(braille(&grey, 0), "⠉\n");
    assert_eq!(braille(&grey, 8), "⠈\n");
    assert_eq!(braille(&grey, 9), "⠀\n");
}
