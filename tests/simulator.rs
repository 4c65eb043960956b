//! What the crate packs is what the simulator, which shares no code with it, takes apart and shows.

use core::{convert::Infallible, fmt::Debug};
use std::{fs::File, io::BufReader, path::Path};

use aquatint::{
    Code, Dithered, FillStyle, Frame, Levels, Light, Line, Pages, Point2, Polygon, Rows, Rule, StrokeStyle, Target,
    display::layout::Layout,
};
use aquatint_simulator::{Panel, Picture, Response, Theme, Zoom, save_png};
use embedded_graphics::{
    Drawable,
    draw_target::DrawTarget,
    geometry::Point,
    image::GetPixel,
    mono_font::{MonoTextStyle, ascii::FONT_6X10},
    pixelcolor::{BinaryColor, Gray4},
    primitives::Primitive,
    text::Text,
};

const ZOOM: Zoom = Zoom { scale: 3, gap: 1 };

#[test]
fn an_ssd1306_shows_the_picture() {
    show::<BinaryColor, Pages>(Panel::SSD1306_128X64, dark_or_light);
}

#[test]
fn a_panel_that_ends_inside_of_a_page_shows_the_picture() {
    show::<BinaryColor, Pages>(Panel { width: 101, height: 43, ..Panel::SSD1306_128X64 }, dark_or_light);
}

#[test]
fn a_memory_lcd_shows_the_picture() {
    show::<BinaryColor, Rows>(Panel::SHARP_400X240, dark_or_light);
}

#[test]
fn an_e_paper_with_padded_rows_shows_the_picture() {
    let panel = Panel { width: 122, height: 250, ..Panel::SHARP_400X240 };
    show::<BinaryColor, Rows>(panel.with_theme(Theme::E_PAPER), dark_or_light);
}

#[test]
fn an_ssd0323_shows_codes_as_srgb_greys() {
    show::<Gray4, Rows>(Panel::SSD0323_128X64.with_theme(BLACK_AND_WHITE), |_, code| [code * 17; 3]);
}

#[test]
fn an_ssd1322_shows_codes_as_equal_steps_of_light() {
    show::<Gray4, Rows>(Panel::SSD1322_256X64.with_theme(BLACK_AND_WHITE), |_, code| {
        [SRGB_OF_FIFTEENTHS[usize::from(code)]; 3]
    });
}

#[test]
fn the_presets_have_the_packings_that_are_tested_here() {
    let facts = |panel: Panel| (panel.width, panel.height, panel.bits, panel.response);
    assert_eq!(facts(Panel::SSD1306_128X64), (128, 64, 1, Response::LinearLight));
    assert_eq!(facts(Panel::SHARP_400X240), (400, 240, 1, Response::LinearLight));
    assert_eq!(facts(Panel::SSD1322_256X64), (256, 64, 4, Response::LinearLight));
    assert_eq!(facts(Panel::SSD0323_128X64), (128, 64, 4, Response::Srgb));
}

const BLACK_AND_WHITE: Theme = Theme { name: "black and white", dark: [0; 3], light: [255; 3], gap: [1, 2, 3] };

/// sRGB codes of n/15 of the light, by the curve of IEC 61966-2-1.
const SRGB_OF_FIFTEENTHS: [u8; 16] = [0, 73, 102, 124, 141, 156, 170, 182, 193, 203, 213, 222, 231, 239, 247, 255];

fn dark_or_light(panel: &Panel, code: u8) -> [u8; 3] {
    if code == 0 { panel.theme.dark } else { panel.theme.light }
}

