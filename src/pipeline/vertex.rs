//! Vertices on their way: as the workspace keeps them, and in clip space.

use crate::{
    clip::{
        sutherland_hodgman::{Crossing, Cut},
        vertex::Homogeneous,
    },
    colour::Light,
    geometry::viewport::{ScreenPoint, fine},
    num::bits,
    space::{Clip, Point2, Point4},
    vary::Varying,
};

/// A vertex after transform and light: 12 bytes. Lend the pipeline one for each vertex of a mesh.
#[derive(Clone, Copy, Debug, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MeshVertex {
    /// The place across in sixteenths of a pixel, 20 bits, and the upper 12 bits of the depth.
    across: u32,
    /// The place down, and the lower 12 bits of the depth.
    down: u32,
    /// The light on the front, and on the back if that is drawn, too.
    pub(super) front: Light,
    pub(super) back: Light,
}

/// 2048 pixels, in sixteenths.
const SHORT: i32 = 1 << 15;

impl MeshVertex {
    /// Something to fill an array with. All its bytes are zero, so that a static array takes no flash.
    pub const EMPTY: Self = Self { across: 0, down: 0, front: Light::BLACK, back: Light::BLACK };

    /// A vertex that must be clipped first: a place that no projected vertex has, far left of all guard bands.
    pub(super) const UNPROJECTED: Self = Self { across: 0x8000_0000, down: 0, front: Light::BLACK, back: Light::BLACK };

    #[inline]
    pub(super) const fn new(point: ScreenPoint) -> Self {
        let Point2 { x, y } = point.position;
        Self {
            across: bits(x.to_bits()) << 12 | point.depth >> 12,
            down: bits(y.to_bits()) << 12 | point.depth & 0xFFF,
            front: Light::BLACK,
            back: Light::BLACK,
        }
    }

    /// The same light, but the vertex must be clipped first.
    pub(super) const fn unprojected(self) -> Self {
        Self { front: self.front, back: self.back, ..Self::UNPROJECTED }
    }

    #[inline]
    pub(super) const fn is_projected(&self) -> bool {
        self.across >> 12 != 0x8_0000
    }

    #[inline]
    pub(super) const fn position(&self) -> Point2 {
        Point2::from_sixteenths(self.across.cast_signed() >> 12, self.down.cast_signed() >> 12)
    }

    /// Twice the signed area of a triangle whose corners are less than 2048 pixels from the first one.
    ///
    /// `None` of others, and of those without area: so a corner that must be clipped, which is farther from all that are
    /// projected, is told without a look, and so are three of them, which lie on each other.
    #[inline]
    pub(super) fn short_area(a: &Self, b: &Self, c: &Self) -> Option<i32> {
        let along = |from: u32, to: u32| (to.cast_signed() >> 12) - (from.cast_signed() >> 12);
        let (bx, by) = (along(a.across, b.across), along(a.down, b.down));
        let (cx, cy) = (along(a.across, c.across), along(a.down, c.down));
        let digits = |v: i32| bits(v + SHORT);
        if (digits(bx) | digits(by) | digits(cx) | digits(cy)) >= 2 * bits(SHORT) {
            return None;
        }
        // Below 2³⁰ each.
        Some(bx * cy - cx * by).filter(|&area| area != 0)
    }

    /// The depth in 31 bits, as it is carried over a triangle.
    #[inline]
    pub(super) const fn depth(&self) -> u32 {
        fine((self.across & 0xFFF) << 12 | self.down & 0xFFF)
    }
}

/// A vertex in clip space.
#[derive(Clone, Copy, Debug)]
pub(super) struct ClipVertex<A> {
    pub(super) point: Point4<Clip>,
    pub(super) attributes: A,
}

impl<A: Varying> Homogeneous for ClipVertex<A> {
    #[inline]
    fn point(&self) -> Point4<Clip> {
        self.point
    }
}

impl<A: Varying> Cut for ClipVertex<A> {
    /// Out of line: clippers cut in many places, and seldom.
    #[inline(never)]
    fn cut(inside: Self, outside: Self, crossing: Crossing) -> Self {
        Self {
            point: Cut::cut(inside.point, outside.point, crossing),
            attributes: inside.attributes.mixed(outside.attributes, &|a, b| between(crossing, a, b)),
        }
    }
}

#[inline(never)]
fn between(crossing: Crossing, inside: u16, outside: u16) -> u16 {
    crossing.attribute(inside, outside)
}
