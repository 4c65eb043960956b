//! Projection: the pyramid that the camera sees becomes the cube −w ≤ x, y, z ≤ w. Lecture 2.2.2.

use crate::{
    angle::Angle,
    error::describe,
    matrix::Matrix,
    num::{Scalar, divide_round, format_fixed, saturate_i32},
    space::{CLIP_LIMIT, Clip, LEAST_W, View},
};

/// Why numbers do not make a projection.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum ProjectionError {
    /// The field of view is not between 0° and 180°.
    FieldOfView,
    /// The aspect ratio is not positive.
    Aspect,
    /// Not ⅛ ≤ near < far ≤ 4096.
    Range,
    /// The height of a view without perspective is not positive, or so is not its width.
    Extent,
    /// Not −4096 ≤ near < far ≤ 4096, without perspective.
    Depths,
}

describe! { ProjectionError,
    Self::FieldOfView => "the field of view is not between 0 and 180 degrees";
    Self::Aspect => "the aspect ratio is not positive";
    Self::Range => "not 1/8 <= near < far <= 4096";
    Self::Extent => "the height of the view is not positive, or so is not its width";
    Self::Depths => "not -4096 <= near < far <= 4096";
}

/// How wide and how deep the camera sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lens {
    /// Full angle from the lower to the upper border of the view.
    pub field_of_view: Angle,
    /// Width of the view over its height.
    pub aspect: Scalar,
    /// Distance of the plane before which nothing is seen, at least ⅛.
    pub near: Scalar,
    /// Distance of the plane behind which nothing is seen, at most 4096.
    pub far: Scalar,
}

format_fixed! {
    impl[] |it: Lens| "Lens {{ field_of_view: {}, aspect: {}, near: {}, far: {} }}",
    it.field_of_view, Fixed(it.aspect), Fixed(it.near), Fixed(it.far)
}

/// The box that is seen without perspective.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ViewBox {
    /// From the lower to the upper border of the view.
    pub height: Scalar,
    /// Width of the view over its height.
    pub aspect: Scalar,
    /// Distance of the plane before which nothing is seen. It may lie behind the eye, at −4096 at the farthest.
    pub near: Scalar,
    /// Distance of the plane behind which nothing is seen, at most 4096.
    pub far: Scalar,
}

format_fixed! {
    impl[] |it: ViewBox| "ViewBox {{ height: {}, aspect: {}, near: {}, far: {} }}",
    Fixed(it.height), Fixed(it.aspect), Fixed(it.near), Fixed(it.far)
}

/// The `w` of all points without perspective. The larger it is, the more digits the elements of the matrix have.
const PARALLEL_W: i64 = 64;

impl Matrix<View, Clip> {
    /// Perspective: `w` becomes the distance in front of the eye, by which the rest is divided.
    ///
    /// # Errors
    /// [`ProjectionError`]: which of the numbers is out of range.
    pub fn perspective(lens: Lens) -> Result<Self, ProjectionError> {
        let Lens { field_of_view, aspect, near, far } = lens;
        if near < LEAST_W || far <= near || far > CLIP_LIMIT {
            return Err(ProjectionError::Range);
        }
        if aspect <= 0 {
            return Err(ProjectionError::Aspect);
        }
        let half = field_of_view.half();
        let focal = half.cot().filter(|&c| c > 0 && half.0 < Angle::QUARTER.0).ok_or(ProjectionError::FieldOfView)?;
        let quotient = |a: i64, b: i64| Scalar::from_bits(saturate_i32(divide_round(a, b)));
        let [n, f] = [near, far].map(|v| i64::from(v.to_bits()));
        let across = quotient(i64::from(focal.to_bits()) << 16, i64::from(aspect.to_bits()));
        // z becomes −w at the near plane and +w at the far one.
        let (a, b) = (quotient((f + n) << 16, f - n), quotient(2 * f * n, f - n));
        let (one, nil) = (Scalar::ONE, Scalar::ZERO);
        Ok(Self::from_rows([
            [across, nil, nil, nil],
            [nil, focal, nil, nil],
            [nil, nil, -a, -b],
            [nil, nil, -one, nil],
        ]))
    }

