//! Modes, inks, curves and masks against real numbers and against single pixels.

use std::convert::Infallible;

use aquatint::{
    Alpha, AntialiasedStyle, Blend, BlendMode, Blended, Coverage, CoverageCurve, CoverageMask, Covered, Frame, Ink,
    Light, Outline, Oval, Pattern, Point2, Polygon, Rect, Rows, SpanFn, Stencil, Subpixel, Target, Window, Words,
};
use embedded_graphics::{
    image::GetPixel,
    pixelcolor::{Gray4, Gray8, Rgb565},
    prelude::*,
    primitives::Rectangle,
};
use proptest::{collection::vec, prelude::*, sample::select};

use super::{Record, cover, light, points};

type Picture = Frame<Light, Words, Vec<u8>>;

fn dark(width: u32, height: u32) -> Picture {
    Frame::new(vec![0; Picture::bytes_needed_for(width, height)], width, height).expect("memory enough")
}

/// How many bytes a picture in light has.
trait BytesNeeded {
    fn bytes_needed_for(width: u32, height: u32) -> usize;
}

impl BytesNeeded for Picture {
    fn bytes_needed_for(width: u32, height: u32) -> usize {
        Frame::<Light, Words, ()>::bytes_needed(width, height)
    }
}

/// The covered part of each pixel.
fn coverage(outline: &impl Outline, size: Size) -> Vec<Coverage> {
    let mut cells = vec![Coverage::NONE; (size.width * size.height) as usize];
    let mut sink = SpanFn::new(Rect::of_size(size), |row: i32, columns: std::ops::Range<i32>, covered: Covered<'_>| {
        for (offset, column) in columns.enumerate() {
            cells[row as usize * size.width as usize + column as usize] = covered.at(offset);
        }
    });
    cover(outline, &mut sink);
    cells
}

