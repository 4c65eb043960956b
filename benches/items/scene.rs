//! The items. Every input goes through `black_box`, so that nothing is computed while compiling.

use core::{convert::Infallible, hint::black_box};

use aquatint::{
    BAYER_4X4, BAYER_8X8, BAYER_16X16, Cap, Code, CodeMask, Dithered, FillStyle, Flood, Frame, Join, Levels, Light,
    Line, Path, Point2, Polyline, Rect, Rows, Segment, Stroke, StrokeStyle, Target,
    display::{
        diffuse::{Diffusion, FloydSteinberg, Kernel, SierraLite},
        layout::Layout,
        transpose::Transpose,
    },
    raster::flood::{Run, words_needed},
};
use embedded_graphics::{
    Drawable, Pixel,
    draw_target::DrawTarget,
    geometry::{Point, Size},
    pixelcolor::{BinaryColor, Gray8, PixelColor},
    primitives::{Primitive, PrimitiveStyle, Rectangle},
};

use super::{
    Item,
    ours::{Ink, Ours, Packed},
    peers::{Polygons, Shapes, draw_image, write_text},
    pictures::{PHOTO_WIDTH, photo},
};

/// What the peers draw too.
pub fn both<'s, S: Shapes>() -> &'s [Item<S>] {
    &[
        ("clear", clear),
        ("rect_fill", rect_fill),
        ("hline", |s| line(s, [(7, 9), (106, 9)])),
        ("vline", |s| line(s, [(13, 2), (13, 61)])),
        ("line45", |s| line(s, [(5, 2), (64, 61)])),
        ("shallow", |s| line(s, [(7, 9), (106, 34)])),
        ("steep", |s| line(s, [(20, 2), (34, 61)])),
        ("tri_fill", tri_fill),
        ("tri_fill_x16", tri_fill_x16),
        ("circle_out", |s| s.circle(black_box(Point::new(44, 12)), black_box(41), on())),
        ("circle_fill", |s| s.disc(black_box(Point::new(44, 12)), black_box(41), on())),
        ("text", text),
        ("blit", blit),
        ("one_frame", one_frame),
    ]
}

/// Polygons, which few of the peers draw.
#[cfg(not(target_os = "none"))]
pub fn polygons<'s, S: Polygons>() -> &'s [Item<S>] {
    &[("tri_fill", tri_fill), ("star_fill", star_fill)]
}

/// The photograph, from codes to bits.
pub fn photographs<'m>() -> &'m [Item<OnRows<'m>>] {
    &[
        ("dither_4x4", |s| by_codes(s, &BY_4X4)),
        ("dither_8x8", |s| by_codes(s, &BY_8X8)),
        ("dither_16x16", |s| by_codes(s, &BY_16X16)),
        ("dither_pixels", by_pixels),
        ("sierra_lite", diffuse::<SierraLite>),
        ("floyd_steinberg", diffuse::<FloydSteinberg>),
    ]
}

/// Strokes and curves, which cost on every panel what they cost on rows.
pub fn outlines<'m>() -> &'m [Item<OnRows<'m>>] {
    &[
        ("thick_line", |s| thick_line(&mut s.target)),
        ("polyline", |s| polyline(&mut s.target)),
        ("path_fill", |s| path_fill(&mut s.target)),
    ]
}

/// What only aquatint draws.
pub fn alone<'m, C: Ink, L: Packed<C>>() -> &'m [Item<OnFrame<'m, C, L>>] {
    &[
        ("star_fill", star_fill),
        ("flood", flood),
        ("dither_photo", dither_photo),
        ("grey_rect", grey_rect),
        // As embedded-graphics does it, on our frames.
        ("text_eg", |s| write_text(&mut s.target, black_box(TEXT), black_box(Point::new(3, 30)), on())),
        ("blit_eg", |s| draw_image(&mut s.target, black_box(Point::new(5, 0)))),
    ]
}

type OnRows<'m> = OnFrame<'m, BinaryColor, Rows>;
type OnFrame<'m, C, L> = Ours<'m, Frame<C, L, &'m mut [u8]>, L>;

fn on<C: PixelColor + From<BinaryColor>>() -> C {
    black_box(BinaryColor::On).into()
}

fn clear<S: Shapes>(surface: &mut S) -> Result<(), S::Error> {
    surface.clear(on())
}

