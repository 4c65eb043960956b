//! What windows look like: for each grain a picture, and the details of one window.

use aquatint::{
    Changed, Code, Columns, Dirty, Frame, Grain, Pages, Planes, Rect, Rows, Target, display::layout::Layout,
};
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::Point,
    pixelcolor::{BinaryColor, Gray2, Gray4, Gray8},
};

use crate::reference::{places, size_i32, size_u32};

/// Draws the `#`, and shows the pixels of the first window as `a`, of the second as `b` …
fn windows<C: Code, L: Layout<C>>(picture: &[&str], grain: Grain) -> Vec<String> {
    let (width, height) = (size_u32(picture[0].len()), size_u32(picture.len()));
    let bytes = Frame::<C, L, ()>::bytes_needed(width, height);
    let mut frame = Frame::<C, L, _>::new(vec![0; bytes], width, height).expect("enough");
    let mut dirty = Dirty::new([Changed::NOTHING; 40]);
    let points = (0..).zip(picture).flat_map(|(y, line)| line.match_indices('#').map(move |(x, _)| (x, y)));
    let pixels = points.map(|(x, y)| Pixel(Point::new(size_i32(x), y), C::from_code(0xFF)));
    let Ok(()) = dirty.track(&mut frame).draw_iter(pixels);

    let mut shown = vec![vec!['.'; picture[0].len()]; picture.len()];
    for (window, letter) in dirty.windows(&frame, grain).zip('a'..='z') {
        for (x, y) in places(window.area()) {
            shown[usize::try_from(y).expect("inside")][usize::try_from(x).expect("inside")] = letter;
        }
    }
    shown.into_iter().map(String::from_iter).collect()
}

#[test]
fn e_paper_has_bytes_of_eight_columns() {
    let picture = [
        "....................",
        "..........#.........",
        "........#....#......",
        "....................",
        "..................#.",
    ];
    let expected = [
        "....................",
        "........aaaaaaaa....",
        "........aaaaaaaa....",
        "....................",
        "................bbbb",
    ];
    assert_eq!(windows::<BinaryColor, Rows>(&picture, Grain { overhead: 1, ..Grain::SSD1680 }), expected);
    // To open a window takes 14 bytes: as much as all of these.
    let together = [".".repeat(20), "........aaaaaaaaaaaa".into()];
    let together = [0, 1, 1, 1, 1].map(|row: usize| together[row].clone());
    assert_eq!(windows::<BinaryColor, Rows>(&picture, Grain::SSD1680), together);
}

#[test]
fn an_oled_of_one_bit_has_pages() {
    let picture = [
        "............",
        "............",
        "............",
        "............",
        "............",
        "............",
        "............",
        "...#........",
        "............",
        ".......#....",
    ];
    let [upper, lower] = ["...a........", ".......b...."];
    let expected = [upper, upper, upper, upper, upper, upper, upper, upper, lower, lower];
    assert_eq!(windows::<BinaryColor, Pages>(&picture, Grain { overhead: 7, ..Grain::SSD1306 }), expected);
    // Five bytes in two pages, for two bytes in two windows.
    assert_eq!(windows::<BinaryColor, Pages>(&picture, Grain { overhead: 8, ..Grain::SSD1306 }), ["...aaaaa...."; 10]);
}

#[test]
fn a_grey_oled_has_words_of_four_columns() {
    let picture = ["..........", ".....#....", "..........", "...#....#."];
    let expected = ["..........", "....aaaa..", "..........", "bbbbbbbbbb"];
    assert_eq!(windows::<Gray4, Rows>(&picture, Grain { overhead: 7, ..Grain::SSD1322 }), expected);
}

#[test]
fn an_st7920_has_words_of_sixteen_columns() {
    let picture = [
        "........................................",
        "................#.......................",
        ".................................#......",
    ];
    let expected = [
        "........................................",
        "................aaaaaaaaaaaaaaaa........",
        "................................bbbbbbbb",
    ];
    assert_eq!(windows::<BinaryColor, Rows>(&picture, Grain::ST7920), expected);
}

#[test]
fn an_st7306_has_tiles_of_twelve_by_two() {
    let picture = [
        "..............................",
        ".............#................",
        "..............................",
        "..............................",
        ".........................#....",
    ];
    let tiles = [
        "............aaaaaaaaaaaa......",
        "............aaaaaaaaaaaa......",
        "..............................",
        "..............................",
        "........................bbbbbb",
    ];
    assert_eq!(windows::<Gray8, Rows>(&picture, Grain { overhead: 0, ..Grain::ST7306 }), tiles);
    // Bytes of eight columns: two tiles are three of them.
    let pairs = [
        "aaaaaaaaaaaaaaaaaaaaaaaa......",
        "aaaaaaaaaaaaaaaaaaaaaaaa......",
        "..............................",
        "..............................",
        "........................bbbbbb",
    ];
    assert_eq!(windows::<BinaryColor, Rows>(&picture, Grain { overhead: 0, ..Grain::ST7306 }), pairs);
}

