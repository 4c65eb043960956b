//! Projection: the pyramid that the camera sees becomes the cube −w ≤ x, y, z ≤ w. Lecture 2.2.2.

use crate::{
    angle::Angle,
    error::describe,
    matrix::Matrix,
    num::{Scalar, divide_round, saturate_i32},
    space::{CLIP_LIMIT, Clip, LEAST_W, View},
};

/// Why numbers do not make a projection.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProjectionError {
    /// The field of view is not between 0° and 180°.
    FieldOfView,
    /// The aspect ratio is not positive.
    Aspect,
    /// Not ⅛ ≤ near < far ≤ 4096.
    Range,
}

describe! { ProjectionError,
    Self::FieldOfView => "the field of view is not between 0 and 180 degrees";
    Self::Aspect => "the aspect ratio is not positive";
    Self::Range => "not 1/8 <= near < far <= 4096";
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