#[test]
fn three_shapes_in_one_pixel_are_averaged_by_area() {
    let mut picture = dark(3, 3);
    // A half, a quarter and a quarter of the middle pixel.
    let corners = [
        [(16, 16), (24, 16), (24, 32), (16, 32)],
        [(24, 16), (32, 16), (32, 24), (24, 24)],
        [(24, 24), (32, 24), (32, 32), (24, 32)],
    ];
    for (corners, light) in corners.iter().zip([60_000, 10_001, 33_333]) {
        let corners = corners.map(|(x, y)| Point2::from_sixteenths(x, y));
        let contours = [&corners[..]];
        let part = Polygon::new(&contours).expect("in range");
        cover(&part, &mut Blended::new(&mut picture).with_mode(BlendMode::Add).brush(Light(light)));
    }
    let mean = 60_000.0 / 2.0 + 10_001.0 / 4.0 + 33_333.0 / 4.0;
    let middle = picture.pixel(Point::new(1, 1)).expect("inside");
    assert!((f64::from(middle.0) - mean).abs() <= 2.0, "{middle:?}");
    assert_eq!(points(Size::new(3, 3)).filter(|&point| picture.pixel(point) != Some(Light::BLACK)).count(), 1);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn shapes_around_a_point_are_averaged_by_area(
        middle in (20..100_i32, 20..100_i32), ends in vec(0..128_i32, 3), lights in vec(any::<u16>(), 3),
    ) {
        // Triangles from a point to the border of the picture: three shapes that share a pixel.
        let border = |at: i32| match at / 32 {
            0 => (at % 32 * 4, 0),
            1 => (128, at % 32 * 4),
            2 => (128 - at % 32 * 4, 128),
            _ => (0, 128 - at % 32 * 4),
        };
        let size = Size::new(8, 8);
        let mut ends = ends;
        ends.sort_unstable();
        let mut picture = dark(8, 8);
        let (mut sums, mut whole) = (vec![0.0; 64], vec![0_i32; 64]);
        for (index, drawn) in lights.iter().enumerate() {
            let (from, to) = (ends[index], if index == 2 { ends[0] + 128 } else { ends[index + 1] });
            // Around the corners of the picture.
            let corners = (1..=8).map(|corner| corner * 32).filter(|corner| (from + 1..to).contains(corner));
            let around = std::iter::once(from).chain(corners).chain([to]).map(|at| border(at % 128));
            let contour: Vec<_> = std::iter::once(middle).chain(around).map(|(x, y)| Point2::from_sixteenths(x, y)).collect();
            let contours = [&contour[..]];
            let part = Polygon::new(&contours).expect("in range");
            cover(&part, &mut Blended::new(&mut picture).with_mode(BlendMode::Add).brush(Light(*drawn)));
            for ((sum, whole), covered) in sums.iter_mut().zip(&mut whole).zip(coverage(&part, size)) {
                *sum += f64::from(*drawn) * f64::from(covered.parts()) / 32_768.0;
                *whole += i32::from(covered.parts());
            }
        }
        for ((point, sum), whole) in points(size).zip(sums).zip(whole) {
            let ours = f64::from(picture.pixel(point).expect("inside").0);
            prop_assert!((ours - sum.min(65_535.0)).abs() <= 2.0, "{point:?}: {ours} {sum}");
            // Where the ends are one the whole is one of them.
            prop_assert!((whole - 32_768).abs() <= 4 || ends[0] == ends[2], "{point:?}: {whole}");
        }
    }

    #[test]
    fn areas_and_pixels_are_blended_one_by_one(
        before in vec(0..16_u8, 60), colors in vec((0..16_u8, 0..=32_768_u16), 1..80), mode in select(light::MODES.to_vec()),
        at in (-12..14_i32, -8..8_i32), size in (0..20_u32, 0..9_u32), part in (-3..6_i32, -3..4_i32, 0..12_i32, 0..8_i32),
    ) {
        let area = Rectangle::new(Point::new(at.0, at.1), Size::new(size.0, size.1));
        let colors: Vec<_> = colors.into_iter().map(|(code, parts)| Alpha::new(Gray4::new(code), Coverage::new(parts))).collect();
        let window = Rect::new(part.0, part.1, part.0 + part.2, part.1 + part.3);
        let under = |point: Point| Gray4::new(before[point.y as usize * 10 + point.x as usize]);
        for which in 0..3 {
            let mut frame = Frame::<Gray4, Rows, _>::with_array([0; 30], 10, 6).expect("memory enough");
            let Ok(()) = frame.fill_contiguous(&frame.bounding_box(), before.iter().map(|&code| Gray4::new(code)));
            let mut seen = Window::part(&mut frame, window);
            let mut target = Blended::new(&mut seen).with_mode(mode);
            let drawn = area.points().zip(&colors).map(|(point, &color)| Pixel(point, color));
            let Ok(()) = match which {
                0 => target.draw_iter(drawn.clone()),
                1 => target.fill_contiguous(&area, colors.iter().copied()),
                _ => target.fill_solid(&area, colors[0]),
            };
            let is_seen = |point: Point| window.contains(point);
            for point in points(Size::new(10, 6)) {
                // The window's own corner is (0, 0).
                let inside = point - Point::new(window.left, window.top);
                let place = area.points().position(|place| place == inside);
                let color = if which == 2 { place.map(|_| colors[0]) } else { place.and_then(|place| colors.get(place).copied()) };
                let expected = match color.filter(|_| is_seen(point)) {
                    Some(Alpha { color, coverage }) if coverage != Coverage::NONE => color.blend(under(point), mode, coverage),
                    _ => under(point),
                };
                prop_assert_eq!(frame.pixel(point), Some(expected), "{} {:?}", which, point);
            }
        }
    }

    #[test]
    fn inks_are_covered_pixel_by_pixel(
        corners in vec((-50..700_i32, -50..250_i32), 3..6), mode in select(light::MODES.to_vec()), anchor in (-9..9_i32, -9..9_i32),
        percent in 0..=100_u8, is_bolder: bool, window in (-5..20_i32, -5..9_i32, 1..40_i32, 1..15_i32),
    ) {
        let corners: Vec<_> = corners.into_iter().map(|(x, y)| Point2::from_sixteenths(x, y)).collect();
        let contours = [&corners[..]];
        let shape = Polygon::new(&contours).expect("in range");
        let curve = if is_bolder { CoverageCurve::bolder(percent) } else { CoverageCurve::thinner(percent) };
        let anchor = Point::new(anchor.0, anchor.1);
        let tile = Pattern::new([[0, 9000, 60_000], [65_535, 1, 30_000]].map(|row| row.map(Light))).anchored(anchor);
        let stencil = Stencil::new([0b1011_0001, 0, 0xFF], Light(40_000)).anchored(anchor);
        let size = Size::new(40, 12);
        let window = Rect::new(window.0, window.1, window.0 + window.2, window.1 + window.3).intersection(Rect::of_size(size));
        check_ink(&shape, &tile, (mode, curve), size);
        check_ink(&shape, &stencil, (mode, curve), size);
        check_ink(&shape, &Light(12_345), (mode, curve), size);
        // Of a part of the display all is right, too, to the roundings of tiles.
        let (mut whole, mut part) = (dark(40, 12), dark(40, 12));
        cover(&shape, &mut Blended::new(&mut whole).brush(Light::WHITE));
        let shifted: Vec<_> = corners.iter().map(|corner| Point2::new(corner.x - Subpixel::from_num(window.left), corner.y - Subpixel::from_num(window.top))).collect();
        let contours = [&shifted[..]];
        cover(&Polygon::new(&contours).expect("in range"), &mut Blended::new(&mut Window::part(&mut part, window)).brush(Light::WHITE));
        for point in points(size) {
            let expected = if window.contains(point) { whole.pixel(point) } else { Some(Light::BLACK) };
            let [ours, expected] = [part.pixel(point), expected].map(|light| light.expect("inside").0);
            prop_assert!(ours.abs_diff(expected) <= 32, "{:?}: {} {}", point, ours, expected);
        }
    }

    #[test]
    fn a_mask_shows_the_shape_to_eight_bits(center in (-30..600_i32, -30..250_i32), radii in (0..300_i32, 0..200_i32), at in (-45..45_i32, -14..14_i32)) {
        let size = Size::new(40, 12);
        let oval = |x: i32, y: i32| Oval::new(Point2::from_sixteenths(center.0 + 16 * x, center.1 + 16 * y), [radii.0, radii.1].map(Subpixel::from_bits)).expect("in range");
        let mut mask = CoverageMask::new(vec![0; 480], size).expect("memory enough");
        cover(&oval(0, 0), &mut mask);
        let (mut shown, mut direct) = (dark(40, 12), dark(40, 12));
        let Ok(()) = mask.spans(Point::new(at.0, at.1), &mut Blended::new(&mut shown).brush(Light::WHITE));
        cover(&oval(at.0, at.1), &mut Blended::new(&mut direct).brush(Light::WHITE));
        for point in points(size).filter(|&point| Rectangle::new(Point::new(at.0, at.1), size).contains(point)) {
            let [shown, direct] = [shown.pixel(point), direct.pixel(point)].map(|light| light.expect("inside").0);
            // Half of a step of eight bits, and what a tile may be off.
            prop_assert!(shown.abs_diff(direct) <= 129 + 16, "{:?}: {} {}", point, shown, direct);
        }
    }
}

