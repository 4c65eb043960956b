//! The colour matrix against the same in floating point, and what must be exact.

use crate::exact::some_colours;
use aquatint::{Angle, ColourMatrix, Light, Scalar};
use proptest::prelude::*;

/// Rows, and what is added.
type Exact = ([[f64; 3]; 3], f64);

const WEIGHTS: [f64; 3] = [0.2126, 0.7152, 0.0722];

fn unit(row: usize, column: usize) -> f64 {
    f64::from(u8::from(row == column))
}

fn rows(element: impl Fn(usize, usize) -> f64) -> [[f64; 3]; 3] {
    [0, 1, 2].map(|row| [0, 1, 2].map(|column| element(row, column)))
}

fn exact_saturation(factor: f64) -> Exact {
    (rows(|row, column| factor * unit(row, column) + (1.0 - factor) * WEIGHTS[column]), 0.0)
}

/// The quarter turn about the greys that keeps the luminance, from its conditions: rows sum to 0, so does each
/// column by the weights, and the first and the last row are as the W3C has them.
fn exact_hue(degrees: f64) -> Exact {
    let [r, g, b] = WEIGHTS;
    let (first, last) = ([-r, -g, 1.0 - b], [r - 1.0, g, b]);
    let middle = [0, 1, 2].map(|at| -(r * first[at] + b * last[at]) / g);
    let quarter = [first, middle, last];
    let (sin, cos) = degrees.to_radians().sin_cos();
    let weight = |column: usize| WEIGHTS[column];
    (rows(|row, column| weight(column) + cos * (unit(row, column) - weight(column)) + sin * quarter[row][column]), 0.0)
}

fn exact_sepia(amount: f64) -> Exact {
    let sepia = [[0.393, 0.769, 0.189], [0.349, 0.686, 0.168], [0.272, 0.534, 0.131]];
    (rows(|row, column| (1.0 - amount) * unit(row, column) + amount * sepia[row][column]), 0.0)
}

fn exact_contrast(factor: f64) -> Exact {
    (rows(|row, column| factor * unit(row, column)), (1.0 - factor) / 2.0)
}

/// The exact result, clipped, for a scale of `full`.
fn exact_product((rows, bias): &Exact, colour: [f64; 3], full: f64) -> [f64; 3] {
    rows.map(|row| {
        let sum: f64 = row.into_iter().zip(colour).map(|(a, b)| a * b).sum();
        (sum + bias * full).clamp(0.0, full)
    })
}

/// Every matrix that has a name, with its exact one.
fn named() -> Vec<(String, ColourMatrix, Exact)> {
    let mut all = vec![
        ("identity".into(), ColourMatrix::IDENTITY, exact_contrast(1.0)),
        ("invert".into(), ColourMatrix::INVERT, (rows(|row, column| -unit(row, column)), 1.0)),
    ];
    for factor in [-1.0, 0.0, 0.3, 0.5, 1.0, 1.7, 2.5] {
        let value = Scalar::from_num(factor);
        all.push((format!("saturation {factor}"), ColourMatrix::saturation(value), exact_saturation(factor)));
        all.push((format!("contrast {factor}"), ColourMatrix::contrast(value), exact_contrast(factor)));
        let brighter = (rows(|row, column| factor * unit(row, column)), 0.0);
        all.push((format!("brightness {factor}"), ColourMatrix::brightness(value), brighter));
        let amount = factor.clamp(0.0, 1.0);
        all.push((format!("sepia {factor}"), ColourMatrix::sepia(value), exact_sepia(amount)));
    }
    for degrees in (0..360_u16).step_by(15) {
        let angle = Angle::from_degrees(f32::from(degrees));
        let turns = f64::from(angle.0) / 65_536.0 * 360.0;
        all.push((format!("hue {degrees}"), ColourMatrix::hue_rotation(angle), exact_hue(turns)));
    }
    all
}