/// Draws, and follows every pixel through the bytes into a file and back.
fn show<C: Code + Debug, L: Layout<C>>(panel: Panel, expected: fn(&Panel, u8) -> [u8; 3]) {
    let mut memory = vec![0; panel.byte_len()];
    let mut frame = Frame::<C, L, _>::new(&mut memory[..], panel.width, panel.height).expect("as long as the panel's");
    let Ok(()) = draw(&mut frame);
    let codes = panel.codes(frame.bytes()).expect("as long as the panel's");
    assert!((0..codes.levels).all(|code| codes.values.iter().any(|&value| u16::from(value) == code)));
    let file = saved(&panel.render(frame.bytes(), ZOOM).expect("as long as the panel's"));
    assert_eq!((file.width(), file.height()), (panel.width * ZOOM.scale, panel.height * ZOOM.scale));
    for (x, y) in (0..panel.height).flat_map(|y| (0..panel.width).map(move |x| (x, y))) {
        let code = frame.pixel(Point::new(x.cast_signed(), y.cast_signed())).map(Code::code);
        assert_eq!(codes.get(x, y), code, "{x}, {y}");
        assert_square(&file, (x, y), expected(&panel, code.expect("inside")), panel.theme.gap);
    }
}

/// A pixel of the panel is a square of 2 × 2, with a gap at its right and below.
fn assert_square(picture: &Picture, (x, y): (u32, u32), lit: [u8; 3], gap: [u8; 3]) {
    for (dx, dy) in (0..ZOOM.scale).flat_map(|dy| (0..ZOOM.scale).map(move |dx| (dx, dy))) {
        let color = if dx < 2 && dy < 2 { lit } else { gap };
        assert_eq!(picture.pixel(ZOOM.scale * x + dx, ZOOM.scale * y + dy), Some(color), "{x}, {y}");
    }
}

/// The picture that a file of it holds.
fn saved(picture: &Picture) -> Picture {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("panel.png");
    save_png(picture, &path).expect("written");
    read(&path)
}

fn read(path: &Path) -> Picture {
    let mut decoder = png::Decoder::new(BufReader::new(File::open(path).expect("a file")));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().expect("a PNG file");
    let mut rgb = vec![0; reader.output_buffer_size().expect("small")];
    let info = reader.next_frame(&mut rgb).expect("a whole PNG file");
    assert_eq!((info.color_type, info.bit_depth), (png::ColorType::Rgb, png::BitDepth::Eight));
    Picture::from_rgb(info.width, info.height, rgb).expect("three bytes a pixel")
}

/// A ramp of light, a star that crosses itself, a line from corner to corner and letters.
fn draw<C: Code, L: Layout<C>>(frame: &mut Frame<C, L, &mut [u8]>) -> Result<(), Infallible> {
    let (dark, bright) = (C::from_code(0), C::from_code(u8::MAX));
    let bounds = frame.bounds();
    frame.clear(dark)?;
    ramp(frame)?;
    let star = [(30, 1), (43, 41), (9, 16), (51, 16), (17, 41)].map(|(x, y)| Point2::corner(x, y));
    let star = [&star[..]];
    let filled = FillStyle::new(bright).with_rule(Rule::EvenOdd);
    Polygon::new(&star).expect("in range").into_styled(filled).draw(frame)?;
    let corner = Point::new(bounds.right - 1, bounds.bottom - 1);
    Line::new(Point::zero(), corner).into_styled(StrokeStyle::new(dark)).draw(frame)?;
    Text::new("Ag,%", Point::new(60, 20), MonoTextStyle::new(&FONT_6X10, bright)).draw(frame)?;
    Ok(())
}

/// From black at the left to white at the right.
fn ramp<C: Code, L: Layout<C>>(frame: &mut Frame<C, L, &mut [u8]>) -> Result<(), Infallible> {
    let levels = if C::BITS == 1 { Levels::ONE_BIT } else { Levels::LINEAR_16 };
    let (bounds, mut light) = (frame.bounds(), Dithered::new(frame, levels));
    let last = bounds.width() - 1;
    let lights = (0..=last).map(|x| Light(u16::try_from(x * 65_535 / last).expect("at most white")));
    bounds.rows().try_for_each(|row| light.write_run(row, bounds.columns(), lights.clone().map(Some)))
}
