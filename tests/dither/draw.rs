//! Drawings of embedded-graphics and areas of light: the same pixels however they are drawn, on every layout.

use core::fmt::Debug;

use aquatint::{
    BAYER_4X4, BAYER_8X8, BLUE_NOISE_16, Code, Columns, Dithered, FrameRateControl, IntoLight, Inverted, Levels, Light,
    LsbFirst, MsbFirst, OnDrawTarget, Pages, Planes, R2Noise, Rect, Rgb332, Rows, Shade, Target, Window,
    display::{
        dither::{Mask, Method},
        halftone::DOTS_6X6,
        layout::Layout,
    },
};
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point, Size},
    mono_font::{MonoTextStyle, ascii::FONT_6X10},
    pixelcolor::{BinaryColor, Gray2, Gray4, Gray8, Rgb565, Rgb888, RgbColor, WebColors},
    prelude::{Drawable, Primitive},
    primitives::{Circle, PrimitiveStyleBuilder, Rectangle},
    text::Text,
};
use proptest::prelude::*;

use crate::{
    even_levels,
    reference::{Packing, Reference, conform, places},
};

const SIZE: (u32, u32) = (29, 19);

/// The code of a light at a place, by the rule: exact, in 64 bits.
fn shown(levels: &[u16], light: Light, threshold: u16) -> u8 {
    let brighter = levels.partition_point(|&level| level <= light.0).clamp(1, levels.len() - 1);
    let (dark, bright) = (u64::from(levels[brighter - 1]), u64::from(levels[brighter]));
    // t > threshold / 65536, where the threshold is rounded down and lights are whole.
    let switch = dark + (bright - dark) * u64::from(threshold) / 65_536;
    u8::try_from(brighter - 1).unwrap() + u8::from(u64::from(light.0) > switch)
}

fn expected<C: Code>(mask: &impl Mask, light: impl Fn(i32, i32) -> Option<Light>) -> Reference<C> {
    let (levels, mut reference) = (even_levels::<C>(), Reference::new(SIZE.0, SIZE.1));
    reference.draw(|x, y| light(x, y).map(|light| C::from_code(shown(&levels, light, mask.threshold(x, y)))));
    reference
}

/// A colour for each pixel.
fn color(x: i32, y: i32) -> Rgb888 {
    let [red, green, blue, _] = (x * 0x07_1B_3D + y * 0x1D_0B_05).to_le_bytes();
    Rgb888::new(red, green, blue)
}

fn pixels(area: Rect) -> impl Iterator<Item = Pixel<Rgb888>> {
    places(area).map(|(x, y)| Pixel(Point::new(x, y), color(x, y)))
}

/// Pixel by pixel, backwards; as an area; in solid pixels.
fn draw_colours<C: Code + Debug, L: Layout<C>>(packing: Packing, mask: &impl Mask, area: Rect) {
    let inside = |x, y| area.contains(Point::new(x, y)).then(|| color(x, y).into_light());
    let (expected, levels) = (expected::<C>(mask, inside), even_levels::<C>());
    let levels = Levels::new(&levels).unwrap();
    conform::<C, L>(packing, &expected, |frame| {
        let mut display = Dithered::new(frame, levels).with_method(mask).into_draw_target::<Rgb888>();
        let pixels: Vec<_> = pixels(area).collect();
        let Ok(()) = display.draw_iter(pixels.into_iter().rev());
    });
    conform::<C, L>(packing, &expected, |frame| {
        let mut display = Dithered::new(frame, levels).with_method(mask).into_draw_target::<Rgb888>();
        let Ok(()) = display.fill_contiguous(&area.into(), pixels(area).map(|Pixel(_, color)| color));
    });
    conform::<C, L>(packing, &expected, |frame| {
        let mut display = Dithered::new(frame, levels).with_method(mask).into_draw_target::<Rgb888>();
        for Pixel(at, color) in pixels(area) {
            let Ok(()) = display.fill_solid(&Rectangle::new(at, Size::new(1, 1)), color);
        }
    });
}