#[test]
fn named_matrices_are_near_the_exact_ones() {
    for (name, matrix, exact) in named() {
        // Where the sum of a row has to be rounded too it adds half a coefficient's last bit of the full scale.
        let (code_error, light_error) = if name.starts_with("sepia") { (0.6, 25.0) } else { (0.57, 17.0) };
        for rgb in some_colours(23) {
            let want = exact_product(&exact, rgb.map(f64::from), 255.0);
            for (got, want) in matrix.apply(rgb).into_iter().zip(want) {
                assert!((f64::from(got) - want).abs() <= code_error, "{name} of {rgb:?}: {got} {want}");
            }
            let lights = rgb.map(Light::from_srgb);
            let want = exact_product(&exact, lights.map(|light| light.0.into()), 65_535.0);
            let got = matrix.apply(lights);
            assert_eq!(matrix.apply(lights.map(|light| light.0)), got.map(|light| light.0));
            for (got, want) in got.into_iter().zip(want) {
                assert!((f64::from(got.0) - want).abs() <= light_error, "{name} of {rgb:?}: {got:?} {want}");
            }
        }
    }
}

#[test]
fn greys_stay_exactly() {
    let keep = |matrix: ColourMatrix| {
        (0..=u16::MAX).all(|light| matrix.apply([light; 3]) == [light; 3])
            && (0..=255_u8).all(|code| matrix.apply([code; 3]) == [code; 3])
    };
    assert!(keep(ColourMatrix::IDENTITY));
    for factor in [-7.0, -1.0, 0.0, 0.3, 1.0, 1.7, 7.0] {
        assert!(keep(ColourMatrix::saturation(Scalar::from_num(factor))), "{factor}");
    }
    for degrees in (0..360_u16).step_by(15) {
        assert!(keep(ColourMatrix::hue_rotation(Angle::from_degrees(degrees.into()))), "{degrees}");
    }
}

/// Row sums of every hue and every saturation, not of some.
#[test]
fn rows_that_should_sum_to_one_do() {
    let sums_are_one = |matrix: ColourMatrix| {
        matrix.rows().iter().all(|row| row.iter().map(|&value| i32::from(value)).sum::<i32>() == 4096)
    };
    assert!((0..=u16::MAX).all(|turn| sums_are_one(ColourMatrix::hue_rotation(Angle(turn)))));
    let factors = (i32::MIN..=i32::MAX).step_by(65_521).chain(-600_000..600_000);
    assert!(factors.map(Scalar::from_bits).all(|factor| sums_are_one(ColourMatrix::saturation(factor))));
}

#[test]
fn luminance_stays_when_hues_turn() {
    let luminance = |rgb: [u16; 3]| rgb.into_iter().zip(WEIGHTS).map(|(light, w)| f64::from(light) * w).sum::<f64>();
    // Far enough from the ends that nothing is clipped.
    for rgb in [[30_000, 28_000, 31_000], [33_000, 30_000, 36_000], [30_000, 32_000, 26_000]] {
        for turn in (0..=u16::MAX).step_by(97) {
            let turned = ColourMatrix::hue_rotation(Angle(turn)).apply(rgb);
            assert!((luminance(turned) - luminance(rgb)).abs() <= 4.0, "{turned:?}");
        }
    }
}

#[test]
fn four_quarter_turns_and_two_negatives_change_next_to_nothing() {
    let quarter = ColourMatrix::hue_rotation(Angle::QUARTER);
    let half = quarter.then(&quarter);
    let whole = half.then(&half);
    for (row, unit) in whole.rows().iter().zip(ColourMatrix::IDENTITY.rows()) {
        assert!(row.iter().zip(unit).all(|(a, b)| a.abs_diff(*b) <= 2), "{whole:?}");
    }
    assert_eq!(ColourMatrix::INVERT.then(&ColourMatrix::INVERT), ColourMatrix::IDENTITY);
}

#[test]
fn known_colours() {
    assert_eq!(ColourMatrix::INVERT.apply_rgba([0, 100, 255, 7_u8]), [255, 155, 0, 7]);
    assert_eq!(ColourMatrix::sepia(Scalar::ONE).apply([255_u8; 3]), [255, 255, 239]);
    assert_eq!(ColourMatrix::sepia(Scalar::ONE).apply([100_u8, 150, 200]), [192, 171, 134]);
    let grey = ColourMatrix::saturation(Scalar::ZERO);
    assert_eq!(grey.apply([255_u8, 0, 0]), [54; 3]);
    assert_eq!(ColourMatrix::contrast(Scalar::ZERO).apply([9_u8, 200, 30]), [128; 3]);
    assert_eq!(ColourMatrix::brightness(Scalar::from_num(0.5)).apply([Light(1000); 3]), [Light(500); 3]);
}

