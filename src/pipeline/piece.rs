//! Fragment processing: what happens to the spans of one triangle.

use core::ops::Range;

use super::vertex::MeshVertex;
use crate::{
    fragment::shade::{Corner, Facet, Placed, Shading},
    hidden::Hidden,
    illumination::Illumination,
    num::{Scalar, low_i32},
    space::{Point2, Rect},
    span::Sink,
    target::Target,
    slopes::Slopes,
    vary::{Plane, Ramp},
};

/// How much nearer to the eye than they are surfaces are taken to be: for lines and decals on others.
///
/// The depth test then sees them in front of what they lie on. Both parts are in units of a 16-bit depth buffer:
/// what always is added, and what is added for each unit that the depth changes from a pixel to the next, which
/// steep surfaces need. Negative numbers push away.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DepthBias {
    /// Added everywhere.
    pub constant: i16,
    /// Times the steepness.
    pub slope: i8,
}

impl DepthBias {
    /// None.
    pub const NONE: Self = Self { constant: 0, slope: 0 };

    /// Depths, moved; they stay in range.
    fn moved(self, depths: [u32; 3], steepness: u32) -> [u32; 3] {
        let bias = (i64::from(self.constant) << 15) + i64::from(self.slope) * i64::from(steepness);
        // Up to the nearest depth that there is.
        depths.map(|depth| low_i32((i64::from(depth) + bias).clamp(0, 0x7FFF_FF80)).cast_unsigned())
    }
}

/// A triangle or a piece of one on the screen, ready to be drawn.
pub(super) struct Piece {
    pub(super) positions: [Point2; 3],
    pub(super) depths: [u32; 3],
    pub(super) ws: [Scalar; 3],
}

impl Piece {
    pub(super) fn of_vertices(vertices: &[MeshVertex; 3]) -> Self {
        let of = vertices.each_ref();
        Self { positions: of.map(|v| v.position()), depths: of.map(|v| v.depth()), ws: [Scalar::ZERO; 3] }
    }
}

/// Where fragments go, and what decides about them.
pub(super) struct Fragments<'f, S, I, H, T> {
    pub(super) shading: &'f S,
    pub(super) light: I,
    pub(super) bias: DepthBias,
    pub(super) hidden: &'f mut H,
    pub(super) target: &'f mut T,
    pub(super) bounds: Rect,
}

/// What is computed of a triangle when the first of its pixels is seen.
struct Begun<F> {
    face: F,
    depth: Plane<1>,
}

/// One triangle on its way into the fragments.
pub(super) struct Painter<'p, 'f, S: Shading, I, H, T> {
    pub(super) fragments: &'p mut Fragments<'f, S, I, H, T>,
    pub(super) piece: &'p Piece,
    pub(super) corners: &'p [Corner; 3],
    pub(super) normal: Option<[i8; 3]>,
    /// What the corners carry, if clipping has made them.
    pub(super) attributes: [S::Attributes; 3],
    begun: Option<Begun<S::Face>>,
}
