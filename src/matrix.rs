//! A 4 × 4 matrix that knows from which space to which it leads.
#![expect(clippy::needless_pass_by_value, reason = "points are copied; their space need not be `Copy` to say so")]

use core::marker::PhantomData;

use crate::{
    num::{Scalar, format_fixed, saturate_i32},
    space::{Point3, Point4, Vector3},
};

/// A homogeneous transform from the space `From` to the space `To`.
///
/// Points are columns, so the rows of the matrix make the coordinates of the result. Elements are
/// signed 16.16. Products are summed in 64 bits and rounded once; what leaves the range saturates.
///
/// Transforms chain in the order in which they happen, and only where the spaces meet:
///
/// ```
/// use aquatint::{Angle, Matrix, Model, World, View};
///
/// let placement = Matrix::<Model, World>::rotation_y(Angle::from_degrees(30.0));
/// let camera = Matrix::<World, View>::IDENTITY;
/// let both: Matrix<Model, View> = placement.then(&camera);
/// # let _ = both;
/// ```
///
/// ```compile_fail
/// use aquatint::{Matrix, Model, World, View};
/// let placement = Matrix::<Model, World>::IDENTITY;
/// let camera = Matrix::<World, View>::IDENTITY;
/// let wrong = camera.then(&placement); // a camera does not lead into the model
/// ```
#[derive(Debug, PartialEq, Eq)]
pub struct Matrix<From, To> {
    rows: [[Scalar; 4]; 4],
    spaces: PhantomData<fn(From) -> To>,
}

format_fixed! {
    impl[From, To] |it: Matrix<From, To>| "Matrix {{ rows: {} }}", Fixed(it.rows)
}

// Not derived: a derive would ask for `From: Clone`, which the map between spaces has no use for.
impl<From, To> Clone for Matrix<From, To> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<From, To> Copy for Matrix<From, To> {}

impl<From, To> Matrix<From, To> {
    /// Leaves the coordinates as they are and only renames the space.
    pub const IDENTITY: Self = {
        let (one, nil) = (Scalar::ONE, Scalar::ZERO);
        Self::from_rows([[one, nil, nil, nil], [nil, one, nil, nil], [nil, nil, one, nil], [nil, nil, nil, one]])
    };

    /// A matrix from its rows.
    #[must_use]
    pub const fn from_rows(rows: [[Scalar; 4]; 4]) -> Self {
        Self { rows, spaces: PhantomData }
    }

    /// The rows.
    #[must_use]
    pub const fn rows(&self) -> &[[Scalar; 4]; 4] {
        &self.rows
    }

    /// First this transform, then `next`. 64 multiplications.
    #[must_use]
    pub fn then<Further>(&self, next: &Matrix<To, Further>) -> Matrix<From, Further> {
        let columns = transposed(self.rows);
        Matrix::from_rows(next.rows.map(|row| columns.map(|column| dot(row, column))))
    }

    /// Where a point lands. 12 multiplications.
    #[must_use]
    pub fn transform_point(&self, point: Point3<From>) -> Point4<To> {
        let column = [point.x, point.y, point.z, Scalar::ONE];
        let [x, y, z, w] = self.rows.map(|row| dot(row, column));
        Point4::new(x, y, z, w)
    }

    /// Where a direction points. Translation and the last row play no part.
    #[must_use]
    pub fn transform_vector(&self, vector: Vector3<From>) -> Vector3<To> {
        let [x, y, z, _] = self.rows.map(|row| dot(row, [vector.x, vector.y, vector.z, Scalar::ZERO]));
        Vector3::new(x, y, z)
    }

    /// The direction of `From` that this transform turns into `vector`, for a rotation and a scale
    /// that is the same along all axes (the length of the result is off by the scale squared).
    ///
    /// Multiplies by the transpose, which for such a matrix is the inverse but for a factor.
    #[must_use]
    pub fn unrotate_vector(&self, vector: Vector3<To>) -> Vector3<From> {
        let [a, b, c, _] = transposed(self.rows).map(|column| {
            let [x, y, z, _] = column;
            dot([x, y, z, Scalar::ZERO], [vector.x, vector.y, vector.z, Scalar::ZERO])
        });
        Vector3::new(a, b, c)
    }
}

fn transposed(rows: [[Scalar; 4]; 4]) -> [[Scalar; 4]; 4] {
    let [[a, b, c, d], [e, f, g, h], [i, j, k, l], [m, n, o, p]] = rows;
    [[a, e, i, m], [b, f, j, n], [c, g, k, o], [d, h, l, p]]
}

/// Sum of products, rounded once to the nearest and saturated.
fn dot(a: [Scalar; 4], b: [Scalar; 4]) -> Scalar {
    let products = a.into_iter().zip(b).map(|(a, b)| i64::from(a.to_bits()) * i64::from(b.to_bits()));
    let sum = products.fold(1 << 15, i64::saturating_add);
    Scalar::from_bits(saturate_i32(sum >> 16))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::{Model, World};

    fn scalar(value: f64) -> Scalar {
        Scalar::saturating_from_num(value)
    }

    #[test]
    fn then_applies_the_first_matrix_first() {
        let double = Matrix::<Model, World>::from_rows([2.0, 3.0, 4.0, 1.0].map(scalar).into_iter().enumerate().fold(
            [[Scalar::ZERO; 4]; 4],
            |mut rows, (i, s)| {
                rows[i][i] = s;
                rows
            },
        ));
        let mut shifted = *Matrix::<World, World>::IDENTITY.rows();
        shifted[0][3] = scalar(10.0);
        let both = double.then(&Matrix::<World, World>::from_rows(shifted));
        let landed = both.transform_point(Point3::new(scalar(1.0), scalar(1.0), scalar(1.0)));
        assert_eq!(landed, Point4::new(scalar(12.0), scalar(3.0), scalar(4.0), scalar(1.0)));
    }

    #[test]
    fn extreme_elements_saturate() {
        let huge = Matrix::<Model, World>::from_rows([[Scalar::MAX; 4]; 4]);
        let landed = huge.then(&huge.rename()).transform_point(Point3::new(Scalar::MIN, Scalar::MIN, Scalar::MIN));
        assert_eq!(landed.x, Scalar::MIN);
    }

    impl Matrix<Model, World> {
        fn rename(self) -> Matrix<World, World> {
            Matrix::from_rows(self.rows)
        }
    }
}
