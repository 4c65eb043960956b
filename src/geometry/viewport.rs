//! Perspective divide and viewport: from clip space to pixels. Lecture 2.2.2 and 2.3.4.

use crate::{
    error::describe,
    num::{low_i32, saturate_u16},
    space::{Clip, LEAST_W, Point2, Point4, Rect},
};

/// A point on the screen, and how near it is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ScreenPoint {
    /// Place on the screen.
    pub position: Point2,
    /// 65535 at the near plane, 0 at the far one, linear in 1/w, so linear on the screen.
    pub depth: u16,
}

/// The rectangle of the screen that the view fills.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Viewport {
    rect: Rect,
}

/// The viewport has no pixels, or reaches more than 4096 pixels from the origin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BadViewport;

describe! { BadViewport, Self => "the viewport is empty or reaches beyond 4096 pixels"; }

impl Viewport {
    /// Lets the view fill `rect`.
    ///
    /// # Errors
    /// [`BadViewport`]: empty, or a border beyond ±4096.
    pub const fn new(rect: Rect) -> Result<Self, BadViewport> {
        let far = rect.left < -4096 || rect.top < -4096 || rect.right > 4096 || rect.bottom > 4096;
        if far || rect.is_empty() { Err(BadViewport) } else { Ok(Self { rect }) }
    }

    /// The pixels of the viewport.
    #[must_use]
    pub const fn rect(self) -> Rect {
        self.rect
    }

    /// Divides by `w` and maps −1 … 1 to the borders: x to the right, y *down* on the screen.
    ///
    /// One 64-bit division. The point is inside the guard band and `w ≥` [`LEAST_W`], as the clipper
    /// leaves it; others land somewhere harmless. Places are within 1/16 of a pixel of the exact
    /// ones as far as `w` = 256 and a view of 400 pixels, depths within 2 units of 65535.
    #[must_use]
    pub fn project(self, point: &Point4<Clip>) -> ScreenPoint {
        let w = point.w.max(LEAST_W).to_bits();
        // 2⁴⁴/w, which is 2²⁸ over the true w: w ≥ 2¹³, so it fits 32 bits and one sign.
        let reciprocal = (1_i64 << 44) / i64::from(w.max(1));
        let over_w = |v: i64| (v * reciprocal) >> 20; // 8.24
        // Sums are in sixteenths: half the size of the view is 8 sixteenths a pixel.
        let place = |v: i64, near: i32, far: i32, half: i64| {
            let middle = 8 * (i64::from(near) + i64::from(far));
            low_i32(middle + ((over_w(v) * half + (1 << 23)) >> 24))
        };
        let Rect { left, top, right, bottom } = self.rect;
        let (half_width, half_height) =
            (8 * (i64::from(right) - i64::from(left)), 8 * (i64::from(bottom) - i64::from(top)));
        let [x, y, z] = [point.x, point.y, point.z].map(|v| i64::from(v.to_bits()));
        let nearness = ((i64::from(w) - z) * reciprocal) >> 29; // (w − z)/2w in 0.16
        ScreenPoint {
            position: Point2::from_sixteenths(place(x, left, right, half_width), place(-y, top, bottom, half_height)),
            depth: saturate_u16(nearness),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::Scalar;

    fn project(x: f64, y: f64, z: f64, w: f64) -> ScreenPoint {
        let [x, y, z, w] = [x, y, z, w].map(Scalar::saturating_from_num);
        Viewport::new(Rect::new(10, 20, 110, 70)).unwrap().project(&Point4::new(x, y, z, w))
    }

    #[test]
    fn the_cube_fills_the_viewport() {
        for w in [0.125, 0.4, 1.0, 7.0, 250.0] {
            assert_eq!(project(-w, w, -w, w).position, Point2::corner(10, 20), "upper left, w = {w}");
            assert_eq!(project(w, -w, w, w).position, Point2::corner(110, 70), "lower right, w = {w}");
            assert_eq!(project(0.0, 0.0, 0.0, w).position, Point2::corner(60, 45));
            assert_eq!((project(0.0, 0.0, -w, w).depth, project(0.0, 0.0, w, w).depth), (65_535, 0));
        }
    }

    #[test]
    fn no_input_overflows() {
        let ends = [Scalar::MIN, -Scalar::DELTA, Scalar::ZERO, Scalar::MAX];
        let view = Viewport::new(Rect::new(-4096, -4096, 4096, 4096)).unwrap();
        for x in ends {
            for w in ends {
                for z in ends {
                    let _ = view.project(&Point4::new(x, x, z, w));
                }
            }
        }
    }

    #[test]
    fn a_viewport_has_pixels_in_range() {
        assert!(Viewport::new(Rect::new(3, 3, 3, 4)).is_err());
        assert!(Viewport::new(Rect::new(0, 0, 4097, 1)).is_err());
        assert!(Viewport::new(Rect::new(i32::MIN, 0, i32::MAX, 1)).is_err());
    }
}
