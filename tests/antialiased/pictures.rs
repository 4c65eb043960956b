//! One scene, looked at once; on every target; and pixel by pixel against real numbers.

use aquatint::{
    Alpha, Blend, BlendMode, Blended, Code, Columns, Coverage, Covered, Dithered, Frame, Levels, Light, LsbFirst,
    OnBackground, Pages, PerPixel, Planes, Rect, Rows, SpanFn, Target, Window, display::dither::Method,
    display::layout::Layout,
};
use embedded_graphics::{
    framebuffer::{Framebuffer, buffer_size},
    image::GetPixel,
    pixelcolor::{
        BinaryColor, Gray2, Gray4, GrayColor,
        raw::{LittleEndian, RawU1, RawU2, RawU4},
    },
    prelude::*,
};

use super::{DRAWINGS, Record, SIZE, cover, draw, draw_all, draw_ramp, light, points, ramped};

fn frame<C: Code, L: Layout<C>>(height: u32) -> Frame<C, L, Vec<u8>> {
    let bytes = vec![0; Frame::<C, L, ()>::bytes_needed(SIZE.width, height)];
    Frame::new(bytes, SIZE.width, height).expect("memory enough")
}

fn gray4(code: u8) -> Gray4 {
    Gray4::new(code / 17)
}

fn gray2(code: u8) -> Gray2 {
    Gray2::new(code / 85)
}

fn binary(code: u8) -> BinaryColor {
    BinaryColor::from(code >= 128)
}

/// A hexadecimal digit a pixel, a point for black.
fn picture<C: Code>(target: &impl GetPixel<Color = C>) -> String {
    let sign = |point| match target.pixel(point).map_or(0, Code::code) {
        0 => '.',
        code => char::from_digit(code.into(), 16).expect("four bits"),
    };
    let width = SIZE.width as usize;
    let signs: Vec<char> = points(SIZE).map(sign).collect();
    signs.chunks(width).map(|row| row.iter().collect::<String>() + "\n").collect()
}

fn on_frame<C: Code + Blend, L: Layout<C>>(shade: impl Fn(u8) -> C + Copy) -> String {
    let mut frame = frame::<C, L>(SIZE.height);
    draw_all(shade, &mut frame);
    picture(&frame)
}

/// The scene on bands of so many rows.
fn on_bands<C: Code + Blend, L: Layout<C>>(shade: impl Fn(u8) -> C + Copy, height: u32) -> String {
    let mut whole = frame::<C, Rows>(SIZE.height);
    for top in (0..SIZE.height.cast_signed()).step_by(height as usize) {
        let mut frame = frame::<C, L>(height);
        let mut band = Window::band(&mut frame, top);
        draw_all(shade, &mut band);
        for row in top..(top + height.cast_signed()).min(SIZE.height.cast_signed()) {
            let Ok(()) = whole.write_run(row, 0..64, (0..64).map(|x| band.pixel(Point::new(x, row))));
        }
    }
    picture(&whole)
}

#[test]
fn the_scene_at_four_bits() {
    let ours = on_frame::<Gray4, Rows>(gray4);
    assert_eq!(ours, include_str!("../pictures/antialiased_4bit.txt"), "\n{ours}");
    assert_eq!(on_frame::<Gray4, Rows<LsbFirst>>(gray4), ours);
    let mut others = Framebuffer::<Gray4, RawU4, LittleEndian, 64, 40, { buffer_size::<Gray4>(64, 40) }>::new();
    draw_all(gray4, &mut PerPixel::new(&mut others));
    assert_eq!(picture(&others), ours);
    for height in [1, 3, 8, 39] {
        assert_eq!(on_bands::<Gray4, Rows>(gray4, height), ours, "bands of {height}");
    }
}

#[test]
fn the_scene_at_two_bits() {
    let ours = on_frame::<Gray2, Rows>(gray2);
    assert_eq!(ours, include_str!("../pictures/antialiased_2bit.txt"), "\n{ours}");
    assert_eq!(on_frame::<Gray2, Planes>(gray2), ours);
    let mut others = Framebuffer::<Gray2, RawU2, LittleEndian, 64, 40, { buffer_size::<Gray2>(64, 40) }>::new();
    draw_all(gray2, &mut PerPixel::new(&mut others));
    assert_eq!(picture(&others), ours);
    for height in [1, 5, 16] {
        assert_eq!(on_bands::<Gray2, Planes>(gray2, height), ours, "bands of {height}");
    }
}

#[test]
fn the_scene_at_one_bit() {
    let ours = on_frame::<BinaryColor, Rows>(binary);
    assert_eq!(ours, include_str!("../pictures/antialiased_1bit.txt"), "\n{ours}");
    assert_eq!(on_frame::<BinaryColor, Pages>(binary), ours);
    assert_eq!(on_frame::<BinaryColor, Columns>(binary), ours);
    let mut others =
        Framebuffer::<BinaryColor, RawU1, LittleEndian, 64, 40, { buffer_size::<BinaryColor>(64, 40) }>::new();
    draw_all(binary, &mut PerPixel::new(&mut others));
    assert_eq!(picture(&others), ours);
    for height in [1, 8, 11] {
        assert_eq!(on_bands::<BinaryColor, Pages>(binary, height), ours, "bands of {height}");
    }
}

