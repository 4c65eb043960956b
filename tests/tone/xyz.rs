//! XYZ against the matrix of the primaries in floating point, whose error is 10⁻¹⁰ of a step.

use aquatint::{
    Chromaticity, Gamut, Light, Xyz,
    tone::xyz::{OutOfGamut, Tristimulus},
};
use proptest::prelude::*;

type Rows = [[f64; 3]; 3];

fn product(rows: &Rows, [x, y, z]: [f64; 3]) -> [f64; 3] {
    rows.map(|[a, b, c]| a * x + b * y + c * z)
}

/// Cramer's rule.
fn inverse([[a, b, c], [d, e, f], [g, h, i]]: Rows) -> Rows {
    let determinant = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
    let cofactors = [
        [e * i - f * h, c * h - b * i, b * f - c * e],
        [f * g - d * i, a * i - c * g, c * d - a * f],
        [d * h - e * g, b * g - a * h, a * e - b * d],
    ];
    cofactors.map(|row| row.map(|value| value / determinant))
}

/// From sRGB light to XYZ: the primaries in such amounts that together they are D65 of luminance 1.
fn from_linear() -> Rows {
    let column = |x: f64, y: f64| [x / y, 1.0, (1.0 - x - y) / y];
    let [r, g, b] = [column(0.64, 0.33), column(0.30, 0.60), column(0.15, 0.06)];
    let primaries = [0, 1, 2].map(|row| [r[row], g[row], b[row]]);
    let amounts = product(&inverse(primaries), column(0.3127, 0.3290));
    primaries.map(|[r, g, b]| [r * amounts[0], g * amounts[1], b * amounts[2]])
}

fn numbers(xyz: Xyz) -> [f64; 3] {
    [xyz.x, xyz.y, xyz.z].map(Tristimulus::to_num)
}

#[test]
fn white_black_and_the_primaries() {
    let xyz = |rgb: [u16; 3]| Xyz::from_linear(rgb.map(Light));
    assert_eq!(xyz([u16::MAX; 3]).y, Tristimulus::from_num(65_535));
    assert_eq!(xyz([u16::MAX; 3]).chromaticity(), Some(Chromaticity::D65));
    assert_eq!(xyz([0; 3]), Xyz::default());
    assert_eq!(xyz([0; 3]).chromaticity(), None);
    let [red, green, blue] = Gamut::SRGB.primaries;
    assert_eq!(xyz([u16::MAX, 0, 0]).chromaticity(), Some(red));
    assert_eq!(xyz([0, u16::MAX, 0]).chromaticity(), Some(green));
    assert_eq!(xyz([0, 0, u16::MAX]).chromaticity(), Some(blue));
}

#[test]
fn clipping_is_reported() {
    let cyan = Chromaticity::from_ten_thousandths(500, 3000).with_luminance(Light(20_000)).expect("y");
    let Err(OutOfGamut([red, green, blue])) = cyan.to_linear() else { panic!("a colour of the spectrum is shown") };
    assert!(red == Light::BLACK && green > red && blue > red, "{red:?} {green:?} {blue:?}");
    // Twice as bright as white.
    let white = Chromaticity::D65.with_luminance(Light::WHITE).expect("y");
    let [x, y, z] = [white.x, white.y, white.z].map(|value| value * 2);
    assert_eq!(Xyz { x, y, z }.to_linear(), Err(OutOfGamut([Light::WHITE; 3])));
    assert_eq!(Chromaticity { x: 1, y: 0 }.with_luminance(Light::WHITE), None);
}