/// An area of one light, by every verb.
fn fill_light<C: Code + Debug, L: Layout<C>>(packing: Packing, mask: &impl Mask, (area, grey): (Rect, u8)) {
    let light = Light::from_srgb(grey);
    let (expected, levels) =
        (expected::<C>(mask, |x, y| area.contains(Point::new(x, y)).then_some(light)), even_levels::<C>());
    let levels = Levels::new(&levels).unwrap();
    conform::<C, L>(packing, &expected, |frame| {
        let Ok(()) = Dithered::new(frame, levels).with_method(mask).fill_area(area, light);
    });
    conform::<C, L>(packing, &expected, |frame| {
        let mut dithered = Dithered::new(frame, levels).with_method(mask);
        for row in area.intersection(Rect::new(-50, -50, 99, 99)).rows() {
            let Ok(()) = dithered.fill_run(row, area.columns(), [light]);
        }
    });
    conform::<C, L>(packing, &expected, |frame| {
        let (mut dithered, mut shade) = (Dithered::new(frame, levels).with_method(mask), Shade::new(light));
        for row in area.intersection(Rect::new(-50, -50, 99, 99)).rows() {
            let Ok(()) = dithered.fill_shade(row, area.columns(), &mut shade);
        }
    });
    conform::<C, L>(packing, &expected, |frame| {
        let mut display = Dithered::new(frame, levels).with_method(mask).into_draw_target::<Gray8>();
        let Ok(()) = display.fill_solid(&area.into(), Gray8::new(grey));
    });
    conform::<C, L>(packing, &expected, |frame| {
        let mut on_target = OnDrawTarget::new(frame);
        let mut display = Dithered::new(&mut on_target, levels).with_method(mask).into_draw_target::<Gray8>();
        let Ok(()) = display.fill_solid(&area.into(), Gray8::new(grey));
    });
}

/// A tile of codes on a frame, on a window of one, and lent.
fn fill_tile<C: Code + Debug, L: Layout<C>>(packing: Packing, tile: &[[u8; 8]; 8], (area, by): (Rect, Point)) {
    let tile = tile.map(|row| row.map(C::from_code));
    let of = |x: i32, y: i32| tile[usize::try_from(y & 7).unwrap()][usize::try_from(x & 7).unwrap()];
    let draw = |moved: Point| {
        let mut expected = Reference::<C>::new(SIZE.0, SIZE.1);
        expected.draw(|x, y| {
            let (x, y) = (x - moved.x, y - moved.y);
            area.contains(Point::new(x, y)).then(|| of(x, y))
        });
        expected
    };
    conform::<C, L>(packing, &draw(Point::zero()), |frame| {
        let Ok(()) = frame.fill_tile(area, &tile);
    });
    conform::<C, L>(packing, &draw(Point::zero()), |frame| {
        let Ok(()) = OnDrawTarget::new(frame).fill_tile(area, &tile);
    });
    conform::<C, L>(packing, &draw(by), |frame| {
        let part = Rect::new(by.x, by.y, by.x + 99, by.y + 99);
        let Ok(()) = Window::part(frame, part).fill_tile(area.intersection(Rect::new(0, 0, 99, 99)), &tile);
    });
}

fn areas() -> impl Strategy<Value = Rect> {
    let side = || prop_oneof![9 => -5..35_i32, 1 => Just(i32::MIN), 1 => Just(i32::MAX)];
    (side(), side(), side(), side()).prop_map(|(left, top, right, bottom)| Rect::new(left, top, right, bottom))
}