/// Draws on a ramp of lights and compares each pixel with its own blend.
fn check_ink(
    shape: &impl Outline,
    ink: &(impl Ink<Color = Light> + Copy),
    (mode, curve): (BlendMode, CoverageCurve),
    size: Size,
) {
    let under = |point: Point| Light(u16::try_from(point.x * 1600 + point.y * 100).expect("small"));
    let mut picture = dark(size.width, size.height);
    let Ok(()) = picture.fill_contiguous(&picture.bounding_box(), points(size).map(under));
    // The ink alone, where it has a colour.
    let mut colors = vec![None; points(size).count()];
    for row in 0..size.height.cast_signed() {
        let Ok(()) = ink.fill(&mut Colors(&mut colors, size), row, 0..size.width.cast_signed());
    }
    let covered = coverage(shape, size);
    cover(shape, &mut Blended::new(&mut picture).with_mode(mode).brush(*ink).with_curve(curve));
    for ((point, covered), color) in points(size).zip(covered).zip(colors) {
        let expected = match color {
            Some(color) if covered != Coverage::NONE => mode.mix(color, under(point), curve.bend(covered)),
            _ => under(point),
        };
        assert_eq!(picture.pixel(point), Some(expected), "{mode:?} {curve:?} {point:?} {covered:?}");
    }
}

/// Keeps the colours of an ink.
struct Colors<'c>(&'c mut [Option<Light>], Size);

impl Target for Colors<'_> {
    type Color = Light;
    type Error = Infallible;

    fn bounds(&self) -> Rect {
        Rect::of_size(self.1)
    }

    fn fill_run<const N: usize>(
        &mut self,
        row: i32,
        columns: std::ops::Range<i32>,
        colors: [Light; N],
    ) -> Result<(), Infallible> {
        let repeated = columns.clone().map(|column| Some(colors[column as usize % N]));
        self.write_run(row, columns, repeated)
    }

    fn write_run(
        &mut self,
        row: i32,
        columns: std::ops::Range<i32>,
        colors: impl Iterator<Item = Option<Light>>,
    ) -> Result<(), Infallible> {
        let line = row as usize * self.1.width as usize;
        for (column, color) in columns.zip(colors) {
            self.0[line + column as usize] = color;
        }
        Ok(())
    }
}