fn rect_fill<S: Shapes>(surface: &mut S) -> Result<(), S::Error> {
    let area = black_box(Rectangle::new(Point::new(3, 5), Size::new(100, 50)));
    area.into_styled(PrimitiveStyle::with_fill(on())).draw(surface)
}

fn line<S: Shapes>(surface: &mut S, ends: [(i32, i32); 2]) -> Result<(), S::Error> {
    surface.line(black_box(ends).map(Point::from), on())
}

pub fn tri_fill<S: Shapes>(surface: &mut S) -> Result<(), S::Error> {
    surface.triangle(black_box([Point::new(12, 4), Point::new(98, 20), Point::new(45, 56)]), on())
}

/// The same sixteen times as large about its middle: all that is seen is inside.
fn tri_fill_x16<S: Shapes>(surface: &mut S) -> Result<(), S::Error> {
    surface.triangle(black_box([Point::new(-573, -326), Point::new(803, -70), Point::new(-45, 506)]), on())
}

/// Twenty characters.
const TEXT: &str = "Aquatint draws fonts";

fn text<S: Shapes>(surface: &mut S) -> Result<(), S::Error> {
    surface.text(black_box(TEXT), black_box(Point::new(3, 30)), on())
}

fn blit<S: Shapes>(surface: &mut S) -> Result<(), S::Error> {
    surface.image(black_box(Point::new(5, 0)))
}

/// A whole picture, for comparison with the same one drawn band by band.
pub fn one_frame<S: Shapes>(surface: &mut S) -> Result<(), S::Error> {
    rect_fill(surface)?;
    line(surface, [(7, 9), (106, 34)])?;
    tri_fill(surface)?;
    text(surface)
}

/// Twelve vertices, area 1172.
const STAR: [(i32, i32); 12] = [
    (94, 31),
    (75, 38),
    (79, 57),
    (64, 44),
    (49, 57),
    (53, 38),
    (34, 31),
    (53, 24),
    (49, 5),
    (64, 18),
    (79, 5),
    (75, 24),
];

pub fn star_fill<S: Polygons>(surface: &mut S) -> Result<(), S::Error> {
    surface.polygon(&black_box(STAR.map(|(x, y)| Point::new(x, y))), on())
}

/// The shallow line, five pixels wide.
fn thick_line<D: DrawTarget<Color: From<BinaryColor>>>(target: &mut D) -> Result<(), D::Error> {
    let [start, end] = black_box([Point::new(7, 9), Point::new(106, 34)]);
    Line::new(start, end).into_styled(StrokeStyle::new(on()).with_width(black_box(5))).draw(target)
}

/// A zigzag of four segments, three pixels wide, with round corners and ends.
fn polyline<D: DrawTarget<Color: From<BinaryColor>>>(target: &mut D) -> Result<(), D::Error> {
    let points = black_box([(8, 50), (32, 12), (60, 52), (84, 10), (118, 40)]).map(|(x, y)| Point2::corner(x, y));
    let stroke = Stroke::new(3).with_join(Join::Round).with_cap(Cap::Round);
    let Ok(polyline) = Polyline::new(&points) else { return Ok(()) };
    polyline.into_styled(StrokeStyle::new(on()).with_stroke(stroke)).draw(target)
}

/// Tip, two control points, top, two control points, and back to the tip.
pub const HEART: [(i32, i32); 6] = [(64, 60), (14, 30), (40, -10), (64, 18), (88, -10), (114, 30)];

/// A heart of two cubic Béziers, 50 pixels high.
fn path_fill<D: DrawTarget<Color: From<BinaryColor>>>(target: &mut D) -> Result<(), D::Error> {
    let [tip, a, b, top, c, d] = black_box(HEART).map(|(x, y)| Point2::corner(x, y));
    let heart = [Segment::MoveTo(tip), Segment::CubicTo(a, b, top), Segment::CubicTo(c, d, tip), Segment::Close];
    let Ok(heart) = Path::new(&heart) else { return Ok(()) };
    heart.into_styled(FillStyle::new(on())).draw(target)
}

