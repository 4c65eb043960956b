//! A picture as text.

use std::fmt::Write;

use crate::codes::Codes;
use crate::picture::Picture;

const RESET: &str = "\x1b[0m";

/// The picture in 24-bit ANSI colours, two pixels one above the other in each character cell.
///
/// Colours are set only where they change and put back at the end of each line. The lower half of
/// the last line of a picture with an odd number of rows keeps the terminal's own background.
#[must_use]
pub fn half_blocks(picture: &Picture) -> String {
    let mut text = String::new();
    for top in (0..picture.height()).step_by(2) {
        let mut previous = (None, None);
        for x in 0..picture.width() {
            let upper = picture.pixel(x, top);
            let lower = picture.pixel(x, top + 1);
            if upper != previous.0 {
                set_colour(&mut text, 38, upper);
            }
            if lower != previous.1 {
                set_colour(&mut text, 48, lower);
            }
            text.push('▀');
            previous = (upper, lower);
        }
        text.push_str(RESET);
        text.push('\n');
    }
    text
}

/// `layer` is 38 for the foreground and 48 for the background.
fn set_colour(text: &mut String, layer: u8, colour: Option<[u8; 3]>) {
    if let Some([red, green, blue]) = colour {
        // Writing to a string cannot fail.
        let _ = write!(text, "\x1b[{layer};2;{red};{green};{blue}m");
    }
}

/// The panel in braille, two by four pixels in each character cell, without colours: for plain
/// terminals, pipes and logs.
///
/// Every pixel with a code of at least `threshold` is a dot.
#[must_use]
pub fn braille(codes: &Codes, threshold: u8) -> String {
    let mut text = String::new();
    for top in (0..codes.height).step_by(4) {
        for left in (0..codes.width).step_by(2) {
            text.push(braille_cell(codes, threshold, (left, top)));
        }
        text.push('\n');
    }
    text
}

fn braille_cell(codes: &Codes, threshold: u8, (left, top): (u32, u32)) -> char {
    /// The bits of the dots, from the left and from the top. The lowest two came to braille later.
    const DOTS: [[u32; 2]; 4] = [[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]];
    const NO_DOTS: u32 = 0x2800;

    let mut dots = 0;
    for (y, row) in (top..).zip(DOTS) {
        for (x, dot) in (left..).zip(row) {
            if codes.get(x, y).is_some_and(|code| code >= threshold) {
                dots |= dot;
            }
        }
    }
    char::from_u32(NO_DOTS | dots).unwrap_or(' ')
}