fn small_areas() -> impl Strategy<Value = Rect> {
    (-5..30_i32, -5..20_i32, 0..30_i32, 0..20_i32)
        .prop_map(|(x, y, width, height)| Rect::new(x, y, x + width, y + height))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn colours_are_dithered_in_place(area in small_areas()) {
        on_every_layout!(draw_colours(&BAYER_8X8, area));
        draw_colours::<BinaryColor, Pages>(Packing::Pages, &DOTS_6X6, area);
        draw_colours::<Gray4, Rows>(Packing::Rows, &R2Noise, area);
    }

    #[test]
    fn areas_of_one_light_are_the_same_by_every_verb(area in areas(), grey: u8, number: u32) {
        on_every_layout!(fill_light(&BAYER_4X4, (area, grey)));
        let frame = FrameRateControl::new(3, number).unwrap();
        fill_light::<BinaryColor, Pages>(Packing::Pages, &frame, (area, grey));
        fill_light::<BinaryColor, Rows>(Packing::Rows, &BLUE_NOISE_16, (area, grey));
        fill_light::<Gray2, Planes>(Packing::Planes, &R2Noise, (area, grey));
    }

    #[test]
    fn tiles_repeat_every_eight_pixels(
        tile: [[u8; 8]; 8], area in areas(), (x, y) in (-9..9_i32, -9..9_i32),
    ) {
        let seen = area.intersection(Rect::new(0, 0, 99, 99));
        on_every_layout!(fill_tile(&tile, (seen, Point::new(x.max(0), y.max(0)))));
    }
}

#[test]
fn hostile_places_draw_nothing_and_do_not_hang() {
    let mut reference = Reference::<BinaryColor>::new(8, 8);
    let mut on_target = OnDrawTarget::new(&mut reference);
    let mut display = Dithered::new(&mut on_target, Levels::ONE_BIT).into_draw_target::<Gray8>();
    let ends = [i32::MIN, i32::MIN + 1, -1, 8, i32::MAX - 1, i32::MAX];
    for (x, y) in ends.into_iter().flat_map(|x| ends.map(|y| (x, y))) {
        let Ok(()) = display.draw_iter([Pixel(Point::new(x, y), Gray8::new(200))]);
        let area = Rectangle::new(Point::new(x, y), Size::new(u32::from(x == 8) * u32::MAX, 3));
        let Ok(()) = display.fill_contiguous(&area, core::iter::repeat_n(Gray8::new(200), 99));
        let Ok(()) = display.fill_solid(&area, Gray8::new(200));
    }
    assert_eq!(display.bounding_box(), Rectangle::new(Point::zero(), Size::new(8, 8)));
    assert!(reference.pixels().iter().all(Option::is_none));
}

#[test]
fn a_run_that_begins_far_away_is_dithered_where_it_is_seen() {
    for method in [Method::Ordered4x4, Method::Nearest] {
        let (mut whole, mut seen) = (Reference::<BinaryColor>::new(40, 1), Reference::<BinaryColor>::new(40, 1));
        let mut on_target = OnDrawTarget::new(&mut whole);
        let lights = [Light(20_000), Light(30_000), Light(40_000)];
        let Ok(()) =
            Dithered::new(&mut on_target, Levels::ONE_BIT).with_method(method).fill_run(0, i32::MIN..i32::MAX, lights);
        let mut on_target = OnDrawTarget::new(&mut seen);
        let run = (0..40).map(|column| Some(lights[column % 3]));
        let Ok(()) = Dithered::new(&mut on_target, Levels::ONE_BIT).with_method(method).write_run(0, 0..40, run);
        assert_eq!(whole.pixels(), seen.pixels());
    }
}

fn drawing<D: DrawTarget<Color = Rgb888>>(display: &mut D, ball: Rgb888) -> Result<(), D::Error> {
    display.clear(Rgb888::CSS_STEEL_BLUE)?;
    let style = PrimitiveStyleBuilder::new().fill_color(ball).stroke_color(Rgb888::WHITE).stroke_width(2).build();
    Circle::new(Point::new(5, 3), 12).into_styled(style).draw(display)?;
    Text::new("grey", Point::new(3, 15), MonoTextStyle::new(&FONT_6X10, Rgb888::YELLOW)).draw(display).map(drop)
}

