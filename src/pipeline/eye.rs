//! Where the eye is, seen from an object: of any camera, also of those without perspective.

use crate::{
    matrix::Matrix,
    num::{Scalar, low_i128},
    space::{Clip, Model, Point4},
};

/// The point that all rays of a camera come from, or the direction that they come from: there `x`, `y` and `w` of clip
/// space are zero.
///
/// It is the cross product of three rows, in four dimensions; exact to 30 bits. Rows have elements of 27 bits and a sign, as the
/// pipeline tests, so products of three are less than 2⁸⁴.
pub(super) fn eye(to_clip: &Matrix<Model, Clip>) -> Point4<Model> {
    let [x, y, z, w] = to_clip.rows().map(|row| row.map(|element| i128::from(element.to_bits())));
    let minor = |[i, j, k]: [usize; 3]| {
        let of = |row: &[i128; 4], at: usize| row.get(at).copied().unwrap_or(0);
        of(&x, i) * (of(&y, j) * of(&w, k) - of(&y, k) * of(&w, j))
            - of(&x, j) * (of(&y, i) * of(&w, k) - of(&y, k) * of(&w, i))
            + of(&x, k) * (of(&y, i) * of(&w, j) - of(&y, j) * of(&w, i))
    };
    let eye = [minor([1, 2, 3]), -minor([0, 2, 3]), minor([0, 1, 3]), -minor([0, 1, 2])];
    let digits = eye.iter().fold(0, |digits, part| digits | part.unsigned_abs());
    let too_long = (u128::BITS - digits.leading_zeros()).saturating_sub(30);
    let eye = eye.map(|part| low_i128(part >> too_long));
    // In front of everything: where depths are least.
    let depth: i128 = z.iter().zip(eye).map(|(element, part)| element * i128::from(part)).sum();
    let [x, y, z, w] = eye.map(|part| Scalar::from_bits(if depth > 0 { -part } else { part }));
    Point4::new(x, y, z, w)
}