/// A U of walls, and the 2061 pixels between them filled from one of its arms.
fn flood<C: Ink, L: Packed<C>>(surface: &mut OnFrame<C, L>) -> Result<(), Infallible> {
    let frame = &mut surface.target;
    for (left, top, width, height, color) in
        [(37, 0, 53, 63, BinaryColor::On), (38, 1, 51, 61, BinaryColor::Off), (53, 0, 21, 51, BinaryColor::On)]
    {
        frame.fill_solid(&Rectangle::new(Point::new(left, top), Size::new(width, height)), color.into())?;
    }
    let (mut memory, mut queue) = ([0; words_needed(400, 240)], [Run::default(); 16]);
    let filled = Flood::new(&mut memory, &mut queue).fill(frame, black_box(Point::new(41, 5)), on());
    // A region that was refused would show as a picture without it.
    black_box(filled.map_or(0, |filled| filled.pixels));
    Ok(())
}

/// The levels of a panel of one or four bits.
fn levels<C: Code>() -> Levels<'static> {
    black_box(if C::BITS == 1 { Levels::ONE_BIT } else { Levels::LINEAR_16 })
}

fn dither_photo<C: Code, L: Layout<C>>(surface: &mut OnFrame<C, L>) -> Result<(), Infallible> {
    let mut dithered = Dithered::new(&mut surface.target, levels::<C>());
    let end = black_box(128);
    for (row, codes) in (0..).zip(photo().chunks_exact(PHOTO_WIDTH)) {
        dithered.write_run(row, 0..end, codes.iter().map(|&code| Some(Light::from_srgb(code))))?;
    }
    Ok(())
}

/// The rectangle of `rect_fill`, in half of the light.
fn grey_rect<C: Code, L: Layout<C>>(surface: &mut OnFrame<C, L>) -> Result<(), Infallible> {
    let mut dithered = Dithered::new(&mut surface.target, levels::<C>());
    dithered.fill_area(black_box(Rect::new(3, 5, 103, 55)), black_box(Light(32_768)))
}

/// The photograph from codes to bits, by masks whose thresholds are codes.
#[expect(clippy::unnecessary_wraps, reason = "an item")]
fn by_codes<const W: usize, const H: usize>(surface: &mut OnRows<'_>, mask: &CodeMask<W, H>) -> Result<(), Infallible> {
    let mask = black_box(mask);
    for (row, codes) in (0..).zip(photo().chunks_exact(PHOTO_WIDTH)) {
        mask.write_rows(&mut surface.target, Point::new(0, row), codes);
    }
    Ok(())
}

/// The photograph by error diffusion.
#[expect(clippy::unnecessary_wraps, reason = "an item")]
fn diffuse<K: Kernel>(surface: &mut OnRows<'_>) -> Result<(), Infallible> {
    let mut memory = [0; 2 * (PHOTO_WIDTH + 4)];
    let Ok(mut diffusion) = Diffusion::<K>::new(&mut memory, black_box(128), Levels::ONE_BIT) else { return Ok(()) };
    for (row, codes) in (0..).zip(photo().chunks_exact(PHOTO_WIDTH)) {
        let lights = codes.iter().map(|&code| Light::from_srgb(code));
        diffusion.draw_packed_row(&mut surface.target, Point::new(0, row), lights);
    }
    Ok(())
}

/// The photograph through `DrawTarget`, pixel by pixel.
fn by_pixels(surface: &mut OnRows<'_>) -> Result<(), Infallible> {
    let mut target = Dithered::new(&mut surface.target, Levels::ONE_BIT).into_draw_target::<Gray8>();
    for (y, codes) in (0..).zip(photo().chunks_exact(PHOTO_WIDTH)) {
        target.draw_iter((0..).zip(codes).map(|(x, &code)| Pixel(Point::new(x, y), Gray8::new(code))))?;
    }
    Ok(())
}

static BY_4X4: CodeMask<4, 4> = CodeMask::srgb(&BAYER_4X4);
static BY_8X8: CodeMask<8, 8> = CodeMask::srgb(&BAYER_8X8);
static BY_16X16: CodeMask<16, 16> = CodeMask::srgb(&BAYER_16X16);

/// 128 × 64 pixels from rows to pages and back.
pub fn transpose<S: Shapes>(surface: &mut S) -> Result<(), S::Error> {
    let (source, mut pages, mut rows) = (photo(), [0; 1024], [0; 1024]);
    let transpose = Transpose::new(black_box(128), black_box(64));
    let forth = transpose.rows_to_pages(source, &mut pages);
    let back = transpose.pages_to_rows(black_box(&pages), &mut rows);
    let is_done = forth.and(back).is_ok() && black_box(&rows).last() == source.get(1023);
    surface.draw_iter([Pixel(Point::zero(), BinaryColor::from(is_done).into())])
}