#[test]
fn all_modes_on_light_and_on_greys() {
    let parts = [0, 1, 5000, 16_384, 20_000, 32_767, 32_768];
    for mode in light::MODES {
        for (drawn, under) in
            (0..=65_535).step_by(4369).flat_map(|drawn| (0..=65_535).step_by(3855).map(move |under| (drawn, under)))
        {
            for parts in parts {
                let (drawn, under) = (Light(drawn), Light(under));
                let ours = drawn.blend(under, mode, Coverage::new(parts));
                let exact =
                    light::mixed(mode, light::of_light(drawn), light::of_light(under), f64::from(parts) / 32_768.0);
                assert!(
                    (f64::from(ours.0) - exact * 65_535.0).abs() <= 1.01,
                    "{mode:?} {drawn:?} {under:?} {parts}: {ours:?}"
                );
            }
        }
        let grey = |code: u8| light::of_srgb(f64::from(code) / 15.0);
        for (drawn, under) in (0..16).flat_map(|drawn| (0..16).map(move |under| (drawn, under))) {
            for parts in (0..=32_768).step_by(256) {
                let ours = Gray4::new(drawn).blend(Gray4::new(under), mode, Coverage::new(parts));
                let exact = light::mixed(mode, grey(drawn), grey(under), f64::from(parts) / 32_768.0);
                let best = (0..16).map(|code| (grey(code) - exact).abs()).fold(f64::INFINITY, f64::min);
                let excess = (grey(ours.luma()) - exact).abs() - best;
                assert!(excess <= 3.0 / 65_535.0, "{mode:?} {drawn} {under} {parts}: {ours:?}, {excess}");
            }
        }
    }
}

#[test]
fn all_modes_on_colours() {
    // The channels of a colour are codes of 8 bits before and after: two roundings.
    let to_light = |code: u8, most: u8| light::of_srgb((f64::from(code) * 255.0 / f64::from(most)).round() / 255.0);
    let to_code = |light: f64| if light <= 0.003_130_8 { light * 12.92 } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 };
    let mut worst = 0.0_f64;
    for mode in light::MODES {
        for code in 0..=0xFFFF_u16 {
            // Every 37th colour on a colour that is far from it.
            let (drawn, under) = (code.wrapping_mul(37), code.wrapping_mul(151).rotate_left(5));
            let parts = code.wrapping_mul(97) % 32_769;
            let [a, b] = [drawn, under].map(|bits| Rgb565::from(embedded_graphics::pixelcolor::raw::RawU16::new(bits)));
            let ours = a.blend(b, mode, Coverage::new(parts));
            let channels = [(a.r(), b.r(), ours.r(), 31), (a.g(), b.g(), ours.g(), 63), (a.b(), b.b(), ours.b(), 31)];
            for (drawn, under, ours, most) in channels {
                let exact =
                    light::mixed(mode, to_light(drawn, most), to_light(under, most), f64::from(parts) / 32_768.0);
                let off = (f64::from(ours) - to_code(exact) * f64::from(most)).abs();
                // In steps of the channel: half of one, and half of an 8-bit one.
                worst = worst.max(off - f64::from(most) / 510.0);
            }
        }
    }
    assert!(worst <= 0.51, "{worst}");
}

#[test]
fn styles_bend_the_coverage() {
    let size = Size::new(20, 20);
    let oval = Oval::circle(Point2::from_sixteenths(163, 158), Subpixel::from_num(8)).expect("in range");
    for curve in [CoverageCurve::LINEAR, CoverageCurve::bolder(60), CoverageCurve::thinner(100)] {
        let (mut linear, mut bent) = (Record::new(size), Record::new(size));
        let style = AntialiasedStyle::fill(Gray8::WHITE);
        let Ok(()) = oval.into_styled(style).draw(&mut linear);
        let Ok(()) = oval.into_styled(style.with_curve(curve)).draw(&mut bent);
        for point in points(size) {
            let expected = linear.at(point).map(|alpha| curve.bend(alpha.coverage));
            assert_eq!(bent.at(point).map(|alpha| alpha.coverage), expected);
        }
    }
}