#[test]
fn a_memory_lcd_has_rows() {
    let picture = ["..........", ".....#....", "#.........", "..........", ".........#"];
    let expected = ["..........", "aaaaaaaaaa", "aaaaaaaaaa", "..........", "bbbbbbbbbb"];
    assert_eq!(windows::<BinaryColor, Rows>(&picture, Grain::SHARP), expected);
}

#[test]
fn lines_may_run_down() {
    let picture = [".#..........", "............", "........#...", "............", "............"];
    assert_eq!(windows::<BinaryColor, Columns>(&picture, Grain::BYTES), [".a......b..."; 5]);
    let words = Grain { columns: 4, ..Grain::BYTES };
    assert_eq!(windows::<BinaryColor, Columns>(&picture, words), ["aaaa....bbbb"; 5]);
    let all = Grain { columns: u32::MAX, ..Grain::BYTES };
    assert_eq!(windows::<BinaryColor, Columns>(&picture, all), ["aaaaaaaaaaaa"; 5]);
}

#[test]
fn planes_share_a_window() {
    let mut frame = Frame::<Gray2, Planes, _>::with_array([0; 2 * 2 * 3], 10, 3).expect("enough");
    let mut dirty = Dirty::new([Changed::NOTHING; 3]);
    // One has a bit in the low plane, one in the high plane.
    let pixels = [(3, 1, 0b01), (9, 2, 0b10)].map(|(x, y, code)| Pixel(Point::new(x, y), Gray2::new(code)));
    let Ok(()) = dirty.track(&mut frame).draw_iter(pixels);
    let [window] = &dirty.windows(&frame, Grain::SSD1680).collect::<Vec<_>>()[..] else { panic!("one") };
    assert_eq!(window.area(), Rect::new(0, 1, 10, 3));
    let (low, high) = (window.clone().plane(0), window.clone().plane(1));
    assert_eq!(low.contiguous(), Some(&[0b0001_0000, 0, 0, 0][..]));
    assert_eq!(high.contiguous(), Some(&[0, 0, 0, 0b0100_0000][..]));
    assert_eq!((window.contiguous(), window.byte_len()), (None, 8));
    assert_eq!(
        window.slices().collect::<Vec<_>>().concat(),
        [low.contiguous(), high.contiguous()].map(Option::unwrap).concat()
    );
    for plane in [2, usize::MAX] {
        let none = window.clone().plane(plane);
        assert_eq!((none.slices().count(), none.byte_len(), none.contiguous()), (0, 0, None));
        assert_eq!(none.plane(usize::MAX).copy_to(&mut []), Ok(&[][..]));
    }
}

#[test]
fn a_dirty_list_may_be_a_constant_and_starts_with_what_it_says() {
    const CLEAN: Dirty<[Changed; 2]> = Dirty::new([Changed::NOTHING; 2]);
    static UNSENT: Dirty<[Changed; 2]> = Dirty::new([Changed::EVERYTHING; 2]);
    let frame = Frame::<BinaryColor, Rows, _>::with_array([0; 6], 20, 2).expect("enough");
    assert!(CLEAN.is_clean() && CLEAN.windows(&frame, Grain::BYTES).next().is_none());
    let all: Vec<_> = UNSENT.windows(&frame, Grain::BYTES).map(|window| window.contiguous()).collect();
    assert!(!UNSENT.is_clean() && all == [Some(frame.bytes())]);
}

#[test]
fn colours_that_end_are_not_asked_again() {
    /// Gives a colour at every second call.
    struct Gaps(bool);
    impl Iterator for Gaps {
        type Item = Option<Gray8>;

        fn next(&mut self) -> Option<Option<Gray8>> {
            self.0 = !self.0;
            self.0.then_some(Some(Gray8::new(9)))
        }
    }
    let mut frame = Frame::<Gray8, Rows, _>::new(vec![0; 400], 400, 1).expect("enough");
    let mut dirty = Dirty::new([Changed::NOTHING; 1]);
    let Ok(()) = dirty.track(&mut frame).write_run(0, 0..400, Gaps(false));
    assert_eq!((dirty.entries()[0].bytes(400), &frame.bytes()[..2]), (0..1, &[9, 0][..]));
}