/// A red of 3 and −2 in a chain: were it clipped in between, it would not come back.
#[test]
fn nothing_is_clipped_in_between() {
    let scalar = Scalar::from_num::<f64>;
    let far = ColourMatrix::IDENTITY.with_scale_and_bias([scalar(4.0); 4], [scalar(-2.0); 4]);
    let back = ColourMatrix::IDENTITY.with_scale_and_bias([scalar(0.25); 4], [scalar(0.5); 4]);
    assert_eq!(far.then(&back), ColourMatrix::IDENTITY);
    assert_ne!(back.apply(far.apply([10_u8, 100, 200])), [10, 100, 200]);
    // The scale comes before the bias, and both after the matrix.
    let both = ColourMatrix::INVERT.with_scale_and_bias([scalar(0.5); 4], [scalar(0.25); 4]);
    assert_eq!(both.bias(), [0.75, 0.75, 0.75, 0.25].map(scalar));
    assert_eq!(both.apply_rgba([255_u8, 0, 51, 255]), [64, 191, 166, 191]);
}

#[test]
fn what_is_out_of_range_is_moved_there_and_its_neighbours_stay() {
    let far = ColourMatrix::from_rows(
        [[9, 0, 0, 1], [-9, 1, 0, 0], [0, 0, 100, -100], [0; 4]].map(|row| row.map(Scalar::from_num)),
    );
    let want = [[32_767, 0, 0, 4096], [-32_768, 4096, 0, 0], [0, 0, 32_767, -32_768], [0; 4]];
    assert_eq!(far.rows(), &want);
    // 40 full scales more than −32 of the row is white, though the bias is kept as 33.
    let least = ColourMatrix::from_parts([[i16::MIN; 4]; 4], [Scalar::from_num(40); 4]);
    assert_eq!(least.apply_rgba([255_u8; 4]), [255; 4]);
    let most = ColourMatrix::from_parts([[i16::MAX; 4]; 4], [Scalar::from_num(-40); 4]);
    assert_eq!(most.apply_rgba([255_u8; 4]), [0; 4]);
}

/// Scalars of all kinds: small, ordinary and extreme.
fn scalar() -> impl Strategy<Value = Scalar> {
    prop_oneof![
        4 => -600_000..600_000_i32,
        2 => -70_000..70_000_i32,
        2 => any::<i32>(),
        1 => prop::sample::select(vec![i32::MIN, i32::MAX, 0, 1 << 19, -(1 << 19), 33 << 16]),
    ]
    .prop_map(Scalar::from_bits)
}

fn coefficients() -> impl Strategy<Value = [[i16; 4]; 4]> {
    let coefficient = prop_oneof![
        any::<i16>(),
        -5000..5000_i16,
        prop::sample::select(vec![i16::MIN, i16::MIN + 1, i16::MAX, 0, 4096, -4096]),
    ];
    prop::array::uniform4(prop::array::uniform4(coefficient))
}

