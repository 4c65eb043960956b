//! Perspective divide and viewport: from clip space to pixels. Lecture 2.2.2 and 2.3.4.

use crate::{
    error::describe,
    num::{bits, low_i32, multiply_high, multiply_high_u32, reciprocal},
    space::{CLIP_LIMIT, Clip, LEAST_W, Point2, Point4, Rect},
};

/// The depth of the near plane: 24 bits. Both ends keep three units of 16 bits clear, by which depths between the corners
/// of a triangle that reaches from one plane to the other may be off.
pub const NEAREST: u32 = 0xFF_FFFF - FARTHEST;

/// The depth of the far plane: more than what is behind everything.
pub const FARTHEST: u32 = 3 << 8;

/// A depth in the 31 bits in which it is carried over a triangle.
#[inline]
pub(crate) const fn fine(depth: u32) -> u32 {
    depth << (31 - 24)
}

/// A point on the screen, and how near it is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ScreenPoint {
    /// Place on the screen.
    pub position: Point2,
    /// [`NEAREST`] at the near plane, [`FARTHEST`] at the far one, linear in 1/w, so linear on the screen. The upper
    /// 16 of the 24 bits are a depth for a buffer of `u16`.
    pub depth: u32,
}

/// The rectangle of the screen that the view fills.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Viewport {
    rect: Rect,
}

/// The viewport has no pixels, or reaches more than 4096 pixels from the origin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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
    /// One 32-bit division and five products of 32 by 32 bits, seven where the view is more than 256 pixels across. The point is inside the guard band and
    /// [`LEAST_W`] `≤ w ≤` [`CLIP_LIMIT`], as the clipper leaves it; others land somewhere harmless. Places are the
    /// exact ones rounded to the nearest sixteenth of a pixel, and off by 1/64 sixteenth more at the most. Depths are
    /// the exact ones rounded down to 24 bits, or one less.
    #[must_use]
    pub fn project(self, point: &Point4<Clip>) -> ScreenPoint {
        let w = point.w.clamp(LEAST_W, CLIP_LIMIT).to_bits();
        let (reciprocal, shift) = reciprocal(bits(w)); // 3 ≤ shift ≤ 18
        // In 3.28, because 4w, shifted so, is less than 2³¹.
        let over_w = |v: i32| multiply_high(v << (shift - 3), reciprocal);
        // In sixteenths: half the size of the view is 8 sixteenths a pixel.
        let place = |v: i32, near: i32, far: i32| 8 * (near + far) + scaled(over_w(v), 8 * (far - near));
        let Rect { left, top, right, bottom } = self.rect;
        // From 0 at the far plane to 2w at the near one, so less than 2³² when shifted.
        let nearness = bits(w.saturating_sub(point.z.to_bits()).clamp(0, 2 * w));
        // (w − z)/2w in 1.31; what is beyond an end is cut off.
        let depth = multiply_high_u32(nearness << (shift - 1), reciprocal) >> 7;
        ScreenPoint {
            position: Point2::from_sixteenths(
                place(point.x.to_bits(), left, right),
                place(point.y.to_bits().wrapping_neg(), top, bottom),
            ),
            depth: depth.clamp(FARTHEST, NEAREST),
        }
    }
}

/// A ratio in 3.28 of half the size of a view, rounded to the nearest; the size is less than 2¹⁷.
#[inline]
fn scaled(ratio: i32, half: i32) -> i32 {
    if half <= 8 * 256 {
        // 2¹⁹ times 2¹¹ at the most.
        let ratio = ((ratio >> 11) + 1) >> 1;
        return (ratio * half + (1 << 15)) >> 16;
    }
    low_i32((i64::from(ratio) * i64::from(half) + (1 << 27)) >> 28)
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
            assert_eq!((project(0.0, 0.0, -w, w).depth, project(0.0, 0.0, w, w).depth), (NEAREST, FARTHEST));
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