#[test]
fn a_drawing_in_bands_is_the_drawing() {
    let mut whole = Reference::<BinaryColor>::new(29, 19);
    let mut on_target = OnDrawTarget::new(&mut whole);
    let Ok(()) = drawing(&mut Dithered::new(&mut on_target, Levels::ONE_BIT).into_draw_target(), Rgb888::RED);
    conform::<BinaryColor, Rows>(Packing::Rows, &whole, |frame| {
        for top in (0..19).step_by(5) {
            let mut band = aquatint::Frame::<BinaryColor, Rows, _>::with_array([0; 4 * 5], 29, 5).unwrap();
            let mut window = Window::band(&mut band, top);
            let Ok(()) = drawing(&mut Dithered::new(&mut window, Levels::ONE_BIT).into_draw_target(), Rgb888::RED);
            let shown = places(Rect::new(0, 0, 29, 5));
            let pixels = shown.map(|(x, y)| Pixel(Point::new(x, y + top), pixel(&band, x, y)));
            let Ok(()) = frame.draw_iter(pixels);
        }
    });
}

fn pixel(frame: &impl embedded_graphics::image::GetPixel<Color = BinaryColor>, x: i32, y: i32) -> BinaryColor {
    frame.pixel(Point::new(x, y)).unwrap()
}

#[test]
fn a_change_repaints_nothing_outside_of_itself() {
    fn draw(mask: &impl Mask, ball: Rgb888) -> Vec<Option<BinaryColor>> {
        let mut display = Reference::<BinaryColor>::new(29, 19);
        let mut on_target = OnDrawTarget::new(&mut display);
        let Ok(()) =
            drawing(&mut Dithered::new(&mut on_target, Levels::ONE_BIT).with_method(mask).into_draw_target(), ball);
        display.pixels().to_vec()
    }
    fn check(mask: &impl Mask) {
        let (red, dark) = (draw(mask, Rgb888::RED), draw(mask, Rgb888::CSS_DARK_SLATE_GRAY));
        let inside = Rect::new(5, 3, 17, 15);
        let changed = places(Rect::new(0, 0, 29, 19)).zip(red.iter().zip(&dark)).filter(|(_, (red, dark))| red != dark);
        let changed: Vec<_> = changed.map(|(at, _)| Point::from(at)).collect();
        assert!(!changed.is_empty() && changed.iter().all(|&at| inside.contains(at)), "{changed:?}");
    }
    check(&BAYER_4X4);
    check(&BAYER_8X8);
    check(&BLUE_NOISE_16);
    check(&DOTS_6X6);
    check(&R2Noise);
}

#[test]
fn colours_have_the_light_of_their_luminance() {
    for code in 0..=255 {
        assert_eq!(Gray8::new(code).into_light(), Light::from_srgb(code));
        assert_eq!(Rgb888::new(code, code, code).into_light(), Light::from_srgb(code));
    }
    for code in 0..16 {
        assert_eq!(Gray4::new(code).into_light(), Light::from_srgb(17 * code));
    }
    for code in 0..4 {
        assert_eq!(Gray2::new(code).into_light(), Light::from_srgb(85 * code));
    }
    assert_eq!([BinaryColor::Off, BinaryColor::On].map(IntoLight::into_light), [Light::BLACK, Light::WHITE]);
    for (code, channel) in (0..32_u8).flat_map(|code| (0..64_u8).map(move |channel| (code, channel))) {
        let nearest = |value: u8, most: u32| u8::try_from((u32::from(value) * 510 + most) / (2 * most)).unwrap();
        let expected = [nearest(code, 31), nearest(channel, 63), nearest(31 - code, 31)];
        assert_eq!(Rgb565::new(code, channel, 31 - code).into_light(), Light::from_srgb_colour(expected));
        let small = Rgb332::new(code, channel, code);
        let expected = [nearest(small.r(), 7), nearest(small.g(), 7), nearest(small.b(), 3)];
        assert_eq!(small.into_light(), Light::from_srgb_colour(expected));
    }
}