    /// No perspective: lines that are parallel stay so, and what is far is as large as what is near.
    ///
    /// `w` is 64 for all points. What lies more than 64 half views off is out of range.
    ///
    /// # Errors
    /// [`ProjectionError`]: which of the numbers is out of range.
    ///
    /// ```
    /// use aquatint::{Matrix, Scalar, geometry::projection::ViewBox};
    ///
    /// let [height, near, far] = [3, -10, 10].map(Scalar::from_num);
    /// let plan = Matrix::orthographic(ViewBox { height, aspect: Scalar::from_num(2), near, far })?;
    /// # let _ = plan;
    /// # Ok::<(), aquatint::geometry::projection::ProjectionError>(())
    /// ```
    pub fn orthographic(seen: ViewBox) -> Result<Self, ProjectionError> {
        let ViewBox { height, aspect, near, far } = seen;
        if far <= near || far > CLIP_LIMIT || near < -CLIP_LIMIT {
            return Err(ProjectionError::Depths);
        }
        if aspect <= 0 {
            return Err(ProjectionError::Aspect);
        }
        let [height, aspect, n, f] = [height, aspect, near, far].map(|v| i64::from(v.to_bits()));
        let width = divide_round(height.saturating_mul(aspect), 1 << 16);
        if height <= 0 || width <= 0 {
            return Err(ProjectionError::Extent);
        }
        // Of 2w over an extent: what makes it −w to w.
        let scale = |extent: i64| Scalar::from_bits(saturate_i32(divide_round((2 * PARALLEL_W) << 32, extent)));
        let middle = Scalar::from_bits(saturate_i32(divide_round((-PARALLEL_W * (f + n)) << 16, f - n)));
        let nil = Scalar::ZERO;
        Ok(Self::from_rows([
            [scale(width), nil, nil, nil],
            [nil, scale(height), nil, nil],
            [nil, nil, -scale(f - n), middle],
            [nil, nil, nil, Scalar::from_bits(saturate_i32(PARALLEL_W << 16))],
        ]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::Point3;

    fn lens() -> Lens {
        let field_of_view = Angle::from_degrees(90.0);
        let [near, far] = [0.5, 100.0].map(Scalar::from_num);
        Lens { field_of_view, aspect: Scalar::from_num(2), near, far }
    }

    #[test]
    fn the_corners_of_the_view_become_the_corners_of_the_cube() {
        let projection = Matrix::perspective(lens()).unwrap();
        for (depth, z) in [(0.5, -0.5), (100.0, 100.0)] {
            let [x, y, back] = [depth * 2.0, depth, -depth].map(Scalar::from_num);
            let p = projection.transform_point(Point3::new(x, y, back));
            let close = |a: Scalar, b: f64| (a.to_num::<f64>() - b).abs() < 0.003 * depth;
            assert!(close(p.x, depth) && close(p.y, depth) && close(p.z, z) && close(p.w, depth), "{p:?}");
        }
    }

    #[test]
    fn a_box_becomes_the_cube() {
        let [height, near, far] = [2.0, -3.0, 61.0].map(Scalar::from_num);
        let projection = Matrix::orthographic(ViewBox { height, aspect: Scalar::from_num(1.5), near, far }).unwrap();
        for (depth, z) in [(-3.0, -64.0), (29.0, 0.0), (61.0, 64.0)] {
            let [x, y, back] = [1.5, -1.0, -depth].map(Scalar::from_num);
            let p = projection.transform_point(Point3::new(x, y, back));
            let close = |a: Scalar, b: f64| (a.to_num::<f64>() - b).abs() < 0.001;
            assert!(close(p.x, 64.0) && close(p.y, -64.0) && close(p.z, z) && close(p.w, 64.0), "{p:?}");
        }
    }

    #[test]
    fn bad_boxes_are_named() {
        let good = ViewBox { height: Scalar::ONE, aspect: Scalar::ONE, near: -Scalar::ONE, far: Scalar::ONE };
        let of = |change: fn(&mut ViewBox)| {
            let mut changed = good;
            change(&mut changed);
            Matrix::orthographic(changed).unwrap_err()
        };
        assert_eq!(of(|b| b.near = b.far), ProjectionError::Depths);
        assert_eq!(of(|b| b.near = Scalar::MIN), ProjectionError::Depths);
        assert_eq!(of(|b| b.far = Scalar::MAX), ProjectionError::Depths);
        assert_eq!(of(|b| b.aspect = Scalar::ZERO), ProjectionError::Aspect);
        assert_eq!(of(|b| b.height = Scalar::MIN), ProjectionError::Extent);
        assert_eq!(of(|b| (b.height, b.aspect) = (Scalar::DELTA, Scalar::DELTA)), ProjectionError::Extent);
        for (height, aspect) in [(Scalar::MAX, Scalar::MAX), (Scalar::DELTA, Scalar::ONE)] {
            assert!(Matrix::orthographic(ViewBox { height, aspect, ..good }).is_ok());
        }
    }

    #[test]
    fn bad_numbers_are_named() {
        let of = |change: fn(&mut Lens)| {
            let mut changed = lens();
            change(&mut changed);
            Matrix::perspective(changed).unwrap_err()
        };
        assert_eq!(of(|l| l.near = Scalar::ZERO), ProjectionError::Range);
        assert_eq!(of(|l| l.far = l.near), ProjectionError::Range);
        assert_eq!(of(|l| l.far = Scalar::MAX), ProjectionError::Range);
        assert_eq!(of(|l| l.aspect = Scalar::ZERO), ProjectionError::Aspect);
        assert_eq!(of(|l| l.aspect = Scalar::MIN), ProjectionError::Aspect);
        assert_eq!(of(|l| l.field_of_view = Angle(0)), ProjectionError::FieldOfView);
        assert_eq!(of(|l| l.field_of_view = Angle(0x8000)), ProjectionError::FieldOfView);
        assert_eq!(of(|l| l.field_of_view = Angle(0xFFFF)), ProjectionError::FieldOfView);
    }
}
