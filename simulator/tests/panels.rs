//! Bytes written by hand, in each packing, and the picture a controller would show.

use aquatint_simulator::{Codes, Packing, Panel};

fn panel(width: u32, height: u32, bits: u8, packing: Packing) -> Panel {
    Panel { width, height, bits, packing, ..Panel::SSD1322_256X64 }
}

/// Rows of hexadecimal digits; with one bit, of '#' and '.'.
fn drawn(codes: &Codes) -> Vec<String> {
    let character = |x, y| match (codes.levels, codes.get(x, y)) {
        (2, Some(code)) => [".", "#"][usize::from(code)].to_owned(),
        (_, Some(code)) => format!("{code:x}"),
        (_, None) => "?".to_owned(),
    };
    (0..codes.height).map(|y| (0..codes.width).map(|x| character(x, y)).collect()).collect()
}

#[test]
fn rows_with_the_left_pixel_in_the_highest_bit() {
    let panel = panel(11, 3, 1, Packing::RowsMsbFirst);
    let bytes = [
        0b1110_0001,
        0b0000_0000, //
        0b1000_0001,
        0b0010_0000, //
        0b1000_0001,
        0b1110_0000,
    ];
    assert_eq!(
        drawn(&panel.codes(&bytes).expect("two bytes a row")),
        [
            "###....#...", //
            "#......#..#",
            "#......####",
        ]
    );
}

#[test]
fn rows_with_the_left_pixel_in_the_lowest_bit() {
    let panel = panel(11, 3, 1, Packing::RowsLsbFirst);
    let bytes = [
        0b1000_0111,
        0b0000_0000, //
        0b1000_0001,
        0b0000_0100, //
        0b1000_0001,
        0b0000_0111,
    ];
    assert_eq!(
        drawn(&panel.codes(&bytes).expect("two bytes a row")),
        [
            "###....#...", //
            "#......#..#",
            "#......####",
        ]
    );
}

#[test]
fn padding_is_not_shown() {
    let msb = panel(3, 1, 1, Packing::RowsMsbFirst);
    let lsb = panel(3, 1, 1, Packing::RowsLsbFirst);
    let pages = panel(1, 3, 1, Packing::PagesLsbTop);
    assert_eq!(msb.codes(&[0b0001_1111]).expect("a byte").values, [0; 3]);
    assert_eq!(lsb.codes(&[0b1111_1000]).expect("a byte").values, [0; 3]);
    assert_eq!(pages.codes(&[0b1111_1000]).expect("a byte").values, [0; 3]);
}

#[test]
fn pages_run_along_x_with_the_top_pixel_in_the_lowest_bit() {
    let panel = panel(4, 10, 1, Packing::PagesLsbTop);
    let bytes = [
        0b1111_1111,
        0b0000_0001,
        0b1000_0001,
        0b0000_0010, //
        0b0000_0001,
        0b0000_0000,
        0b0000_0011,
        0b0000_0000,
    ];
    assert_eq!(
        drawn(&panel.codes(&bytes).expect("two pages")),
        [
            "###.", //
            "#..#", "#...", "#...", "#...", "#...", "#...", "#.#.", //
            "#.#.", "..#.",
        ]
    );
}

#[test]
fn two_bits() {
    let bytes = [0b00_01_10_11, 0b11_00_00_00, 0b11_11_00_00, 0b00_00_00_01];
    let msb = panel(5, 2, 2, Packing::RowsMsbFirst);
    assert_eq!(drawn(&msb.codes(&bytes).expect("four bytes")), ["01233", "33000"]);
    let lsb = panel(5, 2, 2, Packing::RowsLsbFirst);
    assert_eq!(drawn(&lsb.codes(&bytes).expect("four bytes")), ["32100", "00331"]);
    let pages = panel(4, 4, 2, Packing::PagesLsbTop);
    assert_eq!(drawn(&pages.codes(&bytes).expect("one page")), ["3001", "2000", "1030", "0330"]);
}

#[test]
fn four_bits_are_nibbles() {
    let bytes = [0x12, 0x3f, 0xab, 0xc0];
    let msb = panel(3, 2, 4, Packing::RowsMsbFirst);
    assert_eq!(drawn(&msb.codes(&bytes).expect("four bytes")), ["123", "abc"]);
    let lsb = panel(3, 2, 4, Packing::RowsLsbFirst);
    assert_eq!(drawn(&lsb.codes(&bytes).expect("four bytes")), ["21f", "ba0"]);
}

#[test]
fn eight_bits_are_bytes() {
    let panel = panel(2, 2, 8, Packing::RowsMsbFirst);
    let codes = panel.codes(&[0, 1, 128, 255]).expect("four bytes");
    assert_eq!(codes.levels, 256);
    assert_eq!(codes.values, [0, 1, 128, 255]);
    assert_eq!(panel.colour(255), panel.theme.light);
}

#[test]
fn corners_of_the_real_panels_are_where_the_data_sheets_have_them() {
    let corner = |panel: Panel, byte: usize, value: u8| {
        let mut bytes = vec![0; panel.byte_len()];
        bytes[byte] = value;
        let codes = panel.codes(&bytes).expect("a full frame");
        let lit = codes.values.iter().position(|&code| code != 0);
        let index = u32::try_from(lit.expect("one pixel")).expect("few pixels");
        (index % panel.width, index / panel.width)
    };
    assert_eq!(corner(Panel::SSD1306_128X64, 0, 0x01), (0, 0));
    assert_eq!(corner(Panel::SSD1306_128X64, 127, 0x80), (127, 7));
    assert_eq!(corner(Panel::SSD1306_128X64, 128, 0x01), (0, 8));
    assert_eq!(corner(Panel::SHARP_400X240, 0, 0x80), (0, 0));
    assert_eq!(corner(Panel::SHARP_400X240, 11_999, 0x01), (399, 239));
    assert_eq!(corner(Panel::SSD1322_256X64, 0, 0xf0), (0, 0));
    assert_eq!(corner(Panel::SSD1322_256X64, 128, 0x0f), (1, 1));
    assert_eq!(corner(Panel::SSD0323_128X64, 64, 0xf0), (0, 1));
}

#[test]
fn a_frame_of_the_wrong_length_is_named() {
    let error = Panel::SSD1306_128X64.codes(&[0; 1000]).expect_err("24 bytes are missing");
    assert_eq!(error.to_string(), "expected 1024 bytes, found 1000");
    assert!(Panel::SSD1306_128X64.codes(&[0; 1025]).is_err());
}