#[test]
fn triangles() {
    let at = Chromaticity::from_ten_thousandths;
    let [red, green, blue] = Gamut::SRGB.primaries;
    for inside in [red, green, blue, Chromaticity::D65, at(3333, 3333)] {
        assert!(Gamut::SRGB.contains(inside), "{inside:?}");
        assert!(Gamut { primaries: [green, red, blue] }.contains(inside), "the other way around: {inside:?}");
    }
    for outside in [at(0, 0), at(9999, 9999), at(1700, 7970), at(6401, 3300), at(1500, 599), at(3000, 6001)] {
        assert!(!Gamut::SRGB.contains(outside), "{outside:?}");
    }
    let line = Gamut { primaries: [at(1000, 1000), at(2000, 2000), at(3000, 3000)] };
    assert!(!line.contains(at(2000, 2000)) && !Gamut { primaries: [red; 3] }.contains(red));
    let all = Gamut { primaries: [(0, 0), (u16::MAX, 0), (0, u16::MAX)].map(|(x, y)| Chromaticity { x, y }) };
    assert!(
        all.contains(Chromaticity { x: 32_767, y: 32_768 }) && !all.contains(Chromaticity { x: 32_768, y: 32_768 })
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn every_light_is_right_and_comes_back(rgb: [u16; 3]) {
        let xyz = Xyz::from_linear(rgb.map(Light));
        for (got, exact) in numbers(xyz).into_iter().zip(product(&from_linear(), rgb.map(f64::from))) {
            prop_assert!((got - exact).abs() <= 0.01, "{got} {exact}");
        }
        prop_assert_eq!(xyz.to_linear(), Ok(rgb.map(Light)));
    }

    /// Anything at all: the nearest light, or clipped, and it says which.
    #[test]
    fn any_numbers_are_the_nearest_light(
        bits in prop_oneof![any::<[i32; 3]>(), prop::array::uniform3(-1_000_000..300_000_000_i32)]
    ) {
        let [x, y, z] = bits.map(Tristimulus::from_bits);
        let xyz = Xyz { x, y, z };
        let exact = product(&inverse(from_linear()), numbers(xyz));
        let (lights, is_shown) = match xyz.to_linear() {
            Ok(lights) => (lights, true),
            Err(OutOfGamut(lights)) => (lights, false),
        };
        for (got, exact) in lights.into_iter().zip(exact) {
            prop_assert!((f64::from(got.0) - exact.clamp(0.0, 65_535.0)).abs() <= 0.6, "{got:?} {exact}");
        }
        let within = |slack: f64| exact.iter().all(|value| (-slack..=65_535.0 + slack).contains(value));
        prop_assert_eq!(within(if is_shown { 0.6 } else { 0.4 }), is_shown);
        let sum: f64 = numbers(xyz).iter().sum();
        prop_assert_eq!(xyz.chromaticity().is_some(), sum > 0.0);
    }

    #[test]
    fn chromaticities_are_the_nearest(rgb: [u16; 3], luminance: u16) {
        let xyz = Xyz::from_linear(rgb.map(Light));
        let Some(place) = xyz.chromaticity() else { return Ok(()) };
        let [x, y, z] = numbers(xyz);
        for (got, exact) in [(place.x, x), (place.y, y)] {
            prop_assert!((f64::from(got) - exact / (x + y + z) * 65_536.0).abs() <= 0.5 + 1e-6);
        }
        let again = place.with_luminance(Light(luminance)).expect("y is above 0");
        prop_assert_eq!(again.y, Tristimulus::from_num(luminance));
        // Light of three positive primaries is in their triangle, but for the rounding to 1/65536.
        let centre = Chromaticity::D65;
        let inwards = |v: u16, c: u16| if v < c { v + 2 } else { v - 2 };
        let inner = Chromaticity { x: inwards(place.x, centre.x), y: inwards(place.y, centre.y) };
        prop_assert!(Gamut::SRGB.contains(place) || Gamut::SRGB.contains(inner), "{place:?}");
    }

    #[test]
    fn no_place_and_no_triangle_overflows(places: [[u16; 2]; 4], luminance: u16) {
        let [a, b, c, place] = places.map(|[x, y]| Chromaticity { x, y });
        prop_assert_eq!(Gamut { primaries: [a, b, c] }.contains(place), Gamut { primaries: [c, b, a] }.contains(place));
        let _ = place.with_luminance(Light(luminance));
    }
}
