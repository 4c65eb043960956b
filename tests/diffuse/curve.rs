//! Along Hilbert's curve.

use aquatint::{
    Frame, Levels, Light, Rows,
    display::diffuse::{AlongCurve, Carry, Hilbert, History, Riemersma},
};
use embedded_graphics::{
    geometry::{Dimensions, Point, Size},
    pixelcolor::{BinaryColor, Gray8},
    primitives::Rectangle,
};
use proptest::{collection::vec, prelude::*};

/// The curve as it is defined: four of the order below.
fn square(order: u32) -> Vec<Point> {
    let Some(below) = order.checked_sub(1) else { return vec![Point::zero()] };
    let (quarter, side) = (square(below), 1 << below);
    let first = quarter.iter().map(|p| Point::new(p.y, p.x));
    let second = quarter.iter().map(|p| Point::new(p.x, p.y + side));
    let third = quarter.iter().map(|p| Point::new(p.x + side, p.y + side));
    let last = quarter.iter().map(|p| Point::new(2 * side - 1 - p.y, side - 1 - p.x));
    first.chain(second).chain(third).chain(last).collect()
}

#[test]
fn a_square_is_walked_step_by_step() {
    for order in 0..=8 {
        let points: Vec<_> = Hilbert::new(Size::new_equal(1 << order)).collect();
        assert_eq!(points, square(order));
        for two in points.windows(2) {
            let step = two[1] - two[0];
            assert_eq!(step.x.abs() + step.y.abs(), 1, "{two:?}");
        }
    }
}

#[test]
fn a_long_picture_is_walked_in_time() {
    assert_eq!(Hilbert::new(Size::new(1_000_000, 1)).count(), 1_000_000);
    assert_eq!(Hilbert::new(Size::new(2, 300_000)).count(), 600_000);
    assert_eq!(Hilbert::new(Size::new(u32::MAX, u32::MAX)).nth(4), Some(Point::new(0, 2)));
    assert_eq!(Hilbert::new(Size::new(u32::MAX, 0)).next(), None);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn any_picture_is_walked_in_the_order_of_the_square(width in 0..20_u32, height in 0..20_u32) {
        let order = 32 - width.max(height).saturating_sub(1).leading_zeros();
        let inside = |point: &Point| point.x < width.cast_signed() && point.y < height.cast_signed();
        prop_assert!(Hilbert::new(Size::new(width, height)).eq(square(order).into_iter().filter(inside)));
    }

    #[test]
    fn every_pixel_is_that_of_the_definition(
        lights in vec(prop_oneof![any::<u16>(), Just(0), Just(u16::MAX)], 1..200),
        width in 1..20_u32,
        levels in proptest::collection::btree_set(any::<u16>(), 2..9),
        (left, top) in (-5..30, -5..30),
    ) {
        let levels: Vec<_> = levels.into_iter().collect();
        let area = Rectangle::new(Point::new(left, top), Size::new(width, u32::try_from(lights.len()).expect("small") / width));
        check::<Carry>(&lights, &levels, area, carry);
        check::<Riemersma>(&lights, &levels, area, riemersma);
    }
}

/// Correction and what is remembered, of pairs of error with and without correction, the last first.
fn carry(errors: &[(i64, i64)]) -> i64 {
    errors.first().map_or(0, |(with, _)| *with)
}

fn riemersma(errors: &[(i64, i64)]) -> i64 {
    let weights = [16, 13, 11, 9, 8, 6, 5, 4, 4, 3, 3, 2, 2, 1, 1, 1];
    let sum: i64 = errors.iter().zip(weights).map(|((_, without), weight)| without * weight).sum();
    (sum + 8).div_euclid(16)
}

fn check<H: History>(lights: &[u16], levels: &[u16], area: Rectangle, correction: fn(&[(i64, i64)]) -> i64) {
    let mut frame = Frame::<Gray8, Rows, _>::new(vec![77; 30 * 24], 30, 24).expect("enough");
    let mut expected = vec![77; 30 * 24];
    let light = |point: Point| {
        let at = (point.y - area.top_left.y) * area.size.width.cast_signed() + point.x - area.top_left.x;
        lights[usize::try_from(at).expect("inside")]
    };
    let curve = AlongCurve::<H>::new(Levels::new(levels).expect("rising"));
    let Ok(()) = curve.draw(&mut frame, area, |point| Light(light(point)));

    let visible = area.intersection(&frame.bounding_box());
    let mut errors = vec![];
    for point in Hilbert::new(visible.size).map(|point| point + visible.top_left) {
        let light = i64::from(light(point).clamp(levels[0], levels[levels.len() - 1]));
        let value = light + correction(&errors);
        let code = (0..levels.len()).min_by_key(|&code| (i64::from(levels[code]) - value).abs()).expect("some");
        errors.insert(0, (value - i64::from(levels[code]), light - i64::from(levels[code])));
        let at = usize::try_from(point.y * 30 + point.x).expect("inside");
        expected[at] = u8::try_from(code).expect("few");
    }
    assert_eq!(frame.bytes(), expected);
}

#[test]
fn flat_greys_keep_their_light() {
    for code in 0..=255 {
        let light = Light::from_srgb(code);
        let exact = f64::from(light.0) / 65_535.0;
        assert!((white::<Carry>(light) - exact).abs() <= 1.0 / 4096.0, "{code}");
        // A history of 89 sixteenths cannot lift what is darker than a thirteenth.
        assert!((white::<Riemersma>(light) - exact).abs() <= 1.0 / 13.0, "{code}: {}", white::<Riemersma>(light));
    }
    for light in [Light::BLACK, Light::WHITE] {
        let exact = f64::from(light.0) / 65_535.0;
        assert!((white::<Carry>(light), white::<Riemersma>(light)) == (exact, exact));
    }
}

/// Share of white in 64 × 64 pixels of a light.
fn white<H: History>(light: Light) -> f64 {
    let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 512], 64, 64).expect("enough");
    let area = frame.bounding_box();
    let Ok(()) = AlongCurve::<H>::new(Levels::ONE_BIT).draw(&mut frame, area, |_| light);
    f64::from(frame.bytes().iter().map(|byte| byte.count_ones()).sum::<u32>()) / 4096.0
}