/// The greatest error in light of greys that were mixed, beyond that of the best grey there is.
fn excess<C: Code + Blend + GrayColor>(before: &[C], drawn: &[Option<Alpha<C>>], after: &[C]) -> f64 {
    let most = C::WHITE.luma();
    let light = |color: C| light::of_srgb(f64::from(color.luma()) / f64::from(most));
    let mut worst = 0.0_f64;
    for ((before, drawn), after) in before.iter().zip(drawn).zip(after) {
        let Some(Alpha { color, coverage }) = *drawn else {
            assert!(before == after);
            continue;
        };
        let exact = light::mixed(BlendMode::Over, light(color), light(*before), f64::from(coverage.parts()) / 32_768.0);
        let best = (0..=most).map(|code| (light(C::from_code(code)) - exact).abs()).fold(f64::INFINITY, f64::min);
        worst = worst.max((light(*after) - exact).abs() - best);
    }
    worst
}

/// Draws the scene step by step and compares each with what it says it draws.
fn check_steps<C: Code + Blend + GrayColor>(shade: impl Fn(u8) -> C + Copy) {
    let mut frame = frame::<C, Rows>(SIZE.height);
    let codes =
        |frame: &Frame<C, Rows, Vec<u8>>| points(SIZE).filter_map(|point| frame.pixel(point)).collect::<Vec<_>>();
    for which in 0..DRAWINGS {
        let before = codes(&frame);
        let mut record = Record::new(SIZE);
        let Ok(()) = draw(which, shade, &mut record);
        let Ok(()) = draw(which, shade, &mut Blended::new(&mut frame));
        let drawn: Vec<_> = points(SIZE).map(|point| record.at(point)).collect();
        // The rectangle has an inside and a border, one upon the other.
        if record.pixels.iter().all(|(_, times)| *times < 2) {
            let worst = excess(&before, &drawn, &codes(&frame));
            assert!(worst <= 2.0 / 65_535.0, "{which}: {worst}");
        } else {
            assert_eq!(which, 2);
        }
    }
    let before = codes(&frame);
    let mut drawn = vec![None; before.len()];
    cover(
        &ramped(),
        &mut SpanFn::new(Rect::of_size(SIZE), |row: i32, columns: core::ops::Range<i32>, covered: Covered<'_>| {
            for (offset, column) in columns.enumerate() {
                // The ramp has its number at the centre of each pixel.
                let number = (2 * i64::from(column) + 1 - 100) * 65_536 / 26;
                let color = shade(u16::try_from(number.clamp(0, 65_535)).expect("clamped").to_be_bytes()[0]);
                drawn[row as usize * 64 + column as usize] = Some(Alpha::new(color, covered.at(offset)));
            }
        }),
    );
    draw_ramp(shade, &mut frame);
    let worst = excess(&before, &drawn, &codes(&frame));
    assert!(worst <= 2.0 / 65_535.0, "the ramp: {worst}");
}

#[test]
fn every_pixel_is_the_nearest_grey_to_the_light_it_should_have() {
    check_steps(gray4);
    check_steps(gray2);
}

#[test]
fn one_bit_is_half_of_the_light_or_dithered() {
    // Drawn in light, shown by the nearer of two levels: as blended in black and white.
    let mut nearest = frame::<BinaryColor, Rows>(SIZE.height);
    let mut dithered = frame::<BinaryColor, Rows>(SIZE.height);
    let mut records = vec![];
    let shade = |code| if code >= 128 { Light::WHITE } else { Light::BLACK };
    for which in 0..DRAWINGS {
        let Ok(()) = draw(
            which,
            shade,
            &mut Blended::new(&mut Dithered::new(&mut nearest, Levels::ONE_BIT).with_method(Method::Nearest)),
        );
        let mut record = Record::new(SIZE);
        let Ok(()) = draw(which, shade, &mut record);
        let before: Vec<_> = points(SIZE).map(|point| dithered.pixel(point)).collect();
        let Ok(()) = draw(which, shade, &mut Blended::new(&mut Dithered::new(&mut dithered, Levels::ONE_BIT)));
        records.push(record);
        // White that is covered by so much on black is on above the threshold of the pixel.
        for (point, before) in points(SIZE).zip(before).filter(|_| which != 2) {
            let Some(Alpha { color, coverage }) = records[which].at(point) else {
                assert_eq!(dithered.pixel(point), before);
                continue;
            };
            let under = if before == Some(BinaryColor::On) { 1.0 } else { 0.0 };
            let light =
                light::mixed(BlendMode::Over, light::of_light(color), under, f64::from(coverage.parts()) / 32_768.0);
            let rank = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]][point.y as usize % 4]
                [point.x as usize % 4];
            let threshold = (f64::from(rank) + 0.5) / 16.0;
            if (light - threshold).abs() > 0.0001 && coverage != Coverage::NONE {
                assert_eq!(
                    dithered.pixel(point),
                    Some(BinaryColor::from(light > threshold)),
                    "{which} {point:?} {light}"
                );
            }
        }
    }
    let mut binary_only = frame::<BinaryColor, Rows>(SIZE.height);
    for which in 0..DRAWINGS {
        let Ok(()) = draw(which, binary, &mut Blended::new(&mut binary_only));
    }
    assert_eq!(picture(&nearest), picture(&binary_only));
}

#[test]
fn on_a_background_is_on_a_frame_of_that_colour() {
    for background in [0, 5, 15].map(Gray4::new) {
        for which in 0..DRAWINGS {
            let (mut blended, mut written) = (frame::<Gray4, Rows>(SIZE.height), frame::<Gray4, Rows>(SIZE.height));
            let Ok(()) = blended.clear(background);
            let Ok(()) = written.clear(background);
            let Ok(()) = draw(which, gray4, &mut Blended::new(&mut blended));
            let Ok(()) = draw(which, gray4, &mut OnBackground::new(&mut written, background));
            // What is drawn twice lies on the background twice.
            if which != 2 {
                assert_eq!(picture(&written), picture(&blended), "{which}");
            }
        }
    }
}
