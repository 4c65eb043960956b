//! Clip planes of the user's, of arbitrary orientation, for vertices in clip space. Lecture 3.5.5.
//!
//! ```text
//!   world:  a cut through a house          clip space:  the same plane, seen by this camera
//!           normal · p + offset ≥ 0    ──▶              a·x + b·y + c·z + d·w ≥ 0
//! ```
//!
//! A [`HalfSpace`] is turned into a clip plane once for each picture, and then the vertices that have been projected are
//! compared with it: no second place of a vertex has to be kept, and a vertex that another boundary has made can be
//! compared, too. Like the planes of the [`volume`](super::volume) it comes before the perspective divide.
//!
//! If `M` leads from the space of the half-space to clip space, the four coefficients `c` are those for which
//! `c · M` is the half-space's normal and offset. By Cramer's rule each is a determinant, up to a factor that they share.

use crate::{
    error::OutOfRange,
    matrix::Matrix,
    num::{Scalar, saturate_i32},
    space::Clip,
};

use super::{half_space::HalfSpace, vertex::Homogeneous, window::Boundary};

/// Coefficients are no farther from zero than this, so that a distance is at most 2⁶².
const LIMIT: u32 = 1 << 29;

/// One side of a plane in clip space, the plane included.
///
/// ```
/// use aquatint::{ClipPlane, Clip, HalfSpace, Matrix, Point4, Scalar, Vector3, View};
/// use aquatint::clip::{sutherland_hodgman_3d::clip, volume::Volume};
/// use heapless::Vec;
///
/// // What lies to the right of the eye.
/// let right = HalfSpace::<View>::new(Vector3::new(Scalar::ONE, Scalar::ZERO, Scalar::ZERO), Scalar::ZERO)?;
/// let projection = Matrix::<View, Clip>::IDENTITY; // any other
/// let plane = right.in_clip_space(&projection).expect("a projection can be undone");
///
/// let corner = |x: f64, y: f64| {
///     let [x, y] = [x, y].map(Scalar::from_num);
///     Point4::<Clip>::new(x, y, Scalar::ZERO, Scalar::ONE)
/// };
/// let mut polygon = Vec::<_, 11>::from_slice(&[corner(-0.5, 0.0), corner(0.5, 0.0), corner(0.5, 1.0)]).unwrap();
/// clip(&mut polygon, &mut Vec::<_, 11>::new(), &[plane], Volume::View).unwrap();
/// assert_eq!(polygon, [corner(0.0, 0.5), corner(0.0, 0.0), corner(0.5, 0.0), corner(0.5, 1.0)]);
/// # Ok::<(), aquatint::OutOfRange>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ClipPlane {
    coefficients: [i32; 4],
}

impl ClipPlane {
    /// Where `a·x + b·y + c·z + d·w` is not negative.
    ///
    /// # Errors
    /// [`OutOfRange`] when a coefficient is beyond ±8192. Only their ratios play a part: take smaller ones.
    pub fn new(coefficients: [Scalar; 4]) -> Result<Self, OutOfRange> {
        let coefficients = coefficients.map(Scalar::to_bits);
        let is_far = coefficients.iter().any(|v| v.unsigned_abs() > LIMIT);
        if is_far { Err(OutOfRange) } else { Ok(Self { coefficients }) }
    }
}

impl<V: Homogeneous> Boundary<V> for ClipPlane {
    fn distance(&self, vertex: &V) -> i64 {
        let point = vertex.point();
        let coordinates = [point.x, point.y, point.z, point.w].map(Scalar::to_bits);
        let products = self.coefficients.iter().zip(coordinates);
        products.map(|(&coefficient, v)| i64::from(coefficient) * i64::from(v)).sum()
    }
}

impl<S> HalfSpace<S> {
    /// The same boundary in clip space, for vertices that `to_clip` leads there. `None` if the matrix cannot be
    /// undone, which one of a placement, a camera and a projection can.
    ///
    /// Coefficients have 29 digits. A vertex is rounded on its way to clip space, by 2⁻¹⁷; for a plane that is `n` times as
    /// far away as the near plane this moves it by `n` times as much. Some 200 products, 37,000 instructions on a Cortex-M0: once a picture.
    #[must_use]
    pub fn in_clip_space(&self, to_clip: &Matrix<S, Clip>) -> Option<ClipPlane> {
        let rows = to_clip.rows().map(|row| row.map(|v| i64::from(v.to_bits())));
        let mut cofactors = cofactors(&rows);
        shorten(&mut cofactors, 60);
        let [x, y, z] = self.normal.map(|v| i128::from(v) << 16);
        let wanted = [x, y, z, i128::from(self.offset)];
        // 2⁶⁰ · 2³¹ · 4, and 2⁶⁰ · 2⁶² · 4.
        let orientation = dot(&cofactors[0], &rows[0].map(i128::from)).signum();
        let mut coefficients = [cofactors.map(|row| dot(&row, &wanted) * orientation)];
        shorten(&mut coefficients, 29);
        let [coefficients] = coefficients.map(|row| row.map(|v| i64::try_from(v).map_or(0, saturate_i32)));
        (orientation != 0).then_some(ClipPlane { coefficients })
    }
}

/// The cofactors of a matrix of 32-bit numbers: each is below 2⁹⁶.
fn cofactors(&[a, b, c, d]: &[[i64; 4]; 4]) -> [[i128; 4]; 4] {
    let minus = |row: [i128; 4]| row.map(|v| -v);
    [minors([b, c, d]), minus(minors([a, c, d])), minors([a, b, d]), minus(minors([a, b, c]))]
}

/// The determinants of three rows without one of the columns each, with alternating signs.
#[inline(never)]
fn minors([[a, b, c, d], [e, f, g, h], [i, j, k, l]]: [[i64; 4]; 3]) -> [i128; 4] {
    [
        determinant([[b, c, d], [f, g, h], [j, k, l]]),
        -determinant([[a, c, d], [e, g, h], [i, k, l]]),
        determinant([[a, b, d], [e, f, h], [i, j, l]]),
        -determinant([[a, b, c], [e, f, g], [i, j, k]]),
    ]
}

#[inline(never)]
fn determinant([[a, b, c], [d, e, f], [g, h, i]]: [[i64; 3]; 3]) -> i128 {
    // Two products of 32-bit numbers: their difference fits 64 bits.
    let minors = [e * i - f * h, f * g - d * i, d * h - e * g];
    dot(&[a, b, c, 0].map(i128::from), &[minors[0], minors[1], minors[2], 0].map(i128::from))
}

#[inline(never)]
fn dot(a: &[i128; 4], b: &[i128; 4]) -> i128 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Divides all numbers by the same power of two, the least with which they have so many digits at most.
#[inline(never)]
fn shorten(numbers: &mut [[i128; 4]], digits: u32) {
    let all = numbers.iter().flatten().fold(0, |all, v| all | v.unsigned_abs());
    let excess = (u128::BITS - all.leading_zeros()).saturating_sub(digits);
    for v in numbers.iter_mut().flatten() {
        // To the nearest.
        *v = ((*v >> excess.saturating_sub(1)) + i128::from(excess > 0)) >> excess.min(1);
    }
}
