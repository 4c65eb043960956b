//! The transform of the inner loop has the very bits of one in 128-bit arithmetic.

use aquatint::{Clip, Matrix, Model, Scalar, geometry::transform::MeshTransform};
use proptest::prelude::*;

use crate::{element, place, rows};

/// The exact sum, rounded once: half a unit up.
fn exact(row: [Scalar; 4], place: [i16; 3]) -> i128 {
    let [x, y, z, w] = row.map(|v| i128::from(v.to_bits()));
    let [a, b, c] = place.map(i128::from);
    (x * a + y * b + z * c + (w << 14) + (1 << 13)) >> 14
}

/// Matrices at the border of what is accepted: a row that adds up to all but 4096.
fn largest(signs: [bool; 4], shares: [u16; 3], missing: u8) -> Matrix<Model, Clip> {
    let limit = (1_i64 << 28) - 1 - i64::from(missing);
    let total: i64 = shares.iter().map(|&share| i64::from(share) + 1).sum::<i64>() + 1;
    let mut row = shares.map(|share| (i64::from(share) + 1) * limit / total / 2).to_vec();
    row.push(limit - 2 * row.iter().sum::<i64>());
    let signed = |(value, negative): (i64, bool)| if negative { -value } else { value };
    let bits: Vec<_> = row.into_iter().zip(signs).map(signed).collect();
    let row = [0, 1, 2, 3].map(|i| Scalar::from_bits(i32::try_from(bits[i]).expect("28 bits")));
    Matrix::from_rows([row; 4])
}

fn assert_exact(matrix: &Matrix<Model, Clip>, places: &[[i16; 3]]) -> Result<bool, TestCaseError> {
    let reach = |row: &[Scalar; 4]| {
        let [x, y, z, w] = row.map(|v| i64::from(v.to_bits()).abs());
        2 * (x + y + z) + w
    };
    let fits = matrix.rows().iter().all(|row| reach(row) < 1 << 28);
    let transform = MeshTransform::new(matrix);
    prop_assert_eq!(transform.is_ok(), fits);
    let Ok(transform) = transform else { return Ok(false) };
    for &place in places {
        let got = transform.apply(place);
        let want = matrix.rows().map(|row| exact(row, place));
        prop_assert_eq!([got.x, got.y, got.z, got.w].map(|v| i128::from(v.to_bits())), want);
        prop_assert_eq!(transform.apply_w(place), got.w);
    }
    Ok(true)
}

const CORNERS: [[i16; 3]; 4] =
    [[i16::MIN; 3], [i16::MAX; 3], [i16::MIN, i16::MAX, i16::MIN], [i16::MAX, i16::MIN, i16::MIN]];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn any_matrix(
        rows in rows(),
        smaller in prop::array::uniform4(prop::array::uniform4((element(), 6..20_u32))),
        places in prop::collection::vec(place(), 1..9),
    ) {
        assert_exact(&Matrix::from_rows(rows), &places)?;
        let smaller = smaller.map(|row| row.map(|(v, by)| Scalar::from_bits(v.to_bits() >> by)));
        prop_assert!(assert_exact(&Matrix::from_rows(smaller), &places)?, "small ones are accepted");
    }

    #[test]
    fn the_largest_matrices(
        signs in any::<[bool; 4]>(), shares in any::<[u16; 3]>(), missing in any::<u8>(), place in place(),
    ) {
        let matrix = largest(signs, shares, missing);
        prop_assert!(assert_exact(&matrix, &CORNERS)? && assert_exact(&matrix, &[place])?);
    }
}