/// The exact product in 128 bits: rounded once, halves up, then clipped.
fn oracle(rows: [[i16; 4]; 4], bias: [Scalar; 4], colour: [u16; 4], full: i128) -> [u16; 4] {
    let parts = rows.into_iter().zip(bias).map(|(row, bias)| {
        let sum: i128 = row.into_iter().zip(colour).map(|(a, b)| i128::from(a) * i128::from(b)).sum();
        let exact = sum * 16 + i128::from(bias.to_bits()) * full;
        u16::try_from((exact + 0x8000).div_euclid(0x1_0000).clamp(0, full)).expect("clipped")
    });
    parts.collect::<Vec<_>>().try_into().expect("four")
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn any_matrix_is_exact(rows in coefficients(), bias in prop::array::uniform4(scalar()), colour: [u16; 4]) {
        let matrix = ColourMatrix::from_parts(rows, bias);
        prop_assert_eq!(matrix.apply_rgba(colour), oracle(rows, bias, colour, 65_535));
        prop_assert_eq!(matrix.apply_rgba(colour.map(Light)).map(|light| light.0), oracle(rows, bias, colour, 65_535));
        let codes = colour.map(|light| light.to_le_bytes()[1]);
        let want = oracle(rows, bias, codes.map(u16::from), 255);
        prop_assert_eq!(matrix.apply_rgba(codes).map(u16::from), want);
        let [red, green, blue, _] = codes;
        let [r, g, b, _] = matrix.apply_rgba([red, green, blue, 255]);
        prop_assert_eq!(matrix.apply([red, green, blue]), [r, g, b]);
    }

    #[test]
    fn rows_are_rounded_so_that_their_sums_are(rows in prop::array::uniform4(prop::array::uniform4(-32_000..32_000_i32))) {
        let matrix = ColourMatrix::from_rows(rows.map(|row| row.map(Scalar::from_bits)));
        for (got, exact) in matrix.rows().iter().zip(rows) {
            let sum: i32 = got.iter().map(|&value| i32::from(value)).sum();
            prop_assert!((sum * 16 - exact.iter().sum::<i32>()).abs() <= 8);
            prop_assert!(got.iter().zip(exact).all(|(&got, exact)| (i32::from(got) * 16 - exact).abs() < 16));
        }
    }

    /// One after the other without a clip, against both at once: the coefficients are rounded once more.
    #[test]
    fn a_chain_is_one_matrix(
        rows in prop::array::uniform2(prop::array::uniform4(prop::array::uniform4(-4096..4096_i16))),
        bias in prop::array::uniform2(prop::array::uniform4((-65_536..65_536_i32).prop_map(Scalar::from_bits))),
        colour: [u8; 4],
    ) {
        let [first, second] = [0, 1].map(|at| ColourMatrix::from_parts(rows[at], bias[at]));
        let exact = |at: usize, colour: [f64; 4]| {
            [0, 1, 2, 3].map(|row| {
                let products = rows[at][row].into_iter().zip(colour);
                let sum: f64 = products.map(|(a, b)| f64::from(a) / 4096.0 * b).sum();
                sum + bias[at][row].to_num::<f64>() * 255.0
            })
        };
        let want = exact(1, exact(0, colour.map(f64::from)));
        let chain = first.then(&second);
        for ((got, row), added) in chain.bias().into_iter().zip(rows[1]).zip(bias[1]) {
            let products = row.into_iter().zip(bias[0]).map(|(a, b)| i64::from(a) * i64::from(b.to_bits()));
            let error = (i64::from((got - added).to_bits()) << 12) - products.sum::<i64>();
            prop_assert!(error.abs() <= 1 << 11, "{error}");
        }
        for (got, want) in chain.apply_rgba(colour).into_iter().zip(want) {
            prop_assert!((f64::from(got) - want.clamp(0.0, 255.0)).abs() <= 0.65, "{got} {want}");
        }
    }

    #[test]
    fn nothing_overflows(
        rows in coefficients(),
        scalars in prop::array::uniform4(scalar()),
        others in prop::array::uniform4(scalar()),
        colour: [u16; 4],
    ) {
        let matrix = ColourMatrix::from_parts(rows, scalars);
        let scaled = matrix.with_scale_and_bias(scalars, others);
        let chain = scaled.then(&scaled).then(&ColourMatrix::from_rows([scalars, others, scalars, others]));
        let [first, second, ..] = scalars;
        let filters = [
            ColourMatrix::saturation(first),
            ColourMatrix::contrast(second),
            ColourMatrix::brightness(first),
            ColourMatrix::sepia(second),
        ];
        let all = filters.iter().fold(chain, |chain, filter| chain.then(filter));
        for matrix in [scaled, chain, all] {
            let _ = matrix.apply_rgba(colour);
            // A bias is moved into ±33, which is out of reach for any row.
            prop_assert!(matrix.bias().iter().all(|bias| bias.to_bits().abs() <= 33 << 16));
        }
    }
}
